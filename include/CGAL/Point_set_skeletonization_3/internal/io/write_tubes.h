// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_TUBES_H
#define CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_TUBES_H

#include <CGAL/Point_set_skeletonization_3/internal/branches/measure_branch.h>
#include <CGAL/Point_set_skeletonization_3/internal/interface/plain_data.h>
#include <CGAL/Point_set_skeletonization_3/internal/io/Written_skeleton.h>

#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <vector>

namespace CGAL {
namespace Point_set_skeletonization_3 {
namespace internal {

/// Tubes around branches, as triangles: each branch is a closed surface of its own, round at its
/// ends, that turns outwards. Where a branch bends so sharply that cross-sections would meet, some
/// are left out; so neighbouring parts of a tube do not intersect. Tubes overlap at junctions.
class Tube_mesh
{
public:
  /// Adds the tube of a branch. O(its vertices).
  void add(const Plain_skeleton& skeleton, const Plain_branch& branch)
  {
    bool is_closed =
        branch.vertices.size() > 1 && branch.vertices.front() == branch.vertices.back();
    std::vector<Section> sections = sections_of(skeleton, branch, is_closed);
    if(sections.size() > 2 || !is_closed)
      sections = without_crossings(sections, is_closed);
    if(is_closed && sections.size() < 3) { // hardly more than a point
      sections.resize(1);
      is_closed = false;
    }
    add_rings(sections, is_closed);
  }

  std::vector<Plain_point> points;
  std::vector<std::array<std::size_t, 3>> triangles;

private:
  static constexpr std::size_t corners = 16; ///< Of a ring.

  /// A circle: its centre, its axis of length 1, its radius.
  struct Section
  {
    Plain_point centre, axis;
    double radius;
  };

  static Plain_point sum(const Plain_point& a, double factor, const Plain_point& b)
  {
    return {{a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2]}};
  }

  static Plain_point cross(const Plain_point& a, const Plain_point& b)
  {
    return {{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]}};
  }

  /// Of length 1; along z if it has no direction.
  static Plain_point unit(const Plain_point& v)
  {
    const double length = std::sqrt(dot(v, v));
    return length > 0 ? Plain_point{{v[0] / length, v[1] / length, v[2] / length}}
                      : Plain_point{{0, 0, 1}};
  }

  static std::vector<Section> sections_of(const Plain_skeleton& skeleton,
                                          const Plain_branch& branch, bool is_closed)
  {
    // A radius of 0 would not give a surface.
    const double thinnest = 1e-3 * (std::max)(branch.mean_radius, 1e-3 * branch.length);
    std::vector<Section> sections;
    for(std::size_t v : branch.vertices) {
      const Plain_vertex& vertex = skeleton.vertices[v];
      if(sections.empty() || vertex.point != sections.back().centre)
        sections.push_back({vertex.point, {}, (std::max)(vertex.radius, thinnest)});
    }
    if(is_closed && sections.size() > 1)
      sections.pop_back(); // it is the first
    const std::size_t n = sections.size();
    for(std::size_t i = 0; i < n; ++i) {
      const bool has_before = i > 0 || is_closed, has_after = i + 1 < n || is_closed;
      Plain_point axis{};
      if(has_before && n > 1)
        axis = unit(difference(sections[i].centre, sections[(i + n - 1) % n].centre));
      if(has_after && n > 1)
        axis = sum(axis, 1, unit(difference(sections[(i + 1) % n].centre, sections[i].centre)));
      sections[i].axis = unit(axis);
    }
    return sections;
  }

  /// Whether each of two circles is on its side of the plane of the other.
  static bool are_apart(const Section& a, const Section& b)
  {
    const Plain_point step = difference(b.centre, a.centre);
    const Plain_point sine = cross(a.axis, b.axis);
    const double lean = (std::max)(a.radius, b.radius) * std::sqrt(dot(sine, sine));
    return dot(step, a.axis) > lean && dot(step, b.axis) > lean;
  }

  static std::vector<Section> without_crossings(const std::vector<Section>& sections,
                                                bool is_closed)
  {
    std::vector<Section> kept{sections.front()};
    for(std::size_t i = 1; i < sections.size(); ++i)
      if(are_apart(kept.back(), sections[i]))
        kept.push_back(sections[i]);
    Section last = is_closed ? kept.front() : sections.back();
    if(!is_closed && kept.size() > 1 && kept.back().centre == last.centre)
      return kept;
    while(kept.size() > 1 && !are_apart(kept.back(), last))
      kept.pop_back();
    if(!is_closed && sections.size() > 1) {
      if(!are_apart(kept.back(), last)) // the first: they are made parallel
        kept.back().axis = last.axis = unit(difference(last.centre, kept.back().centre));
      kept.push_back(last);
    }
    return kept;
  }

  /// A direction square to an axis, as near to `u` as can be.
  static Plain_point square_to(const Plain_point& axis, const Plain_point& u)
  {
    const Plain_point v = sum(u, -dot(u, axis), axis);
    if(dot(v, v) > 1e-12 * dot(u, u))
      return unit(v);
    const bool is_along_x = std::abs(axis[0]) > 0.9;
    return square_to(axis, is_along_x ? Plain_point{{0, 1, 0}} : Plain_point{{1, 0, 0}});
  }

