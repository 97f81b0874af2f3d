// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_MODEL_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_MODEL_H

#include "Measurements.h"
#include "methods/Method.h"

#include <cstddef>
#include <string>
#include <vector>

/// Without folder and extension.
std::string name_of(const std::string& file);

/// A cloud, the mesh it was drawn from if there is one, and what is true about its skeleton.
struct Model
{
  std::string name;
  Mesh mesh;                    ///< empty if the file is a cloud
  std::vector<Mesh> components; ///< of the mesh
  bool is_closed = false;       ///< whether there is a mesh, and that without a hole
  double diagonal = 0;          ///< of the bounding box
  std::vector<Point> points;
  Truth truth;
};

/// Draws points from a mesh; those of a file without faces stay as they are.
/// \throw std::runtime_error
Model read_model(const std::string& file, std::size_t number_of_points, unsigned int seed);

/// In a random orientation.
std::vector<Point> turned(std::vector<Point> points, unsigned int seed);

/// Likewise. The diagonal stays as it is, and with it all that is measured in it.
Model turned(Model model, unsigned int seed);

/// Isotropic Gaussian noise. \param deviation in the unit of the points
std::vector<Point> with_noise(std::vector<Point> points, double deviation, unsigned int seed);

/// Fills in what is true and, if there is a closed mesh, what can be measured with it.
void measure_in_model(Measurements& row, const Skeleton& skeleton, const Model& model);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_MODEL_H
