// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "results_json.h"

#include <CGAL/bounding_box.h>
#include <CGAL/number_utils.h>

#include <boost/range/iterator_range.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

using nlohmann::json;

namespace {

/// Where the coordinates of the report are measured from, and in what.
class Frame
{
public:
  explicit Frame(const std::vector<Point>& cloud)
  {
    const auto box = CGAL::bounding_box(cloud.begin(), cloud.end());
    const double diagonal = std::sqrt(CGAL::squared_distance(box.min(), box.max()));
    centre_ = CGAL::midpoint(box.min(), box.max());
    scale_ = diagonal > 0 ? units / diagonal : 1;
  }

  void append(json& coordinates, const Point& point) const
  {
    for(int i = 0; i < 3; ++i)
      coordinates.push_back(std::lround(std::clamp(scale_ * (point[i] - centre_[i]), -far, far)));
  }

private:
  static constexpr double units = 1e4; // finer than a screen, and few digits to write
  static constexpr double far = 1e7;   // for what a method throws away; nobody looks there
  Point centre_;
  double scale_;
};

json cloud_json(const std::vector<Point>& cloud)
{
  constexpr std::size_t most = 4000; // more would only make a picture of 160 pixels grey all over
  const Frame frame(cloud);
  const std::size_t shown = std::min(cloud.size(), most);
  json points = json::array();
  for(std::size_t i = 0; i < shown; ++i)
    frame.append(points, cloud[i * cloud.size() / shown]);
  return {{"size", cloud.size()}, {"points", std::move(points)}};
}

json skeleton_json(const Skeleton& skeleton, const Frame& frame)
{
  json points = json::array(), ends = json::array();
  for(const auto v : boost::make_iterator_range(vertices(skeleton)))
    frame.append(points, skeleton[v].point);
  for(const auto e : boost::make_iterator_range(edges(skeleton))) {
    ends.push_back(source(e, skeleton));
    ends.push_back(target(e, skeleton));
  }
  return {{"points", std::move(points)}, {"edges", std::move(ends)}};
}

json truth_json(const std::optional<std::size_t>& known)
{
  return known ? json(*known) : json();
}

json metrics_json(const Measurements& measured)
{
  return {{"components", measured.got.components},
          {"true_components", truth_json(measured.truth.components)},
          {"cycles", measured.got.cycles},
          {"true_cycles", truth_json(measured.truth.cycles)},
          {"ends", measured.got.ends},
          {"true_ends", truth_json(measured.truth.ends)},
          {"junctions", measured.got.junctions},
          {"off_centre", measured.off_centre},
          {"inside", measured.inside},
          {"spurs", measured.spurs},
          {"unexplained", measured.unexplained},
          {"moved_mean", measured.moved_mean},
          {"moved_maximum", measured.moved_maximum}};
}

json row_json(const Compared& row)
{
  json result = {{"input", row.input},
                 {"noise", row.noise},
                 {"seed", row.seed},
                 {"method", row.method},
                 {"input_kind", row.input_kind},
                 {"status", row.status},
                 {"message", row.message},
                 {"stages", row.stages},
                 {"seconds", row.seconds},
                 {"peak_memory_mib", row.peak_memory},
                 {"cloud", nullptr},
                 {"metrics", nullptr},
                 {"skeleton", nullptr}};
  if(row.status == "ok")
    result["metrics"] = metrics_json(row.measured);
  return result;
}

} // namespace

json results_json(const std::vector<Compared>& rows)
{
  json result = {{"rows", json::array()}, {"clouds", json::array()}};
  // Of an input, its noise and its seed.
  std::map<std::tuple<std::string, double, unsigned int>, std::size_t> cloud_of;
  for(const Compared& row : rows) {
    json written = row_json(row);
    if(row.cloud && !row.cloud->empty()) {
      const auto [known, is_new] =
          cloud_of.try_emplace({row.input, row.noise, row.seed}, result["clouds"].size());
      if(is_new)
        result["clouds"].push_back(cloud_json(*row.cloud));
      written["cloud"] = known->second;
      if(row.status == "ok")
        written["skeleton"] = skeleton_json(row.skeleton, Frame(*row.cloud));
    }
    result["rows"].push_back(std::move(written));
  }
  return result;
}
