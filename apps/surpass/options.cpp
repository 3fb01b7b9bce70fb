#include "options.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <fmt/format.h>

#include "spelling.hpp"

namespace surpass::cli {

namespace {

constexpr std::size_t kNameColumn = 32;
constexpr std::size_t kLineWidth = 98;

/// `text` broken into lines that start at kNameColumn; the first goes on where `head` ends.
std::string in_columns(std::string head, const std::string& text) {
  const std::string indent(kNameColumn, ' ');
  if (head.size() + 2 > kNameColumn) {
    head += "\n" + indent;
  } else {
    head.resize(kNameColumn, ' ');
  }
  std::istringstream words(text);
  std::size_t column = kNameColumn;
  for (std::string word; words >> word; column += word.size() + 1) {
    if (column + word.size() > kLineWidth) {
      head += "\n" + indent;
      column = kNameColumn;
    }
    head += (column == kNameColumn ? "" : " ") + word;
  }
  return head + "\n";
}

class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool positional) const override {
    std::string head = "  " + (positional ? option->get_name(true) : option->get_name(false, true));
    const std::string type = option->get_type_name();
    if (!positional && !type.empty()) head += " " + type;
    std::string text = option->get_description();
    if (!option->get_default_str().empty()) text += " [default: " + option->get_default_str() + "]";
    if (!positional && option->get_required()) text += " (required)";
    return in_columns(head, text);
  }

  [[nodiscard]] std::string make_description(const CLI::App* app) const override {
    return app->get_name() + ": " + app->get_description() + "\n\n";
  }

  [[nodiscard]] std::string make_footer(const CLI::App* app) const override {
    return "\n" + app->get_footer();
  }
};

/// An option as typed, without its value: "--levels=3" is "--levels", "-oa.obj" is "-o".
std::string option_name(const std::string& word) {
  if (word.starts_with("--")) return word.substr(0, word.find('='));
  return word.substr(0, 2);
}

bool looks_like_option(const std::string& word) {
  if (word.size() < 2 || word[0] != '-') return false;
  const bool negative_number = std::isdigit(static_cast<unsigned char>(word[1])) || word[1] == '.';
  return !negative_number;
}

std::vector<std::string> option_names(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

/// Refuses what `fault` finds a sentence against. CLI11's own checks would repeat themselves in
/// --help, where the description tells the range.
Option checked(CLI::Option* option, const std::function<std::string(std::string&)>& fault) {
  option->check(CLI::Validator(fault, ""));
  return Option(option);
}

/// That of the word among `words`, their number if it is none of them.
std::size_t number_of(const std::string& word, const std::vector<std::string>& words) {
  return static_cast<std::size_t>(std::find(words.begin(), words.end(), word) - words.begin());
}

}  // namespace

Option Option::group(const std::string& title) const {
  option_->group(title);
  return *this;
}

Option Option::type_name(const std::string& name) const {
  option_->type_name(name);
  return *this;
}

Option Option::default_text(const std::string& text) const {
  option_->default_str(text);
  return *this;
}

Option Option::required() const {
  option_->required();
  return *this;
}

Option Option::excludes(const Option& other) const {
  option_->excludes(other.option_);
  return *this;
}

Option Option::needs(const Option& other) const {
  option_->needs(other.option_);
  return *this;
}

Option Option::value_optional() const {
  option_->expected(0, 1);
  return *this;
}

Option Option::comma_separated() const {
  option_->delimiter(',');
  return *this;
}

Option Option::in_range(double low, double high) const {
  return checked(option_, [low, high](const std::string& word) -> std::string {
    double number = 0;
    const bool inside = CLI::detail::lexical_cast(word, number) && number >= low && number <= high;
    return inside ? "" : fmt::format("'{}' is not a number from {} to {}", word, low, high);
  });
}

Option Option::one_of(const std::vector<std::string>& words) const {
  option_->type_name(fmt::format("{}", fmt::join(words, "|")));
  return checked(option_, [words](const std::string& word) -> std::string {
    if (number_of(word, words) < words.size()) return {};
    return fmt::format("'{}' is not one of {}{}", word, fmt::join(words, ", "),
                       suggestion(word, words));
  });
}

bool Option::given() const { return option_ != nullptr && option_->count() > 0; }

Options::Options(const std::string& command, const std::string& summary)
    : app_(std::make_unique<CLI::App>(summary, command)) {
  app_->formatter(std::make_shared<HelpFormatter>());
  app_->set_help_flag("--help,-h", "Print this text")->group("General");
}

