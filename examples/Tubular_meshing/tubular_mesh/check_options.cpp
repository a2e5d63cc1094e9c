// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Options.h"
#include "solver_case.h"

#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_partitioned_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_sections.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Partition/partition_cells.h>
#include <CGAL/Tubular_meshing/Volume/Volume_mesher.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <system_error>
#include <utility>

namespace tubular = CGAL::Tubular_meshing;
using tubular::IO::Mesh_format;

namespace {

bool fills_by_mesh_3(const Options& o) {
  return o.volume_mesher == "mesh_3" ||
         (o.volume_mesher.empty() && tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3);
}

// Why a volume mesher is not there; empty if it is.
std::string why_not_filled_by(const std::string& volume_mesher) {
  if (volume_mesher == "tetgen" && !tubular::has_tetgen())
    return "This program was built without TetGen; use --volume-mesher mesh_3, or build it where TetGen's library is "
           "installed (libtet1.5-dev).";
  if (volume_mesher == "ccdt" && !tubular::has_ccdt())
    return "This program was built with a version of CGAL before 6.1, which has no constrained triangulations in "
           "space; use --volume-mesher tetgen or mesh_3.";
  return "";
}

void check_mesher(const Options& o) {
  if (o.makes_surface_only() && o.surface_mesher == "mesh_3")
    throw tubular::Parameter_error("Mesh_3 makes surface and volume at once: a surface alone is made by "
                                   "--surface-mesher parametric.");
  if (o.makes_surface_only() && !o.volume_mesher.empty())
    throw tubular::Parameter_error("--volume-mesher has nothing to do in a mesh of type surface.");
  const bool keeps_surface = o.volume_mesher == "tetgen" || o.volume_mesher == "ccdt";
  if (o.is_anisotropic() && o.surface_mesher == "mesh_3")
    throw tubular::Parameter_error("Anisotropic meshes begin with those of --surface-mesher parametric.");
  if (o.is_mixed() && (o.surface_mesher == "mesh_3" || o.volume_mesher == "mesh_3"))
    throw tubular::Parameter_error("Mesh_3 makes no quads, and would not keep them: mixed meshes are made by "
                                   "--surface-mesher parametric and --volume-mesher tetgen or ccdt.");
  if (keeps_surface && !o.meshes_patches())
    throw tubular::Parameter_error("--volume-mesher " + o.volume_mesher +
                                   " fills the surface mesh of --surface-mesher parametric, but --surface-mesher "
                                   "mesh_3 fills its own: leave one of the two out.");
  const std::string why_not = why_not_filled_by(o.volume_mesher);
  if (!why_not.empty())
    throw tubular::Parameter_error(why_not);
}

// Before hours of work, what a solver would not take: it has no cells of these kinds, or one kind at a time.
void check_cells(const Options& o) {
  const bool is_svmultiphysics = o.mesh_format() == Mesh_format::svmultiphysics;
  if (!is_svmultiphysics && o.mesh_format() != Mesh_format::xdmf)
    return;
  const std::string solver = is_svmultiphysics ? "svMultiPhysics" : "FEniCSx";
  if (o.is_mixed())
    throw tubular::Parameter_error("No pyramids, which meshes of type mixed have, can be written for " + solver +
                                   ": choose --type isotropic, anisotropic or hexahedral.");
  if (o.is_hexahedral() && o.hex_fallback == "mixed")
    throw tubular::Parameter_error("No pyramids, which --hex-fallback mixed makes, can be written for " + solver +
                                   ": choose subdivision or none.");
  if (o.boundary_layer_prisms > 0 && !o.is_hexahedral())
    throw tubular::Parameter_error(solver + " takes one kind of cells, not prisms and tetrahedra in one lumen: choose "
                                            "--type anisotropic in place of --boundary-layer-prisms, or --type "
                                            "hexahedral.");
  if (!is_svmultiphysics && o.has_wall() && !o.is_hexahedral() && o.wall_elements == "auto")
    throw tubular::Parameter_error(solver +
                                   " takes one kind of cells: add --wall-elements tetrahedra, or choose --type "
                                   "hexahedral.");
}

// The same for quadratic elements, whatever has been said of linear ones.
void check_quadratic_cells(const Options& o) {
  const Mesh_format format = o.mesh_format();
  const std::string why_not = tubular::IO::why_not_quadratic(format);
  if (!why_not.empty())
    throw tubular::Parameter_error(why_not);
  const bool has_pyramids = o.is_mixed() || (o.is_hexahedral() && o.hex_fallback == "mixed");
  if (format == Mesh_format::abaqus && has_pyramids)
    throw tubular::Parameter_error("CalculiX and Abaqus have no quadratic pyramids, which this mesh may have: choose "
                                   "another --type or --hex-fallback than mixed, or leave --order 2 away.");
  if (format == Mesh_format::svmultiphysics && o.makes_prisms())
    throw tubular::Parameter_error(
        "No quadratic prisms can be written for svMultiPhysics: add --wall-elements tetrahedra, choose --type "
        "hexahedral, or leave --order 2 away.");
  if (format == Mesh_format::xdmf && o.is_hexahedral() && !o.complete_elements)
    throw tubular::Parameter_error("FEniCSx has no hexahedra of 20 nodes, but of 27: add --order-2-complete.");
  if (!o.complete_elements)
    return;
  if (format == Mesh_format::vtu && has_pyramids)
    throw tubular::Parameter_error(
        "VTK has no pyramids of 14 nodes, which this mesh may have: leave --order-2-complete "
        "away, or write a .msh or .exo file.");
  if (format == Mesh_format::abaqus && (o.makes_prisms() || o.is_hexahedral()))
    throw tubular::Parameter_error(
        "CalculiX has no prisms of 18 and hexahedra of 27 nodes: leave --order-2-complete away.");
  if (format == Mesh_format::febio && (o.makes_prisms() || has_pyramids))
    throw tubular::Parameter_error(
        "FEBio has no prisms of 18 and pyramids of 14 nodes: leave --order-2-complete away, or "
        "choose --type hexahedral.");
}

void check_order(const Options& o) {
  if (o.order != 1 && o.order != 2)
    throw tubular::Parameter_error("Elements are of order 1 or 2, not " + std::to_string(o.order) + ".");
  if (o.complete_elements && !o.is_quadratic())
    throw tubular::Parameter_error("--order-2-complete is for elements of --order 2.");
  if (o.is_quadratic() && o.makes_surface_only())
    throw tubular::Parameter_error("--order 2 is for meshes of cells; choose another --type than surface.");
}

void check_mesh_format(const Options& o) {
  if (o.mesh_format() == Mesh_format::by_name)
    throw tubular::Parameter_error(
        "The mesh cannot be written to \"" + o.output +
        "\": give a .vtu, .pvtu, .msh, .mesh, .inp, .su2, .feb, .cas, .xdmf, .cgns or .exo file, a "
        "folder polyMesh or mesh-complete, or the --format.");
  const std::string why_not = tubular::IO::why_not_built_in(o.mesh_format());
  if (!why_not.empty())
    throw tubular::Parameter_error(why_not);
  const std::string why_no_fibres = o.fibres ? tubular::IO::why_no_cell_arrays(o.mesh_format()) : "";
  if (!why_no_fibres.empty())
    throw tubular::Parameter_error(why_no_fibres);
  check_cells(o);
  if (o.is_quadratic())
    check_quadratic_cells(o);
}

void check_partitions(const Options& o) {
  if (o.partitions == 0 || o.output.empty())
    return;
  if (o.makes_surface_only())
    throw tubular::Parameter_error(
        "A surface has no cells to be divided: --partitions is for the other types of mesh.");
  if (!tubular::IO::has_parts(o.mesh_format()))
    throw tubular::Parameter_error("The mesh cannot be written in parts to \"" + o.output +
                                   "\": with --partitions, give a .pvtu or .msh file, or --format openfoam.");
  if (o.is_quadratic())
    throw tubular::Parameter_error(
        "Meshes in parts are written with linear cells alone: leave --partitions or --order 2 "
        "away.");
  if (o.partitions > 1 && !tubular::has_metis())
    throw tubular::Parameter_error("This program was built without METIS, which --partitions needs: build it where "
                                   "that is installed (libmetis-dev), or write the mesh as a whole.");
}

void check_output(const Options& o, bool has_output) {
  if (!has_output) {
  } else if (o.makes_surface_only()) {
    if (!tubular::IO::is_supported_surface_format(o.output))
      throw tubular::Parameter_error("The surface cannot be written to \"" + o.output +
                                     "\": give a .stl, .vtp, .msh, .ply, .off, .obj or .vtk file.");
    if (!o.format.empty())
      throw tubular::Parameter_error("--format is for meshes of cells; the format of a surface is in its name.");
  } else {
    check_mesh_format(o);
  }
  check_partitions(o);
  if (!o.surface_output.empty() && !tubular::IO::is_supported_surface_format(o.surface_output))
    throw tubular::Parameter_error("The surface cannot be written to \"" + o.surface_output +
                                   "\": give a .stl, .vtp, .msh, .ply, .off, .obj or .vtk file.");
  const Mesh_format blocks = tubular::IO::mesh_format_of(o.blocks_output);
  if (!o.blocks_output.empty() && blocks != Mesh_format::vtu && blocks != Mesh_format::gmsh &&
      blocks != Mesh_format::medit && blocks != Mesh_format::abaqus)
    throw tubular::Parameter_error("The blocks cannot be written to \"" + o.blocks_output +
                                   "\": give a .vtu, .msh, .mesh or .inp file.");
}

// What is said of a wall needs one.
void check_wall(const Options& o) {
  const std::pair<bool, const char*> said[] = {{o.wall.number > 0, "--wall-layers"},
                                               {o.wall.growth > 0, "--wall-growth"},
                                               {o.wall_elements != "auto", "--wall-elements"},
                                               {o.has_second_wall(), "--second-wall"},
                                               {!o.material_array.empty(), "--material-array"},
                                               {o.fibres, "--fibres"}};
  for (const auto& option : said)
    if (option.first && !o.has_wall())
      throw tubular::Parameter_error(std::string(option.second) +
                                     " needs a wall: add --wall, --wall-thickness, --wall-thickness-array or "
                                     "--wall-thickness-table.");
  if ((o.second_wall.number > 0 || o.second_wall.growth > 0) && !o.has_second_wall())
    throw tubular::Parameter_error("--second-wall-layers and --second-wall-growth need a second wall: add "
                                   "--second-wall or --second-wall-thickness.");
}

void check_layers(const Options& o) {
  check_wall(o);
  if (o.makes_surface_only() && o.has_wall())
    throw tubular::Parameter_error("A surface has no cells, hence no --wall; choose another --type.");
  if (!o.makes_surface_only() && o.surface_elements != "triangles")
    throw tubular::Parameter_error("--surface-elements is for --type surface; --type mixed has quads on its own.");
  if ((o.is_mixed() || o.is_hexahedral()) && o.wall_elements == "tetrahedra")
    throw tubular::Parameter_error("The wall of a " + o.type +
                                   " mesh is of hexahedra, which match its quads: leave --wall-elements away, or "
                                   "choose --type isotropic.");
  if (!o.is_hexahedral() && (o.hex_method != "blocks" || o.hex_fallback != "subdivision"))
    throw tubular::Parameter_error("--hex-method and --hex-fallback are for --type hexahedral.");
  if (!o.blocks_output.empty() && (!o.is_hexahedral() || o.hex_method != "blocks"))
    throw tubular::Parameter_error("--write-blocks is for --type hexahedral, of --hex-method blocks.");
  if (o.boundary_layer_prisms > 0 && (o.makes_surface_only() || o.is_anisotropic()))
    throw tubular::Parameter_error(
        "--boundary-layer-prisms is for the types isotropic, mixed and hexahedral" +
        std::string(o.is_anisotropic() ? "; anisotropic tetrahedra are layers already." : "."));
  if (o.boundary_layer_prisms > 0 && o.surface_mesher == "mesh_3")
    throw tubular::Parameter_error("Layers inside the lumen grow from the mesh of --surface-mesher parametric.");
  if (o.boundary_layer_prisms > 0 && o.volume_mesher == "mesh_3")
    throw tubular::Parameter_error("Mesh_3 would not keep the sides of layers inside the lumen: these need "
                                   "--volume-mesher tetgen or ccdt.");
}

void check_reduced_model(const Options& o) {
  if (!o.sections_output.empty() && !tubular::IO::is_supported_sections_format(o.sections_output))
    throw tubular::Parameter_error("The cross-sections cannot be written to \"" + o.sections_output +
                                   "\": give a .csv or .vtp file.");
  if (!o.zero_d_output.empty() && std::filesystem::path(o.zero_d_output).extension() != ".json")
    throw tubular::Parameter_error("The zero-dimensional model cannot be written to \"" + o.zero_d_output +
                                   "\": give a .json file.");
}

bool has_ending(const std::string& file, const std::string& ending) {
  return file.size() > ending.size() && file.compare(file.size() - ending.size(), ending.size(), ending) == 0;
}

// What is missing, and what a solver does not take; the rest is as for files in its format.
void check_case(const Options& o) {
  const Case_options& c = o.solver_case;
  if (!c.is_wanted())
    return;
  if (o.makes_surface_only())
    throw tubular::Parameter_error("A surface has no cells to compute in: choose another --type for --case.");
  if (c.is_of_wall() && !(c.wall_pressure > 0))
    throw tubular::Parameter_error("--case calculix needs --wall-pressure, in Pa.");
  if (c.is_of_wall() && !o.has_wall())
    throw tubular::Parameter_error("--case calculix computes the vessel's wall: add --wall, its thickness.");
  if (c.is_of_wall() && (o.physics.flow_rate > 0 || !c.outlet_pressures.empty()))
    throw tubular::Parameter_error("--case calculix computes no flow: leave --flow-rate and --outlet-pressure away.");
  if (!c.is_of_wall() && !(o.physics.flow_rate > 0))
    throw tubular::Parameter_error("--case " + c.solver + " needs --flow-rate, in ml/s.");
  if (!c.is_of_wall() && (c.wall_pressure > 0 || o.has_wall()))
    throw tubular::Parameter_error("--case " + c.solver +
                                   " computes the flow in the lumen alone: leave --wall and --wall-pressure away.");
  if (c.solver == "freefem" && (o.is_mixed() || o.is_hexahedral() || o.boundary_layer_prisms > 0))
    throw tubular::Parameter_error("FreeFEM has tetrahedra alone: choose --type isotropic or anisotropic, without "
                                   "--boundary-layer-prisms.");
  if (c.solver == "svmultiphysics" && o.is_quadratic())
    throw tubular::Parameter_error("The case for svMultiPhysics is of linear elements: leave --order 2 away.");
  if (c.solver == "fenicsx" && o.is_quadratic() && o.is_hexahedral())
    throw tubular::Parameter_error(
        "The case for FEniCSx takes quadratic tetrahedra, but no quadratic hexahedra: leave --order 2 away.");
}

// Devices and pipes pass: opening them would be seen at their other end.
void check_mesh_output(const Options& o) {
  if (o.solver_case.is_wanted()) {
    open_case(o);
    return;
  }
  std::error_code ignored;
  const auto status = std::filesystem::status(o.output, ignored);
  if (!tubular::IO::is_folder(o.mesh_format()) && std::filesystem::is_other(status))
    return;
  if (o.partitions > 0)
    tubular::IO::open_partitioned_mesh(o.output, std::size_t(o.partitions), o.mesh_format());
  else
    tubular::IO::open_mesh(o.output, tubular::parameters::format(o.mesh_format()));
}

} // namespace

