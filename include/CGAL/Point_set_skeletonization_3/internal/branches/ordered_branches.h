// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_ORDERED_BRANCHES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_ORDERED_BRANCHES_H

#include <CGAL/Point_set_skeletonization_3/internal/branches/measure_branch.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// For every vertex its neighbours, each with the number of the edge.
using Incidences = std::vector<std::vector<std::pair<std::size_t, std::size_t>>>;

inline Incidences incidences_of(const Plain_skeleton& skeleton)
{
  Incidences result(skeleton.vertices.size());
  for(std::size_t e = 0; e < skeleton.edges.size(); ++e) {
    const auto [v, w] = skeleton.edges[e];
    result[v].emplace_back(w, e);
    result[w].emplace_back(v, e);
  }
  return result;
}

/// Calls `visit(vertices)` for each connected component, in the order of their first vertices.
template <typename Visit>
void for_each_component(const Incidences& incidences, const Visit& visit)
{
  std::vector<bool> seen(incidences.size(), false);
  for(std::size_t first = 0; first < incidences.size(); ++first) {
    if(seen[first])
      continue;
    std::vector<std::size_t> component{first};
    seen[first] = true;
    for(std::size_t i = 0; i < component.size(); ++i)
      for(const auto& [w, e] : incidences[component[i]])
        if(!seen[w]) {
          seen[w] = true;
          component.push_back(w);
        }
    visit(component);
  }
}

/// Returns the vertex with the least `cost(v)`, the first of several: of the tips and junctions of
/// a component, or of all vertices of a cycle without a junction.
template <typename Cost>
std::size_t least_end(const std::vector<std::size_t>& component, const Incidences& incidences,
                      const Cost& cost)
{
  const auto rank = [&](std::size_t v) {
    return std::make_tuple(incidences[v].size() == 2, cost(v), v);
  };
  return *std::min_element(component.begin(), component.end(),
                           [&rank](std::size_t v, std::size_t w) { return rank(v) < rank(w); });
}

/// The same for each component, in the order of their first vertices. O(n).
template <typename Cost>
std::vector<std::size_t> least_ends(const Plain_skeleton& skeleton, const Cost& cost)
{
  const Incidences incidences = incidences_of(skeleton);
  std::vector<std::size_t> result;
  for_each_component(incidences, [&](const std::vector<std::size_t>& component) {
    result.push_back(least_end(component, incidences, cost));
  });
  return result;
}

/// Appends the lowest end of each component that has no root.
inline void add_missing_roots(const Plain_skeleton& skeleton, const Incidences& incidences,
                              std::vector<std::size_t>& roots)
{
  std::vector<bool> is_root(skeleton.vertices.size(), false);
  for(std::size_t v : roots)
    is_root[v] = true;
  for_each_component(incidences, [&](const std::vector<std::size_t>& component) {
    if(std::none_of(component.begin(), component.end(),
                    [&is_root](std::size_t v) { return is_root[v]; }))
      roots.push_back(least_end(component, incidences, [&skeleton](std::size_t v) {
        return skeleton.vertices[v].point[2];
      }));
  });
}

/// Returns all paths between two nodes that pass no other node, each once, in any direction. O(n).
inline std::vector<Plain_branch> paths_between(const std::vector<bool>& is_node,
                                               const Incidences& incidences, std::size_t edges)
{
  std::vector<Plain_branch> result;
  std::vector<bool> seen(edges, false);
  const auto follow = [&](std::size_t from, std::size_t to, std::size_t edge) {
    std::vector<std::size_t> path{from, to};
    seen[edge] = true;
    while(!is_node[to]) {
      const auto& [one, other] = std::tie(incidences[to][0], incidences[to][1]);
      std::tie(to, edge) = one.second == edge ? other : one;
      path.push_back(to);
      seen[edge] = true;
    }
    return path;
  };
  for(std::size_t v = 0; v < incidences.size(); ++v) {
    if(!is_node[v])
      continue;
    if(incidences[v].empty()) {
      result.emplace_back();
      result.back().vertices = {v};
    }
    for(const auto& [w, e] : incidences[v])
      if(!seen[e]) {
        std::vector<std::size_t> path = follow(v, w, e);
        result.emplace_back();
        result.back().vertices = std::move(path);
      }
  }
  return result;
}

/// The number of the component of each vertex, in the order of their first vertices. O(n).
inline std::vector<std::size_t> component_numbers(const Incidences& incidences)
{
  std::vector<std::size_t> result(incidences.size());
  std::size_t components = 0;
  for_each_component(incidences, [&](const std::vector<std::size_t>& members) {
    for(std::size_t v : members)
      result[v] = components;
    ++components;
  });
  return result;
}

/// For every vertex the branches that end there, each once. O(n).
inline std::vector<std::vector<std::size_t>>
branches_at_ends(const std::vector<Plain_branch>& branches, std::size_t vertices)
{
  std::vector<std::vector<std::size_t>> result(vertices);
  for(std::size_t b = 0; b < branches.size(); ++b) {
    const std::size_t front = branches[b].vertices.front(), back = branches[b].vertices.back();
    result[front].push_back(b);
    if(front != back)
      result[back].push_back(b);
  }
  return result;
}

