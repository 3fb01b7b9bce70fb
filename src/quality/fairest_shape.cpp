#include <surpass/fairness.hpp>

#include <cmath>
#include <numbers>

#include <fmt/format.h>

namespace surpass {
namespace {

constexpr int kCoarse = 9;
constexpr int kSections = 12;

/// Enough refinements to see the surface, few enough for some twenty measurements.
int search_levels(const Mesh& control) {
  constexpr double kMost = 2e6;
  int levels = 3;
  while (levels > 1 && std::ldexp(static_cast<double>(control.face_count()), 2 * levels) > kMost) {
    --levels;
  }
  return levels;
}

class ShapeSearch {
 public:
  ShapeSearch(const Mesh& control, const NonstationaryOptions& scheme, const Context& context)
      : control_(control), scheme_(scheme), context_(context) {
    measure_.levels = search_levels(control);
    measure_.rings = measure_.levels > 2 ? 1 : 0;
  }

  Result<FairestShape> run(double low, double high) {
    const double step = (high - low) / (kCoarse - 1);
    for (int i = 0; i < kCoarse; ++i) {
      if (auto ok = bending(low + i * step); !ok) return tl::make_unexpected(ok.error());
    }
    const double middle = best_.shape;
    return sections(std::max(low, middle - step), std::min(high, middle + step));
  }

 private:
  Result<FairestShape> sections(double low, double high) {
    constexpr double kGolden = std::numbers::phi - 1;
    double inner[2] = {high - kGolden * (high - low), low + kGolden * (high - low)};
    double value[2] = {};
    for (int i = 0; i < 2; ++i) {
      const auto found = bending(inner[i]);
      if (!found) return tl::make_unexpected(found.error());
      value[i] = *found;
    }
    for (int i = 2; i < kSections; ++i) {
      const bool left = value[0] <= value[1];
      (left ? high : low) = inner[left ? 1 : 0];
      inner[left ? 1 : 0] = inner[left ? 0 : 1];
      value[left ? 1 : 0] = value[left ? 0 : 1];
      double& next = inner[left ? 0 : 1];
      next = left ? high - kGolden * (high - low) : low + kGolden * (high - low);
      const auto found = bending(next);
      if (!found) return tl::make_unexpected(found.error());
      value[left ? 0 : 1] = *found;
    }
    return best_;
  }

  /// Measures, and keeps the best.
  Result<double> bending(double shape) {
    scheme_.shape = shape;
    const auto found = fairness(control_, scheme_, measure_, context_);
    if (!found) return tl::make_unexpected(found.error());
    if (best_.levels == 0 || found->bending < best_.bending) {
      best_ = {shape, found->bending, measure_.levels};
    }
    return found->bending;
  }

  const Mesh& control_;
  NonstationaryOptions scheme_;
  const Context& context_;
  FairnessOptions measure_;
  FairestShape best_;
};

}  // namespace

Result<FairestShape> fairest_shape(const Mesh& control, const NonstationaryOptions& scheme,
                                   const Context& context) {
  if (scheme.rule != NonstationaryRule::interpolating &&
      scheme.rule != NonstationaryRule::uniform) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the rule {} has no shape parameter to choose", name_of(scheme.rule)));
  }
  // What is taken of shapes at both ends is the allowed range.
  NonstationaryOptions end = scheme;
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
  return ShapeSearch(control, scheme, context).run(range[0], range[1]);
}

}  // namespace surpass
