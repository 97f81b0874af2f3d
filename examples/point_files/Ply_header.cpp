// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Ply_header.h"

#include "numbers.h"

#include <array>
#include <string_view>
#include <utility>

namespace point_files {

namespace {

using Words = std::vector<std::string_view>;

[[noreturn]] void not_understood(const Input& input)
{
  throw Bad_file(input.line() + " is not understood");
}

Number_type type_of(const Input& input, std::string_view name)
{
  using Name = std::pair<std::string_view, Number_type>;
  constexpr std::array<Name, 18> names{{{"char", Number_type::int8},
                                        {"int8", Number_type::int8},
                                        {"uchar", Number_type::uint8},
                                        {"uint8", Number_type::uint8},
                                        {"short", Number_type::int16},
                                        {"int16", Number_type::int16},
                                        {"ushort", Number_type::uint16},
                                        {"uint16", Number_type::uint16},
                                        {"int", Number_type::int32},
                                        {"int32", Number_type::int32},
                                        {"uint", Number_type::uint32},
                                        {"uint32", Number_type::uint32},
                                        {"int64", Number_type::int64},
                                        {"uint64", Number_type::uint64},
                                        {"float", Number_type::float32},
                                        {"float32", Number_type::float32},
                                        {"double", Number_type::float64},
                                        {"float64", Number_type::float64}}};
  for(const auto& [known, type] : names)
    if(name == known)
      return type;
  not_understood(input);
}

Ply_property property_of(const Input& input, const Words& words)
{
  Ply_property property;
  const bool is_list = words.size() >= 5 && words[1] == "list";
  if(!is_list && words.size() < 3)
    not_understood(input);
  if(is_list) {
    property.type_of_size = type_of(input, words[2]);
    if(!is_integer(*property.type_of_size))
      not_understood(input);
  }
  property.type = type_of(input, words[is_list ? 3 : 1]);
  property.name = words[is_list ? 4 : 2];
  return property;
}

void read_format(const Input& input, const Words& words, Ply_header& header)
{
  const std::string_view format = words.size() < 2 ? std::string_view() : words[1];
  header.is_text = format == "ascii";
  header.byte_order = format == "binary_big_endian" ? Byte_order::big : Byte_order::little;
  if(!header.is_text && format != "binary_little_endian" && format != "binary_big_endian")
    not_understood(input);
}

} // namespace

Ply_header read_ply_header(Input& input)
{
  Ply_header header;
  bool has_format = false;
  Words words;
  for(std::string_view line; input.next_line(line);) {
    split(line, words);
    const std::string_view keyword = words.empty() ? std::string_view() : words[0];
    if(input.line_number() == 1) {
      if(keyword != "ply")
        not_understood(input);
    }
    else if(keyword == "format") {
      read_format(input, words, header);
      has_format = true;
    }
    else if(keyword == "element") {
      Ply_element element;
      if(words.size() < 3 || !to_integer(words[2], element.size))
        not_understood(input);
      element.name = words[1];
      header.elements.push_back(std::move(element));
    }
    else if(keyword == "property" && !header.elements.empty())
      header.elements.back().properties.push_back(property_of(input, words));
    else if(keyword == "end_header") {
      if(!has_format)
        throw Bad_file("its header does not say in which format it is");
      return header;
    }
    else if(keyword != "comment" && keyword != "obj_info" && !keyword.empty())
      not_understood(input);
  }
  throw Ends_early();
}

} // namespace point_files
