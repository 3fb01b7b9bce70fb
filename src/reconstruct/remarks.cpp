#include "reconstruct/remarks.hpp"

#include <surpass/topology.hpp>

#include <fmt/format.h>

namespace surpass::reconstruction {
namespace {
constexpr double kSheetsMayJoin = 1.5;  // spacings
constexpr double kManyUnused = 0.005;
}  // namespace

void count_parts(const Mesh& mesh, ReconstructReport& report) {
  report.creases = mesh.creases.size();
  report.corners = mesh.corners.size();
  const auto topology = Topology::build(mesh);
  if (!topology) return;
  report.pieces = find_components(*topology).count;
  report.open_loops = boundary_loops(*topology).size();
  for (Index v = 0; v < mesh.vertex_count(); ++v) {
    if (topology->is_bowtie(v)) return;
  }
  const auto count = [](std::size_t n) { return static_cast<std::int64_t>(n); };
  const std::int64_t euler =
      count(mesh.vertex_count()) - count(topology->edge_count()) + count(mesh.face_count());
  const std::int64_t handles = (2 * count(report.pieces) - count(report.open_loops) - euler) / 2;
  report.genus = static_cast<std::size_t>(handles);
}

void add_warnings(double share_of_sheets, std::optional<Index> wanted, Index vertices,
                  ReconstructReport& report) {
  std::vector<std::string>& warnings = report.warnings;
  const ReconstructReport& r = report;
  if (r.sheet_gap && share_of_sheets > 0.02 && *r.sheet_gap < kSheetsMayJoin) {
    warnings.push_back(fmt::format(
        "parts of the surface seem to lie {:.2f} spacings apart ({:.0f} % of the points are near a "
        "second sheet); below 1.5 they may be joined, so look at the mesh, or sample more densely",
        *r.sheet_gap, 100 * share_of_sheets));
  }
  if (r.noise.value_or(0) > kMuchNoise) {
    warnings.push_back(fmt::format(
        "the points scatter by {:.2f} spacings about the surface, more than 0.3: fine detail is "
        "lost, and handles or holes may be wrong",
        *r.noise));
  }
  const double share =
      static_cast<double>(r.unused) / static_cast<double>(r.points - r.not_finite - r.duplicates);
  if (share > kManyUnused) {
    warnings.push_back(
        fmt::format("{} not used by the mesh ({:.1f} % of all), of them {} as outliers",
                    r.unused == 1 ? "1 point is" : fmt::format("{} points are", r.unused),
                    100 * share, r.outliers));
  }
  if (wanted && vertices > *wanted) {
    warnings.push_back(
        fmt::format("{} vertices are left, more than the {} asked for: further "
                    "collapses would spoil the mesh or exceed the tolerance",
                    vertices, *wanted));
  }
}

}  // namespace surpass::reconstruction
