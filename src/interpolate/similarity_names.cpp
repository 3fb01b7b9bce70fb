#include <surpass/similarity.hpp>

#include <array>

#include <fmt/format.h>

#include "mesh/wording.hpp"

namespace surpass {
namespace {

template <class Choice, std::size_t kCount>
Result<Choice> named(std::string_view name, const std::array<Choice, kCount>& choices,
                     const char* what) {
  std::vector<std::string> known;
  for (const Choice choice : choices) {
    if (name == name_of(choice)) return choice;
    known.emplace_back(name_of(choice));
  }
  return fail(ErrorCode::invalid_argument,
              fmt::format("there is no {} \"{}\"; there are {}", what, name, joined(known, ", ")));
}

}  // namespace

const char* name_of(Similarity similarity) {
  switch (similarity) {
    case Similarity::vectors: return "vectors";
    case Similarity::directions: return "directions";
    case Similarity::fair: return "fair";
  }
  return "unknown";
}

const char* name_of(RowWeights weights) {
  switch (weights) {
    case RowWeights::none: return "none";
    case RowWeights::unit: return "unit";
    case RowWeights::order: return "order";
    case RowWeights::regularised: return "regularised";
  }
  return "unknown";
}

const char* name_of(Scaling scaling) {
  switch (scaling) {
    case Scaling::none: return "none";
    case Scaling::per_axis: return "per-axis";
    case Scaling::isotropic: return "isotropic";
  }
  return "unknown";
}

const char* name_of(OpenMeshes open) {
  switch (open) {
    case OpenMeshes::boundary_rules: return "boundary-rules";
    case OpenMeshes::dummy_ring: return "dummy-ring";
  }
  return "unknown";
}

const char* name_of(SimilaritySolver solver) {
  switch (solver) {
    case SimilaritySolver::conjugate_gradient: return "conjugate-gradient";
    case SimilaritySolver::gauss_seidel: return "gauss-seidel";
  }
  return "unknown";
}

Result<Similarity> similarity_named(std::string_view name) {
  return named(name, std::array{Similarity::vectors, Similarity::directions, Similarity::fair},
               "similarity");
}

Result<RowWeights> row_weights_named(std::string_view name) {
  return named(
      name,
      std::array{RowWeights::none, RowWeights::unit, RowWeights::order, RowWeights::regularised},
      "weight of rows");
}

Result<Scaling> scaling_named(std::string_view name) {
  return named(name, std::array{Scaling::none, Scaling::per_axis, Scaling::isotropic}, "scaling");
}

Result<OpenMeshes> open_meshes_named(std::string_view name) {
  return named(name, std::array{OpenMeshes::boundary_rules, OpenMeshes::dummy_ring},
               "treatment of open meshes");
}

Result<SimilaritySolver> similarity_solver_named(std::string_view name) {
  return named(name,
               std::array{SimilaritySolver::conjugate_gradient, SimilaritySolver::gauss_seidel},
               "solver for this method");
}

}  // namespace surpass
