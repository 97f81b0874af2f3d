// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_FILL_PAGE_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_FILL_PAGE_H

#include <boost/algorithm/string/replace.hpp>

#include <cstddef>
#include <ostream>
#include <string>

/// The text of an object of `nlohmann` inside a script element, which must not contain its end.
template <typename Json>
std::string embedded(const Json& json)
{
  const bool ascii = true; // a file's name may be in any encoding
  return boost::replace_all_copy(json.dump(-1, ' ', ascii, Json::error_handler_t::replace), "<",
                                 "\\u003c");
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

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_FILL_PAGE_H
