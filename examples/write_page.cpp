// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "write_page.h"

#include "cloud_view.h"
#include "fill_page.h"
#include "page_files.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <vector>

namespace {

using nlohmann::ordered_json;

std::string base64(const std::vector<std::uint16_t>& numbers)
{
  constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  for(std::uint16_t number : numbers) { // lowest byte first, as browsers have it
    bytes.push_back(static_cast<unsigned char>(number & 0xff));
    bytes.push_back(static_cast<unsigned char>(number >> 8));
  }
  const std::size_t size = bytes.size();
  bytes.resize((size + 2) / 3 * 3, 0);
  std::string result;
  for(std::size_t i = 0; i < bytes.size(); i += 3) {
    const unsigned int bits = bytes[i] << 16u | bytes[i + 1] << 8u | bytes[i + 2];
    for(unsigned int shift : {18u, 12u, 6u, 0u})
      result += digits[bits >> shift & 63u];
  }
  std::fill(result.end() - static_cast<std::ptrdiff_t>(bytes.size() - size), result.end(), '=');
  return result;
}

/// Rounded to what a `float` would hold of it, with fewer digits to write.
double rounded(double x, double diagonal)
{
  const double unit = diagonal > 0 ? std::pow(10., std::floor(std::log10(diagonal)) - 6) : 1;
  return std::round(x / unit) * unit;
}

/// In an order of which every beginning is spread over the whole, for a view that shows a part.
std::vector<std::size_t> scattered(const std::vector<std::size_t>& chosen)
{
  if(chosen.empty())
    return {};
  constexpr double golden = 0.6180339887498949;
  const std::size_t size = chosen.size();
  std::size_t step = std::max<std::size_t>(1, static_cast<std::size_t>(golden * double(size)));
  while(std::gcd(step, size) != 1)
    ++step;
  std::vector<std::size_t> result;
  for(std::size_t i = 0; i < size; ++i)
    result.push_back(chosen[i * step % size]);
  return result;
}

ordered_json cloud_json(const Skeletonized_cloud& cloud, const Cloud_box& box)
{
  constexpr std::size_t most = 250000;
  constexpr double steps = 65535;
  std::vector<std::uint16_t> positions, branches;
  for(std::size_t i : scattered(thinned(cloud.points.size(), most))) {
    const auto& p = cloud.points[i];
    const std::array<double, 3> xyz{p.x(), p.y(), p.z()};
    for(std::size_t k = 0; k < 3; ++k) {
      const double share = box.size(k) > 0 ? (xyz[k] - box.lower[k]) / box.size(k) : 0;
      positions.push_back(static_cast<std::uint16_t>(std::lround(share * steps)));
    }
    const std::uint32_t b = cloud.branch_of_point[i];
    constexpr std::uint32_t outlier = 65535;
    branches.push_back(
        static_cast<std::uint16_t>(b == Skeletonized_cloud::no_branch ? outlier : b % outlier));
  }
  ordered_json result;
  result["count"] = branches.size();
  result["lower"] = box.lower;
  result["size"] = {box.size(0), box.size(1), box.size(2)};
  result["positions"] = base64(positions);
  result["branches"] = base64(branches);
  return result;
}

ordered_json skeleton_json(const Skeletonized_cloud& cloud, const Cloud_box& box)
{
  const auto& graph = cloud.skeleton.graph;
  ordered_json points = ordered_json::array(), radii = ordered_json::array();
  for(const auto& v : graph.vertices) {
    for(std::size_t k = 0; k < 3; ++k)
      points.push_back(rounded(v.point[k] - box.centre(k), box.diagonal()));
    radii.push_back(rounded(v.radius, box.diagonal()));
  }
  ordered_json edges = ordered_json::array(), edge_branches = ordered_json::array();
  for_each_edge(cloud.skeleton, [&](std::size_t b, std::size_t v, std::size_t w) {
    edges.push_back(v);
    edges.push_back(w);
    edge_branches.push_back(b);
  });
  ordered_json branches = ordered_json::array();
  for(std::size_t b = 0; b < cloud.skeleton.branches.size(); ++b) {
    const auto& branch = cloud.skeleton.branches[b];
    ordered_json json;
    json["order"] = branch.order;
    json["length"] = rounded(branch.length, box.diagonal());
    json["mean_radius"] = rounded(branch.mean_radius, box.diagonal());
    json["points"] = nullptr;
    if(!cloud.points_of_branch.empty())
      json["points"] = cloud.points_of_branch[b];
    branches.push_back(json);
  }
  return {{"points", points},
          {"radius", radii},
          {"edges", edges},
          {"edge_branches", edge_branches},
          {"branches", branches}};
}

ordered_json facts_json(const Skeletonized_cloud& cloud)
{
  const Skeleton_facts facts = facts_of(cloud);
  return {{"points", cloud.number_of_points},
          {"components", facts.components},
          {"branches", cloud.skeleton.branches.size()},
          {"tips", facts.tips},
          {"junctions", facts.junctions},
          {"cycles", facts.cycles},
          {"length", facts.length}};
}

} // namespace

void write_page(std::ostream& os, const Skeletonized_cloud& cloud)
{
  const Cloud_box box = box_of(cloud);
  ordered_json data;
  data["name"] = cloud.name;
  data["up"] = cloud.up;
  data["centre"] = {box.centre(0), box.centre(1), box.centre(2)};
  data["size"] = {box.size(0), box.size(1), box.size(2)};
  data["diagonal"] = box.diagonal() > 0 ? box.diagonal() : 1;
  // Places are shown to about a hundred thousandth of the diagonal.
  data["decimals"] =
      box.diagonal() > 0
          ? std::clamp(5 - static_cast<int>(std::ceil(std::log10(box.diagonal()))), 0, 12)
          : 3;
  data["facts"] = facts_json(cloud);
  data["cloud"] = cloud_json(cloud, box);
  data["skeleton"] = skeleton_json(cloud, box);
  const auto& files = page_files();
  write_filled(os, files.at("skeleton.html"), [&](const std::string& name) {
    return name == "data.json" ? embedded(data) : files.at(name);
  });
}
