#include "reconstruct/simplify.hpp"

#include <surpass/topology.hpp>

#include <algorithm>
#include <cmath>
#include <queue>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "reconstruct/collapse_guards.hpp"
#include "reconstruct/collapse_mesh.hpp"
#include "reconstruct/lines.hpp"
#include "reconstruct/quadric.hpp"
#include "reconstruct/vectors.hpp"

namespace surpass::reconstruction {
namespace {

using Eigen::Vector3d;

constexpr double kLongestToMean = 2.0;  // edges beside the mean edge of the result
constexpr double kMoreLength = 1.25;    // the longest edge grows by this where nothing else is left
constexpr int kMostGrowth = 8;
// Where planes do not tell collapses apart, short edges go first.
constexpr double kLengthInCost = 1e-8;

struct Candidate {
  double key = 0;
  Index vertex = 0;
  Index into = 0;
  Index version = 0;
  // For a queue that gives the smallest key first.
  [[nodiscard]] bool operator<(const Candidate& other) const {
    return key != other.key ? key > other.key : vertex > other.vertex;
  }
};

class Simplification {
 public:
  Simplification(const Mesh& mesh, const Topology& topology, const Features& features,
                 const SimplifyLimits& limits, const Context& context)
      : topology_(topology),
        limits_(limits),
        context_(context),
        triangles_(mesh),
        lines_(topology, features),
        quadrics_(mesh.points.size()),
        version_(mesh.points.size(), 0),
        boundary_(mesh.points.size(), 0),
        guards_(triangles_, points_, boundary_) {
    for (const Point& p : mesh.points) points_.push_back(as_vector(p));
    for (Index v = 0; v < topology.vertex_count(); ++v) {
      if (topology.outgoing(v) == kNone) continue;
      ++left_;
      boundary_[v] = topology.is_boundary(v) ? 1 : 0;
    }
    at_first_ = left_;
    add_planes(features);
  }

  [[nodiscard]] std::size_t vertices_left() const { return left_; }
  [[nodiscard]] std::vector<std::array<Index, 2>> creases() const { return lines_.creases(); }

  // The mean edge of an even triangulation of this surface.
  [[nodiscard]] double mean_edge(std::size_t vertices) const {
    return std::sqrt(2 * area_ / (std::sqrt(3.0) * static_cast<double>(vertices)));
  }

  // Collapses what is allowed with edges up to this length; 0 is any.
  Result<void> run(double longest_edge) {
    guards_.set_longest_edge(longest_edge);
    queue_ = {};
    for (Index v = 0; v < points_.size(); ++v) {
      if (v % 1024 == 0) {
        if (const auto going = look_up(); !going) return going;
      }
      offer(v);
    }
    for (std::size_t step = 0; !queue_.empty() && !is_done(); ++step) {
      if (step % 1024 == 0) {
        if (const auto going = look_up(); !going) return going;
      }
      const Candidate candidate = queue_.top();
      queue_.pop();
      if (candidate.version != version_[candidate.vertex]) continue;
      triangles_.neighbours(candidate.vertex, around_);
      if (guards_.allow(candidate.vertex, candidate.into, around_)) {
        collapse(candidate.vertex, candidate.into);
      } else {
        offer(candidate.vertex);  // a valence nearby has changed
      }
    }
    return {};
  }

  [[nodiscard]] bool is_done() const { return limits_.vertices && left_ <= *limits_.vertices; }

  [[nodiscard]] std::vector<Index> faces() const {
    std::vector<Index> vertices;
    for (Index f = 0; f < triangles_.face_count(); ++f) {
      if (triangles_.is_gone(f)) continue;
      for (Index c = 3 * f; c < 3 * f + 3; ++c) vertices.push_back(triangles_.vertex(c));
    }
    return vertices;
  }

 private:
  void add_planes(const Features& features) {
    for (Index h = 0; h < topology_.corner_count(); h += 3) {
      const std::array<Index, 3> face = {topology_.tail(h), topology_.tail(h + 1),
                                         topology_.tail(h + 2)};
      const Vector3d cross = normal_of(face);
      area_ += cross.norm() / 2;
      if (!(cross.norm() > 0)) continue;
      for (const Index v : face) quadrics_[v].add_plane(cross.normalized(), points_[v]);
    }
    for (Index h = 0; h < topology_.corner_count(); ++h) {
      if (topology_.opposite(h) == kNone) add_upright_plane(h);
    }
    for (const auto& [a, b] : features.creases) {
      topology_.for_each_outgoing(a, [&, b = b](Index h) {
        if (topology_.head(h) == b) {
          add_upright_plane(h);
          if (topology_.opposite(h) != kNone) add_upright_plane(topology_.opposite(h));
        }
      });
    }
  }

  [[nodiscard]] Vector3d normal_of(const std::array<Index, 3>& face) const {
    return (points_[face[1]] - points_[face[0]]).cross(points_[face[2]] - points_[face[0]]);
  }

