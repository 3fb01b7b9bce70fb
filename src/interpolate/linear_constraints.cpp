#include "interpolate/linear_constraints.hpp"

#include <map>
#include <numeric>
#include <set>

#include <Eigen/SparseCore>
#include <fmt/format.h>

#include "interpolate/independent_rows.hpp"
#include "interpolate/requirement_places.hpp"
#include "interpolate/sparse_cholesky.hpp"

namespace surpass {
namespace {

using Vector = Eigen::VectorXd;
using Rows = Eigen::SparseMatrix<double, Eigen::RowMajor>;
using Triplets = std::vector<Eigen::Triplet<double>>;

// Of an equation's length. What is left of it by free points is rounding if it is shorter.
constexpr double kNothing = 1e-9;
// Relative to the box side: equations that are dropped must hold to this.
constexpr double kHolds = 1e-10;
// In the units of the solve; squares of larger numbers may overflow.
constexpr double kFarthest = 1e100;

int number(std::size_t i) { return static_cast<int>(i); }

// Every equation over all control points, and over the free ones after elimination.
struct BothRows {
  Rows all;
  Rows free;
};

BothRows both_rows(const RequirementRows& equations, const Elimination& elimination) {
  Triplets all;
  Triplets free;
  for (std::size_t i = 0; i < equations.rows.size(); ++i) {
    const RequirementRow& row = equations.rows[i];
    const auto& weights = equations.weights[row.stencil];
    for (std::size_t k = 0; k < weights.columns.size(); ++k) {
      const Index j = weights.columns[k];
      const auto add = [&](Triplets& to, Index column, double factor) {
        for (std::size_t c = 0; c < 3; ++c) {
          const double w = factor * weights.values[k] * row.normal[c];
          if (w != 0) to.emplace_back(number(i), number(std::size_t{3} * column + c), w);
        }
      };
      add(all, j, 1);
      const Index given = elimination.given_of(j);
      if (given == kNone) {
        add(free, j, 1);
      } else {
        elimination.for_each_coefficient(given, [&](Index f, double w) { add(free, f, w); });
      }
    }
  }
  const auto size = static_cast<Eigen::Index>(equations.rows.size());
  const auto width = static_cast<Eigen::Index>(std::size_t{3} * elimination.control_count());
  BothRows rows{Rows(size, width), Rows(size, width)};
  rows.all.setFromTriplets(all.begin(), all.end());
  rows.free.setFromTriplets(free.begin(), free.end());
  return rows;
}

Rows inverse_blocks(const FreePreconditioner& preconditioner, Index control_points) {
  Triplets entries;
  const std::size_t block = preconditioner.block_size();
  for (std::size_t j = 0; j < control_points; ++j) {
    const double* d = &preconditioner.inverse()[j * block];
    constexpr std::array<std::array<std::size_t, 3>, 3> kUpper = {
        {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (block == 1 && r != c) continue;
        entries.emplace_back(number(3 * j + r), number(3 * j + c),
                             block == 1 ? d[0] : d[kUpper[r][c]]);
      }
    }
  }
  const auto width = static_cast<Eigen::Index>(std::size_t{3} * control_points);
  Rows blocks(width, width);
  blocks.setFromTriplets(entries.begin(), entries.end());
  return blocks;
}

// `amount`: in units of the box side.
tl::unexpected<Error> contradiction(std::set<std::size_t> numbers, std::size_t last, double amount,
                                    std::span<const Requirement> requirements) {
  numbers.insert(last);
  const std::vector<std::size_t> all(numbers.begin(), numbers.end());
  const std::string what =
      all.size() == 1
          ? fmt::format("requirement {} contradicts itself or the given vertices",
                        names_of(all, requirements))
          : fmt::format("requirements contradict each other: {}", names_of(all, requirements));
  const Requirement& r = requirements[last];
  const bool at_vertex = all.size() == 1 && r.kind == Requirement::Kind::position &&
                         r.vertex == kNone && corner_at(r.place) != kNone;
  return fail(ErrorCode::contradictory,
              fmt::format("{}; together they miss by {:.3g} of the box side{}", what, amount,
                          at_vertex ? "; a given vertex lies there, which a position at the vertex "
                                      "moves"
                                    : ""),
              place_of(r));
}

// Values of the equations in the units of the solve.
double value_in_units(const RequirementRow& row, const Requirement& r,
                      const LinearConstraints::Units& units) {
  if (r.kind != Requirement::Kind::position) return row.value * units.scale;
  double origin = 0;
  for (std::size_t c = 0; c < 3; ++c) origin += row.normal[c] * units.origin[c];
  return (row.value - origin) * units.scale;
}

// Of the equations: their values in units, and as they were given; and what rows are multiplied
// with to have length 1, 0 where free points say nothing.
struct Values {
  Vector in_units;
  Vector absolute;
  Vector factor;
};

Values values_of(const RequirementRows& equations, std::span<const Requirement> requirements,
                 const BothRows& rows, const LinearConstraints::Units& units) {
  const auto count = static_cast<Eigen::Index>(equations.rows.size());
  Values values{Vector(count), Vector(count), Vector(count)};
  for (Eigen::Index i = 0; i < count; ++i) {
    const RequirementRow& row = equations.rows[static_cast<std::size_t>(i)];
    values.in_units[i] = value_in_units(row, requirements[row.requirement], units);
    values.absolute[i] = row.value;
    const double length = rows.all.row(i).norm();
    const double left = rows.free.row(i).norm();
    values.factor[i] = left > kNothing * length ? 1 / left : 0;
  }
  return values;
}

}  // namespace

struct LinearConstraints::Contents {
  const Elimination* elimination = nullptr;
  Rows all;       // independent equations, each divided by the length of its free part
  Rows free;      // the same over free points
  Rows downward;  // inverse blocks times the transpose of `free`
  Vector value;   // in the units of the solve
  Vector absolute_value;
  SparseCholesky products;
  bool decomposed = false;
  Vector squares;  // the diagonal of the products
  std::vector<unsigned char> redundant;
  std::set<std::size_t> opposed;

