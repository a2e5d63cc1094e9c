// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_DECLARE_OPTIONS_H
#define TUBULAR_MESH_DECLARE_OPTIONS_H

#include "../command_line/run_tool.h"
#include "../command_line/validators.h"
#include "Options.h"
#include "view/Coloring.h"

#include <CLI/CLI.hpp>

#include <limits>
#include <string>
#include <vector>

using command_line::in_range;

inline void declare_mesher_options(CLI::App& app, Options& o) {
  app.add_option("--surface-mesher", o.surface_mesher,
                 "parametric: patch by patch, on the surface itself, Mesh_3 where that fails; or mesh_3, with the "
                 "volume (default: parametric, unless --volume-mesher is mesh_3)")
      ->check(CLI::IsMember({"mesh_3", "parametric"}).description(""));
  app.add_option("--volume-mesher", o.volume_mesher,
                 "tetgen, or ccdt of CGAL 6.1, which keep the triangles of the parametric surface mesher; or mesh_3 "
                 "(default: the first of these that is there)")
      ->check(CLI::IsMember({"mesh_3", "tetgen", "ccdt"}).description(""));
}

inline void declare_order_options(CLI::App& app, Options& o) {
  app.add_option(
         "--order", o.order,
         "of the elements: 1, or 2, with nodes between the corners, those of the wall on the smooth surface behind "
         "the triangles; of .vtu .msh .inp .exo .feb .xdmf and mesh-complete")
      ->capture_default_str();
  app.add_flag("--order-2-complete", o.complete_elements,
               "with --order 2: nodes in the middle of quads and hexahedra, which then have 27 (default: no, 20)");
}

inline void declare_hexahedral_options(CLI::App& app, Options& o) {
  const char* const group = "Meshes of type hexahedral";
  app.add_option("--hex-method", o.hex_method,
                 "blocks along the vessels, with -n rounded to a multiple of 8; or subdivision of tetrahedra and "
                 "prisms, for any shape")
      ->capture_default_str()
      ->check(CLI::IsMember({"blocks", "subdivision"}).description(""))
      ->group(group);
  app.add_option(
         "--hex-fallback", o.hex_fallback,
         "where there are no blocks to be had: subdivision, of the whole mesh; mixed, pyramids and tetrahedra in "
         "the junction alone, or, if it is not a junction that lacks them, subdivision; or none, no mesh")
      ->capture_default_str()
      ->check(CLI::IsMember({"subdivision", "mixed", "none"}).description(""))
      ->group(group);
  app.add_option(
         "--write-blocks", o.blocks_output,
         "write the block structure, one hexahedron a block, of its branch's region: .vtu .msh .mesh .inp; there "
         "is no fallback then")
      ->group(group);
}

inline void declare_wall_options(CLI::App& app, const std::string& name, const std::string& what, const std::string& of,
                                 Options::Layers& layers) {
  const char* const group = "Layers outside the lumen";
  const bool is_first = name == "wall";
  auto* wall = app.add_option("--" + name, layers.thickness, "thickness of " + what + ", in local radii")
                   ->check(in_range((std::numeric_limits<double>::min)(), 10))
                   ->group(group);
  app.add_option("--" + name + "-thickness", layers.length, "thickness of " + of + ", in the unit of the surface")
      ->check(in_range((std::numeric_limits<double>::min)(), (std::numeric_limits<double>::max)()))
      ->excludes(wall)
      ->group(group);
  app.add_option("--" + name + "-layers", layers.number,
                 std::string("number of its layers of cells (default: ") + (is_first ? "4)" : "as of the wall)"))
      ->check(CLI::Range(1, 1000))
      ->group(group);
  app.add_option("--" + name + "-growth", layers.growth,
                 std::string("ratio of the thicknesses of successive layers, outward (default: ") +
                     (is_first ? "1)" : "as of the wall)"))
      ->check(in_range(0.1, 10))
      ->group(group);
}

