// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

/*! \file
 *
 * How the package is compiled, in CGAL's own manner. Its core is a library: `X.h` declares, `X_impl.h` beside it
 * defines, and a file of `src/` compiles the definitions once. Where `CGAL_TUBULAR_MESHING_HEADER_ONLY` is defined, as
 * the CMake target `CGAL::Tubular_meshing_header_only` does, `X.h` includes its `X_impl.h`, and nothing is linked.
 */

#ifndef CGAL_TUBULAR_MESHING_BASE_CONFIG_H
#define CGAL_TUBULAR_MESHING_BASE_CONFIG_H

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#define CGAL_TUBULAR_MESHING_INLINE inline
#else
#define CGAL_TUBULAR_MESHING_INLINE
#endif

#endif // CGAL_TUBULAR_MESHING_BASE_CONFIG_H
