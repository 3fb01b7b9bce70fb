// Point clouds with known surfaces, and what a reconstruction owes.
#pragma once

#include <surpass/reconstruct.hpp>
#include <surpass/surpass.hpp>

#include <random>
#include <vector>

#include <Eigen/Core>
#include <gtest/gtest.h>

namespace surpass::test {

using Cloud = std::vector<Point>;

inline Eigen::Vector3d vec(const Point& p) { return {p[0], p[1], p[2]}; }

/// Nearly evenly spread over the unit sphere.
Cloud sphere_cloud(std::size_t n);
/// Random, even in area, on the torus of radii 1 and 0.4.
Cloud torus_cloud(std::size_t n, std::uint64_t seed);
/// On a Loop surface of genus 2 through the vertices of data/double_torus.obj.
Cloud double_torus_cloud();
/// An n by n by n grid's surface points of the unit cube, edges and corners among them.
Cloud cube_cloud(int n);
/// z = 0.3 sin(3 x) cos(2 y) over the unit square, at n by n places moved a little.
Cloud wave_cloud(int n);

/// Every coordinate moved by a normal variate.
Cloud with_noise(Cloud cloud, double sigma, std::uint64_t seed);
/// `count` points more, even in a cube of twice the box.
Cloud with_outliers(Cloud cloud, std::size_t count, std::uint64_t seed);
/// In another order.
Cloud shuffled(Cloud cloud, std::uint64_t seed);

/// Of a closed triangle mesh.
double volume(const Mesh& mesh);

/// Vertices are the points that `source` names, bit for bit.
void expect_input_points(const Reconstruction& found, const Cloud& given);
/// A manifold without boundary, in one piece, of this genus, looking outward.
void expect_closed(const Reconstruction& found, std::size_t genus);

/// Reconstructs; the test fails where that fails.
Reconstruction reconstructed(const Cloud& cloud, const ReconstructOptions& options = {});

/// The distance of p to the mesh, by looking at every triangle (cut into segments and a height).
double slow_distance(const Point& p, const Mesh& mesh);

}  // namespace surpass::test
