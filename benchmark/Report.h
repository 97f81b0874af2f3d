// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H

#include "Quality_options.h"
#include "Summary.h"
#include "jobs.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

/// What a command prints.
struct Layout
{
  std::vector<columns::Column> table;
  std::vector<columns::Group_column> summary;
  std::vector<std::function<std::string(const Row&)>> keys; ///< to group the rows by
};

/// Prints the groups of a finished table, all rows, and the misses.
inline void print_summary(const std::vector<Row>& rows, const Layout& layout)
{
  const auto print_groups = [&](const auto& key) {
    std::cout << '\n';
    Table<Group> table(std::cout, layout.summary);
    for(const Group& group : group_by(rows, key))
      table.add(group);
  };
  for(const auto& key : layout.keys)
    print_groups(key);
  print_groups([](const Row&) { return "all"; });
  write_misses(std::cout, rows);
}

/// Prints the rows of all jobs as they come, then the summary.
/// \param work a function of the number of a job that returns its rows
template <typename Work>
void report(const Quality_options& options, std::size_t jobs, const Work& work,
            const Layout& layout)
{
  Table<Row> table(std::cout, layout.table, options.csv);
  std::vector<Row> rows;
  run_jobs(jobs, options.threads, work, [&](const std::vector<Row>& more) {
    for(const Row& row : more) {
      table.add(row);
      rows.push_back(row);
    }
  });
  print_summary(rows, layout);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H
