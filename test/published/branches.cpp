// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Algorithm 1 of the paper and the merging of its branches.

#include "catch2.h"

#include <CGAL/Point_set_skeletonization_3/internal/published/branch_detection.h>
#include <CGAL/Point_set_skeletonization_3/internal/published/branch_merging.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <random>
#include <set>
#include <tuple>
#include <vector>

namespace branches_test {

using namespace CGAL::Point_set_skeletonization_3::internal;

namespace {

constexpr double spacing = 0.01;

// `size` components at begin, begin + step, ...; equal spheres, so that d_M orders as distances do.
void add_line(Gaussians& mixture, const Vector3& begin, const Vector3& step, int size)
{
  for(int i = 0; i < size; ++i)
    mixture.push_back({1, begin + i * step, 1e-6 * Matrix3::Identity()});
}

// Two arms of ten components that leave a common one under an angle given in degrees.
Gaussians corner(double degrees)
{
  const double angle = degrees * CGAL_PI / 180;
  const Vector3 a(spacing, 0, 0), b(spacing * std::cos(angle), spacing * std::sin(angle), 0);
  Gaussians mixture;
  add_line(mixture, 10 * a, -a, 11);
  add_line(mixture, b, b, 10);
  return mixture;
}

Gaussians random_mixture(std::size_t size, unsigned int seed)
{
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-0.3, 0.3);
  const auto vector = [&] {
    const double x = uniform(generator), y = uniform(generator), z = uniform(generator);
    return Vector3(x, y, z);
  };
  Gaussians mixture;
  for(std::size_t i = 0; i < size; ++i) {
    Matrix3 root;
    for(int k = 0; k < 3; ++k)
      root.col(k) = vector();
    mixture.push_back({1, vector(), regularized(root * root.transpose(), 0.01)});
  }
  return mixture;
}

std::size_t number_of_used(const std::vector<Branch>& branches)
{
  std::set<std::size_t> used;
  for(const Branch& b : branches)
    used.insert(b.begin(), b.end());
  return used.size();
}

std::size_t number_of_components(const Skeleton_graph& graph)
{
  std::vector<std::size_t> rank(graph.vertices.size()), parent(graph.vertices.size());
  boost::disjoint_sets<std::size_t*, std::size_t*> sets(rank.data(), parent.data());
  std::size_t number = graph.vertices.size();
  for(std::size_t v = 0; v < graph.vertices.size(); ++v)
    sets.make_set(v);
  for(const Skeleton_graph::Edge& e : graph.edges)
    if(sets.find_set(e.first) != sets.find_set(e.second)) {
      sets.union_set(e.first, e.second);
      --number;
    }
  return number;
}

bool is_tree(const Skeleton_graph& graph)
{
  return graph.edges.size() + 1 == graph.vertices.size() && number_of_components(graph) == 1;
}

std::size_t number_of_vertices_of_degree(const Skeleton_graph& graph, std::size_t degree)
{
  std::size_t number = 0;
  for(const auto& neighbors : graph.adjacency())
    if(neighbors.size() == degree)
      ++number;
  return number;
}

// The paper's listing, line by line, without any thought of speed; d_max holds while growing, too.
class Listing
{
public:
  Listing(const Gaussians& mixture, const Branch_detection_options& options)
    : mixture_(mixture), distance_(mixture), options_(options)
  {}

  std::vector<Branch> run() const
  {
    std::vector<Branch> B;
    std::set<std::size_t> A;
    for(std::size_t i = 0; i < mixture_.size(); ++i)
      A.insert(A.end(), i);
    auto [i, j] = closest(A);
    while(A.size() >= options_.b_min && is_near(i, j)) {
      Branch b{i, j};
      while(const std::size_t* prev = nearest(A, b, b.front())) {
        if(!is_near(b.front(), *prev) ||
           !(angle_at(mean(b[1]), mean(b[0]), mean(*prev)) > options_.alpha_min))
          break;
        b.insert(b.begin(), *prev);
      }
      while(const std::size_t* next = nearest(A, b, b.back())) {
        if(!is_near(b.back(), *next) ||
           !(angle_at(mean(b[b.size() - 2]), mean(b.back()), mean(*next)) > options_.alpha_min))
          break;
        b.push_back(*next);
      }
      if(b.size() >= options_.b_min)
        B.push_back(b);
      for(std::size_t k : b)
        A.erase(k);
      std::tie(i, j) = closest(A);
    }
    return B;
  }

private:
  const Vector3& mean(std::size_t i) const { return mixture_[i].mean; }
  bool is_near(std::size_t i, std::size_t j) const
  {
    return (mean(i) - mean(j)).norm() < options_.d_max;
  }

