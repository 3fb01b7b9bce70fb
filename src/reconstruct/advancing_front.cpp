#include "reconstruct/advancing_front.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <iterator>
#include <list>
#include <memory>
#include <numeric>
#include <tuple>

#include <CGAL/Advancing_front_surface_reconstruction.h>
#include <CGAL/Delaunay_triangulation_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/assertions_behaviour.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>
#include <fmt/format.h>

#include "reconstruct/nodes_in_order.hpp"

namespace surpass::reconstruction {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

// CGAL compares vertices and cells by these stamps, which tell who was made first; without them by
// address, which is chance. That the type is ours makes others ours, too, that depend on it: one of
// them has its allocator replaced below.
template <class Base>
class Stamped : public Base {
 public:
  using Base::Base;
  using Has_timestamp = CGAL::Tag_true;  // NOLINT(readability-identifier-naming): CGAL's names
  template <class Structure>
  struct Rebind_TDS {  // NOLINT(readability-identifier-naming)
    using Other = Stamped<typename Base::template Rebind_TDS<Structure>::Other>;
  };
  [[nodiscard]] std::size_t time_stamp() const { return stamp_; }
  void set_time_stamp(std::size_t stamp) { stamp_ = stamp; }

 private:
  std::size_t stamp_ = static_cast<std::size_t>(-1);
};

using VertexBase = CGAL::Advancing_front_surface_reconstruction_vertex_base_3<
    Kernel, Stamped<CGAL::Triangulation_vertex_base_3<Kernel>>>;
using CellBase = CGAL::Advancing_front_surface_reconstruction_cell_base_3<
    Kernel, Stamped<CGAL::Delaunay_triangulation_cell_base_3<Kernel>>>;
using Delaunay =
    CGAL::Delaunay_triangulation_3<Kernel,
                                   CGAL::Triangulation_data_structure_3<VertexBase, CellBase>>;
using BorderEdge = Delaunay::Vertex::Next_border_elt;

}  // namespace
}  // namespace surpass::reconstruction

// CGAL has its border edges in a std::list, and asks nobody for an allocator of its nodes.
// Elsewhere than in GNU's library their order stays a matter of chance.
#ifdef __GLIBCXX__
template <>
struct std::allocator<std::_List_node<surpass::reconstruction::BorderEdge>>
    : surpass::reconstruction::InOrder<std::_List_node<surpass::reconstruction::BorderEdge>> {
  allocator() = default;
  template <class U>
  explicit allocator(const std::allocator<U>& /*all are alike*/) {}
};
#endif

namespace surpass::reconstruction {
namespace {

// Leaves CGAL's loops, which know no cancellation.
struct Cancelled : std::exception {};

// While it lives, failed checks of CGAL's throw instead of ending the program, and say nothing.
class ThrowingChecks {
 public:
  ThrowingChecks()
      : error_(CGAL::set_error_behaviour(CGAL::THROW_EXCEPTION)),
        handler_(CGAL::set_error_handler(say_nothing)) {}
  ~ThrowingChecks() {
    CGAL::set_error_behaviour(error_);
    CGAL::set_error_handler(handler_);
  }
  ThrowingChecks(const ThrowingChecks&) = delete;
  ThrowingChecks& operator=(const ThrowingChecks&) = delete;

 private:
  static void say_nothing(const char*, const char*, const char*, int, const char*) {}
  CGAL::Failure_behaviour error_;
  CGAL::Failure_function handler_;
};

// The radius of the smallest empty sphere, as by default, for triangles that are short enough. CGAL
// asks for it a few times a point, so this is also where the front looks up from its work.
class Priority {
 public:
  Priority(double perimeter, std::size_t points, const Context& context, std::size_t& asked)
      : perimeter_(perimeter), expected_(8 * points), context_(&context), asked_(&asked) {}

