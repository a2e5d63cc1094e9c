// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESH_OF_MODEL_H
#define CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESH_OF_MODEL_H

#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>
#include <CGAL/Tubular_meshing/base/Kernel.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/Quality/Mesh_check.h>
#include <CGAL/Tubular_meshing/Quality/lumen_measures.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Polygon_mesh_processing/measure.h>

#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <set>
#include <string>

namespace CGAL::Tubular_meshing::internal {

// Chords lose (2 pi^2 / 3) / N^2 of the volume with N points round a vessel, 26 % with five; facets that pass over a part
// of the vessel lose more.
constexpr double largest_loss_of_volume = 0.3;

// What a mesh of the model must be beyond valid: of the model's topology, with all of its patches, and as large.
// `surface`: the model's, where the mesh is; `check`: of the mesh.
inline std::string differences(const Mixed_mesh& mesh, const Tubular_model& model, const Surface& surface,
                               const Mesh_check& check) {
  Validity_report report = check.validity();
  const bool has_materials =
      !report.region_components.empty() && report.region_components.rbegin()->first >= labels::first_material;
  if (has_materials) // which may be in several places, and part the wall
    report.region_components.erase(report.region_components.lower_bound(labels::wall_region),
                                   report.region_components.end());
  std::string s = report.defects();
  const auto add = [&](const std::string& what) { s += (s.empty() ? "" : ", ") + what; };
  const std::ptrdiff_t euler = std::ptrdiff_t(num_vertices(model.surface)) - std::ptrdiff_t(num_edges(model.surface)) +
                               std::ptrdiff_t(num_faces(model.surface));
  if (report.boundary_euler != euler)
    add("a boundary of Euler characteristic " + std::to_string(report.boundary_euler) + " instead of " +
        std::to_string(euler));
  std::set<int> patches(mesh.triangles.label.begin(), mesh.triangles.label.end());
  patches.insert(mesh.quads.label.begin(), mesh.quads.label.end());
  for (const auto& opening : model.openings)
    if (patches.count(opening.patch) == 0)
      add("no facets on " + patch_names(model).at(opening.patch));
  const double wanted = Polygon_mesh_processing::volume(surface);
  const double found = lumen_measures(mesh, model.openings.size()).volume;
  if (std::abs(found - wanted) > largest_loss_of_volume * wanted)
    add(std::to_string(std::lround(100 * found / wanted)) + " % of the volume of the surface");
  return s;
}

// Mesh_3 takes about a kilobyte for each tetrahedron, as surface meshing does for each triangle; the machine's memory is
// the limit, not what happens to be free.
inline void check_memory(double elements, const std::string& name = "tetrahedra") {
  const double needed = 1000 * elements;
  const double there = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGE_SIZE));
  if (needed > there)
    throw Meshing_error("A mesh this fine would have about " + std::to_string((long long)(elements / 1e6)) +
                        " million " + name + ", more than the memory of this machine holds: make it coarser.");
}

// Of equilateral triangles, as large as the size at the centre of each face.
template <class Size> double estimated_number_of_triangles(const Surface& surface, const Size& size) {
  double number = 0;
  for (auto f : surface.faces()) {
    const auto h = surface.halfedge(f);
    const Point_3 &p = surface.point(surface.source(h)), &q = surface.point(surface.target(h)),
                  &r = surface.point(surface.target(surface.next(h)));
    const double length = size(CGAL::centroid(p, q, r));
    number += std::sqrt(CGAL::cross_product(q - p, r - p).squared_length()) / 2 / (std::sqrt(3.) / 4 * length * length);
  }
  return number;
}

inline void check_differences(const Mixed_mesh& mesh, const Tubular_model& model, const Surface& surface,
                              const Mesh_check& check) {
  const std::string s = differences(mesh, model, surface, check);
  if (!s.empty())
    throw Meshing_error("The mesh came out with " + s +
                        ": the mesh size may be too coarse for the surface; try a finer one.");
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_PIPELINES_INTERNAL_CHECK_MESH_OF_MODEL_H