  std::pair<std::size_t, std::size_t> closest(const std::set<std::size_t>& A) const
  {
    std::pair<std::size_t, std::size_t> result(0, 0);
    double smallest = std::numeric_limits<double>::infinity();
    for(std::size_t i : A)
      for(std::size_t j : A)
        if(i != j && distance_(i, j) < smallest) {
          smallest = distance_(i, j);
          result = {i, j};
        }
    return result;
  }

  const std::size_t* nearest(const std::set<std::size_t>& A, const Branch& b, std::size_t end) const
  {
    const std::size_t* result = nullptr;
    for(const std::size_t& i : A)
      if(std::find(b.begin(), b.end(), i) == b.end() &&
         (result == nullptr || distance_(i, end) < distance_(*result, end)))
        result = &i;
    return result;
  }

  const Gaussians& mixture_;
  Squared_mahalanobis_distances distance_;
  Branch_detection_options options_;
};

// What linking the closest two clusters at a time costs in the paper's words.
double length_of_greedy_links(const Gaussians& mixture, std::vector<Branch> clusters)
{
  const Squared_mahalanobis_distances distance(mixture);
  double sum = 0;
  while(clusters.size() > 1) {
    double smallest = std::numeric_limits<double>::infinity();
    std::size_t first = 0, second = 0;
    for(std::size_t a = 0; a < clusters.size(); ++a)
      for(std::size_t b = a + 1; b < clusters.size(); ++b)
        for(std::size_t i : clusters[a])
          for(std::size_t j : clusters[b])
            if(distance(i, j) < smallest) {
              smallest = distance(i, j);
              first = a;
              second = b;
            }
    sum += std::sqrt(smallest);
    clusters[first].insert(clusters[first].end(), clusters[second].begin(), clusters[second].end());
    clusters.erase(clusters.begin() + static_cast<std::ptrdiff_t>(second));
  }
  return sum;
}

} // namespace

TEST_CASE("The Mahalanobis distance is the smaller one of the two, and symmetric")
{
  const Gaussians mixture = {{1, Vector3(0, 0, 0), Vector3(4, 1, 1).asDiagonal()},
                             {1, Vector3(6, 0, 0), Matrix3::Identity()}};
  const Squared_mahalanobis_distances distance(mixture);
  CHECK(distance(0, 1) == Approx(9));
  CHECK(distance(1, 0) == distance(0, 1));
  CHECK(distance(0, 0) == 0);
}

TEST_CASE("The angle at a vertex is 180 degrees straight on and 0 straight back")
{
  const Vector3 o = Vector3::Zero(), x = Vector3::UnitX(), y = Vector3::UnitY();
  CHECK(angle_at(x, o, -x) == Approx(180));
  CHECK(angle_at(x, o, y) == Approx(90));
  CHECK(angle_at(x, o, 2 * x) == 0);
  CHECK(angle_at(x, o, o) == 180);
}

TEST_CASE("A line is one branch from end to end, whatever the order of its components")
{
  const unsigned int seed = GENERATE(1u, 2u, 3u, 4u);
  CAPTURE(seed);
  Gaussians mixture;
  add_line(mixture, Vector3::Zero(), Vector3(spacing, 0, 0), 20);
  std::mt19937 generator(seed);
  std::shuffle(mixture.begin(), mixture.end(), generator);

  const std::vector<Branch> branches = detect_branches(mixture, Branch_detection_options());
  REQUIRE(branches.size() == 1);
  REQUIRE(branches.front().size() == 20);
  for(std::size_t k = 1; k < 20; ++k)
    CHECK((mixture[branches[0][k]].mean - mixture[branches[0][k - 1]].mean).norm() ==
          Approx(spacing));
}

TEST_CASE("A branch turns by less than a right angle")
{
  const auto branches_at = [](double degrees) {
    return detect_branches(corner(degrees), Branch_detection_options());
  };
  CHECK(branches_at(80).size() == 2);
  CHECK(branches_at(100).size() == 1);
  CHECK(number_of_used(branches_at(80)) == 21);
  CHECK(number_of_used(branches_at(100)) == 21);

  Gaussians square;
  add_line(square, Vector3(10 * spacing, 0, 0), Vector3(-spacing, 0, 0), 11);
  add_line(square, Vector3(0, spacing, 0), Vector3(0, spacing, 0), 10);
  CHECK(detect_branches(square, Branch_detection_options()).size() == 2); // must exceed, not reach

  Branch_detection_options sharper;
  sharper.alpha_min = 60;
  CHECK(detect_branches(corner(80), sharper).size() == 1);
}