inline void declare_layer_options(CLI::App& app, Options& o) {
  const char* const group = "Layers outside the lumen";
  declare_wall_options(app, "wall", "the vessel's wall, of prisms or hexahedra", "the wall", o.wall);
  auto* array =
      app.add_option("--wall-thickness-array", o.wall_array,
                     "point or cell array of the surface: the thickness of the wall there, in the unit of the surface")
          ->group(group);
  auto* table = app.add_option("--wall-thickness-table", o.wall_table,
                               "file of lines BRANCH,THICKNESS, as -v and --report number branches, from 0; * for all "
                               "others")
                    ->excludes(array)
                    ->group(group);
  for (CLI::Option* option : {array, table})
    for (const char* other : {"--wall", "--wall-thickness"})
      option->excludes(app.get_option(other));
  app.add_option("--wall-elements", o.wall_elements, "auto: prisms on triangles, hexahedra on quads; or tetrahedra")
      ->capture_default_str()
      ->check(CLI::IsMember({"auto", "tetrahedra"}).description(""))
      ->group(group);
  declare_wall_options(app, "second-wall", "a second wall around it", "the second wall", o.second_wall);
  app.add_option("--material-array", o.material_array,
                 "cell or point array of the surface, of integers: areas of the wall that are regions of their own, as "
                 "plaque or a stent; 0 is the wall itself")
      ->group(group);
  app.add_flag("--fibres", o.fibres,
               "write the circumferential and the longitudinal direction of each cell of the wall: .vtu .pvtu .msh "
               ".xdmf .feb .inp .exo and mesh-complete")
      ->group(group);
  app.add_option("--boundary-layer-prisms", o.boundary_layer_prisms,
                 "layers of prisms, or hexahedra, along the wall inside the lumen; of --first-height, by --growth")
      ->check(CLI::Range(1, 1000))
      ->group("Layers inside the lumen");
}

inline void declare_metric_options(CLI::App& app, Options& o) {
  const char* const group = "Layers inside the lumen";
  app.add_option("--boundary-layer", o.boundary_layer, "thickness of the layers at the wall, in local radii")
      ->capture_default_str()
      ->check(in_range((std::numeric_limits<double>::min)(), 1))
      ->group(group);
  app.add_option("--first-height", o.first_height,
                 "height of the first layer, in local radii (default: a twentieth of their thickness)")
      ->check(in_range((std::numeric_limits<double>::min)(), 1))
      ->group(group);
  app.add_option("--growth", o.growth, "ratio of the heights of successive layers")
      ->capture_default_str()
      ->check(in_range(1, 100))
      ->group(group);
  app.add_option("--smoothing-ratio", o.smoothing_ratio, "largest ratio of adjacent edges, as the wall curves")
      ->capture_default_str()
      ->check(in_range(1, 100))
      ->group(group);
  app.add_option("--curvature-points", o.curvature_points, "points on a full circle of the wall's curvature")
      ->capture_default_str()
      ->check(in_range(3, 1e4))
      ->group(group);
}

inline CLI::Validator is_number_of_parts() {
  return CLI::Validator(
      [](std::string& text) {
        const bool is_number = !text.empty() && text.size() < 7 &&
                               text.find_first_not_of("0123456789") == std::string::npos && std::stoi(text) > 0;
        return text == "all" || text == "largest" || is_number ? std::string()
                                                               : "\"" + text + "\" is not all, largest, or a number";
      },
      "");
}

inline void declare_surface_options(CLI::App& app, Options& o) {
  app.add_option("--repair", o.repair,
                 "off, auto: repair what is wrong, or wrap: replace the surface by one wrapped around it")
      ->capture_default_str()
      ->check(CLI::IsMember({"off", "auto", "wrap"}).description(""));
  app.add_option("--parts", o.parts,
                 "vessels to mesh, where the surface has several: all, the largest, or a number of them, by area")
      ->capture_default_str()
      ->check(is_number_of_parts());
  app.add_option("--fill", o.filled_holes,
                 "X,Y,Z (repeatable): the loop of the border nearest to this point is a hole, not an opening: it is "
                 "filled")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_point());
  app.add_flag("--smooth", o.smooth, "smooth staircase noise off the surface, keeping its volume");
  app.add_option("--flow-extensions", o.flow_extensions,
                 "extend each opening by a straight tube of this length, in radii of the opening")
      ->check(in_range((std::numeric_limits<double>::min)(), 1e3));
}

