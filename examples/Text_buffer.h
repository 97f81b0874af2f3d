// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_EXAMPLES_TEXT_BUFFER_H
#define POINT_SET_SKELETONIZATION_3_EXAMPLES_TEXT_BUFFER_H

#include <cstddef>
#include <istream>
#include <streambuf>
#include <string>

/// Hands a text file to a reader line by line, so that the line at which the reader gave up is
/// known. It also evens out what CGAL's readers trip over: lines that end in CR LF, and a last line
/// without an end.
class Text_buffer : public std::streambuf
{
public:
  explicit Text_buffer(std::istream& in) : in_(in) {}

  /// The line that was handed out last, from 1; 0 before the first.
  std::size_t line_number() const { return line_number_; }

protected:
  int_type underflow() override
  {
    if(!std::getline(in_, line_))
      return traits_type::eof();
    ++line_number_;
    if(!line_.empty() && line_.back() == '\r')
      line_.pop_back();
    line_ += '\n';
    setg(&line_.front(), &line_.front(), &line_.front() + line_.size());
    return traits_type::to_int_type(line_.front());
  }

private:
  std::istream& in_;
  std::string line_;
  std::size_t line_number_ = 0;
};

#endif // POINT_SET_SKELETONIZATION_3_EXAMPLES_TEXT_BUFFER_H
