// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "spanning_tree.h"

#include "../metrics/spurs.h"
#include "add_curve.h"
#include "average_spacing.h"

#include <CGAL/Orthogonal_k_neighbor_search.h>
#include <CGAL/Search_traits_3.h>
#include <CGAL/Search_traits_adapter.h>
#include <CGAL/property_map.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using Edge = std::pair<std::size_t, std::size_t>;

std::vector<Point> thinned(const std::vector<Point>& points, double cell)
{
  struct Sum
  {
    Vector offset = CGAL::NULL_VECTOR;
    double number = 0;
  };
  std::map<std::array<double, 3>, Sum> cells;
  for(const Point& p : points) {
    Sum& sum =
        cells[{std::floor(p.x() / cell), std::floor(p.y() / cell), std::floor(p.z() / cell)}];
    sum.offset += p - CGAL::ORIGIN;
    ++sum.number;
  }
  std::vector<Point> means;
  for(const auto& [place, sum] : cells)
    means.push_back(CGAL::ORIGIN + sum.offset / sum.number);
  return means;
}

/// From every point to its `k` nearest, the shortest first.
std::vector<Edge> neighbour_edges(const std::vector<Point>& points, std::size_t k)
{
  using Map = CGAL::Pointer_property_map<Point>::const_type;
  using Traits = CGAL::Search_traits_adapter<std::size_t, Map, CGAL::Search_traits_3<Kernel>>;
  using Search = CGAL::Orthogonal_k_neighbor_search<Traits>;
  const Map map = CGAL::make_property_map(points);
  const boost::counting_iterator<std::size_t> first(0), last(points.size());
  const Search::Tree tree(first, last, Search::Splitter(), Traits(map));
  std::vector<std::tuple<double, std::size_t, std::size_t>> edges;
  for(std::size_t i = 0; i < points.size(); ++i)
    for(const auto& [j, distance] :
        Search(tree, points[i], static_cast<unsigned>(k + 1), 0, true, Search::Distance(map)))
      if(i != j)
        edges.emplace_back(distance, std::min(i, j), std::max(i, j));
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> result;
  for(const auto& [distance, i, j] : edges)
    result.emplace_back(i, j);
  return result;
}

/// By Kruskal's algorithm, on ever more edges until they connect all points.
std::vector<Edge> minimum_spanning_tree(const std::vector<Point>& points)
{
  std::vector<Edge> tree;
  for(std::size_t k = 8; tree.size() + 1 < points.size(); k *= 2) {
    tree.clear();
    boost::disjoint_sets_with_storage<> sets(points.size());
    for(const Edge& edge : neighbour_edges(points, std::min(k, points.size() - 1)))
      if(sets.find_set(edge.first) != sets.find_set(edge.second)) {
        sets.union_set(edge.first, edge.second);
        tree.push_back(edge);
      }
  }
  return tree;
}

/// Takes away the branch from `tip` to a junction, but for the junction.
void cut_twig(Skeleton& skeleton, std::size_t tip)
{
  while(out_degree(tip, skeleton) == 1) {
    const std::size_t next = target(*out_edges(tip, skeleton).first, skeleton);
    const bool is_last = out_degree(next, skeleton) > 2;
    clear_vertex(tip, skeleton);
    if(is_last)
      return;
    tip = next;
  }
}

/// The shortest first: of two at the same fork the longer is part of the limb then.
void cut_twigs(Skeleton& skeleton, double length)
{
  using metrics::internal::follow_branch;
  std::vector<std::pair<double, std::size_t>> twigs;
  do {
    twigs.clear();
    for(const auto v : boost::make_iterator_range(vertices(skeleton)))
      if(out_degree(v, skeleton) == 1) {
        const auto branch = follow_branch(v, skeleton);
        if(branch.length < length && out_degree(branch.vertex, skeleton) > 2)
          twigs.emplace_back(branch.length, v);
      }
    std::sort(twigs.begin(), twigs.end());
    for(const auto& [before, tip] : twigs) {
      const auto branch = follow_branch(tip, skeleton); // may have lost its junction
      if(branch.length < length && out_degree(branch.vertex, skeleton) > 2)
        cut_twig(skeleton, tip);
    }
  } while(!twigs.empty());
}

/// Without the vertices that have no edges.
Skeleton connected_part(const Skeleton& skeleton)
{
  std::vector<std::size_t> number(num_vertices(skeleton));
  std::vector<Point> points;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    if(out_degree(v, skeleton) > 0) {
      number[v] = points.size();
      points.push_back(skeleton[v].point);
    }
  std::vector<Edge> ends;
  for(const auto e : boost::make_iterator_range(edges(skeleton)))
    ends.emplace_back(number[source(e, skeleton)], number[target(e, skeleton)]);
  Skeleton result;
  add_curve(result, points, ends);
  return result;
}

} // namespace

Method_result spanning_tree(const Method_input& input)
{
  constexpr double cell_width = 2;  // spacings
  constexpr double twig_length = 4; // cells
  Method_result result;
  timed_stage(result, "tree", [&] {
    const double cell = cell_width * average_spacing(input.points);
    const std::vector<Point> points = thinned(input.points, cell);
    Skeleton skeleton;
    add_curve(skeleton, points, minimum_spanning_tree(points));
    cut_twigs(skeleton, twig_length * cell);
    result.skeleton = connected_part(skeleton);
  });
  return result;
}
