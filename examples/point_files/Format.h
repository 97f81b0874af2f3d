// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMAT_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMAT_H

#include "Input.h"
#include "Rows.h"

#include <string>
#include <string_view>

namespace point_files {

/// A file format that is read.
struct Format
{
  std::string_view extension; ///< In lower case, without a dot.
  void (*read)(Input&, Rows&);
};

/// The format with this extension, in any case and with or without a dot; else a null pointer.
const Format* find_format(std::string_view extension);

/// The format that the first bytes of an input tell; a null pointer if it is one that they do not.
const Format* format_of_content(Input& input);

/// ".off, .ply, ...": what is read, for messages.
std::string names_of_formats();

/// The extension of a file name, in lower case and without the dot.
std::string extension_of(const std::string& filename);

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_FORMAT_H
