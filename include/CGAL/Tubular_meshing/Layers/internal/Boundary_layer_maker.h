// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOUNDARY_LAYER_MAKER_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOUNDARY_LAYER_MAKER_H

#include <CGAL/Tubular_meshing/Layers/boundary_layer_heights.h>
#include <CGAL/Tubular_meshing/Layers/extrude_boundary_layer.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_builder.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_engine.h>
#include <CGAL/Tubular_meshing/Layers/internal/Wall_facets.h>
#include <CGAL/Tubular_meshing/Plane/triangulate_in_metric.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* The triangles that close a rim, their vertices first those of the rim. */
struct Rim_cap {
  std::vector<Vector_3d> inner_points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

/* Meshes the inside of a rim, in its plane, by triangles of the rim's mean edge. */
inline Rim_cap mesh_rim(const std::vector<Vector_3d>& rim, const Vector_3d& normal) {
  typedef Kernel::Point_2 Point_2;
  const Plane_frame frame(rim[0], normal);
  std::vector<std::vector<Point_2>> polygons(1);
  double length = 0;
  for (std::size_t i = 0; i < rim.size(); ++i) {
    const auto p = frame.in_plane(rim[i]);
    polygons[0].emplace_back(p[0], p[1]);
    length += norm(rim[(i + 1) % rim.size()] - rim[i]) / double(rim.size());
  }
  const Metric_tensor_2 metric(1 / (length * length), 0, 1 / (length * length));
  const auto plane = triangulate_in_metric(polygons, [&](const Point_2&) { return metric; });
  Rim_cap cap;
  cap.triangles = plane.triangles;
  for (std::size_t i = rim.size(); i < plane.points.size(); ++i) {
    // as far from the plane as the rim is, which is not at all but for rounding, or where it is not flat
    double height = 0, weights = 0;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      const double d2 = CGAL::squared_distance(plane.points[i], polygons[0][k]);
      height += frame.height(rim[k]) / (d2 * d2);
      weights += 1 / (d2 * d2);
    }
    cap.inner_points.push_back(frame.point(plane.points[i].x(), plane.points[i].y(), height / weights));
  }
  return cap;
}

/* Makes the layers and what they leave. */
class Boundary_layer_maker {
public:
  typedef std::uint32_t Index;
  typedef Surface::Vertex_index Vertex;

  Boundary_layer_maker(Mixed_mesh facets, const Boundary_layer_heights& heights, Boundary_layer& result)
      : facets_(std::move(facets))
      , heights_(heights)
      , result_(result) {}

  void run(Length_function radius) {
    const Wall_facets wall(facets_);
    const Layer_surface surface = wall.surface(true);
    check_openings(wall, surface);
    Layer_options options;
    options.levels = heights_.levels();
    options.part_of_gap = 0.5;
    options.inward = true;
    options.threads = heights_.threads;
    const Layer_engine engine(surface, surface.points, {}, {}, multiples_of_radius(surface, radius, heights_.total()),
                              options);
    result_.report = report_of(surface, engine);
    result_.report.relabelled_facets = wall.number_of_relabelled_facets();
    make_layers(surface, wall.mesh_vertices(), engine, options.levels);
    make_inner_surface(surface);
  }

private:
  void check_openings(const Wall_facets& wall, const Layer_surface& surface) const {
    if (!wall.has_all_caps(surface))
      throw Input_error("The surface is open: boundary layers need it closed at its openings.");
    for (const Layer_surface::Rim& rim : surface.rims)
      for (Index e : rim.edges)
        if (surface.rim_edges[e].label != surface.rim_edges[rim.edges[0]].label)
          throw Input_error("The rim at " + place_of(surface.points[surface.rim_edges[e].source]) +
                            " is that of two patches; boundary layers need one patch an opening.");
  }

  void make_layers(const Layer_surface& surface, const std::vector<Index>& vertices, const Layer_engine& engine,
                   const Layer_levels& levels) {
    Mixed_mesh& mesh = result_.layers;
    const std::size_t layers = levels.size() - 1;
    std::vector<Index> base;
    for (Index v : vertices) {
      base.push_back(Index(mesh.points.size()));
      mesh.points.push_back(facets_.points[v]);
    }
    Layer_builder builder(surface, base, layers, true, mesh);
    builder.add_points(levels, [&](Index v) { return engine.vector(v); });
    builder.add_cells(0, layers, labels::lumen, false);
    builder.add_facets(0, labels::wall);
    builder.add_rings([](int label) { return label; }, false);
    mesh.region_names = {{labels::lumen, "lumen"}};
    mesh.patch_names = lumen_patch_names(number_of_openings(surface));
    result_.report.prisms = mesh.prisms.size();
    result_.report.hexahedra = mesh.hexahedra.size();
    for (Index v = 0; v < base.size(); ++v)
      result_.mesh_points.push_back(builder.point(v, layers));
  }

  static int number_of_openings(const Layer_surface& surface) {
    int largest = labels::wall;
    for (const Layer_surface::Rim_edge& e : surface.rim_edges)
      largest = (std::max)(largest, e.label);
    return largest - labels::wall;
  }

  void make_inner_surface(const Layer_surface& surface) {
    for (Index p : result_.mesh_points)
      result_.inner.add_vertex(result_.layers.points[p]);
    for (const Layer_surface::Face& f : surface.faces)
      if (Layer_surface::degree(f) == 4)
        add_face({Vertex(f[3]), Vertex(f[2]), Vertex(f[1]), Vertex(f[0])}, labels::wall);
      else
        add_face({Vertex(f[2]), Vertex(f[1]), Vertex(f[0])}, labels::wall);
    for (const Layer_surface::Rim& rim : surface.rims)
      close(surface, rim);
  }

  // The rim turns as the surface with its faces turned inward does: so does a cap that is turned outward.
  void close(const Layer_surface& surface, const Layer_surface::Rim& rim) {
    std::vector<Vertex> vertices;
    std::vector<Vector_3d> points;
    for (Index e : rim.edges) {
      vertices.push_back(Vertex(surface.rim_edges[e].source));
      points.emplace_back(result_.inner.point(vertices.back()));
    }
    const Rim_cap cap = mesh_rim(points, rim.normal);
    for (const Vector_3d& p : cap.inner_points) {
      vertices.push_back(result_.inner.add_vertex(Point_3(p.x, p.y, p.z)));
      result_.mesh_points.push_back(no_point);
    }
    for (const auto& t : cap.triangles)
      add_face({vertices[t[0]], vertices[t[1]], vertices[t[2]]}, surface.rim_edges[rim.edges[0]].label);
  }

  void add_face(const std::vector<Vertex>& vertices, int label) {
    const auto f = result_.inner.add_face(vertices);
    if (f == Surface::null_face())
      throw Meshing_error("The surface inside of the boundary layers is not manifold at " +
                          place_of(Vector_3d(result_.inner.point(vertices[0]))) + "; repair the surface first.");
    result_.patch[f] = label;
  }

  Mixed_mesh facets_;
  const Boundary_layer_heights heights_;
  Boundary_layer& result_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_BOUNDARY_LAYER_MAKER_H
