// Arrays of millions of numbers are filled once and thrown away soon. Half of the time that takes
// is the kernel's, which hands memory out in small pages; so large blocks ask it for huge ones.
// These are the operators that the standard lets a program replace.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include <sys/mman.h>

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

void* allocate(std::size_t size, std::size_t alignment) {
  const bool large = size >= kHugePage;
  if (large) alignment = std::max(alignment, kHugePage);
  const std::size_t rounded = (std::max<std::size_t>(size, 1) + alignment - 1) & ~(alignment - 1);
  void* block = rounded < size ? nullptr : std::aligned_alloc(alignment, rounded);
  // A hint, so whether it is followed does not matter. What does not fill a page stays in small
  // ones.
  if (large && block != nullptr) ::madvise(block, size / kHugePage * kHugePage, MADV_HUGEPAGE);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { std::free(block); }
void operator delete(void* block, std::size_t) noexcept { std::free(block); }
void operator delete(void* block, std::align_val_t) noexcept { std::free(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { std::free(block); }
