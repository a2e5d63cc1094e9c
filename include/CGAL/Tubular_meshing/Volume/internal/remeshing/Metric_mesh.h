// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_MESH_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_MESH_H

#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/Volume/internal/Patch_projection.h>
#include <CGAL/Tubular_meshing/Volume/internal/Topology_optimizer.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Surface_locations.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/Vertex_clock.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/metric_quality.h>
#include <CGAL/Tubular_meshing/Volume/internal/remeshing/remeshing_input.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Whether a tetrahedron is positively oriented with a thousand times the rounding error of its determinant to spare:
 * exact arithmetic would say the same, and still would if the coordinates were written to a file with fewer digits.
 * `u`, `v`, `w`: its edges from `a`; `determinant`: u (v x w). */
inline bool is_positive(const Vector_3d& a, const Vector_3d& u, const Vector_3d& v, const Vector_3d& w,
                        double determinant) {
  const auto magnitude = [](const Vector_3d& x) { return std::abs(x.x) + std::abs(x.y) + std::abs(x.z); };
  const double rounding = std::numeric_limits<double>::epsilon() *
                          (magnitude(a) + magnitude(u) + magnitude(v) + magnitude(w)); // of a difference
  const double lu = magnitude(u), lv = magnitude(v), lw = magnitude(w);
  return determinant > 1000 * rounding * (lu * lv + lv * lw + lw * lu);
}
inline bool is_positive(const Vector_3d& a, const Vector_3d& b, const Vector_3d& c, const Vector_3d& d) {
  const Vector_3d u = b - a, v = c - a, w = d - a;
  return is_positive(a, u, v, w, dot(u, cross(v, w)));
}

/* A mesh with the metric at its vertices, and where each of them lies: what all operations of the remesher work on.
 *
 * On `layer_patches` the height of elements counts as such. With `keep_boundary` all vertices on labelled facets are
 * fixed and so are the facets.
 */
class Metric_mesh {
public:
  typedef Tetrahedron_store Store;
  typedef Store::Index Index;

  Metric_mesh(Store& store, Metric_function field, const Patch_projection& projection, bool keep_boundary,
              std::vector<int> layer_patches, int threads)
      : store(store)
      , projection(projection)
      , keep_boundary(keep_boundary)
      , layer_patches(std::move(layer_patches))
      , threads(threads)
      , field_(field)
      , limits_(extent_of(store)) {
    metric_.resize(store.number_of_vertices());
    update_metrics();
    on_surface_.assign(metric_.size(), 0);
    clock.resize(metric_.size());
    Metric_limits::check_number_of_tetrahedra(number_of_unit_tetrahedra());
    location_ = locations.of_vertices(store, [&](Index v) { return projection.is_fixed(store.point(v), 1); });
    if (keep_boundary)
      for (Surface_location& l : location_)
        if (l.dimension < 3)
          l = {0, 0};
  }

  Store& store;
  const Patch_projection& projection;
  Surface_locations locations;
  const bool keep_boundary;
  const std::vector<int> layer_patches; // with a layer whose height counts
  const int threads;
  Vertex_clock clock;

  const Metric_tensor_3& metric(Index v) const { return metric_[v]; }
  const Surface_location& location(Index v) const { return location_[v]; }
  Metric_point at(Index v) const { return {store.point(v), metric_[v]}; }
  Metric_point at(const Vector_3d& p) const {
    const Metric_point result = {p, field_(Point_3(p.x, p.y, p.z))};
    limits_.check(result.metric, p);
    return ratio_ < no_limit ? Metric_point{p, limited(result.metric)} : result;
  }

  /* From now on the metric is the field's with its small sizes enlarged to where no size is more than `ratio` times
   * another one at the same place. */
  void limit_ratio(double ratio) {
    ratio_ = ratio;
    update_metrics();
    clock.wake_all();
  }
  static constexpr double no_limit = 1e300;

