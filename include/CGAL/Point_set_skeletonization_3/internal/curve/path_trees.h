// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PATH_TREES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PATH_TREES_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Union_find.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Refined_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/project_to_lines.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/K_nearest_neighbors.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Component_gaps.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Patch_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <queue>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Replaces the loose patches of a quotient, those of limbs that are not resolved, by trees.
///
/// A tree consists of shortest paths from its root, where what is resolved costs nothing and a gap
/// costs more than as many steps: they follow limbs and lead from one to another where they are
/// closest. Of these paths, those are kept that lead to what is resolved, and then, the longest
/// first, those that stick out of what was kept before by more than it is thick (TEASAR, Sato et
/// al. 2000), both only as far as more of them and of their branches was seen than is missing:
/// what leads from leaf to leaf through the air is no limb. Each patch belongs to the vertex whose
/// tube it is in.
class Path_trees
{
public:
  /// `places` are those of the patches, of loose ones in the middle of their limb. Refers to all
  /// other arguments but the last. O(n log n).
  Path_trees(const Surface_quotient& quotient, const Surface& surface, const Samples& samples,
             std::vector<Vector3> places, const std::vector<Patch_pair>& pairs,
             const std::vector<bool>& is_loose, Concurrency concurrency)
    : patches_(surface.patches), samples_(samples), gaps_(surface, concurrency),
      places_(std::move(places)), is_loose_(is_loose), tree_(places_, concurrency),
      result_(quotient),
      set_of_patch_(patches_.size(), none), thickness_(patches_.size(), 0),
      owner_(patches_.size(), none), squared_distance_to_owner_(patches_.size(), infinity)
  {
    Union_find sets = result_.take_out(is_loose, pairs);
    patches_of_set_.resize(result_.number_of_vertices());
    for(std::size_t i = 0; i < patches_.size(); ++i)
      if(!is_loose[i]) {
        set_of_patch_[i] = sets.find(result_.vertex_of(i));
        patches_of_set_[set_of_patch_[i]].push_back(i);
      }
    edges_.resize(patches_.size() + patches_of_set_.size());
    before_.resize(edges_.size());
    distance_.assign(edges_.size(), infinity);
    beyond_.resize(edges_.size());
    branches_.resize(edges_.size());
    connect(concurrency);
  }

