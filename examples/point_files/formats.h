// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMATS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMATS_H

#include "Input.h"
#include "Rows.h"

namespace point_files {

// One reader per format. Each reads the input from its begin, once, and hands out every row as soon
// as it has it; counts in the file only say when to stop. All throw Bad_file or Ends_early.

/// Rows of numbers with any separator: .xyz, .txt, .csv, .pts, .asc, .pwn.
void read_text(Input& input, Rows& rows);

/// Object File Format, text or binary.
void read_off(Input& input, Rows& rows);

/// Polygon File Format, text or binary.
void read_ply(Input& input, Rows& rows);

/// Wavefront: vertices and faces.
void read_obj(Input& input, Rows& rows);

/// Stereolithography, text or binary. Corners at the same place are one vertex: so it keeps them.
void read_stl(Input& input, Rows& rows);

/// Point Cloud Library: text, binary, or compressed binary, which it has to keep.
void read_pcd(Input& input, Rows& rows);

/// Laser scans, LAS 1.0 to 1.4, not compressed.
void read_las(Input& input, Rows& rows);

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMATS_H
