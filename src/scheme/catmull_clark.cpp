#include "scheme/catmull_clark.hpp"

namespace surpass::catmull_clark {
namespace {

class CatmullClark final : public SubdivisionScheme {
 public:
  const char* name() const override { return "catmull-clark"; }
  const char* title() const override { return "Catmull-Clark"; }
  bool has_boundary_rule(Boundary boundary) const override {
    return boundary == Boundary::edge_only || boundary == Boundary::edge_and_corner;
  }

  Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                       const Rules& rules, const Context& context) const override {
    return catmull_clark::limit_operator(mesh, topology, rules.boundary, context);
  }
  Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                const Context& context) const override {
    return catmull_clark::refinement(mesh, topology, rules.boundary, context);
  }
  Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                           const Rules& rules,
                                           const Context& context) const override {
    return catmull_clark::limit_normals(mesh, topology, rules.boundary, context);
  }
};

}  // namespace

const SubdivisionScheme& scheme() {
  static const CatmullClark catmull_clark;
  return catmull_clark;
}

}  // namespace surpass::catmull_clark
