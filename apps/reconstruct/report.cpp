#include "report.hpp"

#include <fmt/format.h>

namespace surpass::cli {

namespace {

Json distances_json(const PointDistances& d, double side) {
  return {{"max", d.max / side}, {"mean", d.mean / side},
          {"rms", d.rms / side}, {"percentile99", d.percentile99 / side},
          {"points", d.count},   {"farthest", d.farthest}};
}

std::string counted(std::size_t n, const char* one, const char* many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace

Json reconstruction_json(const ReconstructReport& r) {
  Json json = {{"points", r.points},     {"not_finite", r.not_finite}, {"duplicates", r.duplicates},
               {"outliers", r.outliers}, {"unused", r.unused},         {"spacing", r.spacing}};
  if (r.noise) json["noise"] = *r.noise;
  if (r.sheet_gap) json["sheet_gap"] = *r.sheet_gap;
  json["smoothing_passes"] = r.smoothing_passes;
  json["smoothed_positions"] = r.smoothed_positions;
  json["perimeter"] = r.perimeter;
  json["dropped_pieces"] = r.dropped_pieces;
  json["filled_loops"] = r.filled_loops;
  json["open_loops"] = r.open_loops;
  json["pieces"] = r.pieces;
  if (r.genus) json["genus"] = *r.genus;
  json["full_vertices"] = r.full_vertices;
  json["creases"] = r.creases;
  json["corners"] = r.corners;
  json["polyhedron"] = {{"max", r.polyhedron_max}, {"rms", r.polyhedron_rms}};
  return json;
}

Json limit_distances_json(const LimitDistances& distances, double box_side) {
  const double side = box_side > 0 ? box_side : 1;
  Json json = {{"all", distances_json(distances.all, side)},
               {"used", distances_json(distances.used, side)},
               {"levels", distances.levels}};
  if (distances.sampling) json["sampling"] = *distances.sampling / side;
  return json;
}

std::string summary(const ReconstructReport& r, const Mesh& mesh) {
  std::string text =
      fmt::format("{}: {} not finite, {}, {}, {} unused\n", counted(r.points, "point", "points"),
                  r.not_finite, counted(r.duplicates, "duplicate", "duplicates"),
                  counted(r.outliers, "outlier", "outliers"), r.unused);
  text += fmt::format(
      "spacing {:.3g} of the box side{}{}\n", r.spacing,
      r.noise ? fmt::format(", noise {:.2g} spacings", *r.noise) : "",
      r.smoothing_passes == 0
          ? ", not smoothed"
          : fmt::format(", smoothed in {}{}", counted(r.smoothing_passes, "pass", "passes"),
                        r.smoothed_positions ? "" : " to find the faces only"));
  text += fmt::format(
      "mesh: {} vertices{}, {} faces, {}, {}{}{}", mesh.vertex_count(),
      r.full_vertices == mesh.vertex_count() ? "" : fmt::format(" of {}", r.full_vertices),
      mesh.face_count(), counted(r.pieces, "piece", "pieces"),
      r.open_loops == 0 ? "closed" : counted(r.open_loops, "boundary loop", "boundary loops"),
      r.genus ? fmt::format(", genus {}", *r.genus) : "",
      r.filled_loops == 0 ? ""
                          : fmt::format(", {} filled", counted(r.filled_loops, "hole", "holes")));
  if (r.creases > 0) {
    text += fmt::format(", {}, {}", counted(r.creases, "crease edge", "crease edges"),
                        counted(r.corners, "corner", "corners"));
  }
  if (r.polyhedron_max > 0) {
    text += fmt::format("\npoints to the mesh: max {:.3g}, rms {:.3g} of the box side",
                        r.polyhedron_max, r.polyhedron_rms);
  }
  return text;
}

std::string summary(const LimitDistances& distances, double box_side) {
  const double side = box_side > 0 ? box_side : 1;
  const auto line = [side](const char* which, const PointDistances& d) {
    return fmt::format(
        "{} points to the limit surface: max {:.3g}, mean {:.3g}, 99 % below {:.3g} "
        "of the box side",
        which, d.max / side, d.mean / side, d.percentile99 / side);
  };
  std::string text = line("all", distances.all);
  if (distances.used.count < distances.all.count) text += "\n" + line("used", distances.used);
  if (distances.sampling) {
    text += fmt::format("\n(the surface was sampled to about {:.1g} of the box side)",
                        *distances.sampling / side);
  }
  return text;
}

}  // namespace surpass::cli
