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
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* One wall, or the second one: its thickness, its layers, and how they grow outward. */
struct Wall_layers {
  Wall_thickness thickness;
  int layers;
  double growth;

  // The far sides of the layers, from 0 to 1.
  std::vector<double> levels() const {
    double sum = 0;
    for (int k = 0; k < layers; ++k)
      sum += std::pow(growth, k);
    std::vector<double> levels = {0};
    double part = 0;
    for (int k = 0; k < layers; ++k) {
      part += std::pow(growth, k);
      levels.push_back(k + 1 == layers ? 1 : part / sum);
    }
    return levels;
  }

  void check(const std::string& wall) const {
    if (thickness.is_relative() && !(thickness.radii() > 0 && thickness.radii() <= 10))
      throw Parameter_error("The thickness of the " + wall + " is " + std::to_string(thickness.radii()) +
                            ": give a part of the local radius, above 0 and at most 10; 0.2 is usual.");
    if (layers < 1 || layers > 1000)
      throw Parameter_error("The number of layers of the " + wall + " is " + std::to_string(layers) +
                            ": give at least 1 and at most 1000; 4 is usual.");
    if (!(growth >= 0.1 && growth <= 10))
      throw Parameter_error("The growth of the " + wall + "'s layers is " + std::to_string(growth) +
                            ": give the ratio of successive thicknesses, from 0.1 to 10; 1 is usual.");
  }

  // At a point of the surface.
  double at(const Vector_3d& p, double radius, const char* wall) const {
    const double t = thickness(as<Point_3>(p), radius);
    if (thickness.is_relative())
      return t;
    if (!(t > 0) || !std::isfinite(t))
      throw Input_error(std::string("The thickness of the ") + wall + " at " + place_of(p) + " is " +
                        std::to_string(t) + "; a wall is thicker than 0 everywhere.");
    if (t > 10 * radius)
      throw Input_error(std::string("The thickness of the ") + wall + " at " + place_of(p) +
                        " is more than ten times the local radius, " + std::to_string(t / radius) +
                        " times: is it in the unit of the surface?");
    return t;
  }
};

class Wall_extruder {
public:
  typedef std::uint32_t Index;

  Wall_extruder(Mixed_mesh& mesh, const Extrude_wall_options& options)
      : mesh_(mesh)
      , first_{options.wall_thickness, options.wall_layers, options.wall_growth}
      , second_{options.second_wall_thickness, options.second_wall_layers, options.second_wall_growth}
      , has_second_(second_.thickness.is_there())
      , materials_(options.materials)
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
    std::vector<double> shares;
    std::vector<double> wanted = thicknesses(surface, radius, shares);
    const Layer_options options = options_for_layers(std::move(shares));
    std::vector<Vector_3d> points = surface.points;
    std::vector<Layer_surface::Triangle> closure;
    wall.caps(points, closure);
    const std::vector<Layer_surface::Triangle> caps = closure;
    if (!wall.has_all_caps(surface)) // an open surface: then the wall is closed by its own near side
      closure = surface.triangles(true);
    const Layer_engine engine(surface, std::move(points), caps, std::move(closure), std::move(wanted), options);

    Layer_report report = report_of(surface, engine);
    report.relabelled_facets = wall.number_of_relabelled_facets();
    for (Index v = 0; v < report.vertices && !is_relative(); ++v)
      report.steep_vertices += engine.wanted(v) < 0.99 * engine.asked(v);
    mesh_.triangles = std::move(facets.triangles);
    mesh_.quads = std::move(facets.quads);
    build(surface, wall.mesh_vertices(), engine, options.levels, report);
    return report;
  }

