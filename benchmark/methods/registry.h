// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REGISTRY_H
#define POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REGISTRY_H

#include "Method.h"

#include <string>
#include <vector>

/// What a method reads of its input.
enum class Needs
{
  points,
  points_and_normals,
  mesh
};

struct Registered_method
{
  std::string name;
  Needs needs;
  Method_result (*run)(const Method_input&);
  std::string source; ///< where it is from, in a few words
};

/// All compared methods, ours first.
const std::vector<Registered_method>& registered_methods();

/// The methods of these names, in this order. \throw std::runtime_error if there is none such
std::vector<Registered_method> methods_named(const std::vector<std::string>& names);

#endif // POINT_SET_SKELETONIZATION_3_BENCHMARK_METHODS_REGISTRY_H
