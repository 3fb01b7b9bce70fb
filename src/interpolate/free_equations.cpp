#include "interpolate/free_equations.hpp"

#include <vector>

#include "interpolate/independent_rows.hpp"

namespace surpass {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_rows(const RequirementRows& equations, const Elimination& elimination,
              FreeEquations& into) {
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
          if (w != 0)
            to.emplace_back(static_cast<int>(i), static_cast<int>(std::size_t{3} * column + c), w);
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
  into.all.resize(size, width);
  into.free.resize(size, width);
  into.all.setFromTriplets(all.begin(), all.end());
  into.free.setFromTriplets(free.begin(), free.end());
}

double value_in_units(const RequirementRow& row, const Requirement& r,
                      const ConstraintUnits& units) {
  if (r.kind != Requirement::Kind::position) return row.value * units.scale;
  double origin = 0;
  for (std::size_t c = 0; c < 3; ++c) origin += row.normal[c] * units.origin[c];
  return (row.value - origin) * units.scale;
}

}  // namespace

FreeEquations free_equations(const RequirementRows& equations,
                             std::span<const Requirement> requirements,
                             const Elimination& elimination, const ConstraintUnits& units) {
  FreeEquations result;
  add_rows(equations, elimination, result);
  for (Eigen::VectorXd* v : {&result.in_units, &result.factor}) {
    v->resize(result.all.rows());
  }
  for (Eigen::Index i = 0; i < result.all.rows(); ++i) {
    const RequirementRow& row = equations.rows[static_cast<std::size_t>(i)];
    result.in_units[i] = value_in_units(row, requirements[row.requirement], units);
    const double length = result.all.row(i).norm();
    const double left = result.free.row(i).norm();
    result.factor[i] = left > kDependent * length ? 1 / length : 0;
  }
  return result;
}

}  // namespace surpass
