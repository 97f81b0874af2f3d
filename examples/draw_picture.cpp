// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "draw_picture.h"

#include "cloud_view.h"

#include <CGAL/number_type_config.h>

#include <cairo-svg.h>
#include <cairo.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <locale>
#include <memory>
#include <sstream>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace {

using Vector = std::array<double, 3>;
using Colour = std::array<double, 3>;

constexpr double width = 1600, height = 860, margin = 50; // pixels
constexpr double bar_height = 60;                         // of the scale below, with its text
constexpr Colour white{1, 1, 1}, text_colour{0.4, 0.44, 0.5};
constexpr Colour junction_colour{0.84, 0.10, 0.11}, tip_colour{0.12, 0.56, 1};
constexpr Colour near_colour{0.68, 0.72, 0.77}, far_colour{0.89, 0.91, 0.93}; // of the cloud

Colour mixed(const Colour& a, const Colour& b, double share)
{
  Colour result;
  for(std::size_t k = 0; k < 3; ++k)
    result[k] = a[k] + share * (b[k] - a[k]);
  return result;
}

/// The colours of the radius, for shares in [0, 1]; those of the page.
Colour ramp(double share)
{
  constexpr std::array<Colour, 6> stops{{{0.106, 0.047, 0.478},
                                         {0.357, 0.008, 0.639},
                                         {0.604, 0.090, 0.608},
                                         {0.796, 0.275, 0.471},
                                         {0.922, 0.471, 0.322},
                                         {0.984, 0.655, 0.184}}};
  const double at = std::clamp(share, 0., 1.) * static_cast<double>(stops.size() - 1);
  const std::size_t i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  return mixed(stops[i], stops[i + 1], at - static_cast<double>(i));
}

/// A direction to look in: what is right, up and towards the viewer.
struct Axes
{
  Vector right{}, up{}, towards{};
};

