#include "requirements_file.hpp"

#include <surpass/io.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "session.hpp"

namespace surpass::cli {
namespace {

// What a reader of the file may be told, and what an editor is told by. Both are passed over.
constexpr const char* kComment = "comment";
constexpr const char* kSchema = "$schema";

// One entry of the list. Whatever is wrong with it, the first thing found is kept.
class Entry {
 public:
  Entry(const Json& json, std::size_t number, const std::string& path)
      : json_(json), number_(number), path_(path) {}

  Result<Requirement> read() {
    if (!json_.is_object()) return refuse("it is not an object");
    if (!choose_kind() || !locate() || !read_along()) return refuse(problem_);
    for (const auto& [key, value] : json_.items()) {
      if (key == kComment && value.is_string()) continue;
      if (std::find(known_.begin(), known_.end(), key) == known_.end()) {
        return refuse(fmt::format("\"{}\" has no meaning here", key));
      }
    }
    return requirement_;
  }

 private:
  using Kind = Requirement::Kind;

  [[nodiscard]] tl::unexpected<Error> refuse(std::string_view why) const {
    return fail(ErrorCode::syntax, fmt::format("requirement {}: {}", number_, why),
                Place{.file = path_});
  }
  bool problem(std::string text) {
    problem_ = std::move(text);
    return false;
  }

  // "; it has x and y", of keys that could be misspelt kinds; empty without any.
  [[nodiscard]] std::string unknown_keys() const {
    constexpr std::array kOthers = {"vertex", "towards", "face", "uv", "corner", "along", kComment};
    std::string keys;
    for (const auto& [key, value] : json_.items()) {
      if (std::find(kOthers.begin(), kOthers.end(), key) != kOthers.end()) continue;
      keys += fmt::format("{}\"{}\"", keys.empty() ? "; it has " : " and ", key);
    }
    return keys;
  }

  // Exactly one of the kinds' names is a key: its value is the requirement's.
  bool choose_kind() {
    std::vector<std::string> found;
    for (const Kind kind :
         {Kind::position, Kind::normal, Kind::direction, Kind::derivative, Kind::remove}) {
      const char* name = name_of(kind);
      if (!json_.contains(name)) continue;
      found.emplace_back(name);
      requirement_.kind = kind;
      known_.emplace_back(name);
    }
    if (found.size() != 1) {
      return problem(fmt::format(
          "it has to have exactly one of position, normal, direction, derivative and remove{}",
          found.empty() ? unknown_keys() : fmt::format("; it has {} and {}", found[0], found[1])));
    }
    const std::string name = known_.back();
    if (requirement_.kind == Kind::remove) {
      return json_[name] == true || problem("\"remove\" can only be true");
    }
    return numbers(name, requirement_.value.data(), 3);
  }

  bool locate() {
    if (json_.contains("vertex") == json_.contains("face")) {
      return problem("it has to have either a vertex or a face");
    }
    if (json_.contains("vertex")) return index("vertex", requirement_.vertex);
    SurfacePlace& place = requirement_.place;
    return index("face", place.face) && numbers("uv", &place.u, &place.v) &&
           (!json_.contains("corner") || index("corner", place.corner));
  }

  bool read_along() {
    if (requirement_.kind != Kind::direction && requirement_.kind != Kind::derivative) return true;
    if (requirement_.vertex != kNone) return index("towards", requirement_.towards);
    return numbers("along", requirement_.along.data(), &requirement_.along[1]);
  }

  bool index(const char* key, Index& value) {
    known_.emplace_back(key);
    if (!json_.contains(key)) return problem(fmt::format("\"{}\" is missing", key));
    // 1.0 is an integer, too, as the schema has it.
    const Json& json = json_[key];
    const double number = json.is_number() ? json.get<double>() : -1;
    if (!(number >= 0 && number < kNone) || number != std::floor(number)) {
      return problem(fmt::format("\"{}\" is not a number of an element, counted from 0", key));
    }
    value = static_cast<Index>(number);
    return true;
  }

  bool numbers(const std::string& key, double* values, std::size_t count) {
    const Json& json = json_[key];
    bool right = json.is_array() && json.size() == count;
    for (std::size_t i = 0; right && i < count; ++i) {
      right = json[i].is_number() && std::isfinite(json[i].get<double>());
      if (right) values[i] = json[i].get<double>();
    }
    return right || problem(fmt::format("\"{}\" has to be a list of {} numbers", key, count));
  }

