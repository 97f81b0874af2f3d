// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "poisson_mcf.h"

#include "average_spacing.h"
#include "components_of.h"
#include "mcf.h"
#include "remesh.h"

#include <CGAL/boost/graph/helpers.h>
#include <CGAL/poisson_surface_reconstruction.h>
#include <CGAL/property_map.h>

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace {

/// \throw std::runtime_error
std::vector<Mesh> poisson_surface(const Method_input& input)
{
  using Oriented_point = std::pair<Point, Vector>;
  std::vector<Oriented_point> oriented;
  for(std::size_t i = 0; i < input.points.size(); ++i)
    oriented.emplace_back(input.points[i], input.normals[i]);
  Mesh surface;
  if(!CGAL::poisson_surface_reconstruction_delaunay(
         oriented.begin(), oriented.end(), CGAL::First_of_pair_property_map<Oriented_point>(),
         CGAL::Second_of_pair_property_map<Oriented_point>(), surface,
         average_spacing(input.points)))
    throw std::runtime_error("there is no Poisson surface");
  if(!CGAL::is_closed(surface))
    throw std::runtime_error("the Poisson surface is not closed");
  return remesh_to(components_of(surface), input.points.size());
}

} // namespace

Method_result poisson_mcf(const Method_input& input)
{
  Method_result result;
  Method_input reconstructed;
  reconstructed.components =
      timed_stage(result, "reconstruction", [&] { return poisson_surface(input); });
  return after(result, mcf(reconstructed));
}