  /// Returns the quotient with trees. To be called once. O(n log n) in practice.
  Surface_quotient run()
  {
    for(std::size_t i = 0; i < patches_.size(); ++i)
      if(is_loose_[i] && owner_[i] == none)
        grow_tree(i);
    for(std::size_t i = 0; i < patches_.size(); ++i)
      if(is_loose_[i] && !is_kept(i)) // it may be in the tube of a tree that has not reached it
        result_.add_to_front(owner_[i], i);
    return result_.take(patches_, samples_);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Of the graph that paths run through. Its nodes are the patches, those that are loose, and then
  /// the sets of vertices that are connected without them.
  struct Edge // small: there are dozens for each patch
  {
    std::uint32_t from, to; ///< Patches.
    float cost;
  };

  /// The distance of the places of two patches.
  double distance(std::size_t i, std::size_t j) const { return (places_[i] - places_[j]).norm(); }

  /// The node of a patch.
  std::size_t node_of(std::size_t patch) const
  {
    return is_loose_[patch] ? patch : patches_.size() + set_of_patch_[patch];
  }

  /// The node before one that the last search has reached; `none` before its start.
  std::size_t node_before(std::size_t node) const
  {
    return is_start(node) ? none : node_of(before_[node].from);
  }

  bool is_start(std::size_t node) const { return distance_[node] == 0; }

  /// Whether what is resolved may be one limb at two patches: not if both have medial balls, and
  /// yet are not in one set.
  bool may_be_cut(std::size_t i, std::size_t j) const
  {
    const auto is_measured = [this](std::size_t k) {
      return is_off_surface(samples_[k], patches_[k]);
    };
    return set_of_patch_[i] != set_of_patch_[j] && !(is_measured(i) && is_measured(j));
  }

  /// Connects loose patches to their neighbours, and sets where they may be one limb. Measures how
  /// thick limbs are at loose patches: their root mean square distance from the middle.
  void connect(Concurrency concurrency)
  {
    constexpr std::size_t neighbors = 14; // more than the 12 that surround a place in space
    constexpr double widest_gap = 3.5;    // spacings: wider ones are for bridges
    const K_nearest_neighbors nearest = k_nearest_neighbors(tree_, neighbors + 1, concurrency);
    for(std::size_t i = 0; i < patches_.size(); ++i) {
      double sum = 0, number = 0;
      for(const Neighbor& neighbor : nearest[i]) {
        const std::size_t j = neighbor.index;
        if(is_loose_[i] && is_loose_[j]) {
          sum += (places_[j] - patches_[j].mean).squaredNorm();
          ++number;
        }
        const double spacing = (std::max)(patches_[i].spacing, patches_[j].spacing);
        const double length = std::sqrt(neighbor.squared_distance);
        if(i == j || length > widest_gap * spacing ||
           !(is_loose_[i] || is_loose_[j] || may_be_cut(i, j)))
          continue;
        const double gap = (std::max)(1.0, gaps_.between(i, j) / gaps_.grain(i, j));
        const auto cost = static_cast<float>(gap * gap * (std::max)(length, least_spacing));
        const auto a = static_cast<std::uint32_t>(i), b = static_cast<std::uint32_t>(j);
        edges_[node_of(i)].push_back({a, b, cost});
        edges_[node_of(j)].push_back({b, a, cost});
      }
      if(number > 0)
        thickness_[i] = std::sqrt(sum / number);
    }
  }

  /// Grows a tree through all that is connected with a patch, from the middle of a longest path,
  /// whose way to any limb is short.
  void grow_tree(std::size_t patch)
  {
    std::vector<std::size_t> longest{spread(spread(patch).back()).back()};
    while(!is_start(longest.back()))
      longest.push_back(node_before(longest.back()));
    const std::size_t root = longest[longest.size() / 2];
    const std::vector<std::size_t> order = spread(root);
    if(root < patches_.size())
      keep(root);
    look_beyond(order);
    for(std::size_t node : order)
      if(node >= patches_.size())
        keep_set(node);
    for(auto node = order.rbegin(); node != order.rend(); ++node)
      if(*node < patches_.size() && owner_[*node] == none)
        keep_if_long(*node);
    for(std::size_t node : order)
      if(node < patches_.size() && owner_[node] == none)
        owner_[node] = owner_before(node);
  }

  /// Finds the shortest paths from a node (Dijkstra). Returns the nodes reached, the nearest first.
  std::vector<std::size_t> spread(std::size_t start)
  {
    using Reached = std::pair<double, std::size_t>;
    std::priority_queue<Reached, std::vector<Reached>, std::greater<Reached>> queue;
    for(std::size_t node : reached_)
      distance_[node] = infinity;
    reached_.clear();
    distance_[start] = 0;
    queue.push({0., start});
    while(!queue.empty()) {
      const auto [distance, node] = queue.top();
      queue.pop();
      if(distance > distance_[node])
        continue; // a shorter path was found
      Progress::poll();
      reached_.push_back(node);
      for(const Edge& edge : edges_[node]) {
        const std::size_t next = node_of(edge.to);
        const double further = distance + static_cast<double>(edge.cost);
        if(further < distance_[next]) {
          distance_[next] = further;
          before_[next] = edge;
          queue.push({further, next});
        }
      }
    }
    return reached_;
  }

  /// Whether a patch is on a path that is kept.
  bool is_kept(std::size_t patch) const { return squared_distance_to_owner_[patch] < 0; }

  /// The vertex that what is before a node belongs to, on the path to it; `none` if to none yet.
  std::size_t owner_before(std::size_t node) const
  {
    const std::size_t patch = before_[node].from;
    return is_loose_[patch] ? owner_[patch] : result_.vertex_of(patch);
  }

  /// Makes a vertex the owner of the loose patches around a place that are nearer to it than to
  /// their owner.
  void cover(const Vector3& place, double radius, std::size_t vertex)
  {
    tree_.visit_within(place, radius, [&](std::size_t k, double squared) {
      const std::size_t i = tree_.order()[k];
      if(is_loose_[i] && squared < squared_distance_to_owner_[i]) {
        owner_[i] = vertex;
        squared_distance_to_owner_[i] = squared;
      }
    });
  }

  /// Makes a patch a vertex, the owner of all in its tube.
  void keep(std::size_t patch)
  {
    owner_[patch] = result_.add_front_at(places_[patch]);
    squared_distance_to_owner_[patch] = -1; // it stays its own
    result_.add_to_front(owner_[patch], patch);
    constexpr double thin = 0.7; // spacings: places of a limb that has no thickness
    cover(places_[patch], thickness_[patch] / 2 + thin * patches_[patch].spacing, owner_[patch]);
  }

  /// Appends the patches before a node that belong to no vertex. Returns the vertex before them.
  std::size_t path_before(std::size_t node, std::vector<std::size_t>& path) const
  {
    for(; owner_before(node) == none; node = node_before(node))
      path.push_back(node_before(node));
    return owner_before(node);
  }

  /// Keeps a path to a vertex. Returns the vertex of its first patch, the farthest.
  std::size_t keep_path(const std::vector<std::size_t>& path, std::size_t vertex)
  {
    for(auto i = path.rbegin(); i != path.rend(); ++i) {
      keep(*i);
      result_.add_edge(owner_[*i], vertex);
      vertex = owner_[*i];
    }
    return vertex;
  }

  /// How much is missing between two patches on a path: all between their components, unless these
  /// are next to each other.
  double missing(std::size_t i, std::size_t j) const
  {
    constexpr double reach = 1.5; // grains; components next to each other are seldom further apart
    const double gap = (std::min)(gaps_.between(i, j), distance(i, j));
    return gap > reach * gaps_.grain(i, j) ? gap : 0;
  }

  /// How much more was seen between two patches than is missing.
  double seen_between(std::size_t i, std::size_t j) const
  {
    return distance(i, j) - 2 * missing(i, j);
  }

  /// The same between a node and the one before it.
  double seen_before(std::size_t node) const
  {
    return seen_between(before_[node].from, before_[node].to);
  }

  /// How long a set of vertices is.
  double size_of_set(std::size_t set) const
  {
    Eigen::AlignedBox3d box;
    for(std::size_t i : patches_of_set_[set])
      box.extend(patches_[i].mean);
    return box.diagonal().norm();
  }

  /// How long a branch is at least: longer than the limb that it begins at is thick, and than
  /// chance: half a spacing. `foot` is its first patch, after `before`.
  double least_length(std::size_t foot, std::size_t before) const
  {
    return 2 * (std::max)(thickness_[foot], thickness_[before]) + patches_[foot].spacing / 2;
  }

  /// Sets how much more was seen than is missing from each node on, along the best path away from
  /// the start and along all other branches, less what a branch is long at least and than its first
  /// patch: of a wide leaf, branches that are no longer will be pruned. `order` is what `spread()`
  /// returned.
  void look_beyond(const std::vector<std::size_t>& order)
  {
    for(std::size_t node : order)
      beyond_[node] = branches_[node] = 0;
    for(auto node = order.rbegin(); node != order.rend(); ++node) {
      beyond_[*node] += branches_[*node];
      if(*node >= patches_.size())
        beyond_[*node] += size_of_set(*node - patches_.size());
      if(is_start(*node))
        continue;
      const Edge& edge = before_[*node];
      const std::size_t before = node_before(*node);
      const double here = beyond_[*node] + seen_before(*node), other = beyond_[before];
      beyond_[before] = (std::max)(other, here);
      const double least = least_length(edge.to, edge.from) + patches_[edge.to].spacing;
      branches_[before] += (std::max)(0.0, (std::min)(other, here) - least);
    }
  }

  /// Whether from a node backwards nowhere on its path more is missing than was seen until there and
  /// beyond the node. The path is what `path_before()` appended.
  bool is_seen(std::size_t node, const std::vector<std::size_t>& path) const
  {
    double seen = beyond_[node] + seen_before(node);
    for(auto before = path.begin(); before != path.end() && seen >= 0; ++before)
      seen += seen_before(*before);
    return seen >= 0;
  }

  /// Joins a set of vertices to the tree, unless more is missing than was seen; loose patches next
  /// to it belong to it in any case.
  void keep_set(std::size_t node)
  {
    if(!is_start(node)) {
      std::vector<std::size_t> path;
      const std::size_t end = path_before(node, path);
      if(is_seen(node, path))
        result_.add_edge(result_.vertex_of(before_[node].to), keep_path(path, end));
    }
    for(std::size_t i : patches_of_set_[node - patches_.size()])
      cover(patches_[i].mean, patches_[i].spacing, result_.vertex_of(i));
  }

  /// Keeps the path to a patch, up to where most more of it and of its branches was seen than is
  /// missing, if that is enough for a branch.
  void keep_if_long(std::size_t patch)
  {
    std::vector<std::size_t> path{patch};
    const std::size_t end = path_before(patch, path);
    const std::size_t foot = path.back(), before = before_[foot].from;
    double excess = is_loose_[before]
                      ? seen_between(foot, before)
                      : -missing(foot, before); // the way from what is resolved is no limb
    double most = excess;
    std::size_t last = path.size() - 1;
    for(std::size_t k = last; k-- > 0;) {
      excess += seen_between(path[k], path[k + 1]) + branches_[path[k]];
      if(excess >= most) {
        most = excess;
        last = k;
      }
    }
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(last));
    if(most > least_length(foot, before))
      keep_path(path, end);
  }