private:
  bool is_relative() const {
    return first_.thickness.is_relative() && (!has_second_ || second_.thickness.is_relative());
  }

  /* Of both walls, one a vertex; and the first one's shares of it, where these are not the same everywhere. */
  std::vector<double> thicknesses(const Layer_surface& surface, Length_function radius,
                                  std::vector<double>& shares) const {
    if (is_relative())
      return multiples_of_radius(surface, radius,
                                 first_.thickness.radii() + (has_second_ ? second_.thickness.radii() : 0));
    const std::vector<double> radii = multiples_of_radius(surface, radius, 1);
    std::vector<double> wanted;
    for (Index v = 0; v < radii.size(); ++v) {
      const double first = first_.at(surface.points[v], radii[v], "wall");
      const double second = has_second_ ? second_.at(surface.points[v], radii[v], "second wall") : 0;
      wanted.push_back(first + second);
      if (has_second_)
        shares.push_back(first / (first + second));
    }
    return wanted;
  }

  Layer_options options_for_layers(std::vector<double> shares) const {
    Layer_options options;
    options.tetrahedral = tetrahedral_;
    options.threads = threads_;
    if (!has_second_) {
      options.levels = first_.levels();
    } else if (!shares.empty()) {
      options.levels = Layer_levels(first_.levels(), second_.levels(), std::move(shares));
    } else {
      const double first = first_.thickness.radii(), second = second_.thickness.radii();
      std::vector<double> levels;
      for (double level : first_.levels())
        levels.push_back(first * level / (first + second));
      for (double level : second_.levels())
        if (level > 0)
          levels.push_back(level == 1 ? 1 : (first + second * level) / (first + second));
      options.levels = std::move(levels);
    }
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
             const Layer_levels& levels, Layer_report& report) {
    const std::size_t layers = levels.size() - 1, first = std::size_t(first_.layers);
    report.prisms = mesh_.prisms.size();
    report.hexahedra = mesh_.hexahedra.size();
    report.tetrahedra = mesh_.tetrahedra.size();
    const int outer = labels::outer_wall_for(largest_patch(surface));
    Layer_builder builder(surface, base, layers, false, mesh_);
    builder.add_points(levels, [&](Index v) { return engine.vector(v); });
    const std::vector<int> regions = regions_of(surface);
    builder.add_cells(0, first, regions, tetrahedral_);
    builder.add_cells(first, layers, labels::wall_region + 1, tetrahedral_);
    report.prisms = mesh_.prisms.size() - report.prisms;
    report.hexahedra = mesh_.hexahedra.size() - report.hexahedra;
    report.tetrahedra = mesh_.tetrahedra.size() - report.tetrahedra;
    if (has_second_)
      builder.add_facets(first, outer + (labels::middle_wall - labels::outer_wall));
    builder.add_facets(layers, outer);
    builder.add_rings([&](int label) { return outer + label; }, tetrahedral_);
    builder.add_interfaces(0, first, regions, labels::material_interface(outer), tetrahedral_);
    add_names(surface, regions, outer);
    extend_point_arrays(base, layers);
  }

  // Of the first wall, one a face.
  std::vector<int> regions_of(const Layer_surface& surface) const {
    std::vector<int> regions(surface.faces.size(), labels::wall_region);
    for (std::size_t i = 0; i < regions.size() && !materials_.empty(); ++i) {
      const Layer_surface::Face& f = surface.faces[i];
      const int n = Layer_surface::degree(f);
      Vector_3d middle;
      for (int k = 0; k < n; ++k)
        middle += (1. / n) * surface.points[f[std::size_t(k)]];
      regions[i] = materials_.region(as<Point_3>(middle));
    }
    return regions;
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

  void add_names(const Layer_surface& surface, const std::vector<int>& regions, int outer) {
    for (const Layer_surface::Rim_edge& e : surface.rim_edges)
      if (e.label >= labels::inlet && mesh_.patch_names.count(e.label) == 0)
        mesh_.patch_names[e.label] = lumen_patch_names(e.label - labels::inlet + 1)[e.label];
    mesh_.patch_names.insert({labels::wall, "wall"});
    add_wall_patch_names(mesh_.patch_names, has_second_);
    if (std::count(regions.begin(), regions.end(), labels::wall_region) > 0)
      mesh_.region_names[labels::wall_region] = "wall";
    for (const auto& name : materials_.names) // of all, whether or not they are on this vessel
      mesh_.region_names.insert(name);
    if (!materials_.empty()) {
      std::set<std::string> used;
      for (const auto& name : mesh_.patch_names)
        used.insert(name.second);
      mesh_.patch_names[labels::material_interface(outer)] = unused_name("material_interface", used);
    }
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
  const bool has_second_;
  const Wall_materials materials_;
  const bool tetrahedral_;
  const int threads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_LAYERS_INTERNAL_WALL_EXTRUDER_H
