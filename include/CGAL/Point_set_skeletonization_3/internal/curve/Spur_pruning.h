// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPUR_PRUNING_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPUR_PRUNING_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Blocks.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Surface_parts.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <numeric>
#include <queue>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Finds branches that are no limbs, and bridges of a few outliers.
///
/// The least slender is removed first: then its junction may have degree 2 and two short branches
/// become a long one. A branch is measured once, and again when it was joined with another. It is
/// known by its ends, and measured from its tip only as far as it takes to see that it is slender:
/// O(n log n) in practice. What stands for all of a part of the surface stays: between it and the
/// rest is a gap, so it is no bump of a limb, however round.
class Spur_pruning
{
public:
  using Visit_ring = std::function<void(const std::vector<Vector3>& ring,
                                        const std::vector<Vector3>& root)>;
  using For_rings = std::function<void(std::size_t junction, const std::vector<std::size_t>& limb,
                                       const Visit_ring& visit)>;

  /// `surface[v]` are the surface points of vertex v. Refers to all arguments. O(n).
  /// \param for_rings called as `Limb_roots::for_rings()`; empty: limbs have no roots
  /// \param parts of the surface, none of which is removed
  Spur_pruning(const Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
               const Curve_options& options, For_rings for_rings = {}, Surface_parts parts = {})
    : options_(options), graph_(graph), surface_(surface), for_rings_(std::move(for_rings)),
      parts_(std::move(parts)),
      degree_(graph.vertices.size(), 0),
      sum_(graph.vertices.size(), 0), removed_(graph.vertices.size(), false),
      first_(graph.vertices.size() + 1, 0), to_(2 * graph.edges.size()), back_(to_.size()),
      edge_(to_.size()), end_(to_.size(), none)
  {
    for(const Skeleton_graph::Edge& e : graph.edges) {
      ++degree_[e.first];
      ++degree_[e.second];
      sum_[e.first] += e.second;
      sum_[e.second] += e.first;
    }
    std::partial_sum(degree_.begin(), degree_.end(), first_.begin() + 1);
    std::vector<std::size_t> free(first_.begin(), first_.end() - 1);
    for(std::size_t e = 0; e < graph.edges.size(); ++e) {
      const std::size_t a = free[graph.edges[e].first]++, b = free[graph.edges[e].second]++;
      to_[a] = graph.edges[e].second;
      to_[b] = graph.edges[e].first;
      back_[a] = b;
      back_[b] = a;
      edge_[a] = edge_[b] = e;
    }
    for(std::size_t way = 0; way < to_.size(); ++way)
      if(degree_[from(way)] != 2 && end_[way] == none)
        join(way, way_back(way));
  }

  /// Returns a mark for each vertex of a spur. To be called once.
  std::vector<bool> spurs()
  {
    for(std::size_t way = 0; way < to_.size(); ++way)
      if(end_[way] != none && way < end_[way])
        consider(way);
    while(!queue_.empty()) {
      const Spur spur = queue_.top();
      queue_.pop();
      if(!is_current(spur) || (!spur.has_tip && is_bridge(spur)))
        continue;
      Progress::poll();
      const std::vector<std::size_t> vertices = vertices_of(spur);
      if(!parts_.are_last(vertices))
        remove(spur, vertices);
    }
    return std::move(removed_);
  }

private:
  static constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

  /// A branch to be removed.
  struct Spur
  {
    double slenderness;
    std::size_t order; ///< Of two that are equally slender, the one with the first vertex.
    std::size_t way;   ///< From its junction.
    std::size_t end;   ///< From its tip or its other junction.
    bool has_tip;

    bool operator>(const Spur& other) const
    {
      return std::tie(slenderness, order) > std::tie(other.slenderness, other.order);
    }
  };

  /// The vertex where a way begins.
  std::size_t from(std::size_t way) const { return to_[back_[way]]; }

  /// The neighbour of `v` that is not `before`. \pre `v` has two
  std::size_t next(std::size_t v, std::size_t before) const { return sum_[v] - before; }

