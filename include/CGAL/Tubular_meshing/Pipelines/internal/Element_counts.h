// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H

#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* Coefficients of a lumen's integrals, by type of mesh; benchmark/Tubular_meshing/calibrate_estimate.py prints them.
 * Where theory gives one it is near: 2.31 equilateral triangles, or one square, on a square of the mesh size. */
struct Element_counts {
  static constexpr double triangles_on_wall = 2.31, triangles_on_caps = 2.31;
  static constexpr double quads_on_wall = 1;
  static constexpr double metric_triangles_on_wall = 2.31, metric_triangles_on_caps = 2.31;

  /* Of tetrahedra, for each cube of the mesh size inside, and for each facet of the boundary. */
  struct Filling {
    double cube, wall, cap;
  };
  static constexpr Filling isotropic{6.5, 0.5, 0.5}; // between triangles
  static constexpr Filling within_layers{6.5, 0.5, 0.5};
  static constexpr Filling mixed{6.5, 1, 0.5}; // between pyramids on quads
  static constexpr Filling anisotropic{6.5, 0.5, 0.5};

  static double tetrahedra(const Filling& filling, double cubes, double wall, double caps) {
    return (std::max)(filling.cube * cubes + filling.wall * wall + filling.cap * caps, 1.);
  }
};

/* A lumen's integrals with a mesh size that is larger by a factor. */
inline Lumen_integrals coarser(Lumen_integrals n, double factor) {
  n.cubes /= std::pow(factor, 3);
  n.inner_cubes /= std::pow(factor, 3);
  n.wall_squares /= factor * factor;
  n.cap_squares /= factor * factor;
  n.inner_caps /= factor * factor;
  n.rims /= factor;
  return n;
}

/* The facets of triangles, and what is between them and layers of prisms. */
inline void count_between_triangles(Mesh_estimate& e, const Lumen_integrals& n, int layers) {
  typedef Element_counts C;
  e.wall_triangles = C::triangles_on_wall * n.wall_squares;
  e.cap_triangles = C::triangles_on_caps * n.inner_caps;
  e.cap_quads = layers * n.rims;
  e.prisms = layers * e.wall_triangles;
  e.tetrahedra = C::tetrahedra(layers > 0 ? C::within_layers : C::isotropic, n.inner_cubes, e.wall_triangles,
                               e.cap_triangles);
}

/* Of blocks with s x s quads in a quarter of a vessel's core; each layer adds a hexahedron to each quad of the wall. */
inline void count_in_blocks(Mesh_estimate& e, double s, int layers, double openings) {
  const double rows = e.integrals.rows_of_blocks, domes = e.integrals.domes_of_blocks;
  e.wall_quads = 8 * s * rows + 4 * s * s * domes;
  e.cap_quads = openings * (4 * s * s + 8 * s * (1 + layers));
  e.hexahedra = (4 * s * s + 8 * s) * rows + 4 * s * s * domes + layers * e.wall_quads;
}

/* Cells of a lumen. `points`: round a vessel; `coarsening`: of what is to be subdivided. */
inline void count_cells(Mesh_estimate& e, Mesh_type type, int layers, double points, double coarsening,
                        double openings) {
  typedef Element_counts C;
  const Lumen_integrals& n = e.integrals;
  if (type == Mesh_type::isotropic)
    count_between_triangles(e, n, layers);
  else if (type == Mesh_type::anisotropic) {
    e.wall_triangles = C::metric_triangles_on_wall * n.metric_wall;
    e.cap_triangles = C::metric_triangles_on_caps * n.metric_caps;
    e.tetrahedra = C::tetrahedra(C::anisotropic, n.metric_cubes, e.wall_triangles, e.cap_triangles);
  } else if (type == Mesh_type::mixed) {
    e.wall_quads = C::quads_on_wall * n.wall_squares;
    e.cap_triangles = C::triangles_on_caps * n.inner_caps;
    e.cap_quads = layers * n.rims;
    e.pyramids = e.wall_quads;
    e.hexahedra = layers * e.wall_quads;
    e.tetrahedra = C::tetrahedra(C::mixed, n.inner_cubes, e.wall_quads, e.cap_triangles);
  } else if (e.method == Hexahedral_method::blocks)
    count_in_blocks(e, blocks_points(points) / 8., layers, openings);
  else { // four of a tetrahedron, three of a prism, of the quads on them three of a triangle
    Mesh_estimate coarse;
    count_between_triangles(coarse, coarser(n, coarsening), layers);
    e.hexahedra = 4 * coarse.tetrahedra + 3 * coarse.prisms;
    e.wall_quads = 3 * coarse.wall_triangles;
    e.cap_quads = 3 * coarse.cap_triangles + 2 * coarse.cap_quads;
  }
}

/* Of a surface mesh. */
inline void count_facets(Mesh_estimate& e, Surface_elements elements, double points, double openings) {
  typedef Element_counts C;
  const Lumen_integrals& n = e.integrals;
  if (elements == Surface_elements::structured_quads) {
    count_in_blocks(e, blocks_points(points) / 8., 0, openings);
    e.hexahedra = 0;
  } else if (elements == Surface_elements::anisotropic_triangles) {
    e.wall_triangles = C::metric_triangles_on_wall * n.metric_wall;
    e.cap_triangles = C::metric_triangles_on_caps * n.metric_caps;
  } else {
    (elements == Surface_elements::quads ? e.wall_quads : e.wall_triangles) =
        (elements == Surface_elements::quads ? C::quads_on_wall : C::triangles_on_wall) * n.wall_squares;
    e.cap_triangles = C::triangles_on_caps * n.cap_squares;
  }
}

/* What a mesh takes. Of a surface of so many triangles; the program and what it has read come to `bytes_of_surface`. */
struct Mesh_costs {
  // microseconds of a cell, bytes of a cell
  struct Cell {
    double time, memory;
  };
  static constexpr Cell isotropic{60, 400}, anisotropic{250, 600}, mixed{150, 500}, blocks{30, 450}, subdivision{60, 500},
      prisms{15, 250}, facet{15, 300};
  static constexpr double microseconds_of_triangle = 10, bytes_of_triangle = 900, bytes_of_program = 20e6;
};

inline void estimate_cost(Mesh_estimate& e, Mesh_type type, double triangles) {
  typedef Mesh_costs C;
  const bool in_blocks = e.method == Hexahedral_method::blocks;
  const C::Cell filling = type == Mesh_type::isotropic     ? C::isotropic
                          : type == Mesh_type::anisotropic ? C::anisotropic
                          : type == Mesh_type::mixed       ? C::mixed
                          : in_blocks                      ? C::blocks
                                                           : C::subdivision;
  const double layers = type == Mesh_type::hexahedral ? e.prisms : e.prisms + e.hexahedra;
  const double filled = e.cells() - layers;
  e.seconds = 1e-6 * (C::microseconds_of_triangle * triangles + filling.time * filled + C::prisms.time * layers +
                      C::facet.time * e.facets());
  e.bytes = C::bytes_of_program + C::bytes_of_triangle * triangles + filling.memory * filled +
            C::prisms.memory * layers + C::facet.memory * e.facets();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H