/// Orders branches by component, then by the distance of their far ends from the nearest root,
/// along the skeleton, and directs them away from it. Sets parents, and which branches close a
/// cycle. O(n log n).
inline std::vector<Plain_branch> directed_from(const std::vector<std::size_t>& roots,
                                               const Incidences& incidences,
                                               std::vector<Plain_branch> branches)
{
  constexpr std::size_t none = Plain_branch::none;
  const std::vector<std::size_t> component = component_numbers(incidences);
  const std::vector<std::vector<std::size_t>> touching =
      branches_at_ends(branches, incidences.size());

  struct Node
  {
    double distance = std::numeric_limits<double>::infinity();
    std::size_t shortest = none;  // the branch by which it is reached, in `branches`
    std::size_t branch_to = none; // the same in the result
    bool settled = false;
  };
  std::vector<Node> nodes(incidences.size());
  std::vector<Plain_branch> result;
  const auto append = [&](std::size_t b, std::size_t from) {
    result.push_back(std::move(branches[b]));
    std::vector<std::size_t>& path = result.back().vertices;
    if(path.front() != from)
      std::reverse(path.begin(), path.end());
    result.back().parent = nodes[from].branch_to;
  };
  const auto other_end = [&](std::size_t b, std::size_t v) {
    const std::vector<std::size_t>& path = branches[b].vertices;
    return path.front() == v ? path.back() : path.front();
  };

  using Reached = std::tuple<std::size_t, double, std::size_t>; // component, distance, vertex
  std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
  for(std::size_t v : roots) {
    nodes[v].distance = 0;
    queue.emplace(component[v], 0., v);
  }
  while(!queue.empty()) {
    const std::size_t v = std::get<2>(queue.top());
    queue.pop();
    Node& node = nodes[v];
    if(std::exchange(node.settled, true))
      continue;
    if(node.shortest != none) {
      append(node.shortest, other_end(node.shortest, v));
      node.branch_to = result.size() - 1;
    }
    for(std::size_t b : touching[v]) {
      if(b == node.shortest)
        continue;
      const std::size_t w = other_end(b, v);
      const double distance = node.distance + branches[b].length;
      if(nodes[w].settled) {
        append(b, w);
        result.back().closes_cycle = result.back().vertices.size() > 1;
      }
      else if(distance < nodes[w].distance) {
        nodes[w].distance = distance;
        nodes[w].shortest = b;
        queue.emplace(component[w], distance, w);
      }
    }
  }
  return result;
}

/// Sets axes, orders and angles of branches whose parents come before them. O(n).
inline void set_axes(const Plain_skeleton& skeleton, std::vector<Plain_branch>& branches)
{
  constexpr std::size_t none = Plain_branch::none;
  std::vector<double> growth(branches.size()); // length of a branch and all that grows from it
  for(std::size_t b = branches.size(); b-- > 0;) {
    growth[b] += branches[b].length;
    if(branches[b].parent != none)
      growth[branches[b].parent] += growth[b];
  }
  std::vector<std::size_t> heir(branches.size(), none); // the child that continues the axis
  for(std::size_t b = 0; b < branches.size(); ++b) {
    const std::size_t parent = branches[b].parent;
    if(parent == none || branches[b].closes_cycle)
      continue;
    if(heir[parent] == none || growth[b] > growth[heir[parent]])
      heir[parent] = b;
  }
  std::size_t axes = 0;
  std::vector<std::vector<Plain_branch*>> children(branches.size());
  for(std::size_t b = 0; b < branches.size(); ++b) {
    Plain_branch& branch = branches[b];
    if(branch.parent == none) {
      branch.axis = axes++;
      continue;
    }
    const Plain_branch& parent = branches[branch.parent];
    const bool continues = heir[branch.parent] == b;
    branch.axis = continues ? parent.axis : axes++;
    branch.order = parent.order + (continues ? 0 : 1);
    children[branch.parent].push_back(&branch);
  }
  for(std::size_t b = 0; b < branches.size(); ++b)
    if(!children[b].empty())
      measure_angles(skeleton, branches[b], children[b]);
}

/// Returns the branches of a skeleton, see `skeleton_branches()`. O(n log n).
/// \param roots may lack the root of a component: it gets the end with the least z coordinate
inline std::vector<Plain_branch> ordered_branches(const Plain_skeleton& skeleton,
                                                  std::vector<std::size_t> roots)
{
  const Incidences incidences = incidences_of(skeleton);
  add_missing_roots(skeleton, incidences, roots);
  std::vector<bool> is_node(skeleton.vertices.size());
  for(std::size_t v = 0; v < is_node.size(); ++v)
    is_node[v] = incidences[v].size() != 2;
  for(std::size_t v : roots)
    is_node[v] = true;

  std::vector<Plain_branch> branches = paths_between(is_node, incidences, skeleton.edges.size());
  for(Plain_branch& branch : branches)
    measure_branch(skeleton, branch);
  branches = directed_from(roots, incidences, std::move(branches));
  set_axes(skeleton, branches);
  return branches;
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_BRANCHES_ORDERED_BRANCHES_H
