// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_IMPL_H
#define CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_IMPL_H

#include <CGAL/Tubular_meshing/Hexahedra/insert_wall_layers.h>
#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/base/Vector_3d.h>
#include <CGAL/Tubular_meshing/base/cell_topology.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

class Wall_layer_inserter {
public:
  typedef std::uint32_t Index;

  Wall_layer_inserter(Mixed_mesh& mesh, Length_function radius, const Extrude_boundary_layer_options& options)
      : mesh_(mesh)
      , radius_(radius)
      , heights_(options) {}

  Layer_report run() {
    find_columns();
    find_directions();
    find_radii();
    add_points();
    give_way();
    report_heights();
    cut_hexahedra();
    cut_facets();
    return report_;
  }

private:
  static constexpr Index none = (std::numeric_limits<Index>::max)();
  static constexpr double most_room = 0.85; // of an edge inward, what layers may take up

  static constexpr int hexahedron_edges[12][2] = {{0, 1}, {1, 2}, {2, 3}, {3, 0}, {4, 5}, {5, 6},
                                                  {6, 7}, {7, 4}, {0, 4}, {1, 5}, {2, 6}, {3, 7}};

  typedef std::array<Index, 4> Quad;

  static Quad key(Quad q) {
    std::sort(q.begin(), q.end());
    return q;
  }
  struct Hash {
    std::size_t operator()(const Quad& q) const {
      std::size_t h = 0;
      for (Index i : q)
        h = (h ^ i) * 0x9e3779b97f4a7c15ull;
      return h ^ (h >> 32);
    }
  };

