// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_DATA_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_DATA_H

#include <CGAL/Point_set_skeletonization_3/Medial_sample_kind.h>
#include <CGAL/Point_set_skeletonization_3/internal/mixture/Cell_numbers.h>

#include <array>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

// The results of the stages in the coordinates of the input, without a kernel; public data
// structures are made from them.

using Plain_point = std::array<double, 3>;

struct Plain_gaussian
{
  double weight = 0;
  Plain_point mean{};
  std::array<double, 6> covariance{}; ///< The upper triangle, row by row.
};

/// The bounding box of the input.
struct Plain_box
{
  Plain_point lower{}, upper{};
  bool is_known = false;
};

struct Plain_mixture
{
  Plain_box box;
  std::vector<std::vector<Plain_gaussian>> levels; ///< Finest level first.
  double cell_size = 0;                            ///< Of the finest level; 0: no cells.
};

struct Plain_sample
{
  Plain_gaussian patch;
  Plain_point point{};
  double radius = 0;
  Medial_sample_kind kind = Medial_sample_kind::solid;
  std::size_t object = 0;
};

struct Plain_surface_point
{
  Plain_point point{}, denoised{};
  double weight = 1;
  std::size_t sample = 0;
};

struct Plain_samples
{
  Plain_box box;
  std::vector<Plain_sample> samples;
  std::vector<double> noise; ///< Of each object, in [0, 1]; 0 where there is none.
  std::vector<Plain_surface_point> surface;
};

struct Plain_l1_sample
{
  Plain_point origin{}, point{};
  double kernel_radius = 0, radius = 0;
};

struct Plain_vertex
{
  Plain_point point{};
  double radius = 0;
};

struct Plain_skeleton
{
  std::vector<Plain_vertex> vertices;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  std::size_t number_of_bridges = 0; ///< The last edges.
};

/// Which vertex the points of a builder belong to.
struct Plain_assignment
{
  std::pair<Plain_point, Plain_point> box; ///< Its corners. Points outside belong to none.
  Cell_numbers cells;
  std::vector<std::size_t> vertex_of_cell; ///< The greatest number for none.
};

/// Access to the index lists of all vertices, whatever their type.
struct Index_lists
{
  std::size_t bytes_of_index; ///< 1, 2, 4 or 8.
  /// Reserves capacity for the list of a vertex.
  std::function<void(std::size_t vertex, std::size_t capacity)> reserve;
  /// Resizes the list of a vertex and returns its data. May be called concurrently for different
  /// vertices.
  std::function<void*(std::size_t vertex, std::size_t size)> resize;
};

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_INTERFACE_PLAIN_DATA_H
