// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H
#define CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H

#include <CGAL/Tubular_meshing/Quality/internal/Matched_faces.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/base/Face_buckets.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <boost/pending/disjoint_sets.hpp>
#include <boost/sort/spreadsort/integer_sort.hpp>

#include <algorithm>
#include <array>
#include <atomic>
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

template <std::size_t N> bool is_inverted(const Mixed_mesh& mesh, const std::array<std::uint32_t, N>& c) {
  const auto point = [&](int k) { return Vector_3d(mesh.points[c[std::size_t(k)]]); };
  for (const auto& k : Cell_topology<N>::corners()) {
    const Vector_3d o = point(k[0]);
    if (!(dot(cross(point(k[1]) - o, point(k[2]) - o), point(k[3]) - o) > 0))
      return true;
  }
  return false;
}

template <std::size_t N>
std::size_t number_of_inverted(const Mixed_mesh& mesh, const Element_block<N>& cells, int threads) {
  std::atomic<std::size_t> number{0};
  for_each_range(cells.size(), threads, [&](std::size_t first, std::size_t last) {
    std::size_t n = 0;
    for (std::size_t c = first; c < last; ++c)
      n += is_inverted(mesh, cells.vertices[c]);
    number += n;
  });
  return number;
}

inline std::size_t number_of_inverted_cells(const Mixed_mesh& mesh, int threads) {
  return number_of_inverted(mesh, mesh.tetrahedra, threads) + number_of_inverted(mesh, mesh.pyramids, threads) +
         number_of_inverted(mesh, mesh.prisms, threads) + number_of_inverted(mesh, mesh.hexahedra, threads);
}

/* All that validity is but for inverted cells: of the mesh's elements and labels, wherever its points are. */
class Validity_checker {
public:
  // Of all cells, and facets.
  explicit Validity_checker(const Matched_faces& matched)
      : mesh_(matched.cells.mesh())
      , cells_(matched.cells)
      , faces_(matched.faces) {
    report_.cells = matched.cells.size();
    match_faces();
    check_boundary();
    count_unused_points();
  }

  const Validity_report& report() const { return report_; }

private:
  typedef std::uint32_t Index;
  typedef cells::Face_buckets::Face Face;

  void match_faces() {
    boundary_edges_.reserve(3 * mesh_.triangles.size() + 4 * mesh_.quads.size());
    std::vector<std::uint8_t> rank(report_.cells, 0);
    std::vector<Index> parent(report_.cells);
    std::iota(parent.begin(), parent.end(), Index(0));
    boost::disjoint_sets<std::uint8_t*, Index*> pieces(rank.data(), parent.data()); // of regions; at last, of all
    for (std::size_t v = 0; v < mesh_.points.size(); ++v)
      faces_.for_each_group(v, [&](std::size_t first, std::size_t last) { match_face(first, last, pieces); });
    for (Index c = 0; c < report_.cells; ++c)
      if (pieces.find_set(c) == c)
        ++report_.region_components[cells_.region(c)];
    for (const auto& i : interfaces_)
      pieces.union_set(i.first, i.second);
    for (Index c = 0; c < report_.cells; ++c)
      report_.connected_components += pieces.find_set(c) == c;
  }

  // All faces that are the same, cells before facets.
  template <class Sets> void match_face(std::size_t first, std::size_t last, Sets& pieces) {
    std::size_t cells = 0;
    while (cells < last - first && !faces_[first + cells].is_facet())
      ++cells;
    const std::size_t facets = last - first - cells;
    const Face &face = faces_[first], &other = faces_[last - 1 - facets];
    if (cells > 2 || (cells == 2 && faces_.overlap(face, other)))
      ++report_.overfull_faces;
    if (cells == 2) {
      if (cells_.region(face.owner()) == cells_.region(other.owner()))
        pieces.union_set(face.owner(), other.owner());
      else {
        interfaces_.emplace_back(face.owner(), other.owner());
        report_.unlabelled_interfaces += facets == 0;
      }
    }
    if (cells == 0 || facets > 1)
      ++report_.misplaced_facets;
    if (cells == 1) {
      report_.unlabelled_faces += facets == 0;
      add_boundary_face(faces_.corners(face));
    }
  }

  void add_boundary_face(const cells::Face& v) {
    const std::size_t n = cells::number_of_corners(v);
    for (std::size_t k = 0; k < n; ++k)
      boundary_edges_.push_back(edge(v[k], v[(k + 1) % n]));
    ++boundary_faces_;
  }

  static std::uint64_t edge(Index v, Index w) { return std::uint64_t((std::min)(v, w)) << 32 | (std::max)(v, w); }

  void check_boundary() {
    boost::sort::spreadsort::integer_sort(boundary_edges_.begin(), boundary_edges_.end());
    std::vector<char> on_boundary(mesh_.points.size(), 0);
    std::ptrdiff_t edges = 0;
    for (std::size_t k = 0; k < boundary_edges_.size(); ++edges) {
      const auto edge = boundary_edges_[k];
      std::size_t faces = 0;
      for (; k < boundary_edges_.size() && boundary_edges_[k] == edge; ++k)
        ++faces;
      report_.nonmanifold_edges += faces != 2;
      on_boundary[edge >> 32] = on_boundary[Index(edge)] = 1;
    }
    report_.boundary_euler = std::count(on_boundary.begin(), on_boundary.end(), 1) - edges + boundary_faces_;
  }

  void count_unused_points() {
    std::vector<char> used(mesh_.points.size(), 0);
    const auto use = [&](const auto& block) {
      for (const auto& cell : block.vertices)
        for (Index v : cell)
          used[v] = 1;
    };
    use(mesh_.tetrahedra);
    use(mesh_.pyramids);
    use(mesh_.prisms);
    use(mesh_.hexahedra);
    report_.unused_points = std::size_t(std::count(used.begin(), used.end(), 0));
  }

  const Mixed_mesh& mesh_;
  const cells::Numbered_cells& cells_;
  const cells::Face_buckets& faces_;
  std::vector<std::pair<Index, Index>> interfaces_; // cells on both sides
  std::vector<std::uint64_t> boundary_edges_;       // lower vertex, higher vertex
  std::ptrdiff_t boundary_faces_ = 0;
  Validity_report report_;
};

inline Validity_report validity_of(const Matched_faces& matched, int threads) {
  Validity_report report = Validity_checker(matched).report();
  report.inverted_cells = number_of_inverted_cells(matched.cells.mesh(), threads);
  return report;
}

CGAL_TUBULAR_MESHING_INLINE Validity_report validity_report_on(int threads, const Mixed_mesh& mesh) {
  return validity_of(Matched_faces(mesh, cells::Face_buckets::with_facets, threads), threads);
}

} // namespace internal

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_QUALITY_VALIDITY_REPORT_IMPL_H
