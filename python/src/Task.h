// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_TASK_H
#define TUBULAR_MESHING_PYTHON_TASK_H

#include "tubular_mesh/Stage_clock.h"

#include <CGAL/Tubular_meshing/base/interruption.h>

#include <pybind11/pybind11.h>

#include <string>

namespace py = pybind11;

// A signal that has come in the meantime becomes the exception of its handler, such as KeyboardInterrupt.
inline void raise_signals() {
  if (PyErr_CheckSignals() != 0)
    throw py::error_already_set();
}

/* Runs work(Stage_clock&) without Python's lock, so that other threads go on. `progress`, a callable or None, receives
 * the name of each stage; what it raises ends the work, and so does a signal. The work must not touch Python. */
template <class Work> auto run_task(const py::object& progress, const Work& work) {
  Stage_clock clock([&](const std::string& stage) {
    const py::gil_scoped_acquire lock;
    raise_signals();
    if (!progress.is_none())
      progress(stage);
  });
  const py::gil_scoped_release unlocked;
  const CGAL::Tubular_meshing::Interruption_check check([] {
    const py::gil_scoped_acquire lock;
    raise_signals();
  });
  return work(clock);
}

#endif // TUBULAR_MESHING_PYTHON_TASK_H
