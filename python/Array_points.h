// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_PYTHON_ARRAY_POINTS_H
#define POINT_SET_SKELETONIZATION_3_PYTHON_ARRAY_POINTS_H

#include <CGAL/Simple_cartesian.h>

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <boost/property_map/property_map.hpp>

#include <cstddef>
#include <cstring>
#include <string>

/// A property map from the number of a row to the point in it: reads an array of any layout,
/// without a copy. The array must outlive it.
template <typename Number>
class Array_points
{
public:
  using key_type = std::size_t;
  using value_type = CGAL::Simple_cartesian<double>::Point_3;
  using reference = value_type;
  using category = boost::readable_property_map_tag;

  explicit Array_points(const pybind11::array& array)
      : data_(static_cast<const char*>(array.data()))
      , row_(array.strides(0))
      , column_(array.strides(1))
  {}

  friend value_type get(const Array_points& map, std::size_t row)
  {
    const char* place = map.data_ + static_cast<std::ptrdiff_t>(row) * map.row_;
    Number xyz[3];
    for(std::ptrdiff_t k = 0; k < 3; ++k) // maybe not aligned
      std::memcpy(&xyz[k], place + k * map.column_, sizeof(Number));
    return value_type(xyz[0], xyz[1], xyz[2]);
  }

private:
  const char* data_;
  std::ptrdiff_t row_, column_; ///< Bytes from one to the next.
};

/// Returns whatever numpy can make an array of numbers from, as an array of shape (n, 3) of float32
/// or float64; the same array if it is one. \throw pybind11::value_error,
/// pybind11::error_already_set
inline pybind11::array to_point_array(const pybind11::object& points)
{
  namespace py = pybind11;
  py::array array = py::array::ensure(points);
  if(!array)
    throw py::value_error("points are no array: they must be numbers of shape (n, 3)");
  if(array.ndim() != 2 || array.shape(1) != 3) {
    std::string shape;
    for(py::ssize_t k = 0; k < array.ndim(); ++k)
      shape += std::to_string(array.shape(k)) + (k + 1 < array.ndim() ? ", " : "");
    throw py::value_error("points must be an array of shape (n, 3), not (" + shape + ")");
  }
  if(py::isinstance<py::array_t<float>>(array) || py::isinstance<py::array_t<double>>(array))
    return array;
  if(std::string("fiub").find(array.dtype().kind()) == std::string::npos)
    throw py::value_error("points must be real numbers, not " +
                          std::string(py::str(array.dtype())));
  return py::array_t<double>::ensure(array);
}

#endif // POINT_SET_SKELETONIZATION_3_PYTHON_ARRAY_POINTS_H
