// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing {

CGAL_TUBULAR_MESHING_INLINE bool Validity_report::is_valid() const {
  return cells > 0 && inverted_cells == 0 && overfull_faces == 0 && nonmanifold_edges == 0 && unlabelled_faces == 0 &&
         misplaced_facets == 0 && unlabelled_interfaces == 0 && unused_points == 0 && connected_components == 1 &&
         regions_in_pieces() == 0;
}

CGAL_TUBULAR_MESHING_INLINE std::size_t Validity_report::regions_in_pieces() const {
  return std::size_t(std::count_if(region_components.begin(), region_components.end(),
                                   [](const std::pair<const int, std::size_t>& r) { return r.second > 1; }));
}

CGAL_TUBULAR_MESHING_INLINE std::string Validity_report::defects() const {
  std::string s;
  const auto add = [&](std::size_t n, const char* what) {
    if (n > 0)
      s += (s.empty() ? "" : ", ") + std::to_string(n) + what;
  };
  if (cells == 0)
    s = "no cells";
  add(inverted_cells, " inverted cells");
  add(overfull_faces, " overlapping faces");
  add(nonmanifold_edges, " non-manifold boundary edges");
  add(unlabelled_faces, " unlabelled boundary faces");
  add(misplaced_facets, " facets that bound no cell");
  add(unlabelled_interfaces, " unlabelled faces between regions");
  add(unused_points, " unused points");
  if (connected_components > 1)
    add(connected_components, " separate pieces");
  else
    add(regions_in_pieces(), " regions in several pieces");
  return s;
}

namespace internal {

class Validity_checker {
public:
  explicit Validity_checker(const Mixed_mesh& mesh) {
    points_.reserve(mesh.points.size());
    for (const Point_3& p : mesh.points)
      points_.emplace_back(p);
    faces_.reserve(4 * mesh.tetrahedra.size() + 5 * (mesh.pyramids.size() + mesh.prisms.size()) +
                   6 * mesh.hexahedra.size() + mesh.triangles.size() + mesh.quads.size());
    add_cells(mesh.tetrahedra);
    add_cells(mesh.pyramids);
    add_cells(mesh.prisms);
    add_cells(mesh.hexahedra);
    add_facets(mesh.triangles);
    add_facets(mesh.quads);
    match_faces();
  }

  const Validity_report& report() const { return report_; }

private:
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);
  static constexpr Index facet_mark = Index(-1);

  // A face, from its smallest vertex on towards the smaller of that one's neighbors; a triangle ends in `none`.
  struct Face {
    std::array<Index, 4> v;
    Index cell; // or facet_mark
    bool reversed;
    bool operator<(const Face& f) const { return v < f.v; }
  };

  template <std::size_t N> void add_cells(const Element_block<N>& cells) {
    typedef Cell_topology<N> Topology;
    regions_.insert(regions_.end(), cells.label.begin(), cells.label.end());
    for (const auto& c : cells.vertices) {
      if (is_inverted(c))
        ++report_.inverted_cells;
      for (const auto& f : Topology::triangles())
        add_face<3>({c[f[0]], c[f[1]], c[f[2]]}, Index(report_.cells));
      for (const auto& f : Topology::quads())
        add_face<4>({c[f[0]], c[f[1]], c[f[2]], c[f[3]]}, Index(report_.cells));
      ++report_.cells;
    }
  }

  template <std::size_t N> void add_facets(const Element_block<N>& facets) {
    for (const auto& f : facets.vertices)
      add_face<N>(f, facet_mark);
  }

  template <std::size_t N> bool is_inverted(const std::array<Index, N>& c) const {
    for (const auto& k : Cell_topology<N>::corners()) {
      const Vector_3d& o = points_[c[k[0]]];
      if (!(dot(cross(points_[c[k[1]]] - o, points_[c[k[2]]] - o), points_[c[k[3]]] - o) > 0))
        return true;
    }
    return false;
  }

  template <std::size_t N> void add_face(const std::array<Index, N>& f, Index cell) {
    const std::size_t first = std::size_t(std::min_element(f.begin(), f.end()) - f.begin());
    const Index next = f[(first + 1) % N], previous = f[(first + N - 1) % N];
    Face face = {{none, none, none, none}, cell, previous < next};
    for (std::size_t k = 0; k < N; ++k)
      face.v[k] = f[(face.reversed ? first + N - k : first + k) % N];
    faces_.push_back(face);
  }

  void match_faces() {
    std::sort(faces_.begin(), faces_.end());
    boost::disjoint_sets_with_storage<> pieces(report_.cells), pieces_of_regions(report_.cells); // of cells
    for (std::size_t k = 0; k < faces_.size();) {
      std::array<const Face*, 2> sides = {nullptr, nullptr};
      std::size_t cells = 0, facets = 0;
      const Face& face = faces_[k];
      for (; k < faces_.size() && faces_[k].v == face.v; ++k)
        if (faces_[k].cell == facet_mark)
          ++facets;
        else if (cells++ < 2)
          sides[cells - 1] = &faces_[k];
      if (cells > 2 || (cells == 2 && sides[0]->reversed == sides[1]->reversed))
        ++report_.overfull_faces;
      if (cells == 2) {
        pieces.union_set(sides[0]->cell, sides[1]->cell);
        if (regions_[sides[0]->cell] == regions_[sides[1]->cell])
          pieces_of_regions.union_set(sides[0]->cell, sides[1]->cell);
        else
          report_.unlabelled_interfaces += facets == 0;
      }
      if (cells == 0 || facets > 1)
        ++report_.misplaced_facets;
      if (cells == 1) {
        report_.unlabelled_faces += facets == 0;
        add_boundary_face(face.v);
      }
    }
    for (std::size_t c = 0; c < report_.cells; ++c) {
      report_.connected_components += pieces.find_set(c) == c;
      if (pieces_of_regions.find_set(c) == c)
        ++report_.region_components[regions_[c]];
    }
    check_boundary();
  }

  void add_boundary_face(const std::array<Index, 4>& v) {
    const std::size_t n = v[3] == none ? 3 : 4;
    for (std::size_t k = 0; k < n; ++k)
      boundary_edges_.push_back(std::minmax(v[k], v[(k + 1) % n]));
    ++boundary_faces_;
  }

  void check_boundary() {
    std::sort(boundary_edges_.begin(), boundary_edges_.end());
    std::vector<char> used(points_.size(), 0), on_boundary(points_.size(), 0);
    for (const Face& f : faces_)
      if (f.cell != facet_mark)
        for (Index v : f.v)
          if (v != none)
            used[v] = 1;
    std::ptrdiff_t edges = 0;
    for (std::size_t k = 0; k < boundary_edges_.size(); ++edges) {
      const auto edge = boundary_edges_[k];
      std::size_t faces = 0;
      for (; k < boundary_edges_.size() && boundary_edges_[k] == edge; ++k)
        ++faces;
      report_.nonmanifold_edges += faces != 2;
      on_boundary[edge.first] = on_boundary[edge.second] = 1;
    }
    report_.unused_points = std::size_t(std::count(used.begin(), used.end(), 0));
    report_.boundary_euler = std::count(on_boundary.begin(), on_boundary.end(), 1) - edges + boundary_faces_;
  }

  std::vector<Vector_3d> points_;
  std::vector<Face> faces_;
  std::vector<int> regions_; // of the cells
  std::vector<std::pair<Index, Index>> boundary_edges_;
  std::ptrdiff_t boundary_faces_ = 0;
  Validity_report report_;
};

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Validity_report validity_report(const Mixed_mesh& mesh) {
  return internal::Validity_checker(mesh).report();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H
