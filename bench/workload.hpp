// One mesh of each size, as a value, as files, and with the results that everybody must reach.
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "generate.hpp"
#include "loop_system.hpp"

namespace surpass::bench {

/// Vertices a side of the square grids that are measured: 16 thousand, 250 thousand, a million.
inline constexpr Index kSides[] = {128, 500, 1000};

/// Four million, for the solve alone.
inline constexpr Index kLargestSide = 2000;

/// From a hundred to a million, for what is to show how it grows.
inline constexpr Index kGrowingSides[] = {10, 32, 100, 316, 1000};

/// What is asked of every solver: distance from given to limit points relative to the box side.
inline constexpr double kTolerance = 1e-10;

class Workload {
 public:
  Workload(Index side, const std::filesystem::path& folder);
  ~Workload();
  Workload(const Workload&) = delete;
  Workload& operator=(const Workload&) = delete;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }
  /// As many vertices, in quads.
  [[nodiscard]] const Mesh& quads() const;
  [[nodiscard]] const std::string& obj() const { return obj_; }
  [[nodiscard]] const std::string& ply() const { return ply_; }

  /// Largest distance of two point lists in order, relative to the box side; infinite where their
  /// lengths differ.
  [[nodiscard]] double difference(std::span<const Point> a, std::span<const Point> b) const;

  /// Limit points of the mesh's own points taken as control points.
  [[nodiscard]] const std::vector<Point>& limits() const { return limits_; }
  /// Largest distance between the limit of these control points and the mesh's points.
  [[nodiscard]] double interpolation_error(std::span<const Point> control) const;
  /// The control points as the library finds them at a tolerance far below what is measured.
  [[nodiscard]] const std::vector<Point>& control() const;

 private:
  Index side_;
  Mesh mesh_;
  mutable Mesh quads_;  // on first demand
  double box_side_;
  std::string obj_;
  std::string ply_;
  RowMatrix limit_matrix_;
  std::vector<Point> limits_;
  mutable std::vector<Point> control_;  // on first demand
};

/// Workloads by side, made when they are first asked for.
class Workloads {
 public:
  explicit Workloads(std::filesystem::path folder) : folder_(std::move(folder)) {}
  const Workload& operator[](Index side);

 private:
  std::filesystem::path folder_;
  std::map<Index, std::unique_ptr<Workload>> made_;
};

}  // namespace surpass::bench
