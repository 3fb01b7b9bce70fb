#include "interpolate/similarity_solve.hpp"

#include <cmath>

#include "interpolate/free_preconditioner.hpp"
#include "interpolate/linear_system.hpp"

namespace surpass {
namespace {

// Shifts and scales numbers to the neighbourhood of 0 and 1, so that squares of them neither
// overflow nor lose what matters, and the other way.
struct Units {
  std::vector<double> centre;  // a number per column
  double side = 1;             // of the values' box
  double rounding = 0;         // of the values, relative to it
  double scale = 1;            // a power of two

  void enter(const Context& context, std::span<double> x) const {
    for_all(context, x, [&](double value, double middle) { return (value - middle) * scale; });
  }
  void leave(const Context& context, std::span<double> x) const {
    for_all(context, x, [&](double value, double middle) { return value / scale + middle; });
  }

 private:
  template <class Change>
  void for_all(const Context& context, std::span<double> x, Change&& change) const {
    if (x.empty()) return;
    const std::size_t width = centre.size();
    parallel::for_ranges(context, x.size() / width, [&](std::size_t begin, std::size_t end) {
      double* at = x.data() + begin * width;
      for (std::size_t i = begin; i < end; ++i) {
        for (std::size_t c = 0; c < width; ++c, ++at) *at = change(*at, centre[c]);
      }
    });
  }
};

// Of the vertices that have faces: others may be so far away that nothing were left of these.
Result<Units> units_of(const SimilarityPrepared& prepared, std::span<const double> values,
                       std::size_t width) {
  std::vector<double> low(width, HUGE_VAL);
  std::vector<double> high(width, -HUGE_VAL);
  for (std::size_t i = 0; i < prepared.given_count(); ++i) {
    if (prepared.isolated[i] != 0) continue;
    const double* at = values.data() + i * width;
    for (std::size_t c = 0; c < width; ++c) {
      low[c] = std::min(low[c], at[c]);
      high[c] = std::max(high[c], at[c]);
    }
  }
  Units units{std::vector<double>(width, 0.0)};
  double side = 0;
  for (std::size_t c = 0; c < width && low[c] <= high[c]; ++c) {
    units.centre[c] = low[c] / 2 + high[c] / 2;
    side = std::max(side, high[c] - low[c]);
  }
  if (!std::isfinite(side)) {
    return fail(ErrorCode::not_finite,
                "the coordinates are so large that their differences overflow");
  }
  if (side > 0) units.side = side;
  for (const auto& ends : {low, high}) {
    units.rounding = floored_tolerance(units.rounding, ends, units.side);
  }
  units.scale = power_of_two_scale(units.side);
  return units;
}

std::vector<double> refined_reference(const SimilarityPrepared& prepared, const Wanted& wanted,
                                      const Context& context) {
  const std::span<const double> source = wanted.reference.empty() ? wanted.given : wanted.reference;
  const std::size_t values = prepared.control_count() * wanted.width;
  if (source.size() == values) return {source.begin(), source.end()};
  return refine_given(prepared, wanted.width, source, context);
}

// They are where they are given, in the reference, too.
void keep_isolated(const SimilarityPrepared& prepared, const Wanted& wanted,
                   std::span<const double> given, std::span<double> x) {
  for (Index i = 0; i < prepared.given_count(); ++i) {
    if (prepared.isolated[i] == 0) continue;
    const std::size_t j = wanted.elimination.limits().row_columns(i).front();
    for (std::size_t c = 0; c < wanted.width; ++c) {
      x[j * wanted.width + c] = given[i * wanted.width + c];
    }
  }
}

// The given numbers and the reference that they are to resemble, in units.
struct Start {
  Units units;
  std::vector<double> given;
  std::vector<double> reference;
  std::vector<double> scale;  // that the reference was stretched by
};

Result<Start> start_of(const SimilarityPrepared& prepared, const Wanted& wanted,
                       const Context& context) {
  auto units = units_of(prepared, wanted.given, wanted.width);
  if (!units) return tl::make_unexpected(units.error());
  Start start{std::move(*units),
              {wanted.given.begin(), wanted.given.end()},
              refined_reference(prepared, wanted, context),
              {}};
  start.units.enter(context, start.given);
  start.units.enter(context, start.reference);
  start.scale = scale_reference(prepared, prepared.options.scaling, wanted.width, start.given,
                                context, start.reference);
  keep_isolated(prepared, wanted, start.given, start.reference);
  return start;
}

void leave_reference(const SimilarityPrepared& prepared, const Wanted& wanted, const Units& units,
                     const Context& context, std::span<double> reference) {
  units.leave(context, reference);
  keep_isolated(prepared, wanted, wanted.given, reference);
}

// x relative to where the energy is least; empty where it is there already.
std::vector<double> distance_to_least(const SimilarityPrepared& prepared,
                                      std::span<const double> reference,
                                      std::span<const double> x) {
  std::vector<double> difference(x.begin(), x.end());
  if (prepared.options.similarity != Similarity::fair) {
    // Only the difference to the reference costs, and it may be nothing but rounding.
    double largest = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
      difference[i] -= reference[i];
      largest = std::max(largest, std::abs(difference[i]));
    }
    constexpr double kRounding = 1e-14;  // coordinates are near 1
    if (largest <= kRounding) return {};
  }
  return difference;
}

// The energy's derivative there by the free points. Takes the distance away: it is large.
std::vector<double> gradient_at(const FreeSystem& system, Precision precision,
                                std::vector<double> distance) {
  std::vector<double> gradient(distance.size());
  system.energy.product(system.context, system.width, precision, distance, gradient);
  system.elimination.restrict_gradient(system.context, system.width, gradient);
  return gradient;
}

// Where a step of progressive interpolation leads: what the reference misses the given points by,
// added to its control mesh before the refinement. Far from a vertex little moves at once, and what
// is left to do is local.
std::vector<double> progressive_step(const SimilarityPrepared& prepared, const FreeSystem& system,
                                     std::span<const double> reference,
                                     std::span<const double> given) {
  const std::size_t width = system.width;
  std::vector<double> missed(given.size());
  system.elimination.limits().apply(system.context, width, reference, missed);
  for (std::size_t i = 0; i < given.size(); ++i) {
    const bool released = system.elimination.dependent(static_cast<Index>(i / width)) == kNone;
    missed[i] = released ? 0 : given[i] - missed[i];
  }
  return refine_given(prepared, width, missed, system.context);
}

// x = the reference where points are free, moved to where the energy is least; in units.
FreeOutcome minimise(const SimilarityPrepared& prepared, const FreeSystem& system,
                     std::span<const double> reference, std::span<const double> given,
                     std::span<double> x) {
  std::vector<double> distance = distance_to_least(prepared, reference, x);
  if (distance.empty()) return {.at_rest = true};
  const StopAt stop{prepared.options.solver_tolerance, prepared.options.max_iterations};
  if (prepared.options.solver != SimilaritySolver::gauss_seidel) {
    const Preconditioned how = precondition(system, stop.tolerance);
    if (system.context.cancelled()) return {.cancelled = true};
    std::vector<double> gradient = gradient_at(system, how.precision, std::move(distance));
    auto first = progressive_step(prepared, system, reference, given);
    return conjugate_gradient(system, how, stop, std::move(first), gradient, x);
  }
  std::vector<double> gradient = gradient_at(system, Precision::full, std::move(distance));
  std::vector<double> change(x.size(), 0.0);
  FreeOutcome outcome = gauss_seidel(system, *prepared.layout, stop, gradient, change);
  for (std::size_t i = 0; i < x.size(); ++i) x[i] += change[i];
  return outcome;
}

Result<std::optional<LinearConstraints>> constraints_of(const Wanted& wanted,
                                                        const FreeSystem& system,
                                                        std::span<const double> given,
                                                        const Units& units) {
  if (!wanted.constraints) return std::nullopt;
  const ConstraintUnits own{
      {units.centre[0], units.centre[1], units.centre[2]}, units.scale, units.side, units.rounding};
  auto built = wanted.constraints(system, given, own);
  if (!built) return tl::make_unexpected(built.error());
  return std::move(*built);
}

}  // namespace

