// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "sample_branches.h"

#include <CGAL/number_type_config.h>

#include <boost/graph/dijkstra_shortest_paths.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace methods {

namespace {

constexpr double least_sigma = 0.9;
constexpr double least_bridge_sigma = 0.8;
const double least_turn_cosine = std::cos(25 * CGAL_PI / 180);
const double least_kept_cosine = std::cos(101 * CGAL_PI / 180);
const double least_join_cosine = std::cos(60 * CGAL_PI / 180);
const double least_bridge_cosine = std::cos(80 * CGAL_PI / 180);

constexpr std::size_t near_samples = 12;

// In units.
constexpr double search_distance = 0.4;
constexpr double follow_distance = 0.33;
constexpr double grow_distance = 0.15;
constexpr double merge_distance = 0.08;
constexpr double clean_distance = 0.05;
constexpr double same_distance = 0.01;
constexpr double least_loop = 0.5;

double cosine(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  return a.dot(b) / (a.norm() * b.norm());
}

// The length of the shortest way in the skeleton; infinite, or almost, if there is none.
double way_along(const Skeleton& skeleton, Skeleton::vertex_descriptor from,
                 Skeleton::vertex_descriptor to)
{
  std::map<Skeleton::edge_descriptor, double> lengths;
  for(const auto e : boost::make_iterator_range(edges(skeleton)))
    lengths[e] = std::sqrt(CGAL::squared_distance(skeleton[source(e, skeleton)].point,
                                                  skeleton[target(e, skeleton)].point));
  std::vector<double> distance(num_vertices(skeleton));
  boost::dijkstra_shortest_paths(
      skeleton, from,
      boost::weight_map(boost::make_assoc_property_map(lengths)).distance_map(distance.data()));
  return distance[to];
}

} // namespace

bool Sample_branches::is_bridge(std::size_t i) const
{
  return std::any_of(branches_.begin(), branches_.end(), [i](const Branch& branch) {
    return branch.halves[0].bridge == i || branch.halves[1].bridge == i;
  });
}

Eigen::Vector3d Sample_branches::way(std::size_t from, std::size_t to) const
{
  return samples_[to].point - samples_[from].point;
}

// From the last sample but one to the last.
Eigen::Vector3d Sample_branches::way_ahead(const Branch& branch, int side) const
{
  const std::vector<std::size_t>& curve = branch.halves[side].curve;
  const bool is_seed = curve.size() == 1; // the branch goes on in the other half
  return way(is_seed ? branch.halves[1 - side].curve[1] : curve[curve.size() - 2], curve.back());
}

// The last samples of an end, where a branch does not meet itself.
std::vector<std::size_t> Sample_branches::recent(const Half& half, const Half& other) const
{
  std::vector<std::size_t> result(half.curve.rbegin(), half.curve.rend());
  if(!other.curve.empty()) // the seed is in both
    result.insert(result.end(), other.curve.begin() + 1, other.curve.end());
  double length = 0;
  std::size_t size = 1;
  for(; size < result.size() && length < search_distance * unit_; ++size)
    length += way(result[size - 1], result[size]).norm();
  result.resize(size);
  return result;
}

// The nearest sample ahead, except `not_these`; it has to be one of the nearest all around.
std::size_t Sample_branches::next(std::size_t from, const Vector3d& direction, double max_distance,
                                  const std::vector<std::size_t>& not_these) const
{
  std::vector<std::pair<double, std::size_t>> around;
  for(std::size_t i = 0; i < samples_.size(); ++i)
    if(i != from && !samples_[i].is_removed())
      around.emplace_back(way(from, i).norm(), i);
  const auto end =
      around.begin() + static_cast<std::ptrdiff_t>(std::min(near_samples, around.size()));
  std::partial_sort(around.begin(), end, around.end());
  const auto found = std::find_if(around.begin(), end, [&](const auto& candidate) {
    return way(from, candidate.second).dot(direction) > 0 &&
           std::find(not_these.begin(), not_these.end(), candidate.second) == not_these.end();
  });
  return found != end && found->first < max_distance * unit_ ? found->second : none;
}

