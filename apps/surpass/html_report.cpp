#include "html_report.hpp"

#include <surpass/fairness.hpp>
#include <surpass/version.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "mesh_output.hpp"

namespace surpass::cli {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kDataMark = "\"surpass-data\"";  // in the page's frame, once
constexpr double kMostShown = 30000;                        // vertices of a limit surface

// Beside the build, or where `cmake --install` put it.
Result<std::string> read_frame() {
  std::error_code failed;
  const fs::path self = fs::read_symlink("/proc/self/exe", failed).parent_path();
  for (const char* place : {"../report/report.html", "../share/surpass/report.html"}) {
    std::ifstream file(self / place, std::ios::binary);
    std::string text{std::istreambuf_iterator<char>(file), {}};
    if (text.find(kDataMark) != std::string::npos) return text;
  }
  return fail(
      ErrorCode::not_built_in,
      "the frame of HTML reports is not there; build it with 'make web' (which needs npm) in "
      "the folder of Surpass, then try again");
}

template <class Number>
std::string base64(const std::vector<Number>& numbers) {
  static constexpr char kDigits[] =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes(numbers.size() * sizeof(Number));
  if (!bytes.empty()) std::memcpy(bytes.data(), numbers.data(), bytes.size());
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t left = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < left ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= left ? kDigits[group >> (18 - 6 * k) & 63U] : '=';
    }
  }
  return text;
}

// Positions as multiples of 1/65535 of the largest side of their own box.
Json quantised(std::span<const Point> points) {
  const Box box = bounding_box(points);
  const double step = (box.side() > 0 ? box.side() : 1) / 65535;
  std::vector<std::uint16_t> numbers;
  numbers.reserve(3 * points.size());
  for (const Point& p : points) {
    for (std::size_t c = 0; c < 3; ++c) {
      const double steps = std::round((p[c] - box.low[c]) / step);
      numbers.push_back(static_cast<std::uint16_t>(std::clamp(steps, 0.0, 65535.0)));
    }
  }
  return {{"low", box.low}, {"step", step}, {"values", base64(numbers)}};
}

std::string small_normals(const std::vector<double>& normals) {
  std::vector<std::int8_t> numbers;
  numbers.reserve(normals.size());
  for (const double x : normals) {
    numbers.push_back(static_cast<std::int8_t>(std::lround(std::clamp(x, -1.0, 1.0) * 127)));
  }
  return base64(numbers);
}

std::string floats(std::span<const double> values) {
  return base64(std::vector<float>(values.begin(), values.end()));
}

// Two bytes a vertex number where they are enough.
int index_bytes(const Mesh& mesh) { return mesh.vertex_count() <= 65536 ? 2 : 4; }

std::string numbers_of_vertices(const std::vector<Index>& vertices, const Mesh& mesh) {
  if (index_bytes(mesh) == 4) return base64(vertices);
  std::vector<std::uint16_t> small;
  small.reserve(vertices.size());
  for (const Index v : vertices) small.push_back(static_cast<std::uint16_t>(v));
  return base64(small);
}

const char* name_of(LayerKind kind) {
  switch (kind) {
    case LayerKind::surface: return "surface";
    case LayerKind::mesh: return "mesh";
    case LayerKind::cage: return "cage";
    case LayerKind::points: return "points";
  }
  return "mesh";
}

void add_channels(const Mesh& mesh, Json& layer) {
  for (const Channel& channel : mesh.channels) {
    if (channel.name == "normal" && channel.width() == 3) {
      layer["normals"] = small_normals(channel.values);
    } else if (channel.width() == 1 && (channel.name == "mean" || channel.name == "gauss" ||
                                        channel.name == "error" || channel.name == "distance")) {
      layer["channels"][channel.name] = floats(channel.values);
    }
  }
}

}  // namespace

void HtmlReport::define(Options& options) {
  options
      .add("--html", path_,
           "Also write a page that shows it all, in one file for any browser, without a network")
      .type_name("FILE")
      .group("Output");
}

Result<void> HtmlReport::prepare(Session& session, const std::vector<std::string>& inputs,
                                 const std::vector<std::string>& other_outputs) {
  if (!wanted()) return {};
  session.on_page = true;
  std::vector<std::string> outputs = other_outputs;
  outputs.push_back(path_);
  // Last, as everywhere: it is the one that must not go where another output is.
  outputs.push_back(session.report_path);
  std::erase(outputs, "");
  if (const auto checked = check_paths(inputs, outputs, true); !checked) return checked;
  // No --force: a page in the place of a mesh is always a mistake.
  if (const auto checked = check_paths(inputs, {path_}, false); !checked) return checked;
  auto frame = read_frame();
  if (!frame) return tl::make_unexpected(frame.error());
  frame_ = std::move(*frame);
  return {};
}

