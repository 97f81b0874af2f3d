// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The inventory of a tree: its height, its diameter at 1.3, and where each branch starts, of which
// order it is, how long and thick, at which angle it leaves.
// The tree is sampled from round limbs, with a trunk that is 0.3 thick at the height of 1.3.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/IO/Curve_skeleton_3.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/number_type_config.h>
#include <CGAL/point_generators_3.h>
#include <CGAL/skeleton_branches.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <iostream>
#include <vector>

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;
using Vector = Kernel::Vector_3;
using Skeleton = CGAL::Curve_skeleton_3<Kernel>;

constexpr double trunk = 0.15; // radius

// Appends points on a round limb, outside of the trunk.
void add_limb(const Point& start, const Vector& along, double radius, std::size_t size,
              std::vector<Point>& points)
{
  CGAL::Random random(static_cast<unsigned int>(points.size()));
  const Kernel::Plane_3 across(start, along);
  const auto unit = [](const Vector& v) { return v / std::sqrt(v.squared_length()); };
  const Vector u = unit(across.base1()), v = unit(across.base2());
  for(std::size_t i = 0; i < size; ++i) {
    const double angle = random.get_double(0, 2 * CGAL_PI);
    const Point p =
        start + random.get_double() * along + radius * (std::cos(angle) * u + std::sin(angle) * v);
    if(radius == trunk || std::hypot(p.x(), p.y()) > trunk)
      points.push_back(p);
  }
}

// The radius where a branch passes a height; 0 if it does not.
double radius_at(const Skeleton& skeleton, const CGAL::Skeleton_branch_of<Skeleton>& branch,
                 double height)
{
  for(std::size_t i = 1; i < branch.vertices.size(); ++i) {
    const auto& a = skeleton[branch.vertices[i - 1]];
    const auto& b = skeleton[branch.vertices[i]];
    const double share = (height - a.point.z()) / (b.point.z() - a.point.z());
    if(share >= 0 && share <= 1)
      return a.radius + share * (b.radius - a.radius);
  }
  return 0;
}

int main()
{
  std::vector<Point> points;
  add_limb({0, 0, 0}, {0, 0, 6}, trunk, 8000, points);
  add_limb({0, 0, 3}, {2, 0, 1}, 0.08, 2500, points);
  add_limb({0, 0, 4}, {-1, 1, 1}, 0.07, 2000, points);

  Skeleton skeleton;
  CGAL::extract_l1_medial_skeleton(points, skeleton);
  const auto branches = CGAL::skeleton_branches(skeleton); // from the lowest vertex

  double height = 0, diameter = 0;
  for(const auto& branch : branches) {
    height = (std::max)(height, skeleton[branch.vertices.back()].point.z());
    if(branch.order == 0 && diameter == 0)
      diameter = 2 * radius_at(skeleton, branch, 1.3);
    std::cout << "axis " << branch.axis << ", order " << branch.order << ", length "
              << branch.length << ", radius " << branch.mean_radius << ", angle " << branch.angle
              << '\n';
  }
  std::cout << "height " << height << ", diameter at 1.3: " << diameter << '\n';
  CGAL::IO::write_curve_skeleton("branches_example.csv", skeleton); // a cylinder per edge
  CGAL::IO::write_curve_skeleton("branches_example.ply", skeleton);
  std::ofstream file("branches_example.xyz");
  for(const Point& p : points)
    file << p << '\n';
}
