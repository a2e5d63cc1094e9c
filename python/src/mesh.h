// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_MESH_H
#define TUBULAR_MESHING_PYTHON_MESH_H

#include <pybind11/pybind11.h>

void add_mesh(pybind11::module_& module);

#endif // TUBULAR_MESHING_PYTHON_MESH_H
