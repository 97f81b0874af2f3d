// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Packets compute with each of their numbers what is computed with one.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/spatial/Float_packet.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace packets_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

template <std::size_t N>
Float_packet<N> some_packet(shapes::Random& random, double least, double greatest)
{
  Float_packet<N> result;
  for(std::size_t k = 0; k < N; ++k)
    result.set(k, static_cast<float>(random.uniform(least, greatest)));
  return result;
}

template <std::size_t N>
void check_packets()
{
  const unsigned int seed = GENERATE(1u, 2u, 3u);
  CAPTURE(N, seed);
  shapes::Random random(seed);
  const Float_packet<N> a = some_packet<N>(random, -2, 2), b = some_packet<N>(random, 0.1, 3);
  Float_packet<N> sum = a;
  sum += b;
  double total = 0;
  for(std::size_t k = 0; k < N; ++k) {
    CAPTURE(k, a[k], b[k]);
    CHECK((a + b)[k] == a[k] + b[k]);
    CHECK((a - b)[k] == a[k] - b[k]);
    CHECK((a * b)[k] == a[k] * b[k]);
    CHECK((a / b)[k] == a[k] / b[k]);
    CHECK((-a)[k] == -a[k]);
    CHECK((2 * a)[k] == 2 * a[k]);
    CHECK(sum[k] == a[k] + b[k]);
    CHECK(b.sqrt()[k] == Approx(std::sqrt(b[k])).epsilon(1e-6)); // Eigen's may round differently
    CHECK(b.inverse()[k] == 1 / b[k]);
    CHECK(a.min(b)[k] == std::min(a[k], b[k]));
    CHECK(a.max(b)[k] == std::max(a[k], b[k]));
    CHECK(is_positive(a)[k] == (a[k] > 0 ? 1 : 0));
    CHECK(a.minCoeff() <= a[k]);
    CHECK(a.maxCoeff() >= a[k]);
    total += a[k];
  }
  CHECK(a.mean() == Approx(total / static_cast<double>(N)).margin(1e-6));
  const auto is_one_of_a = [&](float value) {
    for(std::size_t k = 0; k < N; ++k)
      if(a[k] == value)
        return true;
    return false;
  };
  CHECK(is_one_of_a(a.minCoeff()));
  CHECK(is_one_of_a(a.maxCoeff()));
}

} // namespace

TEST_CASE("A packet of four computes what four numbers do") { check_packets<4>(); }

TEST_CASE("A packet of eight computes what eight numbers do") { check_packets<8>(); }

TEST_CASE("A packet is closer to a box if one of its places is")
{
  const auto packet = packet_of([](std::size_t k) {
    return Eigen::Vector3f(static_cast<float>(k), 0, 0); // 0 to 7 along x
  });
  const Eigen::AlignedBox3f box(Eigen::Vector3f(9, -1, -1), Eigen::Vector3f(10, 1, 1));
  CHECK(packet.is_any_closer(box, 4.1f)); // the last is at 2
  CHECK(!packet.is_any_closer(box, 3.9f));
  CHECK(packet.squared_norm()[5] == 25);
  CHECK(packet.to(Eigen::Vector3f(1, 2, 3)).dot(Eigen::Vector3f(0, 1, 1))[4] == 5);
}

} // namespace packets_test