inline void declare_centerline_options(CLI::App& app, Options& o) {
  auto* lines = app.add_option("-c,--centerlines", o.centerlines,
                               "centerlines, if they are not to be computed: .vtk .vtp (VMTK) or .msh (Gmsh)");
  app.add_option(
         "--inlet", o.inlet,
         "X,Y,Z or NAME: the opening nearest to this point, or of this name or number in the surface's file, is "
         "the inlet (default: one whose name begins with inlet, else the one at the centerlines' common start, "
         "else the largest)")
      ->check(command_line::is_point_or_name());
  auto* outlets = app.add_option("--outlet", o.outlets,
                                 "X,Y,Z (repeatable): where vessels end; a round end is cut open there; with --inlet")
                      ->expected(1)
                      ->take_all()
                      ->check(command_line::is_point())
                      ->excludes(lines);
  app.add_option("--seeds", o.seeds, "file with such points, one a line, the inlet first")
      ->excludes("--inlet")
      ->excludes(outlets)
      ->excludes(lines);
  app.add_flag("--cut-ends", o.cut_ends,
               "cut vessels open that end in domes (by itself where a closed surface has no other end)");
  app.add_option("--keep-end", o.blind_ends,
                 "X,Y,Z (repeatable): the round or capped end nearest to this point stays closed")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_point());
  app.add_option("--openings", o.openings, "number of openings that there have to be; with others nothing is meshed")
      ->check(CLI::Range(1, 1000000));
  app.add_flag("--allow-single-opening", o.single_opening,
               "mesh vessels that have one opening, and end blind otherwise");
  auto* loops = app.add_flag("--loops", o.loops,
                             "keep every branch where vessels split and rejoin, as is done by default where they do")
                    ->excludes(lines);
  app.add_flag("--no-loops", o.no_loops, "follow shortest paths alone where vessels split and rejoin")
      ->excludes(lines)
      ->excludes(loops);
  for (const char* ends : {"--centerlines", "--outlet", "--seeds"})
    app.get_option("--flow-extensions")->excludes(app.get_option(ends));
}

inline void declare_size_options(CLI::App& app, Options& o) {
  app.add_option("--elements", o.elements,
                 "about how many cells (of a surface, faces) the mesh is to have, within a tenth: N is found for it")
      ->check(in_range(10, 1e10))
      ->excludes("--points-per-circumference");
  app.add_option("--refine", o.refined_balls,
                 "X,Y,Z,RADIUS,FACTOR (repeatable): in this ball mesh sizes are divided by the factor")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_refinement<5>("X,Y,Z,RADIUS,FACTOR"));
  app.add_option("--refine-branch", o.refined_branches,
                 "K,FACTOR (repeatable): the same in branch K, as -v and --report number them, from 0")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_refinement<2>("K,FACTOR"));
  app.add_option("--size-array", o.size_array,
                 "point array of the surface: the mesh size there, in place of h; where it is not above 0, h");
}

inline void declare_name_options(CLI::App& app, Options& o) {
  app.add_option("--faces", o.faces,
                 "cell array of the surface whose integers say which face is the wall and which are ends (default: "
                 "ModelFaceID, CapID, CellEntityIds or patch; solids of .stl, groups of .obj and .msh)");
  app.add_option("--rename", o.renames, "NAME=NEW (repeatable): name a patch otherwise")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_renaming());
}

constexpr const char* reduced_model_group = "Cross-sections and zero-dimensional models";
constexpr const char* case_group = "A case for a solver";
constexpr const char* physics_group = "Of cases and zero-dimensional models";

inline void declare_reduced_model_options(CLI::App& app, Options& o) {
  const char* const group = reduced_model_group;
  const double least = (std::numeric_limits<double>::min)(), most = (std::numeric_limits<double>::max)();
  app.add_option("--write-sections", o.sections_output,
                 "write the cross-sections of all branches: area, perimeter, hydraulic diameter, inscribed radius, "
                 "eccentricity, curvature and torsion: .csv .vtp")
      ->group(group);
  app.add_option("--section-spacing", o.section_spacing,
                 "of the cross-sections, in local radii; with --write-sections or --write-0d")
      ->capture_default_str()
      ->check(in_range(0.01, 1e3))
      ->group(group);
  auto* model = app.add_option("--write-0d", o.zero_d_output,
                               "write a zero-dimensional model of the vessels for SimVascular's svZeroDSolver: .json")
                    ->group(group);
  app.add_flag(
         "--murray", o.murray,
         "resistances at the outlets by Murray's law, flow by the cube of the radius (default: no, a pressure of 0)")
      ->needs(model)
      ->group(group);
  app.add_option("--mean-pressure", o.mean_pressure, "at these outlets, in Pa")
      ->capture_default_str()
      ->check(in_range(least, most))
      ->needs("--murray")
      ->group(group);
}

