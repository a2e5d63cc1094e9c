// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Patches/Indexed_patch_impl.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization_impl.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch_impl.h>
