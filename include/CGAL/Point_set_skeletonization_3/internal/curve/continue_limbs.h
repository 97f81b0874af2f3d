// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/open_loops.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Continues the limbs of a skeleton graph over gaps.
class Limb_continuation
{
public:
  /// `surface[v]` are the surface points of vertex v. Refers to the other arguments. O(n).
  Limb_continuation(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                    const Curve_options& options)
    : options_(options), graph_(graph), adjacency_(graph.adjacency()), limbs_(adjacency_.size()),
      loops_(adjacency_.size())
  {
    for(std::size_t v = 0; v < adjacency_.size(); ++v)
      if(is_tip(v))
        limbs_[v] = limb(v, surface);
  }

  /// Adds the bridges, at most one from each tip, the shorter first: those between two tips, which
  /// tell more, then those that end elsewhere, also within a bridge. A tip that would close a loop
  /// without room for a hole touches a limb.
  void run()
  {
    for(const Skeleton_graph::Edge& edge : graph_.edges)
      loops_.add(edge);
    std::vector<bool> is_continued(adjacency_.size(), false);
    for(const Bridge& gap : pairs_of_tips()) {
      if(is_continued[gap.a] || is_continued[gap.b])
        continue;
      is_continued[gap.a] = is_continued[gap.b] = true;
      if(leaves_room(gap))
        add_with_vertices(gap);
    }
    adjacency_ = graph_.adjacency();
    for(const Bridge& gap : ends_elsewhere()) {
      if(is_continued[gap.a])
        continue;
      is_continued[gap.a] = true;
      if(leaves_room(gap))
        add_edge(gap.a, gap.b);
    }
  }

private:
  /// The limb that ends in a tip.
  struct Limb
  {
    Branch branch;
    Vector3 direction = Vector3::Zero();
    double points = 0; ///< Their number.
    double reach = 0; ///< How far they lie beyond the tip.
    Curve_evidence curve;

    /// The length along which it was seen.
    double length() const { return curve.length() + reach; }
  };

  /// The limb of a tip. `surface[v]` are the surface points of vertex v.
  Limb limb(std::size_t tip, const std::vector<std::vector<Vector3>>& surface) const
  {
    Limb result;
    result.branch = follow(tip, adjacency_[tip][0], adjacency_);
    result.direction = tip_direction(tip, graph_, adjacency_);
    result.reach = reach_beyond(graph_.vertices[tip].position, result.direction, surface[tip]);
    for(std::size_t v : result.branch)
      result.points += static_cast<double>(surface[v].size());
    for(std::size_t k = 1; k < result.branch.size(); ++k)
      result.curve.add(graph_.vertices[result.branch[k - 1]], graph_.vertices[result.branch[k]]);
    return result;
  }

  bool is_tip(std::size_t v) const { return adjacency_[v].size() == 1; }

  /// Returns the bridges from a tip to what `is_end(v, w)` says, the shorter first.
  template <typename IsEnd> std::vector<Bridge> bridges(const IsEnd& is_end) const
  {
    const std::vector<Vector3> positions = positions_of(graph_);
    const Box_tree places(positions);
    std::vector<Bridge> result;
    for(std::size_t v = 0; v < limbs_.size(); ++v) {
      const Limb& limb = limbs_[v];
      const double furthest = 2 * limb.length() + 2 * limb.reach; // the other one is no longer
      places.visit_within(positions[v], furthest, [&](std::size_t k, double) {
        const std::size_t w = places.order()[k];
        if(is_end(v, w))
          result.push_back(bridge(v, w, graph_));
      });
    }
    std::sort(result.begin(), result.end());
    return result;
  }

  std::vector<Bridge> pairs_of_tips() const
  {
    return bridges([this](std::size_t v, std::size_t w) {
      return is_tip(w) && is_longer(v, w) && are_one_limb(v, w);
    });
  }

  std::vector<Bridge> ends_elsewhere() const
  {
    return bridges([this](std::size_t v, std::size_t w) {
      return is_tip(v) && !is_tip(w) && !is_on_limb(w, v) && goes_on_at(v, w);
    });
  }

  /// Whether a bridge closes no loop, or one with room for a hole.
  bool leaves_room(const Bridge& gap)
  {
    const Loop loop = loops_.closed_by({gap.a, gap.b});
    return loop.empty() || room_for_hole(loop, graph_) >= 1;
  }

  void add_edge(std::size_t v, std::size_t w)
  {
    graph_.edges.emplace_back(v, w);
    loops_.add(graph_.edges.back());
  }

