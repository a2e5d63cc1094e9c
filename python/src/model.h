// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_MODEL_H
#define TUBULAR_MESHING_PYTHON_MODEL_H

#include "surface.h"
#include "tubular_mesh/execute.h"

#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <pybind11/pybind11.h>

#include <memory>
#include <optional>

namespace py = pybind11;

/* The vessels of a surface, ready to be meshed, as often as one likes. */
struct Python_model {
  std::shared_ptr<const CGAL::Tubular_meshing::IO::Surface_data> data; // the sizes that it has at its points
  Prepared prepared;
  Stage_clock clock = Stage_clock();
  std::optional<CGAL::Tubular_meshing::Tubular_model> joined; // of several vessels

  const CGAL::Tubular_meshing::Tubular_model& whole() const {
    return joined ? *joined : prepared.parts.front().run.model;
  }
};

void add_model(py::module_& module);

#endif // TUBULAR_MESHING_PYTHON_MODEL_H
