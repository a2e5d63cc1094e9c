// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H
#define CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H

#include <CGAL/Tubular_meshing/Quality/internal/Matched_faces.h>
#include <CGAL/Tubular_meshing/base/Face_buckets.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The cells of a mesh, or of one region of it, as the finite volumes of a solver: their centers and faces as OpenFOAM
 * takes them, and what its checkMesh measures there. A region is taken for a mesh of its own: its interfaces are part of
 * its boundary. O(n log m) for n cells, m at a vertex; cells and faces are measured on all threads. */
class Finite_volumes {
public:
  explicit Finite_volumes(const Mixed_mesh& mesh, const int* region = nullptr, int threads = 1)
      : Finite_volumes(Matched_faces(mesh, cells::Face_buckets::without_facets, threads, region), threads) {}
  // Facets among the faces make no difference.
  Finite_volumes(const Matched_faces& matched, int threads)
      : mesh_(matched.cells.mesh())
      , cells_(matched.cells)
      , faces_(matched.faces)
      , region_(matched.region)
      , threads_(threads) {
    measure_cells();
    measure_faces();
  }

  // Of each cell: how far its faces are from showing the same area in the directions of the axes, and from a cube's.
  std::vector<double>& aspect() { return aspect_; }
  // Of each face between two cells, in degrees: the angle between its normal and the line between their centers.
  std::vector<double>& non_orthogonality() { return non_orthogonality_; }
  // Of each face: how far from its center that line meets it.
  std::vector<double>& skewness() { return skewness_; }

private:
  typedef cells::Face_buckets::Face Face;
  static constexpr double nothing = -1; // where there is no measure

  // Of a triangle or a quad: its corners, counterclockwise from outside of its cell.
  struct Polygon {
    std::array<Vector_3d, 4> corners;
    std::size_t size;
    Vector_3d center, area;
  };

  /* A quad is the triangles between its edges and the mean of its corners: its area is the sum of their area vectors,
   * its center the mean of theirs, by their areas. */
  Polygon polygon(const cells::Face& v) const {
    Polygon p;
    p.size = cells::number_of_corners(v);
    Vector_3d middle;
    for (std::size_t k = 0; k < p.size; ++k) {
      p.corners[k] = Vector_3d(mesh_.points[v[k]]);
      middle += p.corners[k];
    }
    middle = (1. / double(p.size)) * middle;
    if (p.size == 3) {
      p.center = middle;
      p.area = 0.5 * cross(p.corners[1] - p.corners[0], p.corners[2] - p.corners[0]);
      return p;
    }
    double sum = 0;
    for (std::size_t k = 0; k < p.size; ++k) {
      const Vector_3d &a = p.corners[k], &b = p.corners[(k + 1) % p.size];
      const Vector_3d twice = cross(b - a, middle - a);
      p.area += 0.5 * twice;
      p.center += (norm(twice) / 3) * (a + b + middle);
      sum += norm(twice);
    }
    p.center = sum > 0 ? (1 / sum) * p.center : middle;
    return p;
  }

  void measure_cells() {
    centers_.resize(cells_.size());
    aspect_.assign(cells_.size(), nothing);
    const std::size_t tetrahedra = cells_.first_cell(1);
    for_each_range(cells_.size(), threads_, [&](std::size_t first, std::size_t last) {
      std::array<Polygon, 6> faces;
      for (std::size_t c = first; c < last; ++c) {
        if (region_ != nullptr && cells_.region(c) != *region_)
          continue;
        if (c < tetrahedra) {
          measure(mesh_.tetrahedra.vertices[c], centers_[c], aspect_[c]);
          continue;
        }
        const std::size_t n = cells_.number_of_faces(c);
        for (std::size_t f = 0; f < n; ++f)
          faces[f] = polygon(cells_.face(c, f));
        measure(faces.data(), n, centers_[c], aspect_[c]);
      }
    });
    if (region_ != nullptr)
      aspect_.erase(std::remove(aspect_.begin(), aspect_.end(), nothing), aspect_.end());
  }

  typedef std::array<double, 3> Projections; // areas of faces along the axes
  static void add(const Vector_3d& area, Projections& sum) {
    for (int i = 0; i < 3; ++i)
      sum[std::size_t(i)] += std::abs(area[i]);
  }

  /* A cell's center is that of the pyramids over its faces from the mean of the faces' centers, by their volumes. */
  static void measure(const Polygon* faces, std::size_t n, Vector_3d& center, double& aspect) {
    Vector_3d middle, moment;
    for (std::size_t f = 0; f < n; ++f)
      middle += (1. / double(n)) * faces[f].center;
    double three_volumes = 0;
    Projections areas = {0, 0, 0};
    for (std::size_t f = 0; f < n; ++f) {
      const double part = dot(faces[f].area, faces[f].center - middle);
      three_volumes += part;
      moment += part * (0.75 * faces[f].center + 0.25 * middle);
      add(faces[f].area, areas);
    }
    center = three_volumes != 0 ? (1 / three_volumes) * moment : middle;
    aspect = aspect_of(areas, three_volumes / 3);
  }

