// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H

#include "Row.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

/// The mean of the numbers that are one; NaN if there are none.
inline double mean_of(const std::vector<double>& numbers)
{
  double sum = 0, count = 0;
  for(const double number : numbers)
    if(!std::isnan(number)) {
      sum += number;
      ++count;
    }
  return sum / count;
}

/// Rows that have something in common.
struct Group
{
  std::string name;
  std::string method;
  std::vector<Row> rows;

  std::vector<double> values(double Row::*member) const
  {
    std::vector<double> result;
    for(const Row& row : rows)
      result.push_back(row.*member);
    return result;
  }

  double mean(double Row::*member) const { return mean_of(values(member)); }

  /// In per cent.
  double share(bool (Row::*is_exact)() const) const
  {
    const auto exact = std::count_if(rows.begin(), rows.end(),
                                     [is_exact](const Row& row) { return (row.*is_exact)(); });
    return 100. * static_cast<double>(exact) / static_cast<double>(rows.size());
  }
};

/// Groups by method and by `key`, in the order of their first rows.
template <typename Key>
std::vector<Group> group_by(const std::vector<Row>& rows, const Key& key)
{
  std::vector<Group> groups;
  for(const Row& row : rows) {
    const std::string name = key(row);
    auto group = std::find_if(groups.begin(), groups.end(), [&](const Group& g) {
      return g.name == name && g.method == row.method;
    });
    if(group == groups.end())
      group = groups.insert(group, {name, row.method, {}});
    group->rows.push_back(row);
  }
  return groups;
}

namespace columns {

using Group_column = Table<Group>::Column;

inline Group_column share(const std::string& name, bool (Row::*is_exact)() const)
{
  return {name, 5, [is_exact](const Group& group) { return fixed(group.share(is_exact), 1); }};
}

inline Group_column mean(const std::string& name, double Row::*member, int digits)
{
  return {name, 5, [=](const Group& group) { return fixed(group.mean(member), digits); }};
}

/// How many skeletons leave the shape somewhere.
inline Group_column outside()
{
  return {"outside", 5, [](const Group& group) {
            const auto leaves = [](const Row& row) { return row.inside < 1; };
            return std::to_string(std::count_if(group.rows.begin(), group.rows.end(), leaves));
          }};
}

inline Group_column total_spurs()
{
  return {"spurs", 5, [](const Group& group) {
            std::size_t spurs = 0;
            for(const Row& row : group.rows)
              spurs += row.spurs;
            return std::to_string(spurs);
          }};
}

} // namespace columns

/// One line per group: shares of exact skeletons in per cent, and means of all else.
inline void write_groups(std::ostream& out, const std::vector<Group>& groups)
{
  using namespace columns;
  Table<Group> table(out,
                     {{"mean of", 20, [](const Group& group) { return group.name; }},
                      {"method", 9, [](const Group& group) { return group.method; }},
                      {"clouds", 6, [](const Group& g) { return std::to_string(g.rows.size()); }},
                      share("exact%", &Row::exact),
                      share("comp%", &Row::components_exact),
                      share("cycles%", &Row::cycles_exact),
                      share("ends%", &Row::ends_exact),
                      mean("axis", &Row::axis_mean, 3),
                      mean("axis_max", &Row::axis_maximum, 2),
                      mean("off_centre", &Row::off_centre, 3),
                      mean("inside", &Row::inside, 4),
                      outside(),
                      total_spurs(),
                      mean("unexplained", &Row::unexplained, 4),
                      mean("moved", &Row::moved_mean, 4),
                      mean("moved_max", &Row::moved_maximum, 4),
                      mean("seconds", &Row::seconds, 2)});
  for(const Group& group : groups)
    table.add(group);
}

/// "ends 5 of 4" if that is wrong.
inline std::string difference(const std::string& what, std::size_t got,
                              const std::optional<std::size_t>& wanted)
{
  if(!wanted || got == *wanted)
    return "";
  return ", " + what + ' ' + std::to_string(got) + " of " + std::to_string(*wanted);
}

inline void write_misses(std::ostream& out, const std::vector<Row>& rows)
{
  out << "\nmisses\n";
  for(const Row& row : rows)
    if(!row.exact())
      out << row.shape << ' ' << row.seed << ' ' << row.variant << ' ' << row.method
          << (row.status == "ok" ? "" : ", " + row.status)
          << difference("components", row.got.components, row.truth.components)
          << difference("cycles", row.got.cycles, row.truth.cycles)
          << difference("ends", row.got.ends, row.truth.ends) << '\n';
  out << std::flush;
}

/// Groups and misses of a finished table. \param keys what to group by, apart from everything
inline void write_summary(std::ostream& out, const std::vector<Row>& rows,
                          const std::vector<std::function<std::string(const Row&)>>& keys)
{
  for(const auto& key : keys) {
    out << '\n';
    write_groups(out, group_by(rows, key));
  }
  out << '\n';
  write_groups(out, group_by(rows, [](const Row&) { return "all"; }));
  write_misses(out, rows);
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H
