// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*!
\ingroup PkgPointSetSkeletonization3Concepts
\cgalConcept

The requirements on the geometric traits of all functions and classes of this package: two types,
and the construction of points. No predicate is used. Points are converted to `double` and scaled so
that the bounding box of the input is centred at the origin and has a diagonal of length 1. The
traits must be default constructible and copyable.

\cgalHasModelsBegin
\cgalHasModels{any CGAL kernel with inexact constructions over `float` or `double`\, such as
`CGAL::Simple_cartesian<float>`\, `CGAL::Simple_cartesian<double>` and
`CGAL::Exact_predicates_inexact_constructions_kernel`}
\cgalHasModelsEnd

Results are constructed by the traits object that is passed as `geom_traits`. Functions without that
parameter use a new one. Unless `geom_traits` is given, the traits are the kernel of the points, as
`CGAL::Kernel_traits` names it.
*/
class L1MedialSkeletonizationTraits_3
{
public:
  /*!
  `float` or `double`. It must be convertible to and from `double`, and constructible from 0.
  */
  typedef unspecified_type FT;

  /*!
  A point: copyable and assignable, with members `x()`, `y()` and `z()`, whose results can be passed
  to `CGAL::to_double()`.
  */
  typedef unspecified_type Point_3;

  /*!
  The construction of points: default constructible, with the operators

  - `Point_3 operator()(FT x, FT y, FT z)`, a point by its coordinates;
  - `Point_3 operator()(CGAL::Origin)`, the point of results that are not computed yet.
  */
  typedef unspecified_type Construct_point_3;

  /*!
  Returns the construction of points.
  */
  Construct_point_3 construct_point_3_object() const;
};