/* Of --case and --write-0d; without one of them they have no meaning. */
inline void declare_physical_options(CLI::App& app, Options& o) {
  Physical_options& p = o.physics;
  const double least = (std::numeric_limits<double>::min)(), most = (std::numeric_limits<double>::max)();
  const std::vector<CLI::Option*> all = {
      app.add_option("--length-unit", p.length_unit, "of the surface: m, cm, mm or um")
          ->capture_default_str()
          ->check(CLI::IsMember({"m", "cm", "mm", "um"}).description("")),
      app.add_option(
          "--flow-rate", p.flow_rate,
          "at the inlet of each vessel, in ml/s (default of --write-0d: that of a wall shear stress of 1.5 Pa "
          "at the inlet)"),
      app.add_option("--density", p.density, "of the fluid, in kg/m3")->capture_default_str(),
      app.add_option("--viscosity", p.viscosity, "dynamic, of the fluid, in Pa s")->capture_default_str(),
      app.add_option("--youngs-modulus", p.youngs_modulus,
                     "of the vessel's wall, in Pa; for --write-0d its thickness is that of --wall, else 0.2 radii")
          ->capture_default_str()};
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i]->group(physics_group);
    if (i > 0)
      all[i]->check(in_range(least, most));
  }
  app.parse_complete_callback([all, &app] {
    if (app.count("--section-spacing") > 0 && app.count("--write-sections") == 0 && app.count("--write-0d") == 0)
      throw CLI::RequiresError("--section-spacing", "--write-sections or --write-0d");
    if (app.count("--case") > 0 || app.count("--write-0d") > 0)
      return;
    for (const CLI::Option* option : all)
      if (option->count() > 0)
        throw CLI::RequiresError(option->get_name(), "--case or --write-0d");
  });
}

inline void declare_report_options(CLI::App& app, Options& o) {
  const char* const group = "Reports and pictures";
  auto* report = app.add_option("--report", o.reports,
                                "write the summary to this file (repeatable): .html, a page with the mesh in 3D; .json")
                     ->expected(1)
                     ->take_all()
                     ->group(group);
  app.add_option("--report-budget", o.report_budget,
                 "MB that a page may take: cells that do not fit are left out, and it says which; facets never are")
      ->capture_default_str()
      ->check(in_range(0, 1000))
      ->needs(report)
      ->group(group);
  auto* picture = app.add_option("--picture", o.picture, "draw the mesh into this .png file")->group(group);
  app.add_option("--clip", o.clip,
                 "x, y, z, -x, -y, -z or X,Y,Z,NX,NY,NZ: cut the picture's mesh, across the axis in its middle, or by "
                 "the plane "
                 "through a point; cells whose centre is on the side of the normal are taken away")
      ->check(command_line::is_plane())
      ->needs(picture)
      ->group(group);
  app.add_option(
         "--picture-view", o.picture_view,
         "x, y, z, -x, -y, -z or X,Y,Z: from where the picture is taken (default: with --clip, from the side of its "
         "normal; else, from where most is seen)")
      ->check(command_line::is_direction())
      ->needs(picture)
      ->group(group);
  app.add_option("--picture-color", o.picture_color,
                 "patch, region, type, quality, size or branch: what its colours stand for")
      ->capture_default_str()
      ->check(CLI::IsMember(Coloring::names()).description(""))
      ->needs(picture)
      ->group(group);
  app.add_option("--picture-size", o.picture_size, "its width and height in pixels, 16 to 4096")
      ->capture_default_str()
      ->check(command_line::is_picture_size())
      ->needs(picture)
      ->group(group);
}

