// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_TABLE_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_TABLE_H

#include "Csv.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <iomanip>
#include <ios>
#include <optional>
#include <ostream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

/// With `digits` after the point; "-" if it is not finite.
inline std::string fixed(double number, int digits)
{
  if(!std::isfinite(number))
    return "-";
  std::ostringstream out;
  out << std::fixed << std::setprecision(digits) << number;
  return out.str();
}

/// A table of rows of any type, each written as soon as it is there: in aligned columns, the first
/// and the last to the left, and as CSV.
template <typename Row>
class Table
{
public:
  struct Column
  {
    std::string name;
    std::size_t width; ///< in characters, at least; that of the name if that is more
    std::function<std::string(const Row&)> cell;
  };

  /// Writes the head. \param csv a file; none if empty. \throw std::runtime_error
  Table(std::ostream& out, std::vector<Column> columns, const std::string& csv = "")
      : out_(out)
      , columns_(std::move(columns))
  {
    if(!csv.empty())
      csv_.emplace(csv);
    write([](const Column& column) { return column.name; });
  }

  void add(const Row& row)
  {
    write([&row](const Column& column) { return column.cell(row); });
  }

private:
  template <typename Cell_of>
  void write(const Cell_of& cell_of)
  {
    std::vector<std::string> cells;
    for(const Column& column : columns_)
      cells.push_back(cell_of(column));
    write_aligned(cells);
    if(csv_)
      csv_->write(cells);
  }

  void write_aligned(const std::vector<std::string>& cells)
  {
    for(std::size_t i = 0; i < cells.size(); ++i) {
      const bool first = i == 0, last = i + 1 == cells.size();
      const std::size_t width = std::max(columns_[i].width, columns_[i].name.size());
      out_ << (first ? "" : "  ") << (first || last ? std::left : std::right)
           << std::setw(last ? 0 : static_cast<int>(width)) << cells[i];
    }
    out_ << std::endl;
  }

  std::ostream& out_;
  std::optional<Csv> csv_;
  std::vector<Column> columns_;
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_TABLE_H
