// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "edge_collapse.h"

#include <Eigen/Geometry>

#include <functional>
#include <queue>
#include <tuple>
#include <utility>

namespace methods {
namespace {

constexpr double sampling_weight = 0.1; // w_b; w_a of the shape is 1

} // namespace

Edge_collapse::Edge_collapse(const Positions& points, const std::vector<Fan>& fans)
    : stars_(fans.size())
    , quadrics_(fans.size(), Eigen::Matrix4d::Zero())
{
  for(std::size_t i = 0; i < fans.size(); ++i) {
    points_.emplace_back(points.row(static_cast<Eigen::Index>(i)));
    regions_.push_back({i});
    for(const auto& [j, k] : fans[i]) {
      stars_[i][j].insert(k);
      stars_[i][k].insert(j);
    }
  }
  for(std::size_t i = 0; i < fans.size(); ++i)
    for(const auto& neighbor : stars_[i])
      add_quadric(i, neighbor.first);
}

/// Of the line through the edge from `i` to `j`: |a x p - b|^2.
void Edge_collapse::add_quadric(std::size_t i, std::size_t j)
{
  const Eigen::Vector3d a = (points_[j] - points_[i]).normalized();
  const Eigen::Vector3d b = a.cross(points_[i]);
  Eigen::Matrix<double, 3, 4> k;
  k << 0, -a.z(), a.y(), -b.x(), a.z(), 0, -a.x(), -b.y(), -a.y(), a.x(), 0, -b.z();
  quadrics_[i] += k.transpose() * k;
}

bool Edge_collapse::is_collapsible(std::size_t i, std::size_t j) const
{
  const auto edge = stars_[i].find(j);
  return edge != stars_[i].end() && !edge->second.empty();
}

double Edge_collapse::cost(std::size_t i, std::size_t j) const
{
  const Eigen::Vector4d p = points_[j].homogeneous();
  double lengths = 0;
  for(const auto& neighbor : stars_[i])
    lengths += (points_[neighbor.first] - points_[i]).norm();
  return p.dot((quadrics_[i] + quadrics_[j]) * p) +
         sampling_weight * (points_[j] - points_[i]).norm() * lengths;
}

void Edge_collapse::collapse(std::size_t i, std::size_t j)
{
  const Star star = std::exchange(stars_[i], {});
  for(const auto& [k, thirds] : star) {
    stars_[k].erase(i);
    for(const std::size_t third : thirds)
      stars_[k][third].erase(i);
  }
  for(const auto& [k, thirds] : star) {
    if(k == j)
      continue;
    stars_[j][k]; // an edge at least
    stars_[k][j];
    for(const std::size_t third : thirds)
      if(third != j) {
        stars_[j][k].insert(third);
        stars_[k][j].insert(third);
        stars_[k][third].insert(j);
      }
  }
  quadrics_[j] += quadrics_[i];
  regions_[j].insert(regions_[j].end(), regions_[i].begin(), regions_[i].end());
  regions_[i].clear();
}

void Edge_collapse::collapse_all()
{
  using Entry = std::tuple<double, std::size_t, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> queue;
  const auto push_edges_from = [&](std::size_t i) {
    for(const auto& [j, thirds] : stars_[i])
      if(!thirds.empty()) {
        queue.emplace(cost(i, j), i, j);
        queue.emplace(cost(j, i), j, i);
      }
  };
  for(std::size_t i = 0; i < stars_.size(); ++i)
    push_edges_from(i);
  while(!queue.empty()) {
    const auto [stored_cost, i, j] = queue.top();
    queue.pop();
    if(!is_collapsible(i, j) || stored_cost != cost(i, j)) // else there is a newer entry
      continue;
    collapse(i, j);
    push_edges_from(j);
    for(const auto& neighbor : stars_[j])
      push_edges_from(neighbor.first);
  }
}

std::vector<std::size_t> Edge_collapse::vertices() const
{
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < regions_.size(); ++i)
    if(!regions_[i].empty())
      result.push_back(i);
  return result;
}

std::vector<std::size_t> Edge_collapse::neighbors(std::size_t i) const
{
  std::vector<std::size_t> result;
  for(const auto& neighbor : stars_[i])
    result.push_back(neighbor.first);
  return result;
}

} // namespace methods