  /* The vertex inward of each on the wall, and the hexahedron inward of each quad. */
  void find_columns() {
    inward_.assign(mesh_.points.size(), none);
    std::unordered_map<Quad, std::size_t, Hash> quad_at;
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k)
      if (mesh_.quads.label[k] == labels::wall)
        quad_at.emplace(key(mesh_.quads.vertices[k]), k);
    cell_of_.assign(mesh_.quads.size(), none);
    for (std::size_t i = 0; i < mesh_.hexahedra.size(); ++i) {
      const auto& h = mesh_.hexahedra.vertices[i];
      int walls = 0;
      for (const auto& f : Cell_topology<8>::quads()) {
        const auto found = quad_at.find(key({{h[f[0]], h[f[1]], h[f[2]], h[f[3]]}}));
        if (found == quad_at.end())
          continue;
        if (++walls > 1)
          throw Input_error("A hexahedron has two facets on the wall: no layers can be put into it.");
        cell_of_[found->second] = Index(i);
        for (const auto& e : hexahedron_edges) {
          const bool first = std::find(f.begin(), f.end(), e[0]) != f.end();
          const bool second = std::find(f.begin(), f.end(), e[1]) != f.end();
          if (first != second)
            set_inward(h[first ? e[0] : e[1]], h[first ? e[1] : e[0]]);
        }
      }
    }
    for (std::size_t k = 0; k < cell_of_.size(); ++k)
      if (mesh_.quads.label[k] == labels::wall && cell_of_[k] == none)
        throw Input_error("A facet of the wall has no hexahedron inside: layers cannot be put there.");
  }
  void set_inward(Index wall, Index inner) {
    if (inward_[wall] != none && inward_[wall] != inner)
      throw Input_error("A vertex on the wall has several edges inward: no layers can be put along them.");
    inward_[wall] = inner;
  }

  // The wall's normals, inward; in the plane of an opening where the edge inward lies in it.
  void find_directions() {
    direction_.assign(mesh_.points.size(), Vector_3d());
    std::vector<Vector_3d> cap(mesh_.points.size());
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k) {
      const Quad& q = mesh_.quads.vertices[k];
      const Vector_3d n = cross(place(q[2]) - place(q[0]), place(q[3]) - place(q[1]));
      for (Index v : q)
        (mesh_.quads.label[k] == labels::wall ? direction_ : cap)[v] += -1 * n;
    }
    for (std::size_t v = 0; v < direction_.size(); ++v) {
      const Vector_3d n = normalized(cap[v]);
      direction_[v] = normalized(direction_[v] - dot(direction_[v], n) * n);
    }
  }

  /* The local radius at each vertex of the wall, smoothed: where thin and wide vessels meet, layers of columns that are
   * neighbors have about the same height. */
  void find_radii() {
    constexpr int rounds = 4;
    log_radius_.assign(mesh_.points.size(), 0);
    for_each_range(inward_.size(), heights_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        if (inward_[v] != none)
          log_radius_[v] = std::log(radius_(mesh_.points[v]));
    });
    for (int round = 0; round < rounds; ++round) {
      std::vector<double> sum(log_radius_.size(), 0), count(log_radius_.size(), 0);
      for (std::size_t k = 0; k < mesh_.quads.size(); ++k)
        if (mesh_.quads.label[k] == labels::wall)
          for (int i = 0; i < 4; ++i) {
            const Index a = mesh_.quads.vertices[k][i], b = mesh_.quads.vertices[k][(i + 1) % 4];
            sum[a] += log_radius_[b];
            sum[b] += log_radius_[a];
            ++count[a];
            ++count[b];
          }
      for (std::size_t v = 0; v < sum.size(); ++v)
        if (count[v] > 0)
          log_radius_[v] = 0.5 * log_radius_[v] + 0.5 * sum[v] / count[v];
    }
  }

  Vector_3d place(Index v) const { return Vector_3d(mesh_.points[v]); }

  /* A cubic curve from the wall to the vertex inward, that starts along the normal. */
  struct Curve {
    Vector_3d start, end, start_tangent, end_tangent;

    Vector_3d at(double t) const {
      const double s = 1 - t;
      return s * s * (1 + 2 * t) * start + t * s * s * start_tangent + t * t * (3 - 2 * t) * end +
             -1 * (t * t * s) * end_tangent;
    }
  };
  Curve curve(Index wall) const {
    const Vector_3d p = place(wall), q = place(inward_[wall]), d = q - p;
    const double length = norm(d);
    // next to a sharp edge of the wall, where the normal leads elsewhere, it turns sooner
    const double cosine = (std::max)(dot(normalized(d), direction_[wall]), 0.);
    const double bend = bend_[wall] * cosine;
    return {p, q, length * bend * direction_[wall] + (1 - bend) * d, d};
  }

  void add_points() {
    const std::size_t n = std::size_t(heights_.layers), before = mesh_.points.size();
    first_new_.assign(before, none);
    for (std::size_t v = 0; v < inward_.size(); ++v)
      if (inward_[v] != none) {
        first_new_[v] = Index(before + walls_.size() * n);
        walls_.push_back(Index(v));
      }
    mesh_.points.resize(before + walls_.size() * n);
    bend_.assign(before, 1);
    room_.assign(before, most_room);
    ratio_.assign(before, 1);
    used_.assign(before, 0);
    place_columns(walls_);
  }

  void place_columns(const std::vector<Index>& walls) {
    for_each_range(walls.size(), heights_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        place_column(walls[i]);
    });
  }

  /* Where a hexahedron between two layers is bad, which it was not before it was cut, its columns get straighter and
   * thinner, and those around them with them. */
  void give_way() {
    constexpr int rounds = 12;
    constexpr double straighter = 0.6, thinner = 0.85;
    std::vector<std::size_t> wall, quads;
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k)
      if (mesh_.quads.label[k] == labels::wall)
        wall.push_back(k);
    quads = wall;
    for (int round = 0; round < rounds; ++round) {
      std::vector<Index> columns = columns_of_bad(quads);
      if (columns.empty())
        return;
      for (Index v : columns) {
        bend_[v] *= straighter;
        room_[v] = thinner * used_[v];
      }
      place_columns(columns);
      const std::vector<char> is_changed = even_out(columns, wall);
      quads.clear();
      for (std::size_t k : wall)
        for (Index v : mesh_.quads.vertices[k])
          if (is_changed[v]) {
            quads.push_back(k);
            break;
          }
    }
  }

  // The columns round those quads of the wall whose stacks have a bad hexahedron.
  std::vector<Index> columns_of_bad(const std::vector<std::size_t>& quads) const {
    constexpr double least = 0.2, kept = 0.95; // the scaled Jacobian, and the part that is kept of a worse one
    std::vector<char> is_bad(quads.size(), 0);
    for_each_range(quads.size(), heights_.threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i) {
        const double before = quality(mesh_.hexahedra.vertices[cell_of_[quads[i]]]);
        is_bad[i] = worst_in_stack(quads[i]) < (std::min)(least, kept * before);
      }
    });
    std::vector<Index> columns;
    for (std::size_t i = 0; i < quads.size(); ++i)
      if (is_bad[i])
        columns.insert(columns.end(), mesh_.quads.vertices[quads[i]].begin(), mesh_.quads.vertices[quads[i]].end());
    std::sort(columns.begin(), columns.end());
    columns.erase(std::unique(columns.begin(), columns.end()), columns.end());
    return columns;
  }

  /* Lowers columns that are much higher than a neighbor that has been lowered. Says which columns have changed. */
  std::vector<char> even_out(std::vector<Index> lowered, const std::vector<std::size_t>& wall) {
    constexpr double steepest = 1.3; // the ratio of heights
    if (neighbor_.empty())
      find_neighbors(wall);
    std::vector<char> is_changed(inward_.size(), 0);
    for (Index v : lowered)
      is_changed[v] = 1;
    while (!lowered.empty()) {
      const Index low = lowered.back();
      lowered.pop_back();
      for (std::size_t k = first_neighbor_[low]; k < first_neighbor_[low + 1]; ++k) {
        const Index high = neighbor_[k];
        const double most = steepest * height(low);
        if (!(most > 0) || height(high) <= 1.01 * most)
          continue;
        room_[high] = used_[high] * most / height(high);
        place_column(high);
        is_changed[high] = 1;
        lowered.push_back(high);
      }
    }
    return is_changed;
  }
  void find_neighbors(const std::vector<std::size_t>& wall) {
    first_neighbor_.assign(inward_.size() + 1, 0);
    for (std::size_t k : wall)
      for (Index v : mesh_.quads.vertices[k])
        first_neighbor_[v + 1] += 2;
    for (std::size_t v = 0; v < inward_.size(); ++v)
      first_neighbor_[v + 1] += first_neighbor_[v];
    neighbor_.resize(first_neighbor_.back());
    std::vector<std::size_t> next(first_neighbor_.begin(), first_neighbor_.end() - 1);
    for (std::size_t k : wall)
      for (int i = 0; i < 4; ++i) {
        const Quad& q = mesh_.quads.vertices[k];
        neighbor_[next[q[i]]++] = q[(i + 1) % 4];
        neighbor_[next[q[i]]++] = q[(i + 3) % 4];
      }
  }
  double height(Index wall) const { return ratio_[wall] * std::exp(log_radius_[wall]); } // but for a factor

  // The hexahedron between two levels of the columns round a quad of the wall.
  std::array<Index, 8> hexahedron(const Quad& q, int level) const {
    std::array<Index, 8> h;
    for (int i = 0; i < 4; ++i) {
      h[i] = at(q[i], level + 1);
      h[i + 4] = at(q[i], level);
    }
    return h;
  }
  double quality(const std::array<Index, 8>& h) const {
    std::array<Vector_3d, 8> p;
    for (int i = 0; i < 8; ++i)
      p[i] = place(h[i]);
    return scaled_jacobian<8>(p);
  }
  double worst_in_stack(std::size_t quad) const {
    double worst = 1;
    for (int level = 0; level <= heights_.layers; ++level)
      worst = (std::min)(worst, quality(hexahedron(mesh_.quads.vertices[quad], level)));
    return worst;
  }

  void report_heights() {
    report_.vertices = walls_.size();
    double sum = 0;
    for (Index v : walls_) {
      sum += ratio_[v];
      report_.reduced_vertices += ratio_[v] < 0.99;
      if (ratio_[v] < report_.min_ratio) {
        report_.min_ratio = ratio_[v];
        report_.worst_place = mesh_.points[v];
      }
    }
    if (!walls_.empty())
      report_.mean_ratio = sum / double(walls_.size());
  }

  // Places the points between a vertex on the wall and the one inward.
  void place_column(Index wall) {
    constexpr int samples = 24;
    const Curve c = curve(wall);
    std::array<double, samples + 1> length;
    length[0] = 0;
    Vector_3d before = c.start;
    for (int i = 1; i <= samples; ++i) {
      const Vector_3d p = c.at(double(i) / samples);
      length[i] = length[i - 1] + norm(p - before);
      before = p;
    }
    const double radius = std::exp(log_radius_[wall]), wanted = radius * heights_.total();
    ratio_[wall] = (std::min)(1., room_[wall] * length[samples] / wanted);
    used_[wall] = ratio_[wall] * wanted / length[samples];
    for (int k = 1; k <= heights_.layers; ++k) {
      const double height = ratio_[wall] * radius * heights_.height(k);
      int i = 0;
      while (i + 1 < samples && length[i + 1] < height)
        ++i;
      const double t = (i + (height - length[i]) / (length[i + 1] - length[i])) / samples;
      mesh_.points[first_new_[wall] + Index(k - 1)] = as<Point_3>(c.at(t));
    }
  }

  // The vertex of a column at a level: 0 is on the wall, the last one is the vertex inward.
  Index at(Index wall, int level) const {
    return level == 0 ? wall : level > heights_.layers ? inward_[wall] : first_new_[wall] + Index(level - 1);
  }

  void cut_hexahedra() {
    for (std::size_t k = 0; k < mesh_.quads.size(); ++k) {
      if (mesh_.quads.label[k] != labels::wall)
        continue;
      const Quad q = mesh_.quads.vertices[k];
      const int label = mesh_.hexahedra.label[cell_of_[k]];
      for (int level = 0; level <= heights_.layers; ++level) {
        const std::array<Index, 8> h = hexahedron(q, level);
        if (level == heights_.layers)
          mesh_.hexahedra.vertices[cell_of_[k]] = h;
        else
          mesh_.hexahedra.push_back(h, label);
      }
      report_.hexahedra += std::size_t(heights_.layers);
    }
  }

  // Quads of openings that have an edge inward on each of two sides.
  void cut_facets() {
    const std::size_t n = mesh_.quads.size();
    for (std::size_t k = 0; k < n; ++k) {
      if (mesh_.quads.label[k] == labels::wall)
        continue;
      const Quad q = mesh_.quads.vertices[k];
      for (int i = 0; i < 4; ++i) {
        const Index a = q[i], b = q[(i + 1) % 4], c = q[(i + 2) % 4], d = q[(i + 3) % 4];
        if (inward_[a] != d || inward_[b] != c)
          continue;
        for (int level = 0; level <= heights_.layers; ++level) {
          const Quad part = {{at(a, level), at(b, level), at(b, level + 1), at(a, level + 1)}};
          if (level == heights_.layers)
            mesh_.quads.vertices[k] = part;
          else
            mesh_.quads.push_back(part, mesh_.quads.label[k]);
        }
        break;
      }
    }
  }

  Mixed_mesh& mesh_;
  Length_function radius_;
  const Boundary_layer_heights heights_;
  Layer_report report_;
  std::vector<Index> inward_;        // of each vertex on the wall, else none
  std::vector<Index> cell_of_;       // of each quad of the wall
  std::vector<double> log_radius_;   // of each vertex on the wall
  std::vector<Vector_3d> direction_; // of each vertex on the wall
  std::vector<Index> first_new_;     // of each vertex on the wall, the first of its column
  std::vector<Index> walls_;         // the vertices on the wall
  // of each vertex on the wall: how far its column bends to the normal, which part of it layers may take up and do take
  // up, and which part that is of the thickness wanted
  std::vector<double> bend_, room_, used_, ratio_;
  std::vector<std::size_t> first_neighbor_; // of each vertex on the wall, its place in neighbor_; only if needed
  std::vector<Index> neighbor_;
};

CGAL_TUBULAR_MESHING_INLINE Layer_report insert_wall_layers(Mixed_mesh& mesh, Length_function radius,
                                                            const Extrude_boundary_layer_options& options) {
  Mixed_mesh result = mesh;
  const Layer_report report = Wall_layer_inserter(result, radius, options).run();
  mesh = std::move(result);
  return report;
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_HEXAHEDRA_INSERT_WALL_LAYERS_IMPL_H
