// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Builders that were written and read again, and what is no builder.

#include "catch2.h"
#include "generator/Random.h"
#include "shapes.h"

#include <CGAL/IO/Gaussian_mixture_builder_3.h>
#include <CGAL/fit_gaussian_mixture.h>

#include <CGAL/Simple_cartesian.h>
#include <CGAL/bounding_box.h>

#include <algorithm>
#include <cstddef>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace moments_test {

using Kernel = CGAL::Simple_cartesian<double>;
using Point = Kernel::Point_3;
using Builder = CGAL::Gaussian_mixture_builder_3<Kernel>;
using Mixture = CGAL::Gaussian_mixture_3<Kernel>;

namespace {

const std::vector<Point>& points()
{
  static const std::vector<Point> result =
      shapes::to_points<Kernel>(shapes::sample(shapes::y_junction(), 20000, 8));
  return result;
}

Builder builder_of(const std::vector<Point>& cloud, const std::string& source)
{
  Builder builder(CGAL::bbox_3(points().begin(), points().end()), 2000);
  builder.insert_source(source);
  builder.insert(cloud);
  return builder;
}

std::string written(const Builder& builder)
{
  std::ostringstream os;
  CGAL::IO::write_moments(os, builder);
  return os.str();
}

Builder read(const std::string& bytes)
{
  std::istringstream is(bytes);
  Builder builder;
  CGAL::IO::read_moments(is, builder);
  return builder;
}

// What `read()` complains about.
std::string complaint(const std::string& bytes)
{
  try {
    read(bytes);
  } catch(const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

} // namespace

TEST_CASE("A builder that was read goes on as the one that was written")
{
  const auto middle = points().begin() + 9000;
  const Builder all = builder_of(points(), "cloud");
  Builder half = read(written(builder_of({points().begin(), middle}, "cloud")));
  CHECK(half.number_of_points() == 9000);
  CHECK(half.box() == all.box());
  CHECK(half.sources() == all.sources());
  half.insert(CGAL::make_range(middle, points().end()));
  CHECK(written(half) == written(all));
  CHECK(CGAL::fit_gaussian_mixture(half).levels.front().size() ==
        CGAL::fit_gaussian_mixture(all).levels.front().size());
}

TEST_CASE("The bytes are the same for any order of the points and of the parts")
{
  const std::string expected = written(builder_of(points(), "cloud"));
  for(const unsigned int seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    std::vector<Point> shuffled = points();
    std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(seed));
    CHECK(written(builder_of(shuffled, "cloud")) == expected);
    const auto cut = shuffled.begin() + 5000 * seed;
    Builder second = read(written(builder_of({cut, shuffled.end()}, "cloud")));
    Builder parts(second.box(), 2000);
    parts.insert(CGAL::make_range(shuffled.begin(), cut));
    parts.merge(second);
    CHECK(written(parts) == expected);
  }
}

TEST_CASE("An empty builder is one as well")
{
  CHECK(written(read(written(Builder()))) == written(Builder()));
  CHECK(read(written(Builder())).number_of_points() == 0);
}

TEST_CASE("Nothing is counted twice, and only what fits is merged")
{
  Builder all = builder_of(points(), "a");
  CHECK_FALSE(all.insert_source("a"));
  CHECK(all.insert_source("b"));
  const std::string before = written(all);
  CHECK_THROWS_AS(all.merge(builder_of(points(), "b")), std::invalid_argument);
  CHECK_THROWS_AS(all.merge(Builder(CGAL::Bbox_3(0, 0, 0, 1, 1, 1), 2000)), std::invalid_argument);
  CHECK_THROWS_AS(all.merge(Builder(all.box(), 3000)), std::invalid_argument);
  CHECK(written(all) == before);
}

TEST_CASE("What is no builder is refused, and nothing changes")
{
  const std::string good = written(builder_of(points(), "cloud"));
  CHECK(complaint("").find("it is no file of moments") == 0);
  CHECK(complaint("ply\nformat ascii 1.0\n").find("it is no file of moments") == 0);
  std::string newer = good;
  newer[newer.find('\n') - 1] = '2';
  CHECK(complaint(newer).find("it is of another version") == 0);
  for(const std::size_t size : {40u, 100u, 1000u})
    CHECK(complaint(good.substr(0, size)).find("it breaks off") == 0);
  CHECK(complaint(good.substr(0, good.size() - 1)).find("it breaks off") == 0);
  CHECK(complaint(good + '\0').find("it is damaged") == 0);

  std::istringstream is(good.substr(0, 1000));
  Builder builder = builder_of(points(), "other");
  const std::string before = written(builder);
  CHECK_THROWS_AS(CGAL::IO::read_moments(is, builder), std::runtime_error);
  CHECK(written(builder) == before);
}

TEST_CASE("A single wrong bit is noticed")
{
  const std::string good = written(builder_of({points().begin(), points().begin() + 50}, "cloud"));
  const unsigned int seed = 4;
  CAPTURE(seed);
  std::mt19937 generator(seed);
  for(int i = 0; i < 500; ++i) {
    const std::size_t byte = generator() % good.size(), bit = generator() % 8;
    CAPTURE(byte, bit);
    std::string bad = good;
    bad[byte] = static_cast<char>(bad[byte] ^ 1 << bit);
    CHECK(!complaint(bad).empty());
  }
}

} // namespace moments_test
