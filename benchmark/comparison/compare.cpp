// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compare.h"

#include "../Model.h"
#include "../measure_skeleton.h"
#include "Compared_input.h"
#include "generated_model.h"
#include "isolated_run.h"
#include "nearest_point_radii.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <map>
#include <optional>
#include <utility>

namespace {

using Use = std::function<void(const Compared&)>;

/// The rows of an input that cannot be read.
void add_unreadable(const std::string& input, unsigned int seed, const std::string& message,
                    const std::vector<Registered_method>& methods,
                    const Comparison_options& options, const Use& use)
{
  Compared row;
  row.input = is_generated(input) ? input : name_of(input);
  row.seed = seed;
  row.status = "unreadable";
  row.message = message;
  for(const double noise : options.noise)
    for(const Registered_method& method : methods) {
      row.noise = noise;
      row.method = method.name;
      row.input_kind = input_kind(method.needs);
      use(row);
    }
}

bool has_radii(const Skeleton& skeleton)
{
  const auto range = vertices(skeleton);
  return std::any_of(range.first, range.second,
                     [&skeleton](auto v) { return skeleton[v].radius > 0; });
}

Model model_of(const std::string& input, std::size_t points, unsigned int seed)
{
  return is_generated(input) ? generated_model(input, points, seed)
                             : read_model(input, points, seed);
}

class Model_comparison
{
public:
  /// \throw std::exception if it cannot be read, or its mesh not be remeshed
  Model_comparison(const std::string& input, unsigned int seed,
                   const std::vector<Registered_method>& methods,
                   const Comparison_options& options)
      : seed_(seed)
      , model_(model_of(input, options.points, seed))
      , methods_(methods)
      , options_(options)
  {
    const auto needs_mesh = [](const auto& method) { return method.needs == Needs::mesh; };
    if(std::any_of(methods.begin(), methods.end(), needs_mesh))
      fine_components_ = fine_components(model_, options.points);
  }

  void run(const Use& use)
  {
    for(const double noise : options_.noise) {
      const Compared_input input(model_, fine_components_, noise, seed_, options_);
      for(const Registered_method& method : methods_)
        for(const Task& task : input.tasks(method))
          use(row_of(task, noise, input));
    }
  }

private:
  Compared row_of(const Task& task, double noise, const Compared_input& input)
  {
    Isolated_result run = run_isolated(task.work, options_.time_limit);
    Compared row;
    row.input = model_.name;
    row.noise = noise;
    row.seed = seed_;
    row.method = task.method;
    row.input_kind = task.input_kind;
    row.status = run.status;
    row.message = run.message;
    row.stages = run.result.stages;
    row.seconds = run.seconds;
    row.peak_memory = run.peak_memory;
    row.measured.truth = model_.truth;
    row.skeleton = std::move(run.result.skeleton);
    row.cloud = input.cloud();
    if(row.status == "ok")
      measure(row);
    return row;
  }

  void measure(Compared& row)
  {
    if(!has_radii(row.skeleton))
      metrics::set_nearest_point_radii(row.skeleton, model_.points);
    measure_skeleton(row.measured, row.skeleton, *row.cloud);
    measure_in_model(row.measured, row.skeleton, model_);
    const auto key = std::make_pair(row.method, row.input_kind);
    if(row.noise == 0)
      clean_[key] = row.skeleton;
    else
      measure_stability(row.measured, row.skeleton, clean_[key], model_.diagonal);
  }

  const unsigned int seed_;
  const Model model_;
  const std::vector<Registered_method>& methods_;
  const Comparison_options& options_;
  std::vector<Mesh> fine_components_;
  std::map<std::pair<std::string, std::string>, Skeleton> clean_; ///< by method and input kind
};

} // namespace

void compare(const std::string& input, const std::vector<Registered_method>& methods,
             const Comparison_options& options, const Use& use)
{
  for(unsigned int seed = options.seed; seed < options.seed + options.seeds; ++seed) {
    std::optional<Model_comparison> comparison;
    try {
      comparison.emplace(input, seed, methods, options);
    } catch(const std::exception& error) {
      add_unreadable(input, seed, error.what(), methods, options, use);
      continue;
    }
    comparison->run(use);
  }
}
