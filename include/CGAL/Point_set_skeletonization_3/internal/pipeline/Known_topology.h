// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_KNOWN_TOPOLOGY_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_KNOWN_TOPOLOGY_H

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// What the caller knows of the skeleton.
struct Known_topology
{
  bool single_component = false; ///< All components are joined, not only across plausible gaps.
  bool is_tree = false;          ///< There is no cycle: all are opened.
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_PIPELINE_KNOWN_TOPOLOGY_H
