// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_ROW_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_ROW_H

#include "Measurements.h"
#include "Table.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// One skeleton and how good it is.
struct Row : Measurements
{
  std::string shape;   ///< family, model or file
  std::string seed;    ///< of the family
  std::string variant; ///< of the cloud
  std::string method;
  std::size_t points = 0;
  double thinnest = not_measured;    ///< radius of a limb, in distances between points
  std::string size;                  ///< number of points that a scan should have
  std::string places;                ///< of the scanner
  std::optional<std::size_t> seen_ends; ///< true ends that have points near them
  std::optional<std::size_t> trunk;     ///< of three heights, those with one curve in the trunk
  double trunk_off = not_measured;      ///< radii of the trunk
  double found = not_measured;       ///< share of the true skeleton that has points near it
  double true_share = not_measured;  ///< of our skeleton
  double centred = not_measured;     ///< share of our skeleton near the true axis
  double unsupported = not_measured; ///< share of our skeleton in empty space
  double radius = not_measured;      ///< factor by which radii are wrong, at least 1
  double axis_mean = not_measured, axis_maximum = not_measured; ///< local radii
  double seconds = not_measured;
  std::string status = "ok"; ///< or what went wrong

  /// Nothing if the truth is not known; false if something went wrong.
  std::optional<bool> components_exact() const
  {
    return is_exact(got.components, truth.components);
  }
  std::optional<bool> cycles_exact() const { return is_exact(got.cycles, truth.cycles); }
  std::optional<bool> ends_exact() const { return is_exact(got.ends, truth.ends); }
  std::optional<bool> junctions_exact() const { return is_exact(got.junctions, truth.junctions); }

  /// Whether there are as many ends as can be seen, but for 15 %.
  std::optional<bool> ends_close() const
  {
    constexpr double tolerance = 0.15;
    if(!seen_ends || status != "ok")
      return is_exact(got.ends, seen_ends);
    const auto ours = static_cast<double>(got.ends), seen = static_cast<double>(*seen_ends);
    return std::abs(ours - seen) <= tolerance * seen;
  }
  std::optional<bool> trunk_exact() const
  {
    return trunk ? is_exact(*trunk, 3) : std::nullopt;
  }

  /// Whether all that is known is right.
  std::optional<bool> exact() const
  {
    std::optional<bool> result;
    for(const std::optional<bool>& part :
        {components_exact(), cycles_exact(), ends_exact(), junctions_exact()})
      if(part)
        result = *part && result.value_or(true);
    return result;
  }

private:
  std::optional<bool> is_exact(std::size_t value, const std::optional<std::size_t>& wanted) const
  {
    if(status != "ok")
      return false;
    return wanted ? std::optional<bool>(value == *wanted) : std::nullopt;
  }
};

/// The columns that a table of rows may have.
namespace columns {

using Column = Table<Row>::Column;

inline Column text(const std::string& name, std::size_t width, std::string Row::*member)
{
  return {name, width, [member](const Row& row) { return row.*member; }};
}

inline Column number(const std::string& name, double Row::*member, int digits)
{
  return {name, 5, [member, digits](const Row& row) { return fixed(row.*member, digits); }};
}

inline Column count(const std::string& name, std::size_t Graph_counts::*member)
{
  return {name, 4, [member](const Row& row) { return std::to_string(row.got.*member); }};
}

/// "-" if it is not known.
inline std::string if_known(const std::optional<std::size_t>& value)
{
  return value ? std::to_string(*value) : "-";
}

inline Column truth(const std::string& name, std::optional<std::size_t> Truth::*member)
{
  return {name, 4, [member](const Row& row) { return if_known(row.truth.*member); }};
}

inline Column known(const std::string& name, std::optional<std::size_t> Row::*member)
{
  return {name, 4, [member](const Row& row) { return if_known(row.*member); }};
}

inline Column exact()
{
  return {"exact", 5,
          [](const Row& row) { return row.exact() ? *row.exact() ? "yes" : "NO" : "-"; }};
}

inline Column points()
{
  return {"points", 7, [](const Row& row) { return std::to_string(row.points); }};
}

inline Column spurs()
{
  return {"spurs", 5, [](const Row& row) { return std::to_string(row.spurs); }};
}

} // namespace columns

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_ROW_H
