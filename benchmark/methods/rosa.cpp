// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "rosa.h"

#include "cluster_skeleton.h"
#include "neighborhoods.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <queue>
#include <stdexcept>
#include <utility>
#include <vector>

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using methods::Point_search;
using methods::Neighbors;
using methods::no_cluster;
using Eigen_solver = Eigen::SelfAdjointEigenSolver<Matrix3d>;

constexpr std::size_t surface_neighbors = 10;
constexpr double squash = 2;             // added to distances along the normal, per such distance
constexpr double half_thickness = 1.5;   // of a slab, in mean distances of neighbours
constexpr int orientation_steps = 6;     // from axes that are mostly right
constexpr double least_spread = 0.05;    // of the normals of a cut that has a centre; 0.5 if round
constexpr int thinning_steps = 3;        // then centres are on curves
constexpr double thinning_radius = 0.05; // share of the diagonal
constexpr double least_linearity = 0.8;  // share of the variance along a line
constexpr double sample_radius = 0.02;   // share of the diagonal
constexpr double least_size = 0.2;       // of a sample, in mean sizes
constexpr double stretch = 3;            // a detour as long as this is none
constexpr double mean_share = 0.3;       // of the mean of the points in the new centre

// A cloud with normals and, for every point, its neighbours on the same side of the surface.
struct Cloud
{
  std::vector<Vector3d> points, normals;
  Neighbors neighbors;
  double spacing;
};

double squashed_distance(const Cloud& cloud, std::size_t i, std::size_t j)
{
  const Vector3d& n = cloud.normals[j];
  const Vector3d d = cloud.points[i] - cloud.points[j];
  return (d + squash * d.dot(n) * n).norm();
}

// Of the nearest points, twice as many as wanted, those with the smallest squashed distances.
void find_neighbors(Cloud& cloud)
{
  const Neighbors candidates = methods::nearest_others(methods::Point_search(cloud.points),
                                                       cloud.points, 2 * surface_neighbors);
  cloud.neighbors.assign(cloud.points.size(), {});
  double sum = 0, count = 0;
  for(std::size_t i = 0; i < cloud.points.size(); ++i) {
    std::vector<std::pair<double, std::size_t>> near;
    for(const std::size_t j : candidates[i])
      if(cloud.normals[i].dot(cloud.normals[j]) > 0)
        near.emplace_back(std::max(squashed_distance(cloud, i, j), squashed_distance(cloud, j, i)),
                          j);
    std::sort(near.begin(), near.end());
    near.resize(std::min(near.size(), surface_neighbors));
    for(const auto& neighbor : near) {
      cloud.neighbors[i].push_back(neighbor.second);
      sum += (cloud.points[i] - cloud.points[neighbor.second]).norm();
      ++count;
    }
  }
  cloud.spacing = sum / count;
}

// The points around point `i` that a slab through it, of the given axis, cuts off.
class Planar_cut
{
public:
  explicit Planar_cut(const Cloud& cloud)
      : cloud_(cloud)
      , visit_(cloud.points.size(), 0)
  {}

  const std::vector<std::size_t>& operator()(std::size_t i, const Vector3d& axis)
  {
    ++visits_;
    visit_[i] = visits_;
    cut_.assign(1, i);
    for(std::size_t next = 0; next < cut_.size(); ++next)
      for(const std::size_t j : cloud_.neighbors[cut_[next]]) {
        const double height = (cloud_.points[j] - cloud_.points[i]).dot(axis);
        if(visit_[j] != visits_ && std::abs(height) < half_thickness * cloud_.spacing) {
          visit_[j] = visits_;
          cut_.push_back(j);
        }
      }
    return cut_;
  }

private:
  const Cloud& cloud_;
  std::vector<std::size_t> visit_, cut_;
  std::size_t visits_ = 0;
};

struct Axis
{
  Vector3d direction;
  double variance; // of the cosines of the angles between it and the normals
};

