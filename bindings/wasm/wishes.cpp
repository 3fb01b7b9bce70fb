#include "wishes.hpp"

namespace surpass::wasm {
namespace {

using emscripten::val;

constexpr char kItself[] = "nonstationary-loop";

// Keeps the first error; the rest of the object is then read for nothing.
class Reader {
 public:
  explicit Reader(const val& from) : from_(from) {}

  template <class Named, class Value>
  void name(const char* key, const Named& named, Value& target) {
    const val word = from_[key];
    if (!word.isString()) return;
    const auto text = word.as<std::string>();
    const Result<Value> value = named(std::string_view(text));
    if (value) {
      target = *value;
    } else if (!error_) {
      error_ = value.error();
    }
  }
  template <class Number>
  void number(const char* key, Number& target) {
    const val found = from_[key];
    if (found.isNumber()) target = found.as<Number>();
  }
  [[nodiscard]] const std::optional<Error>& error() const { return error_; }

 private:
  val from_;
  std::optional<Error> error_;
};

}  // namespace

Result<Wishes> read_wishes(const val& from) {
  Wishes wishes;
  Reader read(from);
  InterpolateOptions& progressive = wishes.progressive;
  const bool by_itself = from["scheme"].isString() && from["scheme"].as<std::string>() == kItself;
  if (by_itself) {
    progressive.rules.scheme = Scheme::loop;
  } else {
    read.name(
        "scheme", [](auto word) { return scheme_named(word); }, progressive.rules.scheme);
  }
  read.name(
      "boundary", [](auto word) { return boundary_named(word); }, progressive.rules.boundary);
  read.name(
      "weights", [](auto word) { return weights_named(word); }, progressive.rules.weights);
  read.name(
      "solver", [](auto word) { return solver_named(word); }, progressive.solver);
  read.number("tolerance", progressive.tolerance);
  read.number("maxIterations", progressive.max_iterations);
  read.number("levels", wishes.levels);

  if (by_itself) {
    wishes.nonstationary.emplace();
    wishes.nonstationary->boundary = progressive.rules.boundary;
    read.number("shape", wishes.nonstationary->shape);
  }

  SimilarityOptions& similar = wishes.similar;
  similar.rules = progressive.rules;
  similar.tolerance = progressive.tolerance;
  read.name(
      "similarity", [](auto word) { return similarity_named(word); }, similar.similarity);
  read.number("solverTolerance", similar.solver_tolerance);
  double tension = 0;
  read.number("tension", tension);
  similar.thin_plate = 1 - tension;
  similar.membrane = tension;
  if (from["method"].isString()) wishes.method = from["method"].as<std::string>();
  if (wishes.method == "fair") similar.similarity = Similarity::fair;
  if (wishes.method != "progressive" && wishes.method != "similarity" && wishes.method != "fair") {
    return fail(ErrorCode::invalid_argument, "there is no method '" + wishes.method + "'");
  }
  if (read.error()) return tl::make_unexpected(*read.error());
  return wishes;
}

}  // namespace surpass::wasm
