#include "rules_option.hpp"

#include <functional>
#include <initializer_list>
#include <sstream>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

constexpr char kTag[] = "interpolateboundary";

/// The words of an OpenSubdiv tag line, with or without its leading "t": its name, the counts of
/// its integers, floats and strings ("1/0/0"), then those.
std::vector<std::string> tag_words(const std::string& line) {
  std::istringstream stream(line);
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  if (!words.empty() && words.front() == "t") words.erase(words.begin());
  return words;
}

bool is_boundary_tag(const std::string& line) {
  const std::vector<std::string> words = tag_words(line);
  return !words.empty() && words.front() == kTag;
}

/// The rule that the file's own tag asks for. In OpenSubdiv's files, 1 is edge-and-corner, 2 is
/// edge-only; 0 drops the faces at the boundary, which no interpolation can mean.
std::optional<Boundary> tagged_boundary(const Mesh& mesh, Console& console) {
  for (const std::string& line : mesh.tags) {
    if (!is_boundary_tag(line)) continue;
    const std::vector<std::string> words = tag_words(line);
    const std::string value = words.size() > 2 ? words[2] : "1";
    if (value == "1") return Boundary::edge_and_corner;
    if (value == "2") return Boundary::edge_only;
    console.note(
        fmt::format("the file's boundary rule '{}' is not supported; edge-and-corner is "
                    "taken (choose with --boundary)",
                    line));
    return std::nullopt;
  }
  return std::nullopt;
}

template <class Value>
std::optional<Value> annotated(const Mesh& mesh, const char* key,
                               Result<Value> (*named)(std::string_view), Console& console) {
  const std::string text = mesh.annotation(key);
  if (text.empty()) return std::nullopt;
  const Result<Value> value = named(text);
  if (value) return *value;
  console.note(
      fmt::format("the file records the {} '{}', which this version does not know; it is "
                  "ignored",
                  key, text));
  return std::nullopt;
}

}  // namespace

void RulesOption::define(Options& options, Knows knows) {
  std::vector<std::string> schemes;
  for (const Scheme scheme : all_schemes()) schemes.emplace_back(name_of(scheme));
  if (knows.nonstationary) schemes.emplace_back(kNonstationaryLoop);
  options
      .choice_of_words(
          "--scheme", schemes,
          [this](std::size_t i) {
            const std::vector<Scheme> known = all_schemes();
            nonstationary_ = i == known.size();
            scheme_ = nonstationary_ ? Scheme::loop : known[i];
          },
          std::string("Subdivision scheme; by default the one that the file records, else loop for "
                      "triangles and catmull-clark for other faces") +
              (knows.nonstationary ? "; nonstationary-loop interpolates by itself" : ""))
      .group("Surface");
  options
      .choice(
          "--boundary", boundary_,
          {Boundary::edge_only, Boundary::edge_and_corner, Boundary::hoppe, Boundary::interior},
          "Rule at the boundary of an open mesh; by default the one that the file records, else "
          "edge-and-corner. edge-only: the boundary curve is the cubic B-spline of the boundary "
          "polygon; edge-and-corner: and vertices of a single face stay fixed; hoppe: the rules "
          "of the progressive-interpolation paper; interior: the interior mask everywhere, "
          "limit positions only; the last two are for loop")
      .group("Surface");
  define_weights(options, knows);
}

void RulesOption::define_weights(Options& options, Knows knows) {
  std::vector<std::string> words;
  std::vector<std::function<bool()>> takes;  // false: there is one of its kind already
  const auto add = [&]<class W>(std::optional<W>& target, std::initializer_list<W> choices) {
    for (const W choice : choices) {
      words.emplace_back(name_of(choice));
      takes.emplace_back([&target, choice] { return !std::exchange(target, choice).has_value(); });
    }
  };
  std::string description =
      "Weights of doo-sabin in faces without four corners: averaging (Catmull and Clark 1978, the "
      "reconstruction paper's) or cosine (Doo and Sabin 1978); by default what the file records, "
      "else averaging";
  add(weights_, {Weights::averaging, Weights::cosine});
  if (knows.nonstationary) {
    description += ". Of nonstationary-loop: warren (default) or classic (Loop 1987)";
    add(loop_weights_, {LoopWeights::warren, LoopWeights::classic});
  }
  if (knows.directions) {
    description +=
        ". Of the derivatives under --similarity directions: none (the paper), unit (by their "
        "length in the reference), order (by the mean length of their order) or regularised (unit, "
        "bounded where they vanish; default); with a comma after those of doo-sabin";
    add(row_weights_,
        {RowWeights::none, RowWeights::unit, RowWeights::order, RowWeights::regularised});
  }
  const auto store = [words, takes](const std::vector<std::size_t>& numbers) -> std::string {
    for (const std::size_t i : numbers) {
      if (!takes[i]()) return fmt::format("'{}' is the second of its kind", words[i]);
    }
    return {};
  };
  options.choices_of_words("--weights", words, store, description).group("Surface");
}

Rules RulesOption::choose(const Mesh& mesh, Session& session) const {
  Rules rules;
  rules.scheme = suggested_scheme(mesh);
  Console& console = session.console;
  if (const auto found = annotated(mesh, "scheme", scheme_named, console)) rules.scheme = *found;
  if (scheme_) rules.scheme = *scheme_;
  if (boundary_) {
    rules.boundary = *boundary_;
  } else if (const auto recorded = annotated(mesh, "boundary", boundary_named, console)) {
    rules.boundary = *recorded;
  } else if (const auto tagged = tagged_boundary(mesh, console)) {
    rules.boundary = *tagged;
  }
  if (const auto found = annotated(mesh, "weights", weights_named, console)) {
    rules.weights = *found;
  }
  if (weights_) rules.weights = *weights_;
  if (weights_ && rules.scheme != Scheme::doo_sabin && !nonstationary_) {
    console.note(fmt::format("--weights {} says nothing of {} surfaces", name_of(*weights_),
                             name_of(rules.scheme)));
  }
  session.report["scheme"] = nonstationary_ ? kNonstationaryLoop : name_of(rules.scheme);
  session.report["boundary"] = name_of(rules.boundary);
  if (rules.weights != Weights{}) session.report["weights"] = name_of(rules.weights);
  return rules;
}

void record(const Rules& rules, Mesh& mesh) {
  annotate(mesh, rules);
  const std::size_t dropped = std::erase_if(mesh.tags, is_boundary_tag);
  if (dropped == 0) return;
  // The tag stays only where it can say the rule, for programs that read no annotation.
  if (rules.boundary == Boundary::edge_only) mesh.tags.push_back(fmt::format("t {} 1/0/0 2", kTag));
  if (rules.boundary == Boundary::edge_and_corner) {
    mesh.tags.push_back(fmt::format("t {} 1/0/0 1", kTag));
  }
}

}  // namespace surpass::cli
