#include "levels.hpp"

#include <cmath>

#include <fmt/format.h>

#include "wording.hpp"

namespace surpass::cli {

Option add_levels(Options& options, int& levels, const std::string& description) {
  return options.add("--levels", levels, description + " (0 to 10; each makes four faces of one)")
      .in_range(0, 10)
      .type_name("N")
      .default_text(std::to_string(levels));
}

Result<void> check_levels(const Mesh& mesh, int levels) {
  constexpr double kMostCorners = 2147483648.0;
  const double corners = std::max(1.0, static_cast<double>(mesh.corner_count()));
  const double refined = corners * std::pow(4.0, levels);
  if (refined <= kMostCorners) return {};
  const int fitting =
      static_cast<int>(std::floor(std::log(kMostCorners / corners) / std::log(4.0)));
  return fail(ErrorCode::invalid_argument,
              fmt::format("--levels {} would make a mesh of {:.3g} face corners; at most {} "
                          "possible for this mesh",
                          levels, refined, counted(fitting, "level is", "levels are")));
}

}  // namespace surpass::cli
