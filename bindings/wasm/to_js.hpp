// From the library's values to what JavaScript holds.
#pragma once

#include <surpass/interpolate.hpp>
#include <surpass/quality.hpp>
#include <surpass/result.hpp>

#include <span>
#include <string>
#include <vector>

#include <emscripten/val.h>

namespace surpass::wasm {

using emscripten::val;

/// A copy of the numbers as a typed array of that name ("Uint32Array").
template <class Number>
[[nodiscard]] val typed_array(const char* name, std::span<const Number> numbers) {
  return val::global(name).new_(val(emscripten::typed_memory_view(numbers.size(), numbers.data())));
}
[[nodiscard]] val floats(std::span<const double> numbers);
[[nodiscard]] val indices(std::span<const Index> numbers);
[[nodiscard]] val bytes(const std::string& text);
[[nodiscard]] val strings(const std::vector<std::string>& sentences);

/// {error: {code, message, vertex?, face?}}; the message has the place in words.
[[nodiscard]] val failure(const Error& error);

/// How a mesh is put before the camera: its centre goes to the origin, its box side to 1. Single
/// precision is enough for what is left.
struct Frame {
  Point centre = {};
  double side = 1;
};
[[nodiscard]] Frame frame_of(std::span<const Point> points);

/// {positions, normals?, offsets, corners, creases, channels: {name: Float32Array}}, in the frame.
/// Of the channels only those of one column are handed on.
[[nodiscard]] val display(const Mesh& mesh, const Frame& frame);

/// [{iteration, max, mean}, ...]
[[nodiscard]] val history(const std::vector<Iteration>& iterations);
[[nodiscard]] val to_js(const Certificate& certificate);

}  // namespace surpass::wasm
