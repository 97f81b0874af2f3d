// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "lost_figures.h"

#include "../Table.h"
#include "../methods/registry.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace {

const std::string ours = "l1_medial";
constexpr double tolerance = 0.05;

using Rows = std::vector<const Compared*>;

struct Figure
{
  std::string name;
  double (*value)(const Measurements&);
  bool is_share; ///< and the larger, the better
};

double error_of(std::size_t number, const std::optional<std::size_t>& truth)
{
  return truth ? std::abs(static_cast<double>(number) - static_cast<double>(*truth)) : not_measured;
}

const std::vector<Figure>& figures()
{
  static const std::vector<Figure> list = {
      {"cycles", [](const Measurements& m) { return error_of(m.got.cycles, m.truth.cycles); },
       false},
      {"ends", [](const Measurements& m) { return error_of(m.got.ends, m.truth.ends); }, false},
      {"off_centre", [](const Measurements& m) { return m.off_centre; }, false},
      {"explained", [](const Measurements& m) { return 1 - m.unexplained; }, true},
      {"moved", [](const Measurements& m) { return m.moved_mean; }, false}};
  return list;
}

double value_of(const Compared& row, const Figure& figure)
{
  const double value = row.status == "ok" ? figure.value(row.measured) : not_measured;
  return std::isfinite(value) ? value : not_measured; // off-centre is infinite outside
}

bool takes_raw_points(const Compared& row)
{
  const std::vector<Registered_method>& all = registered_methods();
  return std::any_of(all.begin(), all.end(), [&row](const Registered_method& method) {
    return method.name == row.method && method.needs == Needs::points;
  });
}

bool is_better(const Figure& figure, double a, double b)
{
  return std::isnan(b) || (figure.is_share ? a > b : a < b);
}

bool is_close(const Figure& figure, double value, double best)
{
  return figure.is_share ? value >= (1 - tolerance) * best : value <= (1 + tolerance) * best;
}

/// \param rows of one input with one level of noise
void compare(const Figure& figure, const Rows& rows, Standing& standing)
{
  const Compared* best = nullptr;
  double best_value = not_measured, our_value = not_measured;
  for(const Compared* row : rows) {
    const double value = value_of(*row, figure);
    if(row->method == ours)
      our_value = value;
    if(!std::isnan(value) && is_better(figure, value, best_value)) {
      best = row;
      best_value = value;
    }
  }
  if(!best)
    return;
  ++standing.compared;
  if(!is_close(figure, our_value, best_value))
    standing.lost.push_back(
        {best->input, best->noise, best->seed, figure.name, our_value, best_value, best->method});
}

} // namespace

Standing standing_of(const std::vector<Compared>& rows)
{
  using Cloud = std::tuple<std::string, double, unsigned int>; // input, noise, seed
  std::map<Cloud, Rows> groups;
  std::vector<Cloud> order;
  for(const Compared& row : rows)
    if(takes_raw_points(row)) {
      Rows& group = groups[{row.input, row.noise, row.seed}];
      if(group.empty())
        order.emplace_back(row.input, row.noise, row.seed);
      group.push_back(&row);
    }
  Standing standing;
  for(const auto& key : order) {
    const Rows& group = groups[key];
    const auto is_ours = [](const Compared* row) { return row->method == ours; };
    if(group.size() > 1 && std::any_of(group.begin(), group.end(), is_ours))
      for(const Figure& figure : figures())
        compare(figure, group, standing);
  }
  return standing;
}

void print_standing(std::ostream& out, const Standing& standing)
{
  if(standing.compared == 0)
    return;
  out << "\nBehind the first method that takes raw points by more than 5 %:\n";
  Table<Lost_figure> table(
      out, {{"input", 20, [](const Lost_figure& lost) { return lost.input; }},
            {"noise", 5, [](const Lost_figure& lost) { return fixed(lost.noise, 3); }},
            {"seed", 4, [](const Lost_figure& lost) { return std::to_string(lost.seed); }},
            {"figure", 10, [](const Lost_figure& lost) { return lost.figure; }},
            {"ours", 8, [](const Lost_figure& lost) { return fixed(lost.ours, 4); }},
            {"first", 8, [](const Lost_figure& lost) { return fixed(lost.best, 4); }},
            {"method", 19, [](const Lost_figure& lost) { return lost.best_method; }}});
  for(const Lost_figure& lost : standing.lost)
    table.add(lost);
  out << ours << " is first or within 5 % of the first in "
      << standing.compared - standing.lost.size() << " of " << standing.compared << " figures"
      << std::endl;
}
