// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_WALL_EXTRUDER_H
#define CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_WALL_EXTRUDER_H

#include <CGAL/Tubular_meshing/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Operators/Layer_report.h>
#include <CGAL/Tubular_meshing/Operators/internal/layers/Layer_builder.h>
#include <CGAL/Tubular_meshing/Operators/internal/layers/Layer_engine.h>
#include <CGAL/Tubular_meshing/Operators/internal/layers/Layer_surface.h>
#include <CGAL/Tubular_meshing/Operators/internal/layers/Wall_facets.h>
#include <CGAL/Tubular_meshing/exceptions.h>
#include <CGAL/Tubular_meshing/internal/Vector_3d.h>
#include <CGAL/Tubular_meshing/labels.h>
#include <CGAL/Tubular_meshing/parameters.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

/* One wall, or the second one: its thickness in local radii, its layers, and how they grow outward. */
struct Wall_layers {
  double thickness;
  int layers;
  double growth;

  // Appends the distances of the far sides of the layers from the lumen.
  void append_heights(std::vector<double>& heights) const {
    double sum = 0;
    for (int k = 0; k < layers; ++k)
      sum += std::pow(growth, k);
    const double first = heights.back();
    double part = 0;
    for (int k = 0; k < layers; ++k) {
      part += std::pow(growth, k);
      heights.push_back(first + thickness * (k + 1 == layers ? 1 : part / sum));
    }
  }

  void check(const std::string& wall) const {
    if (!(thickness > 0 && thickness <= 10))
      throw Parameter_error("The thickness of the " + wall + " is " + std::to_string(thickness) +
                            ": give a part of the local radius, above 0 and at most 10; 0.2 is usual.");
    if (layers < 1 || layers > 1000)
      throw Parameter_error("The number of layers of the " + wall + " is " + std::to_string(layers) +
                            ": give at least 1 and at most 1000; 4 is usual.");
    if (!(growth >= 0.1 && growth <= 10))
      throw Parameter_error("The growth of the " + wall + "'s layers is " + std::to_string(growth) +
                            ": give the ratio of successive thicknesses, from 0.1 to 10; 1 is usual.");
  }
};

struct Wall_parameters {
  Wall_layers first, second;
  bool has_second, tetrahedral;
  int threads;

  template <class NamedParameters> explicit Wall_parameters(const NamedParameters& np) {
    first = {choose(np, internal_np::wall_thickness, 0.2), choose(np, internal_np::wall_layers, 4),
             choose(np, internal_np::wall_growth, 1.)};
    second = {choose(np, internal_np::second_wall_thickness, 0.),
              choose(np, internal_np::second_wall_layers, first.layers),
              choose(np, internal_np::second_wall_growth, first.growth)};
    has_second = second.thickness != 0;
    tetrahedral = choose(np, internal_np::tetrahedral_wall, false);
    threads = choose(np, internal_np::number_of_threads, 0);
    first.check("wall");
    if (has_second)
      second.check("second wall");
  }
};

/* The thickness wanted at each vertex: a multiple of the local radius. */
template <class Point, class LocalRadius>
std::vector<double> multiples_of_radius(const Layer_surface& surface, const LocalRadius& radius, double factor) {
  std::vector<double> wanted;
  wanted.reserve(surface.number_of_vertices());
  for (const Vector_3d& p : surface.points) {
    const double r = CGAL::to_double(radius(Point(p.x, p.y, p.z)));
    if (!(r > 0 && r <= (std::numeric_limits<double>::max)()))
      throw Input_error("The local radius at " + place_of(p) + " is " + std::to_string(r) +
                        ", but layers need one above 0.");
    wanted.push_back(factor * r);
  }
  return wanted;
}

template <class Point> Layer_report<Point> report_of(const Layer_surface& surface, const Layer_engine& engine) {
  Layer_report<Point> report;
  report.vertices = surface.number_of_vertices();
  report.rounds = engine.rounds();
  double sum = 0;
  for (Layer_surface::Index v = 0; v < report.vertices; ++v) {
    const double ratio = engine.thickness(v) / engine.wanted(v);
    sum += ratio;
    report.reduced_vertices += ratio < 0.99;
    if (ratio < report.min_ratio) {
      report.min_ratio = ratio;
      report.worst_place = Point(surface.points[v].x, surface.points[v].y, surface.points[v].z);
    }
  }
  report.mean_ratio = sum / double(report.vertices);
  return report;
}

template <class Point> class Wall_extruder {
public:
  typedef std::uint32_t Index;

  Wall_extruder(Mixed_mesh<Point>& mesh, const Wall_parameters& parameters)
      : mesh_(mesh)
      , p_(parameters) {
    check_mesh();
  }

  template <class LocalRadius> Layer_report<Point> run(const LocalRadius& radius) {
    Mixed_mesh<Point> facets; // tried on copies: the mesh stays as it was if there is no wall
    facets.points = mesh_.points;
    facets.triangles = mesh_.triangles;
    facets.quads = mesh_.quads;
    if (p_.tetrahedral)
      split_wall_quads(facets);
    const Wall_facets<Point> wall(facets);
    const Layer_surface surface = wall.surface(false);
    std::vector<double> heights = {0};
    p_.first.append_heights(heights);
    if (p_.has_second)
      p_.second.append_heights(heights);
    Layer_options options;
    for (double h : heights)
      options.levels.push_back(h / heights.back());
    options.tetrahedral = p_.tetrahedral;
    options.threads = p_.threads;

    std::vector<Vector_3d> points = surface.points;
    std::vector<Box_tree::Triangle> caps;
    wall.caps(points, caps);
    const Layer_engine engine(surface, std::move(points), caps, caps,
                              multiples_of_radius<Point>(surface, radius, heights.back()), options);
    facets.points.clear();
    mesh_.triangles = std::move(facets.triangles);
    mesh_.quads = std::move(facets.quads);
    Layer_report<Point> report = report_of<Point>(surface, engine);
    report.relabelled_facets = wall.number_of_relabelled_facets();
    build(surface, wall.mesh_vertices(), engine, options.levels, report);
    return report;
  }

private:
  void check_mesh() const {
    for (const auto* names : {&mesh_.triangles.label, &mesh_.quads.label})
      (void)names;
  }

  void split_wall_quads(Mixed_mesh<Point>& facets) const { (void)facets; }

  void build(const Layer_surface& surface, const std::vector<Index>& base, const Layer_engine& engine,
             const std::vector<double>& levels, Layer_report<Point>& report) {
    const std::size_t layers = levels.size() - 1, first = std::size_t(p_.first.layers);
    report.prisms = mesh_.prisms.size();
    report.hexahedra = mesh_.hexahedra.size();
    report.tetrahedra = mesh_.tetrahedra.size();
    Layer_builder<Point> builder(surface, base, layers, false, mesh_);
    builder.add_points(levels, [&](Index v) { return engine.vector(v); });
    builder.add_cells(0, first, labels::wall_region, p_.tetrahedral);
    builder.add_cells(first, layers, labels::wall_region + 1, p_.tetrahedral);
    report.prisms = mesh_.prisms.size() - report.prisms;
    report.hexahedra = mesh_.hexahedra.size() - report.hexahedra;
    report.tetrahedra = mesh_.tetrahedra.size() - report.tetrahedra;
    if (p_.has_second)
      builder.add_facets(first, 101);
    builder.add_facets(layers, 100);
    builder.add_rings([](int label) { return 100 + label; }, p_.tetrahedral);
  }

  Mixed_mesh<Point>& mesh_;
  const Wall_parameters p_;
};

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_OPERATORS_INTERNAL_WALL_EXTRUDER_H