bool Options::meshes_patches() const {
  if ((type != "isotropic" && !is_hexahedral()) || boundary_layer_prisms > 0)
    return true;
  return surface_mesher.empty() ? !fills_by_mesh_3(*this) : surface_mesher == "parametric";
}

tubular::IO::Mesh_format Options::mesh_format_of_case() const {
  const std::string& solver = solver_case.solver;
  return solver == "openfoam"         ? Mesh_format::openfoam
         : solver == "svmultiphysics" ? Mesh_format::svmultiphysics
         : solver == "fenicsx"        ? Mesh_format::xdmf
         : solver == "freefem"        ? Mesh_format::medit
                                      : Mesh_format::abaqus;
}

void check(const Options& o, bool has_output) {
  const std::set<std::string> types = {"isotropic", "anisotropic", "mixed", "hexahedral", "surface"};
  if (types.count(o.type) == 0)
    throw tubular::Parameter_error("There is no type of mesh named \"" + o.type +
                                   "\"; the types are: isotropic, anisotropic, mixed, hexahedral, surface.");
  check_order(o);
  if (o.output.empty() && has_output)
    throw tubular::Parameter_error("--output is required, a name such as mesh.vtu; see --help.");
  if (!has_output && !o.dry_run && (o.is_quadratic() || o.partitions > 0))
    throw tubular::Parameter_error(
        "Quadratic elements and meshes in parts are written by tubular_mesh alone: leave the "
        "order and the partitions away, and write the mesh to a file there.");
  check_case(o);
  check_mesher(o);
  check_layers(o);
  if (!o.outlets.empty() && o.inlet.empty())
    throw tubular::Parameter_error("--outlet needs --inlet, where the centerlines begin.");
  if (o.min_size > o.max_size)
    throw tubular::Parameter_error("--min-size is larger than --max-size.");
  check_output(o, has_output);
  for (const std::string& report : o.reports)
    if (o.dry_run && Options::is_page(report))
      throw tubular::Parameter_error("A dry run makes no mesh that a page could show: give its report a .json file.");
  if (!o.picture.empty() && !has_ending(o.picture, ".png"))
    throw tubular::Parameter_error("The picture cannot be written to \"" + o.picture + "\": give a .png file.");
  if (!o.centerlines_output.empty() && !tubular::IO::is_supported_centerlines_format(o.centerlines_output))
    throw tubular::Parameter_error("The centerlines cannot be written to \"" + o.centerlines_output +
                                   "\": give a .vtp or .vtk file.");
  check_reduced_model(o);
  const auto same_file = [](const std::string& f) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(f), ignored).string();
  };
  std::set<std::string> files;
  for (const std::string& f : {o.surface, o.centerlines, o.seeds, o.wall_table})
    if (!f.empty())
      files.insert(same_file(f));
  for (const std::string& f : o.outputs())
    if ((has_output || f != o.output) && !files.insert(same_file(f)).second)
      throw tubular::Parameter_error("The file \"" + f + "\" is named twice; an output needs a name of its own.");
  try {
    for (const std::string& f : o.outputs())
      if (f != o.output || (has_output && o.makes_surface_only()))
        tubular::IO::check_writable(f);
    if (has_output && !o.makes_surface_only())
      check_mesh_output(o);
  } catch (const tubular::Output_error& e) { // the name was wrong; later on, a full disk is no fault of the user's
    throw tubular::Parameter_error(e.what());
  }
}
