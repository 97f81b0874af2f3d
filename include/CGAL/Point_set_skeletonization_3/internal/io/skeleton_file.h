// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_H

#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>

#include <cstddef>
#include <iosfwd>
#include <string>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

struct Written_skeleton;

/// Whether `text` ends with `ending`, given in small letters, in small or capital letters.
bool ends_with(const std::string& text, const std::string& ending);

/// Whether the ending of a filename chooses a format.
bool is_skeleton_filename(const std::string& filename);

/// Returns all endings as a list in a sentence.
std::string skeleton_endings();

/// Writes in the format of a filename. \pre `is_skeleton_filename(filename)`
void write_skeleton(std::ostream& os, const std::string& filename,
                    const Written_skeleton& skeleton);

/// Writes a file with the branches from these roots, see `write_curve_skeleton()`. O(n log n).
/// \throw std::runtime_error
void write_skeleton_file(const std::string& filename, const Plain_skeleton& skeleton,
                         const std::vector<std::size_t>& roots);

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_COMPILED
#include <CGAL/Point_set_skeletonization_3/internal/io/skeleton_file_impl.h>
#endif

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_SKELETON_FILE_H
