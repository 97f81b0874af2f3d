// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "formats.h"
#include "numbers.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace point_files {

namespace {

using Fields = std::vector<std::string_view>;

bool is_comment(std::string_view line)
{
  return line.empty() || line.front() == '#' || line.substr(0, 2) == "//";
}

// Whether a column is called `axis`: "x", "X", "\"x\"", "x[m]", "X_m".
bool names_axis(std::string_view name, char axis)
{
  while(!name.empty() && (name.front() == '"' || name.front() == '\''))
    name.remove_prefix(1);
  const auto letter = [&name](std::size_t i) { return static_cast<unsigned char>(name[i]); };
  return !name.empty() && std::tolower(letter(0)) == axis &&
         (name.size() == 1 || std::isalnum(letter(1)) == 0);
}

// How the rows of a file are to be read, which its first rows tell.
class Row_format
{
public:
  // By the first line that is no comment.
  explicit Row_format(std::string_view line)
      : separator_(line.find(';') != std::string_view::npos   ? ';'
                   : line.find(',') != std::string_view::npos ? ','
                                                              : ' ')
  {}

  void split(std::string_view line, Fields& fields) const
  {
    if(separator_ == ' ')
      point_files::split(line, fields);
    else
      point_files::split(line, separator_, fields);
  }

  // Whether the line says which columns x, y and z are.
  bool take_header(const Fields& fields)
  {
    std::array<std::size_t, 3> column;
    for(std::size_t k = 0; k < 3; ++k) {
      const char axis = static_cast<char>('x' + static_cast<int>(k));
      const auto found = std::find_if(fields.begin(), fields.end(), [axis](std::string_view name) {
        return names_axis(name, axis);
      });
      if(found == fields.end())
        return false;
      column[k] = static_cast<std::size_t>(found - fields.begin());
    }
    column_ = column;
    size_ = fields.size();
    return true;
  }

  // Whether the fields are a row; the header or the first row tells how many there are.
  bool take_row(const Fields& fields, std::array<double, 3>& point)
  {
    if(size_ != 0 ? fields.size() != size_ : fields.size() < 3)
      return false;
    for(std::size_t k = 0; k < 3; ++k)
      if(!to_number(fields[column_[k]], point[k]) &&
         !(separator_ == ';' && to_number(with_point(fields[column_[k]]), point[k])))
        return false;
    size_ = fields.size();
    return true;
  }

private:
  // Where semicolons separate, commas may be decimal.
  static std::string with_point(std::string_view number)
  {
    std::string result(number);
    std::replace(result.begin(), result.end(), ',', '.');
    return result;
  }

  char separator_;
  std::array<std::size_t, 3> column_{{0, 1, 2}};
  std::size_t size_ = 0; // of a row; 0: not known yet
};

// `model` is the number of the line, a header or a row, that tells how many columns there are; 0 if
// there was none yet.
std::string complaint(const Input& input, std::size_t model)
{
  return input.line() + " is neither " +
         (model == 0
              ? std::string("a row of at least three numbers nor a header that names x, y and z")
              : "a comment nor a row with as many columns as line " + std::to_string(model)) +
         "; --skip-invalid leaves such lines out";
}

} // namespace

void read_text(Input& input, Rows& rows)
{
  std::string_view line;
  const auto next = [&] {
    while(input.next_line(line)) {
      line = trimmed(line);
      if(!is_comment(line))
        return true;
    }
    return false;
  };
  if(!next())
    return;
  Row_format format(line);
  Fields fields;
  std::array<double, 3> point;
  std::size_t model = 0; // line that tells how many columns there are
  std::uint64_t announced = 0; // .pts: every scan begins with the number of its points
  const auto take = [&] {
    format.split(line, fields);
    std::uint64_t count = 0;
    if(rows.number_of_rows() == announced && fields.size() == 1 && to_integer(line, count)) {
      announced = count > Input::unknown - announced ? Input::unknown : announced + count;
      if(model == 0 && next()) { // may be separated otherwise
        format = Row_format(line);
        format.split(line, fields);
      }
      else
        return;
    }
    if(format.take_row(fields, point)) {
      rows.add_point(point[0], point[1], point[2]);
      if(model == 0)
        model = input.line_number();
    }
    else if(model == 0 && format.take_header(fields))
      model = input.line_number();
    else
      rows.add_invalid(complaint(input, model));
  };
  do
    take();
  while(next());
  if(rows.number_of_rows() < announced)
    throw Ends_early();
}

} // namespace point_files
