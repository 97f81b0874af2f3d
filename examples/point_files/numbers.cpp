// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "numbers.h"

#include <cstdlib>
#include <limits>
#include <locale>
#include <sstream>
#include <string>

namespace point_files {

namespace {

bool is_space(char c)
{
  return c == ' ' || (c >= '\t' && c <= '\r');
}

// For what std::from_chars does not give: a number too large, which counts as infinite, or too
// small, which counts as 0; and all numbers where the library has no std::from_chars for them.
bool to_number_by_stream(std::string_view text, double& number)
{
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  stream >> number;
  if(stream.fail() && (number == (std::numeric_limits<double>::max)() ||
                       number == std::numeric_limits<double>::lowest()))
    number *= 2;
  else if(stream.fail())
    return false;
  return stream.eof();
}

} // namespace

bool to_number(std::string_view text, double& number)
{
  if(text.size() > 1 && text[0] == '+' && text[1] != '-')
    text.remove_prefix(1);
#if __cpp_lib_to_chars >= 201611L
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if(error != std::errc::result_out_of_range)
    return error == std::errc() && stop == end;
#endif
  return !text.empty() && to_number_by_stream(text, number);
}

std::string_view trimmed(std::string_view text)
{
  while(!text.empty() && is_space(text.front()))
    text.remove_prefix(1);
  while(!text.empty() && is_space(text.back()))
    text.remove_suffix(1);
  return text;
}

void split(std::string_view line, std::vector<std::string_view>& words)
{
  words.clear();
  for(std::size_t i = 0; i < line.size();) {
    while(i < line.size() && is_space(line[i]))
      ++i;
    const std::size_t first = i;
    while(i < line.size() && !is_space(line[i]))
      ++i;
    if(i > first)
      words.push_back(line.substr(first, i - first));
  }
}

void split(std::string_view line, char separator, std::vector<std::string_view>& fields)
{
  fields.clear();
  for(;;) {
    const std::size_t end = line.find(separator);
    fields.push_back(trimmed(line.substr(0, end)));
    if(end == std::string_view::npos)
      return;
    line.remove_prefix(end + 1);
  }
}

} // namespace point_files
