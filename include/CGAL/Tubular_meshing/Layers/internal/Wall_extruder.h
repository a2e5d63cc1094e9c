// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_EXTRUDER_H
#define CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_EXTRUDER_H

#include <CGAL/Tubular_meshing/Layers/extrude_wall.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_builder.h>
#include <CGAL/Tubular_meshing/Layers/internal/Layer_engine.h>
#include <CGAL/Tubular_meshing/Layers/internal/Wall_facets.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

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

class Wall_extruder {
public:
  typedef std::uint32_t Index;

  Wall_extruder(Mixed_mesh& mesh, const Extrude_wall_options& options)
      : mesh_(mesh)
      , first_{options.wall_thickness, options.wall_layers, options.wall_growth}
      , second_{options.second_wall_thickness, options.second_wall_layers, options.second_wall_growth}
      , has_second_(second_.thickness != 0)
      , tetrahedral_(options.tetrahedral_wall)
      , threads_(options.number_of_threads) {
    first_.check("wall");
    if (has_second_)
      second_.check("second wall");
    check_mesh();
  }

  Layer_report run(Length_function radius) {
    Mixed_mesh facets; // the mesh stays as it was if there is no wall
    facets.points = mesh_.points;
    facets.triangles = mesh_.triangles;
    facets.quads = mesh_.quads;
    if (tetrahedral_)
      split_wall_quads(facets);
    const Wall_facets wall(facets);
    const Layer_surface surface = wall.surface(false);
    const Layer_options options = options_for_layers();
    std::vector<Vector_3d> points = surface.points;
    std::vector<Layer_surface::Triangle> closure;
    wall.caps(points, closure);
    const std::vector<Layer_surface::Triangle> caps = closure;
    if (!wall.has_all_caps(surface)) // an open surface: then the wall is closed by its own near side
      closure = surface.triangles(true);
    const Layer_engine engine(surface, std::move(points), caps, std::move(closure),
                              multiples_of_radius(surface, radius, total_thickness()), options);

    Layer_report report = report_of(surface, engine);
    report.relabelled_facets = wall.number_of_relabelled_facets();
    mesh_.triangles = std::move(facets.triangles);
    mesh_.quads = std::move(facets.quads);
    build(surface, wall.mesh_vertices(), engine, options.levels, report);
    return report;
  }

private:
  double total_thickness() const { return first_.thickness + (has_second_ ? second_.thickness : 0); }

  Layer_options options_for_layers() const {
    std::vector<double> heights = {0};
    first_.append_heights(heights);
    if (has_second_)
      second_.append_heights(heights);
    Layer_options options;
    for (double h : heights)
      options.levels.push_back(h / heights.back());
    options.tetrahedral = tetrahedral_;
    options.threads = threads_;
    return options;
  }

  void check_mesh() const {
    for (const auto* regions :
         {&mesh_.tetrahedra.label, &mesh_.pyramids.label, &mesh_.prisms.label, &mesh_.hexahedra.label})
      for (int region : *regions)
        if (region >= labels::wall_region)
          throw Input_error("The mesh has cells of region " + std::to_string(region) +
                            " already; a wall is grown on a lumen, region " + std::to_string(labels::lumen) +
                            ", or on a surface.");
    for (std::size_t i = 0; i < mesh_.points.size(); ++i)
      if (!std::isfinite(squared_norm(Vector_3d(mesh_.points[i]))))
        throw Input_error("Point " + std::to_string(i) + " of the mesh has coordinates that are not finite.");
  }