inline void declare_case_options(CLI::App& app, Options& o) {
  const char* const group = case_group;
  Case_options& c = o.solver_case;
  const double most = (std::numeric_limits<double>::max)(), least = (std::numeric_limits<double>::min)();
  auto* solver =
      app.add_option("--case", c.solver,
                     "the output is a folder with all that a solver needs to run at once, in metres and pascals: "
                     "openfoam, svmultiphysics, fenicsx or freefem, steady laminar flow from a parabolic inlet; or "
                     "calculix, the vessel's wall under pressure")
          ->check(CLI::IsMember({"openfoam", "svmultiphysics", "fenicsx", "freefem", "calculix"}).description(""))
          ->excludes("--format")
          ->excludes("--partitions")
          ->group(group);
  app.add_option("--outlet-pressure", c.outlet_pressures,
                 "P, or NAME=P (repeatable), in Pa: the mean pressure at all outlets, or at the one of this name "
                 "(default: 0)")
      ->expected(1)
      ->take_all()
      ->check(command_line::is_number_or_named_number())
      ->needs(solver)
      ->group(group);
  app.add_option("--wall-pressure", c.wall_pressure, "on the inside of the vessel's wall, in Pa")
      ->check(in_range(least, most))
      ->needs(solver)
      ->group(group);
  app.add_option("--poissons-ratio", c.poissons_ratio, "of the vessel's wall")
      ->capture_default_str()
      ->check(in_range(0, 0.499))
      ->needs(solver)
      ->group(group);
}

// Of surfaces in a batch as well, whose names are not given.
inline std::vector<std::string> formats() {
  std::vector<std::string> names = CGAL::Tubular_meshing::IO::mesh_format_names();
  names.insert(names.end(), {"stl", "vtp", "ply", "off", "obj", "vtk"});
  return names;
}

constexpr const char* batch_group = "Many surfaces";

inline void declare_batch_options(CLI::App& app, Options& o) {
  Batch_options& b = o.batch;
  const double least = (std::numeric_limits<double>::min)(), most = (std::numeric_limits<double>::max)();
  auto* batch =
      app.add_option(
             "--batch", b.surfaces,
             "folder of surfaces, or table of them, .csv or .tsv: each is meshed into the folder --output, with "
             "its report, page and picture, and index.html shows all; those that are there, made of the same "
             "by the same options, are kept. Columns: surface, its file; name; options, any of these; or the "
             "name of an option; #..., shown on the page alone")
          ->group(batch_group);
  const std::vector<CLI::Option*> all = {
      app.add_option("--jobs", b.jobs, "surfaces that are meshed at a time (default: as many as there are cores)")
          ->check(CLI::Range(1, 4096)),
      app.add_option("--pattern", b.pattern,
                     "of a folder: which of its surfaces, in the shell's way, by their path in it")
          ->capture_default_str(),
      app.add_option("--job-timeout", b.timeout, "seconds after which a surface counts as failed (default: no limit)")
          ->check(in_range(least, most)),
      app.add_option("--job-memory", b.memory, "MB of memory that a surface may take (default: no limit)")
          ->check(in_range(least, most)),
      app.add_flag("--retry-failed", b.retries, "mesh those again that have failed, though nothing has changed"),
      app.add_flag("--pages,!--no-pages", b.has_pages,
                   "a page for each mesh, of --report-budget MB, 5 by default, "
                   "beside index.html (default: yes)"),
      app.add_option("--batch-step", b.step,
                     "for workflow programs, as workflow/Snakefile: plan, print the rows as JSON; the status file of a "
                     "row, make that row; or index, write index.html of what is there")};
  for (CLI::Option* option : all)
    option->needs(batch)->group(batch_group);
}

// Reports, pictures and outputs are named by the batch: what is said of them holds all the same.
inline void allow_in_batch(CLI::App& app) {
  app.get_option("--report-budget")->remove_needs(app.get_option("--report"));
  for (const char* option : {"--clip", "--picture-view", "--picture-color", "--picture-size"})
    app.get_option(option)->remove_needs(app.get_option("--picture"));
}

