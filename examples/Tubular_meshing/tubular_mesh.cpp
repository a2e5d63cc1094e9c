// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool: from a surface and its centerlines to a labelled mesh. See the user manual, or --help.

#include "command_line/run_tool.h"
#include "tubular_mesh/Options.h"
#include "tubular_mesh/Run_report.h"
#include "tubular_mesh/Stage_clock.h"
#include "tubular_mesh/stages.h"

#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>
#include <CGAL/Tubular_meshing/Patches/surface_to_mixed_mesh.h>

#include <boost/property_map/function_property_map.hpp>

#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <set>
#include <string>
#include <system_error>
#include <vector>

namespace {

const char* const version = TUBULAR_MESHING_VERSION;

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
  if (keeps_surface && !o.meshes_patches() && !o.is_anisotropic())
    throw tubular::Parameter_error(
        "--volume-mesher " + o.volume_mesher +
        " keeps the surface mesh that --surface-mesher parametric makes: give that as well.");
  const std::string why_not = why_not_filled_by(o.volume_mesher);
  if (!why_not.empty())
    throw tubular::Parameter_error(why_not);
}

void check_output(const Options& o) {
  if (o.makes_surface_only()) {
    if (!tubular::IO::is_supported_surface_format(o.output))
      throw tubular::Parameter_error("The surface cannot be written to \"" + o.output +
                                     "\": give a .stl, .vtp, .msh, .ply, .off, .obj or .vtk file.");
  } else if (!tubular::IO::is_supported_mesh_format(o.output)) {
    throw tubular::Parameter_error("The mesh cannot be written to \"" + o.output +
                                   "\": give a .vtu, .msh, .mesh or .inp file.");
  }
  if (!o.surface_output.empty() && !tubular::IO::is_supported_surface_format(o.surface_output))
    throw tubular::Parameter_error("The surface cannot be written to \"" + o.surface_output +
                                   "\": give a .vtp, .stl, .off, .obj or .ply file.");
}

void check_layers(const Options& o) {
  if (o.makes_surface_only() && o.has_wall())
    throw tubular::Parameter_error("A surface has no cells, hence no --wall; choose another --type.");
  if (!o.makes_surface_only() && o.surface_elements != "triangles")
    throw tubular::Parameter_error("--surface-elements is for --type surface; --type mixed has quads on its own.");
  if (o.is_mixed() && o.wall_elements == "tetrahedra")
    throw tubular::Parameter_error("The wall of a mixed mesh is of hexahedra, which match its quads: leave "
                                   "--wall-elements away, or choose --type isotropic.");
  if (o.boundary_layer_prisms > 0 && (o.makes_surface_only() || o.is_anisotropic()))
    throw tubular::Parameter_error(
        "--boundary-layer-prisms is for the types isotropic and mixed" +
        std::string(o.is_anisotropic() ? "; anisotropic tetrahedra are layers already." : "."));
  if (o.boundary_layer_prisms > 0 && o.surface_mesher == "mesh_3")
    throw tubular::Parameter_error("Layers inside the lumen grow from the mesh of --surface-mesher parametric.");
}

// What is wrong with the options as such; before any work is done, since work takes time.
void check(const Options& o) {
  const std::set<std::string> types = {"isotropic", "anisotropic", "mixed", "surface"};
  if (types.count(o.type) == 0)
    throw tubular::Parameter_error("There is no type of mesh named \"" + o.type +
                                   "\"; the types are: isotropic, anisotropic, mixed, surface.");
  check_mesher(o);
  check_layers(o);
  if (!o.outlets.empty() && o.inlet.empty())
    throw tubular::Parameter_error("--outlet needs --inlet, where the centerlines begin.");
  if (o.min_size > o.max_size)
    throw tubular::Parameter_error("--min-size is larger than --max-size.");
  check_output(o);
  if (!o.centerlines_output.empty() && !tubular::IO::is_supported_centerlines_format(o.centerlines_output))
    throw tubular::Parameter_error("The centerlines cannot be written to \"" + o.centerlines_output +
                                   "\": give a .vtp or .vtk file.");
  const auto same_file = [](const std::string& f) {
    std::error_code ignored;
    return std::filesystem::weakly_canonical(std::filesystem::absolute(f), ignored).string();
  };
  std::set<std::string> files;
  for (const std::string& f : {o.surface, o.centerlines, o.seeds})
    if (!f.empty())
      files.insert(same_file(f));
  for (const std::string& f : o.outputs())
    if (!files.insert(same_file(f)).second)
      throw tubular::Parameter_error("The file \"" + f + "\" is named twice; an output needs a name of its own.");
  try {
    for (const std::string& f : o.outputs())
      tubular::IO::check_writable(f);
  } catch (const tubular::Output_error& e) { // the name was wrong; later on, a full disk is no fault of the user's
    throw tubular::Parameter_error(e.what());
  }
}

