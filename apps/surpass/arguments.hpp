// Helpers around CLI11: choices by name, and the nearest right word for a wrong one.
#pragma once

#include <surpass/result.hpp>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

namespace surpass::cli {

/// The candidate with the smallest edit distance to `word`, or "" if none is near enough to be
/// meant.
[[nodiscard]] std::string nearest(std::string_view word,
                                  const std::vector<std::string>& candidates);

/// "; did you mean 'x'?" for the nearest candidate, or "".
[[nodiscard]] std::string suggestion(std::string_view word,
                                     const std::vector<std::string>& candidates);

/// Fails on the first of `words` that looks like an option and is none of `app`. CLI11 would name
/// it too, but only after complaining of required options that the misspelt one was meant to be.
[[nodiscard]] Result<void> refuse_unknown_options(const CLI::App& app,
                                                  const std::vector<std::string>& words);

/// CLI::Range without its own words in --help, where the description tells the range.
template <class Number>
CLI::Validator in_range(Number low, Number high) {
  return CLI::Range(low, high).description("");
}

/// An option that takes one of a few names, as name_of(value) writes them. `target` is a Value, or
/// an optional that stays empty without the option.
template <class Target, class Value>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Target& target,
                        const std::vector<Value>& choices, const std::string& description) {
  std::vector<std::pair<std::string, Value>> table;
  std::vector<std::string> names;
  for (const Value choice : choices) {
    table.emplace_back(name_of(choice), choice);
    names.emplace_back(name_of(choice));
  }
  const auto store = [table, &target](const std::string& word) {
    for (const auto& [name, choice] : table) {
      if (name == word) target = choice;
    }
  };
  const auto known = [names](const std::string& word) -> std::string {
    for (const std::string& name : names) {
      if (name == word) return {};
    }
    return fmt::format("'{}' is not one of {}{}", word, fmt::join(names, ", "),
                       suggestion(word, names));
  };
  return app.add_option_function<std::string>(option, store, description)
      ->check(CLI::Validator(known, ""))
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
}

template <class Value, class Target>
CLI::Option* add_choice(CLI::App& app, const std::string& option, Target& target,
                        std::initializer_list<Value> choices, const std::string& description) {
  return add_choice(app, option, target, std::vector<Value>(choices), description);
}

}  // namespace surpass::cli
