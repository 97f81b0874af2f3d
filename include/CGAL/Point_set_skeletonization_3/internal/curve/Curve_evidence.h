// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_EVIDENCE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_EVIDENCE_H

#include <CGAL/Point_set_skeletonization_3/internal/curve/Skeleton_graph.h>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// How well a part of a skeleton graph was seen: means along its edges, by length.
class Curve_evidence
{
public:
  /// Adds the edge between two vertices.
  void add(const Skeleton_graph::Vertex& a, const Skeleton_graph::Vertex& b)
  {
    const double length = (a.position - b.position).norm();
    length_ += length;
    evidence_ += length * (a.evidence + b.evidence) / 2;
    open_ += length * (a.open + b.open) / 2;
  }

  /// Adds another part.
  void add(const Curve_evidence& other)
  {
    length_ += other.length_;
    evidence_ += other.evidence_;
    open_ += other.open_;
  }

  double length() const { return length_; }

  /// The evidence for limbs, in [0, 1]; 0 without edges.
  double evidence() const { return length_ > 0 ? evidence_ / length_ : 0; }

  /// The length of what was not seen from all sides.
  double open_length() const { return open_; }

  /// Whether most of it was not seen from all sides, as lines, sheets and limbs scanned from one
  /// side: it may go on where nothing was seen.
  bool is_open() const { return open_ > 0.5 * length_; }

  /// How much more of it was seen from all sides than was not: the difference of both shares of the
  /// length, in [-1, 1]; 0 without edges.
  double surplus() const { return length_ > 0 ? 1 - 2 * open_ / length_ : 0; }

private:
  double length_ = 0, evidence_ = 0, open_ = 0; ///< The latter two are times the length.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_CURVE_CURVE_EVIDENCE_H