Options::~Options() = default;

Option Options::add(const std::string& name, std::string& target, const std::string& description) {
  return Option(app_->add_option(name, target, description));
}

Option Options::add(const std::string& name, double& target, const std::string& description) {
  return Option(app_->add_option(name, target, description));
}

Option Options::add(const std::string& name, int& target, const std::string& description) {
  return Option(app_->add_option(name, target, description));
}

// By way of a double, so that "1e6" is a count, too.
Option Options::add(const std::string& name, Index& target, const std::string& description) {
  const auto take = [&target](const std::string& word) {
    double number = 0;
    CLI::detail::lexical_cast(word, number);
    target = static_cast<Index>(number);
  };
  CLI::Option* option = app_->add_option_function<std::string>(name, take, description);
  option->type_name("UINT");
  return checked(option, [](const std::string& word) -> std::string {
    double number = 0;
    const bool whole = CLI::detail::lexical_cast(word, number) && number >= 0 &&
                       number <= std::numeric_limits<Index>::max() && number == std::floor(number);
    return whole ? "" : fmt::format("'{}' is not a whole number of at least 0", word);
  });
}

Option Options::add(const std::string& name, std::vector<Index>& target,
                    const std::string& description) {
  return Option(app_->add_option(name, target, description));
}

Option Options::add(const std::string& name, std::vector<std::string>& target,
                    const std::string& description) {
  return Option(app_->add_option(name, target, description));
}

Option Options::flag(const std::string& name, bool& target, const std::string& description) {
  return Option(app_->add_flag(name, target, description));
}

Option Options::choice_of_words(const std::string& name, const std::vector<std::string>& words,
                                const std::function<void(std::size_t)>& store,
                                const std::string& description) {
  const auto take = [words, store](const std::string& word) { store(number_of(word, words)); };
  CLI::Option* option = app_->add_option_function<std::string>(name, take, description);
  return Option(option).one_of(words);
}

Option Options::choices_of_words(
    const std::string& name, const std::vector<std::string>& words,
    const std::function<std::string(const std::vector<std::size_t>&)>& store,
    const std::string& description) {
  const auto take = [=](const std::vector<std::string>& given) {
    std::vector<std::size_t> numbers;
    numbers.reserve(given.size());
    for (const std::string& word : given) numbers.push_back(number_of(word, words));
    const std::string fault = store(numbers);
    if (!fault.empty()) throw CLI::ValidationError(name, fault);
  };
  CLI::Option* option =
      app_->add_option_function<std::vector<std::string>>(name, take, description);
  return Option(option).one_of(words).comma_separated();
}

void Options::examples(const std::string& text) { app_->footer(text); }

/// CLI11 would name a wrong option too, but only after complaining of required ones that the
/// misspelt one was meant to be.
Result<void> Options::refuse_unknown(const std::vector<std::string>& words) const {
  for (const std::string& word : words) {
    if (word == "--") break;  // what follows are arguments
    if (!looks_like_option(word)) continue;
    const std::string name = option_name(word);
    if (app_->get_option_no_throw(name) == nullptr) {
      return fail(ErrorCode::invalid_argument, fmt::format("there is no option '{}'{}", name,
                                                           suggestion(name, option_names(*app_))));
    }
  }
  return {};
}

Result<bool> Options::parse(std::vector<std::string> words) {
  if (const auto known = refuse_unknown(words); !known) {
    for (const std::string& word : words) {
      if (word == "--help" || word == "-h") return true;
    }
    return tl::make_unexpected(known.error());
  }
  try {
    std::reverse(words.begin(), words.end());  // as CLI11 wants them
    app_->parse(std::move(words));
  } catch (const CLI::CallForHelp&) {
    return true;
  } catch (const CLI::ParseError& error) {
    return fail(ErrorCode::invalid_argument, error.what());
  }
  return false;
}

bool Options::offers(const std::string& name) const {
  const CLI::Option* option = app_->get_option_no_throw(name);
  return option != nullptr && option->count() == 0;
}

std::string Options::help() const {
  std::string text = app_->help();
  // CLI11 puts two empty lines between groups.
  for (std::size_t at = 0; (at = text.find("\n\n\n", at)) != std::string::npos;) text.erase(at, 1);
  return text;
}

}  // namespace surpass::cli
