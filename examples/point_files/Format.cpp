// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Format.h"

#include "formats.h"
#include "numbers.h"

#include <array>
#include <cctype>
#include <filesystem>

namespace point_files {

namespace {

constexpr std::array<Format, 13> formats{{{"off", read_off},
                                          {"ply", read_ply},
                                          {"xyz", read_text},
                                          {"txt", read_text},
                                          {"csv", read_text},
                                          {"pts", read_text},
                                          {"asc", read_text},
                                          {"pwn", read_text},
                                          {"pcd", read_pcd},
                                          {"las", read_las},
                                          {"obj", read_obj},
                                          {"stl", read_stl},
                                          {"laz", read_las}}}; // to say what to do with it

std::string in_lower_case(std::string_view text)
{
  std::string result(text);
  for(char& c : result)
    c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

} // namespace

const Format* find_format(std::string_view extension)
{
  if(!extension.empty() && extension.front() == '.')
    extension.remove_prefix(1);
  const std::string wanted = in_lower_case(extension);
  for(const Format& format : formats)
    if(format.extension == wanted)
      return &format;
  return nullptr;
}

const Format* format_of_content(Input& input)
{
  const std::string_view begin = input.peek(256);
  const std::string_view first = begin.substr(0, begin.find_first_of(" \t\r\n"));
  if(first == "ply")
    return find_format("ply");
  if(begin.substr(0, 4) == "LASF")
    return find_format("las");
  if(first.size() >= 3 && first.size() <= 8 && first.substr(first.size() - 3) == "OFF")
    return find_format("off");
  if(begin.substr(0, 6) == "# .PCD" || begin.substr(0, 8) == "VERSION ")
    return find_format("pcd");
  return nullptr;
}

std::string names_of_formats()
{
  std::string result;
  for(const Format& format : formats)
    if(format.extension != "laz")
      result += (result.empty() ? "." : ", .") + std::string(format.extension);
  return result;
}

std::string extension_of(const std::string& filename)
{
  const std::string extension = std::filesystem::path(filename).extension().string();
  return in_lower_case(extension.empty() ? extension : extension.substr(1));
}

} // namespace point_files
