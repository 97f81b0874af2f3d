// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "ratios.h"

#include "Table.h"
#include "methods/Method.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>

namespace {

using Rows = std::vector<Performance_row>;

constexpr double mebibyte = 1 << 20;

struct Ratio
{
  std::string input;
  std::size_t points;
  std::string what;
  double value; ///< not a number if a part of it was not measured
  double asked;
  bool at_most; ///< else at least
};

/// The row of this method; one without measurements if there is none.
Performance_row find(const Rows& rows, const Performance_row& like, const std::string& method,
                     std::size_t threads = 1)
{
  for(const Performance_row& row : rows)
    if(row.input == like.input && row.points == like.points && row.method == method &&
       row.threads == threads)
      return row;
  return {};
}

/// This package with one thread, on every input.
Rows our_rows(const Rows& rows)
{
  Rows result;
  for(const Performance_row& row : rows)
    if(row.method == method_names::ours && row.threads == 1)
      result.push_back(row);
  return result;
}

/// Of the seconds of one to those of the other, in the median over the runs: those of the same
/// round find the machine in the same state.
double median_ratio(const std::vector<double>& one, const std::vector<double>& other)
{
  std::vector<double> ratios;
  for(std::size_t run = 0; run < std::min(one.size(), other.size()); ++run)
    ratios.push_back(one[run] / other[run]);
  return ratios.empty() ? not_measured : median_of(ratios);
}

/// What is asked for at this number of points.
std::vector<Ratio> ratios_of(const Rows& rows, const Performance_row& ours)
{
  const bool is_model = ours.points < 100000, is_million = ours.points == 1000000;
  const bool is_huge = ours.points >= 10000000;
  const auto rival = [&](const std::string& method, const std::string& stage) {
    return median_ratio(ours.of_runs("total", &Stage_seconds::cpu),
                        find(rows, ours, method).of_runs(stage, &Stage_seconds::cpu));
  };
  std::vector<Ratio> result;
  const auto add = [&](const std::string& what, double value, double asked, bool at_most) {
    result.push_back({ours.input, ours.points, what, value, asked, at_most});
  };
  if(is_model) {
    add("time / (alpha wrap + MCF)", rival(method_names::wrap_and_flow, "total"), 1. / 18,
        true);
    add("time / MCF of the mesh", rival(method_names::flow, "total"), 1. / 4, true);
  }
  if(is_million)
    add("time / queries of 16 neighbours", rival(method_names::neighbors, "queries"), 0.15, true);
  if(is_model || is_million)
    add("one thread / two threads",
        median_ratio(ours.of_runs("total", &Stage_seconds::wall),
                     find(rows, ours, method_names::ours, 2)
                       .of_runs("total", &Stage_seconds::wall)),
        1.7, false);
  if(is_huge) {
    const double input = static_cast<double>(ours.points * sizeof(Point)) / mebibyte;
    add("memory beyond input / input", ours.measured.extra_memory / input, 0.25, true);
    add("the same without indices",
        find(rows, ours, method_names::bare).measured.extra_memory / input, 0.25, true);
    add("peak memory of stream, MiB",
        find(rows, ours, method_names::streamed).measured.peak_memory, 200, true);
  }
  return result;
}

std::vector<Ratio> growth(const Rows& ours)
{
  std::vector<Ratio> result;
  for(const Performance_row& small : ours)
    for(const Performance_row& large : ours)
      if(large.input == small.input && small.points >= 1000000 &&
         large.points == 10 * small.points)
        result.push_back({large.input, large.points, "time / time of a tenth of the points",
                          large.cpu("total") / small.cpu("total"), 12, true});
  return result;
}

std::string met(const Ratio& ratio)
{
  if(std::isnan(ratio.value))
    return "-";
  return (ratio.at_most ? ratio.value <= ratio.asked : ratio.value >= ratio.asked) ? "yes" : "NO";
}

} // namespace

void print_ratios(std::ostream& out, const Rows& rows)
{
  Table<Ratio> table(
      out, {{"input", 12, [](const Ratio& r) { return r.input; }},
            {"points", 9, [](const Ratio& r) { return std::to_string(r.points); }},
            {"ratio", 38, [](const Ratio& r) { return r.what; }},
            {"value", 8, [](const Ratio& r) { return fixed(r.value, 3); }},
            {"asked", 9,
             [](const Ratio& r) { return (r.at_most ? "<= " : ">= ") + fixed(r.asked, 3); }},
            {"met", 3, met}});
  const Rows ours = our_rows(rows);
  for(const Performance_row& row : ours)
    for(const Ratio& ratio : ratios_of(rows, row))
      table.add(ratio);
  for(const Ratio& ratio : growth(ours))
    table.add(ratio);
}

void print_shares(std::ostream& out, const Rows& rows)
{
  const auto share = [](const std::string& stage) {
    return [stage](const Performance_row& row) {
      return fixed(100 * row.cpu(stage) / row.cpu("total"), 1);
    };
  };
  std::vector<Table<Performance_row>::Column> columns = {
      {"input", 12, [](const Performance_row& row) { return row.input; }},
      {"points", 9, [](const Performance_row& row) { return std::to_string(row.points); }},
      {"seconds", 8, [](const Performance_row& row) { return fixed(row.cpu("total"), 3); }}};
  for(const char* stage : {"mixture", "projection", "linking", "skeleton"})
    columns.push_back({stage + std::string("%"), 6, share(stage)});
  Table<Performance_row> table(out, columns);
  for(const Performance_row& row : our_rows(rows))
    table.add(row);
}

void print_quietness(std::ostream& out, const Rows& rows)
{
  std::vector<double> shares;
  for(const Performance_row& row : rows)
    if(row.threads == 1)
      shares.push_back(row.cpu("total") / row.wall("total"));
  const double share = median_of(shares);
  out << "runs of one thread had " << fixed(100 * share, 0) << " % of a core (median)"
      << (share < 0.95 ? ": the machine was not quiet" : "") << '\n';
}