  // Along the better diagonal; cells that have quads there would have to be split too.
  void split_wall_quads(Mixed_mesh& facets) const {
    Element_block<4> kept;
    for (std::size_t i = 0; i < facets.quads.size(); ++i) {
      const auto& q = facets.quads.vertices[i];
      if (facets.quads.label[i] != labels::wall) {
        kept.push_back(q, facets.quads.label[i]);
        continue;
      }
      if (mesh_.pyramids.size() + mesh_.prisms.size() + mesh_.hexahedra.size() > 0)
        throw Parameter_error("A wall of tetrahedra needs triangles to grow on, but the lumen has cells with quads at "
                              "the wall; let the wall be of hexahedra there, or fill the lumen with tetrahedra.");
      const auto squared_diagonal = [&](std::size_t k) {
        return squared_norm(Vector_3d(facets.points[q[k + 2]]) - Vector_3d(facets.points[q[k]]));
      };
      const std::size_t k = squared_diagonal(1) < squared_diagonal(0) ? 1 : 0;
      facets.triangles.push_back({q[k], q[k + 1], q[k + 2]}, labels::wall);
      facets.triangles.push_back({q[k], q[k + 2], q[(k + 3) % 4]}, labels::wall);
    }
    facets.quads = std::move(kept);
  }

  void build(const Layer_surface& surface, const std::vector<Index>& base, const Layer_engine& engine,
             const std::vector<double>& levels, Layer_report& report) {
    const std::size_t layers = levels.size() - 1, first = std::size_t(first_.layers);
    report.prisms = mesh_.prisms.size();
    report.hexahedra = mesh_.hexahedra.size();
    report.tetrahedra = mesh_.tetrahedra.size();
    const int outer = labels::outer_wall_for(largest_patch(surface));
    Layer_builder builder(surface, base, layers, false, mesh_);
    builder.add_points(levels, [&](Index v) { return engine.vector(v); });
    builder.add_cells(0, first, labels::wall_region, tetrahedral_);
    builder.add_cells(first, layers, labels::wall_region + 1, tetrahedral_);
    report.prisms = mesh_.prisms.size() - report.prisms;
    report.hexahedra = mesh_.hexahedra.size() - report.hexahedra;
    report.tetrahedra = mesh_.tetrahedra.size() - report.tetrahedra;
    if (has_second_)
      builder.add_facets(first, outer + (labels::middle_wall - labels::outer_wall));
    builder.add_facets(layers, outer);
    builder.add_rings([&](int label) { return outer + label; }, tetrahedral_);
    add_names(surface);
    extend_point_arrays(base, layers);
  }

  // Of the lumen's own.
  int largest_patch(const Layer_surface& surface) const {
    int largest = labels::wall;
    for (const auto* patches : {&mesh_.triangles.label, &mesh_.quads.label})
      for (int label : *patches)
        largest = (std::max)(largest, label);
    for (const Layer_surface::Rim_edge& e : surface.rim_edges)
      largest = (std::max)(largest, e.label);
    if (!mesh_.patch_names.empty())
      largest = (std::max)(largest, mesh_.patch_names.rbegin()->first);
    return largest;
  }

  void add_names(const Layer_surface& surface) {
    for (const Layer_surface::Rim_edge& e : surface.rim_edges)
      if (e.label >= labels::inlet && mesh_.patch_names.count(e.label) == 0)
        mesh_.patch_names[e.label] = lumen_patch_names(e.label - labels::inlet + 1)[e.label];
    mesh_.patch_names.insert({labels::wall, "wall"});
    add_wall_patch_names(mesh_.patch_names, has_second_);
    mesh_.region_names[labels::wall_region] = "wall";
    if (has_second_)
      mesh_.region_names[labels::wall_region + 1] = "second_wall";
  }

  // A point of the wall has the values of the point of the lumen below it.
  void extend_point_arrays(const std::vector<Index>& base, std::size_t layers) {
    for (Point_array& a : mesh_.point_arrays) {
      const std::size_t n = std::size_t(a.components);
      if (a.values.size() + layers * base.size() * n != mesh_.points.size() * n)
        continue;
      for (std::size_t k = 0; k < layers; ++k)
        for (Index v : base)
          for (std::size_t i = 0; i < n; ++i)
            a.values.push_back(a.values[v * n + i]);
    }
  }

  Mixed_mesh& mesh_;
  const Wall_layers first_, second_;
  const bool has_second_, tetrahedral_;
  const int threads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_EXTRUDER_H