// The axis most normals of the set are equally inclined to.
Axis symmetry_axis(const Cloud& cloud, const std::vector<std::size_t>& set)
{
  Vector3d sum = Vector3d::Zero();
  Matrix3d squares = Matrix3d::Zero();
  for(const std::size_t i : set) {
    sum += cloud.normals[i];
    squares += cloud.normals[i] * cloud.normals[i].transpose();
  }
  const double size = static_cast<double>(set.size());
  const Eigen_solver solver(squares / size - sum * sum.transpose() / (size * size));
  return {solver.eigenvectors().col(0), std::max(0.0, solver.eigenvalues()[0])};
}

// An axis per point that its neighbours' axes agree with best, those of low variance above all.
std::vector<Vector3d> smoothed(const std::vector<Axis>& axes, const Neighbors& neighbors)
{
  std::vector<Vector3d> result;
  for(std::size_t i = 0; i < axes.size(); ++i) {
    Matrix3d sum = Matrix3d::Zero();
    const auto add = [&](const Axis& axis) {
      constexpr double epsilon = 1e-5; // a variance that is as good as none
      sum +=
          axis.direction * axis.direction.transpose() / (epsilon + axis.variance * axis.variance);
    };
    add(axes[i]);
    for(const std::size_t j : neighbors[i])
      add(axes[j]);
    result.push_back(Eigen_solver(sum).eigenvectors().col(2));
  }
  return result;
}

std::vector<Vector3d> axes_of(const Cloud& cloud)
{
  std::vector<Axis> axes;
  for(std::size_t i = 0; i < cloud.points.size(); ++i) {
    std::vector<std::size_t> around = cloud.neighbors[i];
    around.push_back(i);
    axes.push_back(symmetry_axis(cloud, around));
  }
  std::vector<Vector3d> result = smoothed(axes, cloud.neighbors);
  Planar_cut cut(cloud);
  for(int step = 0; step < orientation_steps; ++step) {
    for(std::size_t i = 0; i < axes.size(); ++i)
      axes[i] = symmetry_axis(cloud, cut(i, result[i]));
    result = smoothed(axes, cloud.neighbors);
  }
  return result;
}

// The point nearest to the lines along the normals, in the sense of least squares; false if the
// normals are too much alike to tell.
bool find_center(const Cloud& cloud, const std::vector<std::size_t>& set, Vector3d& center)
{
  Matrix3d sum = Matrix3d::Zero();
  Vector3d right = Vector3d::Zero(), mean = Vector3d::Zero();
  for(const std::size_t i : set) {
    const Vector3d& n = cloud.normals[i];
    const Matrix3d across = Matrix3d::Identity() - n * n.transpose();
    sum += across;
    right += across * cloud.points[i];
    mean += cloud.points[i];
  }
  const double size = static_cast<double>(set.size());
  const Eigen_solver solver(sum);
  if(solver.eigenvalues()[0] < least_spread * size)
    return false;
  center = sum.ldlt().solve(right);
  double extent = 0;
  for(const std::size_t i : set)
    extent = std::max(extent, (cloud.points[i] - cloud.points[set.front()]).norm());
  return (center - cloud.points[set.front()]).norm() < extent;
}

// Centers where there is none yet: the mean of the neighbours', from where there are some inwards.
void fill(std::vector<Vector3d>& centers, std::vector<char>& known, const Neighbors& neighbors)
{
  std::vector<std::size_t> unknown;
  for(std::size_t i = 0; i < known.size(); ++i)
    if(!known[i])
      unknown.push_back(i);
  while(!unknown.empty()) {
    std::vector<std::size_t> done, left;
    for(const std::size_t i : unknown) {
      Vector3d sum = Vector3d::Zero();
      double count = 0;
      for(const std::size_t j : neighbors[i])
        if(known[j]) {
          sum += centers[j];
          ++count;
        }
      (count > 0 ? done : left).push_back(i);
      if(count > 0)
        centers[i] = sum / count;
    }
    for(const std::size_t i : done)
      known[i] = 1;
    if(done.empty())
      return;
    unknown = left;
  }
}