  // The equations that are solved for: `pick` times all that were asked. Incomplete if cancelled.
  void solve_for(const Rows& pick, const BothRows& rows, const Values& values, const Rows& inverse,
                 const Context& context) {
    all = pick * rows.all;
    free = pick * rows.free;
    value = pick * values.in_units;
    absolute_value = pick * values.absolute;
    if (context.cancelled()) return;
    downward = inverse * Rows(free.transpose());
    if (context.cancelled()) return;
    const Symmetric product = free * downward;
    squares = product.diagonal();
    if (context.cancelled()) return;
    decomposed = products.compute(product, 0, context);
  }

  // Whether each equation has, by what measures changes here, a thousandth or more of its length of
  // its own, that is, apart from those that were decomposed before it.
  [[nodiscard]] bool far_from_dependent() const {
    constexpr double kFar = 1e-6;  // a squared share
    return decomposed && (products.pivots().array() > kFar * squares.array()).all();
  }

  [[nodiscard]] Vector multipliers(const Vector& right) const {
    Vector x = products.solve(right);
    const Vector rest = right - free * (downward * x);  // once more for its digits
    return x + products.solve(rest);
  }
};

LinearConstraints::LinearConstraints(std::unique_ptr<Contents> contents)
    : contents_(std::move(contents)) {}
LinearConstraints::LinearConstraints(LinearConstraints&&) noexcept = default;
LinearConstraints& LinearConstraints::operator=(LinearConstraints&&) noexcept = default;
LinearConstraints::~LinearConstraints() = default;

const std::vector<unsigned char>& LinearConstraints::redundant() const {
  return contents_->redundant;
}

const std::set<std::size_t>& LinearConstraints::opposed() const { return contents_->opposed; }

namespace {

// Rows that are nearly dependent. Of each that is kept only its own part is; of rows that have the
// same own part one is kept, and the others are sums of it and of those that it is expressed by.
struct NearRows {
  std::vector<DependentRow> kept;
  std::vector<DependentRow> dropped;
};

template <class Skip>
NearRows nearly_dependent(const Rows& rows, const IndependentRows& found, const Context& context,
                          Skip&& skip) {
  std::vector<const DependentRow*> near;
  Triplets own;
  for (const DependentRow& d : found.dependent) {
    if (!(d.distance > kDependent) || skip(d.row)) continue;
    const int at = number(near.size());
    near.push_back(&d);
    std::map<Eigen::Index, double> rest;
    const auto add = [&](int row, double factor) {
      for (Rows::InnerIterator k(rows, row); k; ++k) rest[k.col()] += factor * k.value();
    };
    add(d.row, 1 / d.distance);
    for (const auto& [other, share] : d.shares) add(other, -share / d.distance);
    for (const auto& [column, w] : rest) own.emplace_back(at, static_cast<int>(column), w);
  }
  Rows parts(static_cast<Eigen::Index>(near.size()), rows.cols());
  parts.setFromTriplets(own.begin(), own.end());
  const IndependentRows among = independent_rows(parts, context);
  NearRows result;
  for (const int k : among.independent) result.kept.push_back(*near[static_cast<std::size_t>(k)]);
  // A millionth of a millionth of the row's length is left of it: nothing.
  for (const DependentRow& again : among.dependent) {
    const DependentRow& d = *near[static_cast<std::size_t>(again.row)];
    std::map<int, double> shares(d.shares.begin(), d.shares.end());
    for (const auto& [k, share] : again.shares) {
      const DependentRow& other = *near[static_cast<std::size_t>(k)];
      const double factor = share * d.distance / other.distance;
      shares[other.row] += factor;
      for (const auto& [row, weight] : other.shares) shares[row] -= factor * weight;
    }
    result.dropped.push_back({d.row, again.distance * d.distance, {shares.begin(), shares.end()}});
  }
  return result;
}

// The equations that are solved for, as sums of all. What a nearly dependent row has of its own
// takes its place, at full length.
Rows picked_rows(const IndependentRows& found, const NearRows& near, const Vector& factor) {
  Triplets picked;
  int place = 0;
  for (const int row : found.independent) picked.emplace_back(place++, row, factor[row]);
  for (const DependentRow& d : near.kept) {
    picked.emplace_back(place, d.row, factor[d.row] / d.distance);
    for (const auto& [other, share] : d.shares) {
      picked.emplace_back(place, other, -share / d.distance * factor[other]);
    }
    ++place;
  }
  Rows pick(place, factor.size());
  pick.setFromTriplets(picked.begin(), picked.end());
  return pick;
}

IndependentRows every_row(Eigen::Index count) {
  IndependentRows rows;
  rows.independent.resize(static_cast<std::size_t>(count));
  std::iota(rows.independent.begin(), rows.independent.end(), 0);
  return rows;
}

tl::unexpected<Error> cancelled() {
  return fail(ErrorCode::cancelled, "cancelled while setting up");
}

tl::unexpected<Error> not_decomposed() {
  return fail(ErrorCode::singular, "the requirements are too nearly dependent to be solved for");
}

using Contents = LinearConstraints::Contents;

class Builder {
 public:
  Builder(const RequirementRows& equations, std::span<const Requirement> requirements,
          const FreeSystem& system, std::span<const double> targets,
          const LinearConstraints::Units& units)
      : equations_(equations),
        requirements_(requirements),
        system_(system),
        side_(units.side * units.scale),
        rows_(both_rows(equations, system.elimination)),
        values_(values_of(equations, requirements, rows_, units)),
        contents_(std::make_unique<Contents>()) {
    // What the equations are where all free points are 0.
    std::vector<double> fixed(system.size(), 0.0);
    system.elimination.meet(system.context, 3, targets, fixed);
    missed_ =
        values_.in_units -
        rows_.all * Eigen::Map<const Vector>(fixed.data(), static_cast<Eigen::Index>(fixed.size()));
  }

