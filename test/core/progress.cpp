// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever takes long can be cancelled, and a time limit cancels.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/sort_polled.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <random>
#include <thread>
#include <vector>

namespace progress_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

void sleep(int milliseconds)
{
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

} // namespace

TEST_CASE("A poll repeats the last report when it is long ago, where it is listened to")
{
  std::vector<double> reports;
  const Progress whole([&](double fraction) {
    reports.push_back(fraction);
    return true;
  });
  const Progress half = whole.part(0.5, 1);
  {
    const Progress::Polled polled(half);
    half(0.5);
    Progress::poll(); // too soon
    sleep(60);
    std::thread(Progress::poll).join(); // another thread
    CHECK(reports == std::vector<double>{0.75});
    Progress::poll();
    CHECK(reports == std::vector<double>{0.75, 0.75});
    {
      const Progress::Polled nobody{Progress()};
      sleep(60);
      Progress::poll();
    }
    CHECK(reports.size() == 2);
    Progress::poll();
    CHECK(reports.size() == 3);
  }
  sleep(60);
  Progress::poll();
  CHECK(reports.size() == 3);
}

TEST_CASE("Every loop can be cancelled")
{
  for(const Concurrency concurrency : {Concurrency::sequential, Concurrency::parallel}) {
    const Progress cancelled([calls = 0](double) mutable { return ++calls < 2; });
    const Progress::Polled polled(cancelled);
    cancelled(0);
    CHECK_THROWS_AS(parallel_for(concurrency, 2000, [](std::size_t) { sleep(1); }), Cancelled);
  }
}

TEST_CASE("The parts of a loop are disjoint and all of it")
{
  for(const Concurrency concurrency : {Concurrency::sequential, Concurrency::parallel})
    for(const std::size_t size : {0u, 1u, 63u, 64u, 65u, 16383u, 16385u, 100000u}) {
      CAPTURE(size);
      std::vector<int> visits(size, 0);
      parallel_for(concurrency, size, [&](std::size_t i) { ++visits[i]; });
      CHECK(visits == std::vector<int>(size, 1));
    }
}

TEST_CASE("Sorting in pieces sorts, and can be cancelled")
{
  const unsigned int seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for(const std::size_t size : {0u, 1u, 1000u, 32768u, 32769u, 100001u}) {
    CAPTURE(size);
    std::vector<unsigned int> values(size);
    for(unsigned int& value : values)
      value = static_cast<unsigned int>(random() % 5000);
    std::vector<unsigned int> sorted = values, descending = values;
    std::sort(sorted.begin(), sorted.end());
    sort_polled(values.begin(), values.end());
    CHECK(values == sorted);
    sort_polled(descending.begin(), descending.end(), std::greater<>());
    CHECK(std::equal(sorted.rbegin(), sorted.rend(), descending.begin(), descending.end()));
  }
  std::size_t reports = 0;
  const Progress progress([&](double) { return ++reports == 1; });
  const Progress::Polled polled(progress);
  progress(0);
  sleep(60);
  std::vector<int> values(100000);
  CHECK_THROWS_AS(sort_polled(values.begin(), values.end()), Cancelled);
}

TEST_CASE("The time is limited from the first report on")
{
  const Progress limited(nullptr, 0.05);
  sleep(60);
  CHECK_NOTHROW(limited(0));
  sleep(60);
  CHECK_THROWS_AS(limited(0.5), Cancelled);
}

} // namespace progress_test
