// Large blocks of memory, which are kept for the next one when they are freed: fresh memory has to
// be cleared by the kernel first, and that is a seventh of what a large mesh takes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <map>
#include <mutex>
#include <new>
#include <utility>

namespace surpass::cli {

/// Where the memory comes from. Pages are readable, writable and cleared when they are first
/// touched.
struct PageSource {
  /// `bytes` bytes, a multiple of LargeBlocks::kPage, or nullptr.
  void* (*map)(std::size_t bytes);
  /// Gives a part of what was mapped back, possibly of several mappings side by side.
  void (*unmap)(void* pages, std::size_t bytes);
  /// Moves pages of one mapping to where others are mapped, which are given back. Where it is
  /// false, the others may or may not be gone.
  bool (*move)(void* from, std::size_t bytes, void* to);
};

/// That of the operating system.
[[nodiscard]] PageSource system_pages();

/// Memory straight from malloc: operator new may itself rely on the blocks below.
template <class T>
struct Malloc {
  using value_type = T;
  Malloc() = default;
  template <class U>
  explicit Malloc(const Malloc<U>& /*same for all*/) {}
  [[nodiscard]] T* allocate(std::size_t n) {
    void* place = std::malloc(n * sizeof(T));
    if (place == nullptr) throw std::bad_alloc();
    return static_cast<T*>(place);
  }
  void deallocate(T* place, std::size_t /*n*/) { std::free(place); }
  bool operator==(const Malloc&) const = default;
};

/// Hands out blocks at multiples of a huge page, and asks for huge pages where the block fills
/// them. What is freed is kept; a block is cut from what is kept or put together from it, and only
/// what it still lacks is fresh. Never is so much kept that the memory held, in use or kept, were
/// more than the most that was in use so far. So keeping adds nothing to the peak, unless blocks
/// were larger than what was written to them. May be used by several threads at once.
class LargeBlocks {
 public:
  static constexpr std::size_t kPage = std::size_t{1} << 12;
  static constexpr std::size_t kHugePage = std::size_t{1} << 21;

  explicit LargeBlocks(PageSource source) : source_(source) {}

  /// At least `size` bytes at a multiple of `alignment`, a power of two, and of a huge page; what
  /// is in them is unspecified. nullptr where the source has no more, though all that was kept went
  /// back to it. O(pieces kept + huge pages in the block).
  [[nodiscard]] void* allocate(std::size_t size, std::size_t alignment) noexcept;
  /// False for most blocks that are not of these; without looking at any.
  [[nodiscard]] static bool may_be(const void* block) {
    return reinterpret_cast<std::uintptr_t>(block) % kHugePage == 0;
  }
  /// False, and nothing done, if the block is not one of these.
  bool free(void* block) noexcept;
  /// Gives all that is kept back to the source.
  void give_back() noexcept;

  struct Figures {
    std::size_t used;  ///< bytes in blocks
    std::size_t kept;  ///< bytes in pieces for the next blocks
    std::size_t most;  ///< the most that was ever used
  };
  [[nodiscard]] Figures figures() const;

 private:
  // Bytes, by where they begin.
  using Pieces =
      std::map<char*, std::size_t, std::less<>, Malloc<std::pair<char* const, std::size_t>>>;

  [[nodiscard]] char* take_kept(std::size_t bytes, std::size_t alignment);
  [[nodiscard]] char* map_fresh(std::size_t bytes, std::size_t alignment);
  [[nodiscard]] char* map_with_kept(std::size_t bytes, std::size_t alignment);
  bool fill_from_kept(char* block, std::size_t bytes);
  bool move_pages(char* from, std::size_t bytes, char* to);
  void unmap(char* begin, std::size_t bytes);
  void keep(Pieces::node_type piece);
  void give_back(std::size_t bytes);
  void give_back_beyond(std::size_t bytes);

  PageSource source_;
  mutable std::mutex mutex_;
  Pieces used_;
  Pieces kept_;
  Pieces seams_;  // where a mapping may begin; the numbers mean nothing here
  std::size_t bytes_used_ = 0;
  std::size_t bytes_kept_ = 0;
  std::size_t most_used_ = 0;
};

}  // namespace surpass::cli
