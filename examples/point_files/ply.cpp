// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"
#include "binary.h"
#include "formats.h"
#include "numbers.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>
#include <vector>

namespace point_files {

namespace {

constexpr std::size_t none = (std::numeric_limits<std::size_t>::max)();

bool is_vertices(const Ply_element& element)
{
  return element.name == "vertex" || element.name == "vertices";
}

bool is_faces(const Ply_element& element)
{
  return element.name == "face" || element.name == "faces";
}

// What is read of an element: its properties by their numbers, `none` for those that are not there.
struct Wanted
{
  std::array<std::size_t, 3> coordinates{{none, none, none}};
  std::size_t corners = none;

  explicit Wanted(const Ply_element& element)
  {
    for(std::size_t i = 0; i < element.properties.size(); ++i) {
      const Ply_property& property = element.properties[i];
      const bool is_list = property.type_of_size.has_value();
      for(std::size_t k = 0; k < 3; ++k)
        if(is_vertices(element) && !is_list &&
           property.name == std::string_view("xyz").substr(k, 1))
          coordinates[k] = i;
      if(is_faces(element) && is_list && is_integer(property.type) &&
         (property.name == "vertex_indices" || property.name == "vertex_index"))
        corners = i;
    }
  }

  bool is_vertex() const
  {
    return std::find(coordinates.begin(), coordinates.end(), none) == coordinates.end();
  }

  bool is_anything() const { return is_vertex() || corners != none; }
};

[[noreturn]] void no_vertex(const Input& input, std::size_t face)
{
  throw Bad_file(input.location() + "face " + std::to_string(face) + " names a negative vertex");
}

// Hands out the rows of an element.
class Taker
{
public:
  Taker(const Input& input, const Wanted& wanted, Rows& rows)
      : input_(input)
      , wanted_(wanted)
      , rows_(rows)
  {}

  bool wants_list(std::size_t property) const { return property == wanted_.corners; }

  void take(std::size_t property, double number)
  {
    for(std::size_t k = 0; k < 3; ++k)
      if(property == wanted_.coordinates[k])
        point_[k] = number;
  }

  void take_corner(std::int64_t vertex)
  {
    if(vertex < 0)
      no_vertex(input_, number_of_faces_);
    face_.push_back(static_cast<std::size_t>(vertex));
  }

