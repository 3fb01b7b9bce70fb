// What an outside program sees: the installed headers, the installed libraries, and right numbers.
// The octahedron's limit mask keeps 24/55 of a vertex, and its neighbours cancel out: interpolation
// has to scale it by 55/24.
#include <surpass/surpass.hpp>
#ifdef SURPASS_ORACLE
#include <surpass/oracle.hpp>
#endif
#ifdef SURPASS_RENDER
#include <surpass/render.hpp>
#endif
#ifdef SURPASS_RECONSTRUCT
#include <surpass/reconstruct.hpp>
#endif

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace {

surpass::Mesh octahedron() {
  surpass::Mesh mesh;
  mesh.points = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  constexpr std::array<std::array<surpass::Index, 3>, 8> kFaces = {
      {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
  for (const auto& face : kFaces) mesh.add_face(face);
  return mesh;
}

void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "consumer: %s\n", what);
  std::exit(1);
}

}  // namespace

int main() {
  const surpass::Mesh given = octahedron();
  surpass::InterpolateOptions options;
  options.tolerance = 1e-14;
  const auto result = surpass::interpolate(given, options);
  require(result.has_value() && result->report.converged, "the octahedron was not interpolated");
  for (std::size_t v = 0; v < given.points.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double expected = 55.0 / 24.0 * given.points[v][k];
      require(std::abs(result->control.points[v][k] - expected) < 1e-13,
              "a control point is not 55/24 of the given point");
    }
  }
#ifdef SURPASS_ORACLE
  const auto certificate =
      surpass::certify_with_opensubdiv(result->control, given.points, options.rules);
  require(certificate.has_value() && certificate->max < 1e-13, "OpenSubdiv disagrees");
#endif
#ifdef SURPASS_RENDER
  surpass::RenderOptions small;
  small.width = small.height = 32;
  const auto image = surpass::render(given, small);
  require(image.has_value() && image->pixels.size() == 32 * 32 * 3, "no picture was drawn");
#endif
#ifdef SURPASS_RECONSTRUCT
  const auto found = surpass::reconstruct(given.points);
  require(found.has_value() && found->mesh.face_count() == 8, "six points are no octahedron");
#endif
  std::printf("Surpass %s: every control point is 55/24 of its vertex\n", surpass::kVersion);
  return 0;
}
