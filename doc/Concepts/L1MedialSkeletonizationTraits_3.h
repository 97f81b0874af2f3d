// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\cgalConcept

What `CGAL::extract_l1_medial_skeleton()`, `CGAL::L1_medial_skeletonization_3`,
`CGAL::fit_gaussian_mixture()` and `CGAL::project_to_l1_medians()` ask of their geometric traits:
two types. No predicate, no construction and no object of the traits is used; everything is computed
in `double`, in coordinates in which the bounding box of the input is centred and has a diagonal of
length 1.

\cgalHasModelsBegin
\cgalHasModels{any CGAL kernel with inexact constructions over `float` or `double`\, such as
`CGAL::Simple_cartesian<float>`\, `CGAL::Simple_cartesian<double>` and
`CGAL::Exact_predicates_inexact_constructions_kernel`}
\cgalHasModelsEnd

Unless `geom_traits` is given, the traits are the kernel of the points, as `CGAL::Kernel_traits`
names it.
*/
class L1MedialSkeletonizationTraits_3
{
public:
  /*!
  `float` or `double`. It is converted to and from `double`, and constructed from 0.
  */
  typedef unspecified_type FT;

  /*!
  A point. Default constructible, copyable and assignable; it has

  - a constructor from three `FT`, which also accepts `{0, 0, 0}`;
  - members `x()`, `y()` and `z()` whose results `CGAL::to_double()` takes.
  */
  typedef unspecified_type Point_3;
};
