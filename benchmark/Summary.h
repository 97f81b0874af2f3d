// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H

#include "Row.h"
#include "statistics.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <ostream>
#include <string>
#include <vector>

/// What a row says about itself.
using Is_exact = std::optional<bool> (Row::*)() const;

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

  /// In per cent of the rows of which it is known.
  double share(Is_exact is_exact) const
  {
    std::vector<double> known;
    for(const Row& row : rows)
      if((row.*is_exact)())
        known.push_back(*(row.*is_exact)() ? 100 : 0);
    return mean_of(known);
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

inline Group_column group_name()
{
  return {"group", 20, [](const Group& group) { return group.name; }};
}

inline Group_column group_method()
{
  return {"method", 9, [](const Group& group) { return group.method; }};
}

inline Group_column group_size()
{
  return {"clouds", 6, [](const Group& group) { return std::to_string(group.rows.size()); }};
}

inline Group_column share(const std::string& name, Is_exact is_exact)
{
  return {name, 5, [is_exact](const Group& group) { return fixed(group.share(is_exact), 1); }};
}

inline Group_column mean(const std::string& name, double Row::*member, int digits)
{
  return {name, 5,
          [=](const Group& group) { return fixed(mean_of(group.values(member)), digits); }};
}

inline Group_column median(const std::string& name, double Row::*member, int digits)
{
  return {name, 5,
          [=](const Group& group) { return fixed(median_of(group.values(member)), digits); }};
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

/// "ends 5 of 4" if that is wrong.
inline std::string difference(const std::string& what, std::size_t got,
                              const std::optional<std::size_t>& wanted)
{
  if(!wanted || got == *wanted)
    return "";
  return ", " + what + ' ' + std::to_string(got) + " of " + std::to_string(*wanted);
}

/// The rows that are not exact, one a line, and why.
inline void write_misses(std::ostream& out, const std::vector<Row>& rows)
{
  out << "\nmisses\n";
  for(const Row& row : rows) {
    if(row.exact().value_or(true))
      continue;
    for(const std::string& part : {row.shape, row.seed, row.size, row.places, row.variant})
      out << part << (part.empty() ? "" : " ");
    out << row.method << (row.status == "ok" ? "" : ", " + row.status)
        << difference("components", row.got.components, row.truth.components)
        << difference("cycles", row.got.cycles, row.truth.cycles)
        << difference("ends", row.got.ends, row.truth.ends)
        << difference("junctions", row.got.junctions, row.truth.junctions) << '\n';
  }
  out << std::flush;
}

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_SUMMARY_H
