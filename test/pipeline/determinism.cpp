// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The same points give the same bits, whatever computes them.

#include "both_methods.h"
#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"
#include "threads.h"

#include <CGAL/Simple_cartesian.h>

#include <cstddef>
#include <vector>

namespace determinism_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Points = std::vector<Kernel::Point_3>;

namespace {

Points cloud(std::size_t size)
{
  return shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), size, 23));
}

template <typename ConcurrencyTag>
Skeleton skeleton_of(const Points& points, bool published)
{
  Skeleton skeleton;
  REQUIRE(extract<ConcurrencyTag>(published, points, skeleton));
  check_valid(skeleton, points.size());
  return skeleton;
}

} // namespace

TEST_CASE("Two runs give the same bits")
{
  const Points points = cloud(5000);
  for(bool published : {false, true}) {
    CAPTURE(published);
    CHECK(have_same_bits(skeleton_of<CGAL::Sequential_tag>(points, published),
                         skeleton_of<CGAL::Sequential_tag>(points, published)));
  }
}

// The large cloud is split into parts, and has more cells than the finest grid may have.
TEST_CASE("Any number of threads gives the same bits")
{
  for(const std::size_t size : {5000u, 250000u})
    for(bool published : {false, true}) {
      if(published && size > 5000)
        continue; // it takes minutes, and has no parts
      CAPTURE(size, published);
      const Points points = cloud(size);
      const Skeleton expected = skeleton_of<CGAL::Sequential_tag>(points, published);
      for_threads([&](CGAL::Point_set_skeletonization_3::internal::Concurrency) {
        CHECK(have_same_bits(
          expected, skeleton_of<CGAL::Parallel_if_available_tag>(points, published)));
      });
    }
}

} // namespace determinism_test
