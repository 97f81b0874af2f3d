// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lapcon10.h"

#include "cluster_skeleton.h"
#include "laplacian_contraction.h"
#include "neighborhoods.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using Eigen::Vector3d;
using methods::Cluster;
using methods::Fan;
using methods::Neighbors;
using methods::Positions;
using Vertex_base = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex_base>>;

constexpr double growth = 3;              // s_L
constexpr std::size_t maximum_steps = 20; // in the program; a few are enough
constexpr double least_change = 0.02;     // of the first extents
constexpr double sample_distance = 0.02;  // diagonals

std::size_t number_of_neighbors(std::size_t number_of_points)
{
  const double share = std::round(0.012 * static_cast<double>(number_of_points));
  return static_cast<std::size_t>(std::min(30.0, std::max(8.0, share)));
}

/// Two directions along the plane of the points.
Eigen::Matrix<double, 3, 2> plane_of(const std::vector<Vector3d>& points)
{
  Vector3d mean = Vector3d::Zero();
  for(const Vector3d& p : points)
    mean += p / static_cast<double>(points.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for(const Vector3d& p : points)
    covariance += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance); // ascending
  return solver.eigenvectors().rightCols<2>();
}

/// The triangles at the first of the neighbours, which is the point itself.
Fan fan_of(const std::vector<std::size_t>& neighborhood, const std::vector<Vector3d>& points)
{
  std::vector<Vector3d> near;
  for(const std::size_t i : neighborhood)
    near.push_back(points[i]);
  const Eigen::Matrix<double, 3, 2> plane = plane_of(near);
  Triangulation triangulation;
  Triangulation::Vertex_handle centre;
  for(std::size_t i = 0; i < near.size(); ++i) {
    const Eigen::Vector2d p = plane.transpose() * (near[i] - near[0]);
    const std::size_t size = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert({p.x(), p.y()});
    if(triangulation.number_of_vertices() > size) // not a copy of one before
      vertex->info() = neighborhood[i];
    if(i == 0)
      centre = vertex;
  }
  Fan fan;
  if(triangulation.dimension() < 2)
    return fan;
  const auto first = triangulation.incident_faces(centre);
  auto face = first;
  do {
    const int i = face->index(centre);
    if(!triangulation.is_infinite(face))
      fan.push_back({face->vertex(Triangulation::ccw(i))->info(),
                     face->vertex(Triangulation::cw(i))->info()});
  } while(++face != first);
  return fan;
}

std::vector<Fan> fans_of(const std::vector<Vector3d>& points)
{
  const methods::Point_search search(points);
  const std::size_t k = number_of_neighbors(points.size());
  std::vector<methods::Neighbor> found;
  std::vector<Fan> fans;
  for(std::size_t i = 0; i < points.size(); ++i) {
    search.nearest(points[i], k, found);
    std::vector<std::size_t> neighborhood{i};
    for(const auto& neighbor : found)
      if(neighbor.index != i)
        neighborhood.push_back(neighbor.index);
    fans.push_back(fan_of(neighborhood, points));
  }
  return fans;
}

Neighbors neighbors_of(const std::vector<Fan>& fans)
{
  Neighbors neighbors(fans.size());
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& edge : fans[i])
      neighbors[i].insert(neighbors[i].end(), edge.begin(), edge.end());
  return neighbors;
}

double diagonal_of(const Positions& points)
{
  return (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
}

Positions contract_cloud(const Positions& points, const std::vector<Fan>& fans)
{
  const auto extent = [&fans](const Positions& p) {
    return methods::fan_areas(p, fans).cwiseSqrt().sum();
  };
  const auto does_little = [&](const Positions& first, const Positions& before,
                               const Positions& after) {
    return extent(before) - extent(after) < least_change * extent(first);
  };
  return methods::contract(points, fans, {growth, maximum_steps, does_little});
}

/// Samples such that every point is within `radius` of one: each is the farthest from those before.
/// \param owner becomes the nearest sample of every point
std::vector<Cluster> farthest_samples(const Positions& points, double radius,
                                      std::vector<std::size_t>& owner)
{
  Eigen::VectorXd distance =
      Eigen::VectorXd::Constant(points.rows(), std::numeric_limits<double>::infinity());
  owner.assign(static_cast<std::size_t>(points.rows()), methods::no_cluster);
  std::vector<Cluster> samples;
  for(Eigen::Index farthest = 0; distance[farthest] > radius; distance.maxCoeff(&farthest)) {
    const Eigen::RowVector3d sample = points.row(farthest);
    for(Eigen::Index i = 0; i < points.rows(); ++i) {
      const double to_sample = (points.row(i) - sample).norm();
      if(to_sample < distance[i]) {
        distance[i] = to_sample;
        owner[static_cast<std::size_t>(i)] = samples.size();
      }
    }
    samples.push_back({sample.transpose(), 0, {}});
  }
  return samples;
}

Skeleton thin(const Positions& contracted, double radius, const Neighbors& neighbors)
{
  std::vector<std::size_t> owner;
  std::vector<Cluster> samples = farthest_samples(contracted, radius, owner);
  methods::Cluster_graph graph(std::move(samples), owner, neighbors);
  graph.collapse_triangles();
  return graph.skeleton();
}

} // namespace

Method_result lapcon10(const Method_input& input)
{
  constexpr std::size_t least_points = 4; // fewer have no surface
  if(input.points.size() < least_points)
    throw std::runtime_error("too few points for triangles");
  Method_result result;
  const std::vector<Vector3d> points = methods::to_eigen(input.points);
  Positions positions(static_cast<Eigen::Index>(points.size()), 3);
  for(std::size_t i = 0; i < points.size(); ++i)
    positions.row(static_cast<Eigen::Index>(i)) = points[i];
  const std::vector<Fan> fans = timed_stage(result, "one-rings", [&] { return fans_of(points); });
  const Positions contracted =
      timed_stage(result, "contraction", [&] { return contract_cloud(positions, fans); });
  result.skeleton = timed_stage(result, "thinning", [&] {
    return thin(contracted, sample_distance * diagonal_of(positions), neighbors_of(fans));
  });
  return result;
}