  // Holds a boundary or crease in place: the plane through the edge that stands on its face.
  void add_upright_plane(Index h) {
    const Index a = topology_.tail(h);
    const Index b = topology_.head(h);
    const Index c = topology_.head(topology_.next(h));
    const Vector3d upright = (points_[b] - points_[a]).cross(normal_of({a, b, c}));
    if (!(upright.norm() > 0)) return;
    for (const Index v : {a, b}) quadrics_[v].add_plane(upright.normalized(), points_[v]);
  }

  [[nodiscard]] Result<void> look_up() const {
    context_.report({.stage = "simplify", .fraction = share_done()});
    if (!context_.cancelled()) return {};
    return fail(ErrorCode::cancelled, "the simplification was interrupted");
  }

  [[nodiscard]] double share_done() const {
    const double goal = limits_.vertices ? static_cast<double>(*limits_.vertices) : 0;
    const double all = static_cast<double>(at_first_) - goal;
    return all > 0 ? static_cast<double>(at_first_ - left_) / all : 1;
  }

  // Puts the best collapse of v into the queue; older ones of v count no longer.
  void offer(Index v) {
    ++version_[v];
    if (lines_.freedom(v) == Freedom::nowhere) return;
    triangles_.neighbours(v, around_);
    options_.clear();
    for (const Index w : around_) {
      if (!lines_.allows(v, w)) continue;
      Quadric sum = quadrics_[v];
      sum.add(quadrics_[w]);
      const double cost = std::max(sum.at(points_[w]), 0.0);
      if (limits_.cost && cost > *limits_.cost) continue;
      const double length = (points_[w] - points_[v]).squaredNorm();
      options_.push_back({cost + kLengthInCost * length, v, w, version_[v]});
    }
    std::sort(options_.begin(), options_.end(), [](const Candidate& a, const Candidate& b) {
      return a.key != b.key ? a.key < b.key : a.into < b.into;
    });
    for (const Candidate& option : options_) {
      if (!guards_.allow(v, option.into, around_)) continue;
      queue_.push(option);
      return;
    }
  }

  void collapse(Index v, Index w) {
    triangles_.collapse(v, w);
    lines_.collapse(v, w);
    quadrics_[w].add(quadrics_[v]);
    ++version_[v];
    --left_;
    triangles_.neighbours(w, changed_);
    changed_.push_back(w);
    for (const Index u : changed_) offer(u);
  }

  const Topology& topology_;
  const SimplifyLimits& limits_;
  const Context& context_;
  std::vector<Vector3d> points_;
  CollapseMesh triangles_;
  Lines lines_;
  std::vector<Quadric> quadrics_;
  std::vector<Index> version_;
  std::vector<unsigned char> boundary_;
  CollapseGuards guards_;
  std::priority_queue<Candidate> queue_;
  std::size_t left_ = 0;
  std::size_t at_first_ = 0;
  double area_ = 0;
  // Kept between calls for their memory.
  std::vector<Index> around_;
  std::vector<Index> changed_;
  std::vector<Candidate> options_;
};

// How many vertices the costs alone would leave; the longest edge follows from it.
Result<std::size_t> vertices_without_length_guard(const Mesh& mesh, const Topology& topology,
                                                  const Features& features,
                                                  const SimplifyLimits& limits,
                                                  const Context& context) {
  Simplification trial(mesh, topology, features, limits, context);
  if (const auto done = trial.run(0); !done) return tl::make_unexpected(done.error());
  return trial.vertices_left();
}

}  // namespace

Result<Mesh> simplify(const Mesh& mesh, Features& features, const SimplifyLimits& limits,
                      const Context& context) {
  const auto topology = Topology::build(mesh);
  if (!topology) return tl::make_unexpected(topology.error());
  std::size_t goal = limits.vertices.value_or(0);
  if (limits.cost) {
    const auto found = vertices_without_length_guard(mesh, *topology, features, limits, context);
    if (!found) return tl::make_unexpected(found.error());
    goal = std::max(goal, *found);
  }
  Simplification work(mesh, *topology, features, limits, context);
  double longest = kLongestToMean * work.mean_edge(std::max<std::size_t>(goal, 4));
  // With a tolerance the goal is but a guess; a number of vertices is what was asked for.
  const int rounds = limits.cost ? 1 : kMostGrowth;
  for (int round = 0; round < rounds && (round == 0 || !work.is_done()); ++round) {
    if (const auto done = work.run(longest); !done) return tl::make_unexpected(done.error());
    longest *= kMoreLength;
  }
  Mesh result = mesh;
  result.face_vertices = work.faces();
  result.face_offsets.clear();
  for (std::size_t c = 0; c <= result.face_vertices.size(); c += 3) {
    result.face_offsets.push_back(static_cast<Index>(c));
  }
  features.creases = work.creases();
  return result;
}

}  // namespace surpass::reconstruction