  /// Adds the corners of a circle, the first in the direction `u` turned by an angle.
  void add_ring(const Section& section, const Plain_point& u, double angle)
  {
    const Plain_point v = cross(section.axis, u);
    for(std::size_t k = 0; k < corners; ++k) {
      const double a = angle + 2 * CGAL_PI * static_cast<double>(k) / corners;
      points.push_back(sum(sum(section.centre, section.radius * std::cos(a), u),
                           section.radius * std::sin(a), v));
    }
  }

  /// Joins the ring whose corners start at `a` to the next one, which starts at `b`.
  void join(std::size_t a, std::size_t b)
  {
    for(std::size_t k = 0; k < corners; ++k) {
      const std::size_t next = (k + 1) % corners;
      triangles.push_back({{a + k, a + next, b + next}});
      triangles.push_back({{a + k, b + next, b + k}});
    }
  }

  /// A tube through the circles, closed or with a round cap at both ends.
  void add_rings(const std::vector<Section>& open_sections, bool is_closed)
  {
    std::vector<Section> sections = open_sections;
    if(!is_closed)
      add_caps(sections);
    std::vector<Plain_point> u{square_to(sections[0].axis, {{1, 0, 0}})};
    for(std::size_t i = 1; i < sections.size(); ++i)
      u.push_back(square_to(sections[i].axis, u.back()));
    double twist = 0; // after a round
    if(is_closed) {
      const Plain_point back = square_to(sections[0].axis, u.back());
      twist = std::atan2(dot(back, cross(sections[0].axis, u[0])), dot(back, u[0]));
    }
    const std::size_t first = points.size();
    for(std::size_t i = 0; i < sections.size(); ++i)
      add_ring(sections[i], u[i],
               -twist * static_cast<double>(i) / static_cast<double>(sections.size()));
    for(std::size_t i = 1; i < sections.size(); ++i)
      join(first + (i - 1) * corners, first + i * corners);
    const std::size_t last = first + (sections.size() - 1) * corners;
    if(is_closed) {
      join(last, first);
      return;
    }
    const std::size_t start = points.size(), end = start + 1;
    points.push_back(sum(open_sections.front().centre, -open_sections.front().radius,
                         open_sections.front().axis));
    points.push_back(
        sum(open_sections.back().centre, open_sections.back().radius, open_sections.back().axis));
    for(std::size_t k = 0; k < corners; ++k) {
      const std::size_t next = (k + 1) % corners;
      triangles.push_back({{first + next, first + k, start}});
      triangles.push_back({{last + k, last + next, end}});
    }
  }

  /// Adds the circles of two half spheres, without their poles.
  static void add_caps(std::vector<Section>& sections)
  {
    constexpr int circles = 3;
    std::vector<Section> start, end;
    const Section first = sections.front(), last = sections.back();
    for(int i = 1; i <= circles; ++i) {
      const double angle = CGAL_PI / 2 * i / (circles + 1);
      const auto cap = [&](const Section& s, double side) -> Section {
        return {sum(s.centre, side * s.radius * std::sin(angle), s.axis), s.axis,
                s.radius * std::cos(angle)};
      };
      start.insert(start.begin(), cap(first, -1));
      end.push_back(cap(last, 1));
    }
    sections.insert(sections.begin(), start.begin(), start.end());
    sections.insert(sections.end(), end.begin(), end.end());
  }
};

/// Returns a closed mesh per branch, as thick as its vertices have their radii.
inline Tube_mesh tubes_of(const Written_skeleton& skeleton)
{
  Tube_mesh mesh;
  for(const Plain_branch& branch : skeleton.branches)
    mesh.add(skeleton.graph, branch);
  return mesh;
}

/// Points, then triangles, as OFF and PLY have them after their headers.
inline void write_mesh_rows(std::ostream& os, const Tube_mesh& mesh)
{
  for(const Plain_point& p : mesh.points)
    os << p << '\n';
  for(const auto& t : mesh.triangles)
    os << "3 " << t[0] << ' ' << t[1] << ' ' << t[2] << '\n';
}

/// Tubes as OFF.
inline void write_tubes_off(std::ostream& os, const Written_skeleton& skeleton)
{
  const Tube_mesh mesh = tubes_of(skeleton);
  os << "OFF\n" << mesh.points.size() << ' ' << mesh.triangles.size() << " 0\n";
  write_mesh_rows(os, mesh);
}

/// Tubes as PLY.
inline void write_tubes_ply(std::ostream& os, const Written_skeleton& skeleton)
{
  const Tube_mesh mesh = tubes_of(skeleton);
  os << "ply\nformat ascii 1.0\n"
     << "element vertex " << mesh.points.size() << '\n'
     << "property double x\nproperty double y\nproperty double z\n"
     << "element face " << mesh.triangles.size() << '\n'
     << "property list uchar int vertex_indices\nend_header\n";
  write_mesh_rows(os, mesh);
}

} // namespace internal
} // namespace Point_set_skeletonization_3
} // namespace CGAL

#endif // CGAL_POINT_SET_SKELETONIZATION_3_INTERNAL_IO_WRITE_TUBES_H