  /// Adds a bridge between two tips with vertices in it, as dense as those of their limbs.
  void add_with_vertices(const Bridge& gap)
  {
    const Limb &a = limbs_[gap.a], &b = limbs_[gap.b];
    const auto in_limbs = static_cast<double>(a.branch.size() + b.branch.size() - 2);
    // Finite: what is missing between the tips is shorter than the limbs.
    const double edges = std::ceil(in_limbs * gap.length / (a.length() + b.length()));
    std::size_t last = gap.a;
    for(double k = 1; k < edges; ++k) {
      graph_.vertices.push_back(
        between(graph_.vertices[gap.a], graph_.vertices[gap.b], k / edges));
      loops_.add_vertex();
      add_edge(last, graph_.vertices.size() - 1);
      last = graph_.vertices.size() - 1;
    }
    add_edge(last, gap.b);
  }

  /// Whether a limb may go on where nothing was seen.
  bool may_go_on(const Curve_evidence& limb) const
  {
    return limb.is_open() && limb.evidence() >= options_.limb_evidence;
  }

  /// Whether points this far apart, between two vertices, are next to each other.
  bool are_adjacent(double distance, std::size_t v, std::size_t w) const
  {
    constexpr double reach = 1.5; // spacings; adjacent patches are seldom further apart
    return 2 * distance < reach * (graph_.vertices[v].resolution + graph_.vertices[w].resolution);
  }

  /// How much was seen of the limb of a tip that goes on at vertex `w`.
  double seen(const Limb& limb, std::size_t w) const
  {
    return (std::min)(limb.length(), length_seen(limb.points, w, graph_));
  }

  /// Whether the limbs of two tips are one: both tips point over the gap, and nothing is missing
  /// between their points; or taken together the limbs may go on, and as much as is missing was
  /// seen.
  bool are_one_limb(std::size_t v, std::size_t w) const
  {
    const Limb &a = limbs_[v], &b = limbs_[w];
    const Vector3 bridge = graph_.vertices[w].position - graph_.vertices[v].position;
    const double length = bridge.norm();
    Curve_evidence both = a.curve;
    both.add(b.curve);
    const double missing = length - a.reach - b.reach;
    return (are_adjacent(missing, v, w) ||
            (missing < seen(a, w) + seen(b, v) && may_go_on(both))) &&
           a.direction.dot(bridge) > options_.aligned * length &&
           -b.direction.dot(bridge) > options_.aligned * length;
  }

  /// Whether the limb of a tip goes on at a vertex that is none: as much as is missing was seen, and
  /// something is missing there, too: the wall of what was seen from all sides is complete.
  bool goes_on_at(std::size_t tip, std::size_t w) const
  {
    const Limb& limb = limbs_[tip];
    const Vector3 bridge = graph_.vertices[w].position - graph_.vertices[tip].position;
    const double length = bridge.norm();
    return length - limb.reach < seen(limb, w) && may_go_on(limb.curve) &&
           is_open(graph_.vertices[w]) &&
           limb.direction.dot(bridge) > options_.aligned * length;
  }

  /// Whether the limb of a tip is the longer one of two, or as long and the first.
  bool is_longer(std::size_t v, std::size_t w) const
  {
    return std::make_pair(limbs_[w].length(), v) < std::make_pair(limbs_[v].length(), w);
  }

  /// Whether a vertex is on the limb of a tip.
  bool is_on_limb(std::size_t v, std::size_t tip) const
  {
    const Branch& branch = limbs_[tip].branch;
    return std::find(branch.begin(), branch.end(), v) != branch.end();
  }

  const Curve_options& options_;
  Skeleton_graph& graph_;
  std::vector<std::vector<std::size_t>> adjacency_; ///< With the bridges between tips, once added.
  std::vector<Limb> limbs_; ///< Of each tip, as seen; of other vertices empty.
  Loop_search loops_;       ///< With the bridges.
};

/// Part 3d: adds edges over gaps, from a tip to a vertex that it points at, or to a tip that points
/// back: then with vertices in the gap, where other limbs may end. A limb needs evidence, and must
/// not have been seen from all sides: a tip that was ends there, and nothing ends in a wall that
/// was. What ends at a gap must be longer than the gap between its surface points, see
/// `length_seen()`: as much as is missing was seen. What holds for a limb holds for two that face
/// each other, taken together; if their points are next to each other, they are one limb without
/// that. Closes cycles, if there is room for a hole. `surface[v]` are the surface points of vertex
/// v. O(n log n), times the vertices within twice the length of a limb.
inline void continue_limbs(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                           const Curve_options& options)
{
  Limb_continuation(graph, surface, options).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H