  const Patches& patches_;
  const Samples& samples_;
  const Component_gaps gaps_;
  const std::vector<Vector3> places_;
  const std::vector<bool>& is_loose_;
  Box_tree tree_; ///< Of the places.
  Refined_quotient result_;

  // Sets of vertices that are connected without loose patches; each is known by its first vertex.
  std::vector<std::vector<std::size_t>> patches_of_set_;
  std::vector<std::size_t> set_of_patch_; ///< `none` if it is loose.

  std::vector<std::vector<Edge>> edges_; ///< Of each node.
  std::vector<double> thickness_;        ///< Of the limb at each patch.

  // Of each node that the last search has reached.
  std::vector<double> distance_;
  std::vector<Edge> before_; ///< From the node before it, on the path to it.
  std::vector<std::size_t> reached_;
  std::vector<double> beyond_; ///< How much more was seen from it on than is missing.
  std::vector<double> branches_; ///< The same of all branches that begin at it but the best.

  // Of each loose patch.
  std::vector<std::size_t> owner_; ///< The vertex that it belongs to.
  std::vector<double> squared_distance_to_owner_;
};

/// The patches of pieces that are not resolved, and the parts of the surface between them that have
/// no cross-section: they are no limb, unless a part is most of the surface. O(n log n).
inline std::vector<bool> loose_patches(const Surface_quotient& quotient,
                                       const std::vector<Patch_pair>& pairs,
                                       const std::vector<bool>& is_unresolved)
{
  const std::size_t size = is_unresolved.size();
  std::vector<bool> result(size), has_cross_section(size, false);
  std::vector<std::size_t> size_of_part(size, 0), size_of_whole(size, 0);
  for(std::size_t i = 0; i < size; ++i)
    result[i] = is_unresolved[i] && is_piece(quotient.vertex_of_patch[i], quotient);
  Union_find parts(size), whole(size);
  for(const Patch_pair& pair : pairs) {
    whole.join(pair.a, pair.b);
    if(!result[pair.a] && !result[pair.b])
      parts.join(pair.a, pair.b);
  }
  for(std::size_t i = 0; i < size; ++i) {
    ++size_of_whole[whole.find(i)];
    ++size_of_part[parts.find(i)];
    if(!is_piece(quotient.vertex_of_patch[i], quotient))
      has_cross_section[parts.find(i)] = true;
  }
  for(std::size_t i = 0; i < size; ++i) {
    const std::size_t part = parts.find(i);
    if(!result[i] && !has_cross_section[part])
      result[i] = 2 * size_of_part[part] <= size_of_whole[whole.find(i)];
  }
  return result;
}

