#include "interpolate/contradiction.hpp"

#include <vector>

#include <fmt/format.h>

#include "interpolate/fewest_rows.hpp"
#include "interpolate/requirement_places.hpp"

namespace surpass {
namespace {

using Numbers = std::set<std::size_t>;

class Contradiction {
 public:
  Contradiction(const RowCheck& check, const RowMatrix& scaled, const Context& context)
      : check_(check), scaled_(scaled), context_(context) {}

  [[nodiscard]] Numbers taking_part(const DependentRow& d) const {
    Numbers all = {check_.requirement_of(d.row)};
    for (const auto& [other, share] : d.shares) all.insert(check_.requirement_of(other));
    return all;
  }

  // By as few rows as say something else.
  [[nodiscard]] DependentRow shortest(const DependentRow& d) const {
    const Suffices contradicts = [&](const DependentRow& e) {
      return e.distance <= kDependent && check_.is_missed(e);
    };
    return by_fewest_rows(scaled_, d, contradicts, context_);
  }

  // Where requirements can be left out because the others contradict each other by other rows of
  // theirs, they are: halves first, single ones last.
  [[nodiscard]] DependentRow by_fewest_requirements(DependentRow d) const {
    constexpr std::size_t kMostRows = 5000;  // of all tries
    std::size_t rows = 0;
    Numbers numbers = taking_part(d);
    for (std::size_t part = (numbers.size() + 1) / 2; part > 0; part /= 2) {
      for (std::size_t begin = 0; begin < numbers.size() && rows < kMostRows;) {
        const RowNumbers others = rows_of(without(numbers, begin, part));
        rows += others.size();
        std::optional<DependentRow> other;
        (void)check_.consistent_rows(scaled_, others, other);
        if (other) {
          d = *other;
          numbers = taking_part(d);
        } else {
          begin += part;
        }
      }
    }
    return shortest(d);
  }

 private:
  [[nodiscard]] static Numbers without(const Numbers& numbers, std::size_t begin,
                                       std::size_t count) {
    Numbers rest;
    std::size_t at = 0;
    for (const std::size_t number : numbers) {
      if (at < begin || at >= begin + count) rest.insert(number);
      ++at;
    }
    return rest;
  }

  [[nodiscard]] RowNumbers rows_of(const Numbers& numbers) const {
    RowNumbers rows;
    for (int row = 0; row < scaled_.rows(); ++row) {
      if (!check_.is_chosen(row) && numbers.contains(check_.requirement_of(row))) {
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

tl::unexpected<Error> contradiction(const Numbers& numbers, double amount,
                                    std::span<const Requirement> requirements) {
  const std::vector<std::size_t> all(numbers.begin(), numbers.end());
  const std::string what =
      all.size() == 1
          ? fmt::format("requirement {} contradicts itself or the given vertices",
                        names_of(all, requirements))
          : fmt::format("requirements contradict each other: {}", names_of(all, requirements));
  const Requirement& r = requirements[all.front()];
  const bool at_vertex = all.size() == 1 && r.kind == Requirement::Kind::position &&
                         r.vertex == kNone && corner_at(r.place) != kNone;
  return fail(ErrorCode::contradictory,
              fmt::format("{}; {} by {:.3g} of the box side{}", what,
                          all.size() == 1 ? "it misses" : "together they miss", amount,
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
  return contradiction(found.taking_part(few), check.missed_by(few), requirements);
}

tl::unexpected<Error> not_told_apart() {
  return fail(ErrorCode::contradictory,
              "the requirements are too nearly dependent to be told apart; leave some of them out");
}

}  // namespace surpass
