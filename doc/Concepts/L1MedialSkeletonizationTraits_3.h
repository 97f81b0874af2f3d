// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgPointSetSkeletonization3Concepts
\cgalConcept

The requirements on the geometric traits of all functions and classes of this package: two types. No
predicate, no construction and no object of the traits is used. Points are converted to `double` and
scaled so that the bounding box of the input is centred at the origin and has a diagonal of length 1.

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
  `float` or `double`. It must be convertible to and from `double`, and constructible from 0.
  */
  typedef unspecified_type FT;

  /*!
  A point: default constructible, copyable and assignable, with

  - a constructor from three `FT`, which also accepts `{0, 0, 0}`;
  - members `x()`, `y()` and `z()`, whose results can be passed to `CGAL::to_double()`.
  */
  typedef unspecified_type Point_3;
};
