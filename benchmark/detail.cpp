// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "detail.h"

#include "Report.h"
#include "measure.h"
#include "to_points.h"

#include "generator/branching_tree.h"
#include "generator/clouds.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

namespace detail {

namespace {

struct Tree
{
  std::size_t points;
  int levels;
};

/// One tree if it was asked for.
std::vector<Tree> chosen_trees(const Quality_options& options)
{
  if(options.levels > 0)
    return {{options.points, options.levels}};
  // Two trees whose finest limbs are one to two points thick, and each about five times as well
  // resolved; of those, the larger has four times as many ends.
  return {{18000, 5}, {177845, 6}, {176822, 8}, {883662, 8}};
}

std::vector<Row> rows_of(const Tree& tree, unsigned int seed, const Quality_options& options)
{
  const shapes::Known_shape shape = shapes::branching_tree(tree.levels, seed);
  shapes::Random random(seed);
  const double spacing = std::sqrt(shape.solid.area(random) / static_cast<double>(tree.points));
  const std::vector<Point> points =
      to_points(shapes::sample(shape, shapes::Variant::clean, tree.points, seed));
  std::vector<Row> rows;
  for(const Outcome& outcome : skeletonize(points, options)) {
    Row row;
    row.shape = "2^" + std::to_string(tree.levels) + " ends";
    row.seed = std::to_string(seed);
    row.truth = {shape.components, shape.cycles, shape.ends, shape.junctions.size()};
    row.thinnest = shapes::least_radius(shape) / spacing;
    measure(row, outcome, points);
    write_miss(options.misses, row, outcome.skeleton, points);
    rows.push_back(row);
  }
  return rows;
}

Layout layout()
{
  using namespace columns;
  return {{text("tree", 9, &Row::shape), text("seed", 4, &Row::seed), points(),
           number("thinnest", &Row::thinnest, 2), text("method", 9, &Row::method), exact(),
           count("comp", &Graph_counts::components), count("cycles", &Graph_counts::cycles),
           count("ends", &Graph_counts::ends), truth("ends_true", &Truth::ends),
           count("junctions", &Graph_counts::junctions), truth("junctions_true", &Truth::junctions),
           number("seconds", &Row::seconds, 2), text("status", 2, &Row::status)},
          {group_name(), group_method(), group_size(), share("exact%", &Row::exact),
           share("comp%", &Row::components_exact), share("cycles%", &Row::cycles_exact),
           share("ends%", &Row::ends_exact), share("junctions%", &Row::junctions_exact),
           mean("seconds", &Row::seconds, 2)},
          {}};
}

} // namespace

void run(const Quality_options& options)
{
  const std::vector<Tree> trees = chosen_trees(options);
  const auto work = [&](std::size_t job) {
    const auto seed = static_cast<unsigned int>(job % options.seeds) + options.first_seed;
    return rows_of(trees[job / options.seeds], seed, options);
  };
  report(options, trees.size() * options.seeds, work, layout());
}

} // namespace detail
