// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H
#define CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H

#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/Patches/Patch_parameterization.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Patches/Surface_patch.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Curve_divider.h>
#include <CGAL/Tubular_meshing/Patches/pieces/Remeshed_piece.h>

#include <cstddef>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* Meshes the pieces of a cut surface, each on its own: the patches and, after them, the caps. Each can be meshed again
 * with smaller sizes. What faces they get is up to the class derived. */
class Piece_mesher {
public:
  typedef Patch_parameterization Map;
  typedef Remeshed_piece Piece;
  typedef std::vector<Curve_position> Curve_points;
  typedef std::size_t size_type;

  /* Throws Input_error if there is not one parameterization a patch. */
  Piece_mesher(const Surface& surface, const Surface_cut& cut, const std::vector<Map>& maps, int threads);
  virtual ~Piece_mesher() = default;
  Piece_mesher(const Piece_mesher&) = delete;
  Piece_mesher& operator=(const Piece_mesher&) = delete;

  void mesh_all() { mesh(std::vector<char>(pieces_.size(), 1)); }

  /* Meshes some pieces finer, and with them their curves and the pieces beyond these. */
  void mesh_finer(const std::vector<size_type>& pieces);

  /* Raises the worst faces of a surface made of the pieces, of which `piece_of_face` tells where each face is from.
   * Returns the pieces where faces are turned over even so. */
  virtual std::vector<size_type> improve(Remeshed_surface& result,
                                         const std::vector<size_type>& piece_of_face) const = 0;

  /* A piece whose loops touch each other in the plane, since they are divided too coarsely, has no faces. */
  const std::vector<Piece>& pieces() const { return pieces_; }
  const std::vector<Curve_points>& curve_points() const { return curve_points_; }

  bool is_cap(size_type piece) const { return piece >= maps_.size(); }
  // The label of the opening that a piece is the cap of; 0 for a patch.
  int opening(size_type piece) const { return is_cap(piece) ? cut_.curves[rim_of_cap(piece)].opening : 0; }
  size_type number_of_refined_pieces() const;
  std::string name_of(size_type piece) const;

protected:
  /* Sets curve_points_ again: of the curves beside concerned pieces at least, and marks the pieces beside all others
   * that it changes. */
  virtual void divide_curves(std::vector<char>& concerned) = 0;
  /* Fills an empty piece. False if its loops touch each other in the plane. Several threads call it at once. */
  virtual bool mesh_patch(size_type patch, Piece& piece) = 0;
  virtual bool mesh_cap(size_type cap, Piece& piece) = 0;

  size_type rim_of_cap(size_type piece) const { return rims_[piece - maps_.size()]; }
  size_type piece_on_the_right(size_type curve) const;
  // What the size on a curve is multiplied by.
  double fineness_of_curve(size_type curve) const;

  /* The loops of a patch in the plane, the outer one first; the piece gets its sides. */
  Plane_polygons patch_polygons(size_type patch, Piece& piece) const;
  /* The points of a rim in the plane of its cap, counterclockwise; the piece gets its side. */
  Plane_polygons cap_polygons(size_type cap, const Cap_chart& chart, Piece& piece) const;

  const Surface& surface_;
  const Surface_cut& cut_;
  const std::vector<Map>& maps_;
  const int threads_;
  std::vector<std::vector<Point_3>> polylines_; // the curves
  std::vector<size_type> rims_;                 // those with caps
  std::vector<Curve_points> curve_points_;
  std::vector<Piece> pieces_;
  std::vector<double> fineness_; // of pieces: what their sizes are multiplied by

private:
  void mesh(std::vector<char> concerned);
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/Patches/pieces/Piece_mesher_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_PATCHES_PIECES_PIECE_MESHER_H
