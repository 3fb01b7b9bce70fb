// The arguments and options of one command. This is a front to CLI11, whose headers take longer to
// compile than everything else here: options.cpp alone includes them.
#pragma once

#include <surpass/result.hpp>

#include <functional>
#include <initializer_list>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace CLI {  // NOLINT(readability-identifier-naming): as the library has it
class App;
class Option;
}  // namespace CLI

namespace surpass::cli {

/// One of the Options, to say more of it. Copies speak of the same option.
class Option {
 public:
  Option() = default;
  explicit Option(CLI::Option* option) : option_(option) {}

  Option group(const std::string& title) const;        ///< its heading in --help
  Option type_name(const std::string& name) const;     ///< what it takes, in --help
  Option default_text(const std::string& text) const;  ///< shown in --help
  Option required() const;
  Option excludes(const Option& other) const;
  Option needs(const Option& other) const;
  Option value_optional() const;  ///< the name alone will do
  Option comma_separated() const;
  Option in_range(double low, double high) const;              ///< refuse other numbers
  Option one_of(const std::vector<std::string>& words) const;  ///< refuse others
  [[nodiscard]] bool given() const;

 private:
  CLI::Option* option_ = nullptr;
};

class Options {
 public:
  /// `command` is what the user types ("surpass check"), `summary` one line on what it does.
  Options(const std::string& command, const std::string& summary);
  Options(const Options&) = delete;
  Options& operator=(const Options&) = delete;
  ~Options();

  /// An argument ("GIVEN") or an option ("-o,--output"). `target` keeps its value if it is not
  /// given, and has to live until parse().
  Option add(const std::string& name, std::string& target, const std::string& description);
  Option add(const std::string& name, double& target, const std::string& description);
  Option add(const std::string& name, int& target, const std::string& description);
  Option add(const std::string& name, Index& target, const std::string& description);
  Option add(const std::string& name, std::vector<Index>& target, const std::string& description);
  Option add(const std::string& name, std::vector<std::string>& target,
             const std::string& description);
  Option flag(const std::string& name, bool& target, const std::string& description);

  /// An option that takes one of a few names, as name_of(value) writes them. `target` is a Value,
  /// or an optional that stays empty without the option.
  template <class Target, class Value>
  Option choice(const std::string& name, Target& target, const std::vector<Value>& choices,
                const std::string& description) {
    std::vector<std::string> words;
    words.reserve(choices.size());
    for (const Value value : choices) words.emplace_back(name_of(value));
    const auto store = [choices, &target](std::size_t i) { target = choices[i]; };
    return choice_of_words(name, words, store, description);
  }
  template <class Target, class Value>
  Option choice(const std::string& name, Target& target, std::initializer_list<Value> choices,
                const std::string& description) {
    return choice(name, target, std::vector<Value>(choices), description);
  }

  /// Stores the number of the word that is given.
  Option choice_of_words(const std::string& name, const std::vector<std::string>& words,
                         const std::function<void(std::size_t)>& store,
                         const std::string& description);

  /// One word or several with commas between. `store` is given their numbers, and answers with what
  /// is wrong with them together, or nothing.
  Option choices_of_words(const std::string& name, const std::vector<std::string>& words,
                          const std::function<std::string(const std::vector<std::size_t>&)>& store,
                          const std::string& description);

  /// Printed under the options.
  void examples(const std::string& text);

  /// Fills the targets from what follows the command's name. True if help was asked for instead.
  [[nodiscard]] Result<bool> parse(std::vector<std::string> words);

  /// Whether the command has this option ("--repair") and it was not given.
  [[nodiscard]] bool offers(const std::string& name) const;

  /// `surpass COMMAND --help`: options in two columns, descriptions wrapped, with defaults.
  [[nodiscard]] std::string help() const;

 private:
  [[nodiscard]] Result<void> refuse_unknown(const std::vector<std::string>& words) const;

  std::unique_ptr<CLI::App> app_;
};

}  // namespace surpass::cli