  /// The way from the last vertex of a branch to the one before it, for that from its first vertex.
  /// \pre nothing was removed
  std::size_t way_back(std::size_t way) const
  {
    while(degree_[to_[way]] == 2) {
      const std::size_t a = first_[to_[way]];
      way = a == back_[way] ? a + 1 : a;
    }
    return back_[way];
  }

  /// Makes two ways the ends of one branch.
  void join(std::size_t a, std::size_t b)
  {
    end_[a] = b;
    end_[b] = a;
  }

  /// Adds the branch of a way to the queue if it is to be removed, unless something better is: one
  /// with a tip that is not slender, or few points between two junctions.
  void consider(std::size_t way)
  {
    if(end_[way] == none)
      return;
    if(degree_[from(way)] == 1)
      way = end_[way];
    const std::size_t end = end_[way], last = from(end);
    if(degree_[from(way)] == 1)
      return;
    const bool has_tip = degree_[last] == 1, is_thin = this->is_thin(way, has_tip);
    if(!has_tip && (to_[way] == last || !is_thin))
      return;
    const double slenderness = is_thin ? 0 : this->slenderness(end);
    if(slenderness >= options_.slenderness)
      return;
    const bool is_first = std::make_pair(from(way), to_[way]) < std::make_pair(last, to_[end]);
    queue_.push({slenderness, is_first ? way : end, way, end, has_tip});
  }

  /// Whether the branch is still there, and the same.
  bool is_current(const Spur& spur) const
  {
    return end_[spur.way] == spur.end && degree_[from(spur.way)] > 1 &&
           spur.has_tip == (degree_[from(spur.end)] == 1);
  }

  /// The vertices of a branch but its junctions, from that of its way on.
  std::vector<std::size_t> vertices_of(const Spur& spur) const
  {
    const std::size_t last = from(spur.end);
    std::vector<std::size_t> result;
    std::size_t before = from(spur.way);
    for(std::size_t v = to_[spur.way]; v != last; before = std::exchange(v, next(v, before)))
      result.push_back(v);
    if(spur.has_tip)
      result.push_back(last);
    return result;
  }

  /// Removes a branch, `vertices_of()` it. Where two others are left at a junction, they become
  /// one; where one is left, it has a tip there.
  void remove(const Spur& spur, const std::vector<std::size_t>& vertices)
  {
    const std::size_t junction = from(spur.way), last = from(spur.end);
    for(std::size_t v : vertices) {
      removed_[v] = true;
      parts_.remove(v);
    }
    end_[spur.way] = end_[spur.end] = none;
    leave(junction, to_[spur.way]);
    if(!spur.has_tip) {
      leave(last, to_[spur.end]);
      has_opened_ = true;
    }
    std::vector<std::size_t> changed;
    for(std::size_t v : {junction, last})
      if(!removed_[v] && degree_[v] < 3)
        changed.push_back(branch_left_at(v));
    for(std::size_t way : changed)
      if(way != none)
        consider(way);
  }

  /// The way along the branch that is left at a vertex where one or two were; `none` if it has no
  /// end.
  std::size_t branch_left_at(std::size_t v)
  {
    std::vector<std::size_t> ways;
    for(std::size_t way = first_[v]; way < first_[v + 1]; ++way)
      if(!removed_[to_[way]])
        ways.push_back(way);
    if(ways.size() < 2 || end_[ways[0]] == none)
      return ways.empty() ? none : ways[0];
    const std::size_t a = end_[ways[0]], b = end_[ways[1]];
    end_[ways[0]] = end_[ways[1]] = none;
    if(a != ways[1])
      join(a, b);
    return a;
  }

  void leave(std::size_t v, std::size_t neighbor)
  {
    --degree_[v];
    sum_[v] -= neighbor;
  }

