// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_MEDIAL_SAMPLE_KIND_H
#define CGAL_POINT_SET_SKELETONIZATION_3_MEDIAL_SAMPLE_KIND_H

#include <CGAL/license/Point_set_skeletonization_3.h>

namespace CGAL {

/// \ingroup PkgPointSetSkeletonization3Ref
///
/// What a medial sample is in the middle of: the dimension of the cloud around its patch.
enum class Medial_sample_kind
{
  solid,  ///< A limb whose other side was seen: the sample is the centre of a medial ball.
  line,   ///< Points that are thinner across than their spacing; the sample is on the patch.
  sheet,  ///< A surface whose other side was not seen; the sample is on the patch.
  scatter ///< Neither a surface nor a line, as leaves; the sample is on the patch.
};

} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_MEDIAL_SAMPLE_KIND_H
