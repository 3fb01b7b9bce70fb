#include "interpolate/contradiction.hpp"

#include <algorithm>
#include <set>
#include <vector>

#include <fmt/format.h>

#include "interpolate/fewest_rows.hpp"
#include "interpolate/leave_out.hpp"
#include "interpolate/requirement_places.hpp"

namespace surpass {
namespace {

using Numbers = std::vector<std::size_t>;  // ascending

class Contradiction {
 public:
  Contradiction(const RowCheck& check, const RowMatrix& scaled, const Context& context)
      : check_(check), scaled_(scaled), context_(context) {}

  [[nodiscard]] Numbers taking_part(const DependentRow& d) const {
    std::set<std::size_t> all = {check_.requirement_of(d.row)};
    for (const auto& [other, share] : d.shares) all.insert(check_.requirement_of(other));
    return {all.begin(), all.end()};
  }

  // By as few rows as say something else.
  [[nodiscard]] DependentRow shortest(const DependentRow& d) const {
    const Suffices contradicts = [&](const DependentRow& e) {
      return e.distance <= kDependent && check_.is_missed(e);
    };
    return by_fewest_rows(scaled_, d, contradicts, context_);
  }

  // Where requirements can be left out because the others contradict each other by other rows of
  // theirs, they are.
  [[nodiscard]] DependentRow by_fewest_requirements(DependentRow d) const {
    constexpr std::size_t kMostRows = 5000;  // of all tries
    std::size_t rows = 0;
    (void)leave_out(taking_part(d), [&](const Numbers& fewer) -> std::optional<Numbers> {
      if (rows >= kMostRows) return std::nullopt;
      const RowNumbers those = rows_of(fewer);
      rows += those.size();
      auto other = check_.look_at(scaled_, those).contradicts;
      if (!other) return std::nullopt;
      d = std::move(*other);
      return taking_part(d);
    });
    return shortest(d);
  }

 private:
  [[nodiscard]] RowNumbers rows_of(const Numbers& numbers) const {
    RowNumbers rows;
    for (int row = 0; row < scaled_.rows(); ++row) {
      const std::size_t number = check_.requirement_of(row);
      if (!check_.is_chosen(row) && std::binary_search(numbers.begin(), numbers.end(), number)) {
        rows.push_back(row);
      }
    }
    return rows;
  }

  const RowCheck& check_;
  const RowMatrix& scaled_;
  const Context& context_;
};

}  // namespace

tl::unexpected<Error> contradiction(std::span<const std::size_t> numbers, double amount,
                                    std::span<const Requirement> requirements) {
  const std::string what =
      numbers.size() == 1
          ? fmt::format("requirement {} contradicts itself or the given vertices",
                        names_of(numbers, requirements))
          : fmt::format("requirements contradict each other: {}", names_of(numbers, requirements));
  const Requirement& r = requirements[numbers.front()];
  const bool at_vertex = numbers.size() == 1 && r.kind == Requirement::Kind::position &&
                         r.vertex == kNone && corner_at(r.place) != kNone;
  return fail(ErrorCode::contradictory,
              fmt::format("{}; {} by {:.3g} of the box side{}", what,
                          numbers.size() == 1 ? "it misses" : "together they miss", amount,
                          at_vertex ? "; a given vertex lies there, which a position at the vertex "
                                      "moves"
                                    : ""),
              place_of(r));
}

tl::unexpected<Error> contradiction_of(const DependentRow& d, const RowCheck& check,
                                       const RowMatrix& scaled,
                                       std::span<const Requirement> requirements,
                                       const Context& context) {
  const Contradiction found(check, scaled, context);
  const DependentRow few = found.by_fewest_requirements(found.shortest(d));
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while setting up");
  return contradiction(found.taking_part(few), check.missed_by(few), requirements);
}

tl::unexpected<Error> not_told_apart() {
  return fail(ErrorCode::contradictory,
              "the requirements are too nearly dependent to be told apart; leave some of them out");
}

}  // namespace surpass
