// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_RUN_H
#define TUBULAR_MESH_RUN_H

#include "Options.h"

#include <CGAL/Tubular_meshing/Centerlines/Centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/Centerlines/zero_d_model.h>
#include <CGAL/Tubular_meshing/Fields/Size_requests.h>
#include <CGAL/Tubular_meshing/Layers/Layer_report.h>
#include <CGAL/Tubular_meshing/Layers/Wall_array.h>
#include <CGAL/Tubular_meshing/Layers/Wall_materials.h>
#include <CGAL/Tubular_meshing/Layers/Wall_thickness.h>
#include <CGAL/Tubular_meshing/Layers/wall_fibres.h>
#include <CGAL/Tubular_meshing/Openings/Round_end_report.h>
#include <CGAL/Tubular_meshing/Openings/labelled_ends.h>
#include <CGAL/Tubular_meshing/Partition/Cell_partition.h>
#include <CGAL/Tubular_meshing/Patches/Remeshed_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>
#include <CGAL/Tubular_meshing/Quadratic/Quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Quadratic/make_quadratic_mesh.h>
#include <CGAL/Tubular_meshing/Repair/Repair_report.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/Opening.h>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

/* Straight tubes at the openings. The list is of the openings where they are now, the inlet first, and of the tubes'
 * lengths; empty where none were asked for. */
struct Flow_extensions {
  std::vector<CGAL::Tubular_meshing::Opening> openings;
  std::vector<double> lengths;
};

/* Points that the user names, of one vessel. */
struct Named_points {
  std::optional<CGAL::Tubular_meshing::Point_3> inlet;
  std::vector<CGAL::Tubular_meshing::Point_3> ends; ///< that have to be open, the inlet first; empty if not said
  std::vector<CGAL::Tubular_meshing::Point_3> blind_ends;
};

/* What is asked of the vessel's wall beside numbers, and what it comes to once the vessels are known. */
struct Wall_requests {
  std::optional<CGAL::Tubular_meshing::Wall_array> thickness_array, material_array;
  std::map<std::size_t, double> of_branches; ///< the thickness
  double of_other_branches = 0;              ///< 0: not said
  CGAL::Tubular_meshing::Label_names material_names;

  CGAL::Tubular_meshing::Wall_thickness thickness, second_thickness;
  CGAL::Tubular_meshing::Wall_materials materials;
};

/* What was asked for, and what came of it: of a vessel, or of all. */
struct Run {
  Options options;
  std::string version;
  Named_points points;
  CGAL::Tubular_meshing::Centerline_polylines lines; ///< if they were given
  std::vector<std::string> notes;                    ///< a sentence each
  std::vector<CGAL::Tubular_meshing::Round_end_report> round_ends;
  std::vector<std::size_t> openings_of_parts; ///< how many each vessel has
  CGAL::Tubular_meshing::Repair_report repairs;
  CGAL::Tubular_meshing::Labelled_ends labels;
  CGAL::Tubular_meshing::Size_requests sizes;
  Wall_requests walls;
  Flow_extensions extensions;
  bool is_sampled = false; ///< of a dry run: counted by samples of the wall, without centerlines
  CGAL::Tubular_meshing::Tubular_model model;
  CGAL::Tubular_meshing::Remeshed_surface surface; ///< as it was meshed by patches; else empty
  CGAL::Tubular_meshing::Mixed_mesh mesh;          ///< empty once there are quadratic elements
  CGAL::Tubular_meshing::Quadratic_mesh quadratic; ///< if these were asked for
  CGAL::Tubular_meshing::Quadratic_report curving;
  CGAL::Tubular_meshing::Block_structure blocks;   ///< that the mesh is in, of one vessel
  CGAL::Tubular_meshing::Mixed_mesh block_mesh;    ///< of all; only if it was asked for
  CGAL::Tubular_meshing::Cell_partition partition; ///< of the mesh, if it is written in parts
  CGAL::Tubular_meshing::Mesher_report meshing;
  CGAL::Tubular_meshing::Layer_report wall;
  CGAL::Tubular_meshing::Wall_fibres fibres; ///< if they were asked for
  std::vector<CGAL::Tubular_meshing::Cross_section> sections;
  CGAL::Tubular_meshing::Zero_d_model zero_d;

  // The mesh by its corners, of whatever order.
  const CGAL::Tubular_meshing::Mixed_mesh& cells() const { return options.is_quadratic() ? quadratic.linear : mesh; }
};

#endif // TUBULAR_MESH_RUN_H
