// Lists of weights, each kept once: most rows of a mesh are like few others.
#pragma once

#include <surpass/mesh.hpp>

#include <array>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace surpass {

/// Lists are equal if all their bits are.
class WeightLists {
 public:
  /// The list's number; it is added if it is new.
  Index number_of(std::span<const double> list);

  [[nodiscard]] Index size() const { return static_cast<Index>(starts_.size() - 1); }
  [[nodiscard]] std::span<const double> operator[](Index number) const {
    return std::span(weights_).subspan(starts_[number], starts_[number + 1] - starts_[number]);
  }
  /// Where it starts among the weights of all lists.
  [[nodiscard]] Index start(Index number) const { return starts_[number]; }
  [[nodiscard]] std::vector<double> take_weights() && { return std::move(weights_); }

 private:
  static constexpr std::size_t kSlots = 64;

  std::vector<double> weights_;
  std::vector<Index> starts_ = {0};
  std::unordered_map<std::string, Index> numbers_;  // by their bytes
  std::array<Index, kSlots> recent_ = {};  // number + 1, or 0: saves most lists from being hashed
};

}  // namespace surpass
