// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: LGPL-3.0-or-later OR LicenseRef-Commercial

#include "measure_runs.h"

#include "forked.h"

#include <nlohmann/json.hpp>

#include <malloc.h>
#include <sys/resource.h>

#include <exception>

namespace {

using Json = nlohmann::json;
using Work = std::function<void(Stopwatch&)>;

double peak_memory_so_far()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024; // KiB on Linux
}

/// In the process of a run: what it tells its parent.
Json report(const Work& work)
{
  Json message;
  message["memory"] = peak_memory_so_far(); // a new process starts with what it has
  message["error"] = "";
  message["stages"] = Json::array();
  Stopwatch stages, total;
  try {
    total.stage("total", [&] { work(stages); });
  } catch(const std::exception& error) {
    message["error"] = error.what();
  }
  for(const Stopwatch& stopwatch : {stages, total})
    for(const Stage_seconds& s : stopwatch.stages())
      message["stages"].push_back({s.name, s.cpu, s.wall});
  return message;
}

Measured_runs measure_once(const Work& work, double time_limit)
{
  malloc_trim(0); // what is free here could be used there without being counted
  const Forked run = run_forked([&work] { return Json::to_cbor(report(work)); }, time_limit);
  Measured_runs result;
  result.runs = 1;
  result.peak_memory = run.peak_memory;
  if(!run.in_time)
    result.status = "time limit";
  else
    result.status = run.death.empty() ? "ok" : run.death;
  if(result.status != "ok")
    return result;
  const Json message = Json::from_cbor(run.answer);
  if(!message["error"].get<std::string>().empty())
    result.status = message["error"];
  result.extra_memory = run.peak_memory - message["memory"].get<double>();
  for(const Json& stage : message["stages"])
    result.stages.push_back({stage[0], stage[1], stage[2]});
  return result;
}

template <typename Value>
double median(const std::vector<Measured_runs>& runs, const Value& value)
{
  std::vector<double> values;
  for(const Measured_runs& run : runs)
    values.push_back(value(run));
  return median_of(values);
}

} // namespace

Measured_runs measure_runs(const Work& work, std::size_t runs, double time_limit)
{
  std::vector<Measured_runs> all;
  while(all.size() < runs) {
    all.push_back(measure_once(work, time_limit));
    if(all.back().status != "ok")
      return all.back();
  }
  Measured_runs result = all.front();
  result.runs = runs;
  result.peak_memory = median(all, [](const auto& run) { return run.peak_memory; });
  result.extra_memory = median(all, [](const auto& run) { return run.extra_memory; });
  for(std::size_t s = 0; s < result.stages.size(); ++s) {
    result.stages[s].cpu = median(all, [s](const auto& run) { return run.stages.at(s).cpu; });
    result.stages[s].wall = median(all, [s](const auto& run) { return run.stages.at(s).wall; });
  }
  return result;
}