  Result<std::unique_ptr<Contents>> build() && {
    if (auto ok = check_fixed(); !ok) return tl::make_unexpected(ok.error());
    if (system_.context.cancelled()) return cancelled();
    const Rows inverse = inverse_blocks(FreePreconditioner(system_, Precision::full),
                                        system_.elimination.control_count());
    // Nearly always all are independent, and then the decomposition that is needed anyway tells so.
    found_ = every_row(values_.factor.size());
    const bool may_be = rows_.free.rows() <= rows_.free.cols();
    if (may_be) {
      contents_->solve_for(picked_rows(found_, near_, values_.factor), rows_, values_, inverse,
                           system_.context);
    }
    if (system_.context.cancelled()) return cancelled();
    if (!may_be || !contents_->far_from_dependent()) {
      if (auto ok = choose(); !ok) return tl::make_unexpected(ok.error());
      contents_->solve_for(picked_rows(found_, near_, values_.factor), rows_, values_, inverse,
                           system_.context);
    }
    if (system_.context.cancelled()) return cancelled();
    if (!contents_->decomposed) return not_decomposed();
    mark_redundant();
    contents_->elimination = &system_.elimination;
    return std::move(contents_);
  }

 private:
  // Whether equations can be computed with, and those of which free points say nothing hold
  // already, or never.
  [[nodiscard]] Result<void> check_fixed() const {
    for (Eigen::Index i = 0; i < values_.factor.size(); ++i) {
      const double missed = std::abs(missed_[i]) / side_;
      const int row = static_cast<int>(i);
      if (!(std::abs(values_.in_units[i]) <= kFarthest)) {
        const std::size_t number = requirement_of(row);
        return refuse_requirement(requirements_[number], number,
                                  "its numbers are so large beside the given mesh that nothing can "
                                  "be computed with both",
                                  ErrorCode::not_finite);
      }
      if (values_.factor[i] == 0 && !is_chosen(row) && missed > kHolds) {
        return contradiction({}, requirement_of(row), missed, requirements_);
      }
    }
    return {};
  }