  /// Whether a branch, without its junctions, has fewer surface points than any limb: than a ring
  /// and, between two junctions, than these, which on lines of points have no rings either, and
  /// than a row of points between them. On a line every point is a cross-section.
  bool is_thin(std::size_t way, bool has_tip) const
  {
    const std::size_t last = from(end_[way]);
    std::size_t before = from(way), v = to_[way], points = 0;
    bool is_on_line = graph_.vertices[last].is_on_line && has_tip;
    for(; v != last && static_cast<double>(points) < options_.least_points;
        before = std::exchange(v, next(v, before))) {
      points += surface_[v].size();
      is_on_line = is_on_line || graph_.vertices[v].is_on_line;
    }
    if(is_on_line)
      return false;
    if(v == last && has_tip)
      points += surface_[v].size();
    return static_cast<double>(points) < options_.least_points &&
           (has_tip || (points < (std::min)(surface_[from(way)].size(), surface_[last].size()) &&
                        is_sparser_than_row(points, from(way), last)));
  }

  /// Whether points between two vertices are fewer than those of a row of points. Two halves of a
  /// junction of thin limbs are closer to each other than that.
  bool is_sparser_than_row(std::size_t points, std::size_t v, std::size_t w) const
  {
    const Skeleton_graph::Vertex &a = graph_.vertices[v], &b = graph_.vertices[w];
    const double spacing = (a.resolution + b.resolution) / 2;
    return static_cast<double>(points) * spacing < (a.position - b.position).norm();
  }

  /// Whether the ends of a branch are not connected without it. A bridge remains one.
  bool is_bridge(const Spur& spur)
  {
    if(is_bridge_.empty())
      find_bridges();
    return is_bridge_[edge_[spur.way]] || (has_opened_ && !is_detour(spur));
  }

  /// Whether the ends of a branch are connected without it. Searches from both alternately: visits
  /// about twice the smaller part if there are two.
  bool is_detour(const Spur& spur) const
  {
    const std::array<std::size_t, 2> ends{from(spur.way), from(spur.end)};
    if(ends[0] == ends[1])
      return true;
    std::unordered_map<std::size_t, std::size_t> side{{ends[0], 0}, {ends[1], 1}};
    std::array<std::vector<std::size_t>, 2> reached;
    reached[0] = {ends[0]};
    reached[1] = {ends[1]};
    for(std::size_t next = 0; next < (std::min)(reached[0].size(), reached[1].size()); ++next)
      for(std::size_t k = 0; k < 2; ++k) {
        const std::size_t v = reached[k][next];
        for(std::size_t way = first_[v]; way < first_[v + 1]; ++way) {
          if(removed_[to_[way]] || way == spur.way || way == spur.end)
            continue;
          const auto [found, is_new] = side.emplace(to_[way], k);
          if(is_new)
            reached[k].push_back(to_[way]);
          else if(found->second != k)
            return true;
        }
      }
    return false;
  }

  /// Finds the edges whose ends are not connected without them. The ends of a branch stay connected
  /// without it if it has none of them. O(n log n).
  void find_bridges()
  {
    Skeleton_graph rest;
    rest.vertices.resize(graph_.vertices.size());
    for(const Skeleton_graph::Edge& e : graph_.edges)
      if(!removed_[e.first] && !removed_[e.second])
        rest.edges.push_back(e);
    const Blocks blocks = blocks_of(rest);
    std::size_t next = 0;
    for(const Skeleton_graph::Edge& e : graph_.edges)
      is_bridge_.push_back(removed_[e.first] || removed_[e.second] || blocks.is_bridge[next++]);
  }

