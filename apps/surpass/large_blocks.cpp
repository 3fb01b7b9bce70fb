#include "large_blocks.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <new>
#include <utility>

#include <sys/mman.h>

namespace surpass::cli {

namespace {

void* map_pages(std::size_t bytes) {
  void* pages = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (pages == MAP_FAILED) return nullptr;
  // A hint, so whether it is followed does not matter. What does not fill a huge page stays in
  // small ones.
  ::madvise(pages, bytes, MADV_HUGEPAGE);
  return pages;
}

void unmap_pages(void* pages, std::size_t bytes) { ::munmap(pages, bytes); }

bool move_pages(void* from, std::size_t bytes, void* to) {
  return ::mremap(from, bytes, bytes, MREMAP_MAYMOVE | MREMAP_FIXED, to) != MAP_FAILED;
}

std::size_t rounded_up(std::size_t n, std::size_t unit) { return (n + unit - 1) & ~(unit - 1); }

char* rounded_up(char* place, std::size_t unit) {
  const auto address = reinterpret_cast<std::uintptr_t>(place);
  return place + (rounded_up(address, unit) - address);
}

}  // namespace

PageSource system_pages() { return {map_pages, unmap_pages, move_pages}; }

void* LargeBlocks::allocate(std::size_t size, std::size_t alignment) noexcept {
  alignment = std::max(alignment, kHugePage);
  // So much that rounding cannot overflow; there is no such block anyway.
  if (size > std::numeric_limits<std::size_t>::max() / 4 ||
      alignment > std::numeric_limits<std::size_t>::max() / 4) {
    return nullptr;
  }
  const std::size_t bytes = rounded_up(std::max<std::size_t>(size, 1), kPage);
  const std::lock_guard lock(mutex_);
  char* block = nullptr;
  try {
    block = take_kept(bytes, alignment);
    if (block == nullptr) block = map_with_kept(bytes, alignment);
    if (block == nullptr) {
      give_back(bytes_kept_);
      block = map_fresh(bytes, alignment);
    }
    if (block == nullptr) return nullptr;
    seams_.emplace(block, 0);
    used_.emplace(block, bytes);
  } catch (const std::bad_alloc&) {
    if (block != nullptr) unmap(block, bytes);
    return nullptr;
  }
  bytes_used_ += bytes;
  most_used_ = std::max(most_used_, bytes_used_);
  return block;
}

bool LargeBlocks::free(void* block) noexcept {
  const std::lock_guard lock(mutex_);
  const auto found = used_.find(static_cast<char*>(block));
  if (found == used_.end()) return false;
  bytes_used_ -= found->second;
  keep(used_.extract(found));
  return true;
}

void LargeBlocks::give_back() noexcept {
  const std::lock_guard lock(mutex_);
  give_back(bytes_kept_);
}

LargeBlocks::Figures LargeBlocks::figures() const {
  const std::lock_guard lock(mutex_);
  return {bytes_used_, bytes_kept_, most_used_};
}

// From the smallest piece that it fits in. What is left before and behind stays kept.
char* LargeBlocks::take_kept(std::size_t bytes, std::size_t alignment) {
  auto best = kept_.end();
  for (auto piece = kept_.begin(); piece != kept_.end(); ++piece) {
    const auto [begin, size] = *piece;
    const auto before = static_cast<std::size_t>(rounded_up(begin, alignment) - begin);
    if (size < before || size - before < bytes) continue;
    if (best == kept_.end() || size < best->second) best = piece;
  }
  if (best == kept_.end()) return nullptr;
  const auto [begin, size] = *best;
  char* const block = rounded_up(begin, alignment);
  const auto before = static_cast<std::size_t>(block - begin);
  if (before + bytes < size) kept_.emplace(block + bytes, size - before - bytes);
  best->second = before;
  if (before == 0) kept_.erase(best);
  bytes_kept_ -= bytes;
  return block;
}

char* LargeBlocks::map_fresh(std::size_t bytes, std::size_t alignment) {
  auto* const begin = static_cast<char*>(source_.map(bytes + alignment));
  if (begin == nullptr) return nullptr;
  char* const block = rounded_up(begin, alignment);
  const auto before = static_cast<std::size_t>(block - begin);
  if (before > 0) source_.unmap(begin, before);
  if (before < alignment) source_.unmap(block + bytes, alignment - before);
  return block;
}

char* LargeBlocks::map_with_kept(std::size_t bytes, std::size_t alignment) {
  char* block = map_fresh(bytes, alignment);
  if (block != nullptr && !fill_from_kept(block, bytes)) {
    unmap(block, bytes);
    block = nullptr;
  }
  give_back_beyond(std::max(most_used_, bytes_used_ + bytes) - bytes_used_ - bytes);
  return block;
}

// What is kept takes the place of fresh pages, as far as it goes, for moving costs less than
// clearing. Whole huge pages only: what is behind the last of a piece is too small for a block.
bool LargeBlocks::fill_from_kept(char* block, std::size_t bytes) {
  std::size_t left = bytes / kHugePage * kHugePage;
  for (auto piece = kept_.begin(); piece != kept_.end() && left > 0;) {
    auto& [begin, size] = *piece;
    const auto before = static_cast<std::size_t>(rounded_up(begin, kHugePage) - begin);
    const std::size_t whole = size < before ? 0 : (size - before) / kHugePage * kHugePage;
    if (whole == 0) {
      ++piece;
      continue;
    }
    const std::size_t behind = size - before - whole;
    const std::size_t part = std::min(whole, left);
    if (behind > 0) unmap(begin + before + whole, behind);
    size -= behind;
    bytes_kept_ -= behind;
    if (!move_pages(begin + before + whole - part, part, block + left - part)) return false;
    size -= part;
    bytes_kept_ -= part;
    left -= part;
    piece = size == 0 ? kept_.erase(piece) : std::next(piece);
  }
  return true;
}

// One mapping after the other, for a move is of one.
bool LargeBlocks::move_pages(char* from, std::size_t bytes, char* to) {
  try {
    seams_.emplace(to + bytes, 0);
    while (bytes > 0) {
      const auto seam = seams_.lower_bound(from + bytes);
      const bool inside = seam != seams_.begin() && std::prev(seam)->first > from;
      const std::size_t rest = inside ? static_cast<std::size_t>(std::prev(seam)->first - from) : 0;
      seams_.emplace(to + rest, 0);
      if (!source_.move(from + rest, bytes - rest, to + rest)) return false;
      seams_.erase(seams_.lower_bound(from + rest), seams_.lower_bound(from + bytes));
      bytes = rest;
    }
    return true;
  } catch (const std::bad_alloc&) {
    return false;
  }
}

void LargeBlocks::unmap(char* begin, std::size_t bytes) {
  source_.unmap(begin, bytes);
  seams_.erase(seams_.lower_bound(begin), seams_.lower_bound(begin + bytes));
}

// Joins it with the pieces that touch it. Nothing is allocated, for this must not fail.
void LargeBlocks::keep(Pieces::node_type piece) {
  bytes_kept_ += piece.mapped();
  auto after = kept_.lower_bound(piece.key());
  if (after != kept_.end() && piece.key() + piece.mapped() == after->first) {
    piece.mapped() += after->second;
    after = kept_.erase(after);
  }
  if (after != kept_.begin()) {
    const auto before = std::prev(after);
    if (before->first + before->second == piece.key()) {
      before->second += piece.mapped();
      return;
    }
  }
  kept_.insert(after, std::move(piece));
}

void LargeBlocks::give_back_beyond(std::size_t bytes) {
  if (bytes_kept_ > bytes) give_back(bytes_kept_ - bytes);
}

// At least so many bytes, smallest pieces first, for they fit the fewest blocks.
void LargeBlocks::give_back(std::size_t bytes) {
  while (bytes > 0 && !kept_.empty()) {
    const auto piece =
        std::min_element(kept_.begin(), kept_.end(),
                         [](const auto& a, const auto& b) { return a.second < b.second; });
    const std::size_t part = std::min(piece->second, rounded_up(bytes, kHugePage));
    unmap(piece->first + piece->second - part, part);
    piece->second -= part;
    if (piece->second == 0) kept_.erase(piece);
    bytes_kept_ -= part;
    bytes -= std::min(bytes, part);
  }
}

}  // namespace surpass::cli