  // Of the tetrahedra that the metric asks for, the share that is to have sizes in a ratio above this.
  double share_above_ratio(double ratio) const {
    double all = 0, above = 0;
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t)) {
        const double n = shape(store[t].v).volume;
        all += n;
        if (metric_[store[t].v[0]].anisotropy() > ratio)
          above += n;
      }
    return all > 0 ? above / all : 0;
  }

  // Whether a vertex with a location on the surface is known to lie there.
  bool is_on_surface(Index v) const { return on_surface_[v] != 0; }

  Index add_vertex(const Metric_point& p, const Surface_location& l, bool on_surface) {
    const Index v = store.add_vertex(p.position);
    if (v == metric_.size()) {
      metric_.push_back(p.metric);
      location_.push_back(l);
      on_surface_.push_back(0);
      clock.resize(metric_.size());
    }
    clock.wake(v);
    metric_[v] = p.metric;
    location_[v] = l;
    on_surface_[v] = on_surface;
    return v;
  }
  void move(Index v, const Metric_point& p, bool on_surface) {
    store.move(v, p.position);
    metric_[v] = p.metric;
    on_surface_[v] = on_surface;
  }

  // The nearest point of the surface at a location.
  Vector_3d project(const Vector_3d& p, const Surface_location& l) const {
    return l.dimension == 2   ? projection.to_patch(p, l.id)
           : l.dimension == 1 ? projection.to_rim(p, locations.patches_of_rim(l.id))
                              : p;
  }

  // By vertex; the mesh is without metrics after that.
  std::vector<Metric_tensor_3> take_metrics() { return std::move(metric_); }

  /* The length in the metric that edges are to have: one, or a multiple of it on the way there. Over a coarse edge the
   * metric varies much; sizes that grow geometrically along it tell its length, and the volume of a tetrahedron, much more
   * nearly as the finer mesh will have them than a metric that varies linearly. */
  void set_unit(double unit) {
    unit_ = unit;
    clock.wake_all();
  }
  double unit() const { return unit_; }

  double length(const Metric_point& p, const Metric_point& q) const {
    return unit_ > 1 ? Metric_tensor_3::edge_length(q.position - p.position, p.metric, q.metric) : metric_length(p, q);
  }
  double length(Index v, Index w) const { return length(at(v), at(w)); }
  Metric_shape shape(const Store::Vertices& v) const {
    const Vector_3d& p = store.point(v[0]);
    return metric_shape(store.point(v[1]) - p, store.point(v[2]) - p, store.point(v[3]) - p,
                        0.25 * (metric_[v[0]] + metric_[v[1]] + metric_[v[2]] + metric_[v[3]]));
  }
  // The measures that flips compare, see Topology_optimizer.
  double tetrahedron(Index a, Index b, Index c, Index d) const {
    const Vector_3d &p = store.point(a), u = store.point(b) - p, v = store.point(c) - p, w = store.point(d) - p;
    const double determinant = dot(u, cross(v, w));
    if (!is_positive(p, u, v, w, determinant))
      return 0;
    const Metric_tensor_3 mean = 0.25 * (metric_[a] + metric_[b] + metric_[c] + metric_[d]);
    return metric_shape(u, v, w, determinant, mean).quality();
  }
  double triangle(Index a, Index b, Index c) const { return metric_quality(at(a), at(b), at(c)); }

  // As the metrics at the vertices of the mesh foretell.
  double number_of_unit_tetrahedra() const {
    double n = 0;
    for (Index t = 0; t < store.number_of_slots(); ++t)
      if (store.is_alive(t))
        n += shape(store[t].v).volume;
    return n;
  }

  /* For each vertex, the mean volume in the metric of the tetrahedra around it, over that of the regular one of unit
   * edges, smoothed once over the neighbors: whether vertices are too many there (below one) or too few. Linear. */
  std::vector<float> local_volumes() const {
    const std::vector<Index> tetrahedra = store.tetrahedra();
    std::vector<float> of_vertex(store.number_of_vertices()), number(store.number_of_vertices());
    std::vector<float> of_tetrahedron(store.number_of_slots());
    for_each_range(tetrahedra.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t k = first; k < last; ++k)
        of_tetrahedron[tetrahedra[k]] = float(unit_volume(store[tetrahedra[k]].v));
    });
    for (int round = 0; round < 2; ++round) {
      std::fill(of_vertex.begin(), of_vertex.end(), 0.f);
      std::fill(number.begin(), number.end(), 0.f);
      for (Index t : tetrahedra)
        for (Index v : store[t].v) {
          of_vertex[v] += of_tetrahedron[t];
          number[v] += 1;
        }
      for (std::size_t v = 0; v < of_vertex.size(); ++v)
        of_vertex[v] /= (std::max)(number[v], 1.f);
      for (Index t : tetrahedra) {
        const auto& v = store[t].v;
        of_tetrahedron[t] = (of_vertex[v[0]] + of_vertex[v[1]] + of_vertex[v[2]] + of_vertex[v[3]]) / 4;
      }
    }
    return of_vertex;
  }

  // Vertices and tetrahedra along a space-filling curve; the unused are gone.
  void renumber() {
    std::vector<Point_3> points;
    std::vector<std::size_t> order;
    for (Index v = 0; v < store.number_of_vertices(); ++v) {
      const Vector_3d& p = store.point(v);
      points.emplace_back(p.x, p.y, p.z);
      if (store.is_used(v))
        order.push_back(v);
    }
    order_in_space(points, order, threads);
    put_in_order(order, metric_);
    put_in_order(order, location_);
    put_in_order(order, on_surface_);
    clock.renumber(order);
    store.renumber(std::vector<Index>(order.begin(), order.end()), threads);
  }

private:
  void update_metrics() {
    for_each_range(metric_.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t v = first; v < last; ++v)
        if (store.is_used(Index(v)))
          metric_[v] = at(store.point(Index(v))).metric;
    });
  }
  // Over that of the regular tetrahedron of the unit at hand.
  double unit_volume(const Store::Vertices& v) const {
    if (!(unit_ > 1))
      return shape(v).volume;
    double density = 1;
    for (Index w : v)
      density *= std::sqrt(std::sqrt(metric_[w].density()));
    const Vector_3d& p = store.point(v[0]);
    return std::sqrt(2.) * dot(store.point(v[1]) - p, cross(store.point(v[2]) - p, store.point(v[3]) - p)) * density /
           (unit_ * unit_ * unit_);
  }
  Metric_tensor_3 limited(const Metric_tensor_3& m) const {
    const double largest = m.sizes()[2];
    return m.clamped(largest / ratio_, largest);
  }

  static double extent_of(const Store& store) {
    Vector_3d low = store.point(store[0].v[0]), high = low;
    for (Index v = 0; v < store.number_of_vertices(); ++v)
      if (store.is_used(v)) {
        const Vector_3d& p = store.point(v);
        low = {(std::min)(low.x, p.x), (std::min)(low.y, p.y), (std::min)(low.z, p.z)};
        high = {(std::max)(high.x, p.x), (std::max)(high.y, p.y), (std::max)(high.z, p.z)};
      }
    return norm(high - low);
  }

  Metric_function field_;
  const Metric_limits limits_;
  double ratio_ = no_limit, unit_ = 1;
  std::vector<Metric_tensor_3> metric_;
  std::vector<Surface_location> location_;
  std::vector<char> on_surface_; // written by several threads, for vertices of their own
};

typedef Topology_optimizer<Surface_flip_guard, const Metric_mesh&> Remeshing_flips;

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_REMESHING_METRIC_MESH_H