  /// The largest ratio of the length beyond a cross-section of a branch to half its width; or, if
  /// that is enough for a limb, the first one found from the tip. If no separator is enough, the
  /// rings at its root may be. Among twigs of single points each is a cross-section. `end` is the
  /// way from the tip.
  double slenderness(std::size_t end) const
  {
    const std::size_t junction = from(end_[end]);
    double result = 0;
    std::vector<Vector3> beyond;
    std::vector<std::size_t> limb;
    for(std::size_t v = from(end), w = to_[end];
        v != junction && result < options_.slenderness;
        v = std::exchange(w, next(w, v))) {
      const Skeleton_graph::Vertex& vertex = graph_.vertices[v];
      const std::vector<Vector3>& points = surface_[v];
      beyond.insert(beyond.end(), points.begin(), points.end());
      limb.push_back(v);
      if(vertex.is_cross_section && !points.empty())
        result = (std::max)(result, slenderness(vertex.position, points, beyond, v,
                                                graph_.vertices[w].position));
    }
    const bool has_root = for_rings_ &&
                          std::none_of(limb.begin(), limb.end(), [this](std::size_t v) {
                            return is_open(graph_.vertices[v]); // there is no ring around a strip
                          });
    if(result >= options_.slenderness || !has_root)
      return result;
    const std::size_t before_root = beyond.size();
    for_rings_(junction, limb,
               [&](const std::vector<Vector3>& ring, const std::vector<Vector3>& root) {
                 if(static_cast<double>(ring.size()) < options_.least_points)
                   return;
                 beyond.resize(before_root);
                 beyond.insert(beyond.end(), root.begin(), root.end());
                 const Vector3 sum = std::accumulate(ring.begin(), ring.end(),
                                                     Vector3(Vector3::Zero()));
                 const Vector3 middle = sum / static_cast<double>(ring.size());
                 result = (std::max)(result,
                                     slenderness(middle, ring, beyond, limb.back(), middle));
               });
    return result;
  }

  /// Half the width that a ring has at least. Around a line of points it shows none: two lines are
  /// told from one if they are as far apart as two points of a line.
  double least_width(std::size_t v) const { return half_a_spacing * graph_.vertices[v].resolution; }

  /// The ratio of the length beyond a ring to half its width. The ring is one of them. One of fewer
  /// points than it takes to go around a limb shows no plane, and may be as long as the limb is
  /// wide: its width is that across the direction from the place before it to what is beyond. (If
  /// it is all there is beyond, the direction from its middle is none.) `v` is its vertex.
  double slenderness(const Vector3& middle, const std::vector<Vector3>& ring,
                     const std::vector<Vector3>& beyond, std::size_t v,
                     const Vector3& before) const
  {
    const Vector3 sum = std::accumulate(beyond.begin(), beyond.end(), Vector3(Vector3::Zero()));
    const bool is_plane = static_cast<double>(ring.size()) >= options_.least_points;
    const Vector3 axis = (sum / static_cast<double>(beyond.size()) - before).normalized();
    double width = least_width(v);
    for(const Vector3& p : ring) {
      const Vector3 offset = p - middle;
      const double along = is_plane ? 0 : axis.dot(offset);
      width = (std::max)(width, (offset - along * axis).norm());
    }
    // Without the furthest 5 %, at least two: outliers stick out of the surface. A line has few
    // points, and one outlier at its end.
    const std::size_t fewest = graph_.vertices[v].is_on_line ? 1 : 2;
    std::vector<double> length;
    for(const Vector3& p : beyond)
      length.push_back((p - middle).norm());
    const std::size_t last = length.size() - 1;
    const auto reached = length.begin() + static_cast<std::ptrdiff_t>(
        last - (std::min)(last, (std::max)(fewest, last / 20)));
    std::nth_element(length.begin(), reached, length.end());
    return width > 0 ? *reached / width : 0;
  }

  const Curve_options& options_;
  const Skeleton_graph& graph_;
  const std::vector<std::vector<Vector3>>& surface_;
  For_rings for_rings_;
  Surface_parts parts_; ///< Without what was removed.

  // For each vertex.
  std::vector<std::size_t> degree_; ///< Number of neighbours left.
  std::vector<std::size_t> sum_;    ///< Of the numbers of the neighbours left.
  std::vector<bool> removed_;

  // Ways from a vertex to a neighbour. Those from vertex v are [first_[v], first_[v + 1]), in the
  // order of the edges.
  std::vector<std::size_t> first_;
  std::vector<std::size_t> to_;   ///< The neighbour.
  std::vector<std::size_t> back_; ///< The opposite way.
  std::vector<std::size_t> edge_;
  std::vector<std::size_t> end_;  ///< From an end of a branch: the way from its other end.

  std::vector<bool> is_bridge_; ///< For each edge, before a cycle was opened; empty: not known.
  bool has_opened_ = false;     ///< A cycle, by removing a branch without tip.
  std::priority_queue<Spur, std::vector<Spur>, std::greater<Spur>> queue_; ///< Least slender first.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_SPUR_PRUNING_H
