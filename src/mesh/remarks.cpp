#include "mesh/remarks.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mesh/coincident.hpp"
#include "mesh/wording.hpp"

namespace surpass {
namespace {

// A list that is cut after the first few: "3, 8, 9 and 14 more".
class Naming {
 public:
  explicit Naming(std::size_t limit) : limit_(limit) {}
  void add(const std::string& element) {
    if (++count_ > limit_) return;
    text_ += (text_.empty() ? "" : ", ") + element;
  }
  void add(Index element) {
    if (count_ < limit_) return add(std::to_string(element));
    ++count_;
  }
  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] std::string text() const {
    if (count_ <= limit_) return text_;
    return text_ + fmt::format(" and {} more", count_ - limit_);
  }

 private:
  std::size_t limit_;
  std::size_t count_ = 0;
  std::string text_;
};

class Remarker {
 public:
  Remarker(const Mesh& mesh, std::span<const unsigned char> skip, std::size_t limit)
      : mesh_(mesh), skip_(skip), limit_(limit) {}

  std::vector<std::string> run(const Topology* topology) {
    if (mesh_.face_count() == 0) remarks_.emplace_back("the mesh has no faces");
    if (topology != nullptr) {
      remark_on_bowties(*topology);
      remark_on_back_to_back(*topology);
      remark_on_creases(*topology);
    }
    remark_on_isolated();
    remark_on_coincident();
    remark_on_shapes();
    remark_on_size();
    return std::move(remarks_);
  }

 private:
  void add(const Naming& elements, std::string_view one, std::string_view many,
           std::string_view rest) {
    if (elements.count() == 0) return;
    remarks_.push_back(
        fmt::format("{} {}: {}", counted(elements.count(), one, many), rest, elements.text()));
  }

  void remark_on_bowties(const Topology& topology) {
    Naming bowties(limit_);
    for (Index v = 0; v < topology.vertex_count(); ++v) {
      if (topology.is_bowtie(v)) bowties.add(v);
    }
    add(bowties, "vertex", "vertices",
        "where several fans of faces meet (bow-ties), treated as infinitely sharp");
  }

  // Two faces that are each other's only neighbour.
  void remark_on_back_to_back(const Topology& topology) {
    Naming faces(limit_);
    for (Index f = 0; f < topology.face_count(); ++f) {
      const Index first = topology.opposite(topology.face_begin(f));
      if (first == kNone || topology.face(first) > f) continue;
      bool same = topology.face_degree(topology.face(first)) == topology.face_degree(f);
      for (Index h = topology.face_begin(f); same && h < topology.face_end(f); ++h) {
        const Index other = topology.opposite(h);
        same = other != kNone && topology.face(other) == topology.face(first);
      }
      if (same) faces.add(fmt::format("{} on {}", f, topology.face(first)));
    }
    add(faces, "face", "faces", "back to back with another, a closed surface without volume");
  }

  void remark_on_creases(const Topology& topology) {
    std::vector<std::array<Index, 2>> edges;
    if (mesh_.creases.empty()) return;
    for (Index e = 0; e < topology.edge_count(); ++e) edges.push_back(topology.edge_vertices(e));
    for (auto& [a, b] : edges) {
      if (a > b) std::swap(a, b);
    }
    std::sort(edges.begin(), edges.end());
    Naming lost(limit_);
    for (const Crease& crease : mesh_.creases) {
      const auto [a, b] = crease.vertices;
      const std::array<Index, 2> edge{std::min(a, b), std::max(a, b)};
      if (!std::binary_search(edges.begin(), edges.end(), edge)) {
        lost.add(fmt::format("{}-{}", a, b));
      }
    }
    add(lost, "crease", "creases", "between vertices that no edge joins, without effect");
  }

  void remark_on_isolated() {
    std::vector<unsigned char> used(mesh_.points.size(), 0);
    for (const Index v : mesh_.face_vertices) {
      if (v < used.size()) used[v] = 1;
    }
    Naming isolated(limit_);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (used[v] == 0) isolated.add(v);
    }
    add(isolated, "vertex", "vertices", "without faces, kept and fixed");
  }

  void remark_on_coincident() {
    const auto target = merge_targets(mesh_.points, 0);
    Naming coincident(limit_);
    for (Index v = 0; v < mesh_.vertex_count(); ++v) {
      if (target[v] != v) coincident.add(fmt::format("{} on {}", v, target[v]));
    }
    add(coincident, "vertex", "vertices",
        "with exactly the coordinates of another (a weld by 0 would merge them)");
  }

  void remark_on_shapes() {
    Naming flat(limit_);
    Naming short_edges(limit_);
    for (Index f = 0; f < mesh_.face_count(); ++f) {
      if (skip_[f] != 0) continue;
      const auto face = mesh_.face(f);
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Index a = face[i == 0 ? face.size() - 1 : i - 1];
        if (mesh_.points[a] == mesh_.points[face[i]]) {
          short_edges.add(fmt::format("{}-{}", a, face[i]));
        }
      }
      if (is_flat(f)) flat.add(f);
    }
    add(flat, "face", "faces", "of zero area up to rounding");
    add(short_edges, "edge of a face", "edges of faces", "of zero length");
  }

  // Area against the square of the face's own size: a needle is not flat, a collinear face is.
  [[nodiscard]] bool is_flat(Index f) const {
    constexpr double kRounding = 1e-15;
    const auto face = mesh_.face(f);
    const Point& origin = mesh_.points[face[0]];
    double size = 0;
    for (const Index v : face) {
      for (std::size_t k = 0; k < 3; ++k) {
        size = std::max(size, std::abs(mesh_.points[v][k] - origin[k]));
      }
    }
    if (size == 0) return true;
    const auto at = [&](Index v, std::size_t k) { return (mesh_.points[v][k] - origin[k]) / size; };
    Point normal = {};
    for (std::size_t i = 2; i < face.size(); ++i) {
      const Index p = face[i - 1];
      const Index q = face[i];
      normal[0] += at(p, 1) * at(q, 2) - at(p, 2) * at(q, 1);
      normal[1] += at(p, 2) * at(q, 0) - at(p, 0) * at(q, 2);
      normal[2] += at(p, 0) * at(q, 1) - at(p, 1) * at(q, 0);
    }
    return std::hypot(normal[0], normal[1], normal[2]) <= kRounding;
  }

  void remark_on_size() {
    // Squares of lengths stay in the range of a double between these.
    constexpr double kHuge = 1e150;
    constexpr double kTiny = 1e-150;
    if (mesh_.points.empty()) return;
    const Box box = bounding_box(mesh_.points);
    double largest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      largest = std::max({largest, std::abs(box.low[k]), std::abs(box.high[k])});
    }
    if (box.side() == 0) {
      remarks_.emplace_back("all vertices lie at one point: the bounding box has side 0");
    } else if (largest > kHuge) {
      remarks_.push_back(fmt::format(
          "coordinates as large as {}: squares of lengths overflow, scale the mesh down", largest));
    } else if (box.side() < kTiny) {
      remarks_.push_back(fmt::format(
          "a bounding box of side {}: squares of lengths vanish, scale the mesh up", box.side()));
    }
  }

  const Mesh& mesh_;
  std::span<const unsigned char> skip_;
  std::size_t limit_;
  std::vector<std::string> remarks_;
};

}  // namespace

std::vector<std::string> remarks_on(const Mesh& mesh, const Topology* topology,
                                    std::span<const unsigned char> skip, std::size_t limit) {
  return Remarker(mesh, skip, limit).run(topology);
}

}  // namespace surpass
