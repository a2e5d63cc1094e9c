// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "mesh.h"

#include "Task.h"
#include "model.h"
#include "options.h"
#include "tubular_mesh/Run_report.h"
#include "tubular_mesh/execute.h"
#include "tubular_mesh/stages.h"
#include "tubular_mesh/walls.h"
#include "views.h"

#include <CGAL/Tubular_meshing/IO/Mesh_format.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Quality/element_quality.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <pybind11/stl.h>

#include <cstddef>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

/* A mesh, with all that the tool would say about it. */
struct Python_mesh {
  Run run;
  Stage_clock clock = Stage_clock();
};

bool has_outputs(const Options& o) {
  for (const std::string& file : o.outputs())
    if (!file.empty())
      return true;
  return false;
}

void print(const Run_report& report, bool verbose) {
  report.print(verbose);
  if (std::fflush(stdout) != 0)
    throw tubular::Output_error("The summary cannot be printed.");
}

std::unique_ptr<Python_mesh> mesh_of_model(const Python_model& model, std::vector<std::string> arguments,
                                           const std::string& source, bool prints, const py::object& progress) {
  return run_task(progress, [&](Stage_clock& clock) {
    Options options = parse_options(std::move(arguments));
    options.surface = source;
    check(options, !options.output.empty());
    clock.continue_from(model.clock);
    auto mesh = std::make_unique<Python_mesh>();
    mesh->run = make_mesh(
        copy_of(model.prepared, options, size_requests(options, *model.data), wall_requests(options, *model.data)),
        clock);
    if (!options.output.empty())
      note_changes(mesh->run);
    if (prints || has_outputs(options)) {
      clock.begin("report");
      Run_report report(mesh->run);
      clock.begin("write");
      write(mesh->run, report, clock);
      if (prints)
        print(report, options.verbose);
    }
    clock.stop();
    mesh->clock = clock;
    return mesh;
  });
}

template <std::size_t N> py::tuple views_of(const tubular::Element_block<N>& elements, const py::object& self) {
  return py::make_tuple(view_of(elements.vertices, self), view_of(elements.label, self));
}

// The vertices and the labels of the elements of a kind, by the names of meshio.
py::tuple elements_of(const py::object& self, const std::string& kind) {
  const tubular::Mixed_mesh& mesh = self.cast<const Python_mesh&>().run.mesh;
  return kind == "tetra"        ? views_of(mesh.tetrahedra, self)
         : kind == "pyramid"    ? views_of(mesh.pyramids, self)
         : kind == "wedge"      ? views_of(mesh.prisms, self)
         : kind == "hexahedron" ? views_of(mesh.hexahedra, self)
         : kind == "triangle"   ? views_of(mesh.triangles, self)
         : kind == "quad"       ? views_of(mesh.quads, self)
                                : throw py::key_error(kind);
}

py::dict point_arrays_of(const py::object& self) {
  py::dict arrays;
  for (const tubular::Point_array& a : self.cast<const Python_mesh&>().run.mesh.point_arrays)
    arrays[py::str(a.name)] =
        read_only_view(a.values.data(), {py::ssize_t(a.values.size()) / a.components, py::ssize_t(a.components)}, self);
  return arrays;
}

// The directions of fibres, if there are any.
py::dict cell_arrays_of(const py::object& self) {
  py::dict arrays;
  const Run& run = self.cast<const Python_mesh&>().run;
  if (run.options.fibres)
    for (const tubular::Cell_array* a : {&run.fibres.circumferential, &run.fibres.longitudinal})
      arrays[py::str(a->name)] = read_only_view(
          a->values.data(), {py::ssize_t(a->values.size()) / a->components, py::ssize_t(a->components)}, self);
  return arrays;
}

py::array_t<double> quality_of(const Python_mesh& mesh, const std::string& measure) {
  return array_of(run_task(py::none(), [&](Stage_clock&) { return tubular::element_quality(mesh.run.mesh, measure); }));
}

std::string json_report_of(const Python_mesh& mesh) {
  return run_task(py::none(), [&](Stage_clock&) {
    Run_report report(mesh.run);
    report.add_times(mesh.clock);
    return report.json();
  });
}

void print_summary(const Python_mesh& mesh, bool verbose) {
  run_task(py::none(), [&](Stage_clock&) {
    Run_report report(mesh.run);
    report.add_times(mesh.clock);
    print(report, verbose);
  });
}

void write_mesh_as_surface(const Python_mesh& mesh, const std::string& file) {
  tubular::IO::Output_file output(file);
  if (mesh.run.surface.surface.number_of_faces() > 0)
    write_surface(output, mesh.run.surface, mesh.run.model);
  else
    write_surface(output, mesh.run.model);
  output.commit();
}

void write_to_file(const Python_mesh& mesh, const std::string& file, const std::string& format) {
  run_task(py::none(), [&](Stage_clock&) {
    Options options = mesh.run.options;
    options.output = file;
    options.format = format;
    options.surface_output = options.centerlines_output = options.blocks_output = options.picture = "";
    options.reports.clear();
    check(options);
    if (options.makes_surface_only())
      write_mesh_as_surface(mesh, file);
    else
      tubular::IO::write_mesh(file, mesh.run.mesh, cell_arrays(mesh.run),
                              tubular::parameters::format(options.mesh_format()));
  });
}

void write_surface_of(const Python_mesh& mesh, const std::string& file) {
  run_task(py::none(), [&](Stage_clock&) { write_mesh_as_surface(mesh, file); });
}

// What a format changes, a sentence each.
std::vector<std::string> changes_in(const Python_mesh& mesh, const std::string& file, const std::string& format) {
  return tubular::IO::changes_in(mesh.run.mesh, format.empty() ? tubular::IO::mesh_format_of(file)
                                                               : tubular::IO::mesh_format_named(format));
}

} // namespace

void add_mesh(py::module_& module) {
  py::class_<Python_mesh>(module, "Mesh")
      .def_property_readonly(
          "points",
          [](const py::object& self) { return view_of(self.cast<const Python_mesh&>().run.mesh.points, self); })
      .def("elements", &elements_of)
      .def_property_readonly("point_arrays", &point_arrays_of)
      .def_property_readonly("cell_arrays", &cell_arrays_of)
      .def_property_readonly("patch_names", [](const Python_mesh& m) { return m.run.mesh.patch_names; })
      .def_property_readonly("region_names", [](const Python_mesh& m) { return m.run.mesh.region_names; })
      .def_property_readonly("measures", [](const Python_mesh& m) { return tubular::element_measures(m.run.mesh); })
      .def_property_readonly("is_surface", [](const Python_mesh& m) { return m.run.options.makes_surface_only(); })
      .def_property_readonly("fallbacks", [](const Python_mesh& m) { return m.run.meshing.fallbacks; })
      .def("quality", &quality_of)
      .def("json_report", &json_report_of)
      .def("print_summary", &print_summary)
      .def("write", &write_to_file)
      .def("write_surface", &write_surface_of)
      .def("changes_in", &changes_in);
  module.def("mesh", &mesh_of_model);
  module.def("mesh_formats", &tubular::IO::mesh_format_names);
}
