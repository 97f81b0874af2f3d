// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same points give the same bits, whatever computes them.

#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/extract_l1_medial_skeleton.h>

#include <CGAL/Simple_cartesian.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#endif

#include <cstddef>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Points = std::vector<Kernel::Point_3>;

namespace {

Points cloud() { return shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), 5000, 23)); }

template <typename ConcurrencyTag>
Skeleton skeleton_of(const Points& points, bool published, unsigned int seed = 0)
{
  Skeleton skeleton;
  REQUIRE(CGAL::extract_l1_medial_skeleton<ConcurrencyTag>(
    points, skeleton,
    CGAL::parameters::as_published(published, CGAL::parameters::random_seed(seed))));
  check_valid(skeleton, points.size());
  return skeleton;
}

} // namespace

TEST_CASE("Two runs give the same bits")
{
  const Points points = cloud();
  for(bool published : {false, true}) {
    CAPTURE(published);
    CHECK(have_same_bits(skeleton_of<CGAL::Sequential_tag>(points, published),
                         skeleton_of<CGAL::Sequential_tag>(points, published)));
  }
}

TEST_CASE("The seed changes what is drawn at random, and nothing else")
{
  const Points points = cloud();
  for(bool published : {false, true}) {
    CAPTURE(published);
    CHECK(have_same_bits(skeleton_of<CGAL::Sequential_tag>(points, published, 1),
                         skeleton_of<CGAL::Sequential_tag>(points, published, 2)) == !published);
  }
}

#ifdef CGAL_LINKED_WITH_TBB
TEST_CASE("Any number of threads gives the same bits")
{
  const Points points = cloud();
  for(bool published : {false, true}) {
    const Skeleton expected = skeleton_of<CGAL::Sequential_tag>(points, published);
    for(std::size_t threads : {1u, 2u, 5u}) {
      CAPTURE(published, threads);
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      CHECK(have_same_bits(expected, skeleton_of<CGAL::Parallel_tag>(points, published)));
    }
  }
}
#endif
