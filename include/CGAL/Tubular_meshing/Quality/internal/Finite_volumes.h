// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H
#define CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H

#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/element_measures.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The cells of a mesh, or of one region of it, as the finite volumes of a solver: their centers and faces as OpenFOAM
 * takes them, and what its checkMesh measures there. A region is taken for a mesh of its own: its interfaces are part of
 * its boundary. O(n log m) for n cells, m at a vertex; cells and faces are measured on all threads. */
class Finite_volumes {
public:
  explicit Finite_volumes(const Mixed_mesh& mesh, const int* region = nullptr, int threads = 1)
      : mesh_(mesh)
      , region_(region)
      , threads_(threads)
      , faces_begin_(mesh.points.size() + 1, 0) {
    count(mesh.tetrahedra);
    count(mesh.pyramids);
    count(mesh.prisms);
    count(mesh.hexahedra);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      faces_begin_[v + 1] += faces_begin_[v];
    faces_.resize(faces_begin_.back());
    std::vector<std::size_t> next(faces_begin_.begin(), faces_begin_.end() - 1);
    add(mesh.tetrahedra, next);
    add(mesh.pyramids, next);
    add(mesh.prisms, next);
    add(mesh.hexahedra, next);
    measure_cells();
    match();
  }

  // Of each cell: how far its faces are from showing the same area in the directions of the axes, and from a cube's.
  std::vector<double>& aspect() { return aspect_; }
  // Of each face between two cells, in degrees: the angle between its normal and the line between their centers.
  std::vector<double>& non_orthogonality() { return non_orthogonality_; }
  // Of each face: how far from its center that line meets it.
  std::vector<double>& skewness() { return skewness_; }

private:
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);

  // Of a triangle or a quad: its corners, counterclockwise from outside of its cell.
  struct Polygon {
    std::array<Vector_3d, 4> corners;
    std::size_t size;
    Vector_3d center, area;
  };
  // A face of a cell, kept with its lowest vertex.
  struct Face {
    std::array<Index, 3> others; // sorted; `none` last, for a triangle
    Index cell;
    std::uint8_t number; // among the cell's: triangles first

    bool operator<(const Face& f) const { return std::tie(others, cell) < std::tie(f.others, f.cell); }
  };

  bool counts(int label) const { return region_ == nullptr || label == *region_; }
  Vector_3d point(Index v) const { return Vector_3d(mesh_.points[v]); }

  template <std::size_t N> static std::size_t number_of_faces() {
    return Cell_topology<N>::triangles().size() + Cell_topology<N>::quads().size();
  }
  // The vertices of a face of a cell, `none` last for a triangle.
  template <std::size_t N>
  static std::array<Index, 4> face_vertices(const std::array<Index, N>& cell, std::size_t number) {
    const auto& triangles = Cell_topology<N>::triangles();
    std::array<Index, 4> v = {none, none, none, none};
    if (number < triangles.size())
      for (std::size_t k = 0; k < 3; ++k)
        v[k] = cell[std::size_t(triangles[number][k])];
    else
      for (std::size_t k = 0; k < 4; ++k)
        v[k] = cell[std::size_t(Cell_topology<N>::quads()[number - triangles.size()][k])];
    return v;
  }

  template <std::size_t N> void count(const Element_block<N>& cells) {
    for (std::size_t c = 0; c < cells.size(); ++c)
      if (counts(cells.label[c]))
        for (std::size_t f = 0; f < number_of_faces<N>(); ++f) {
          const auto v = face_vertices<N>(cells.vertices[c], f);
          ++faces_begin_[*std::min_element(v.begin(), v.end()) + 1];
        }
  }

  template <std::size_t N> void add(const Element_block<N>& cells, std::vector<std::size_t>& next) {
    for (std::size_t c = 0; c < cells.size(); ++c) {
      if (!counts(cells.label[c]))
        continue;
      for (std::size_t f = 0; f < number_of_faces<N>(); ++f) {
        auto v = face_vertices<N>(cells.vertices[c], f);
        std::sort(v.begin(), v.end());
        faces_[next[v[0]]++] = {{v[1], v[2], v[3]}, Index(elements_.size()), std::uint8_t(f)};
      }
      elements_.emplace_back(std::uint8_t(N), Index(c));
    }
  }

  /* A quad is the triangles between its edges and the mean of its corners: its area is the sum of their area vectors,
   * its center the mean of theirs, by their areas. */
  Polygon polygon(const std::array<Index, 4>& v) const {
    Polygon p;
    p.size = v[3] == none ? 3 : 4;
    Vector_3d middle;
    for (std::size_t k = 0; k < p.size; ++k) {
      p.corners[k] = point(v[k]);
      middle += p.corners[k];
    }
    middle = (1. / double(p.size)) * middle;
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
    centers_.resize(elements_.size());
    aspect_.resize(elements_.size());
    for_each_range(elements_.size(), threads_, [&](std::size_t first, std::size_t last) {
      std::array<Polygon, 6> faces;
      for (std::size_t c = first; c < last; ++c) {
        const std::size_t n = number_of_faces(c);
        for (std::size_t f = 0; f < n; ++f)
          faces[f] = polygon(c, f);
        measure(faces.data(), n, centers_[c], aspect_[c]);
      }
    });
  }

  /* A cell's center is that of the pyramids over its faces from the mean of the faces' centers, by their volumes. */
  static void measure(const Polygon* faces, std::size_t n, Vector_3d& center, double& aspect) {
    Vector_3d middle, moment;
    for (std::size_t f = 0; f < n; ++f)
      middle += (1. / double(n)) * faces[f].center;
    double three_volumes = 0;
    std::array<double, 3> areas = {0, 0, 0}; // of the faces' projections along the axes
    for (std::size_t f = 0; f < n; ++f) {
      const double part = dot(faces[f].area, faces[f].center - middle);
      three_volumes += part;
      moment += part * (0.75 * faces[f].center + 0.25 * middle);
      for (int i = 0; i < 3; ++i)
        areas[std::size_t(i)] += std::abs(faces[f].area[i]);
    }
    center = three_volumes != 0 ? (1 / three_volumes) * moment : middle;
    const double least = *std::min_element(areas.begin(), areas.end());
    const double most = *std::max_element(areas.begin(), areas.end());
    const double infinite = (std::numeric_limits<double>::infinity)();
    const double side2 = three_volumes > 0 ? std::pow(three_volumes / 3, 2. / 3) : 0;
    aspect =
        least > 0 && side2 > 0 ? (std::max)(most / least, (areas[0] + areas[1] + areas[2]) / (6 * side2)) : infinite;
  }

  /* Faces of the same vertices are one. What is measured of a face stands at first where it stood among the faces of
   * its lowest vertex, as threads know no other place for it. */
  void match() {
    const double no_face = -1;
    non_orthogonality_.assign(faces_.size(), no_face);
    skewness_.assign(faces_.size(), no_face);
    for_each_range(mesh_.points.size(), threads_, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        match_at(v);
    });
    for (std::vector<double>* values : {&non_orthogonality_, &skewness_})
      values->erase(std::remove(values->begin(), values->end(), no_face), values->end());
  }

  void match_at(std::size_t v) {
    const auto begin = faces_.begin() + std::ptrdiff_t(faces_begin_[v]);
    const auto end = faces_.begin() + std::ptrdiff_t(faces_begin_[v + 1]);
    std::sort(begin, end);
    for (auto f = begin; f != end;) {
      const std::size_t at = std::size_t(f - faces_.begin());
      const auto other = f + 1;
      const bool is_between = other != end && other->others == f->others;
      const Polygon face = polygon(f->cell, f->number);
      if (is_between)
        measure_between(face, centers_[f->cell], centers_[other->cell], non_orthogonality_[at], skewness_[at]);
      else
        skewness_[at] = skewness_at_boundary(face, centers_[f->cell]);
      f += is_between ? 2 : 1;
    }
  }

  std::size_t number_of_faces(std::size_t cell) const {
    switch (elements_[cell].first) {
    case 4:
      return number_of_faces<4>();
    case 5:
      return number_of_faces<5>();
    case 6:
      return number_of_faces<6>();
    default:
      return number_of_faces<8>();
    }
  }

  Polygon polygon(std::size_t cell, std::size_t number) const {
    const Index c = elements_[cell].second;
    switch (elements_[cell].first) {
    case 4:
      return polygon(face_vertices<4>(mesh_.tetrahedra.vertices[c], number));
    case 5:
      return polygon(face_vertices<5>(mesh_.pyramids.vertices[c], number));
    case 6:
      return polygon(face_vertices<6>(mesh_.prisms.vertices[c], number));
    default:
      return polygon(face_vertices<8>(mesh_.hexahedra.vertices[c], number));
    }
  }

  static void measure_between(const Polygon& face, const Vector_3d& from, const Vector_3d& to,
                              double& non_orthogonality, double& skewness) {
    const Vector_3d d = to - from;
    const double product = norm(d) * norm(face.area);
    const double cosine = product > 0 ? dot(d, face.area) / product : 0;
    non_orthogonality = 180 / pi * std::acos((std::min)((std::max)(cosine, -1.), 1.));
    skewness = skewness_along(face, from, d, 0.2);
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
  const int* region_; // null: all
  int threads_;
  std::vector<std::pair<std::uint8_t, Index>> elements_; // of each cell: the vertices it has, and which of these
  std::vector<Vector_3d> centers_;
  std::vector<std::size_t> faces_begin_; // of each vertex
  std::vector<Face> faces_;
  std::vector<double> aspect_, non_orthogonality_, skewness_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_QUALITY_INTERNAL_FINITE_VOLUMES_H
