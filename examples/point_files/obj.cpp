// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats.h"
#include "numbers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace point_files {

namespace {

// A vertex by its place from 1, or from the last one backwards; texture and normal may follow.
std::size_t vertex_of(const Input& input, std::string_view corner, std::size_t vertices)
{
  std::int64_t place = 0;
  if(to_integer(corner.substr(0, corner.find('/')), place)) {
    if(place > 0)
      return static_cast<std::size_t>(place - 1);
    if(place < 0 && static_cast<std::uint64_t>(-(place + 1)) < vertices)
      return vertices - 1 - static_cast<std::size_t>(-(place + 1));
  }
  throw Bad_file(input.line() + " names no vertex by '" + std::string(corner.substr(0, 40)) + "'");
}

} // namespace

void read_obj(Input& input, Rows& rows)
{
  std::vector<std::string_view> words;
  Rows::Face face;
  for(std::string_view line; input.next_line(line);) {
    split(line.substr(0, line.find('#')), words);
    if(words.empty())
      continue;
    if(words[0] == "v") {
      std::array<double, 3> p;
      if(words.size() < 4 || !to_number(words[1], p[0]) || !to_number(words[2], p[1]) ||
         !to_number(words[3], p[2]))
        throw Bad_file(input.line() + " is not understood");
      rows.add_point(p[0], p[1], p[2]);
    }
    else if(words[0] == "f") {
      face.clear();
      for(std::size_t k = 1; k < words.size(); ++k)
        face.push_back(vertex_of(input, words[k], rows.number_of_rows()));
      rows.add_face(face);
    }
  }
}

} // namespace point_files