  void end_row()
  {
    if(wanted_.is_vertex())
      rows_.add_point(point_[0], point_[1], point_[2]);
    if(wanted_.corners == none)
      return;
    rows_.add_face(face_);
    face_.clear();
    ++number_of_faces_;
  }

private:
  const Input& input_;
  const Wanted& wanted_;
  Rows& rows_;
  std::array<double, 3> point_{};
  Rows::Face face_;
  std::size_t number_of_faces_ = 0;
};

// One line per row.
void read_text_rows(Input& input, const Ply_element& element, Taker& taker)
{
  const auto not_understood = [&input] { throw Bad_file(input.line() + " is not understood"); };
  std::vector<std::string_view> words;
  for(std::uint64_t row = 0; row < element.size; ++row) {
    words.clear();
    for(std::string_view line; words.empty();) {
      if(!input.next_line(line))
        throw Ends_early();
      split(line, words);
    }
    std::size_t next = 0;
    for(std::size_t i = 0; i < element.properties.size(); ++i) {
      if(next == words.size())
        not_understood();
      const std::string_view word = words[next++];
      if(!element.properties[i].type_of_size) {
        double number = 0;
        if(!to_number(word, number))
          not_understood();
        taker.take(i, number);
        continue;
      }
      std::size_t size = 0;
      if(!to_integer(word, size) || size > words.size() - next)
        not_understood();
      for(; size > 0; --size, ++next) {
        std::int64_t vertex = 0;
        if(!taker.wants_list(i))
          continue;
        if(!to_integer(words[next], vertex))
          not_understood();
        taker.take_corner(vertex);
      }
    }
    taker.end_row();
  }
}

// Rows whose size is not known before they are read.
void read_binary_rows(Input& input, Byte_order order, const Ply_element& element, Taker& taker)
{
  std::array<char, 8> bytes;
  const auto as_integer = [](auto number) {
    const bool fits = number >= 0 && static_cast<double>(number) < 0x1p63;
    return fits ? static_cast<std::int64_t>(number) : std::int64_t(-1);
  };
  for(std::uint64_t row = 0; row < element.size; ++row) {
    for(std::size_t i = 0; i < element.properties.size(); ++i) {
      const Ply_property& property = element.properties[i];
      const std::size_t bytes_of_number = size_of(property.type);
      if(!property.type_of_size) {
        input.read(bytes.data(), bytes_of_number);
        taker.take(i, to_double(bytes.data(), property.type, order));
        continue;
      }
      input.read(bytes.data(), size_of(*property.type_of_size));
      std::int64_t size = decode(bytes.data(), *property.type_of_size, order, as_integer);
      if(size < 0 || static_cast<std::uint64_t>(size) > input.bytes_left() / bytes_of_number)
        throw Ends_early();
      if(!taker.wants_list(i))
        input.skip(static_cast<std::uint64_t>(size) * bytes_of_number);
      else
        for(; size > 0; --size) {
          input.read(bytes.data(), bytes_of_number);
          taker.take_corner(decode(bytes.data(), property.type, order, as_integer));
        }
    }
    taker.end_row();
  }
}

// The number of bytes of a row; 0 if there is a list.
std::size_t row_size(const Ply_element& element)
{
  std::size_t size = 0;
  for(const Ply_property& property : element.properties) {
    if(property.type_of_size)
      return 0;
    size += size_of(property.type);
  }
  return size;
}

// Rows of a size known before: only what is wanted is looked at.
void read_binary_vertices(Input& input, Byte_order order, const Ply_element& element,
                          const Wanted& wanted, Rows& rows)
{
  std::array<std::size_t, 3> offset{};
  std::size_t size = 0;
  for(std::size_t i = 0; i < element.properties.size(); ++i) {
    for(std::size_t k = 0; k < 3; ++k)
      if(i == wanted.coordinates[k])
        offset[k] = size;
    size += size_of(element.properties[i].type);
  }
  std::vector<char> bytes(size);
  for(std::uint64_t row = 0; row < element.size; ++row) {
    input.read(bytes.data(), size);
    std::array<double, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = to_double(bytes.data() + offset[k], element.properties[wanted.coordinates[k]].type,
                       order);
    rows.add_point(p[0], p[1], p[2]);
  }
}

void read_element(Input& input, const Ply_header& header, const Ply_element& element, Rows& rows)
{
  if(element.properties.empty()) // such rows take no bytes
    return;
  const Wanted wanted(element);
  const std::size_t size = row_size(element);
  Taker taker(input, wanted, rows);
  if(header.is_text)
    read_text_rows(input, element, taker);
  else if(size == 0)
    read_binary_rows(input, header.byte_order, element, taker);
  else if(wanted.is_vertex())
    read_binary_vertices(input, header.byte_order, element, wanted, rows);
  else if(element.size <= Input::unknown / size)
    input.skip(element.size * size);
  else
    throw Ends_early();
}

} // namespace

void read_ply(Input& input, Rows& rows)
{
  const Ply_header header = read_ply_header(input);
  const auto& elements = header.elements;
  const auto vertices = std::count_if(elements.begin(), elements.end(), is_vertices);
  const auto vertex = std::find_if(elements.begin(), elements.end(), is_vertices);
  if(vertices != 1 || !Wanted(*vertex).is_vertex())
    throw Bad_file("its vertices have no x, y and z");
  std::size_t end = elements.size(); // nothing behind the last element of interest is read
  while(!Wanted(elements[end - 1]).is_anything())
    --end;
  for(std::size_t i = 0; i < end; ++i)
    read_element(input, header, elements[i], rows);
}

} // namespace point_files
