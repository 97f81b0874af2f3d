// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "binary.h"
#include "formats.h"
#include "lzf.h"
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

// Bytes: descriptors of a point have hundreds of numbers, not more.
constexpr std::size_t longest_row = std::size_t(1) << 20;

struct Field
{
  std::string name;
  std::size_t bytes_of_number = 4;
  char kind = 'F'; // F: floating, I: integer, U: unsigned
  std::size_t count = 1;
  Number_type type = Number_type::float32; // of bytes and kind
};

struct Pcd_header
{
  std::vector<Field> fields;
  std::uint64_t points = 0;
  bool has_points = false;
  std::string data;
};

[[noreturn]] void not_understood(const Input& input)
{
  throw Bad_file(input.line() + " is not understood");
}

// A number of the header for each field.
template <typename Take>
void take_fields(const Input& input, const Words& words, Pcd_header& header, const Take& take)
{
  if(words.size() != header.fields.size() + 1)
    not_understood(input);
  for(std::size_t i = 0; i < header.fields.size(); ++i)
    if(!take(words[i + 1], header.fields[i]))
      not_understood(input);
}

bool take_type(Field& field)
{
  const bool is_float = field.kind == 'F', is_signed = field.kind == 'I';
  switch(field.bytes_of_number) {
  case 1:
    field.type = is_signed ? Number_type::int8 : Number_type::uint8;
    return !is_float;
  case 2:
    field.type = is_signed ? Number_type::int16 : Number_type::uint16;
    return !is_float;
  case 4:
    field.type = is_float    ? Number_type::float32
                 : is_signed ? Number_type::int32
                             : Number_type::uint32;
    return true;
  case 8:
    field.type = is_float    ? Number_type::float64
                 : is_signed ? Number_type::int64
                             : Number_type::uint64;
    return true;
  default:
    return false;
  }
}

void take_line(const Input& input, const Words& words, Pcd_header& header)
{
  const std::string_view key = words[0];
  if(key == "FIELDS" || key == "COLUMNS") {
    header.fields.resize(words.size() - 1);
    for(std::size_t i = 0; i < header.fields.size(); ++i)
      header.fields[i].name = words[i + 1];
  }
  else if(key == "SIZE")
    take_fields(input, words, header, [](std::string_view word, Field& field) {
      return to_integer(word, field.bytes_of_number) && field.bytes_of_number <= 8;
    });
  else if(key == "TYPE")
    take_fields(input, words, header, [](std::string_view word, Field& field) {
      field.kind = word[0];
      return word == "F" || word == "I" || word == "U";
    });
  else if(key == "COUNT")
    take_fields(input, words, header, [](std::string_view word, Field& field) {
      return to_integer(word, field.count) && field.count <= longest_row;
    });
  else if(key == "POINTS")
    header.has_points = words.size() == 2 && to_integer(words[1], header.points);
  else if(key == "DATA" && words.size() == 2)
    header.data = words[1];
  else if(key != "VERSION" && key != "WIDTH" && key != "HEIGHT" && key != "VIEWPOINT")
    not_understood(input);
}

Pcd_header read_header(Input& input)
{
  Pcd_header header;
  Words words;
  for(std::string_view line; header.data.empty();) {
    if(!input.next_line(line))
      throw Ends_early();
    split(line.substr(0, line.find('#')), words);
    if(!words.empty())
      take_line(input, words, header);
  }
  if(!header.has_points)
    throw Bad_file("its header does not say how many points there are");
  for(Field& field : header.fields)
    if(!take_type(field))
      throw Bad_file("its field '" + field.name + "' has a type that does not exist");
  return header;
}

// Where x, y and z are.
struct Layout
{
  std::array<std::size_t, 3> field;  // its number
  std::array<std::size_t, 3> number; // how many numbers come before it in a row
  std::array<std::size_t, 3> offset; // how many bytes
  std::size_t row_size = 0;          // bytes
  std::size_t numbers = 0;           // in a row

