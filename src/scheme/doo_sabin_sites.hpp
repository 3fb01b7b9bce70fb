// The limit point and the normal at a site of a refined mesh.
#pragma once

#include "scheme/doo_sabin_step.hpp"

namespace surpass::doo_sabin {

/// Calls add(vertex, weight); a vertex may come several times.
template <class Add>
void add_site_limit(const Layout& layout, Weights family, const Site& site, Add&& add) {
  const Topology& topology = layout.topology();
  if (site.kind == Site::Kind::vertex) return add(site.at, 1.0);
  if (site.kind == Site::Kind::face) {
    const double share = 1.0 / topology.face_degree(site.at);
    for (Index h = topology.face_begin(site.at); h < topology.face_end(site.at); ++h) {
      add(topology.tail(h), share);
    }
    return;
  }
  if (layout.is_curve(topology.edge(site.at))) {
    add(topology.tail(site.at), 1.0 / 2);
    add(topology.head(site.at), 1.0 / 2);
    return;
  }
  for (const Index h : {site.at, topology.opposite(site.at)}) {
    const Index begin = topology.face_begin(topology.face(h));
    add_edge_limit(family, topology.face_degree(topology.face(h)), h - begin,
                   [&](Index k, double w) { add(topology.tail(begin + k), w); });
  }
}

/// Unit normals of the limit surface at sites; zero where there is none. On creases and at kept
/// vertices the normalised mean over the sides.
[[nodiscard]] std::vector<Point> site_normals(const Level& level, const std::vector<Site>& sites,
                                              Weights family, const Context& context);

}  // namespace surpass::doo_sabin