/// Part 3b: replaces the patches of pieces that are not resolved by trees. Nothing there has a ring
/// around it that a separator could be, and all of a crown in leaf is one piece, with the limbs
/// that it grows on. What runs through it are shortest paths in the middle of its limbs, joined to
/// what is resolved. Nothing was seen of them from all sides: they close no cycle. O(n log n) in
/// practice; O(n) if all is resolved.
/// \param pairs adjacent patches, `Ball_overlaps::pairs()`
inline Surface_quotient with_path_trees(Surface_quotient quotient, const Surface& surface,
                                        const Samples& samples,
                                        const std::vector<Patch_pair>& pairs,
                                        const std::vector<bool>& is_unresolved,
                                        Concurrency concurrency)
{
  const auto has_any = [](const std::vector<bool>& marks) {
    return std::find(marks.begin(), marks.end(), true) != marks.end();
  };
  if(!has_any(is_unresolved))
    return quotient;
  const std::vector<bool> is_loose = loose_patches(quotient, pairs, is_unresolved);
  if(!has_any(is_loose))
    return quotient;
  const Patches& patches = surface.patches;
  std::vector<Vector3> places, loose;
  std::vector<double> spacings;
  for(std::size_t i = 0; i < patches.size(); ++i) {
    places.push_back(patches[i].mean);
    if(is_loose[i]) {
      loose.push_back(patches[i].mean);
      spacings.push_back(patches[i].spacing);
    }
  }
  loose = project_to_lines(std::move(loose), spacings, concurrency);
  for(std::size_t i = 0, k = 0; i < patches.size(); ++i)
    if(is_loose[i])
      places[i] = loose[k++];
  return Path_trees(quotient, surface, samples, std::move(places), pairs, is_loose, concurrency)
    .run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_PATH_TREES_H
