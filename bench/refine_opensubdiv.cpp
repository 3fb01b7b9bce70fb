// OpenSubdiv's refinement: everything from faces, and its stencils, which are prepared once.
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>

#include "opensubdiv_input.hpp"
#include "refinement.hpp"

namespace surpass::bench {
namespace {

using namespace osd;

// What a refinement leaves: the topology and the points of its last level.
struct Refined {
  std::shared_ptr<const Far::TopologyRefiner> refiner;
  Vertices vertices;
};

std::shared_ptr<Far::TopologyRefiner> refined_topology(const Input& input, Scheme scheme) {
  auto refiner = refiner_of(input, scheme);
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(1));
  return refiner;
}

Refined refined(const Input& input, Scheme scheme) {
  const auto refiner = refined_topology(input, scheme);
  Vertices vertices(static_cast<std::size_t>(refiner->GetLevel(1).GetNumVertices()));
  Far::PrimvarRefinerReal<double>(*refiner).Interpolate(1, input.vertices, vertices);
  return {refiner, std::move(vertices)};
}

// Its faces with the given vertices first; OpenSubdiv has them after those of faces and edges.
RefinedFaces faces_of(const Far::TopologyRefiner& refiner, const Vertices& vertices) {
  const Far::TopologyLevel parents = refiner.GetLevel(0);
  const Far::TopologyLevel children = refiner.GetLevel(1);
  std::vector<Index> number(vertices.size(), kNone);
  Index next = 0;
  for (int v = 0; v < parents.GetNumVertices(); ++v) {
    number[static_cast<std::size_t>(parents.GetVertexChildVertex(v))] = next++;
  }
  for (Index& n : number) {
    if (n == kNone) n = next++;
  }
  RefinedFaces faces{.points = std::vector<Point>(vertices.size())};
  for (std::size_t v = 0; v < vertices.size(); ++v) faces.points[number[v]] = vertices[v].position;
  for (int f = 0; f < children.GetNumFaces(); ++f) {
    const auto corners = children.GetFaceVertices(f);
    faces.size = static_cast<Index>(corners.size());
    for (int k = 0; k < corners.size(); ++k) {
      faces.corners.push_back(number[static_cast<std::size_t>(corners[k])]);
    }
  }
  return faces;
}

// A stencil table for level 1 and room for what it makes.
struct Prepared {
  using Factory = Far::StencilTableFactoryReal<double>;
  Input input;
  std::shared_ptr<const Far::TopologyRefiner> refiner;
  std::unique_ptr<const Far::StencilTableReal<double>> table;
  Vertices vertices;
};

std::shared_ptr<Prepared> prepare(const Mesh& mesh, Scheme scheme) {
  auto kept = std::make_shared<Prepared>();
  kept->input = input_of(mesh);
  kept->refiner = refined_topology(kept->input, scheme);
  Prepared::Factory::Options options;
  options.generateOffsets = true;
  kept->table.reset(Prepared::Factory::Create(*kept->refiner, options));
  kept->vertices.resize(static_cast<std::size_t>(kept->table->GetNumStencils()));
  return kept;
}

}  // namespace

void add_opensubdiv_refinement(Harness& harness, Index side) {
  for (const Scheme scheme : {Scheme::loop, Scheme::catmull_clark}) {
    harness.add(
        {.step = step_name("refine", scheme),
         .tool = "OpenSubdiv",
         .counted = "TopologyRefinerFactory::Create, RefineUniform, Interpolate",
         .slow = true},
        side,
        [scheme](const Workload& w) {
          return [in = input_of(given(w, scheme)), scheme] { return refined(in, scheme); };
        },
        [scheme](const Workload& w, const Refined& result) {
          return judge_refined(w, scheme, faces_of(*result.refiner, result.vertices),
                               Agreement::doubles);
        });
    harness.add(
        {.step = step_name("refine again", scheme),
         .tool = "OpenSubdiv stencils",
         .counted = "StencilTable::UpdateValues given the table, into kept memory"},
        side,
        [scheme](const Workload& w) {
          return [kept = prepare(given(w, scheme), scheme)] {
            kept->table->UpdateValues(kept->input.vertices, kept->vertices);
            return kept;
          };
        },
        [scheme](const Workload& w, const std::shared_ptr<Prepared>& kept) {
          return judge_refined(w, scheme, faces_of(*kept->refiner, kept->vertices),
                               Agreement::doubles);
        });
  }
}

}  // namespace surpass::bench
