// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_NUMBERS_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_NUMBERS_H

#include <charconv>
#include <cstddef>
#include <string_view>
#include <system_error>
#include <vector>

namespace point_files {

/// Whether the whole of `text` is a number, "nan" and "inf" included, in any locale of the program.
bool to_number(std::string_view text, double& number);

/// Whether the whole of `text` is an integer that fits.
template <typename Integer>
bool to_integer(std::string_view text, Integer& integer)
{
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, integer);
  return error == std::errc() && stop == end && !text.empty();
}

/// Without the white space at both ends.
std::string_view trimmed(std::string_view text);

/// The words of a line, which white space separates.
void split(std::string_view line, std::vector<std::string_view>& words);

/// The fields of a line, which single characters separate; without white space around them.
void split(std::string_view line, char separator, std::vector<std::string_view>& fields);

} // namespace point_files

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_POINT_FILES_NUMBERS_H
