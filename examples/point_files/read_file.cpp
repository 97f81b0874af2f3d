// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "read_file.h"

#include "Format.h"

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <new>
#include <stdexcept>
#include <system_error>

namespace point_files {

namespace {

[[noreturn]] void fail(const std::string& name, const std::string& why)
{
  throw std::runtime_error("cannot read " + (name == "-" ? "standard input" : "'" + name + "'") +
                           ": " + why);
}

const Format& format_of(Input& input, const std::string& name, const Reading_options& options)
{
  if(!options.format.empty()) {
    const Format* const format = find_format(options.format);
    if(!format)
      fail(name, "'" + options.format + "' is no format; there are " + names_of_formats());
    return *format;
  }
  const std::string extension = extension_of(name);
  const Format* const by_name = find_format(extension);
  if(!by_name && name != "-")
    fail(name, "its extension is not one of " + names_of_formats() + "; or give --format");
  const Format* const by_content = format_of_content(input);
  if(!by_name && !by_content)
    fail(name, "give --format, one of " + names_of_formats());
  if(by_name && by_content && by_content->read != by_name->read)
    fail(name, "by its content it is a ." + std::string(by_content->extension) +
                   " file, rename it or give --format");
  return by_name ? *by_name : *by_content;
}

bool is_file(const std::string& filename)
{
  std::error_code ignored;
  return std::filesystem::is_regular_file(filename, ignored);
}

// Formats that are kept in memory while they are read.
void check_bounded_memory(Input& input, const Format& format, const std::string& name)
{
  const bool is_compressed = format.extension == "pcd" &&
                             input.peek(4096).find("binary_compressed") != std::string_view::npos;
  if(is_compressed || format.extension == "stl")
    fail(name, std::string(is_compressed ? "a compressed .pcd" : "an .stl") +
                   " file cannot be streamed; convert it to .ply");
}

} // namespace

void read_bytes(Input& input, const std::string& name, const Reading_options& options, Rows& rows)
{
  if(options.progress)
    input.report_to(options.progress);
  if(input.peek(1).empty())
    fail(name, "there are no points in it: it is empty");
  const Format& format = format_of(input, name, options);
  if(options.in_bounded_memory)
    check_bounded_memory(input, format, name);
  try {
    format.read(input, rows);
    rows.finish();
  } catch(const Bad_file& error) {
    fail(name, error.what());
  } catch(const Ends_early&) {
    const std::string location = input.location();
    fail(name, location.empty() ? "it breaks off or is damaged after " +
                                      std::to_string(rows.number_of_rows()) + " points"
                                : input.line() + " is the last, but more is expected");
  } catch(const std::invalid_argument& error) {
    fail(name, input.location() + error.what());
  } catch(const std::bad_alloc&) {
    fail(name, "not enough memory after " + std::to_string(rows.number_of_rows()) +
                   " points; try --stream");
  }
  if(rows.number_of_points() == 0)
    fail(name, "there are no points in it" +
                   (rows.number_of_skipped() == 0
                        ? std::string()
                        : "; " + std::to_string(rows.number_of_skipped()) + " rows are invalid"));
}

void read_file(const std::string& filename, const Reading_options& options, Rows& rows)
{
  if(filename == "-") {
    Input input(*std::cin.rdbuf());
    read_bytes(input, filename, options, rows);
    return;
  }
  std::error_code ignored;
  if(std::filesystem::is_directory(filename, ignored))
    fail(filename, "it is a folder");
  std::filebuf file;
  if(!file.open(filename, std::ios::in | std::ios::binary))
    fail(filename,
         std::filesystem::exists(filename, ignored) ? "no permission" : "there is no such file");
  const std::uintmax_t size =
      is_file(filename) ? std::filesystem::file_size(filename, ignored) : Input::unknown;
  Input input(file, size);
  read_bytes(input, filename, options, rows);
}

bool can_be_read_twice(const std::string& filename)
{
  std::error_code ignored;
  return filename != "-" && (is_file(filename) || !std::filesystem::exists(filename, ignored));
}

} // namespace point_files
