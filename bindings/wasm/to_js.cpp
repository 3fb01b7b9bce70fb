#include "to_js.hpp"

#include <algorithm>

namespace surpass::wasm {

val floats(std::span<const double> numbers) {
  const std::vector<float> single(numbers.begin(), numbers.end());
  return typed_array<float>("Float32Array", single);
}

val indices(std::span<const Index> numbers) { return typed_array<Index>("Uint32Array", numbers); }

val bytes(const std::string& text) {
  const auto* data = reinterpret_cast<const unsigned char*>(text.data());
  return typed_array<unsigned char>("Uint8Array", std::span(data, text.size()));
}

val strings(const std::vector<std::string>& sentences) {
  val array = val::array();
  for (const std::string& sentence : sentences) array.call<void>("push", sentence);
  return array;
}

val failure(const Error& error) {
  val inside = val::object();
  inside.set("code", std::string(name_of(error.code)));
  inside.set("message", describe(error));
  if (error.place.vertex) inside.set("vertex", *error.place.vertex);
  if (error.place.face) inside.set("face", *error.place.face);
  val outside = val::object();
  outside.set("error", inside);
  return outside;
}

Frame frame_of(std::span<const Point> points) {
  const Box box = bounding_box(points);
  Frame frame;
  for (std::size_t c = 0; c < 3; ++c) frame.centre[c] = box.low[c] / 2 + box.high[c] / 2;
  if (box.side() > 0) frame.side = box.side();
  return frame;
}

val display(const Mesh& mesh, const Frame& frame) {
  std::vector<float> positions;
  positions.reserve(3 * mesh.points.size());
  for (const Point& p : mesh.points) {
    for (std::size_t c = 0; c < 3; ++c) {
      positions.push_back(static_cast<float>((p[c] - frame.centre[c]) / frame.side));
    }
  }
  std::vector<Index> creases;
  for (const Crease& crease : mesh.creases) {
    if (crease.sharpness > 0) {
      creases.insert(creases.end(), crease.vertices.begin(), crease.vertices.end());
    }
  }
  val shown = val::object();
  shown.set("positions", typed_array<float>("Float32Array", positions));
  shown.set("offsets", indices(mesh.face_offsets));
  shown.set("corners", indices(mesh.face_vertices));
  shown.set("creases", indices(creases));
  val channels = val::object();
  for (const Channel& channel : mesh.channels) {
    if (channel.name == "normal" && channel.width() == 3) {
      shown.set("normals", floats(channel.values));
    } else if (channel.width() == 1) {
      channels.set(channel.name, floats(channel.values));
    }
  }
  shown.set("channels", channels);
  return shown;
}

val history(const std::vector<Iteration>& iterations) {
  val array = val::array();
  for (const Iteration& i : iterations) {
    val entry = val::object();
    entry.set("iteration", i.iteration);
    entry.set("max", i.max);
    entry.set("mean", i.mean);
    array.call<void>("push", entry);
  }
  return array;
}

val to_js(const Certificate& certificate) {
  val found = val::object();
  found.set("max", certificate.max);
  found.set("mean", certificate.mean);
  found.set("boxSide", certificate.box_side);
  found.set("worstVertex", certificate.worst_vertex);
  found.set("evaluator", certificate.evaluator);
  return found;
}

}  // namespace surpass::wasm
