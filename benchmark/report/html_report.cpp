// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_report.h"

#include "fill_page.h"
#include "results_json.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <sstream>
#include <stdexcept>

namespace {

std::string read_file(const std::filesystem::path& file)
{
  std::ifstream in(file, std::ios::binary);
  if(!in)
    throw std::runtime_error("cannot read '" + file.string() + "'");
  return {std::istreambuf_iterator<char>(in), {}};
}

/// The page and all that goes into it, by name. The build says where they are.
std::map<std::string, std::filesystem::path> page_files()
{
  std::map<std::string, std::filesystem::path> result;
  std::istringstream list(REPORT_FILES);
  for(std::string file; std::getline(list, file, '|');)
    result[std::filesystem::path(file).filename().string()] = file;
  return result;
}

} // namespace

void write_html_report(const std::string& file, const std::vector<Compared>& rows)
{
  const auto files = page_files();
  const std::string results = embedded(results_json(rows));
  std::ofstream out(file, std::ios::binary);
  write_filled(out, read_file(files.at("page.html")), [&](const std::string& name) {
    return name == "results.json" ? results : read_file(files.at(name));
  });
  if(!out.flush())
    throw std::runtime_error("cannot write '" + file + "'");
}
