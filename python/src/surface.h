// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_SURFACE_H
#define TUBULAR_MESHING_PYTHON_SURFACE_H

#include "tubular_mesh/Stage_clock.h"

#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>

#include <pybind11/pybind11.h>

#include <memory>

namespace py = pybind11;

/* What repair has made of a surface. */
struct Repaired_surface {
  CGAL::Tubular_meshing::Surface surface;
  CGAL::Tubular_meshing::Repair_report report;
  Stage_clock clock = Stage_clock();
};

/* A surface as it came: triangles, their labels, values at the points; and repaired, if it is. */
struct Python_surface {
  std::shared_ptr<const CGAL::Tubular_meshing::IO::Surface_data> data;
  std::shared_ptr<const Repaired_surface> repaired;
};

void add_surface(py::module_& module);

#endif // TUBULAR_MESHING_PYTHON_SURFACE_H
