#include <surpass/requirements.hpp>

#include <algorithm>
#include <functional>

#include <fmt/format.h>

#include "mesh/wording.hpp"

namespace surpass {
namespace {

bool is_missed(const RequirementOutcome& outcome, double tolerance) {
  return !(outcome.error <= tolerance);
}

}  // namespace

std::vector<std::string> notes_on(std::span<const Requirement> requirements,
                                  std::span<const RequirementOutcome> outcomes, double tolerance) {
  std::vector<std::string> notes;
  const auto note_where = [&](const std::string& one, const std::string& many, const auto& is) {
    const auto first = std::find_if(outcomes.begin(), outcomes.end(), is);
    if (first == outcomes.end()) return;
    const auto number = static_cast<std::size_t>(first - outcomes.begin());
    const auto count = std::count_if(first, outcomes.end(), is);
    notes.push_back(fmt::format("{} of {} {}; the first: {}, {}", count,
                                counted(outcomes.size(), "requirement", "requirements"),
                                count == 1 ? one : many, number, describe(requirements[number])));
  };
  note_where("was dropped, for it follows from the others",
             "were dropped, for they follow from the others",
             std::mem_fn(&RequirementOutcome::redundant));
  note_where("points the other way", "point the other way",
             std::mem_fn(&RequirementOutcome::flipped));
  note_where("leaves the surface without a tangent plane, for derivatives there are parallel",
             "leave the surface without a tangent plane, for derivatives there are parallel",
             std::mem_fn(&RequirementOutcome::without_plane));
  const std::string missed = fmt::format("missed by more than {:.3g} of the box side", tolerance);
  note_where("was " + missed, "were " + missed,
             [&](const RequirementOutcome& o) { return is_missed(o, tolerance) && !o.flipped; });
  return notes;
}

bool all_met(std::span<const RequirementOutcome> outcomes, double tolerance) {
  return std::none_of(outcomes.begin(), outcomes.end(),
                      [&](const RequirementOutcome& o) { return is_missed(o, tolerance); });
}

}  // namespace surpass
