// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Beside CGAL's skeletons of closed meshes: the same graph type, from the bare vertices.

#include <CGAL/Curve_skeleton_3.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/split_graph_into_polylines.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_mean_curvature_flow_skeleton.h>

#include <fstream>
#include <iostream>

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;

// Counts the polylines of a skeleton; works on either.
struct Counter
{
  std::size_t polylines = 0;
  void start_new_polyline() { ++polylines; }
  template <typename Vertex>
  void add_node(Vertex) {}
  void end_polyline() {}
};

template <typename Skeleton>
std::size_t number_of_polylines(const Skeleton& skeleton)
{
  Counter counter;
  CGAL::split_graph_into_polylines(skeleton, counter);
  return counter.polylines;
}

int main(int argc, char** argv)
{
  Mesh mesh;
  std::ifstream file(argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off"));
  file >> mesh;

  CGAL::Mean_curvature_flow_skeletonization<Mesh>::Skeleton from_mesh;
  CGAL::extract_mean_curvature_flow_skeleton(mesh, from_mesh);
  std::cout << "from the closed mesh: " << number_of_polylines(from_mesh) << " polylines\n";

  CGAL::Curve_skeleton_3<Kernel> from_points;
  CGAL::extract_l1_medial_skeleton(mesh.points(), from_points);
  std::cout << "from its vertices alone: " << number_of_polylines(from_points) << " polylines\n";
}
