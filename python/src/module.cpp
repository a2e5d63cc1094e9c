// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The module tubular_meshing._core, on which the package in tubular_meshing/ builds: it has the names, the documentation
// and what Python does as well; here is what needs the library.

#include "errors.h"
#include "mesh.h"
#include "model.h"
#include "options.h"
#include "surface.h"

#include <pybind11/pybind11.h>

PYBIND11_MODULE(_core, module) {
  module.attr("version") = TUBULAR_MESHING_VERSION;
  translate_errors();
  add_options(module);
  add_surface(module);
  add_model(module);
  add_mesh(module);
}
