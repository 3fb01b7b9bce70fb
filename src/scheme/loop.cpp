#include "scheme/loop.hpp"

namespace surpass::loop {
namespace {

class Loop final : public SubdivisionScheme {
 public:
  const char* name() const override { return "loop"; }
  const char* title() const override { return "Loop"; }
  Index face_size() const override { return 3; }
  bool has_boundary_rule(Boundary) const override { return true; }

  Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                       const Rules& rules, const Context& context) const override {
    return loop::limit_operator(mesh, topology, rules.boundary, context);
  }
  Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                const Context& context) const override {
    return loop::refinement(mesh, topology, rules.boundary, context);
  }
  Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology& topology,
                                           const Rules& rules,
                                           const Context& context) const override {
    return loop::limit_normals(mesh, topology, rules.boundary, context);
  }
};

}  // namespace

const SubdivisionScheme& scheme() {
  static const Loop loop;
  return loop;
}

}  // namespace surpass::loop
