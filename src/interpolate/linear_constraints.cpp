#include "interpolate/linear_constraints.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <Eigen/SparseCore>

#include "interpolate/contradiction.hpp"
#include "interpolate/dispensable_rows.hpp"
#include "interpolate/sparse_cholesky.hpp"

namespace surpass {
namespace {

using Vector = Eigen::VectorXd;
using Rows = FreeEquations::Rows;

Rows inverse_blocks(const FreePreconditioner& preconditioner, Index control_points) {
  std::vector<Eigen::Triplet<double>> entries;
  const std::size_t block = preconditioner.block_size();
  for (std::size_t j = 0; j < control_points; ++j) {
    const double* d = &preconditioner.inverse()[j * block];
    constexpr std::array<std::array<std::size_t, 3>, 3> kUpper = {
        {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}}};
    for (std::size_t r = 0; r < 3; ++r) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (block == 1 && r != c) continue;
        entries.emplace_back(static_cast<int>(3 * j + r), static_cast<int>(3 * j + c),
                             block == 1 ? d[0] : d[kUpper[r][c]]);
      }
    }
  }
  const auto width = static_cast<Eigen::Index>(std::size_t{3} * control_points);
  Rows blocks(width, width);
  blocks.setFromTriplets(entries.begin(), entries.end());
  return blocks;
}

}  // namespace

struct LinearConstraints::Contents {
  const Elimination* elimination = nullptr;
  Rows all;       // independent equations, each divided by the length of its free part
  Rows free;      // the same over free points
  Rows downward;  // inverse blocks times the transpose of `free`
  Vector value;   // in the units of the solve
  SparseCholesky products;
  bool decomposed = false;
  Vector squares;  // the diagonal of the products
  RowFates fates;

  // Of all that were asked those that the agreement picks. Incomplete if cancelled.
  void solve_for(const Agreement& agreement, const FreeEquations& equations, const Rows& inverse,
                 const Context& context) {
    const Rows pick = agreement.picked_rows();
    all = pick * equations.all;
    free = pick * equations.free;
    value = pick * agreement.values();
    if (context.cancelled()) return;
    downward = inverse * Rows(free.transpose());
    if (context.cancelled()) return;
    const Symmetric product = free * downward;
    squares = product.diagonal();
    if (context.cancelled()) return;
    decomposed = products.compute(product, 0, context);
  }

  // Whether each equation has, by what measures changes here, more than that share of its length of
  // its own, that is, apart from those that were decomposed before it.
  [[nodiscard]] bool far_from_dependent(double share) const {
    return decomposed && (products.pivots().array() > share * share * squares.array()).all();
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

const RowFates& LinearConstraints::fates() const { return contents_->fates; }

Result<LinearConstraints> LinearConstraints::build(const RequirementRows& rows,
                                                   std::span<const Requirement> requirements,
                                                   const FreeSystem& system,
                                                   std::span<const double> targets,
                                                   const ConstraintUnits& units) {
  const Context& context = system.context;
  const auto cancelled = [] { return fail(ErrorCode::cancelled, "cancelled while setting up"); };
  const FreeEquations equations = free_equations(rows, requirements, system.elimination, units);
  Agreement agreement(equations, rows, requirements, system, targets, units);
  if (auto ok = agreement.check_fixed(); !ok) return tl::make_unexpected(ok.error());
  if (context.cancelled()) return cancelled();
  const Rows inverse = inverse_blocks(FreePreconditioner(system, Precision::full),
                                      system.elimination.control_count());
  auto contents = std::make_unique<Contents>();
  // Nearly always all are independent, and then the decomposition that is needed anyway tells so.
  const bool any_chosen = std::any_of(rows.rows.begin(), rows.rows.end(),
                                      [](const RequirementRow& row) { return row.chosen; });
  constexpr double kSurelyFar = 1e-3;
  const double far = any_chosen ? kFarFromOthers : kSurelyFar;
  const bool may_be = equations.free.rows() <= equations.free.cols();
  if (may_be) {
    agreement.take_all();
    contents->solve_for(agreement, equations, inverse, context);
  }
  if (context.cancelled()) return cancelled();
  if (!may_be || !contents->far_from_dependent(far)) {
    if (auto ok = agreement.choose(); !ok) return tl::make_unexpected(ok.error());
    contents->solve_for(agreement, equations, inverse, context);
  }
  if (context.cancelled()) return cancelled();
  if (!contents->decomposed) return not_told_apart();
  contents->fates = agreement.fates();
  contents->elimination = &system.elimination;
  return LinearConstraints(std::move(contents));
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

void LinearConstraints::meet(const Context& context, std::span<double> x) const {
  const Eigen::Map<const Vector> at(x.data(), static_cast<Eigen::Index>(x.size()));
  const Vector right = contents_->value - contents_->all * at;
  const Vector change = contents_->downward * contents_->multipliers(right);
  std::vector<double> extended(change.data(), change.data() + change.size());
  contents_->elimination->meet(context, 3, {}, extended);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += extended[i];
}

}  // namespace surpass
