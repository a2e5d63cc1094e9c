// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "model.h"

#include "Task.h"
#include "options.h"
#include "tubular_mesh/stages.h"
#include "views.h"

#include <CGAL/Tubular_meshing/Centerlines/cross_sections.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/Pipelines/join_parts.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

typedef py::array_t<double, py::array::c_style | py::array::forcecast> Numbers;

// Rows of three coordinates, or of these and a radius, which either all lines have or none.
tubular::Centerline_polylines polylines(const std::vector<Numbers>& lines) {
  tubular::Centerline_polylines result;
  for (const Numbers& line : lines) {
    result.lines.emplace_back();
    for (py::ssize_t i = 0; i < line.shape(0); ++i) {
      result.lines.back().push_back(result.points.size());
      result.points.emplace_back(line.at(i, 0), line.at(i, 1), line.at(i, 2));
      if (line.shape(1) == 4)
        result.radius.push_back(line.at(i, 3));
    }
  }
  return result;
}

tubular::Tubular_model joined(const Prepared& prepared) {
  std::vector<tubular::Tubular_model> models;
  for (Part& part : copy_of(prepared.parts, prepared.run.options, {}))
    models.push_back(std::move(part.run.model));
  return tubular::join_parts(std::move(models));
}

std::unique_ptr<Python_model> make_model(const Python_surface& surface, std::vector<std::string> arguments,
                                         const std::vector<Numbers>& lines, const std::string& source,
                                         const py::object& progress) {
  const tubular::Centerline_polylines given = polylines(lines);
  return run_task(progress, [&](Stage_clock& clock) {
    auto model = std::make_unique<Python_model>();
    model->data = surface.data;
    Run run;
    run.options = parse_options(std::move(arguments));
    run.options.surface = source;
    run.version = TUBULAR_MESHING_VERSION;
    check(run.options, false);
    tubular::Surface mesh;
    if (surface.repaired) {
      clock.continue_from(surface.repaired->clock);
      mesh = surface.repaired->surface;
      run.repairs = surface.repaired->report;
    } else {
      mesh = repair(run, *surface.data, clock);
    }
    take_requests(run, *surface.data, mesh);
    if (!given.lines.empty())
      run.lines = given;
    model->prepared = prepare(run, mesh, clock);
    if (model->prepared.parts.size() > 1)
      model->joined = joined(model->prepared);
    clock.stop();
    model->clock = clock;
    return model;
  });
}

py::object index_or_none(std::size_t i) {
  return i == tubular::Opening::no_branch ? py::object(py::none()) : py::object(py::int_(i));
}

py::list openings_of(const Python_model& model) {
  const tubular::Label_names names = patch_names(model.whole());
  py::list list;
  for (const tubular::Opening& o : model.whole().openings)
    list.append(py::make_tuple(names.at(o.patch), o.patch, array_of_coordinates(o.center),
                               array_of_coordinates(o.normal), o.area, o.perimeter, o.radius, index_or_none(o.branch)));
  return list;
}

// Points are shared by the branches that meet in them: each branch gets its own.
py::list branches_of(const Python_model& model) {
  const tubular::Centerline_graph& graph = model.whole().centerlines;
  py::list list;
  for (const auto& b : graph.branches()) {
    std::vector<std::array<double, 3>> points;
    std::vector<double> radii;
    for (std::size_t i : b.points) {
      const tubular::Point_3& p = graph.points()[i];
      points.push_back({p.x(), p.y(), p.z()});
      radii.push_back(graph.radii()[i]);
    }
    list.append(py::make_tuple(array_of(std::move(points)), array_of(std::move(radii)), array_of(b.abscissa), b.length,
                               b.min_radius, b.max_radius, b.parents, b.children));
  }
  return list;
}

py::tuple centerlines_of(const py::object& self) {
  const tubular::Centerline_graph& graph = self.cast<const Python_model&>().whole().centerlines;
  py::list lines;
  for (const auto& b : graph.branches())
    lines.append(view_of(b.points, self));
  return py::make_tuple(view_of(graph.points(), self), view_of(graph.radii(), self), lines);
}

py::tuple sections_of(const Python_model& model, double spacing, int threads) {
  std::vector<tubular::Cross_section> sections = run_task(py::none(), [&](Stage_clock&) {
    return tubular::cross_sections(model.whole().surface, model.whole().centerlines, spacing, threads);
  });
  std::vector<std::uint64_t> branch;
  std::vector<double> abscissa, area, perimeter, inscribed, hydraulic, eccentricity, curvature, torsion;
  std::vector<std::array<double, 3>> points, centers, normals;
  for (const auto& s : sections) {
    branch.push_back(s.branch);
    abscissa.push_back(s.abscissa);
    area.push_back(s.area);
    perimeter.push_back(s.perimeter);
    inscribed.push_back(s.inscribed_radius);
    hydraulic.push_back(s.hydraulic_diameter());
    eccentricity.push_back(s.eccentricity);
    curvature.push_back(s.curvature);
    torsion.push_back(s.torsion);
    points.push_back({s.point.x(), s.point.y(), s.point.z()});
    centers.push_back({s.center.x(), s.center.y(), s.center.z()});
    normals.push_back({s.normal.x(), s.normal.y(), s.normal.z()});
  }
  return py::make_tuple(array_of(std::move(branch)), array_of(std::move(abscissa)), array_of(std::move(points)),
                        array_of(std::move(normals)), array_of(std::move(centers)), array_of(std::move(area)),
                        array_of(std::move(perimeter)), array_of(std::move(inscribed)),
                        array_of(std::move(hydraulic)), array_of(std::move(eccentricity)),
                        array_of(std::move(curvature)), array_of(std::move(torsion)));
}

// The closed surface: points, triangles, and the patch of each.
py::tuple surface_of(const Python_model& model) {
  const tubular::Surface& mesh = model.whole().surface;
  std::vector<std::uint32_t> number(mesh.num_vertices());
  std::vector<std::array<double, 3>> points;
  for (auto v : mesh.vertices()) {
    number[v] = std::uint32_t(points.size());
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  }
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> patch;
  for (auto f : mesh.faces()) {
    std::size_t i = 0;
    triangles.emplace_back();
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangles.back()[i++] = number[v];
    patch.push_back(model.whole().patch[f]);
  }
  return py::make_tuple(array_of(std::move(points)), array_of(std::move(triangles)), array_of(std::move(patch)));
}

void write_centerlines(const Python_model& model, const std::string& file) {
  run_task(py::none(), [&](Stage_clock&) {
    tubular::IO::Output_file output(file);
    tubular::IO::write_centerlines(output, model.whole().centerlines);
    output.commit();
  });
}

void write_model_surface(const Python_model& model, const std::string& file) {
  run_task(py::none(), [&](Stage_clock&) {
    tubular::IO::Output_file output(file);
    write_surface(output, model.whole());
    output.commit();
  });
}

} // namespace

void add_model(py::module_& module) {
  py::class_<Python_model>(module, "Model")
      .def(py::init(&make_model))
      .def_property_readonly("number_of_vessels", [](const Python_model& m) { return m.prepared.parts.size(); })
      .def_property_readonly("openings", &openings_of)
      .def_property_readonly("branches", &branches_of)
      .def_property_readonly("centerlines", &centerlines_of)
      .def_property_readonly("surface", &surface_of)
      .def("sections", &sections_of)
      .def("write_centerlines", &write_centerlines)
      .def("write_surface", &write_model_surface);
}
