// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "reference.h"

#include "methods/add_curve.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

Skeleton reference_of(const shapes::Known_shape& shape)
{
  std::map<Point, std::size_t> numbers; // pieces are connected where their ends coincide
  std::vector<Point> points;
  std::vector<double> radii;
  const auto number_of = [&](const shapes::Vector& v, double radius) {
    const Point p(v.x(), v.y(), v.z());
    const auto [known, is_new] = numbers.emplace(p, points.size());
    if(is_new) {
      points.push_back(p);
      radii.push_back(0);
    }
    radii[known->second] = std::max(radii[known->second], radius);
    return known->second;
  };
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(const shapes::Axis_segment& piece : shape.axis) {
    const std::size_t a = number_of(piece.a, piece.radius_a);
    const std::size_t b = number_of(piece.b, piece.radius_b);
    edges.emplace_back(a, b);
  }
  Skeleton skeleton;
  add_curve(skeleton, points, edges);
  for(std::size_t v = 0; v < radii.size(); ++v)
    skeleton[v].radius = radii[v];
  return skeleton;
}

Skeleton read_reference(const std::string& file)
{
  std::ifstream in(file);
  if(!in)
    throw std::runtime_error("cannot read '" + file + "'");
  std::vector<Point> points;
  std::vector<std::pair<std::size_t, std::size_t>> edges;
  for(std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if(kind == "v") {
      Point p;
      words >> p;
      points.push_back(p);
    }
    else if(kind == "l") {
      std::size_t from, to;
      for(words >> from; words >> to; from = to)
        edges.emplace_back(from - 1, to - 1);            // numbered from 1
      words.clear(words.rdstate() & ~std::ios::failbit); // at the end of the line
    }
    if(words.fail())
      throw std::runtime_error("cannot read '" + file + "': '" + line + "' is no vertex");
  }
  for(const auto& [a, b] : edges)
    if(a >= points.size() || b >= points.size())
      throw std::runtime_error("cannot read '" + file + "': a line has no such vertex");
  if(edges.empty())
    throw std::runtime_error("cannot read '" + file + "': it has no lines");
  Skeleton skeleton;
  add_curve(skeleton, points, edges);
  return skeleton;
}
