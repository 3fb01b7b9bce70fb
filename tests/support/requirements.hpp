// Requirements, as tests write them down.
#pragma once

#include <surpass/requirements.hpp>

#include <array>

namespace surpass::test {

inline Requirement at_vertex(Requirement::Kind kind, Index vertex, const Point& value = {}) {
  Requirement r;
  r.kind = kind;
  r.vertex = vertex;
  r.value = value;
  return r;
}

/// On the way from `vertex` to its neighbour.
inline Requirement towards(Requirement::Kind kind, Index vertex, Index neighbour,
                           const Point& value) {
  Requirement r = at_vertex(kind, vertex, value);
  r.towards = neighbour;
  return r;
}

inline Requirement on_face(Requirement::Kind kind, const SurfacePlace& place, const Point& value,
                           const std::array<double, 2>& along = {1, 0}) {
  Requirement r;
  r.kind = kind;
  r.place = place;
  r.value = value;
  r.along = along;
  return r;
}

}  // namespace surpass::test
