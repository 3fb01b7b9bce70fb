// --html FILE: one page with the viewer, the meshes and the figures, that opens anywhere.
//
// The page's frame is made by `make web` (web/report.html); this puts the data into it. What is
// shown are positions of 16 bits and normals of 8, about the box of each mesh; the page says so.
#pragma once

#include <surpass/mesh.hpp>
#include <surpass/scheme.hpp>

#include <string>
#include <vector>

#include "options.hpp"
#include "session.hpp"

namespace surpass::cli {

/// How a mesh is drawn: smooth and shaded, as facets with edges, as edges alone, as points.
enum class LayerKind { surface, mesh, cage, points };

class HtmlReport {
 public:
  void define(Options& options);
  [[nodiscard]] bool wanted() const { return !path_.empty(); }
  void set_path(const std::string& path) { path_ = path; }

  /// Before the work: the page can be written where it shall be, and its frame is there. Does
  /// nothing if no page is wanted.
  [[nodiscard]] Result<void> prepare(Session& session, const std::vector<std::string>& inputs,
                                     const std::vector<std::string>& other_outputs);

  /// Adds something to look at. `id` is for the page: "given", "control", "plain" and "surface" are
  /// what the studio calls so too. Vertex channels "normal", "mean", "gauss", "error" and
  /// "distance" are shown.
  void add(const char* id, const std::string& label, LayerKind kind, const Mesh& mesh);

  /// How often a surface is refined that a page can hold.
  [[nodiscard]] static int shown_levels(const Mesh& control);

  /// Adds the limit surface of a control mesh, with its curvature, as fine as a page can hold.
  [[nodiscard]] Result<void> add_limit(const char* id, const std::string& label,
                                       const Mesh& control, const Rules& rules,
                                       const Context& context);

  /// Adds a mesh on the limit surface, with the curvature that its normals say.
  [[nodiscard]] Result<void> add_surface(const char* id, const std::string& label, Mesh surface,
                                         const Context& context);

  /// Marks these points on whatever is shown; `errors` (one a point, of the box side) colour them.
  void mark(std::span<const Point> points, std::span<const double> errors = {});

  /// Adds a curve to the plot of error against iteration.
  void plot(const std::string& name, const Json& history);

  /// Writes the page, with the session's report as it is by now.
  [[nodiscard]] Result<void> write(Session& session);

 private:
  std::string path_;
  std::string frame_;
  Json layers_ = Json::array();
  Json points_;
  Json curves_ = Json::array();
  Box box_;
  bool has_box_ = false;
};

}  // namespace surpass::cli
