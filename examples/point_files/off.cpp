// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "binary.h"
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

using Words = std::vector<std::string_view>;

struct Off_header
{
  bool is_binary = false;
  std::size_t numbers_of_vertex = 3; // binary: with normal, colour and texture
  std::uint64_t vertices = 0, faces = 0;
};

// The next line that is not empty, without comment.
bool next_words(Input& input, Words& words)
{
  for(std::string_view line; input.next_line(line);) {
    split(line.substr(0, line.find('#')), words);
    if(!words.empty())
      return true;
  }
  return false;
}

[[noreturn]] void not_understood(const Input& input)
{
  throw Bad_file(input.line() + " is not understood");
}

// "[ST][C][N]OFF"; 4OFF and nOFF have other dimensions.
void read_keyword(const Input& input, std::string_view keyword, Off_header& header)
{
  const auto drop = [&keyword](std::string_view prefix) {
    const bool found = keyword.substr(0, prefix.size()) == prefix;
    keyword.remove_prefix(found ? prefix.size() : 0);
    return found;
  };
  header.numbers_of_vertex +=
      (drop("ST") ? 2u : 0u) + (drop("C") ? 4u : 0u) + (drop("N") ? 3u : 0u);
  if(keyword != "OFF")
    not_understood(input);
}

Off_header read_header(Input& input)
{
  Off_header header;
  Words words;
  if(!next_words(input, words))
    throw Ends_early();
  read_keyword(input, words[0], header);
  words.erase(words.begin());
  if(words == Words{"BINARY"}) {
    header.is_binary = true;
    Numbers bytes(input, Byte_order::big);
    header.vertices = bytes.read<std::uint32_t>();
    header.faces = bytes.read<std::uint32_t>();
    bytes.read<std::uint32_t>(); // edges
    return header;
  }
  if(words.empty() && !next_words(input, words))
    throw Ends_early();
  if(words.size() < 2 || !to_integer(words[0], header.vertices) ||
     !to_integer(words[1], header.faces))
    not_understood(input);
  return header;
}

void check_vertex(const Input& input, std::uint64_t face, std::uint64_t vertex,
                  const Off_header& header)
{
  if(vertex >= header.vertices)
    throw Bad_file(input.location() + "face " + std::to_string(face) + " names vertex " +
                   std::to_string(vertex) + " of " + std::to_string(header.vertices));
}

void read_text_body(Input& input, const Off_header& header, Rows& rows)
{
  Words words;
  for(std::uint64_t i = 0; i < header.vertices; ++i) {
    if(!next_words(input, words))
      throw Ends_early();
    std::array<double, 3> p;
    if(words.size() < 3 || !to_number(words[0], p[0]) || !to_number(words[1], p[1]) ||
       !to_number(words[2], p[2]))
      not_understood(input);
    rows.add_point(p[0], p[1], p[2]);
  }
  Rows::Face face;
  for(std::uint64_t i = 0; i < header.faces; ++i) {
    std::size_t size = 0;
    if(!next_words(input, words))
      throw Ends_early();
    if(!to_integer(words[0], size) || size > words.size() - 1) // more words are its colour
      not_understood(input);
    face.resize(size);
    for(std::size_t k = 0; k < size; ++k) {
      if(!to_integer(words[k + 1], face[k]))
        not_understood(input);
      check_vertex(input, i, face[k], header);
    }
    rows.add_face(face);
  }
}

void read_binary_body(Input& input, const Off_header& header, Rows& rows)
{
  Numbers bytes(input, Byte_order::big);
  for(std::uint64_t i = 0; i < header.vertices; ++i) {
    const float x = bytes.read<float>(), y = bytes.read<float>(), z = bytes.read<float>();
    input.skip(sizeof(float) * (header.numbers_of_vertex - 3));
    rows.add_point(x, y, z);
  }
  Rows::Face face;
  for(std::uint64_t i = 0; i < header.faces; ++i) {
    face.clear();
    for(auto left = bytes.read<std::uint32_t>(); left > 0; --left) {
      face.push_back(bytes.read<std::uint32_t>());
      check_vertex(input, i, face.back(), header);
    }
    input.skip(sizeof(float) * std::uint64_t(bytes.read<std::uint32_t>())); // its colour
    rows.add_face(face);
  }
}

} // namespace

void read_off(Input& input, Rows& rows)
{
  const Off_header header = read_header(input);
  if(header.is_binary)
    read_binary_body(input, header, rows);
  else
    read_text_body(input, header, rows);
}

} // namespace point_files