  explicit Layout(const std::vector<Field>& fields)
  {
    std::array<bool, 3> found{};
    for(std::size_t i = 0; i < fields.size(); ++i) {
      for(std::size_t k = 0; k < 3; ++k)
        if(fields[i].name == std::string_view("xyz").substr(k, 1) && fields[i].count == 1) {
          found[k] = true;
          field[k] = i;
          number[k] = numbers;
          offset[k] = row_size;
        }
      numbers += fields[i].count;
      row_size += fields[i].count * fields[i].bytes_of_number;
      if(row_size > longest_row)
        throw Bad_file("its points have more than " + std::to_string(longest_row) + " bytes each");
    }
    if(!found[0] || !found[1] || !found[2])
      throw Bad_file("its points have no fields x, y and z");
  }
};

void read_text_rows(Input& input, const Pcd_header& header, const Layout& layout, Rows& rows)
{
  Words words;
  for(std::uint64_t i = 0; i < header.points;) {
    std::string_view line;
    if(!input.next_line(line))
      throw Ends_early();
    split(line, words);
    if(words.empty())
      continue;
    ++i;
    std::array<double, 3> p;
    bool is_row = words.size() == layout.numbers;
    for(std::size_t k = 0; k < 3 && is_row; ++k)
      is_row = to_number(words[layout.number[k]], p[k]);
    if(is_row)
      rows.add_point(p[0], p[1], p[2]);
    else
      rows.add_invalid(input.line() + " is no row of " + std::to_string(layout.numbers) +
                       " numbers; --skip-invalid leaves such lines out");
  }
}

void read_binary_rows(Input& input, const Pcd_header& header, const Layout& layout, Rows& rows)
{
  std::vector<char> row(layout.row_size);
  for(std::uint64_t i = 0; i < header.points; ++i) {
    input.read(row.data(), row.size());
    std::array<double, 3> p;
    for(std::size_t k = 0; k < 3; ++k)
      p[k] = to_double(row.data() + layout.offset[k], header.fields[layout.field[k]].type,
                       Byte_order::little);
    rows.add_point(p[0], p[1], p[2]);
  }
}

// The fields of all points one after the other, compressed together.
void read_compressed_rows(Input& input, const Pcd_header& header, const Layout& layout, Rows& rows)
{
  Numbers numbers(input, Byte_order::little);
  const std::size_t compressed_size = numbers.read<std::uint32_t>();
  const std::size_t size = numbers.read<std::uint32_t>();
  // x, y and z have bytes. NOLINTNEXTLINE(clang-analyzer-core.DivideZero)
  if(header.points > size / layout.row_size || header.points * layout.row_size != size)
    throw Bad_file("its header announces " + std::to_string(header.points) +
                   " points, and its data have another size");
  if(size / lzf_greatest_ratio > compressed_size)
    throw Ends_early();
  std::string compressed;
  while(compressed.size() < compressed_size) { // as much memory as there are bytes
    const std::string_view part = input.peek(1 << 16);
    if(part.empty())
      throw Ends_early();
    const std::string_view wanted = part.substr(0, compressed_size - compressed.size());
    compressed += wanted;
    input.skip(wanted.size());
  }
  const std::string bytes = lzf_decompressed(compressed, size);
  std::array<double, 3> p;
  for(std::size_t i = 0; i < header.points; ++i) {
    for(std::size_t k = 0; k < 3; ++k) {
      const Field& field = header.fields[layout.field[k]];
      p[k] = to_double(bytes.data() + layout.offset[k] * header.points + i * field.bytes_of_number,
                       field.type, Byte_order::little);
    }
    rows.add_point(p[0], p[1], p[2]);
  }
}

} // namespace

void read_pcd(Input& input, Rows& rows)
{
  const Pcd_header header = read_header(input);
  const Layout layout(header.fields);
  if(header.data == "ascii")
    read_text_rows(input, header, layout, rows);
  else if(header.data == "binary")
    read_binary_rows(input, header, layout, rows);
  else if(header.data == "binary_compressed")
    read_compressed_rows(input, header, layout, rows);
  else
    not_understood(input);
}

} // namespace point_files