TEST_CASE("A Y is two branches, merged at one junction")
{
  Gaussians mixture;
  mixture.push_back({1, Vector3::Zero(), 1e-6 * Matrix3::Identity()});
  for(int arm = 0; arm < 3; ++arm) {
    const double angle = 2 * CGAL_PI * arm / 3;
    const Vector3 step(spacing * std::cos(angle), spacing * std::sin(angle), 0);
    add_line(mixture, step, step, 10);
  }
  const std::vector<Branch> branches = detect_branches(mixture, Branch_detection_options());
  CHECK(branches.size() == 2);
  const Skeleton_graph graph = link_branches(mixture, branches);
  CHECK(graph.vertices.size() == 31);
  CHECK(is_tree(graph));
  CHECK(number_of_vertices_of_degree(graph, 1) == 3);
  CHECK(number_of_vertices_of_degree(graph, 3) == 1);
}

TEST_CASE("Two lines are two branches, linked where they are closest")
{
  Gaussians mixture;
  add_line(mixture, Vector3(0, 0, 0), Vector3(spacing, 0, 0), 10);
  add_line(mixture, Vector3(0, 0.1, 0), Vector3(spacing, 2 * spacing, 0), 10);
  const std::vector<Branch> branches = detect_branches(mixture, Branch_detection_options());
  REQUIRE(branches.size() == 2);
  const Skeleton_graph graph = link_branches(mixture, branches);
  REQUIRE(is_tree(graph));
  const Skeleton_graph::Edge link = graph.edges.back();
  const Vector3 difference =
    graph.vertices[link.first].position - graph.vertices[link.second].position;
  CHECK(difference.norm() == Approx(0.1));
}

TEST_CASE("Long components follow their own direction, not the closest mean")
{
  Gaussians mixture; // two parallel lines closer to each other than their own components
  for(double y : {0.0, 0.7 * spacing}) {
    add_line(mixture, Vector3(0, y, 0), Vector3(spacing, 0, 0), 10);
  }
  for(Gaussian& g : mixture)
    g.covariance = spacing * spacing * Matrix3(Vector3(1, 0.01, 0.01).asDiagonal());
  const std::vector<Branch> branches = detect_branches(mixture, Branch_detection_options());
  REQUIRE(branches.size() == 2);
  for(const Branch& b : branches)
    for(std::size_t i : b)
      CHECK(mixture[i].mean.y() == mixture[b.front()].mean.y());
}

TEST_CASE("A branch has b_min components")
{
  Gaussians mixture;
  add_line(mixture, Vector3::Zero(), Vector3(spacing, 0, 0), 4);
  CHECK(detect_branches(mixture, Branch_detection_options()).empty());
  add_line(mixture, Vector3(4 * spacing, 0, 0), Vector3(spacing, 0, 0), 1);
  CHECK(detect_branches(mixture, Branch_detection_options()).size() == 1);
  add_line(mixture, Vector3(0, 1, 0), Vector3(spacing, 0, 0), 4); // too short, and left out
  const std::vector<Branch> branches = detect_branches(mixture, Branch_detection_options());
  CHECK(branches.size() == 1);
  CHECK(link_branches(mixture, branches).vertices.size() == 5);
}

TEST_CASE("Limbs whose components are dense, sparse or apart all get their branch")
{
  const unsigned int seed = GENERATE(11u, 12u, 13u);
  CAPTURE(seed);
  // The dense one holds most of the components, so that the median spacing is that of a clump.
  Gaussians mixture;
  add_line(mixture, Vector3(-0.4, 0, 0), Vector3(0.001, 0, 0), 200); // clumped
  add_line(mixture, Vector3(0, 0, 0), Vector3(0.04, 0, 0), 10);      // 40 times as sparse
  add_line(mixture, Vector3(0, 0.4, 0), Vector3(0.02, 0, 0), 10);    // detached
  std::mt19937 generator(seed);
  std::shuffle(mixture.begin(), mixture.end(), generator);
  const Branch_detection_options options;
  const std::vector<Branch> branches = detect_branches(mixture, options);
  CHECK(branches.size() == 3);
  CHECK(number_of_used(branches) == mixture.size());
  const Skeleton_graph graph = link_branches(mixture, branches);
  CHECK(is_tree(graph));
}