  bool numbers(const char* key, double* first, double* second) {
    known_.emplace_back(key);
    std::array<double, 2> pair = {};
    if (!json_.contains(key)) return problem(fmt::format("\"{}\" is missing", key));
    if (!numbers(std::string(key), pair.data(), 2)) return false;
    *first = pair[0];
    *second = pair[1];
    return true;
  }

  const Json& json_;
  std::size_t number_;
  const std::string& path_;
  Requirement requirement_;
  std::vector<std::string> known_;
  std::string problem_;
};

// What the parser would not say: that a key is there twice, of which it takes the last without a
// word, and where a number is too large. Objects in the outer one are those of the list's entries.
// A pass of its own, for the parser with a callback looks at the whole list again after each entry.
class FirstFault final : public nlohmann::json_sax<Json> {
 public:
  /// A sentence on the first key that is there twice; empty if there is none.
  [[nodiscard]] const std::string& repeated() const { return first_; }

  bool start_object(std::size_t) override {
    if (open_.size() == 1) ++entries_;
    open_.emplace_back();
    return true;
  }
  bool key(std::string& name) override {
    if (!open_.back().insert(name).second) first_ = sentence(name);
    return first_.empty();
  }
  bool end_object() override {
    open_.pop_back();
    return true;
  }
  bool start_array(std::size_t) override { return true; }
  bool end_array() override { return true; }
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(Json::number_integer_t) override { return true; }
  bool number_unsigned(Json::number_unsigned_t) override { return true; }
  bool number_float(Json::number_float_t, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(Json::binary_t&) override { return true; }
  bool parse_error(std::size_t byte, const std::string&, const Json::exception& error) override {
    stopped_at_ = byte;
    stopped_by_number_ = dynamic_cast<const Json::out_of_range*>(&error) != nullptr;
    return false;
  }

  /// The byte, from 1, with which it is no JSON any more, or holds a number that no double can
  /// hold; nothing if it is JSON.
  [[nodiscard]] std::optional<std::size_t> stopped_at() const { return stopped_at_; }
  [[nodiscard]] bool stopped_by_number() const { return stopped_by_number_; }

 private:
  [[nodiscard]] std::string sentence(const std::string& key) const {
    if (open_.size() == 1) return fmt::format("\"{}\" is there more than once", key);
    return fmt::format("requirement {}: \"{}\" is there more than once", entries_ - 1, key);
  }

  std::vector<std::set<std::string>> open_;  // keys so far, of the objects around
  std::size_t entries_ = 0;
  std::string first_;
  std::optional<std::size_t> stopped_at_;
  bool stopped_by_number_ = false;
};

// Of a byte, from 1, in a text.
Place place_at(const std::string& path, const std::string& text, std::size_t byte) {
  const std::string_view before = std::string_view(text).substr(0, byte > 0 ? byte - 1 : 0);
  const std::size_t last = before.rfind('\n');  // npos: -1, as if one came before the text
  return {.file = path,
          .line = 1 + static_cast<std::uint64_t>(std::count(before.begin(), before.end(), '\n')),
          .column = before.size() - last};
}

}  // namespace

Result<std::vector<Requirement>> read_requirements(const std::string& path) {
  const Result<std::string> text = read_file(path);
  if (!text) return tl::make_unexpected(text.error());
  const Place place{.file = path};
  FirstFault fault;
  Json::sax_parse(*text, &fault);
  if (!fault.repeated().empty()) return fail(ErrorCode::syntax, fault.repeated(), place);
  if (const auto byte = fault.stopped_at()) {
    return fail(ErrorCode::syntax,
                fault.stopped_by_number() ? "holds a number here that no double can hold"
                                          : "is not JSON from here on",
                place_at(path, *text, *byte));
  }
  Json json = Json::parse(*text);
  if (json.is_object() && json.value(kSchema, Json()).is_string()) json.erase(kSchema);
  if (!json.is_object() || json.size() != 1 || !json.contains("requirements") ||
      !json["requirements"].is_array()) {
    std::string other;
    for (const auto& [key, value] : json.items()) {
      if (json.is_object() && key != "requirements" && other.empty()) {
        other = fmt::format("; it has \"{}\"", key);
      }
    }
    return fail(ErrorCode::syntax,
                "has to be an object with the list \"requirements\", and nothing else" + other,
                place);
  }
  std::vector<Requirement> requirements;
  for (const Json& entry : json["requirements"]) {
    auto read = Entry(entry, requirements.size(), path).read();
    if (!read) return tl::make_unexpected(read.error());
    requirements.push_back(*read);
  }
  return requirements;
}

}  // namespace surpass::cli
