// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "surface.h"

#include "Task.h"
#include "options.h"
#include "tubular_mesh/Run.h"
#include "tubular_mesh/stages.h"
#include "views.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <pybind11/stl.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

typedef py::array_t<double, py::array::c_style | py::array::forcecast> Numbers;
typedef py::array_t<std::int64_t, py::array::c_style | py::array::forcecast> Integers;

Python_surface surface_of_file(const std::string& file, const std::string& faces, const py::object& progress) {
  return run_task(progress, [&](Stage_clock& clock) {
    clock.begin("read");
    return Python_surface{std::make_shared<tubular::IO::Surface_data>(tubular::IO::read_surface_data(file, faces)),
                          nullptr};
  });
}

// Arrays whose shapes Python has looked at. Indices that are out of range are found by the repair, negative ones as
// well, being large then.
Python_surface surface_of_arrays(const Numbers& points, const Integers& triangles,
                                 const std::optional<Integers>& labels, const std::string& array,
                                 const tubular::Label_names& names, const std::optional<int>& wall,
                                 const std::map<std::string, std::vector<double>>& point_arrays,
                                 const std::map<std::string, std::vector<double>>& cell_arrays) {
  auto data = std::make_shared<tubular::IO::Surface_data>();
  data->points.reserve(std::size_t(points.shape(0)));
  for (py::ssize_t i = 0; i < points.shape(0); ++i)
    data->points.emplace_back(points.at(i, 0), points.at(i, 1), points.at(i, 2));
  data->triangles.reserve(std::size_t(triangles.shape(0)));
  for (py::ssize_t i = 0; i < triangles.shape(0); ++i)
    data->triangles.push_back(
        {std::size_t(triangles.at(i, 0)), std::size_t(triangles.at(i, 1)), std::size_t(triangles.at(i, 2))});
  data->point_arrays = point_arrays;
  data->cell_arrays = cell_arrays;
  data->names = names;
  if (labels) {
    tubular::Surface_labels& l = data->labels;
    l.source = array.empty() ? "labels" : "cell array " + array;
    l.array = array;
    l.names = names;
    l.wall = wall;
    for (py::ssize_t i = 0; i < labels->shape(0); ++i)
      l.label.push_back(int(labels->at(i)));
  }
  return {data, nullptr};
}

Python_surface repaired(const Python_surface& surface, std::vector<std::string> arguments, const py::object& progress) {
  return run_task(progress, [&](Stage_clock& clock) {
    Run run;
    run.options = parse_options(std::move(arguments));
    auto result = std::make_shared<Repaired_surface>();
    result->surface = repair(run, *surface.data, clock);
    result->report = run.repairs;
    clock.stop();
    result->clock = clock;
    return Python_surface{surface.data, result};
  });
}

py::array points_of(const py::object& self) {
  const auto& surface = self.cast<const Python_surface&>();
  if (!surface.repaired)
    return view_of(surface.data->points, self);
  const tubular::Surface& mesh = surface.repaired->surface;
  std::vector<std::array<double, 3>> points;
  for (auto v : mesh.vertices())
    points.push_back({mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z()});
  return array_of(std::move(points));
}

py::array triangles_of(const py::object& self) {
  const auto& surface = self.cast<const Python_surface&>();
  if (!surface.repaired)
    return view_of(surface.data->triangles, self);
  const tubular::Surface& mesh = surface.repaired->surface;
  std::vector<std::uint64_t> number(mesh.num_vertices()); // removed vertices have none
  std::uint64_t n = 0;
  for (auto v : mesh.vertices())
    number[v] = n++;
  std::vector<std::array<std::uint64_t, 3>> triangles;
  for (auto f : mesh.faces()) {
    std::size_t i = 0;
    triangles.emplace_back();
    for (auto v : mesh.vertices_around_face(mesh.halfedge(f)))
      triangles.back()[i++] = number[v];
  }
  return array_of(std::move(triangles));
}

py::object labels_of(const py::object& self) {
  const auto& surface = self.cast<const Python_surface&>();
  if (surface.repaired || surface.data->labels.empty())
    return py::none();
  return view_of(surface.data->labels.label, self);
}

py::list repairs_of(const Python_surface& surface) {
  py::list list;
  if (surface.repaired)
    for (const tubular::Repair& r : surface.repaired->report.repairs) {
      const py::object place = r.has_place ? py::object(array_of_coordinates(r.place)) : py::object(py::none());
      list.append(py::make_tuple(tubular::name_of(r.defect), r.count, r.size, place, r.sentence));
    }
  return list;
}

} // namespace

void add_surface(py::module_& module) {
  py::class_<Python_surface>(module, "Surface")
      .def_property_readonly("points", &points_of)
      .def_property_readonly("triangles", &triangles_of)
      .def_property_readonly("labels", &labels_of)
      .def_property_readonly("label_names", [](const Python_surface& s) { return s.data->labels.names; })
      .def_property_readonly("point_arrays", [](const Python_surface& s) { return s.data->point_arrays; })
      .def_property_readonly("cell_arrays", [](const Python_surface& s) { return s.data->cell_arrays; })
      .def_property_readonly("notes", [](const Python_surface& s) { return s.data->notes; })
      .def_property_readonly("is_repaired", [](const Python_surface& s) { return s.repaired != nullptr; })
      .def_property_readonly("repairs", &repairs_of);
  module.def("read_surface", &surface_of_file);
  module.def("surface_of_arrays", &surface_of_arrays);
  module.def("repair", &repaired);
}
