// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H

#include "Quality_options.h"
#include "Summary.h"
#include "jobs.h"

#include <functional>
#include <iostream>
#include <string>
#include <vector>

/// Prints the rows of all jobs as they come, then the groups and the misses.
///
/// \param work a function of the number of a job that returns its rows
/// \param keys what to group the rows by
template <typename Work>
void report(const Quality_options& options, std::size_t jobs, const Work& work,
            const std::vector<columns::Column>& columns,
            const std::vector<std::function<std::string(const Row&)>>& keys)
{
  Table<Row> table(std::cout, columns, options.csv);
  std::vector<Row> rows;
  run_jobs(jobs, options.threads, work, [&](const std::vector<Row>& more) {
    for(const Row& row : more) {
      table.add(row);
      rows.push_back(row);
    }
  });
  write_summary(std::cout, rows, keys);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_REPORT_H