Sample_branches::Half Sample_branches::trace(std::size_t seed, const Vector3d& direction,
                                             const Half& other, std::vector<char>& is_used) const
{
  Half half;
  half.curve.push_back(seed);
  Vector3d ahead = direction;
  for(;;) {
    const std::size_t last = half.curve.back();
    const std::size_t i = next(last, ahead, search_distance, recent(half, other));
    const bool is_part = i != none && !is_used[i] && samples_[i].is_moving() &&
                         samples_[i].directionality > least_sigma &&
                         cosine(ahead, way(last, i)) > least_turn_cosine && !is_bridge(i);
    if(!is_part) {
      half.bridge = i;
      return half;
    }
    ahead = way(last, i);
    half.curve.push_back(i);
    is_used[i] = 1;
  }
}

void Sample_branches::find(std::size_t least_size)
{
  std::vector<std::size_t> seeds;
  for(std::size_t i = 0; i < samples_.size(); ++i)
    if(samples_[i].is_moving() && samples_[i].directionality > least_sigma && !is_bridge(i))
      seeds.push_back(i);
  std::stable_sort(seeds.begin(), seeds.end(), [this](std::size_t a, std::size_t b) {
    return samples_[a].directionality > samples_[b].directionality;
  });
  std::vector<char> is_used(samples_.size(), 0);
  for(const std::size_t seed : seeds) {
    if(is_used[seed] || !samples_[seed].is_moving())
      continue;
    is_used[seed] = 1;
    const Vector3d& direction = samples_[seed].direction;
    Branch branch;
    branch.halves[0] = trace(seed, direction, {}, is_used);
    branch.halves[1] = trace(seed, -direction, branch.halves[0], is_used);
    if(branch.halves[0].curve.size() + branch.halves[1].curve.size() - 1 < least_size)
      continue;
    for(const Half& half : branch.halves)
      for(const std::size_t i : half.curve)
        samples_[i].state = Wlop_sample::State::fixed;
    branches_.push_back(std::move(branch));
    clean();
  }
  fix_shared_bridges();
}

// Samples contract differently: the bridge is the nearest that is now ahead. One that is far away
// is kept, but not one that has fallen behind, as at the tip of a limb.
void Sample_branches::follow(Branch& branch, int side, double radius) const
{
  Half& half = branch.halves[side];
  const std::size_t last = half.curve.back(), bridge = half.bridge;
  const Vector3d ahead = way_ahead(branch, side);
  if(cosine(ahead, way(last, bridge)) < least_kept_cosine)
    half.bridge = none;
  double least = follow_distance * unit_;
  for(std::size_t i = 0; i < samples_.size(); ++i) {
    const double distance = way(last, i).norm();
    if(samples_[i].is_moving() && distance < least && way(bridge, i).norm() < radius &&
       cosine(ahead, way(last, i)) > least_bridge_cosine) {
      least = distance;
      half.bridge = i;
    }
  }
}

// To what is nearest to the bridge, or to the end if there is none: a sample of another branch or
// the bridge of another end. Beyond the distance at which ends meet it has to be ahead.
void Sample_branches::join(Branch& branch, int side, double max_distance) const
{
  Half& half = branch.halves[side];
  const std::size_t last = half.curve.back();
  const std::size_t from = half.bridge == none ? last : half.bridge;
  const Vector3d ahead = half.bridge == none ? way_ahead(branch, side) : way(last, from);
  double least = max_distance * unit_;
  const auto try_sample = [&](std::size_t i) {
    if(i == none || i == from || i == last)
      return;
    const double distance = way(from, i).norm();
    const bool is_near = distance < merge_distance * unit_;
    if(distance < least && (is_near || cosine(ahead, way(from, i)) > least_join_cosine)) {
      least = distance;
      half.bridge = i;
    }
  };
  for(const Branch& other : branches_)
    for(const Half& other_half : other.halves) {
      if(&other != &branch)
        std::for_each(other_half.curve.begin(), other_half.curve.end(), try_sample);
      if(&other_half != &half)
        try_sample(other_half.bridge);
    }
}

