// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "message.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstddef>

std::vector<std::uint8_t> to_bytes(const Message& message)
{
  const Skeleton& skeleton = message.result.skeleton;
  std::vector<std::array<double, 4>> vertex_rows;
  for(const auto v : CGAL::make_range(vertices(skeleton))) {
    const Point& p = skeleton[v].point;
    vertex_rows.push_back({p.x(), p.y(), p.z(), skeleton[v].radius});
  }
  std::vector<std::array<std::size_t, 2>> edge_rows;
  for(const auto e : CGAL::make_range(edges(skeleton)))
    edge_rows.push_back({source(e, skeleton), target(e, skeleton)});
  return nlohmann::json::to_cbor({{"error", message.error},
                                  {"stages", message.result.stages},
                                  {"seconds", message.seconds},
                                  {"vertices", vertex_rows},
                                  {"edges", edge_rows}});
}

Message to_message(const std::vector<std::uint8_t>& bytes)
{
  const nlohmann::json json = nlohmann::json::from_cbor(bytes);
  Message message;
  json.at("error").get_to(message.error);
  json.at("stages").get_to(message.result.stages);
  json.at("seconds").get_to(message.seconds);
  Skeleton& skeleton = message.result.skeleton;
  for(const auto& row : json.at("vertices")) {
    const auto [x, y, z, radius] = row.get<std::array<double, 4>>();
    const auto v = add_vertex(skeleton);
    skeleton[v].point = Point(x, y, z);
    skeleton[v].radius = radius;
  }
  for(const auto& row : json.at("edges"))
    add_edge(row.at(0).get<std::size_t>(), row.at(1).get<std::size_t>(), skeleton);
  return message;
}
