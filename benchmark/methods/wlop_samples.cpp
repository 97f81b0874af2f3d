// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "wlop_samples.h"

#include "neighborhoods.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace methods {

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double repulsion_strength = 0.35; // mu of the publication
constexpr double least_distance = 1e-3;     // in radii; weights are reciprocal to distances

// Gaussian of half the radius; as good as zero at the radius.
double theta(double squared_distance, double radius)
{
  return std::exp(-4 * squared_distance / (radius * radius));
}

double at_least(double squared_distance, double radius)
{
  return std::max(squared_distance, least_distance * least_distance * radius * radius);
}

void set_direction(Wlop_sample& sample, const Matrix3d& scatter)
{
  const Eigen::SelfAdjointEigenSolver<Matrix3d> solver(scatter);
  sample.direction = solver.eigenvectors().col(2);
  sample.directionality = scatter.trace() > 0 ? solver.eigenvalues()[2] / scatter.trace() : 0;
}

// The first `size` of a random permutation; the engine is the same everywhere, std::shuffle is not.
std::vector<std::size_t> random_subset(std::size_t count, std::size_t size)
{
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::mt19937_64 random(1);
  for(std::size_t i = 0; i < size; ++i)
    std::swap(order[i], order[i + random() % (count - i)]);
  order.resize(size);
  std::sort(order.begin(), order.end());
  return order;
}

} // namespace

Wlop_samples::Wlop_samples(const std::vector<Vector3d>& points, std::size_t size, double radius)
    : points_(points)
{
  const Point_search search(points);
  std::vector<std::size_t> around;
  for(const Vector3d& p : points) {
    search.within(p, radius, around);
    double density = 0; // with 1 for the point itself
    for(const std::size_t j : around)
      density += theta((p - points[j]).squaredNorm(), radius);
    weights_.push_back(1 / density);
  }
  for(const std::size_t i : random_subset(points.size(), std::min(size, points.size()))) {
    samples_.emplace_back();
    samples_.back().point = points[i];
  }
}

// Most points are within the radius before long: a tree of them would not pay.
Vector3d Wlop_samples::median(const Vector3d& center, double radius) const
{
  Vector3d sum = Vector3d::Zero();
  double weight_sum = 0;
  for(std::size_t j = 0; j < points_.size(); ++j) {
    const double squared_distance = (points_[j] - center).squaredNorm();
    if(squared_distance < radius * radius) {
      const double weight = weights_[j] * theta(squared_distance, radius) /
                            std::sqrt(at_least(squared_distance, radius));
      sum += weight * points_[j];
      weight_sum += weight;
    }
  }
  return weight_sum > 0 ? Vector3d(sum / weight_sum) : center;
}

Vector3d Wlop_samples::repulsion(std::size_t i, double radius) const
{
  Vector3d sum = Vector3d::Zero();
  double weight_sum = 0;
  for(std::size_t j = 0; j < samples_.size(); ++j) {
    const Vector3d away = samples_[i].point - samples_[j].point;
    const double squared_distance = away.squaredNorm();
    if(j != i && !samples_[j].is_removed() && squared_distance < radius * radius) {
      const double weight = theta(squared_distance, radius) / at_least(squared_distance, radius);
      sum += weight * away;
      weight_sum += weight;
    }
  }
  return weight_sum > 0 ? Vector3d(sum / weight_sum) : sum;
}

double Wlop_samples::contract(double radius)
{
  std::vector<Vector3d> moved;
  double way = 0, count = 0;
  for(std::size_t i = 0; i < samples_.size(); ++i) {
    moved.push_back(samples_[i].point);
    if(!samples_[i].is_moving())
      continue;
    find_direction(i, radius);
    moved[i] = median(samples_[i].point, radius) +
               repulsion_strength * samples_[i].directionality * repulsion(i, radius);
    way += (moved[i] - samples_[i].point).norm();
    ++count;
  }
  for(std::size_t i = 0; i < samples_.size(); ++i)
    samples_[i].point = moved[i];
  return count > 0 ? way / count : 0;
}

void Wlop_samples::find_direction(std::size_t i, double radius)
{
  Matrix3d scatter = Matrix3d::Zero();
  for(const Wlop_sample& other : samples_) {
    const Vector3d offset = other.point - samples_[i].point;
    if(!other.is_removed() && offset.squaredNorm() < radius * radius)
      scatter += theta(offset.squaredNorm(), radius) * offset * offset.transpose();
  }
  set_direction(samples_[i], scatter);
}

void Wlop_samples::update_directions(std::size_t neighbors)
{
  std::vector<Vector3d> points;
  std::vector<std::size_t> left;
  for(std::size_t i = 0; i < samples_.size(); ++i)
    if(samples_[i].is_moving()) {
      points.push_back(samples_[i].point);
      left.push_back(i);
    }
  const Point_search search(points);
  std::vector<std::vector<Neighbor>> nearest(points.size());
  for(std::size_t k = 0; k < points.size(); ++k) {
    search.nearest(points[k], neighbors + 1, nearest[k]);
    Vector3d mean = Vector3d::Zero();
    for(const Neighbor& neighbor : nearest[k])
      mean += points[neighbor.index] / static_cast<double>(nearest[k].size());
    Matrix3d scatter = Matrix3d::Zero();
    for(const Neighbor& neighbor : nearest[k])
      scatter += (points[neighbor.index] - mean) * (points[neighbor.index] - mean).transpose();
    set_direction(samples_[left[k]], scatter);
  }
  std::vector<double> means;
  for(const std::vector<Neighbor>& list : nearest) {
    double sum = 0;
    for(const Neighbor& neighbor : list)
      sum += samples_[left[neighbor.index]].directionality;
    means.push_back(sum / static_cast<double>(list.size()));
  }
  for(std::size_t k = 0; k < left.size(); ++k)
    samples_[left[k]].directionality = means[k];
}

} // namespace methods