// Moves every centre to the line through the centres around it, or to their mean where they are not
// along a line.
void thin(std::vector<Vector3d>& centers, double radius)
{
  const Point_search search(centers);
  std::vector<Vector3d> result;
  std::vector<std::size_t> around;
  for(const Vector3d& center : centers) {
    search.within(center, radius, around);
    Vector3d mean = Vector3d::Zero();
    for(const std::size_t j : around)
      mean += centers[j] / static_cast<double>(around.size());
    Matrix3d scatter = Matrix3d::Zero();
    for(const std::size_t j : around)
      scatter += (centers[j] - mean) * (centers[j] - mean).transpose();
    const Eigen_solver solver(scatter);
    const Vector3d line = solver.eigenvectors().col(2);
    const bool is_line = solver.eigenvalues()[2] > least_linearity * scatter.trace();
    result.push_back(is_line ? Vector3d(mean + line * line.dot(center - mean)) : mean);
  }
  centers = result;
}

// Samples such that every centre is within `radius` of one, and for every centre the nearest
// sample.
std::vector<std::size_t> sample(const std::vector<Vector3d>& centers,
                                const std::vector<char>& known, double radius,
                                std::vector<methods::Cluster>& samples)
{
  const Point_search search(centers);
  std::vector<std::size_t> owner(centers.size(), no_cluster), around;
  for(std::size_t i = 0; i < centers.size(); ++i) {
    if(!known[i] || owner[i] != no_cluster)
      continue;
    search.within(centers[i], radius, around);
    for(const std::size_t j : around)
      if(known[j] &&
         (owner[j] == no_cluster || (centers[j] - centers[i]).squaredNorm() <
                                        (centers[j] - samples[owner[j]].center).squaredNorm()))
        owner[j] = samples.size();
    samples.push_back({centers[i], 0, {}});
  }
  return owner;
}

// Takes the points from samples that stand for few: cuts of their own kind.
void drop_strays(std::vector<std::size_t>& owner, std::size_t samples)
{
  std::vector<double> size(samples, 0);
  double sum = 0;
  for(const std::size_t s : owner)
    if(s != no_cluster) {
      ++size[s];
      ++sum;
    }
  for(std::size_t& s : owner)
    if(s != no_cluster && size[s] * static_cast<double>(samples) < least_size * sum)
      s = no_cluster;
}

// Moves the vertices that are no junctions towards the axis of the points they stand for.
void recenter(const Cloud& cloud, methods::Cluster_graph& graph)
{
  for(std::size_t c = 0; c < graph.clusters().size(); ++c) {
    methods::Cluster& cluster = graph.clusters()[c];
    if(cluster.points.empty() || graph.adjacent(c).size() > 2)
      continue;
    Vector3d mean = Vector3d::Zero(), center;
    for(const std::size_t i : cluster.points)
      mean += cloud.points[i] / static_cast<double>(cluster.points.size());
    if(find_center(cloud, cluster.points, center))
      cluster.center = mean_share * mean + (1 - mean_share) * center;
  }
}

} // namespace

Method_result rosa(const Method_input& input)
{
  Method_result result;
  Cloud cloud{methods::to_eigen(input.points), methods::to_eigen(input.normals), {}, 0};
  Eigen::AlignedBox3d box;
  for(const Vector3d& p : cloud.points)
    box.extend(p);
  const double diagonal = box.diagonal().norm();

  std::vector<Vector3d> axes, centers(cloud.points);
  std::vector<char> known(cloud.points.size(), 1);
  timed_stage(result, "axes", [&] {
    find_neighbors(cloud);
    axes = axes_of(cloud);
  });
  timed_stage(result, "centres", [&] {
    Planar_cut cut(cloud);
    for(std::size_t i = 0; i < centers.size(); ++i)
      known[i] = find_center(cloud, cut(i, axes[i]), centers[i]);
    fill(centers, known, cloud.neighbors);
  });
  timed_stage(result, "thinning", [&] {
    for(int step = 0; step < thinning_steps; ++step)
      thin(centers, thinning_radius * diagonal);
  });
  timed_stage(result, "joining", [&] {
    std::vector<methods::Cluster> samples;
    std::vector<std::size_t> owner = sample(centers, known, sample_radius * diagonal, samples);
    if(samples.empty())
      throw std::runtime_error("no planar cut has a centre");
    drop_strays(owner, samples.size());
    methods::spread(owner, cloud.neighbors);
    methods::Cluster_graph graph(std::move(samples), owner, cloud.neighbors);
    graph.keep_spanner(stretch);
    recenter(cloud, graph);
    result.skeleton = graph.skeleton();
  });
  return result;
}