  template <class Front, class Cell>
  double operator()(const Front& front, const Cell& cell, const int& index) const {
    if (++*asked_ % 1024 == 0) look_up();
    if (perimeter_ > 0 && longer_than_allowed(cell, index)) return front.infinity();
    return front.smallest_radius_delaunay_sphere(cell, index);
  }

 private:
  void look_up() const {
    if (context_->cancelled()) throw Cancelled();
    const double share = static_cast<double>(*asked_) / static_cast<double>(expected_);
    context_->report({.stage = "front", .fraction = std::min(share, 0.99)});
  }

  template <class Cell>
  [[nodiscard]] bool longer_than_allowed(const Cell& cell, int index) const {
    double length = 0;
    for (int k = 1; k <= 3; ++k) {
      const auto& a = cell->vertex((index + k) % 4)->point();
      const auto& b = cell->vertex((index + k % 3 + 1) % 4)->point();
      length += std::sqrt(CGAL::to_double(CGAL::squared_distance(a, b)));
      if (length > perimeter_) return true;
    }
    return false;
  }

  double perimeter_;
  std::size_t expected_;
  const Context* context_;
  std::size_t* asked_;  // CGAL copies the functor
};

Delaunay triangulate(std::span<const Point> points, const Context& context) {
  std::vector<Kernel::Point_3> sites;
  sites.reserve(points.size());
  for (const Point& p : points) sites.emplace_back(p[0], p[1], p[2]);
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto map = CGAL::make_property_map(sites);
  using Traits = CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(map)>;
  CGAL::spatial_sort(order.begin(), order.end(), Traits(map));

  Delaunay triangulation;
  Delaunay::Cell_handle hint;
  std::size_t done = 0;
  for (const std::size_t i : order) {
    if (done++ % 1024 == 0) {
      if (context.cancelled()) throw Cancelled();
      const double share = static_cast<double>(done) / static_cast<double>(points.size());
      context.report({.stage = "delaunay", .fraction = share});
    }
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert(sites[i], hint);
    if (triangulation.number_of_vertices() > before) vertex->id() = i;
    hint = vertex->cell();
  }
  return triangulation;
}

std::vector<Triangle> run_front(std::span<const Point> points, double perimeter,
                                const Context& context) {
  Delaunay triangulation = triangulate(points, context);
  if (triangulation.dimension() < 2) return {};
  std::size_t asked = 0;
  // Two border edges a vertex, each in a node with two pointers more.
  NodesInOrder nodes(2 * points.size() * (sizeof(BorderEdge) + 4 * sizeof(void*)));
  using Front = CGAL::Advancing_front_surface_reconstruction<Delaunay, Priority>;
  Front front(triangulation, Priority(perimeter, points.size(), context, asked));
  front.run();
  std::vector<std::array<std::size_t, 3>> found;
  CGAL::write_triple_indices(std::back_inserter(found), front);
  std::vector<Triangle> triangles;
  triangles.reserve(found.size());
  for (const auto& [a, b, c] : found) {
    Triangle t = {static_cast<Index>(a), static_cast<Index>(b), static_cast<Index>(c)};
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    triangles.push_back(t);
  }
  // CGAL's order follows addresses too, and so do the sides that pieces are seen from.
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return std::tuple(a[0], std::minmax(a[1], a[2])) < std::tuple(b[0], std::minmax(b[1], b[2]));
  });
  return triangles;
}

}  // namespace

Result<std::vector<Triangle>> advancing_front(std::span<const Point> points, double perimeter,
                                              const Context& context) {
  const ThrowingChecks checks;
  try {
    return run_front(points, perimeter, context);
  } catch (const Cancelled&) {
    return fail(ErrorCode::cancelled, "the reconstruction was interrupted");
  } catch (const std::bad_alloc&) {
    return fail(ErrorCode::too_large, "there is not enough memory to connect so many points");
  } catch (const std::exception& error) {
    return fail(ErrorCode::singular,
                fmt::format("CGAL could not connect the points: {}", error.what()));
  }
}

}  // namespace surpass::reconstruction
