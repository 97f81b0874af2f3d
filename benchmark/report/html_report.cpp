// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "html_report.h"

#include "results_json.h"

#include <boost/algorithm/string/replace.hpp>
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

/// As text inside a script element, which must not contain its end.
std::string embedded(const nlohmann::json& json)
{
  const bool ascii = true; // a file's name may be in any encoding
  return boost::replace_all_copy(
      json.dump(-1, ' ', ascii, nlohmann::json::error_handler_t::replace), "<", "\\u003c");
}

/// Writes the page with a text in place of every {{name}}.
template <typename Text_of>
void write_filled(std::ostream& out, const std::string& page, const Text_of& text_of)
{
  const std::string open = "{{", close = "}}";
  std::size_t end = 0;
  for(std::size_t begin; (begin = page.find(open, end)) != std::string::npos;) {
    out << page.substr(end, begin - end);
    begin += open.size();
    end = page.find(close, begin);
    out << text_of(page.substr(begin, end - begin));
    end += close.size();
  }
  out << page.substr(end);
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
