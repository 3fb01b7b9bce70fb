#include "scheme/doo_sabin_layout.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "parallel/parallel.hpp"
#include "scheme/sharpness.hpp"

namespace surpass::doo_sabin {
namespace {

constexpr const char* kAdvice =
    "Doo-Sabin surfaces have no semi-sharp rules; make it smooth (0) or infinitely sharp (10)";

Result<void> refuse_semi_sharp(const Topology& topology, const Sharpness& sharpness) {
  for (Index e = 0; e < topology.edge_count(); ++e) {
    const float s = sharpness.edge(topology, e);
    if (!is_semi_sharp(s)) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("an edge has sharpness {}; {}", s, kAdvice),
                {.edge = topology.edge_vertices(e)});
  }
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    const float s = sharpness.vertex(v);
    if (!is_semi_sharp(s)) continue;
    return fail(ErrorCode::unsuitable_for_scheme,
                fmt::format("a vertex has sharpness {}; {}", s, kAdvice), {.vertex = v});
  }
  return {};
}

VertexKind kind_of(const Topology& topology, const Sharpness& sharpness, Index v) {
  if (topology.is_isolated(v) || is_infinite(sharpness.vertex(v))) return VertexKind::kept;
  Index spokes = 0;
  Index curves = 0;
  topology.for_each_spoke(v, [&](Index, Index e) {
    ++spokes;
    if (is_infinite(sharpness.edge(topology, e))) ++curves;
  });
  switch (curves) {
    case 0: return spokes == 2 ? VertexKind::doublet : VertexKind::smooth;
    case 1: return VertexKind::dart;
    case 2: return VertexKind::curve;
    default: return VertexKind::kept;
  }
}

}  // namespace

Result<Layout> Layout::build(const Mesh& mesh, const Topology& topology, Boundary boundary,
                             const Context& context) {
  const auto sharpness = Sharpness::build(mesh, topology, boundary);
  if (!sharpness) return tl::make_unexpected(sharpness.error());
  if (auto ok = refuse_semi_sharp(topology, *sharpness); !ok) {
    return tl::make_unexpected(ok.error());
  }
  Layout layout;
  layout.topology_ = &topology;
  for (Index e = 0; e < topology.edge_count(); ++e) {
    if (is_infinite(sharpness->edge(topology, e))) layout.curve_edges_.push_back(e);
  }
  if (!layout.curve_edges_.empty()) layout.curve_rank_.assign(topology.edge_count(), kNone);
  for (Index i = 0; i < layout.curve_edges_.size(); ++i) {
    layout.curve_rank_[layout.curve_edges_[i]] = i;
  }
  layout.kinds_.resize(topology.vertex_count());
  parallel::for_ranges(context, layout.kinds_.size(), [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      layout.kinds_[v] = kind_of(topology, *sharpness, static_cast<Index>(v));
    }
  });
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (layout.kinds_[v] == VertexKind::kept) layout.kept_vertices_.push_back(v);
  }
  return layout;
}

bool Layout::is_lens(Index h) const {
  const Topology& t = *topology_;
  if (kept_vertices_.empty() || kinds_[t.tail(h)] != VertexKind::kept) return false;
  const Index other = t.rotate(h);
  return other != kNone && t.rotate(other) == h && !is_curve(t.edge(h)) && !is_curve(t.edge(other));
}

Index Layout::kept_rank(Index v) const {
  const auto at = std::lower_bound(kept_vertices_.begin(), kept_vertices_.end(), v);
  return static_cast<Index>(at - kept_vertices_.begin());
}

}  // namespace surpass::doo_sabin