double dot(const Vector& a, const Vector& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vector cross(const Vector& a, const Vector& b)
{
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vector sum(double a, const Vector& v, double b, const Vector& w)
{
  return {a * v[0] + b * w[0], a * v[1] + b * w[1], a * v[2] + b * w[2]};
}

/// From the broader side, then from an angle to the left and above, in degrees.
Axes axes_from(const Skeletonized_cloud& cloud, const Cloud_box& box, double left, double above)
{
  left *= CGAL_PI / 180;
  above *= CGAL_PI / 180;
  const std::size_t one = (cloud.up + 1) % 3, other = (cloud.up + 2) % 3;
  const std::size_t depth = box.size(one) < box.size(other) ? one : other;
  Vector vertical{}, towards{};
  vertical[cloud.up] = 1;
  towards[depth] = depth == 1 ? -1 : 1; // as most see a scan: x to the right
  towards = sum(std::cos(left), towards, -std::sin(left), cross(vertical, towards));
  Axes axes;
  axes.right = cross(vertical, towards);
  axes.towards = sum(std::cos(above), towards, std::sin(above), vertical);
  axes.up = cross(axes.towards, axes.right);
  return axes;
}

/// A place in a picture, and how near it is: less is farther.
struct Place
{
  double x = 0, y = 0, depth = 0;
};

/// One of the views: points of space to places in its frame.
class View
{
public:
  View(const Axes& axes, const std::vector<Vector>& all, double left, double frame_width)
      : axes_(axes)
  {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    double x0 = infinity, x1 = -infinity, y0 = infinity, y1 = -infinity;
    for(const Vector& p : all) {
      x0 = std::min(x0, dot(p, axes.right));
      x1 = std::max(x1, dot(p, axes.right));
      y0 = std::min(y0, dot(p, axes.up));
      y1 = std::max(y1, dot(p, axes.up));
    }
    const double room = frame_width - 2 * margin;
    const double tall = height - bar_height - 2 * margin;
    scale_ = std::min(room / std::max(x1 - x0, 1e-300), tall / std::max(y1 - y0, 1e-300));
    scale_ = scale_ < 1e200 ? scale_ : 1; // of a single point
    x_ = left + frame_width / 2 - scale_ * (x0 + x1) / 2;
    y_ = margin + tall / 2 + scale_ * (y0 + y1) / 2;
  }

  Place operator()(const Vector& p) const
  {
    return {x_ + scale_ * dot(p, axes_.right), y_ - scale_ * dot(p, axes_.up),
            dot(p, axes_.towards)};
  }

private:
  Axes axes_;
  double scale_ = 1, x_ = 0, y_ = 0;
};

/// Draws a cloud and its skeleton, from two sides.
class Picture
{
public:
  Picture(cairo_t* cairo, const Skeletonized_cloud& cloud, std::size_t most_dots)
      : cairo_(cairo)
      , cloud_(cloud)
  {
    const Cloud_box box = box_of(cloud);
    const auto relative = [&box](const Vector& p) -> Vector {
      return {p[0] - box.centre(0), p[1] - box.centre(1), p[2] - box.centre(2)};
    };
    for(std::size_t i : thinned(cloud.points.size(), most_dots))
      dots_.push_back(relative({cloud.points[i].x(), cloud.points[i].y(), cloud.points[i].z()}));
    for(const auto& v : cloud.skeleton.graph.vertices) {
      vertices_.push_back(relative(v.point));
      least_ = std::min(least_, v.radius);
      greatest_ = std::max(greatest_, v.radius);
    }
    std::vector<Vector> all = dots_;
    all.insert(all.end(), vertices_.begin(), vertices_.end());
    if(all.empty())
      all.push_back({});
    set(white);
    cairo_paint(cairo_);
    cairo_set_line_cap(cairo_, CAIRO_LINE_CAP_ROUND);
    cairo_set_line_join(cairo_, CAIRO_LINE_JOIN_ROUND);
    for(const auto& [left, from_left, from_above] :
        {std::make_tuple(0., 0., 0.), std::make_tuple(width / 2, 40., 20.)}) {
      const View view(axes_from(cloud, box, from_left, from_above), all, left, width / 2);
      draw_cloud(view);
      draw_skeleton(view);
      draw_marks(view);
    }
    if(!vertices_.empty())
      draw_scale();
  }

private:
  void set(const Colour& c) { cairo_set_source_rgb(cairo_, c[0], c[1], c[2]); }

  /// In layers from far to near, each with its shade of grey.
  void draw_cloud(const View& view)
  {
    constexpr std::size_t layers = 12;
    constexpr double dot_width = 2.6;
    std::vector<Place> places;
    for(const Vector& p : dots_)
      places.push_back(view(p));
    std::sort(places.begin(), places.end(), [](const Place& a, const Place& b) {
      return std::tie(a.depth, a.x, a.y) < std::tie(b.depth, b.x, b.y);
    });
    cairo_set_line_width(cairo_, dot_width);
    for(std::size_t layer = 0; layer < layers; ++layer) {
      for(std::size_t i = layer * places.size() / layers; i < (layer + 1) * places.size() / layers;
          ++i) {
        cairo_move_to(cairo_, places[i].x, places[i].y);
        cairo_close_path(cairo_); // of no length: a dot, by the round caps
      }
      set(mixed(far_colour, near_colour,
                static_cast<double>(layer) / static_cast<double>(layers - 1)));
      cairo_stroke(cairo_);
    }
  }

  double share_of(double radius) const
  {
    return greatest_ > least_ ? (radius - least_) / (greatest_ - least_) : 0;
  }

  /// Branch by branch from far to near, each over a wider white one: a crossing shows which of them
  /// is in front.
  void draw_skeleton(const View& view)
  {
    constexpr double line_width = 4.5, rim = 2;
    const auto& branches = cloud_.skeleton.branches;
    std::vector<std::pair<double, std::size_t>> by_depth;
    for(std::size_t b = 0; b < branches.size(); ++b) {
      double depth = 0;
      for(std::size_t v : branches[b].vertices)
        depth += view(vertices_[v]).depth;
      by_depth.emplace_back(depth / static_cast<double>(branches[b].vertices.size()), b);
    }
    std::sort(by_depth.begin(), by_depth.end());
    for(const auto& [depth, b] : by_depth) {
      trace(view, branches[b].vertices);
      cairo_set_line_width(cairo_, line_width + 2 * rim);
      set(white);
      cairo_stroke(cairo_);
      cairo_set_line_width(cairo_, line_width);
      draw_edges(view, branches[b].vertices);
    }
  }

  void trace(const View& view, const std::vector<std::size_t>& path)
  {
    for(std::size_t v : path) {
      const Place place = view(vertices_[v]);
      cairo_line_to(cairo_, place.x, place.y);
    }
  }

  void draw_edges(const View& view, const std::vector<std::size_t>& path)
  {
    for(std::size_t i = 1; i < path.size(); ++i) {
      trace(view, {path[i - 1], path[i]});
      const auto& vertices = cloud_.skeleton.graph.vertices;
      set(ramp(share_of((vertices[path[i - 1]].radius + vertices[path[i]].radius) / 2)));
      cairo_stroke(cairo_);
    }
  }

  /// Tips and lone vertices, then junctions, as dots with a white rim.
  void draw_marks(const View& view)
  {
    constexpr double dot_width = 9, rim = 2;
    const std::vector<std::size_t> degrees = degrees_of(cloud_);
    const auto draw = [&](bool junctions, const Colour& colour) {
      for(std::size_t v = 0; v < degrees.size(); ++v) {
        if(junctions ? degrees[v] < 3 : degrees[v] > 1)
          continue;
        const Place place = view(vertices_[v]);
        for(bool is_rim : {true, false}) {
          cairo_move_to(cairo_, place.x, place.y);
          cairo_close_path(cairo_);
          cairo_set_line_width(cairo_, is_rim ? dot_width + 2 * rim : dot_width);
          set(is_rim ? white : colour);
          cairo_stroke(cairo_);
        }
      }
    };
    draw(false, tip_colour);
    draw(true, junction_colour);
  }

  void write(const std::string& text, double x, double align)
  {
    cairo_text_extents_t extents;
    cairo_text_extents(cairo_, text.c_str(), &extents);
    set(text_colour);
    cairo_move_to(cairo_, x - align * extents.x_advance, height - margin + 26);
    cairo_show_text(cairo_, text.c_str());
  }

  /// What the colours mean.
  void draw_scale()
  {
    constexpr double bar_width = 360, bar_thickness = 10;
    const double x = (width - bar_width) / 2, y = height - margin - bar_thickness;
    const std::unique_ptr<cairo_pattern_t, decltype(&cairo_pattern_destroy)> gradient(
        cairo_pattern_create_linear(x, 0, x + bar_width, 0), cairo_pattern_destroy);
    constexpr int stops = 16;
    for(int i = 0; i <= stops; ++i) {
      const double share = static_cast<double>(i) / stops;
      const Colour c = ramp(share);
      cairo_pattern_add_color_stop_rgb(gradient.get(), share, c[0], c[1], c[2]);
    }
    cairo_rectangle(cairo_, x, y, bar_width, bar_thickness);
    cairo_set_source(cairo_, gradient.get());
    cairo_fill(cairo_);
    cairo_select_font_face(cairo_, "sans-serif", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo_, 17);
    const auto digits = [](double radius) {
      std::ostringstream text;
      text.imbue(std::locale::classic());
      text.precision(3);
      text << radius;
      return text.str();
    };
    write(digits(least_), x, 0);
    write("radius", x + bar_width / 2, 0.5);
    write(digits(greatest_), x + bar_width, 1);
  }

  cairo_t* cairo_;
  const Skeletonized_cloud& cloud_;
  std::vector<Vector> dots_, vertices_; ///< Relative to the centre of the box.
  double least_ = std::numeric_limits<double>::infinity(), greatest_ = 0; ///< Radii.
};

cairo_status_t write_bytes(void* os, const unsigned char* bytes, unsigned int size)
{
  auto& stream = *static_cast<std::ostream*>(os);
  stream.write(reinterpret_cast<const char*>(bytes), static_cast<std::streamsize>(size));
  return stream ? CAIRO_STATUS_SUCCESS : CAIRO_STATUS_WRITE_ERROR;
}

using Surface = std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)>;

void draw(const Surface& surface, const Skeletonized_cloud& cloud, std::size_t most_dots)
{
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()),
                                                                 cairo_destroy);
  Picture(cairo.get(), cloud, most_dots);
  if(const cairo_status_t status = cairo_status(cairo.get()))
    throw std::runtime_error(std::string("cannot draw a picture: ") +
                             cairo_status_to_string(status));
}

} // namespace

void write_png(std::ostream& os, const Skeletonized_cloud& cloud)
{
  const Surface surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, static_cast<int>(width),
                                                   static_cast<int>(height)),
                        cairo_surface_destroy);
  draw(surface, cloud, 30000);
  cairo_surface_write_to_png_stream(surface.get(), write_bytes, &os);
}

void write_svg(std::ostream& os, const Skeletonized_cloud& cloud)
{
  const Surface surface(cairo_svg_surface_create_for_stream(write_bytes, &os, width, height),
                        cairo_surface_destroy);
  draw(surface, cloud, 6000);
  cairo_surface_finish(surface.get());
}
