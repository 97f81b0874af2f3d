// Copyright (c) 2026 The Point_set_skeletonization_3 authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef POINT_SET_SKELETONIZATION_3_PYTHON_RUN_WITH_PROGRESS_H
#define POINT_SET_SKELETONIZATION_3_PYTHON_RUN_WITH_PROGRESS_H

#include <pybind11/pybind11.h>

#include <exception>
#include <functional>
#include <stdexcept>

/// Runs `run(callback)` without Python's lock, so that other Python threads go on. The callback
/// lets Ctrl-C and `progress`, if it is not None, cancel; what either raises is raised here. \throw
/// std::runtime_error if `progress` returned False
template <typename Run>
void run_with_progress(const pybind11::object& progress, const Run& run)
{
  namespace py = pybind11;
  std::exception_ptr raised;
  const std::function<bool(double)> callback = [&](double fraction) {
    const py::gil_scoped_acquire lock;
    try {
      if(PyErr_CheckSignals() != 0)
        throw py::error_already_set();
      return progress.is_none() || !progress(fraction).is(py::bool_(false));
    } catch(const py::error_already_set&) {
      raised = std::current_exception();
      return false;
    }
  };
  bool is_done;
  {
    const py::gil_scoped_release unlock;
    is_done = run(callback);
  }
  if(raised)
    std::rethrow_exception(raised);
  if(!is_done)
    throw std::runtime_error("cancelled, because progress() returned False");
}

#endif // POINT_SET_SKELETONIZATION_3_PYTHON_RUN_WITH_PROGRESS_H