void HtmlReport::add(const char* id, const std::string& label, LayerKind kind, const Mesh& mesh) {
  if (!wanted()) return;
  if (!has_box_) box_ = bounding_box(mesh.points);
  has_box_ = true;
  Json layer = {
      {"id", id}, {"label", label}, {"kind", name_of(kind)}, {"channels", Json::object()}};
  layer["positions"] = quantised(mesh.points);
  std::vector<Index> degrees;
  degrees.reserve(mesh.face_count());
  for (Index f = 0; f < mesh.face_count(); ++f) {
    degrees.push_back(static_cast<Index>(mesh.face(f).size()));
  }
  const bool same = !degrees.empty() && std::all_of(degrees.begin(), degrees.end(),
                                                    [&](Index d) { return d == degrees.front(); });
  if (same) {
    layer["degree"] = degrees.front();
  } else {
    layer["degrees"] = base64(degrees);
  }
  layer["corners"] = numbers_of_vertices(mesh.face_vertices, mesh);
  layer["index_bytes"] = index_bytes(mesh);
  std::vector<Index> creases;
  for (const Crease& crease : mesh.creases) {
    if (crease.sharpness > 0)
      creases.insert(creases.end(), crease.vertices.begin(), crease.vertices.end());
  }
  layer["creases"] = numbers_of_vertices(creases, mesh);
  add_channels(mesh, layer);
  layers_.push_back(std::move(layer));
}

int HtmlReport::shown_levels(const Mesh& control) {
  int levels = 0;
  while (levels < 4 && control.vertex_count() * std::pow(4.0, levels + 1) <= kMostShown) ++levels;
  return levels;
}

Result<void> HtmlReport::add_limit(const char* id, const std::string& label, const Mesh& control,
                                   const Rules& rules, const Context& context) {
  int levels = shown_levels(control);
  if (levels == 0 && rules.scheme == Scheme::doo_sabin) levels = 1;
  Result<Mesh> limit = limit_mesh(control, rules, levels, context);
  if (!limit) return tl::make_unexpected(limit.error());
  return add_surface(id, label, std::move(*limit), context);
}

Result<void> HtmlReport::add_surface(const char* id, const std::string& label, Mesh surface,
                                     const Context& context) {
  const auto curvatures = vertex_curvatures(surface, context);
  if (!curvatures) return tl::make_unexpected(curvatures.error());
  // As in the studio: of a mesh whose box side is one.
  const double side = has_box_ && box_.side() > 0 ? box_.side() : 1;
  Channel mean{"mean", {"mean"}, {}};
  Channel gauss{"gauss", {"gauss"}, {}};
  for (const VertexCurvature& k : *curvatures) {
    mean.values.push_back(k.mean * side);
    gauss.values.push_back(k.gauss * side * side);
  }
  surface.channels.push_back(std::move(mean));
  surface.channels.push_back(std::move(gauss));
  add(id, label, LayerKind::surface, surface);
  return {};
}

void HtmlReport::mark(std::span<const Point> points, std::span<const double> errors) {
  points_ = {{"positions", quantised(points)}};
  if (!errors.empty()) points_["errors"] = floats(errors);
}

void HtmlReport::plot(const std::string& name, const Json& history) {
  Json points = Json::array();
  for (const Json& entry : history) points.push_back({entry["iteration"], entry["max"]});
  if (points.size() > 1) curves_.push_back({{"name", name}, {"points", std::move(points)}});
}

Result<void> HtmlReport::write(Session& session) {
  if (!wanted()) return {};
  Point centre = {};
  for (std::size_t c = 0; c < 3; ++c) centre[c] = box_.low[c] / 2 + box_.high[c] / 2;
  Json report = session.report;
  report["notes"] = session.console.notes();
  report.erase("seconds");  // a report of the same mesh is the same page
  const Json data = {{"version", kVersion},
                     {"centre", centre},
                     {"side", box_.side() > 0 ? box_.side() : 1},
                     {"layers", std::move(layers_)},
                     {"points", std::move(points_)},
                     {"curves", std::move(curves_)},
                     {"report", std::move(report)}};
  std::string text = data.dump(-1, ' ', false, Json::error_handler_t::replace);
  // Inside a page, nothing in a string may look like the end of its element.
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at)) {
    text.replace(at, 1, "\\u003c");
  }
  std::string page = frame_;
  page.replace(page.find(kDataMark), kDataMark.size(), text);
  if (const auto written = write_bytes(path_, page, session); !written) return written;
  session.report["html"] = path_;
  return {};
}

}  // namespace surpass::cli
