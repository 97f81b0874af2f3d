// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "generated.h"

#include "Report.h"
#include "chosen.h"
#include "axis_distance.h"
#include "inside_share.h"
#include "measure.h"
#include "radius_factor.h"
#include "to_points.h"

#include "generator/clouds.h"
#include "generator/families.h"

#include <cstddef>
#include <map>
#include <string>
#include <vector>

namespace generated {

namespace {

/// Fills in what can be measured because the shape is known.
void measure_shape(Row& row, const Skeleton& skeleton, const shapes::Known_shape& shape)
{
  row.truth = {shape.components, shape.cycles, shape.ends};
  const auto distance = metrics::axis_distance(skeleton, shape.axis, shape.junctions);
  row.axis_mean = distance.mean;
  row.axis_maximum = distance.maximum;
  constexpr double tolerance = 0.015; // diagonals
  row.radius = metrics::radius_factor(skeleton, shape.axis,
                                      tolerance * bounding_box(shape).diagonal().norm());
  const auto inside = [&shape](const metrics::Point& p) {
    return shape.solid.signed_distance({p.x(), p.y(), p.z()}) <= 0;
  };
  constexpr double step = 0.2; // least radii
  row.inside = metrics::inside_share(skeleton, inside, step * shapes::least_radius(shape));
}

/// The rows of one shape: its variants, each by every method.
std::vector<Row> rows_of(const shapes::Known_shape& shape,
                         const std::vector<shapes::Variant>& variants,
                         const Quality_options& options)
{
  std::vector<Row> rows;
  std::map<std::string, Skeleton> clean; // by method
  for(const shapes::Variant variant : variants) {
    const std::vector<Point> points =
        to_points(shapes::sample(shape, variant, options.points, shape.seed));
    for(const Outcome& outcome : skeletonize(points, options)) {
      Row row;
      row.shape = shape.family;
      row.seed = std::to_string(shape.seed);
      row.variant = shapes::to_string(variant);
      measure(row, outcome, points);
      measure_shape(row, outcome.skeleton, shape);
      if(variant == shapes::Variant::clean)
        clean[outcome.method] = outcome.skeleton;
      else
        measure_stability(row, outcome.skeleton, clean[outcome.method],
                          shape.solid.bounding_box().diagonal().norm());
      write_miss(options.misses, row, outcome.skeleton, points);
      rows.push_back(row);
    }
  }
  return rows;
}

Layout layout()
{
  using namespace columns;
  return {{text("family", 16, &Row::shape),
           text("seed", 4, &Row::seed),
           text("variant", 18, &Row::variant),
           text("method", 9, &Row::method),
           exact(),
           count("comp", &Graph_counts::components),
           truth("comp_true", &Truth::components),
           count("cycles", &Graph_counts::cycles),
           truth("cycles_true", &Truth::cycles),
           count("ends", &Graph_counts::ends),
           truth("ends_true", &Truth::ends),
           count("junctions", &Graph_counts::junctions),
           number("axis", &Row::axis_mean, 3),
           number("axis_max", &Row::axis_maximum, 2),
           number("radius", &Row::radius, 2),
           number("inside", &Row::inside, 4),
           spurs(),
           number("unexplained", &Row::unexplained, 4),
           number("moved", &Row::moved_mean, 4),
           number("moved_max", &Row::moved_maximum, 4),
           number("seconds", &Row::seconds, 2),
           text("status", 2, &Row::status)},
          {group_name(), group_method(), group_size(), share("exact%", &Row::exact),
           share("comp%", &Row::components_exact), share("cycles%", &Row::cycles_exact),
           share("ends%", &Row::ends_exact), mean("axis", &Row::axis_mean, 3),
           mean("axis_max", &Row::axis_maximum, 2), mean("radius", &Row::radius, 2),
           mean("inside", &Row::inside, 4), outside(),
           total_spurs(), mean("unexplained", &Row::unexplained, 4),
           mean("moved", &Row::moved_mean, 4), mean("moved_max", &Row::moved_maximum, 4),
           mean("seconds", &Row::seconds, 2)},
          {[](const Row& row) { return row.shape; }, [](const Row& row) { return row.variant; }}};
}

} // namespace

void run(const Quality_options& options)
{
  const std::vector<std::string> families =
      chosen(options.families, shapes::family_names(), "family");
  const auto name_of = [](shapes::Variant variant) { return shapes::to_string(variant); };
  const std::vector<shapes::Variant> variants =
      options.variants.empty()
          ? shapes::usual_variants()
          : chosen(options.variants, shapes::all_variants(), name_of, "variant");
  const auto work = [&](std::size_t job) {
    const auto seed = static_cast<unsigned int>(job % options.seeds) + options.first_seed;
    return rows_of(shapes::known_shape(families[job / options.seeds], seed), variants, options);
  };
  report(options, families.size() * options.seeds, work, layout());
}

} // namespace generated
