// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Meshes of all kinds of cells for the tests of solvers' files: a box of layers of cubes, each layer divided its way.

#ifndef TUBULAR_MESHING_TEST_SOLVER_MESHES_H
#define TUBULAR_MESHING_TEST_SOLVER_MESHES_H

#include "io_fixture.h"

#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

typedef std::set<std::size_t> Corners; // of a face

// The faces of the cells of a mesh by the tables that its documentation implies, with the numbers of the cells.
struct Faces_of_cells {
  std::vector<std::vector<std::vector<std::size_t>>> faces; // of each cell, outward loops
  std::vector<int> region;

  explicit Faces_of_cells(const Mesh& m) {
    add(m.tetrahedra, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}});
    add(m.pyramids, {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}});
    add(m.prisms, {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}});
    add(m.hexahedra, {{0, 3, 2, 1}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}});
  }

  std::set<Corners> corners(std::size_t cell) const {
    std::set<Corners> result;
    for (const auto& f : faces[cell])
      result.insert(Corners(f.begin(), f.end()));
    return result;
  }

private:
  template <class Block> void add(const Block& block, const std::vector<std::vector<std::size_t>>& table) {
    for (std::size_t i = 0; i < block.size(); ++i) {
      faces.emplace_back();
      for (const auto& face : table) {
        faces.back().emplace_back();
        for (std::size_t k : face)
          faces.back().back().push_back(block.vertices[i][k]);
      }
      region.push_back(block.label[i]);
    }
  }
};

/* A box of n x n cubes a layer. A layer is divided as its letter says:
 *   H hexahedra, P pyramids, W prisms, T tetrahedra (six a cube), X pyramids and tetrahedra, from quads below to
 *   triangles above. H, P and X have quads below, W and T triangles; so choose what lies above what.
 * A digit a layer says its region. Patches: 2 below, 3 above, 1 around the first region and between regions, 100
 * around the others. */
class Layered_box {
public:
  static Mesh make(std::size_t n, const std::string& layers, const std::string& regions) {
    Layered_box box(n);
    for (std::size_t k = 0; k <= layers.size(); ++k)
      for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i <= n; ++i)
          box.add_point(double(i), double(j), double(k));
    for (std::size_t k = 0; k < layers.size(); ++k)
      for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < n; ++i)
          box.add_cube(i, j, k, layers[k], regions[k] - '0');
    box.add_facets(layers.size());
    Mesh& m = box.mesh_;
    m.region_names = {{1, "lumen"}, {2, "wall"}};
    m.patch_names = {{1, "wall"}, {2, "inlet"}, {3, "outlet_1"}, {100, "outer_wall"}};
    return box.mesh_;
  }

