// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Wrong calls. Each must give one error, which says in a sentence what is wrong; the sentence
// follows the call here.

#include <CGAL/Gaussian_mixture_builder_3.h>
#include <CGAL/compute_medial_samples.h>
#include <CGAL/extract_l1_medial_skeleton.h>
#include <CGAL/extract_published_l1_medial_skeleton.h>
#include <CGAL/fit_gaussian_mixture.h>
#include <CGAL/link_medial_samples.h>

#include <CGAL/Simple_cartesian.h>

#include <utility>
#include <vector>

using Kernel = CGAL::Simple_cartesian<double>;
namespace parameters = CGAL::parameters;

void wrong_calls(const std::vector<Kernel::Point_3>& points,
                 const std::vector<std::pair<Kernel::Point_3, int>>& pairs,
                 const CGAL::Gaussian_mixture_3<Kernel>& mixture,
                 CGAL::Medial_samples_3<Kernel>& samples, CGAL::Curve_skeleton_3<Kernel>& skeleton)
{
  CGAL::extract_l1_medial_skeleton(pairs, skeleton);
  // expected: the elements of the range are not 3D points: pass point_map(MAP)
  CGAL::extract_published_l1_medial_skeleton(pairs, skeleton);
  // expected: the elements of the range are not 3D points: pass point_map(MAP)
  CGAL::fit_gaussian_mixture(pairs);
  // expected: the elements of the range are not 3D points: pass point_map(MAP)
  CGAL::Gaussian_mixture_builder_3<Kernel>(CGAL::Bbox_3()).insert(pairs);
  // expected: the elements of the range are not 3D points: pass point_map(MAP)
  CGAL::extract_l1_medial_skeleton(points, skeleton, parameters::random_seed(1));
  // expected: unknown named parameter: known are point_map, geom_traits, callback, maximum_running_time, single_component, is_tree, maximum_cells, smallest_feature
  CGAL::extract_published_l1_medial_skeleton(points, skeleton, parameters::single_component(true));
  // expected: unknown named parameter: known are point_map, geom_traits, callback, maximum_running_time, number_of_iterations, random_seed, and those of parameters::published
  CGAL::compute_medial_samples(mixture, samples, parameters::random_seed(1));
  // expected: unknown named parameter: known is callback
  CGAL::link_medial_samples(samples, skeleton, parameters::number_of_iterations(3));
  // expected: unknown named parameter: known are callback, single_component, is_tree
}
