// What a solver did, as JSON and as lines for people.
#pragma once

#include <surpass/interpolate.hpp>
#include <surpass/quality.hpp>

#include <optional>

#include "session.hpp"

namespace surpass::cli {

/// The certificates of one control mesh.
struct Verdict {
  Certificate exact;                  ///< before rounding; the tolerance is judged by it
  std::optional<Certificate> stored;  ///< after rounding, where the file rounds
  std::optional<Certificate> oracle;  ///< by OpenSubdiv, before rounding, where asked for

  /// The largest error that the tolerance is held against.
  [[nodiscard]] double judged() const;
};

/// Fills iterations, error, history and the rest of a report's keys of interpolation.
void add_solve_report(const SolveReport& solved, const Verdict& verdict, Json& report);

/// "error 1.2e-02 -> 3.4e-13 of the box side (mean 5e-14), 21 iterations"
[[nodiscard]] std::string summary(const SolveReport& solved, const Verdict& verdict);

}  // namespace surpass::cli
