// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_PYTHON_ERRORS_H
#define TUBULAR_MESHING_PYTHON_ERRORS_H

// The package's exceptions become those of tubular_meshing._errors.
void translate_errors();

#endif // TUBULAR_MESHING_PYTHON_ERRORS_H
