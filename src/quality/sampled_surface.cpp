#include "quality/sampled_surface.hpp"

#include <cmath>

#include <fmt/format.h>

#include "mesh/wording.hpp"
#include "scheme/subdivision_scheme.hpp"

namespace surpass {
namespace {

Result<void> check(const Mesh& control, int levels, int rings) {
  constexpr int kMostLevels = 12;
  constexpr int kMostRings = 1000;
  if (levels < 1 || levels > kMostLevels) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("the number of levels is {}; fairness is measured after 1 to {}",
                            levels, kMostLevels));
  }
  if (rings < 0 || rings > kMostRings) {
    return fail(ErrorCode::invalid_argument,
                fmt::format("{} rings cannot be left out; 0 to {} can", rings, kMostRings));
  }
  if (control.face_count() == 0) {
    return fail(ErrorCode::empty_mesh, "the mesh has no faces, so there is no surface to measure");
  }
  const double corners = std::ldexp(static_cast<double>(control.corner_count()), 2 * levels);
  if (corners > static_cast<double>(kNone)) {
    return fail(ErrorCode::too_large,
                fmt::format("after {} the mesh would have {:.3g} face corners; take fewer",
                            counted(static_cast<std::size_t>(levels), "level", "levels"), corners));
  }
  return {};
}

// What refinement of the shape needs, in a box around the origin of a side between 1 and 4.
Result<Mesh> framed(const Mesh& control, SampledSurface& surface) {
  constexpr double kLargest = 1e150;
  const Box box = bounding_box(control.points);
  double half = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    surface.origin[c] = box.low[c] / 2 + box.high[c] / 2;
    half = std::max(half, box.high[c] / 2 - box.low[c] / 2);
  }
  if (half > 0 && (half > kLargest || half < 1 / kLargest)) {
    return fail(ErrorCode::too_large,
                fmt::format("half the largest side of the mesh is {:.3g}; areas of such a size are "
                            "no numbers of this machine, scale the mesh",
                            half));
  }
  surface.unit = half > 0 ? std::exp2(std::floor(std::log2(half))) : 1;
  Mesh mesh;
  mesh.points.reserve(control.points.size());
  for (const Point& p : control.points) {
    Point& q = mesh.points.emplace_back();
    for (std::size_t c = 0; c < 3; ++c) q[c] = (p[c] - surface.origin[c]) / surface.unit;
  }
  mesh.face_offsets = control.face_offsets;
  mesh.face_vertices = control.face_vertices;
  mesh.creases = control.creases;
  mesh.corners = control.corners;
  mesh.hole_faces = control.hole_faces;
  return mesh;
}

// Marks every sample of the faces that have a marked one, `rings` times.
void widen(const Mesh& mesh, int rings, std::vector<unsigned char>& marked) {
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<unsigned char> wider = marked;
    for (Index f = 0; f < mesh.face_count(); ++f) {
      const auto face = mesh.face(f);
      const bool touched =
          std::any_of(face.begin(), face.end(), [&](Index v) { return marked[v] != 0; });
      if (!touched) continue;
      for (const Index v : face) wider[v] = 1;
    }
    marked = std::move(wider);
  }
}

void find_curvature(SampledSurface& surface, int rings, const Context& context) {
  const LimitSamples& samples = surface.samples;
  const std::size_t n = samples.spots.size();
  std::vector<unsigned char> left_out(n, 0);
  for (std::size_t v = 0; v < n; ++v) left_out[v] = samples.spots[v] == Spot::extraordinary;
  widen(samples.mesh, rings, left_out);

  surface.curvature.resize(n);
  surface.usable.assign(n, 0);
  surface.degenerate_samples = parallel::reduce(
      context, n, std::size_t{0},
      [&](std::size_t begin, std::size_t end) {
        std::size_t degenerate = 0;
        for (std::size_t v = begin; v < end; ++v) {
          if (samples.spots[v] != Spot::regular) continue;
          const auto found = curvature_of(samples.jets[v]);
          if (!found) {
            ++degenerate;
            continue;
          }
          surface.curvature[v] = *found;
          surface.usable[v] = left_out[v] == 0;
        }
        return degenerate;
      },
      [](std::size_t a, std::size_t b) { return a + b; });
}

}  // namespace

Result<SampledSurface> sample_surface(const Mesh& control, int levels, int rings,
                                      const Context& context, const MakeSamples& make) {
  if (auto ok = check(control, levels, rings); !ok) return tl::make_unexpected(ok.error());
  SampledSurface surface;
  surface.levels = levels;
  const auto mesh = framed(control, surface);
  if (!mesh) return tl::make_unexpected(mesh.error());
  auto samples = make(*mesh);
  if (!samples) return tl::make_unexpected(samples.error());
  surface.samples = std::move(*samples);
  if (context.cancelled()) return fail(ErrorCode::cancelled, "cancelled while measuring");
  find_curvature(surface, rings, context);
  return surface;
}

Result<SampledSurface> sample_surface(const Mesh& control, const Rules& rules, int levels,
                                      int rings, const Context& context) {
  return sample_surface(control, levels, rings, context, [&](const Mesh& mesh) {
    return scheme_of(rules.scheme).limit_samples(mesh, rules, levels, context);
  });
}

Result<MeasuredPart> measured_part(const SampledSurface& surface,
                                   const std::vector<unsigned char>& usable, int rings,
                                   const Context& context) {
  const LimitSamples& samples = surface.samples;
  MeasuredPart part;
  part.measure.assign(samples.spots.size(), 0.0);
  double outside = 0;
  for (Index p = 0; p < samples.patch_count(); ++p) {
    const auto patch = samples.patch(p);
    if (!std::all_of(patch.begin(), patch.end(), [&](Index v) { return usable[v] != 0; })) {
      outside += samples.patch_areas[p];
      continue;
    }
    ++part.coverage.measured_patches;
    const double share = samples.patch_measure / static_cast<double>(patch.size());
    for (const Index v : patch) part.measure[v] += share;
  }
  part.coverage.patches = samples.patch_count();
  part.coverage.degenerate_samples = surface.degenerate_samples;
  if (part.coverage.measured_patches == 0) {
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("nothing of the surface is left to measure after {}: all of its {} "
                            "at a boundary or crease, or within {} of an extraordinary vertex; "
                            "take more levels or leave out fewer rings",
                            counted(static_cast<std::size_t>(surface.levels), "level", "levels"),
                            counted(samples.patch_count(), "patch is", "patches are"),
                            counted(static_cast<std::size_t>(rings), "ring", "rings")));
  }
  part.coverage.samples = static_cast<std::size_t>(
      std::count_if(part.measure.begin(), part.measure.end(), [](double m) { return m > 0; }));
  const double inside = integrate(surface, part, 0.0, context, [](Index) { return 1.0; });
  const double square = surface.unit * surface.unit;
  part.coverage.measured_area = inside * square;
  part.coverage.area = (inside + outside) * square;
  part.coverage.left_out = outside / (inside + outside);
  return part;
}

}  // namespace surpass
