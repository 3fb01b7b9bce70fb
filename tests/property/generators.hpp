// rapidcheck generators of meshes and rules.
#pragma once

#include <rapidcheck.h>

#include "support/meshes.hpp"
#include "support/polygons.hpp"

namespace surpass::test {

inline Mesh any_mesh(bool creases) {
  RandomShape shape;
  shape.seed = *rc::gen::arbitrary<std::uint64_t>();
  shape.kind = *rc::gen::inRange(0, 5);
  shape.size = *rc::gen::inRange(4, 8);
  shape.creases = creases ? *rc::gen::element(0.0, 0.03, 0.1, 0.4) : 0.0;
  shape.semi_sharp = *rc::gen::arbitrary<bool>();
  return random_mesh(shape);
}

inline Rules any_rules() {
  return {Scheme::loop,
          *rc::gen::element(Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe)};
}

/// A mesh and rules that take it.
struct Case {
  Mesh mesh;
  Rules rules;
};

inline Case any_case(bool creases, Scheme scheme) {
  if (scheme == Scheme::loop) return {any_mesh(creases), any_rules()};
  RandomShape shape;
  shape.seed = *rc::gen::arbitrary<std::uint64_t>();
  shape.kind = *rc::gen::inRange(0, 5);
  shape.size = *rc::gen::inRange(4, 8);
  shape.creases = creases ? *rc::gen::element(0.0, 0.03, 0.1, 0.4) : 0.0;
  shape.semi_sharp = scheme != Scheme::doo_sabin && *rc::gen::arbitrary<bool>();
  return {random_mesh_for(scheme, shape),
          {scheme, *rc::gen::element(Boundary::edge_only, Boundary::edge_and_corner),
           *rc::gen::element(Weights::averaging, Weights::cosine)}};
}

inline Case any_case(bool creases) {
  return any_case(creases,
                  *rc::gen::element(Scheme::loop, Scheme::catmull_clark, Scheme::doo_sabin));
}

/// A random property with a fixed seed: the same cases in every run.
template <class Property>
void check(const std::string& name, int cases, Property&& property) {
  rc::detail::TestParams params;
  params.seed = 20240601;
  params.maxSuccess = cases;
  params.disableShrinking = true;
  rc::detail::TestMetadata metadata;
  metadata.id = name;
  metadata.description = name;
  const auto result = rc::detail::checkTestable(std::forward<Property>(property), metadata, params);
  if (!result.template is<rc::detail::SuccessResult>()) {
    std::ostringstream text;
    rc::detail::printResultMessage(result, text);
    ADD_FAILURE() << text.str();
  }
}

}  // namespace surpass::test
