// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The compared methods that are made of this package and of CGAL, on shapes whose skeleton is
// known.

#include "catch2.h"
#include "graph_counts.h"
#include "method_shapes.h"
#include "skeleton_checks.h"
#include "statistics.h"

#include "methods/l1_medial.h"
#include "methods/l1_medial_published.h"
#include "methods/mcf.h"
#include "methods/poisson_mcf.h"
#include "methods/wrap_mcf.h"

#include <CGAL/boost/graph/Euler_operations.h>

#include <cstddef>
#include <string>
#include <vector>

namespace {

struct Method
{
  std::string name;
  Method_result (*run)(const Method_input&);
  bool finds_loops;
  std::size_t spurs; ///< at most, on a limb
};

// The flow leaves a spur or two in a round cap, the published method some along a limb.
const std::vector<Method> methods = {{"l1_medial", l1_medial, true, 0},
                                     {"l1_medial_published", l1_medial_published, false, 6},
                                     {"mcf", mcf, true, 2},
                                     {"wrap_mcf", wrap_mcf, true, 2},
                                     {"poisson_mcf", poisson_mcf, true, 2}};

constexpr double radius = 0.2;

double median_distance_to_axes(const Skeleton& skeleton, const shapes::Shape& shape)
{
  std::vector<double> distances;
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    distances.push_back(shapes::distance_to_axes(shape, shapes::to_vector(skeleton[v].point)));
  return median_of(distances);
}

Skeleton skeleton_of(const Method& method, const Method_input& input)
{
  const Method_result result = method.run(input);
  check_valid(result.skeleton, input.points.size());
  CHECK_FALSE(result.stages.empty());
  for(const auto& [stage, seconds] : result.stages) {
    CAPTURE(stage);
    CHECK(seconds >= 0);
  }
  return result.skeleton;
}

void check_tree(const shapes::Shape& shape, std::size_t limbs, std::size_t ends)
{
  const Method_input input = shapes::method_input(shape);
  for(const Method& method : methods) {
    CAPTURE(method.name);
    const Skeleton skeleton = skeleton_of(method, input);
    const Graph_counts counts = count_graph(skeleton);
    CHECK(counts.components == 1);
    CHECK(counts.cycles == 0);
    CHECK(counts.ends >= ends);
    CHECK(counts.ends <= ends + method.spurs * limbs);
    CHECK(median_distance_to_axes(skeleton, shape) < 0.5 * radius);
  }
}

} // namespace

TEST_CASE("A cylinder gives a curve with two ends")
{
  check_tree(shapes::cylinder(radius), 1, 2);
}

TEST_CASE("A Y gives three ends")
{
  check_tree(shapes::y_junction(radius), 3, 3);
}

TEST_CASE("A ring gives a loop to those that can")
{
  const Method_input input = shapes::method_input(shapes::ring(radius));
  for(const Method& method : methods) {
    CAPTURE(method.name);
    const Graph_counts counts = count_graph(skeleton_of(method, input));
    CHECK(counts.components == 1);
    CHECK(counts.cycles == (method.finds_loops ? 1 : 0));
  }
}

TEST_CASE("An open mesh is no input for the flow")
{
  Method_input input = shapes::method_input(shapes::cylinder(radius), 500);
  Mesh& mesh = input.components.front();
  CGAL::Euler::remove_face(halfedge(*mesh.faces().begin(), mesh), mesh);
  CHECK_THROWS_WITH(mcf(input), "mesh is open");
}