private:
  explicit Layered_box(std::size_t n)
      : n_(n) {}

  // Off the grid a little, so that every coordinate has digits of its own; the sides stay planar.
  void add_point(double x, double y, double z) {
    const double s = 1e-3;
    mesh_.points.push_back(Point(x / 3 + s * x * (double(n_) - x) * y, y / 3, z / 3 + s * z * z / 7));
  }

  std::uint32_t at(std::size_t i, std::size_t j, std::size_t k) const {
    return std::uint32_t(i + (n_ + 1) * (j + (n_ + 1) * k));
  }

  void add_cube(std::size_t i, std::size_t j, std::size_t k, char kind, int region) {
    const std::array<std::uint32_t, 8> v = {
        at(i, j, k),     at(i + 1, j, k),     at(i + 1, j + 1, k),     at(i, j + 1, k),
        at(i, j, k + 1), at(i + 1, j, k + 1), at(i + 1, j + 1, k + 1), at(i, j + 1, k + 1)};
    if (kind == 'H') {
      mesh_.hexahedra.push_back(v, region);
    } else if (kind == 'W') {
      mesh_.prisms.push_back({v[0], v[1], v[2], v[4], v[5], v[6]}, region);
      mesh_.prisms.push_back({v[0], v[2], v[3], v[4], v[6], v[7]}, region);
    } else if (kind == 'T') {
      for (const auto& p : {std::array<int, 2>{1, 2}, {2, 3}, {3, 7}, {7, 4}, {4, 5}, {5, 1}})
        mesh_.tetrahedra.push_back({v[0], v[std::size_t(p[0])], v[std::size_t(p[1])], v[6]}, region);
    } else {
      const auto center = std::uint32_t(mesh_.points.size());
      add_point(double(i) + 0.5, double(j) + 0.5, double(k) + 0.5);
      mesh_.pyramids.push_back({v[0], v[1], v[2], v[3], center}, region);
      mesh_.pyramids.push_back({v[0], v[4], v[5], v[1], center}, region);
      mesh_.pyramids.push_back({v[1], v[5], v[6], v[2], center}, region);
      mesh_.pyramids.push_back({v[2], v[6], v[7], v[3], center}, region);
      mesh_.pyramids.push_back({v[3], v[7], v[4], v[0], center}, region);
      if (kind == 'P') {
        mesh_.pyramids.push_back({v[4], v[7], v[6], v[5], center}, region);
      } else {
        mesh_.tetrahedra.push_back({v[4], v[6], v[5], center}, region);
        mesh_.tetrahedra.push_back({v[4], v[7], v[6], center}, region);
      }
    }
  }

  void add_facets(std::size_t layers) {
    const Faces_of_cells cells(mesh_);
    std::map<Corners, std::vector<std::pair<std::size_t, std::size_t>>> sides;
    for (std::size_t c = 0; c < cells.faces.size(); ++c)
      for (std::size_t f = 0; f < cells.faces[c].size(); ++f)
        sides[Corners(cells.faces[c][f].begin(), cells.faces[c][f].end())].emplace_back(c, f);
    const std::size_t layer = (n_ + 1) * (n_ + 1);
    for (const auto& s : sides) {
      const int a = cells.region[s.second[0].first], b = cells.region[s.second.back().first];
      if (s.second.size() == 2 && a == b)
        continue;
      const bool below = *s.first.rbegin() < layer;
      const bool above = *s.first.begin() >= layers * layer && *s.first.rbegin() < (layers + 1) * layer;
      const int label = s.second.size() == 2 ? 1 : below ? 2 : above ? 3 : a == 1 ? 1 : 100;
      const auto& side = a <= b ? s.second[0] : s.second.back();
      const auto& loop = cells.faces[side.first][side.second];
      std::array<std::uint32_t, 4> v = {};
      std::copy(loop.begin(), loop.end(), v.begin());
      if (loop.size() == 3)
        mesh_.triangles.push_back({v[0], v[1], v[2]}, label);
      else
        mesh_.quads.push_back(v, label);
    }
  }

  std::size_t n_;
  Mesh mesh_;
};

struct Named_mesh {
  std::string name;
  Mesh mesh;
};

// Each kind of cells alone and all together, with and without a region around.
inline std::vector<Named_mesh> solver_meshes() {
  std::vector<Named_mesh> result;
  for (const auto& m : std::vector<std::array<std::string, 2>>{{"T", "1"},
                                                               {"W", "1"},
                                                               {"H", "1"},
                                                               {"P", "1"},
                                                               {"TT", "12"},
                                                               {"WW", "12"},
                                                               {"HH", "12"},
                                                               {"PP", "12"},
                                                               {"TW", "12"},
                                                               {"HHXW", "1111"},
                                                               {"HXWT", "1112"},
                                                               {"HXWW", "2211"},
                                                               {"HPXWW", "12131"}})
    result.push_back({m[0] + "_" + m[1], Layered_box::make(2, m[0], m[1])});
  return result;
}

// The facets of each patch by their corners.
inline std::map<int, std::set<Corners>> facets_of(const Mesh& m) {
  std::map<int, std::set<Corners>> result;
  for (std::size_t i = 0; i < m.triangles.size(); ++i)
    result[m.triangles.label[i]].insert(Corners(m.triangles.vertices[i].begin(), m.triangles.vertices[i].end()));
  for (std::size_t i = 0; i < m.quads.size(); ++i)
    result[m.quads.label[i]].insert(Corners(m.quads.vertices[i].begin(), m.quads.vertices[i].end()));
  return result;
}