void Sample_branches::grow(Branch& branch, int side)
{
  Half& half = branch.halves[side];
  while(half.bridge != none && samples_[half.bridge].is_moving()) {
    const Vector3d to_bridge = way(half.curve.back(), half.bridge);
    if(samples_[half.bridge].directionality < least_bridge_sigma ||
       cosine(way_ahead(branch, side), to_bridge) < least_turn_cosine)
      return;
    const std::size_t beyond =
        next(half.bridge, to_bridge, grow_distance, recent(half, branch.halves[1 - side]));
    if(beyond == none)
      return;
    samples_[half.bridge].state = Wlop_sample::State::fixed;
    half.curve.push_back(std::exchange(half.bridge, beyond));
  }
}

void Sample_branches::grow(double radius)
{
  for(Branch& branch : branches_)
    for(const int side : {0, 1}) {
      const Half& half = branch.halves[side];
      if(half.bridge == none || !samples_[half.bridge].is_moving())
        continue;
      follow(branch, side, radius);
      grow(branch, side);
      if(half.bridge != none && samples_[half.bridge].is_moving())
        join(branch, side, merge_distance);
    }
}

void Sample_branches::join_ends()
{
  for(Branch& branch : branches_)
    for(const int side : {0, 1}) {
      const Half& half = branch.halves[side];
      if(half.bridge == none || samples_[half.bridge].is_moving())
        join(branch, side, follow_distance);
      fix_shared_bridges();
    }
}

// Where ends meet, they stay.
void Sample_branches::fix_shared_bridges()
{
  std::map<std::size_t, int> ends;
  for(const Branch& branch : branches_)
    for(const Half& half : branch.halves)
      if(half.bridge != none && ++ends[half.bridge] == 2)
        samples_[half.bridge].state = Wlop_sample::State::fixed;
}

// A bridge that the end of its own branch has taken is replaced by what is ahead.
void Sample_branches::remove(std::size_t i, std::size_t instead)
{
  samples_[i].state = Wlop_sample::State::removed;
  for(Branch& branch : branches_)
    for(const int side : {0, 1}) {
      Half& half = branch.halves[side];
      if(half.bridge != i)
        continue;
      const std::vector<std::size_t> own = recent(half, branch.halves[1 - side]);
      const bool is_own = std::find(own.begin(), own.end(), instead) != own.end();
      half.bridge =
          is_own ? next(half.curve.back(), way_ahead(branch, side), grow_distance, own) : instead;
    }
}

void Sample_branches::thin()
{
  for(std::size_t i = 0; i < samples_.size(); ++i)
    for(std::size_t j = 0; j < samples_.size() && samples_[i].is_moving(); ++j)
      if(j != i && !samples_[j].is_removed() && way(i, j).norm() < same_distance * unit_)
        remove(i, j);
}

void Sample_branches::clean()
{
  for(std::size_t i = 0; i < samples_.size(); ++i)
    for(std::size_t j = 0; j < samples_.size() && samples_[i].is_moving(); ++j)
      if(samples_[j].is_fixed() && way(i, j).norm() < clean_distance * unit_ && !is_bridge(i))
        remove(i, j);
}

// Branches first, then their links to bridges, of which those that would close a short loop are
// left out: there, several short branches lie side by side.
Skeleton Sample_branches::skeleton() const
{
  Skeleton result;
  std::map<std::size_t, Skeleton::vertex_descriptor> vertex;
  const auto vertex_of = [&](std::size_t i) {
    const auto [position, is_new] = vertex.emplace(i, 0);
    if(is_new) {
      position->second = add_vertex(result);
      const Vector3d& p = samples_[i].point;
      result[position->second].point = Point(p.x(), p.y(), p.z());
    }
    return position->second;
  };
  for(const Branch& branch : branches_)
    for(const Half& half : branch.halves)
      for(std::size_t k = 1; k < half.curve.size(); ++k)
        add_edge(vertex_of(half.curve[k - 1]), vertex_of(half.curve[k]), result);
  for(const Branch& branch : branches_)
    for(const Half& half : branch.halves)
      if(half.bridge != none) {
        const auto end = vertex_of(half.curve.back()), bridge = vertex_of(half.bridge);
        if(way_along(result, end, bridge) > least_loop * unit_)
          add_edge(end, bridge, result);
      }
  return result;
}

} // namespace methods
