// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_H

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Hexahedra/Block_structure.h>
#include <CGAL/Tubular_meshing/Hexahedra/Optimize_hexahedra_options.h>
#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/config.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/parameters.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingHexahedra
 * The named parameters of make_hexahedral_blocks(), as a struct. */
struct Hexahedral_blocks_options {
  double points_per_circumference = 24;
  double layer_thickness = 0;
  int number_of_threads = 0;

  Hexahedral_blocks_options() = default;
  template <class NamedParameters> explicit Hexahedral_blocks_options(const NamedParameters& np) {
    points_per_circumference = internal::choose(np, internal_np::points_per_circumference, points_per_circumference);
    layer_thickness = internal::choose(np, internal_np::layer_thickness, layer_thickness);
    number_of_threads = internal::choose(np, internal_np::number_of_threads, number_of_threads);
  }
};

/*! \ingroup PkgTubularMeshingHexahedra
 * A place where no blocks would fit, and why. */
struct Refused_blocks {
  Point_3 place;
  std::string reason;                        ///< a sentence
  std::vector<Surface::Vertex_index> missed; ///< of the surface: those of a vessel without a centerline, the farthest
                                             ///< first; else none
  bool is_junction = false;
  bool can_be_left_out = false; ///< it is a junction, or a vessel's end: the vessels may have blocks up to there
};

/*! \ingroup PkgTubularMeshingHexahedra
 * The hexahedra along the vessels of a surface, or why there are none. */
struct Hexahedral_blocks {
  /// Hexahedra of region labels::lumen; quads of the wall and of the openings. Between the core of a vessel and its wall
  /// there is one hexahedron, see insert_wall_layers(). Not to be used if something was refused.
  Mixed_mesh mesh;
  std::vector<Refused_blocks> refused; ///< none if all went well

  Block_structure structure; ///< its vertices are numbers of points of the mesh

  std::size_t points_per_circumference = 0; ///< a multiple of eight
  std::size_t junctions = 0;                ///< of vessels; ends are none
  std::size_t irregular_edges = 0;          ///< of the blocks, inside of the lumen, round which there are not four
  std::vector<double> twist;                ///< of each vessel, from end to end, in radians
  Optimize_hexahedra_report optimization;
};

namespace internal {

/* N as blocks have it: a multiple of eight. */
inline int blocks_points(double points_per_circumference) {
  return 8 * (std::max)(1, int(std::lround(points_per_circumference / 8)));
}

Hexahedral_blocks make_hexahedral_blocks(const Surface& surface, Face_patch_map patch, const Centerline_graph& graph,
                                         Length_function size, const Hexahedral_blocks_options& options);

/* How long blocks are: rows of hexahedra along all vessels, each of 4 s^2 + 8 s where N = 8 s, and blind ends, whose tips
 * have 4 s^2 beyond. */
struct Length_of_blocks {
  std::size_t rows = 0, domes = 0;
};

/* The same without making hexahedra that are of use: fast with eight points round a vessel, on which rows do not depend.
 * None where blocks are refused. */
std::optional<Length_of_blocks> length_of_blocks(const Surface& surface, Face_patch_map patch,
                                                 const Centerline_graph& graph, Length_function size,
                                                 const Hexahedral_blocks_options& options);

} // namespace internal

/*! \ingroup PkgTubularMeshingHexahedra
 *
 * fills the lumen of a vessel tree or network with hexahedra alone, in blocks along the vessels.
 *
 * A vessel's cross-section is an O-grid: a core of four squares round the centerline, s times s quads each, and a ring
 * round the core, N = 8 s quads, up to the wall. Where k vessels meet, the sphere of directions round the junction is
 * divided into one four-sided region a vessel, as the dual of a graph on the convex hull of the vessels' directions in
 * which each direction has four edges (see \cgalCite{viville2021}); every two regions that are neighbors share a quarter
 * of their sections, which spans from the junction's center to the wall, at the crotch between the two vessels. Three
 * vessels, or more in one plane, get two poles and a half-disk between each two neighbors. So each wall has two vertices
 * of six quads at a bifurcation, and none elsewhere. There is no global condition: networks may have loops.
 *
 * Sections are found by rays from the centerline to the wall, and are planar but near junctions; they are turned along
 * a vessel by less than an eighth of a circle, from one junction's corners to the next one's. Of several ways to place
 * a junction's center and corners, the one that gives the best hexahedra is taken; some begin where the wall comes between
 * the vessels, for those that part slowly. Blind ends get a cap of the core's squares and the ring round it. Then
 * optimize_hexahedra() does the rest. It is checked for each junction that its hexahedra fill the lumen, all of it and once.
 *
 * Junctions that are nearer to each other than about their radius are one junction. One of more than eight vessels is
 * refused, as is a surface with a part that no vessel of the network reaches, such as a sac without a centerline.
 *
 * O(n log n) in the faces of the surface and the hexahedra.
 *
 * \tparam FaceGraph a model of `FaceListGraph`
 * \tparam FacePatchMap a readable property map from its faces to `int`
 * \tparam SizingField a function object: the wanted length of edges at a `Point_3`, such as Centerline_sizing_field
 *
 * \param surface closed, turned outward, with flat caps on its openings
 * \param patch labels::wall, or the label of an opening
 * \param graph the centerlines of its vessels
 * \param size rows of hexahedra along a vessel are as high as the size at its centerline
 * \param np an optional sequence of named parameters among the ones listed below
 *
 * \cgalNamedParamsBegin
 *   \cgalParamNBegin{points_per_circumference}
 *     \cgalParamDescription{N: it is rounded to a multiple of 8}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{24}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{layer_thickness}
 *     \cgalParamDescription{of layers that insert_wall_layers() is to put into the ring, in local radii: the core leaves
 *       room for them}
 *     \cgalParamType{`double`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{number_of_threads}
 *     \cgalParamDescription{0: all cores. The result does not depend on it}
 *     \cgalParamType{`int`}
 *     \cgalParamDefault{0}
 *   \cgalParamNEnd
 *   \cgalParamNBegin{vertex_point_map}
 *     \cgalParamDescription{the points of the surface's vertices}
 *     \cgalParamType{a model of `ReadablePropertyMap`}
 *     \cgalParamDefault{`boost::get(CGAL::vertex_point, surface)`}
 *   \cgalParamNEnd
 * \cgalNamedParamsEnd
 *
 * \throws Parameter_error if N is less than 8, or the layers are thicker than 0.8 radii
 */
template <class FaceGraph, class FacePatchMap, class SizingField,
          class NamedParameters = CGAL::parameters::Default_named_parameters>
Hexahedral_blocks make_hexahedral_blocks(const FaceGraph& surface, FacePatchMap patch, const Centerline_graph& graph,
                                         const SizingField& size,
                                         const NamedParameters& np = CGAL::parameters::default_values()) {
  const internal::Core_labelled_surface<FaceGraph, FacePatchMap, NamedParameters> core(surface, patch, np);
  return internal::make_hexahedral_blocks(core.surface(), core.patch(), graph,
                                          internal::Field_at_point<SizingField>(size), Hexahedral_blocks_options(np));
}

} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Hexahedra/hexahedral_blocks_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_HEXAHEDRAL_BLOCKS_H
