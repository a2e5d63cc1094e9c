// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_PAGE_VIEWER_BUNDLE_H
#define TUBULAR_MESH_PAGE_VIEWER_BUNDLE_H

/* The script that shows the mesh, made from viewer/ when the program is built; empty where npm was not there, or could
 * not get what it needs. */
extern const char viewer_bundle[];

#endif // TUBULAR_MESH_PAGE_VIEWER_BUNDLE_H
