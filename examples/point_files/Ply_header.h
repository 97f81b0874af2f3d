// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_PLY_HEADER_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_PLY_HEADER_H

#include "Input.h"
#include "binary.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace point_files {

/// A number of every row of an element, or a list of numbers.
struct Ply_property
{
  std::string name;
  Number_type type;
  std::optional<Number_type> type_of_size; ///< If it is a list.
};

/// A table of a PLY file.
struct Ply_element
{
  std::string name;
  std::uint64_t size = 0; ///< Number of rows, as announced.
  std::vector<Ply_property> properties;
};

struct Ply_header
{
  bool is_text = true;
  Byte_order byte_order = Byte_order::little;
  std::vector<Ply_element> elements;
};

/// Reads all up to "end_header". \throw Bad_file, Ends_early
Ply_header read_ply_header(Input& input);

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_PLY_HEADER_H
