// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H

#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks.h>
#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesh_estimate.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher_options.h>

#include <algorithm>
#include <cmath>

namespace CGAL::Tubular_meshing::internal {

/* Coefficients of a lumen's integrals, by type of mesh; benchmark/Tubular_meshing/calibrate_estimate.py prints them.
 * Where theory gives one it is near: 2.31 equilateral triangles, or one square, on a square of the mesh size. */
struct Element_counts {
  // facets of a square of the mesh size; on openings, less some for a length of it along their rims
  static constexpr double triangles_on_wall = 2.43, triangles_on_caps = 2.67, triangles_on_rims = -0.53;
  static constexpr double quads_on_wall = 1.01;
  static constexpr double metric_triangles_on_wall = 2.45, metric_triangles_on_caps = 1.98;

  /* Tetrahedra of a cube of the mesh size inside, and of a square of it on the wall. Where layers of this thickness, in
   * local radii, are between the wall and them, the facets there are smaller. */
  static double between_triangles(const Lumen_integrals& n) {
    const double layers = n.layer_thickness;
    return layers > 0 ? positive(9.59 * n.inner_cubes + (0.31 + 8.42 * layers * layers) * n.wall_squares)
                      : positive(9.43 * n.cubes + 0.33 * n.wall_squares - 1.55 * n.cap_squares);
  }
  static double between_pyramids(const Lumen_integrals& n) {
    const double layers = n.layer_thickness;
    return layers > 0 ? positive(7.86 * n.inner_cubes + (1.35 + 8.6 * layers) * n.wall_squares)
                      : positive(8.33 * n.cubes + 0.79 * n.wall_squares);
  }
  static double anisotropic(const Lumen_integrals& n) { return positive(10.44 * n.metric_cubes); }
  static double cap_triangles(const Lumen_integrals& n) {
    return positive(triangles_on_caps * n.cap_squares + triangles_on_rims * n.rims);
  }

private:
  static double positive(double x) { return (std::max)(x, 1.); }
};

/* The layers along the wall, inside: how many there are, and how thick they are together, in local radii. */
struct Layers_in_lumen {
  int number = 0;
  double thickness = 0;

  explicit Layers_in_lumen(const Mesher_options& options) {
    if (!options.has_boundary_layer())
      return;
    const Boundary_layer_heights heights(options.boundary_layer);
    number = heights.layers;
    thickness = (std::min)(heights.total(), 0.95);
  }
};

/* Whether a mesh has elements of unit size in the metric. */
inline bool has_metric(Mesh_type type, Surface_elements elements) {
  return type == Mesh_type::anisotropic || elements == Surface_elements::anisotropic_triangles;
}

/* Whether it is to be in blocks along the vessels. */
inline bool is_in_blocks(Mesh_type type, Surface_elements elements, const Mesher_options& options) {
  return (type == Mesh_type::hexahedral && options.hexahedral_method == Hexahedral_method::blocks) ||
         (type == Mesh_type::surface && elements == Surface_elements::structured_quads);
}

/* How much larger the mesh size of a coarse mesh is: by a factor, if a vessel has so many points round it then. */
inline double coarsening(double factor, double points, double fewest_points) {
  return (std::min)((std::max)(points / fewest_points, 1.), factor);
}
// Of what is to be subdivided: as many hexahedra come as tetrahedra otherwise.
inline double coarsening_for_subdivision(double points) {
  const double cube_root_of_four = 1.5874;
  return coarsening(cube_root_of_four, points, 6);
}
// Of triangles that are to be remeshed, and of the tetrahedra between them.
inline double coarsening_for_remeshing(double points) {
  return coarsening(1.5, points, 12);
}
constexpr double coarsening_inside_for_remeshing = 2;

/* A lumen's integrals with a mesh size that is larger by a factor. */
inline Lumen_integrals coarser(Lumen_integrals n, double factor) {
  n.cubes /= std::pow(factor, 3);
  n.inner_cubes /= std::pow(factor, 3);
  n.wall_squares /= factor * factor;
  n.cap_squares /= factor * factor;
  n.rims /= factor;
  return n;
}

/* The facets of triangles, and what is between them and layers of prisms. */
inline void count_between_triangles(Mesh_estimate& e, const Lumen_integrals& n, int layers) {
  typedef Element_counts C;
  e.wall_triangles = C::triangles_on_wall * n.wall_squares;
  e.cap_triangles = C::cap_triangles(n);
  e.cap_quads = layers * n.rims;
  e.prisms = layers * e.wall_triangles;
  e.tetrahedra = C::between_triangles(n);
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
    e.tetrahedra = C::anisotropic(n);
  } else if (type == Mesh_type::mixed) {
    e.wall_quads = C::quads_on_wall * n.wall_squares;
    e.cap_triangles = C::cap_triangles(n);
    e.cap_quads = layers * n.rims;
    e.pyramids = e.wall_quads;
    e.hexahedra = layers * e.wall_quads;
    e.tetrahedra = C::between_pyramids(n);
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
    e.cap_triangles = C::cap_triangles(n);
  }
}

/* What a mesh takes: microseconds and bytes of a cell, and of a triangle of the surface. */
struct Mesh_costs {
  struct Cost {
    double time, memory;
  };
  static constexpr Cost tetrahedron{18, 230}, of_metric{112, 264}, mixed{28, 240}, in_blocks{40, 430},
      subdivided{60, 450}, in_layers{14, 180}, facet{25, 300}; // of a surface mesh alone
  static constexpr Cost triangle{15, 700}, triangle_and_metric{87, 1900};
};

inline void estimate_cost(Mesh_estimate& e, Mesh_type type, double triangles) {
  typedef Mesh_costs C;
  const bool is_hexahedral = type == Mesh_type::hexahedral;
  const C::Cost cell = type == Mesh_type::isotropic                 ? C::tetrahedron
                       : type == Mesh_type::anisotropic             ? C::of_metric
                       : type == Mesh_type::mixed                   ? C::mixed
                       : !is_hexahedral                             ? C::facet
                       : e.method == Hexahedral_method::subdivision ? C::subdivided
                                                                    : C::in_blocks;
  const C::Cost triangle = type == Mesh_type::anisotropic ? C::triangle_and_metric : C::triangle;
  const double in_layers = is_hexahedral ? 0 : e.prisms + e.hexahedra;
  const double others = type == Mesh_type::surface ? e.facets() : e.cells() - in_layers;
  e.seconds = 1e-6 * (triangle.time * triangles + cell.time * others + C::in_layers.time * in_layers);
  e.bytes = Mesh_estimate::bytes_of_program + triangle.memory * triangles + cell.memory * others +
            C::in_layers.memory * in_layers;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_ELEMENT_COUNTS_H
