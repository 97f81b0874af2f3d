// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "binary.h"
#include "formats.h"
#include "numbers.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace point_files {

namespace {

using Corner = std::array<double, 3>;

struct Hash_of_corner
{
  std::size_t operator()(const Corner& corner) const
  {
    std::size_t result = 0;
    for(const double x : corner)
      result = result * 31 + std::hash<double>()(x);
    return result;
  }
};

// Makes vertices and faces of triangles that are given by the places of their corners.
class Triangles
{
public:
  explicit Triangles(Rows& rows)
      : rows_(rows)
  {}

  void add_corner(const Corner& corner)
  {
    const bool is_number =
        corner[0] == corner[0] && corner[1] == corner[1] && corner[2] == corner[2];
    const auto [known, is_new] = vertex_at_.emplace(corner, rows_.number_of_rows());
    face_.push_back(is_new || !is_number ? rows_.number_of_rows() : known->second);
    if(is_new)
      rows_.add_point(corner[0], corner[1], corner[2]);
  }

  void end_triangle()
  {
    rows_.add_face(face_);
    face_.clear();
  }

private:
  Rows& rows_;
  std::unordered_map<Corner, std::size_t, Hash_of_corner> vertex_at_;
  Rows::Face face_;
};

bool is_text(Input& input)
{
  const std::string_view begin = input.peek(4096); // binary ones may begin with "solid" as well
  return trimmed(begin).substr(0, 5) == "solid" &&
         (begin.find("facet") != std::string_view::npos ||
          begin.find("endsolid") != std::string_view::npos);
}

void read_text_triangles(Input& input, Triangles& triangles)
{
  std::vector<std::string_view> words;
  bool has_ended = false;
  for(std::string_view line; input.next_line(line);) {
    split(line, words);
    if(words.empty())
      continue;
    has_ended = words[0] == "endsolid";
    Corner corner;
    if(words[0] == "endfacet")
      triangles.end_triangle();
    else if(words[0] == "vertex") {
      if(words.size() < 4 || !to_number(words[1], corner[0]) || !to_number(words[2], corner[1]) ||
         !to_number(words[3], corner[2]))
        throw Bad_file(input.line() + " is not understood");
      triangles.add_corner(corner);
    }
  }
  if(!has_ended)
    throw Ends_early();
}

void read_binary_triangles(Input& input, Triangles& triangles)
{
  Numbers numbers(input, Byte_order::little);
  input.skip(80);
  auto left = numbers.read<std::uint32_t>();
  constexpr std::uint64_t bytes_of_triangle = 50;
  if(left * bytes_of_triangle > input.bytes_left())
    throw Ends_early();
  for(; left > 0; --left) {
    input.skip(12); // its normal
    for(int k = 0; k < 3; ++k) {
      Corner corner;
      for(double& x : corner)
        x = numbers.read<float>();
      triangles.add_corner(corner);
    }
    input.skip(2); // its attributes
    triangles.end_triangle();
  }
}

} // namespace

void read_stl(Input& input, Rows& rows)
{
  Triangles triangles(rows);
  if(is_text(input))
    read_text_triangles(input, triangles);
  else
    read_binary_triangles(input, triangles);
}

} // namespace point_files
