// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_TEST_BOTH_METHODS_H
#define POINT_SET_SKELETONIZATION_3_TEST_BOTH_METHODS_H

#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>

/// The default method, or the published one: what holds for one has to hold for the other.
template <typename ConcurrencyTag = CGAL::Sequential_tag, typename PointRange, typename Skeleton,
          typename NamedParameters = CGAL::parameters::Default_named_parameters>
bool extract(bool published, const PointRange& points, Skeleton& skeleton,
             const NamedParameters& np = CGAL::parameters::default_values())
{
  return published
           ? CGAL::extract_published_l1_medial_skeleton<ConcurrencyTag>(points, skeleton, np)
           : CGAL::extract_l1_medial_skeleton<ConcurrencyTag>(points, skeleton, np);
}

#endif // POINT_SET_SKELETONIZATION_3_TEST_BOTH_METHODS_H
