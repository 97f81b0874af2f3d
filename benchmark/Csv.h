// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_CSV_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_CSV_H

#include <cstddef>
#include <fstream>
#include <iomanip>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

/// A CSV file, each line written as soon as it is there.
class Csv
{
public:
  /// \throw std::runtime_error
  explicit Csv(const std::string& file)
      : file_(file)
      , out_(file_)
  {
    if(!file_)
      throw std::runtime_error("cannot write '" + file + "'");
  }

  explicit Csv(std::ostream& out)
      : out_(out)
  {}

  Csv(const Csv&) = delete;
  Csv& operator=(const Csv&) = delete;

  void write(const std::vector<std::string>& cells)
  {
    for(std::size_t i = 0; i < cells.size(); ++i) {
      out_ << (i > 0 ? "," : "");
      if(cells[i].find_first_of(",\"\n") == std::string::npos)
        out_ << cells[i];
      else
        out_ << std::quoted(cells[i], '"', '"');
    }
    out_ << std::endl;
  }

private:
  std::ofstream file_; ///< not open if it is another stream
  std::ostream& out_;
};

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_CSV_H
