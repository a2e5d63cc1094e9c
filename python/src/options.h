// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_OPTIONS_H
#define TUBULAR_MESHING_PYTHON_OPTIONS_H

#include "tubular_mesh/Options.h"

#include <pybind11/pybind11.h>

#include <string>
#include <vector>

namespace py = pybind11;

/* The options that arguments of tubular_mesh ask for, such as `--threads=2`, by its own declarations; neither a surface
 * nor an output need be among them. Throws a Parameter_error, with the sentence that the tool prints. */
Options parse_options(std::vector<std::string> arguments);

void add_options(py::module_& module);

#endif // TUBULAR_MESHING_PYTHON_OPTIONS_H
