// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "compared_columns.h"

#include <CGAL/version.h>
#include <boost/config.hpp>

#include <optional>
#include <sstream>
#include <string>

namespace {

using Column = Table<Compared>::Column;

Column text(const std::string& name, std::size_t width, std::string Compared::*member)
{
  return {name, width, [member](const Compared& row) { return row.*member; }};
}

Column number(const std::string& name, double Compared::*member, int digits)
{
  return {name, 5, [=](const Compared& row) { return fixed(row.*member, digits); }};
}

/// What is measured of a skeleton, if there is one.
template <typename Cell>
Column measured(const std::string& name, const Cell& cell)
{
  return {name, 4, [cell](const Compared& row) {
            return row.status == "ok" ? cell(row.measured) : std::string("-");
          }};
}

Column measured(const std::string& name, double Measurements::*member, int digits)
{
  return measured(name, [=](const Measurements& m) { return fixed(m.*member, digits); });
}

Column count(const std::string& name, std::size_t Graph_counts::*member)
{
  return measured(name, [=](const Measurements& m) { return std::to_string(m.got.*member); });
}

Column truth(const std::string& name, std::optional<std::size_t> Truth::*member)
{
  return {name, 4, [=](const Compared& row) {
            const std::optional<std::size_t>& value = row.measured.truth.*member;
            return value ? std::to_string(*value) : std::string("-");
          }};
}

Column spurs()
{
  return measured("spurs", [](const Measurements& m) { return std::to_string(m.spurs); });
}

Column seed()
{
  return {"seed", 4, [](const Compared& row) { return std::to_string(row.seed); }};
}

/// The same for all rows.
Column constant(const std::string& name, const std::string& value)
{
  return {name, 4, [value](const Compared&) { return value; }};
}

/// "contraction=1.234;thinning=0.120"
Column stages()
{
  return {"stages", 6, [](const Compared& row) {
            std::string cell;
            for(const auto& [name, seconds] : row.stages)
              cell += (cell.empty() ? "" : ";") + name + '=' + fixed(seconds, 3);
            return cell;
          }};
}

Column points()
{
  return {"points", 6,
          [](const Compared& row) { return row.cloud ? std::to_string(row.cloud->size()) : "-"; }};
}

std::string parameters(const Comparison_options& options)
{
  std::ostringstream out;
  out << "--points " << options.points << " --time-limit " << options.time_limit
      << (options.decimate ? " --decimate" : "");
  return out.str();
}

} // namespace

std::vector<Column> screen_columns()
{
  return {text("input", 12, &Compared::input),
          number("noise", &Compared::noise, 3),
          seed(),
          text("method", 25, &Compared::method),
          text("kind", 14, &Compared::input_kind),
          text("status", 10, &Compared::status),
          count("comp", &Graph_counts::components),
          truth("true", &Truth::components),
          count("cycles", &Graph_counts::cycles),
          truth("true", &Truth::cycles),
          count("ends", &Graph_counts::ends),
          count("junctions", &Graph_counts::junctions),
          measured("off_centre", &Measurements::off_centre, 3),
          measured("inside", &Measurements::inside, 4),
          spurs(),
          measured("unexplained", &Measurements::unexplained, 4),
          measured("moved", &Measurements::moved_mean, 4),
          number("seconds", &Compared::seconds, 2),
          number("MiB", &Compared::peak_memory, 0),
          text("message", 7, &Compared::message)};
}

std::vector<Column> file_columns(const Comparison_options& options)
{
  return {text("input", 0, &Compared::input),
          number("noise", &Compared::noise, 4),
          text("method", 0, &Compared::method),
          text("input_kind", 0, &Compared::input_kind),
          text("status", 0, &Compared::status),
          text("message", 0, &Compared::message),
          points(),
          stages(),
          number("seconds", &Compared::seconds, 3),
          number("peak_memory_mib", &Compared::peak_memory, 1),
          count("components", &Graph_counts::components),
          truth("components_true", &Truth::components),
          count("cycles", &Graph_counts::cycles),
          truth("cycles_true", &Truth::cycles),
          count("ends", &Graph_counts::ends),
          truth("ends_true", &Truth::ends),
          count("junctions", &Graph_counts::junctions),
          measured("off_centre", &Measurements::off_centre, 4),
          measured("inside", &Measurements::inside, 4),
          spurs(),
          measured("unexplained", &Measurements::unexplained, 4),
          measured("moved", &Measurements::moved_mean, 5),
          measured("moved_max", &Measurements::moved_maximum, 5),
          constant("parameters", parameters(options)),
          constant("compiler", BOOST_COMPILER "; CGAL " CGAL_VERSION_STR),
          seed()};
}
