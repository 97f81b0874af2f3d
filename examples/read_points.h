// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H

#include "read_file.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

/// What a file holds: points, and the faces between them if it is a mesh.
template <typename Point>
struct Points_and_faces
{
  std::vector<Point> points;
  std::vector<std::vector<std::size_t>> faces;
  std::size_t number_of_skipped = 0; ///< Rows that were left out, see `Reading_options`.
};

namespace read_points_internal {

template <typename Point>
Points_and_faces<Point> read(const std::string& filename, bool keeps_faces,
                             const point_files::Reading_options& options)
{
  Points_and_faces<Point> result;
  point_files::Rows rows(
      [&result](double x, double y, double z) { result.points.emplace_back(x, y, z); },
      options.skip_invalid);
  if(keeps_faces)
    rows.keep_faces();
  point_files::read_file(filename, options, rows);
  result.faces = std::move(rows.faces());
  result.number_of_skipped = rows.number_of_skipped();
  return result;
}

} // namespace read_points_internal

/// Reads points, or a mesh, from a file in any format of `point_files/Format.h`. Points are counted
/// from 0, lines from 1.
///
/// \throw std::runtime_error with a message of one line that names the file and, where there is
///   one, the line or the point.
template <typename Point>
Points_and_faces<Point>
read_points_and_faces(const std::string& filename,
                      const point_files::Reading_options& options = point_files::Reading_options())
{
  return read_points_internal::read<Point>(filename, true, options);
}

/// Only the points; a mesh's vertices are points.
template <typename Point>
std::vector<Point>
read_points(const std::string& filename,
            const point_files::Reading_options& options = point_files::Reading_options())
{
  return read_points_internal::read<Point>(filename, false, options).points;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_READ_POINTS_H
