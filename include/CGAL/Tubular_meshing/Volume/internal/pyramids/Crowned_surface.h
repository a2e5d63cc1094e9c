// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWNED_SURFACE_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWNED_SURFACE_H

#include <CGAL/Tubular_meshing/Volume/internal/pyramids/Quad_crown.h>
#include <CGAL/Tubular_meshing/base/crossing_pairs.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* A closed surface with a pyramid on the inside of each of its quads, and the surface that is left: its own triangles
 * and the sides of the pyramids, without quads.
 *
 * Pyramids that meet others, or triangles, are lowered until they do not, all of those concerned by the same factor, so
 * that they share the gap. While that is done, they are higher than they are going to be: tetrahedra need room between
 * them. As a pyramid that is lowered stays within what it was, only those that met another one can still meet any. */
class Crowned_surface {
public:
  typedef Surface::Vertex_index Vertex;
  typedef Surface::Face_index Face;
  typedef std::vector<std::size_t> Quads; // sorted

  // Of the pyramids' sides in patch(): no label of a user's.
  static constexpr int side_label = (std::numeric_limits<int>::min)();

  // Of a mesh of nothing but triangles and quads.
  explicit Crowned_surface(const Mixed_mesh& mesh)
      : triangles_(mesh.triangles.size()) {
    crowns_.reserve(mesh.quads.size());
    for (const auto& q : mesh.quads.vertices)
      crowns_.emplace_back(std::array<Vector_3d, 4>{Vector_3d(mesh.points[q[0]]), Vector_3d(mesh.points[q[1]]),
                                                    Vector_3d(mesh.points[q[2]]), Vector_3d(mesh.points[q[3]])});
    if (!quads_without_crown().empty())
      return;
    height_ = crown_heights(mesh, crowns_);
    for (std::size_t k = 0; k < crowns_.size(); ++k)
      height_[k] = (std::max)(height_[k], floor_of(k));
    build(mesh);
  }

  const Surface& surface() const { return surface_; }
  Face_patch_map patch() const { return patch_; }
  const Vector_3d& middle(std::size_t quad) const { return crowns_[quad].foot; }

  // Those on which no pyramid can stand; if there are any, there is no surface.
  Quads quads_without_crown() const {
    Quads quads;
    for (std::size_t k = 0; k < crowns_.size(); ++k)
      if (!std::isfinite(crowns_[k].lowest))
        quads.push_back(k);
    return quads;
  }

  // Lowers pyramids until there is room around each, or they are as low as they may be. Returns those that meet others
  // all the same.
  Quads make_room() {
    Quads met = lower_those_meeting(meeting(surface_.faces(), room), room);
    if (!met.empty())
      met = meeting(faces_of(met), 1);
    raise_to(1);
    return met;
  }

  // Lowers all that meet others; returns false if none do. Those that are left may still.
  bool make_way() {
    const Quads met = meeting(surface_.faces(), 1);
    lower_those_meeting(met, 1);
    raise_to(1);
    return !met.empty();
  }

private:
  static constexpr double room = 1.5;         // of the height, while others are looked for
  static constexpr double lowering = 0.7;     // a round
  static constexpr double lowest_part = 0.02; // of the mean edge of a quad
  static constexpr double above_planes = 1.2; // of what positive corners need
  static constexpr int most_rounds = 16;

  double floor_of(std::size_t k) const {
    return (std::max)(lowest_part * crowns_[k].mean_edge, above_planes * crowns_[k].lowest);
  }

  // The apex of quad k comes behind the points of the quads themselves.
  Vertex apex(std::size_t k) const { return Vertex(Surface::size_type(first_apex_ + k)); }

  void build(const Mixed_mesh& mesh) {
    const std::size_t n = crowns_.size();
    first_apex_ = mesh.points.size();
    surface_.reserve(Surface::size_type(first_apex_ + n), Surface::size_type((3 * triangles_ + 12 * n) / 2),
                     Surface::size_type(triangles_ + 4 * n));
    patch_ = surface_.add_property_map<Face, int>("f:patch", side_label).first;
    for (const Point_3& p : mesh.points)
      surface_.add_vertex(p);
    for (std::size_t k = 0; k < n; ++k)
      surface_.add_vertex(point_of(k, 1));
    const auto add = [this](Vertex a, Vertex b, Vertex c) {
      const Face f = surface_.add_face(a, b, c);
      if (f == Surface::null_face())
        throw Meshing_error("The surface is not manifold at the edge of its points " + std::to_string(std::size_t(a)) +
                            " and " + std::to_string(std::size_t(b)) + ": repair it there.");
      return f;
    };
    for (std::size_t i = 0; i < triangles_; ++i) {
      const auto& t = mesh.triangles.vertices[i];
      patch_[add(Vertex(t[0]), Vertex(t[1]), Vertex(t[2]))] = mesh.triangles.label[i];
    }
    for (std::size_t k = 0; k < n; ++k) {
      const auto& q = mesh.quads.vertices[k];
      for (std::size_t i = 0; i < 4; ++i)
        add(Vertex(q[i]), Vertex(q[(i + 1) % 4]), apex(k));
    }
  }

  Point_3 point_of(std::size_t k, double factor) const {
    const Vector_3d p = crowns_[k].apex(factor * height_[k]);
    return Point_3(p.x, p.y, p.z);
  }
  void raise_to(double factor) {
    for (std::size_t k = 0; k < crowns_.size(); ++k)
      surface_.point(apex(k)) = point_of(k, factor);
  }

  std::vector<Face> faces_of(const Quads& quads) const {
    std::vector<Face> faces;
    for (std::size_t i = 0; i < triangles_; ++i)
      faces.push_back(Face(Surface::size_type(i)));
    for (std::size_t k : quads)
      for (std::size_t i = 0; i < 4; ++i)
        faces.push_back(Face(Surface::size_type(triangles_ + 4 * k + i)));
    return faces;
  }

  // The quads whose pyramids, `factor` times as high as they are, meet others among the faces, or triangles.
  template <class Faces> Quads meeting(const Faces& faces, double factor) {
    raise_to(factor);
    Quads quads;
    for (const auto& pair : crossing_pairs({faces.begin(), faces.end()}, surface_))
      for (Face f : {pair.first, pair.second})
        if (std::size_t(f) >= triangles_)
          quads.push_back((std::size_t(f) - triangles_) / 4);
    std::sort(quads.begin(), quads.end());
    quads.erase(std::unique(quads.begin(), quads.end()), quads.end());
    return quads;
  }

  // Returns those that are left: they meet others as low as they may be.
  Quads lower_those_meeting(Quads met, double factor) {
    for (int round = 0; round < most_rounds && !met.empty() && lower(met); ++round)
      met = meeting(faces_of(met), factor);
    return met;
  }

  // False if all of them are as low as they may be.
  bool lower(const Quads& quads) {
    bool any = false;
    for (std::size_t k : quads) {
      const double to = (std::max)(lowering * height_[k], floor_of(k));
      any = any || to < height_[k];
      height_[k] = (std::min)(height_[k], to);
    }
    return any;
  }

  std::size_t triangles_, first_apex_ = 0;
  std::vector<Quad_crown> crowns_;
  std::vector<double> height_;
  Surface surface_; // its faces: the triangles, then four sides a quad
  Face_patch_map patch_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_PYRAMIDS_CROWNED_SURFACE_H