typedef tubular::Remeshed_surface Remeshed_surface;

void write_surface(tubular::IO::Output_file& file, const Remeshed_surface& surface) {
  const auto labels = tubular::parameters::face_patch_map(surface.patch).surface_patch_map(surface.patch_of_face);
  if (surface.metrics.empty())
    return tubular::IO::write_surface(file, surface.surface, labels);
  typedef Surface::Vertex_index Vertex;
  const auto metric = boost::make_function_property_map<Vertex>([&](Vertex v) { return surface.metrics[v]; });
  tubular::IO::write_surface(file, surface.surface, labels.vertex_metric_map(metric));
}

// Writes everything that was asked for; nothing gets its name before all of it is whole.
void write(const Options& o, const tubular::Tubular_model& model, const Remeshed_surface& surface,
           const tubular::Mixed_mesh& mesh, run_report::Json& report, Stage_clock& clock) {
  std::vector<std::unique_ptr<tubular::IO::Output_file>> files;
  const auto open = [&](const std::string& name) -> tubular::IO::Output_file& {
    files.emplace_back(new tubular::IO::Output_file(name));
    return *files.back();
  };
  o.makes_surface_only() ? write_surface(open(o.output), surface) : tubular::IO::write_mesh(open(o.output), mesh);
  if (!o.surface_output.empty() && o.meshes_patches())
    write_surface(open(o.surface_output), surface);
  else if (!o.surface_output.empty())
    tubular::IO::write_surface(open(o.surface_output), model.surface, tubular::parameters::face_patch_map(model.patch));
  if (!o.centerlines_output.empty())
    tubular::IO::write_centerlines(open(o.centerlines_output), model.centerlines);
  clock.finish();
  run_report::add_times(report, clock);
  if (!o.report.empty())
    open(o.report).write(report.dump(2) + "\n");
  for (auto& f : files)
    f->finish();
  for (auto& f : files)
    f->commit();
}

// The surface as a mesh that has no cells yet, for the report.
tubular::Mixed_mesh without_cells(const Remeshed_surface& surface, std::size_t number_of_openings) {
  tubular::Mixed_mesh mesh;
  tubular::surface_to_mixed_mesh(surface, mesh);
  mesh.patch_names = tubular::lumen_patch_names(int(number_of_openings));
  return mesh;
}

void run(const Options& o) {
  check(o);
  Stage_clock clock(o.quiet);
  Surface input;
  const tubular::Repair_report repairs = read_surface(o, input, clock);
  const Flow_extensions extensions = extend_openings(o, input, clock);
  const tubular::Tubular_model model = prepare(o, input, extensions, clock);
  Remeshed_surface surface;
  tubular::Mixed_mesh mesh;
  tubular::Layer_report wall, boundary_layer;
  if (o.makes_surface_only()) {
    surface = make_surface_mesh(o, model, clock);
    mesh = without_cells(surface, model.openings.size());
  } else {
    mesh = make_mesh(o, model, surface, boundary_layer, clock);
    if (o.has_wall())
      wall = add_wall(o, model, mesh, clock);
  }
  clock.begin("report");
  run_report::Json report = run_report::make(o, version, repairs, extensions.lengths, model, mesh);
  if (o.meshes_patches())
    run_report::add_patches(report, surface);
  if (surface.quads.wall_quads() > 0)
    run_report::add_quads(report, surface.quads);
  if (o.makes_surface_only())
    run_report::describe_surface(report, surface);
  if (o.is_anisotropic_surface())
    run_report::add_metric_quality(report, surface);
  if (o.has_wall())
    run_report::add_layers(report, "wall", wall);
  if (o.boundary_layer_prisms > 0)
    run_report::add_layers(report, "boundary_layer", boundary_layer);
  if (o.is_anisotropic())
    run_report::add_metric_quality(report, model, mesh);
  clock.begin("write");
  write(o, model, surface, mesh, report, clock);
  if (!o.quiet) {
    run_report::print(report, o.verbose);
    if (std::fflush(stdout) != 0)
      throw tubular::Output_error("The summary cannot be printed; the files are written.");
  }
}

} // namespace

int main(int argc, char* argv[]) {
  CLI::App app("", "tubular_mesh");
  Options options;
  declare_options(app, options, std::string("tubular_mesh ") + version);
  return command_line::run_tool(app, argc, argv, [&] { run(options); });
}
