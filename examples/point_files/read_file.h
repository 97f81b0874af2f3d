// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_READ_FILE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_READ_FILE_H

#include "Input.h"
#include "Rows.h"

#include <functional>
#include <string>

namespace point_files {

/// How a file is read.
struct Reading_options
{
  /// The format by its extension, whatever the file is called; empty: as it is called. Standard
  /// input has no name.
  std::string format;

  /// Leaves out and counts what is no finite point, instead of an error: rows with NaN or infinity,
  /// and lines of text that are no row.
  bool skip_invalid = false;

  /// Refuses formats that have to be kept in memory to be read: .stl, and compressed .pcd.
  bool in_bounded_memory = false;

  /// Called with the share of the file that is read, in [0, 1], many times a second. It may throw.
  std::function<void(double)> progress = nullptr;
};

/// Reads a file of points, or a mesh, in any of the formats of `names_of_formats()`, and hands its
/// rows to `rows`. "-" is standard input; a pipe will do as well as a file. Memory: a buffer, and
/// what `rows` keeps.
///
/// \throw std::runtime_error with a message of one line that names the file and, where there is
///   one, the line or the point. So is a std::invalid_argument of the user of the points.
void read_file(const std::string& filename, const Reading_options& options, Rows& rows);

/// The same for bytes from anywhere, for instance memory; `name` is for messages and tells the
/// format.
void read_bytes(Input& input, const std::string& name, const Reading_options& options, Rows& rows);

/// Whether it is no pipe.
bool can_be_read_twice(const std::string& filename);

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_READ_FILE_H