  // Those that do not depend on others, once it is sure that these agree with them. Where more is
  // asked than there are numbers to choose, as many show what is wrong sooner than all.
  Result<void> choose() {
    const Rows scaled = values_.factor.asDiagonal() * rows_.free;
    const Eigen::Index numbers = scaled.cols();
    if (scaled.rows() > numbers) {
      if (auto ok = choose_among(scaled.topRows(numbers)); !ok) return ok;
    }
    return choose_among(scaled);
  }

  Result<void> choose_among(const Rows& scaled) {
    found_ = independent_rows(scaled, system_.context);
    if (system_.context.cancelled()) return cancelled();
    const std::size_t told = found_.independent.size() + found_.dependent.size();
    if (told < static_cast<std::size_t>(scaled.rows())) return not_decomposed();
    near_ =
        nearly_dependent(scaled, found_, system_.context, [&](int row) { return is_chosen(row); });
    if (system_.context.cancelled()) return cancelled();
    for (const DependentRow& d : found_.dependent) {
      if (d.distance > kDependent && !is_chosen(d.row)) continue;
      if (auto ok = check_dependent(d); !ok) return ok;
    }
    for (const DependentRow& d : near_.dropped) {
      if (auto ok = check_dependent(d); !ok) return ok;
    }
    return {};
  }

  Result<void> check_dependent(const DependentRow& d) {
    if (values_.factor[d.row] == 0) return {};
    const auto wanted = [&](int row) { return values_.factor[row] * missed_[row]; };
    double rest = wanted(d.row);
    std::set<std::size_t> others;
    for (const auto& [other, share] : d.shares) {
      rest -= share * wanted(other);
      constexpr double kMatters = 1e-6;
      if (std::abs(share) > kMatters) others.insert(requirement_of(other));
    }
    const double missed = std::abs(rest) / values_.factor[d.row] / side_;
    if (missed <= kHolds) return {};
    if (is_chosen(d.row)) {
      contents_->opposed.merge(others);
      return {};
    }
    return contradiction(std::move(others), requirement_of(d.row), missed, requirements_);
  }

  void mark_redundant() {
    std::vector<unsigned char>& redundant = contents_->redundant;
    redundant.assign(requirements_.size(), 0);
    for (const RequirementRow& row : equations_.rows) redundant[row.requirement] = 1;
    const auto is_needed = [&](int row) {
      if (!is_chosen(row)) redundant[requirement_of(row)] = 0;
    };
    for (const int row : found_.independent) is_needed(row);
    for (const DependentRow& d : near_.kept) is_needed(d.row);
  }

  [[nodiscard]] std::size_t requirement_of(int row) const {
    return equations_.rows[static_cast<std::size_t>(row)].requirement;
  }
  [[nodiscard]] bool is_chosen(int row) const {
    return equations_.rows[static_cast<std::size_t>(row)].chosen;
  }

  const RequirementRows& equations_;
  std::span<const Requirement> requirements_;
  const FreeSystem& system_;
  double side_;  // of the box, in the units of the solve
  BothRows rows_;
  Values values_;
  Vector missed_;  // by each equation, in the units of the solve, where all free points are 0
  IndependentRows found_;
  NearRows near_;
  std::unique_ptr<Contents> contents_;
};

}  // namespace

Result<LinearConstraints> LinearConstraints::build(const RequirementRows& equations,
                                                   std::span<const Requirement> requirements,
                                                   const FreeSystem& system,
                                                   std::span<const double> targets,
                                                   const Units& units) {
  auto contents = Builder(equations, requirements, system, targets, units).build();
  if (!contents) return tl::make_unexpected(contents.error());
  return LinearConstraints(std::move(*contents));
}

void LinearConstraints::clear(std::span<double> gradient) const {
  Eigen::Map<Vector> g(gradient.data(), static_cast<Eigen::Index>(gradient.size()));
  const Vector along = contents_->downward.transpose() * g;
  g -= contents_->free.transpose() * contents_->multipliers(along);
}

void LinearConstraints::keep(std::span<double> change) const {
  Eigen::Map<Vector> x(change.data(), static_cast<Eigen::Index>(change.size()));
  const Vector altered = contents_->free * x;
  x -= contents_->downward * contents_->multipliers(altered);
}

void LinearConstraints::meet(const Context& context, std::span<double> x, bool in_units) const {
  const Eigen::Map<const Vector> at(x.data(), static_cast<Eigen::Index>(x.size()));
  const Vector& value = in_units ? contents_->value : contents_->absolute_value;
  const Vector change = contents_->downward * contents_->multipliers(value - contents_->all * at);
  std::vector<double> extended(change.data(), change.data() + change.size());
  contents_->elimination->meet(context, 3, {}, extended);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += extended[i];
}

}  // namespace surpass
