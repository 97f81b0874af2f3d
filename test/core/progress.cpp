// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever takes long can be cancelled, and a time limit cancels.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Progress.h>
#include <CGAL/Point_set_skeletonization_3/internal/core/parallel.h>

#include <chrono>
#include <cstddef>
#include <thread>
#include <vector>

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

TEST_CASE("The time is limited from the first report on")
{
  const Progress limited(nullptr, 0.05);
  sleep(60);
  CHECK_NOTHROW(limited(0));
  sleep(60);
  CHECK_THROWS_AS(limited(0.5), Cancelled);
}
