// The text of --help and --version.
#pragma once

#include <string>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>

namespace surpass::cli {

/// Options in two columns, descriptions wrapped, with defaults.
class HelpFormatter : public CLI::Formatter {
 public:
  [[nodiscard]] std::string make_option(const CLI::Option* option, bool positional) const override;
  [[nodiscard]] std::string make_description(const CLI::App* app) const override;
  [[nodiscard]] std::string make_footer(const CLI::App* app) const override;
};

/// `surpass COMMAND --help`, in the form of HelpFormatter.
[[nodiscard]] std::string help_text(const CLI::App& app);

/// `surpass --help`: the commands and the exit codes.
[[nodiscard]] std::string overview();

/// `surpass --version`: the version and the components built in.
[[nodiscard]] std::string version_text();

}  // namespace surpass::cli
