// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Outcome.h"

#include "beside.h"
#include "methods/defect_of.h"
#include "methods/l1_medial.h"
#include "methods/l1_medial_published.h"
#include "methods/spanning_tree.h"
#include "part_before.h"

#include <CGAL/Real_timer.h>

#include <exception>
#include <utility>

Outcome run_method(const std::string& name, Method_result (&method)(const Method_input&),
                   const Method_input& input)
{
  Outcome outcome;
  outcome.method = name;
  CGAL::Real_timer timer;
  timer.start();
  try {
    Skeleton skeleton = method(input).skeleton;
    const std::string defect = defect_of(skeleton);
    if(defect.empty())
      outcome.skeleton = std::move(skeleton);
    else
      outcome.status = defect;
  } catch(const std::exception& error) {
    outcome.status = error.what();
  }
  outcome.seconds = timer.time();
  return outcome;
}

Outcome baseline(const std::vector<Point>& points)
{
  Method_input input;
  input.points = points;
  return run_method("tree", spanning_tree, input);
}

std::vector<Outcome> skeletonize(const std::vector<Point>& points, const Quality_options& options)
{
  const Scene_beside scene =
    options.neighbor.empty() ? Scene_beside{points} : beside(points, options.neighbor);
  Method_input input;
  input.points = scene.points;
  std::vector<Outcome> outcomes;
  outcomes.push_back(run_method("default", l1_medial, input));
  if(options.as_published)
    outcomes.push_back(run_method("published", l1_medial_published, input));
  if(!options.neighbor.empty())
    for(Outcome& outcome : outcomes)
      outcome.skeleton = metrics::part_before(scene.border, outcome.skeleton);
  return outcomes;
}
