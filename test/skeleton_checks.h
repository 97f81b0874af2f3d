// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_SKELETON_CHECKS_H
#define POINT_SET_SKELETONIZATION_3_TEST_SKELETON_CHECKS_H

#include "catch2.h"

#include <boost/graph/graph_traits.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>
#include <utility>
#include <vector>

/// What holds for every skeleton of `size` input points: finite numbers, a simple graph, and points
/// that belong to at most one vertex.
template <typename Skeleton>
void check_valid(const Skeleton& skeleton, std::size_t size)
{
  std::vector<char> taken(size, 0);
  for(const auto v : boost::make_iterator_range(vertices(skeleton))) {
    const auto& bundle = skeleton[v];
    CAPTURE(v);
    REQUIRE(std::isfinite(bundle.point.x()));
    REQUIRE(std::isfinite(bundle.point.y()));
    REQUIRE(std::isfinite(bundle.point.z()));
    REQUIRE(std::isfinite(bundle.radius));
    REQUIRE(bundle.radius >= 0);
    REQUIRE(std::is_sorted(bundle.indices.begin(), bundle.indices.end()));
    std::size_t wrong = 0;
    for(std::size_t i : bundle.indices)
      wrong += i >= size || std::exchange(taken[i], char(1));
    REQUIRE(wrong == 0);
  }
  std::set<std::pair<std::size_t, std::size_t>> known;
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    const std::size_t s = source(e, skeleton), t = target(e, skeleton);
    REQUIRE(s != t);
    REQUIRE(known.emplace(std::min(s, t), std::max(s, t)).second);
  }
}

/// Whether two skeletons have the same bits, indices and edges in the same order.
template <typename Skeleton>
bool have_same_bits(const Skeleton& a, const Skeleton& b)
{
  if(num_vertices(a) != num_vertices(b) || num_edges(a) != num_edges(b))
    return false;
  for(const auto v : boost::make_iterator_range(vertices(a)))
    if(a[v].point != b[v].point || a[v].radius != b[v].radius || a[v].indices != b[v].indices)
      return false;
  auto f = edges(b).first;
  for(const auto e : boost::make_iterator_range(edges(a))) {
    if(source(e, a) != source(*f, b) || target(e, a) != target(*f, b))
      return false;
    ++f;
  }
  return true;
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_SKELETON_CHECKS_H
