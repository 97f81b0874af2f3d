// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_INPUT_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_INPUT_H

#include "../Model.h"
#include "../methods/registry.h"
#include "Comparison_options.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

/// A method with something to work on.
struct Task
{
  std::string method;
  std::string input_kind; ///< see Compared
  std::function<Method_result()> work;
};

/// A model as the methods get it, with noise: its cloud and, if it is closed, its surface.
class Compared_input
{
public:
  /// \param fine_components of the model, with as many vertices as there are points
  /// \param noise standard deviation, in diagonals
  /// \param seed of the noise
  Compared_input(const Model& model, const std::vector<Mesh>& fine_components, double noise,
                 unsigned int seed, const Comparison_options& options);

  std::shared_ptr<const std::vector<Point>> cloud() const { return cloud_; }

  /// What a method is to do. The tasks refer to this.
  std::vector<Task> tasks(const Registered_method& method) const;

private:
  Task mesh_task(const Registered_method& method) const;
  Task wrap_task(const Registered_method& method) const;
  Task decimation_task(const Registered_method& method) const;

  std::shared_ptr<const std::vector<Point>> cloud_;
  std::vector<Mesh> components_; ///< none if there is no closed mesh
  bool decimate_;
};

/// The closed components of a model, facing outwards, remeshed so that together they have about as
/// many vertices as wanted; none if it is a cloud, or open.
std::vector<Mesh> fine_components(const Model& model, std::size_t number_of_vertices);

/// What a method gets, as long as it is not known that a wrap has to do for a mesh.
std::string input_kind(Needs needs);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_COMPARISON_COMPARED_INPUT_H
