// Arrays of millions of numbers are filled once and thrown away soon. Half of the time that takes
// is the kernel's, which clears memory and hands it out in small pages; so large blocks ask it for
// huge ones, and are kept for the next array. These are the operators that the standard lets a
// program replace.
#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "large_blocks.hpp"

namespace {

using surpass::cli::LargeBlocks;

// Never destroyed: others free their memory later.
LargeBlocks& large_blocks() {
  alignas(LargeBlocks) static std::byte place[sizeof(LargeBlocks)];
  static LargeBlocks& blocks = *new (place) LargeBlocks(surpass::cli::system_pages());
  return blocks;
}

void* try_small(std::size_t size, std::size_t alignment) {
  if (alignment <= alignof(std::max_align_t)) return std::malloc(size);  // cheaper
  const std::size_t rounded = (size + alignment - 1) & ~(alignment - 1);
  return rounded < size ? nullptr : std::aligned_alloc(alignment, rounded);
}

void* allocate_small(std::size_t size, std::size_t alignment) {
  size = std::max<std::size_t>(size, 1);
  void* block = try_small(size, alignment);
  if (block != nullptr) return block;
  large_blocks().give_back();
  return try_small(size, alignment);
}

void* allocate(std::size_t size, std::size_t alignment) {
  void* block = size >= LargeBlocks::kHugePage ? large_blocks().allocate(size, alignment)
                                               : allocate_small(size, alignment);
  if (block == nullptr) throw std::bad_alloc();
  return block;
}

void release(void* block) noexcept {
  if (LargeBlocks::may_be(block) && large_blocks().free(block)) return;
  std::free(block);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, __STDCPP_DEFAULT_NEW_ALIGNMENT__); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* block) noexcept { release(block); }
void operator delete(void* block, std::size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, std::size_t, std::align_val_t) noexcept { release(block); }
