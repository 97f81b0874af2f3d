// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Bridge.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_evidence.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Curve_options.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/branches.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/refine_curve.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/Box_tree.h>

#include <algorithm>
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
    : options_(options), graph_(graph), adjacency_(graph.adjacency()), limbs_(adjacency_.size())
  {
    for(std::size_t v = 0; v < adjacency_.size(); ++v)
      if(is_tip(v))
        limbs_[v] = limb(v, surface[v]);
  }

  /// Adds the bridges, at most one from each tip: first those between two tips, which tell more,
  /// and the shorter first.
  void run()
  {
    std::vector<Bridge> bridges = candidates();
    std::sort(bridges.begin(), bridges.end());
    std::stable_partition(bridges.begin(), bridges.end(),
                          [this](const Bridge& gap) { return is_tip(gap.b); });
    std::vector<bool> is_continued(adjacency_.size(), false);
    for(const Bridge& gap : bridges) {
      if(is_continued[gap.a] || is_continued[gap.b])
        continue;
      is_continued[gap.a] = true;
      is_continued[gap.b] = is_tip(gap.b); // limbs may begin anywhere else
      graph_.edges.emplace_back(gap.a, gap.b);
    }
  }

private:
  /// The limb that ends in a tip.
  struct Limb
  {
    Branch branch;
    Vector3 direction = Vector3::Zero();
    double reach = 0; ///< How far its points lie beyond the tip.
    Curve_evidence curve;

    /// The length along which it was seen.
    double length() const { return curve.length() + reach; }
  };

  /// The limb of a tip with some surface points.
  Limb limb(std::size_t tip, const std::vector<Vector3>& points) const
  {
    Limb result;
    result.branch = follow(tip, adjacency_[tip][0], adjacency_);
    result.direction = tip_direction(tip, graph_, adjacency_);
    result.reach = reach_beyond(graph_.vertices[tip].position, result.direction, points);
    for(std::size_t k = 1; k < result.branch.size(); ++k)
      result.curve.add(graph_.vertices[result.branch[k - 1]], graph_.vertices[result.branch[k]]);
    return result;
  }

  bool is_tip(std::size_t v) const { return adjacency_[v].size() == 1; }

  std::vector<Bridge> candidates() const
  {
    const std::vector<Vector3> positions = positions_of(graph_);
    const Box_tree places(positions);
    std::vector<Bridge> result;
    for(std::size_t v = 0; v < limbs_.size(); ++v) {
      const Limb& limb = limbs_[v];
      const double furthest = 2 * limb.length() + 2 * limb.reach; // the other one is no longer
      places.visit_within(positions[v], furthest, [&](std::size_t k, double) {
        const std::size_t w = places.order()[k];
        if(continues(v, w) && (is_tip(w) ? is_longer(v, w) && continues(w, v) : !is_on_limb(w, v)))
          result.push_back(bridge(v, w, graph_));
      });
    }
    return result;
  }

  /// Whether the limb of a tip goes on at another vertex. As much as is missing was seen of it and,
  /// if the other is a tip too, of the limb behind the gap.
  bool continues(std::size_t tip, std::size_t w) const
  {
    const Vector3 bridge = graph_.vertices[w].position - graph_.vertices[tip].position;
    const double length = bridge.norm();
    const Limb &limb = limbs_[tip], &other = limbs_[w]; // that of `w` is empty if it is no tip
    return length - limb.reach - other.reach < limb.length() + other.length() &&
           limb.curve.is_open() && limb.curve.evidence() >= options_.limb_evidence &&
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
  std::vector<std::vector<std::size_t>> adjacency_; ///< Without the bridges.
  std::vector<Limb> limbs_; ///< Of each tip; of other vertices empty.
};

/// Part 3d: adds edges over gaps, from a tip to a vertex that it points at, or to a tip that points
/// back. A limb needs evidence, must not have been seen from all sides (a tip that was ends there),
/// and what ends at a gap must be longer than the gap between its surface points: as much as is
/// missing was seen. Closes cycles. `surface[v]` are the surface points of vertex v. O(n log n),
/// times the vertices within twice the length of a limb.
inline void continue_limbs(Skeleton_graph& graph, const std::vector<std::vector<Vector3>>& surface,
                           const Curve_options& options)
{
  Limb_continuation(graph, surface, options).run();
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CONTINUE_LIMBS_H