inline void declare_options(CLI::App& app, Options& o, const std::string& version) {
  app.description("Makes a mesh of a vessel or airway tree from its triangulated surface, along its "
                  "centerlines.\nLengths are in the unit of the surface.");
  app.footer(std::string(command_line::exit_statuses()) +
             " With --batch 5: some of "
             "the surfaces have failed.\nNothing is written unless all of it is whole.");
  app.set_version_flag("--version", version);
  app.add_option("surface", o.surface,
                 "surface: .stl .off .obj .ply .vtp .vtu .vtk .msh .mesh; required, but for --batch");
  app.add_option("-o,--output", o.output,
                 "mesh to write: .vtu .pvtu .msh .mesh .inp .su2 .feb .cas .xdmf .cgns .exo, or a folder polyMesh or "
                 "mesh-complete; a surface: .stl .vtp .msh .ply .off .obj .vtk; required, but for --dry-run");
  app.add_option(
         "--format", o.format,
         "format of the mesh, where its name does not tell it: vtu, pvtu, gmsh, medit, abaqus, openfoam (of a case: "
         "its constant/polyMesh), openfoam-binary, openfoam-regions (of a case: a polyMesh a region), "
         "openfoam-regions-binary, svmultiphysics, su2, febio, fluent, xdmf (FEniCSx), cgns or exodus")
      ->check(CLI::IsMember(formats()).description(""));
  app.add_option("-t,--type", o.type,
                 "kind of mesh: isotropic or anisotropic (tetrahedra), mixed (hexahedra, pyramids, tetrahedra), "
                 "hexahedral (hexahedra alone) or surface (no cells)")
      ->capture_default_str();
  app.add_option(
         "--surface-elements", o.surface_elements,
         "of a surface: triangles; anisotropic triangles, as of --type anisotropic; quads; or structured-quads, "
         "the wall of blocks as of --type hexahedral")
      ->capture_default_str()
      ->check(CLI::IsMember({"triangles", "anisotropic", "quads", "structured-quads"}).description(""));
  app.add_option("-n,--points-per-circumference", o.points_per_circumference,
                 "mesh size h = 2 pi r / N, r the local radius")
      ->capture_default_str()
      ->check(in_range(3, 1e4));
  app.add_option("--min-size", o.min_size, "smallest mesh size")
      ->check(in_range(0, (std::numeric_limits<double>::max)()));
  app.add_option("--max-size", o.max_size, "largest mesh size")
      ->check(in_range((std::numeric_limits<double>::min)(), (std::numeric_limits<double>::max)()));
  app.add_option("--gradation", o.gradation, "largest ratio of the sizes of neighbours")
      ->capture_default_str()
      ->check(in_range(1, 1e4));
  declare_size_options(app, o);
  app.add_flag("--preserve-volume,!--no-preserve-volume", o.preserve_volume,
               "move the wall outward by so much that mesh and openings have the surface's volume and areas, not those "
               "of facets inside of it (default: yes)");
  declare_order_options(app, o);
  declare_mesher_options(app, o);
  declare_hexahedral_options(app, o);
  declare_layer_options(app, o);
  declare_metric_options(app, o);
  declare_surface_options(app, o);
  declare_centerline_options(app, o);
  declare_name_options(app, o);
  declare_report_options(app, o);
  app.add_option("--write-surface", o.surface_output,
                 "write the closed, labelled surface, as it is meshed by the parametric mesher, else as it came: .stl "
                 ".vtp .msh .ply .off .obj .vtk");
  app.add_option("--write-centerlines", o.centerlines_output, "write the branches and their radii: .vtp .vtk");
  declare_reduced_model_options(app, o);
  app.add_option("--partitions", o.partitions,
                 "write the mesh in so many parts of about equal numbers of cells, with ghost cells, for as many "
                 "processors: .pvtu, .msh, or OpenFOAM's processor folders")
      ->check(CLI::Range(1, 1000000));
  declare_case_options(app, o);
  declare_physical_options(app, o);
  declare_batch_options(app, o);
  app.add_option("--threads", o.threads, "number of threads, on which results do not depend (default: all cores)")
      ->check(CLI::Range(0, 1024));
  app.add_flag("--dry-run", o.dry_run,
               "make no mesh: say what the openings, branches and mesh sizes are, and about how many cells there will "
               "be, of which kind, and how much memory and time they take");
  app.add_option("--log-json", o.log_json,
                 "file, or - for standard error: what the program does, as it does it, one JSON object a line");
  auto* verbose = app.add_flag("-v,--verbose", o.verbose, "say more: the branches, a histogram of the quality");
  app.add_flag("-q,--quiet", o.quiet, "print errors only")->excludes(verbose);
}

#endif // TUBULAR_MESH_DECLARE_OPTIONS_H
