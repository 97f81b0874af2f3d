// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "measure_runs.h"

#include "forked.h"

#include <CGAL/Real_timer.h>

#include <nlohmann/json.hpp>
#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#endif

#include <malloc.h>
#include <sys/resource.h>

#include <cstddef>
#include <exception>

namespace {

using Json = nlohmann::json;

double peak_memory_so_far()
{
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024; // KiB on Linux
}

/// Keeps threads busy for a while: it takes a system up to 20 ms until new ones have cores of their
/// own.
void start_threads([[maybe_unused]] std::size_t threads)
{
#ifdef CGAL_LINKED_WITH_TBB
  CGAL::Real_timer timer;
  timer.start();
  const auto count = [](std::size_t) {
    for(volatile int i = 0; i < 10000; i = i + 1) {
    }
  };
  while(threads > 1 && timer.time() < 0.1)
    tbb::parallel_for(std::size_t(0), 10 * threads, count);
#endif
}

/// In the process of a run: what it tells its parent.
Json report(const Work& work)
{
#ifdef CGAL_LINKED_WITH_TBB
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, work.threads);
#endif
  start_threads(work.threads);
  Json message;
  message["memory"] = peak_memory_so_far(); // a new process starts with what it has
  message["error"] = "";
  message["stages"] = Json::array();
  Stopwatch stages, total;
  try {
    total.stage("total", [&] { work.run(stages); });
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

Measured_runs medians(const std::vector<Measured_runs>& runs)
{
  Measured_runs result = runs.front();
  result.runs = runs.size();
  result.peak_memory = median(runs, [](const auto& run) { return run.peak_memory; });
  result.extra_memory = median(runs, [](const auto& run) { return run.extra_memory; });
  for(std::size_t s = 0; s < result.stages.size(); ++s) {
    result.stages[s].cpu = median(runs, [s](const auto& run) { return run.stages.at(s).cpu; });
    result.stages[s].wall = median(runs, [s](const auto& run) { return run.stages.at(s).wall; });
  }
  result.stages_of_runs.clear();
  for(const Measured_runs& run : runs)
    result.stages_of_runs.push_back(run.stages);
  return result;
}

} // namespace

std::vector<Measured_runs> measure_runs(const std::vector<Work>& works, std::size_t runs,
                                        double time_limit)
{
  std::vector<std::vector<Measured_runs>> all(works.size());
  for(std::size_t run = 0; run < runs; ++run)
    for(std::size_t w = 0; w < works.size(); ++w)
      if(run == 0 || all[w].back().status == "ok")
        all[w].push_back(measure_once(works[w], time_limit));
  std::vector<Measured_runs> result;
  for(const std::vector<Measured_runs>& own : all)
    result.push_back(own.back().status == "ok" ? medians(own) : own.back());
  return result;
}
