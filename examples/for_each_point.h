// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H

#include "read_file.h"

#include <CGAL/Bulk_bbox_3.h>
#include <CGAL/Kernel_traits.h>

#include <cstddef>
#include <string>
#include <vector>

/// Calls `use` with the points of a file one after the other, in memory that does not depend on
/// their number; a mesh's vertices are points. Else as `read_points()`: the same errors, also what
/// `use` throws as std::invalid_argument, and formats that have to be kept in memory.
///
/// \returns the number of rows left out, see `Reading_options`
/// \throw std::runtime_error with a message of one line that names the file and, where there is
///   one, the line or the point.
template <typename Point, typename Use>
std::size_t for_each_point(const std::string& filename, const Use& use,
                           point_files::Reading_options options = point_files::Reading_options())
{
  options.in_bounded_memory = true;
  point_files::Rows rows([&use](double x, double y, double z) { use(Point(x, y, z)); },
                         options.skip_invalid);
  point_files::read_file(filename, options, rows);
  return rows.number_of_skipped();
}

/// The box of the bulk of the points of some files, each of which is read once or, if there are
/// points far away, twice; see `for_each_point()`.
template <typename Point>
CGAL::Bulk_bbox_3<typename CGAL::Kernel_traits<Point>::Kernel>
bulk_of_files(const std::vector<std::string>& filenames,
              const point_files::Reading_options& options = point_files::Reading_options())
{
  CGAL::Bulk_bbox_3<typename CGAL::Kernel_traits<Point>::Kernel> bulk;
  do
    for(const std::string& filename : filenames)
      for_each_point<Point>(
          filename, [&bulk](const Point& p) { bulk.insert(p); }, options);
  while(!bulk.end_pass());
  return bulk;
}

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_FOR_EACH_POINT_H
