// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_EVIDENCE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_EVIDENCE_H

#include <CGAL/Point_set_skeletonization_3/internal/core/Gaussian.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/principal_axes.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>
#include <CGAL/Point_set_skeletonization_3/internal/curve/surface_quotient.h>
#include <CGAL/Point_set_skeletonization_3/internal/medial/Sample.h>
#include <CGAL/Point_set_skeletonization_3/internal/spatial/components_within.h>
#include <CGAL/Point_set_skeletonization_3/internal/surface/Surface.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What a strip of surface is whose other side was not seen.
enum class Strip
{
  side, ///< One side of a limb, as of a wire.
  leaf, ///< A sheet, and no evidence for a limb.
};

/// How well limbs are seen, in [0, 1]: as a solid or as a line, whichever is more. Near 0 where
/// points are scattered, as in a crown in leaf.
class Limb_evidence
{
public:
  /// Refers to the first two arguments. O(1).
  Limb_evidence(const Surface& surface, const Samples& samples, Strip strip)
    : surface_(surface), samples_(samples), strip_(strip)
  {}

  /// The evidence for a limb at a vertex in the middle of some patches; 0 if there are none.
  /// O(patches log n) in practice.
  double operator()(const Skeleton_graph::Vertex& vertex,
                    const std::vector<std::size_t>& patches) const
  {
    constexpr std::size_t enough = 16; // for a mean; the patches of large pieces are many
    if(patches.empty())
      return 0;
    const std::size_t step = (patches.size() + enough - 1) / enough;
    double solid = 0, number = 0;
    for(std::size_t k = 0; k < patches.size(); k += step, ++number)
      solid += (std::max)(0.0, of_solid(patches[k]));
    return (std::max)(solid / number, of_line(vertex, half_width(vertex, patches)));
  }

private:
  /// Half the width of a limb at a vertex in the middle of some patches: of a strip the greatest
  /// distance, so that in the window it is longer than wide; or the mean distance, so that it is
  /// not.
  double half_width(const Skeleton_graph::Vertex& vertex,
                    const std::vector<std::size_t>& patches) const
  {
    double result = (std::max)(vertex.resolution, vertex.half_width);
    if(strip_ == Strip::side)
      for(std::size_t i : patches)
        result = (std::max)(result, (surface_.patches[i].mean - vertex.position).norm());
    return result;
  }

  /// All that is near the middle of a solid faces away from it: the mean cosine between the normals
  /// around the sample of a patch and the directions from it.
  double of_solid(std::size_t i) const
  {
    constexpr double around = 1.3; // radii: the ring of a limb that is wider than thick
    const Patches& patches = surface_.patches;
    const Vector3& middle = samples_[i].position;
    const double radius = (middle - patches[i].mean).norm();
    double cosines = 0, area = 0;
    surface_.tree.visit_within(middle, around * radius, [&](std::size_t k, double) {
      const Patch& patch = patches[surface_.tree.order()[k]];
      cosines += patch.area * patch.normal.dot((patch.mean - middle).normalized());
      area += patch.area;
    });
    return area > 0 ? cosines / area : 0;
  }

  /// The linearity of the points around the middle of a limb, in a window in which it is longer
  /// than wide. Where no other side was seen, also in half of that: a line may be much thinner than
  /// its spacing, and the wide window reaches beyond the next joint.
  double of_line(const Skeleton_graph::Vertex& vertex, double half_width) const
  {
    constexpr double around = 2.5; // half widths
    const double wide = linearity_within(around * half_width, vertex.position);
    return vertex.open < 1 ? wide
                           : (std::max)(wide, linearity_within(around / 2 * half_width,
                                                               vertex.position));
  }

  /// 1 - a / b for the greatest variances b and a of the components within a distance, less what as
  /// many scattered ones show by chance. (Components: points on one leaf are not independent.)
  double linearity_within(double radius, const Vector3& place) const
  {
    const Spread_components around = components_within(surface_.component_tree, place, radius);
    if(around.number < 3)
      return 0;
    const Vector3 variances = principal_axes(around.covariance).variances;
    return variances[2] > 0
             ? 1 - variances[1] / variances[2] - anisotropy_by_chance(around.number)
             : 0;
  }

  const Surface& surface_;
  const Samples& samples_;
  Strip strip_;
};

/// Sets the evidence for a limb at each vertex of a quotient. O(n log n) in practice.
inline void set_evidence(Surface_quotient& quotient, const Surface& surface,
                         const Samples& samples, Strip strip, Concurrency concurrency)
{
  const Limb_evidence evidence(surface, samples, strip);
  parallel_for(concurrency, quotient.members.size(), [&](std::size_t v) {
    Skeleton_graph::Vertex& vertex = quotient.graph.vertices[v];
    vertex.evidence = evidence(vertex, quotient.members[v]);
  });
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_LIMB_EVIDENCE_H
