// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "l1_medial_published.h"

#include "l1_medial_stages.h"

#include <CGAL/Published_l1_medial_skeletonization_3.h>

Method_result l1_medial_published(const Method_input& input)
{
  return l1_medial_stages<CGAL::Published_l1_medial_skeletonization_3<Kernel>>(input);
}

Method_result l1_medial_published_tuned(const Method_input& input)
{
  return l1_medial_stages<CGAL::Published_l1_medial_skeletonization_3<Kernel>>(
      input, CGAL::parameters::published::tuned(true));
}
