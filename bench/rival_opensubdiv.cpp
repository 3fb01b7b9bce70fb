// OpenSubdiv's Far: its topology refiner, its limit rules applied one vertex after the other, and
// its limit stencils, which are prepared for repeated use as our operator is.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include "contenders.hpp"
#include "judges.hpp"
#include "opensubdiv_input.hpp"

namespace surpass::bench {
namespace {

using namespace osd;
using StencilFactory = Far::LimitStencilTableFactoryReal<double>;
using Stencils = std::shared_ptr<const Far::LimitStencilTableReal<double>>;

Vertices limits_of(const Far::TopologyRefiner& refiner, const Vertices& vertices) {
  Vertices limits(vertices.size());
  Far::PrimvarRefinerReal<double>(refiner).Limit(vertices, limits);
  return limits;
}

// Stencils of the limit at every vertex, each in one of the vertex's faces.
Stencils stencils_of(const Input& input) {
  const auto refiner = refiner_of(input);
  refiner->RefineAdaptive(Far::TopologyRefiner::AdaptiveOptions(1));
  static constexpr double kS[] = {0, 1, 0};
  static constexpr double kT[] = {0, 0, 1};
  std::vector<int> corner_at(input.vertices.size());
  for (std::size_t h = 0; h < input.corners.size(); ++h) {
    corner_at[static_cast<std::size_t>(input.corners[h])] = static_cast<int>(h);
  }
  StencilFactory::LocationArrayVec places(corner_at.size());
  for (std::size_t v = 0; v < places.size(); ++v) {
    places[v].ptexIdx = corner_at[v] / 3;
    places[v].numLocations = 1;
    places[v].s = kS + corner_at[v] % 3;
    places[v].t = kT + corner_at[v] % 3;
  }
  StencilFactory::Options options;
  options.generate1stDerivatives = false;
  options.generate2ndDerivatives = false;
  return Stencils(StencilFactory::Create(*refiner, places, nullptr, nullptr, options));
}

std::vector<Index> valences_of(const Far::TopologyRefiner& refiner) {
  const Far::TopologyLevel level = refiner.GetLevel(0);
  std::vector<Index> valences;
  for (int v = 0; v < level.GetNumVertices(); ++v) {
    valences.push_back(static_cast<Index>(level.GetVertexEdges(v).size()));
  }
  return valences;
}

Verdict judge(const Workload& workload, const Vertices& limits) {
  std::vector<Point> points;
  for (const Vertex& vertex : limits) points.push_back(vertex.position);
  return judge_limits(workload, points);
}

void add_sweep(Harness& harness, Index side) {
  harness.add(
      {.step = "sweep", .tool = "OpenSubdiv", .counted = "PrimvarRefiner::Limit given the refiner"},
      side,
      [](const Workload& w) {
        return [in = input_of(w.mesh()), refiner = refiner_of(input_of(w.mesh()))] {
          return limits_of(*refiner, in.vertices);
        };
      },
      judge);
}

void add_stencils(Harness& harness, Index side) {
  harness.add(
      {.step = "sweep",
       .tool = "OpenSubdiv stencils",
       .counted = "LimitStencilTable::UpdateValues given the table"},
      side,
      [](const Workload& w) {
        return [in = input_of(w.mesh()), stencils = stencils_of(input_of(w.mesh()))] {
          Vertices limits(in.vertices.size());
          stencils->UpdateValues(in.vertices, limits);
          return limits;
        };
      },
      judge);
}

}  // namespace

void add_opensubdiv(Harness& harness, Index side) {
  harness.add(
      {.step = "topology",
       .tool = "OpenSubdiv",
       .counted = "TopologyRefinerFactory::Create from face arrays, without its full "
                  "validation",
       .slow = true},
      side, [](const Workload& w) { return [in = input_of(w.mesh())] { return refiner_of(in); }; },
      [](const Workload& w, const auto& refiner) {
        return judge_valences(w, valences_of(*refiner));
      });
  harness.add(
      {.step = "limit points from faces",
       .tool = "OpenSubdiv",
       .counted = "TopologyRefinerFactory::Create and PrimvarRefiner::Limit",
       .slow = true},
      side,
      [](const Workload& w) {
        return [in = input_of(w.mesh())] { return limits_of(*refiner_of(in), in.vertices); };
      },
      judge);
  add_sweep(harness, side);
  constexpr Index kLargestStencils = 500;  // making those of a million vertices took over 10 GB
  if (side <= kLargestStencils) add_stencils(harness, side);
}

}  // namespace surpass::bench
