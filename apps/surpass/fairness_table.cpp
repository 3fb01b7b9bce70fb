#include "fairness_table.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>

namespace surpass::cli {

namespace {

// One list for both forms, so that none of them lacks a measure.
struct Measure {
  const char* key;   // in the report
  const char* name;  // in the table
  const char* unit;
  double Fairness::*value;
};
constexpr Measure kMeasures[] = {
    {"bending", "bending", "-", &Fairness::bending},
    {"trimmed_bending", "  without sharpest 1 %", "-", &Fairness::trimmed_bending},
    {"thin_plate", "thin plate", "length^2", &Fairness::thin_plate},
    {"thin_plate_relative", "  relative", "-", &Fairness::thin_plate_relative},
    {"curvature_variation", "curvature variation", "1/length^2", &Fairness::curvature_variation},
    {"curvature_variation_relative", "  relative", "-", &Fairness::curvature_variation_relative},
    {"total_variation", "total variation", "-", &Fairness::total_variation},
    {"largest_curvature", "largest curvature", "1/length", &Fairness::largest_curvature},
    {"largest_curvature_relative", "  relative", "-", &Fairness::largest_curvature_relative},
    {"high_curvature", "99 % curvature", "1/length", &Fairness::high_curvature},
    {"high_curvature_relative", "  relative", "-", &Fairness::high_curvature_relative},
    {"total_gauss", "total Gauss curvature", "-", &Fairness::total_gauss},
};

struct Angle {
  const char* key;
  const char* name;
  double NormalDeviation::*value;
};
constexpr Angle kAngles[] = {
    {"mean", "normals off, mean", &NormalDeviation::mean},
    {"rms", "normals off, rms", &NormalDeviation::rms},
    {"max", "normals off, largest", &NormalDeviation::max},
};

Json coverage_json(const FairnessCoverage& c) {
  return {{"patches", c.patches},  {"measured_patches", c.measured_patches},
          {"samples", c.samples},  {"degenerate_samples", c.degenerate_samples},
          {"area", c.area},        {"measured_area", c.measured_area},
          {"left_out", c.left_out}};
}

using Surfaces = std::vector<MeasuredSurface>;
using Cell = std::function<std::string(const MeasuredSurface&)>;

std::string row(const char* name, const char* unit, const Surfaces& surfaces, const Cell& cell) {
  std::string text = fmt::format("{:24}{:12}", name, unit);
  for (const MeasuredSurface& s : surfaces) text += fmt::format("{:>14}", cell(s));
  return text + "\n";
}

std::string number(double value) { return fmt::format("{:.6g}", value); }

std::string letter(std::size_t i) {
  return i < 26 ? std::string(1, static_cast<char>('A' + i)) : fmt::format("#{}", i + 1);
}

std::string heading(const Surfaces& surfaces) {
  std::string text;
  std::string letters = fmt::format("{:24}{:12}", "", "unit");
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    text += fmt::format("{}  {}\n", letter(i), surfaces[i].path);
    letters += fmt::format("{:>14}", letter(i));
  }
  return text + letters + "\n";
}

std::string sentence(const MeasuredSurface& s, std::size_t i, int rings) {
  const FairnessCoverage& c = s.fairness.coverage;
  const Point& at = s.fairness.largest_at;
  std::string text = fmt::format(
      "{}: {:.3g} % of the area is left out: boundaries, creases, extraordinary vertices with {} "
      "rings\n   around them.",
      letter(i), 100 * c.left_out, rings);
  if (s.fairness.largest_curvature > 0) {
    text += fmt::format(" The largest curvature is at ({:.10g}, {:.10g}, {:.10g}).", at[0], at[1],
                        at[2]);
  }
  text += "\n";
  if (c.degenerate_samples > 0) {
    text += fmt::format("   {} samples have no tangent plane.\n", c.degenerate_samples);
  }
  return text;
}

}  // namespace

Json fairness_json(const MeasuredSurface& surface) {
  const Fairness& f = surface.fairness;
  Json json = {{"levels", f.levels}, {"coverage", coverage_json(f.coverage)}};
  for (const Measure& m : kMeasures) json[m.key] = f.*m.value;
  json["largest_at"] = f.largest_at;
  if (!surface.deviation) return json;
  Json& angles = json["normal_deviation"];
  for (const Angle& a : kAngles) angles[a.key] = (*surface.deviation).*a.value;
  angles["coverage"] = coverage_json(surface.deviation->coverage);
  return json;
}

std::string fairness_table(const Surfaces& surfaces, int rings) {
  std::string text = heading(surfaces);
  const auto add = [&](const char* name, const char* unit, const Cell& cell) {
    text += row(name, unit, surfaces, cell);
  };
  add("levels", "", [](const auto& s) { return std::to_string(s.fairness.levels); });
  add("patches measured", "",
      [](const auto& s) { return std::to_string(s.fairness.coverage.measured_patches); });
  add("area", "length^2", [](const auto& s) { return number(s.fairness.coverage.area); });
  add("  measured", "length^2",
      [](const auto& s) { return number(s.fairness.coverage.measured_area); });
  for (const Measure& m : kMeasures) {
    add(m.name, m.unit, [&](const auto& s) { return number(s.fairness.*m.value); });
  }
  for (const Angle& a : kAngles) {
    if (!surfaces.front().deviation) break;
    add(a.name, "degrees", [&](const auto& s) { return number((*s.deviation).*a.value); });
  }
  for (std::size_t i = 0; i < surfaces.size(); ++i) text += sentence(surfaces[i], i, rings);
  return text;
}

}  // namespace surpass::cli
