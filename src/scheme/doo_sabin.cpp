#include "scheme/doo_sabin.hpp"

namespace surpass::doo_sabin {
namespace {

class DooSabin final : public SubdivisionScheme {
 public:
  const char* name() const override { return "doo-sabin"; }
  const char* title() const override { return "Doo-Sabin"; }
  bool has_boundary_rule(Boundary boundary) const override {
    return boundary == Boundary::edge_only || boundary == Boundary::edge_and_corner;
  }

  Result<LimitOperator> limit_operator(const Mesh& mesh, const Topology& topology,
                                       const Rules& rules, const Context& context) const override {
    return doo_sabin::limit_operator(mesh, topology, rules, context);
  }
  Result<Refinement> refinement(const Mesh& mesh, const Topology& topology, const Rules& rules,
                                const Context& context) const override {
    return doo_sabin::refinement(mesh, topology, rules, context);
  }
  Result<std::vector<Point>> limit_normals(const Mesh& mesh, const Topology&, const Rules& rules,
                                           const Context& context) const override {
    return doo_sabin::limit_normals(mesh, rules, context);
  }
  Result<Mesh> limit_mesh(const Mesh& control, const Rules& rules, int levels,
                          const Context& context) const override {
    // The given mesh itself can be moved; below that, the given vertices have no successors.
    if (levels <= 0) return SubdivisionScheme::limit_mesh(control, rules, levels, context);
    return dual_limit_mesh(control, rules, levels, context);
  }
};

}  // namespace

const SubdivisionScheme& scheme() {
  static const DooSabin doo_sabin;
  return doo_sabin;
}

}  // namespace surpass::doo_sabin
