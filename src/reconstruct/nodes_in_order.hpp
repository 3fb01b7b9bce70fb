// Memory whose addresses rise in the order in which it was asked for.
//
// CGAL's front keeps the edges of its border sorted by priority, and those of equal priority by
// address, which is chance. With their list in here the order is that in which they were made, so
// that the same points give the same mesh, whatever was allocated before.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace surpass::reconstruction {

/// Serves the InOrder allocators of the thread that made it while it lives, and gives all back at
/// its end. Not more than one at a time in a thread.
class NodesInOrder {
 public:
  /// `expected`: bytes; what is more comes in further pieces, in order only among themselves.
  explicit NodesInOrder(std::size_t expected) {
    add_piece(expected);
    current() = this;
  }
  ~NodesInOrder() { current() = nullptr; }
  NodesInOrder(const NodesInOrder&) = delete;
  NodesInOrder& operator=(const NodesInOrder&) = delete;

  static NodesInOrder*& current() {
    static thread_local NodesInOrder* arena = nullptr;
    return arena;
  }

  [[nodiscard]] void* take(std::size_t bytes) {
    constexpr std::size_t kUnit = alignof(std::max_align_t);
    bytes = (bytes + kUnit - 1) / kUnit * kUnit;
    if (bytes > left_) add_piece(std::max(bytes, kPiece));
    left_ -= bytes;
    return std::exchange(next_, next_ + bytes);
  }

 private:
  static constexpr std::size_t kPiece = std::size_t{1} << 20;

  void add_piece(std::size_t bytes) {
    pieces_.push_back(std::make_unique_for_overwrite<std::byte[]>(bytes));
    next_ = pieces_.back().get();
    left_ = bytes;
  }

  std::vector<std::unique_ptr<std::byte[]>> pieces_;
  std::byte* next_ = nullptr;
  std::size_t left_ = 0;
};

/// Allocates from the thread's NodesInOrder.
template <class T>
struct InOrder {
  using value_type = T;
  InOrder() = default;
  template <class U>
  explicit InOrder(const InOrder<U>& /*all are alike*/) {}
  [[nodiscard]] T* allocate(std::size_t n) {
    return static_cast<T*>(NodesInOrder::current()->take(n * sizeof(T)));
  }
  void deallocate(T* /*given back with all*/, std::size_t) {}
  bool operator==(const InOrder&) const = default;
};

}  // namespace surpass::reconstruction