TEST_CASE("Only links that merge branches are longer than d_max")
{
  const unsigned int seed = GENERATE(range(300u, 306u));
  const double d_max = GENERATE(0.05, 0.1, 0.2);
  CAPTURE(seed, d_max);
  const Gaussians mixture = random_mixture(200, seed);
  Branch_detection_options options;
  options.d_max = d_max;
  options.b_min = 2;
  const std::vector<Branch> branches = detect_branches(mixture, options);
  REQUIRE(!branches.empty());
  const Skeleton_graph graph = link_branches(mixture, branches);
  double longest = 0;
  for(std::size_t e = 0; e + branches.size() - 1 < graph.edges.size(); ++e)
    longest = std::max(longest, (graph.vertices[graph.edges[e].first].position -
                                 graph.vertices[graph.edges[e].second].position)
                                  .norm());
  CHECK(longest < d_max);
  CHECK(longest > d_max / 4); // the bound is what ends a branch
}

TEST_CASE("A pair further apart than d_max does not start a branch")
{
  Gaussians mixture;
  add_line(mixture, Vector3::Zero(), Vector3(spacing, 0, 0), 20);
  add_line(mixture, Vector3(0, 0.3, 0), Vector3(6 * spacing, 0, 0), 6);
  Branch_detection_options options;
  options.d_max = 5 * spacing;
  CHECK(detect_branches(mixture, options).size() == 1);
  options.d_max = 7 * spacing;
  CHECK(detect_branches(mixture, options).size() == 2);
}

TEST_CASE("No components have no skeleton, any others have one")
{
  const Branch_detection_options options;
  CHECK(detect_branches({}, options).empty());
  CHECK(detect_longest_branches({}, options).empty());
  CHECK(link_branches({}, {}).vertices.empty());

  const int size = GENERATE(1, 2, 3, 4, 6);
  CAPTURE(size);
  Gaussians mixture;
  SECTION("a line has all of its components")
  {
    add_line(mixture, Vector3::Zero(), Vector3(spacing, spacing, 0), size);
    const Skeleton_graph graph = link_branches(mixture, detect_longest_branches(mixture, options));
    CHECK(graph.vertices.size() == mixture.size());
    CHECK(is_tree(graph));
  }
  SECTION("components at one place have one vertex")
  {
    add_line(mixture, Vector3(0.1, 0.2, 0.3), Vector3::Zero(), size);
    mixture.back().weight = 2;
    const std::vector<Branch> branches = detect_longest_branches(mixture, options);
    CHECK(branches == std::vector<Branch>{{mixture.size() - 1}});
    CHECK(link_branches(mixture, branches).vertices.size() == 1);
  }
}

TEST_CASE("Fast or line by line, the branches are the same")
{
  const unsigned int seed = GENERATE(range(100u, 110u));
  const double d_max = GENERATE(0.03, 0.06, 10.0);
  CAPTURE(seed, d_max);
  const Gaussians mixture = random_mixture(150, seed);
  Branch_detection_options options;
  options.d_max = d_max;
  const std::vector<Branch> branches = detect_branches(mixture, options);
  CHECK(branches == Listing(mixture, options).run());
  CHECK(detect_branches(mixture, options) == branches);
}

TEST_CASE("Merging gives the tree of the shortest links")
{
  const unsigned int seed = GENERATE(range(200u, 210u));
  CAPTURE(seed);
  const Gaussians mixture = random_mixture(120, seed);
  const std::vector<Branch> branches = detect_longest_branches(mixture, Branch_detection_options());
  const Skeleton_graph graph = link_branches(mixture, branches);
  REQUIRE(graph.vertices.size() == number_of_used(branches));
  CHECK(is_tree(graph));

  Branch component_of; // vertices come branch by branch
  for(const Branch& b : branches)
    component_of.insert(component_of.end(), b.begin(), b.end());
  const Squared_mahalanobis_distances distance(mixture);
  double length = 0;
  for(std::size_t e = graph.vertices.size() - branches.size(); e < graph.edges.size(); ++e)
    length += std::sqrt(distance(component_of[graph.edges[e].first],
                                 component_of[graph.edges[e].second]));
  CHECK(length == Approx(length_of_greedy_links(mixture, branches)));
}

} // namespace branches_test
