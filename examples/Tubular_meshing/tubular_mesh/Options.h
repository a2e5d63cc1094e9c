// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_OPTIONS_H
#define TUBULAR_MESH_OPTIONS_H

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

// Of the fluid and the vessel, for what computes with a flow.
struct Physical_options {
  std::string length_unit = "mm";                                 // of the surface
  double flow_rate = 0;                                           // at the inlet, ml/s; 0: not said
  double density = 1060, viscosity = 0.004, youngs_modulus = 4e5; // kg/m3, Pa s, Pa

  double meters() const {
    return length_unit == "m" ? 1 : length_unit == "cm" ? 1e-2 : length_unit == "mm" ? 1e-3 : 1e-6;
  }
};

// What a solver is to compute, of the folder that --case writes.
struct Case_options {
  std::string solver; // openfoam, svmultiphysics, fenicsx, freefem or calculix; empty: none is wanted
  std::vector<std::string> outlet_pressures; // Pa: of all, or NAME=P
  double wall_pressure = 0;                  // Pa, that the wall is under
  double poissons_ratio = 0.45;              // of the wall

  bool is_wanted() const { return !solver.empty(); }
  bool is_of_wall() const { return solver == "calculix"; }
};

/* Many surfaces, each of which is meshed by the other options. */
struct Batch_options {
  std::string surfaces; // a folder or a table; empty: there is one surface
  std::string pattern = "*";
  int jobs = 0;                     // at a time; 0: not said
  double timeout = 0, memory = 0;   // seconds and MB of one; 0: no limit
  bool retries = false;             // those that have failed
  bool has_pages = true;            // one a mesh
  std::string step;                 // of those that a program for clusters takes one by one; empty: all
  std::vector<std::string> options; // of every surface, as words

  bool is_wanted() const { return !surfaces.empty(); }
};

/* What the user of tubular_mesh asks for. */
struct Options {
  // of cells outside the lumen, none where the thickness is 0
  struct Layers {
    double thickness; // in local radii
    int number;
    double growth;
    double length = 0; // the thickness in the unit of the surface, in place of the other
  };

  std::string surface, centerlines, output, type = "isotropic";
  std::string format;                        // of the mesh; empty: the output's name tells it
  std::string surface_mesher, volume_mesher; // empty: not said
  double boundary_layer = 0.3, first_height = 0, growth = 1.3, smoothing_ratio = 1.5, curvature_points = 20;
  std::string surface_elements = "triangles";
  Layers wall = {0, 0, 0}, second_wall = {0, 0, 0}; // 0: not said
  std::string wall_array, wall_table;               // the thickness by an array of the surface, or by branch
  std::string material_array;
  bool fibres = false;
  std::string wall_elements = "auto";
  int boundary_layer_prisms = 0;
  std::string hex_method = "blocks", hex_fallback = "subdivision";
  std::string repair = "auto";
  bool smooth = false, loops = false, no_loops = false;
  double flow_extensions = 0;
  std::string inlet, seeds; // the inlet: a point, or the name of an end
  std::string faces;        // the cell array that says which face is which end; empty: one with a known name
  std::vector<std::string> renames;
  std::vector<std::string> outlets;
  std::vector<std::string> filled_holes, blind_ends; // points
  bool cut_ends = false, single_opening = false;
  int openings = 0;          // that there have to be; 0: not said
  std::string parts = "all"; // or largest, or a number
  double points_per_circumference = 20;
  double elements = 0; // that the mesh is to have; 0: as many as come
  std::vector<std::string> refined_balls, refined_branches;
  std::string size_array;
  double min_size = 0, max_size = (std::numeric_limits<double>::infinity)(), gradation = 1.3;
  std::string surface_output, centerlines_output, blocks_output, sections_output, zero_d_output;
  double section_spacing = 0.5; // in local radii
  bool murray = false;
  double mean_pressure = 13332; // Pa, at its outlets
  Physical_options physics;
  std::vector<std::string> reports; // .html: a page; else JSON
  double report_budget = 20;        // MB, of a page
  std::string picture, picture_size = "1600x1200", picture_color = "patch";
  std::string picture_view, clip; // a direction, a plane; empty: not said
  bool preserve_volume = true;
  int partitions = 0; // that the mesh is written in; 0: as a whole
  int order = 1;      // of the elements
  bool complete_elements = false;
  int threads = 0;
  bool verbose = false, quiet = false, dry_run = false;
  std::string command;  // as it was typed, if it was
  std::string log_json; // a file, or - for standard error; empty: none
  Case_options solver_case;
  Batch_options batch;

  bool makes_surface_only() const { return type == "surface"; }
  bool is_anisotropic() const { return type == "anisotropic"; }
  bool is_anisotropic_surface() const { return makes_surface_only() && surface_elements == "anisotropic"; }
  bool is_mixed() const { return type == "mixed"; }
  bool is_hexahedral() const { return type == "hexahedral"; }
  CGAL::Tubular_meshing::IO::Mesh_format mesh_format() const {
    namespace IO = CGAL::Tubular_meshing::IO;
    if (solver_case.is_wanted())
      return mesh_format_of_case();
    return format.empty() ? IO::mesh_format_of(output) : IO::mesh_format_named(format);
  }
  // of the layers inside the lumen, in local radii
  double first_layer() const { return first_height > 0 ? first_height : boundary_layer / 20; }
  bool is_quadratic() const { return order == 2; }
  // Cells of prisms, in the lumen or around it.
  bool makes_prisms() const {
    return !is_mixed() && !is_hexahedral() && (boundary_layer_prisms > 0 || (has_wall() && wall_elements == "auto"));
  }
  bool has_wall() const { return wall.thickness > 0 || wall.length > 0 || !wall_array.empty() || !wall_table.empty(); }
  bool has_second_wall() const { return second_wall.thickness > 0 || second_wall.length > 0; }
  int wall_layers() const { return wall.number > 0 ? wall.number : 4; }
  double wall_growth() const { return wall.growth > 0 ? wall.growth : 1; }
  // Patch by patch; else surface and volume at once, by Mesh_3.
  bool meshes_patches() const;

  // Whether a report is a page; else it is JSON.
  static bool is_page(const std::string& report) {
    const std::string ending = std::filesystem::path(report).extension().string();
    return ending == ".html" || ending == ".htm";
  }

  // That are there when all is done; nothing but reports of a dry run.
  std::vector<std::string> written_files() const {
    std::vector<std::string> files;
    if (!dry_run)
      files = {output, surface_output, centerlines_output, blocks_output, sections_output, zero_d_output, picture};
    files.insert(files.end(), reports.begin(), reports.end());
    files.erase(std::remove(files.begin(), files.end(), std::string()), files.end());
    return files;
  }
  // All that is written, on the way as well.
  std::vector<std::string> outputs() const {
    std::vector<std::string> files = {output,        surface_output, centerlines_output, blocks_output, sections_output,
                                      zero_d_output, picture};
    files.insert(files.end(), reports.begin(), reports.end());
    if (log_json != "-")
      files.push_back(log_json);
    files.erase(std::remove(files.begin() + 1, files.end(), std::string()), files.end());
    return files;
  }

private:
  CGAL::Tubular_meshing::IO::Mesh_format mesh_format_of_case() const;
};

// Throws a Parameter_error for what is wrong with the options as such; before any work is done, since work takes time.
// Without an output there is nothing wrong with its name: a program keeps the mesh.
void check(const Options& o, bool has_output = true);

#endif // TUBULAR_MESH_OPTIONS_H
