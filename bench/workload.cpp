#include "workload.hpp"

#include <surpass/interpolate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include <fmt/format.h>

#include "mesh_files.hpp"

namespace surpass::bench {
namespace {

double largest_side(std::span<const Point> points) {
  Point low = points.front();
  Point high = low;
  for (const Point& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  return std::max({high[0] - low[0], high[1] - low[1], high[2] - low[2]});
}

}  // namespace

Workload::Workload(Index side, const std::filesystem::path& folder)
    : side_(side),
      mesh_(generate_torus(side, side, Order::mild)),
      box_side_(largest_side(mesh_.points)),
      obj_((folder / fmt::format("torus{}.obj", side)).string()),
      ply_((folder / fmt::format("torus{}.ply", side)).string()),
      limit_matrix_(limit_matrix(mesh_)),
      limits_(as_points(limit_matrix_ * as_rows(mesh_.points))) {
  std::filesystem::create_directories(folder);
  write_obj(mesh_, obj_);
  write_ply(mesh_, ply_);
}

Workload::~Workload() {
  std::remove(obj_.c_str());
  std::remove(ply_.c_str());
}

const Mesh& Workload::quads() const {
  if (quads_.points.empty()) quads_ = generate_quad_torus(side_, side_);
  return quads_;
}

double Workload::difference(std::span<const Point> a, std::span<const Point> b) const {
  if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1], a[i][2] - b[i][2]);
    if (!(d <= largest)) largest = d;  // a NaN stays
  }
  return largest / box_side_;
}

double Workload::interpolation_error(std::span<const Point> control) const {
  return difference(as_points(limit_matrix_ * as_rows(control)), mesh_.points);
}

const std::vector<Point>& Workload::control() const {
  if (control_.empty()) {
    auto solved = interpolate(mesh_, {.tolerance = 1e-14});
    if (!solved) throw std::runtime_error(describe(solved.error()));
    control_ = std::move(solved->control.points);
  }
  return control_;
}

const Workload& Workloads::operator[](Index side) {
  auto& workload = made_[side];
  if (!workload) workload = std::make_unique<Workload>(side, folder_);
  return *workload;
}

}  // namespace surpass::bench
