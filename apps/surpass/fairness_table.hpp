// Fairness measures of one or more surfaces, as JSON and as a table.
#pragma once

#include <surpass/fairness.hpp>

#include <optional>
#include <string>
#include <vector>

#include "session.hpp"

namespace surpass::cli {

struct MeasuredSurface {
  std::string path;
  Fairness fairness;
  std::optional<NormalDeviation> deviation = {};  ///< from the reference, where there is one
};

[[nodiscard]] Json fairness_json(const MeasuredSurface& surface);

/// A row a measure, a column a surface, then sentences on what was left out.
[[nodiscard]] std::string fairness_table(const std::vector<MeasuredSurface>& surfaces, int rings);

}  // namespace surpass::cli