  // The same of a tetrahedron, of which most meshes have the most: its center is the mean of its corners.
  void measure(const std::array<std::uint32_t, 4>& cell, Vector_3d& center, double& aspect) const {
    const Vector_3d p(mesh_.points[cell[0]]);
    const Vector_3d a = Vector_3d(mesh_.points[cell[1]]) - p, b = Vector_3d(mesh_.points[cell[2]]) - p,
                    c = Vector_3d(mesh_.points[cell[3]]) - p;
    center = p + 0.25 * (a + b + c);
    const Vector_3d ab = 0.5 * cross(a, b), bc = 0.5 * cross(b, c), ca = 0.5 * cross(c, a);
    Projections areas = {0, 0, 0};
    for (const Vector_3d& area : {ab, bc, ca, ab + bc + ca})
      add(area, areas);
    aspect = aspect_of(areas, dot(ab, c) / 3);
  }

  static double aspect_of(const Projections& areas, double volume) {
    const double least = *std::min_element(areas.begin(), areas.end());
    const double most = *std::max_element(areas.begin(), areas.end());
    if (!(least > 0 && volume > 0))
      return (std::numeric_limits<double>::infinity)();
    const double side = std::cbrt(volume);
    return (std::max)(most / least, (areas[0] + areas[1] + areas[2]) / (6 * side * side));
  }

  // How many faces there are of each: those between two cells, and all.
  struct Face_numbers {
    std::size_t inner = 0, all = 0;
  };

  // Faces of the same corners are one. They are measured in the order of their lowest corners, in parts side by side.
  void measure_faces() {
    const std::size_t parts = 256, points = mesh_.points.size();
    const auto for_each_face_of = [&](std::size_t part, const auto& visit) {
      for (std::size_t v = part * points / parts; v < (part + 1) * points / parts; ++v)
        faces_.for_each_group(v, [&](std::size_t first, std::size_t last) {
          if (!faces_[first].is_facet()) // cells come before facets
            visit(faces_[first], last - first > 1 && !faces_[first + 1].is_facet() ? &faces_[first + 1] : nullptr);
        });
    };
    std::vector<Face_numbers> before(parts + 1);
    for_each_task(parts, threads_, [&](std::size_t k) {
      for_each_face_of(k, [&](const Face&, const Face* other) {
        before[k + 1].inner += other != nullptr;
        ++before[k + 1].all;
      });
    });
    for (std::size_t k = 0; k < parts; ++k) {
      before[k + 1].inner += before[k].inner;
      before[k + 1].all += before[k].all;
    }
    non_orthogonality_.resize(before[parts].inner);
    skewness_.resize(before[parts].all);
    for_each_task(parts, threads_, [&](std::size_t k) {
      Face_numbers at = before[k];
      for_each_face_of(k, [&](const Face& f, const Face* other) {
        const Polygon face = polygon(cells_.face(f.owner(), f.number()));
        const Vector_3d& center = centers_[f.owner()];
        if (other == nullptr) {
          skewness_[at.all++] = skewness_at_boundary(face, center);
          return;
        }
        const Vector_3d d = centers_[other->owner()] - center;
        non_orthogonality_[at.inner++] = non_orthogonality(face, d);
        skewness_[at.all++] = skewness_along(face, center, d, 0.2);
      });
    });
  }

  static double non_orthogonality(const Polygon& face, const Vector_3d& d) {
    const double product = norm(d) * norm(face.area);
    const double cosine = product > 0 ? dot(d, face.area) / product : 0;
    return 180 / pi * std::acos((std::min)((std::max)(cosine, -1.), 1.));
  }

  // As if the cell were mirrored by the face.
  static double skewness_at_boundary(const Polygon& face, const Vector_3d& from) {
    const Vector_3d normal = normalized(face.area);
    return skewness_along(face, from, dot(normal, face.center - from) * normal, 0.4);
  }

  /* The line from a cell's center along d misses the face's center by so much, in units of the face's extent in that
   * direction, at least a part of d. */
  static double skewness_along(const Polygon& face, const Vector_3d& from, const Vector_3d& d, double part) {
    const Vector_3d to_center = face.center - from;
    const double slope = dot(face.area, d);
    const Vector_3d miss = slope != 0 ? to_center - (dot(face.area, to_center) / slope) * d : to_center;
    const double length = norm(miss);
    if (!(length > 0))
      return 0;
    double extent = part * norm(d);
    for (std::size_t k = 0; k < face.size; ++k)
      extent = (std::max)(extent, std::abs(dot(miss, face.corners[k] - face.center)) / length);
    return extent > 0 ? length / extent : (std::numeric_limits<double>::infinity)();
  }

  const Mixed_mesh& mesh_;
  const cells::Numbered_cells& cells_;
  const cells::Face_buckets& faces_;
  const int* region_; // null: all
  int threads_;
  std::vector<Vector_3d> centers_; // of the cells
  std::vector<double> aspect_, non_orthogonality_, skewness_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H
