// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include <CGAL/Tubular_meshing/Repair/internal/unite_parts_impl.h>