Result<Found> find(const SimilarityPrepared& prepared, const Wanted& wanted,
                   const Context& context) {
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled before solving");
  auto start = start_of(prepared, wanted, context);
  if (!start) return tl::make_unexpected(start.error());
  const Units& units = start->units;
  const std::vector<double>& given = start->given;
  Found found;
  found.reference = std::move(start->reference);
  found.scale = std::move(start->scale);
  found.values = found.reference;
  wanted.elimination.meet(context, wanted.width, given, found.values);

  const SimilarityOptions& options = prepared.options;
  const bool directions = options.similarity == Similarity::directions && wanted.positions;
  std::unique_ptr<PatchEnergy> own;
  if (directions && options.max_iterations > 0) {
    own = cross_products(*prepared.layout, found.reference, options.row_weights, context);
    if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while solving");
  }
  FreeSystem system{wanted.elimination, own ? *own : *prepared.scalar, wanted.width, context};
  auto constraints = constraints_of(wanted, system, given, units);
  if (!constraints) return tl::make_unexpected(constraints.error());
  if (*constraints) {
    system.constraints = &**constraints;
    system.constraints->meet(context, found.values);
    found.fates = system.constraints->fates();
  }
  if (options.max_iterations > 0) {
    found.outcome = minimise(prepared, system, found.reference, given, found.values);
  }
  if (found.outcome.cancelled) return fail(ErrorCode::cancelled, "cancelled while solving");
  // Of the steps. What leaving the units rounds is left: correcting it where the given points are
  // met to rounding alone would multiply it in equations that were dropped.
  if (*constraints) system.constraints->meet(context, found.values);
  units.leave(context, found.values);
  leave_reference(prepared, wanted, units, context, found.reference);
  // Once more from the given numbers themselves: exact to the last rounding.
  wanted.elimination.meet(context, wanted.width, wanted.given, found.values);
  return found;
}

Result<std::vector<double>> reference_of(const SimilarityPrepared& prepared, const Wanted& wanted,
                                         const Context& context) {
  auto start = start_of(prepared, wanted, context);
  if (!start) return tl::make_unexpected(start.error());
  leave_reference(prepared, wanted, start->units, context, start->reference);
  return std::move(start->reference);
}

}  // namespace surpass
