#include "anatomy.hpp"

#include <surpass/topology.hpp>

#include <set>

#include <fmt/format.h>

#include "mesh_input.hpp"

namespace surpass::cli {

namespace {

Connections connect(const Topology& topology) {
  Connections c;
  c.edges = topology.edge_count();
  c.components = find_components(topology).count;
  for (const auto& loop : boundary_loops(topology)) c.boundary_loops.push_back(loop.size());
  for (Index v = 0; v < topology.vertex_count(); ++v) {
    if (topology.is_isolated(v)) {
      ++c.isolated_vertices;
      continue;
    }
    if (topology.is_bowtie(v)) ++c.bowties;
    auto& valences = topology.is_boundary(v) ? c.boundary_valences : c.interior_valences;
    ++valences[topology.valence(v)];
  }
  return c;
}

void refuse_polygons(const Mesh& mesh, Scheme scheme, Diagnosis& diagnosis) {
  const Index fit = face_size(scheme);
  for (Index f = 0; fit != 0 && f < mesh.face_count(); ++f) {
    const std::size_t size = mesh.face(f).size();
    if (size <= fit) continue;
    diagnosis.refusals.push_back(
        {ErrorCode::unsuitable_for_scheme,
         fmt::format("the scheme {} takes triangles only, and this face has {} corners",
                     name_of(scheme), size),
         Place{.face = f}});
    ++diagnosis.refusal_count;
    return;  // the first one tells all
  }
}

struct Range {
  float low = kInfinitelySharp;
  float high = 0;
  std::size_t count = 0;
  void add(float sharpness) {
    low = std::min(low, sharpness);
    high = std::max(high, sharpness);
    ++count;
  }
};

template <class Sharp>
Range sharpness_range(const std::vector<Sharp>& items) {
  Range range;
  for (const Sharp& item : items) range.add(item.sharpness);
  return range;
}

template <class Sharp>
Json sharpness_json(const std::vector<Sharp>& items) {
  const Range range = sharpness_range(items);
  Json json = {{"count", range.count}};
  if (range.count > 0) json["sharpness"] = {range.low, range.high};
  return json;
}

template <class Sharp>
std::string sharpness_text(const std::vector<Sharp>& items) {
  const Range range = sharpness_range(items);
  if (range.low == range.high) return fmt::format("{}, sharpness {}", range.count, range.low);
  return fmt::format("{}, sharpness {} to {}", range.count, range.low, range.high);
}

template <class Map>
Json histogram_json(const Map& histogram) {
  Json json = Json::object();
  for (const auto& [key, count] : histogram) json[std::to_string(key)] = count;
  return json;
}

template <class Map>
std::string histogram_text(const Map& histogram) {
  std::string text;
  for (const auto& [key, count] : histogram) {
    text += fmt::format("{}{} x {}", text.empty() ? "" : ", ", count, key);
  }
  return text;
}

std::string row(const char* name, const std::string& value) {
  return fmt::format("{:20}{}\n", name, value);
}

Json channels_json(const Mesh& mesh) {
  Json json = Json::array();
  for (const Channel& c : mesh.channels) {
    json.push_back({{"name", c.name}, {"width", c.width()}, {"per", "vertex"}});
  }
  for (const CornerChannel& c : mesh.corner_channels) {
    json.push_back({{"name", c.name}, {"width", c.width}, {"per", "corner"}});
  }
  for (const FaceChannel& c : mesh.face_channels) {
    json.push_back({{"name", c.name}, {"width", c.parts.size()}, {"per", "face"}});
  }
  return json;
}

std::string connections_text(const Connections& c) {
  std::string loops;
  constexpr std::size_t kMostLoops = 12;
  for (std::size_t i = 0; i < std::min(kMostLoops, c.boundary_loops.size()); ++i) {
    loops += fmt::format("{} {}", i == 0 ? ", of" : ",", c.boundary_loops[i]);
  }
  if (c.boundary_loops.size() > kMostLoops) loops += ", ...";
  std::string text =
      row("edges", std::to_string(c.edges)) + row("components", std::to_string(c.components)) +
      row("boundary loops",
          fmt::format("{}{}{}", c.boundary_loops.size(), loops, loops.empty() ? "" : " edges"));
  const auto add = [&](const char* name, const std::map<Index, std::size_t>& valences) {
    if (!valences.empty()) text += row(name, histogram_text(valences));
  };
  add("valences, interior", c.interior_valences);
  add("valences, boundary", c.boundary_valences);
  if (c.isolated_vertices > 0)
    text += row("isolated vertices", std::to_string(c.isolated_vertices));
  if (c.bowties > 0) text += row("bow-ties", std::to_string(c.bowties));
  return text;
}

std::string attributes_text(const Mesh& mesh) {
  std::string text;
  if (!mesh.creases.empty()) text += row("creases", sharpness_text(mesh.creases));
  if (!mesh.corners.empty()) text += row("corners", sharpness_text(mesh.corners));
  if (!mesh.hole_faces.empty()) text += row("hole faces", std::to_string(mesh.hole_faces.size()));
  for (const Json& channel : channels_json(mesh)) {
    text += row("channel", fmt::format("{}, {} numbers a {}", channel["name"].get<std::string>(),
                                       channel["width"].get<std::size_t>(),
                                       channel["per"].get<std::string>()));
  }
  for (const std::string& tag : mesh.tags) text += row("tag", tag);
  for (const auto& [key, value] : mesh.annotations) {
    text += row("recorded", fmt::format("{} {}", key, value));
  }
  return text;
}

std::string verdict_text(const Diagnosis& diagnosis) {
  std::string text;
  for (const std::string& remark : diagnosis.remarks) text += row("remark", remark);
  for (const Error& refusal : diagnosis.refusals) text += row("refused", describe(refusal));
  if (diagnosis.refusal_count > diagnosis.refusals.size()) {
    text +=
        row("", fmt::format("and {} more", diagnosis.refusal_count - diagnosis.refusals.size()));
  }
  std::set<std::string> remedies;
  for (const Error& refusal : diagnosis.refusals) remedies.insert(remedy(refusal));
  for (const std::string& sentence : remedies) {
    if (!sentence.empty()) text += row("try", sentence);
  }
  return text + row("verdict", diagnosis.refusals.empty() ? "accepted" : "refused");
}

}  // namespace

Anatomy examine(const Mesh& mesh, Scheme scheme) {
  Anatomy anatomy;
  for (Index f = 0; f < mesh.face_count(); ++f) ++anatomy.face_sizes[mesh.face(f).size()];
  anatomy.box = bounding_box(mesh.points);
  anatomy.diagnosis = diagnose(mesh);
  refuse_polygons(mesh, scheme, anatomy.diagnosis);
  if (const Result<Topology> topology = Topology::build(mesh)) {
    anatomy.connections = connect(*topology);
  }
  return anatomy;
}

Json anatomy_json(const Mesh& mesh, const Anatomy& anatomy) {
  Json json;
  json["face_sizes"] = histogram_json(anatomy.face_sizes);
  json["box"] = {{"low", anatomy.box.low}, {"high", anatomy.box.high}};
  if (anatomy.connections) {
    const Connections& c = *anatomy.connections;
    json["edges"] = c.edges;
    json["isolated_vertices"] = c.isolated_vertices;
    json["bowties"] = c.bowties;
    json["boundary_loop_lengths"] = c.boundary_loops;
    json["valences"] = {{"interior", histogram_json(c.interior_valences)},
                        {"boundary", histogram_json(c.boundary_valences)}};
  }
  json["creases"] = sharpness_json(mesh.creases);
  json["corners"] = sharpness_json(mesh.corners);
  json["hole_faces"] = mesh.hole_faces.size();
  json["channels"] = channels_json(mesh);
  json["accepted"] = anatomy.diagnosis.refusals.empty();
  json["refusal_count"] = anatomy.diagnosis.refusal_count;
  json["refusals"] = Json::array();
  for (const Error& refusal : anatomy.diagnosis.refusals) {
    json["refusals"].push_back(error_json(refusal));
  }
  json["remarks"] = anatomy.diagnosis.remarks;
  return json;
}

std::string anatomy_table(const Mesh& mesh, const Anatomy& anatomy) {
  std::string faces = std::to_string(mesh.face_count());
  if (!anatomy.face_sizes.empty()) faces += " (" + histogram_text(anatomy.face_sizes) + " corners)";
  std::string text = row("vertices", std::to_string(mesh.vertex_count())) + row("faces", faces);
  if (anatomy.connections) text += connections_text(*anatomy.connections);
  const Point& low = anatomy.box.low;
  const Point& high = anatomy.box.high;
  text += row("bounding box", fmt::format("({}, {}, {}) to ({}, {}, {})", low[0], low[1], low[2],
                                          high[0], high[1], high[2]));
  text += row("largest side", fmt::format("{}", anatomy.box.side()));
  return text + attributes_text(mesh) + verdict_text(anatomy.diagnosis);
}

}  // namespace surpass::cli
