#include <surpass/fairness.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include <fmt/format.h>

namespace surpass {
namespace {

constexpr int kGrid = 25;
constexpr int kSections = 6;
constexpr std::size_t kMostPlaces = 3;

/// Enough refinements to see where the energy is low, few enough for some thirty measurements.
int first_levels(const Mesh& control, int finest) {
  constexpr double kMost = 5e5;
  int levels = std::min(3, finest);
  while (levels > 1 && std::ldexp(static_cast<double>(control.face_count()), 2 * levels) > kMost) {
    --levels;
  }
  return levels;
}

class ShapeSearch {
 public:
  ShapeSearch(const Mesh& control, const NonstationaryOptions& scheme,
              const FairnessOptions& options, const Context& context)
      : control_(control), scheme_(scheme), context_(context) {
    best_.measure = options;
    if (options.levels == 0) best_.measure.levels = fairness_levels(control);
  }

  Result<FairestShape> run(double low, double high) {
    best_.shape = std::clamp(scheme_.shape, low, high);
    if (auto ok = choose_measures(); !ok) return tl::make_unexpected(ok.error());
    best_.trimmed_bending = at(best_.shape, best_.measure);
    const double step = (high - low) / (kGrid - 1);
    for (const double shape : low_places(low, step)) consider(shape);
    descend(low, high, step);
    sections(std::max(low, best_.shape - step), std::min(high, best_.shape + step));
    if (failed_) return tl::make_unexpected(*failed_);
    return best_;
  }

 private:
  /// Rings such that something is left of the surface, and the levels of the grid.
  Result<void> choose_measures() {
    FairnessOptions& last = best_.measure;
    auto found = measured(best_.shape, last);
    while (!found && nothing_left(found.error()) && last.rings > 0) {
      --last.rings;
      found = measured(best_.shape, last);
    }
    if (!found) return found;
    grid_ = last;
    for (int levels = first_levels(control_, last.levels); levels < last.levels; ++levels) {
      // Rings are narrower after more levels; about the same part of the surface is left out.
      const double rings = std::ldexp(last.rings + 1, levels - last.levels) - 1;
      const FairnessOptions first{levels, std::max(0, static_cast<int>(std::lround(rings)))};
      found = measured(best_.shape, first);
      if (!found && !nothing_left(found.error())) return found;
      if (!found) continue;
      grid_ = first;
      break;
    }
    return {};
  }

  static bool nothing_left(const Error& error) {
    return error.code == ErrorCode::unsuitable_for_scheme;
  }

  /// The lowest of the grid's local minima.
  std::vector<double> low_places(double low, double step) {
    std::vector<double> energy;
    energy.reserve(kGrid);
    for (int i = 0; i < kGrid; ++i) energy.push_back(at(low + i * step, grid_));
    std::vector<std::size_t> places;
    for (std::size_t i = 0; i < energy.size(); ++i) {
      const bool falls_left = i > 0 && energy[i - 1] < energy[i];
      const bool falls_right = i + 1 < energy.size() && energy[i + 1] < energy[i];
      if (!falls_left && !falls_right) places.push_back(i);
    }
    std::stable_sort(places.begin(), places.end(),
                     [&](std::size_t a, std::size_t b) { return energy[a] < energy[b]; });
    places.resize(std::min(places.size(), kMostPlaces));
    std::vector<double> shapes;
    shapes.reserve(places.size());
    for (const std::size_t i : places) shapes.push_back(low + static_cast<double>(i) * step);
    return shapes;
  }

  /// Step by step to where both neighbours are higher: after more levels the lowest place may be
  /// another one than the grid's.
  void descend(double low, double high, double step) {
    for (int side = -1; side <= 1; side += 2) {
      double before = 0;
      do {
        before = best_.shape;
        consider(std::clamp(before + side * step, low, high));
      } while (best_.shape != before);
    }
  }

  void sections(double low, double high) {
    constexpr double kGolden = std::numbers::phi - 1;
    double inner[2] = {high - kGolden * (high - low), low + kGolden * (high - low)};
    double energy[2] = {consider(inner[0]), consider(inner[1])};
    for (int i = 2; i < kSections; ++i) {
      const int keep = energy[0] <= energy[1] ? 0 : 1;
      const int drop = 1 - keep;
      (keep == 0 ? high : low) = inner[drop];
      inner[drop] = inner[keep];
      energy[drop] = energy[keep];
      inner[keep] = keep == 0 ? high - kGolden * (high - low) : low + kGolden * (high - low);
      energy[keep] = consider(inner[keep]);
    }
  }

  /// Measures after the last levels, and keeps what is lower by more than rounding.
  double consider(double shape) {
    constexpr double kAlike = 1e-12;
    const double energy = at(shape, best_.measure);
    if (energy < best_.trimmed_bending - kAlike * (1 + energy)) {
      best_.shape = shape;
      best_.trimmed_bending = energy;
    }
    return energy;
  }

  /// 0 once something has failed.
  double at(double shape, const FairnessOptions& measure) {
    if (failed_) return 0;
    if (const auto ok = measured(shape, measure); !ok) {
      failed_ = ok.error();
      return 0;
    }
    return known_.at({shape, measure.levels});
  }

  Result<void> measured(double shape, const FairnessOptions& measure) {
    const std::pair key(shape, measure.levels);
    if (known_.contains(key)) return {};
    scheme_.shape = shape;
    const auto found = fairness(control_, scheme_, measure, context_);
    if (!found) return tl::make_unexpected(found.error());
    known_.emplace(key, found->trimmed_bending);
    return {};
  }

  const Mesh& control_;
  NonstationaryOptions scheme_;
  const Context& context_;
  FairestShape best_;
  FairnessOptions grid_;
  std::map<std::pair<double, int>, double> known_;  ///< by shape and levels
  std::optional<Error> failed_;
};

}  // namespace

Result<FairestShape> fairest_shape(const Mesh& control, const NonstationaryOptions& scheme,
                                   const FairnessOptions& options, const Context& context) {
  if (scheme.rule != NonstationaryRule::interpolating &&
      scheme.rule != NonstationaryRule::uniform) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the rule {} has no shape parameter to choose", name_of(scheme.rule)));
  }
  NonstationaryOptions limit = scheme;
  limit.steps = 0;
  // What is taken of shapes at both ends is the allowed range.
  NonstationaryOptions end = limit;
  double range[2] = {};
  for (int i = 0; i < 2; ++i) {
    end.shape = i == 0 ? kLowestShape : kHighestShape;
    for (const LineTarget& target : scheme.targets) {
      if (i == 0) end.shape = std::max(end.shape, 8 * target.along - 4 + 0.01);
    }
    const auto surface = NonstationaryLoop::create(control, end, context);
    if (!surface) return tl::make_unexpected(surface.error());
    range[i] = surface->shape();
  }
  return ShapeSearch(control, limit, options, context).run(range[0], range[1]);
}

}  // namespace surpass
