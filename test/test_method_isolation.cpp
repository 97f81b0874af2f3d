// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Whatever a compared method does, the comparison goes on and knows what it was.

#include "catch2.h"

#include "comparison/isolated_run.h"

#include <chrono>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <thread>

namespace {

constexpr double enough = 60; // seconds

Method_result segment(double radius)
{
  Method_result result;
  timed_stage(result, "drawing", [&] {
    Skeleton& skeleton = result.skeleton;
    for(const double x : {0.1, 1. / 3}) {
      const auto v = add_vertex(skeleton);
      skeleton[v].point = Point(x, 0, 0);
      skeleton[v].radius = radius;
    }
    add_edge(0, 1, skeleton);
  });
  return result;
}

} // namespace

TEST_CASE("A skeleton comes back as it was")
{
  const Isolated_result run = run_isolated([] { return segment(0.7); }, enough);
  CHECK(run.status == "ok");
  CHECK(run.message.empty());
  CHECK(run.seconds >= 0);
  CHECK(run.peak_memory > 0);
  REQUIRE(run.result.stages.size() == 1);
  CHECK(run.result.stages.front().first == "drawing");
  const Skeleton& skeleton = run.result.skeleton;
  REQUIRE(num_vertices(skeleton) == 2);
  CHECK(skeleton[0].point == Point(0.1, 0, 0));
  CHECK(skeleton[1].point == Point(1. / 3, 0, 0));
  CHECK(skeleton[1].radius == 0.7);
  CHECK(edge(0, 1, skeleton).second);
}

TEST_CASE("An exception is a failure, with its first line")
{
  const auto work = []() -> Method_result { throw std::runtime_error("no luck\nnone at all"); };
  const Isolated_result run = run_isolated(work, enough);
  CHECK(run.status == "failed");
  CHECK(run.message == "no luck");
}

TEST_CASE("A crash is a failure")
{
  const auto work = []() -> Method_result { std::abort(); };
  const Isolated_result run = run_isolated(work, enough);
  CHECK(run.status == "failed");
  CHECK_FALSE(run.message.empty());
}

TEST_CASE("Work that takes too long is stopped")
{
  const auto work = [] {
    std::this_thread::sleep_for(std::chrono::hours(1));
    return segment(1);
  };
  const Isolated_result run = run_isolated(work, 0.1);
  CHECK(run.status == "time_limit");
  CHECK(num_vertices(run.result.skeleton) == 0);
}

TEST_CASE("What is no skeleton is invalid")
{
  const auto status = [](const Method_result& result) {
    const Isolated_result run = run_isolated([&] { return result; }, enough);
    CHECK(num_vertices(run.result.skeleton) == 0);
    CHECK_FALSE(run.message.empty());
    return run.status;
  };
  CHECK(status({}) == "invalid");
  CHECK(status(segment(-1)) == "invalid");
  CHECK(status(segment(std::numeric_limits<double>::quiet_NaN())) == "invalid");
  Method_result infinite = segment(1);
  infinite.skeleton[0].point = Point(std::numeric_limits<double>::infinity(), 0, 0);
  CHECK(status(infinite) == "invalid");
  Method_result loop = segment(1);
  add_edge(0, 0, loop.skeleton);
  CHECK(status(loop) == "invalid");
  Method_result twice = segment(1);
  add_edge(1, 0, twice.skeleton);
  CHECK(status(twice) == "invalid");
}
