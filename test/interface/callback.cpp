// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Progress is reported truthfully, from the calling thread, and can be ended at any time.

#include "both_methods.h"
#include "catch2.h"
#include "shapes.h"
#include "skeleton_checks.h"

#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <thread>
#include <vector>

namespace callback_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;
using Points = std::vector<Kernel::Point_3>;
using Callback = std::function<bool(double)>;

namespace {

Points cloud(std::size_t size)
{
  return shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), size, 37));
}

template <typename ConcurrencyTag = CGAL::Sequential_tag>
bool watched(const Points& points, Skeleton& skeleton, bool published, const Callback& callback)
{
  return extract<ConcurrencyTag>(published, points, skeleton,
                                 CGAL::parameters::callback(callback));
}

std::vector<double> reported(const Points& points, bool published)
{
  std::vector<double> values;
  Skeleton skeleton;
  CHECK(watched(points, skeleton, published, [&](double value) {
    values.push_back(value);
    return true;
  }));
  return values;
}

// Something that no result looks like.
Skeleton sentinel()
{
  Skeleton skeleton(3);
  add_edge(0, 2, skeleton);
  skeleton[1].point = Kernel::Point_3(7, 8, 9);
  skeleton[1].radius = 5;
  skeleton[1].indices = {1, 4};
  return skeleton;
}

} // namespace

TEST_CASE("Progress rises from 0 to 1")
{
  for(bool published : {false, true})
    for(std::size_t size : {0u, 1u, 2u, 1500u}) {
      CAPTURE(published, size);
      const std::vector<double> values = reported(cloud(size), published);
      REQUIRE(!values.empty());
      CHECK(values.front() == 0);
      CHECK(values.back() == 1);
      CHECK(std::is_sorted(values.begin(), values.end()));
    }
}

TEST_CASE("Progress is fine enough to cancel soon")
{
  for(bool published : {false, true}) {
    CAPTURE(published);
    const std::vector<double> values = reported(cloud(1500), published);
    CHECK(values.size() > 8);
  }
}

TEST_CASE("Cancelling at any report leaves the output as it was")
{
  const Points points = cloud(500);
  for(bool published : {false, true}) {
    const std::size_t reports = reported(points, published).size();
    for(std::size_t last = 0; last < reports; ++last) {
      CAPTURE(published, last);
      Skeleton skeleton = sentinel();
      std::size_t calls = 0;
      CHECK_FALSE(watched(points, skeleton, published, [&](double) { return calls++ < last; }));
      CHECK(calls == last + 1); // nobody asks again
      CHECK(have_same_bits(skeleton, sentinel()));
    }
  }
}

TEST_CASE("Filling the lists of points can be cancelled, and leaves the output as it was")
{
  for(bool published : {false, true}) {
    // After the last report comes one more, as the callback took its time.
    std::size_t ends = 0;
    Skeleton skeleton = sentinel();
    CHECK_FALSE(watched(cloud(1500), skeleton, published, [&](double value) {
      if(value < 1)
        return true;
      std::this_thread::sleep_for(std::chrono::milliseconds(60));
      return ++ends == 1;
    }));
    CHECK(ends == 2);
    CHECK(have_same_bits(skeleton, sentinel()));
  }
}

TEST_CASE("Looking at the progress changes nothing")
{
  const Points points = cloud(1500);
  for(bool published : {false, true}) {
    Skeleton seen, unseen;
    CHECK(watched(points, seen, published, [](double) { return true; }));
    CHECK(extract(published, points, unseen));
    CHECK(have_same_bits(seen, unseen));
  }
}

TEST_CASE("The callback is called on the calling thread")
{
  const std::thread::id caller = std::this_thread::get_id();
  for(bool published : {false, true}) {
    CAPTURE(published);
    bool elsewhere = false;
    Skeleton skeleton;
    CHECK(watched<CGAL::Parallel_if_available_tag>(
      cloud(3000), skeleton, published, [&](double) {
        elsewhere = elsewhere || std::this_thread::get_id() != caller;
        return true;
      }));
    CHECK_FALSE(elsewhere);
  }
}

TEST_CASE("An exception of the callback reaches the caller and leaves the output as it was")
{
  struct Stop {};
  Skeleton skeleton = sentinel();
  const Callback throws = [](double value) { return value < 0.5 ? true : throw Stop(); };
  CHECK_THROWS_AS(watched(cloud(1500), skeleton, false, throws), Stop);
  CHECK(have_same_bits(skeleton, sentinel()));
}

TEST_CASE("Reading a large cloud can be cancelled, and leaves the output as it was")
{
  const Points points = cloud(400000);
  for(bool parallel : {false, true}) {
    std::size_t calls = 0;
    const auto extract_until = [&](std::size_t last, Skeleton& skeleton) {
      calls = 0;
      const Callback callback = [&](double) { return calls++ < last; };
      return parallel ? watched<CGAL::Parallel_if_available_tag>(points, skeleton, false, callback)
                      : watched(points, skeleton, false, callback);
    };
    // The step that reads.
    std::size_t reports = 0;
    const Callback count = [&](double) { return ++reports > 0; };
    CGAL::L1_medial_skeletonization_3<Kernel> steps(points, CGAL::parameters::callback(count));
    REQUIRE(steps.fit_mixture());
    REQUIRE(reports > 4);
    for(std::size_t last = 0; last < reports; ++last) {
      CAPTURE(parallel, last);
      Skeleton skeleton = sentinel();
      CHECK_FALSE(extract_until(last, skeleton));
      CHECK(calls == last + 1);
      CHECK(have_same_bits(skeleton, sentinel()));
    }
  }
}

} // namespace callback_test
