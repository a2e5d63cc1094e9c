// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Shown_mesh.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Quality/element_quality.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::norm;
using tubular::internal::cells::no_vertex;
using tubular::internal::cells::number_of_corners;

namespace {

// The place of an element from those of its corners: on the branch that most of them are on.
template <class Corners>
Shown_mesh::Place place_of(const Corners& corners, std::size_t n, const std::vector<Shown_mesh::Place>& of_point) {
  std::uint32_t best = of_point[corners[0]].branch;
  std::ptrdiff_t most = 0;
  for (std::size_t i = 0; i < n; ++i) {
    std::ptrdiff_t votes = 0;
    for (std::size_t j = 0; j < n; ++j)
      votes += of_point[corners[j]].branch == of_point[corners[i]].branch;
    if (votes > most) {
      most = votes;
      best = of_point[corners[i]].branch;
    }
  }
  double sum = 0;
  for (std::size_t i = 0; i < n; ++i)
    sum += of_point[corners[i]].branch == best ? of_point[corners[i]].abscissa : 0;
  return {best, float(sum / double(most))};
}

} // namespace

Shown_mesh::Shown_mesh(const tubular::Mixed_mesh& mesh, const tubular::Centerline_graph& centerlines, int threads)
    : mesh_(mesh)
    , centerlines_(centerlines)
    , cells_(mesh) {
  find_sides();
  measure();
  find_places(threads);
}

Shown_mesh::Face Shown_mesh::facet(std::size_t f) const {
  if (!is_triangle(f))
    return mesh_.quads.vertices[f - mesh_.triangles.size()];
  const auto& t = mesh_.triangles.vertices[f];
  return {t[0], t[1], t[2], no_vertex};
}

int Shown_mesh::patch(std::size_t facet) const {
  return is_triangle(facet) ? mesh_.triangles.label[facet] : mesh_.quads.label[facet - mesh_.triangles.size()];
}

// Faces of cells are looked up among the facets, which are sorted by their corners.
void Shown_mesh::find_sides() {
  using tubular::internal::cells::sorted;
  typedef std::pair<Face, std::uint32_t> Entry;
  sides_.assign(number_of_facets(), Sides{none, none});
  std::vector<Entry> facets;
  facets.reserve(number_of_facets());
  std::vector<char> is_on_facet(mesh_.points.size(), 0);
  for (std::size_t f = 0; f < number_of_facets(); ++f) {
    facets.emplace_back(sorted(facet(f)), std::uint32_t(f));
    for (std::uint32_t v : facets.back().first)
      if (v != no_vertex)
        is_on_facet[v] = 1;
  }
  std::sort(facets.begin(), facets.end());
  cells_.for_each_face([&](std::size_t cell, std::size_t, const Face& corners) {
    for (std::uint32_t v : corners)
      if (v != no_vertex && !is_on_facet[v])
        return;
    const Face key = sorted(corners);
    const auto found = std::lower_bound(facets.begin(), facets.end(), Entry(key, 0));
    if (found == facets.end() || found->first != key)
      return;
    Sides& sides = sides_[found->second];
    sides[sides[0] == none ? 0 : 1] = std::uint32_t(cell);
  });
}

void Shown_mesh::measure() {
  cell_quality_.assign(cells_.size(), 0);
  facet_quality_.assign(number_of_facets(), 0);
  const std::vector<std::string> names = tubular::element_measures(mesh_);
  const auto put = [&](const char* measure, std::vector<float>& quality, std::size_t first, bool is_inverse) {
    if (std::find(names.begin(), names.end(), measure) == names.end())
      return;
    const std::vector<double> values = tubular::element_quality(mesh_, measure);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const double q = is_inverse ? 1 / values[i] : values[i];
      quality[first + i] = std::isfinite(q) ? float(q) : 0; // of a cell that is flat
    }
  };
  put("gamma_tau", cell_quality_, 0, false);
  put("Q_tau", cell_quality_, 0, true);
  put("pyramid_jacobian", cell_quality_, cells_.first_cell(1), false);
  put("prism_jacobian", cell_quality_, cells_.first_cell(2), false);
  put("scaled_jacobian", cell_quality_, cells_.first_cell(3), false);
  put("gamma_T", facet_quality_, 0, false);
  put("eta_q", facet_quality_, mesh_.triangles.size(), false);
}

void Shown_mesh::find_places(int threads) {
  cell_place_.resize(cells_.size());
  facet_place_.resize(number_of_facets());
  if (centerlines_.empty())
    return;
  const tubular::Centerline_field field(centerlines_);
  std::vector<Place> of_point(mesh_.points.size());
  tubular::internal::for_each_range(of_point.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const auto d = field.descriptors(mesh_.points[v]);
      of_point[v] = {std::uint32_t(d.branch), float(d.abscissa)};
    }
  });
  for (std::size_t c = 0; c < cells_.size(); ++c)
    cell_place_[c] = place_of(cells_.corners(c), cells_.corners(c).number, of_point);
  for (std::size_t f = 0; f < number_of_facets(); ++f) {
    const Face corners = facet(f);
    facet_place_[f] = place_of(corners, number_of_corners(corners), of_point);
  }
}

std::array<Shown_mesh::Vector, 2> Shown_mesh::extent() const {
  const double infinity = (std::numeric_limits<double>::infinity)();
  Vector low(infinity, infinity, infinity), high(-infinity, -infinity, -infinity);
  for (const auto& p : mesh_.points) {
    low = {(std::min)(low.x, p.x()), (std::min)(low.y, p.y()), (std::min)(low.z, p.z())};
    high = {(std::max)(high.x, p.x()), (std::max)(high.y, p.y()), (std::max)(high.z, p.z())};
  }
  return {low, high};
}

Shown_mesh::Vector Shown_mesh::center_of_cell(std::size_t cell) const {
  Vector sum;
  const auto corners = cells_.corners(cell);
  for (std::uint32_t v : corners)
    sum += point(v);
  return (1. / double(corners.number)) * sum;
}

Shown_mesh::Vector Shown_mesh::center_of_face(const Face& face) const {
  Vector sum;
  const std::size_t n = number_of_corners(face);
  for (std::size_t i = 0; i < n; ++i)
    sum += point(face[i]);
  return (1. / double(n)) * sum;
}

double Shown_mesh::size_of_face(const Face& face) const {
  double sum = 0;
  const std::size_t n = number_of_corners(face);
  for (std::size_t i = 0; i < n; ++i)
    sum += norm(point(face[(i + 1) % n]) - point(face[i]));
  return sum / double(n);
}
