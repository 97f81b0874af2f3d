// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Components merged by cells keep what can be kept.

#include "catch2.h"
#include "generator/Random.h"

#include <CGAL/Point_set_skeletonization_3/internal/core/Moments.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/merge_by_cell.h>

#include <cmath>
#include <cstddef>
#include <vector>

namespace merge_by_cell_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr unsigned int seeds[] = {1, 2, 3};

Gaussians random_components(shapes::Random& random)
{
  Gaussians result;
  for(int i = 0; i < 500; ++i) {
    const double weight = random.uniform(0.5, 2);
    const Vector3 mean = 2 * random.uniform_vector() - Vector3::Ones();
    result.push_back({weight, mean, random.uniform() * Matrix3::Identity()});
  }
  return result;
}

Gaussian total(const Gaussians& gaussians)
{
  Moments moments;
  for(const Gaussian& g : gaussians)
    moments.add(g.weight, g.mean, g.covariance);
  return moments.gaussian(Vector3::Zero());
}

Vector3 cell_of(const Vector3& p, double cell_size)
{
  return (p / cell_size).array().floor();
}

} // namespace

TEST_CASE("Merging by cells keeps moments, and tells who went where")
{
  constexpr double cell_size = 0.3;
  for(const unsigned int seed : seeds) {
    CAPTURE(seed);
    shapes::Random random(seed);
    const Gaussians fine = random_components(random);
    const Merged_gaussians merged = merged_by_cell(fine, cell_size);
    CHECK(merged.gaussians.size() < fine.size());
    REQUIRE(merged.merged_into.size() == fine.size());
    std::vector<Gaussians> members(merged.gaussians.size());
    for(std::size_t i = 0; i < fine.size(); ++i)
      members.at(merged.merged_into[i]).push_back(fine[i]);
    for(std::size_t k = 0; k < members.size(); ++k) {
      REQUIRE(!members[k].empty());
      for(const Gaussian& g : members[k])
        REQUIRE(cell_of(g.mean, cell_size) == cell_of(members[k].front().mean, cell_size));
      const Gaussian expected = total(members[k]);
      REQUIRE(merged.gaussians[k].weight == Approx(expected.weight));
      REQUIRE((merged.gaussians[k].mean - expected.mean).norm() < 1e-12);
      REQUIRE((merged.gaussians[k].covariance - expected.covariance).norm() < 1e-12);
    }
  }
}

TEST_CASE("Without a size of cells nothing is merged")
{
  shapes::Random random(seeds[0]);
  const Gaussians fine = random_components(random);
  const Merged_gaussians merged = merged_by_cell(fine, 0);
  REQUIRE(merged.gaussians.size() == fine.size());
  for(std::size_t i = 0; i < fine.size(); ++i) {
    REQUIRE(merged.merged_into[i] == i);
    REQUIRE(merged.gaussians[i].mean == fine[i].mean);
  }
  CHECK(merged_by_cell({}, 1).gaussians.empty());
}

} // namespace merge_by_cell_test