// The corners of the cells of each region, in the order of the mesh; their number tells the kind.
typedef std::map<int, std::vector<std::vector<std::size_t>>> Cells_of_regions;
inline Cells_of_regions cells_of(const Mesh& m) {
  Cells_of_regions result;
  const auto add = [&](const auto& block) {
    for (std::size_t i = 0; i < block.size(); ++i)
      result[block.label[i]].emplace_back(block.vertices[i].begin(), block.vertices[i].end());
  };
  add(m.tetrahedra);
  add(m.pyramids);
  add(m.prisms);
  add(m.hexahedra);
  return result;
}

/* Directions as those of fibres, others in each cell: unit vectors at right angles, 0 in the lumen. */
inline std::vector<TM::Cell_array> fibres_of(const Mesh& m) {
  std::vector<TM::Cell_array> arrays = {{TM::circumferential_array_name, 3, {}}, {TM::longitudinal_array_name, 3, {}}};
  double angle = 0.1;
  const auto add = [&](const auto& block) {
    for (int region : block.label) {
      const double c = std::cos(angle), s = std::sin(angle);
      const std::array<double, 3> first = {c, s, 0}, second = {-s * c, c * c, s};
      for (std::size_t k = 0; k < 3; ++k) {
        arrays[0].values.push_back(region == TM::labels::lumen ? 0 : first[k]);
        arrays[1].values.push_back(region == TM::labels::lumen ? 0 : second[k]);
      }
      angle += 0.1;
    }
  };
  add(m.tetrahedra);
  add(m.pyramids);
  add(m.prisms);
  add(m.hexahedra);
  return arrays;
}

// The numbers of the cells of each region, in the order of cells_of().
inline std::map<int, std::vector<std::size_t>> cell_numbers(const Mesh& m) {
  std::map<int, std::vector<std::size_t>> result;
  std::size_t number = 0;
  for (const auto* labels : {&m.tetrahedra.label, &m.pyramids.label, &m.prisms.label, &m.hexahedra.label})
    for (int region : *labels)
      result[region].push_back(number++);
  return result;
}

// Points found by their exact coordinates.
class Point_finder {
public:
  explicit Point_finder(const Mesh& m) {
    for (std::size_t i = 0; i < m.points.size(); ++i)
      EXPECT_TRUE(index_.emplace(m.points[i], i).second);
  }
  std::size_t operator()(const Point& p) const {
    const auto found = index_.find(p);
    EXPECT_TRUE(found != index_.end()) << p;
    return found == index_.end() ? std::size_t(-1) : found->second;
  }

private:
  std::map<Point, std::size_t> index_;
};

// A facet of a region, from outside of which its corners have to turn counterclockwise.
inline void expect_outward(const Faces_of_cells& cells, int region, const std::vector<std::size_t>& loop) {
  const Corners key(loop.begin(), loop.end());
  for (std::size_t c = 0; c < cells.faces.size(); ++c)
    if (cells.region[c] == region)
      for (auto face : cells.faces[c])
        if (Corners(face.begin(), face.end()) == key) {
          std::rotate(face.begin(), std::find(face.begin(), face.end(), loop[0]), face.end());
          EXPECT_EQ(face, loop);
          return;
        }
  ADD_FAILURE() << "no cell of region " << region << " has the facet";
}

// The volume between a face and the origin: what the volume of a cell adds up from.
inline double volume_under(const std::vector<Point>& loop) {
  double sum = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const auto &a = loop[0], &b = loop[i], &c = loop[i + 1];
    sum += a.x() * (b.y() * c.z() - b.z() * c.y()) - a.y() * (b.x() * c.z() - b.z() * c.x()) +
           a.z() * (b.x() * c.y() - b.y() * c.x());
  }
  return sum / 6;
}

#endif // TUBULAR_MESHING_TEST_SOLVER_MESHES_H
