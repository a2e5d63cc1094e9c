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
#include <cstddef>
#include <cstdint>
#include <numeric>
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

/* Faces are matched in the bucket of their smallest vertex: two passes over the cells, and buckets of a few dozen. */
class Validity_checker {
public:
  explicit Validity_checker(const Mixed_mesh& mesh) {
    points_.reserve(mesh.points.size());
    for (const Point_3& p : mesh.points)
      points_.emplace_back(p);
    check_cells(mesh.tetrahedra);
    check_cells(mesh.pyramids);
    check_cells(mesh.prisms);
    check_cells(mesh.hexahedra);
    collect_faces(mesh);
    match_faces();
    check_boundary();
  }

  const Validity_report& report() const { return report_; }

private:
  typedef std::uint32_t Index;
  static constexpr Index none = Index(-1);
  static constexpr Index facet_mark = Index(-1);

  // A face after its smallest vertex, towards the smaller of that one's neighbors; a triangle ends in `none`.
  struct Face {
    std::array<Index, 3> others;
    Index cell; // or facet_mark
    bool reversed;
    bool operator<(const Face& f) const { return others < f.others; }
  };

  template <std::size_t N> void check_cells(const Element_block<N>& cells) {
    regions_.insert(regions_.end(), cells.label.begin(), cells.label.end());
    report_.cells += cells.size();
    for (const auto& c : cells.vertices)
      report_.inverted_cells += is_inverted(c);
  }

  template <std::size_t N> bool is_inverted(const std::array<Index, N>& c) const {
    for (const auto& k : Cell_topology<N>::corners()) {
      const Vector_3d& o = points_[c[k[0]]];
      if (!(dot(cross(points_[c[k[1]]] - o, points_[c[k[2]]] - o), points_[c[k[3]]] - o) > 0))
        return true;
    }
    return false;
  }

  // Calls visit(smallest vertex, face) for the faces of all cells, and all facets.
  template <class Visit> static void for_each_face(const Mixed_mesh& mesh, const Visit& visit) {
    Index cell = 0;
    visit_faces_of_cells(mesh.tetrahedra, cell, visit);
    visit_faces_of_cells(mesh.pyramids, cell, visit);
    visit_faces_of_cells(mesh.prisms, cell, visit);
    visit_faces_of_cells(mesh.hexahedra, cell, visit);
    for (const auto& f : mesh.triangles.vertices)
      visit_face<3>(f, facet_mark, visit);
    for (const auto& f : mesh.quads.vertices)
      visit_face<4>(f, facet_mark, visit);
  }
  template <std::size_t N, class Visit>
  static void visit_faces_of_cells(const Element_block<N>& cells, Index& cell, const Visit& visit) {
    typedef Cell_topology<N> Topology;
    for (const auto& c : cells.vertices) {
      for (const auto& f : Topology::triangles())
        visit_face<3>({c[f[0]], c[f[1]], c[f[2]]}, cell, visit);
      for (const auto& f : Topology::quads())
        visit_face<4>({c[f[0]], c[f[1]], c[f[2]], c[f[3]]}, cell, visit);
      ++cell;
    }
  }
  template <std::size_t N, class Visit>
  static void visit_face(const std::array<Index, N>& f, Index cell, const Visit& visit) {
    const std::size_t first = std::size_t(std::min_element(f.begin(), f.end()) - f.begin());
    const Index next = f[(first + 1) % N], previous = f[(first + N - 1) % N];
    Face face = {{none, none, none}, cell, previous < next};
    for (std::size_t k = 1; k < N; ++k)
      face.others[k - 1] = f[(face.reversed ? first + N - k : first + k) % N];
    visit(f[first], face);
  }

  void collect_faces(const Mixed_mesh& mesh) {
    first_face_.assign(points_.size() + 1, 0);
    for_each_face(mesh, [this](Index v, const Face&) { ++first_face_[v + 1]; });
    std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
    faces_.resize(first_face_.back());
    std::vector<std::size_t> next(first_face_.begin(), first_face_.end() - 1);
    for_each_face(mesh, [&](Index v, const Face& face) { faces_[next[v]++] = face; });
  }

  void match_faces() {
    boost::disjoint_sets_with_storage<> pieces(report_.cells), pieces_of_regions(report_.cells); // of cells
    for (std::size_t v = 0; v < points_.size(); ++v) {
      std::sort(faces_.begin() + std::ptrdiff_t(first_face_[v]), faces_.begin() + std::ptrdiff_t(first_face_[v + 1]));
      for (std::size_t k = first_face_[v]; k < first_face_[v + 1];)
        k = match_face(Index(v), k, pieces, pieces_of_regions);
    }
    for (std::size_t c = 0; c < report_.cells; ++c) {
      report_.connected_components += pieces.find_set(c) == c;
      if (pieces_of_regions.find_set(c) == c)
        ++report_.region_components[regions_[c]];
    }
  }

  // The face number k, whose smallest vertex is v, with all that are the same; returns the number after them.
  template <class Sets> std::size_t match_face(Index v, std::size_t k, Sets& pieces, Sets& pieces_of_regions) {
    std::array<const Face*, 2> sides = {nullptr, nullptr};
    std::size_t cells = 0, facets = 0;
    const Face& face = faces_[k];
    for (; k < first_face_[v + 1] && faces_[k].others == face.others; ++k)
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
      add_boundary_face({v, face.others[0], face.others[1], face.others[2]});
    }
    return k;
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
    for (std::size_t v = 0; v < points_.size(); ++v)
      for (std::size_t k = first_face_[v]; k < first_face_[v + 1]; ++k)
        if (faces_[k].cell != facet_mark) {
          used[v] = 1;
          for (Index w : faces_[k].others)
            if (w != none)
              used[w] = 1;
        }
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
  std::vector<Face> faces_;             // by their smallest vertices
  std::vector<std::size_t> first_face_; // of each vertex
  std::vector<int> regions_;            // of the cells
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
