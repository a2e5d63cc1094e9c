// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "solver_case.h"

#include "Case_patches.h"

#include <CGAL/Tubular_meshing/IO/Output_file.h>
#include <CGAL/Tubular_meshing/IO/internal/Face_mesh.h>
#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/base/Cell_array.h>
#include <CGAL/Tubular_meshing/base/Numbered_cells.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <set>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::internal::Vector_3d Vector;
typedef nlohmann::ordered_json Json;

namespace {

typedef std::map<std::string, std::string> Words; // what stands for @WORD@

std::string number(double x) {
  std::ostringstream s;
  s.precision(10);
  s << x;
  return s.str();
}

// Where the mesh of a solver lies in the folder.
std::string mesh_file(const std::string& solver) {
  return solver == "openfoam"         ? "constant/polyMesh"
         : solver == "svmultiphysics" ? "mesh-complete"
         : solver == "fenicsx"        ? "mesh.xdmf"
         : solver == "freefem"        ? "mesh.mesh"
                                      : "mesh.inp";
}

// What a case may consist of: the templates, and the mesh. Results of solvers do not belong: they are not lost.
bool belongs(const std::filesystem::path& file) {
  const std::string name = file.generic_string();
  for (const auto& t : case_templates())
    if (t.first.substr(t.first.find('/') + 1) == name)
      return true;
  const std::set<std::string> others = {"mesh.xdmf", "mesh.h5", "mesh.mesh", "mesh.inp", "case.json", "case.edp"};
  return others.count(name) > 0 || name.rfind("constant/polyMesh/", 0) == 0 || name.rfind("mesh-complete/", 0) == 0;
}

std::string filled(std::string text, const Words& words) {
  for (const auto& [word, value] : words)
    for (std::size_t at = 0; (at = text.find("@" + word + "@", at)) != text.npos; at += value.size())
      text.replace(at, word.size() + 2, value);
  return text;
}

/* Of a mesh in which solvers compute, in metres: of the lumen, or of the wall alone. */
struct Case_mesh {
  tubular::Mixed_mesh linear; // empty if there are quadratic elements
  tubular::Quadratic_mesh quadratic;
  bool is_quadratic = false;
  std::vector<tubular::Cell_array> cell_arrays; // directions of fibres in a wall

  const tubular::Mixed_mesh& cells() const { return is_quadratic ? quadratic.linear : linear; }
};

void scale(std::vector<tubular::Point_3>& points, double factor) {
  for (tubular::Point_3& p : points)
    p = tubular::Point_3(factor * p.x(), factor * p.y(), factor * p.z());
}

// Those of a block's elements that are wanted, with the points that have got a number.
template <std::size_t N, class Wanted>
void copy_block(const tubular::Element_block<N>& from, const std::vector<std::uint32_t>& number, const Wanted& wanted,
                tubular::Element_block<N>& to) {
  for (std::size_t i = 0; i < from.size(); ++i) {
    auto element = from.vertices[i];
    if (!wanted(element, from.label[i]))
      continue;
    for (std::uint32_t& v : element)
      v = number[v];
    to.push_back(element, from.label[i]);
  }
}

/* The walls of vessels without their lumens. `kept`: of each of its points, the one that it was. */
tubular::Mixed_mesh walls_of(const tubular::Mixed_mesh& mesh, const std::set<int>& openings,
                             std::vector<std::uint32_t>& kept) {
  constexpr std::uint32_t none = std::uint32_t(-1);
  std::vector<std::uint32_t> number(mesh.points.size(), none);
  const auto mark = [&](const auto& block) {
    for (std::size_t i = 0; i < block.size(); ++i)
      if (block.label[i] != tubular::labels::lumen)
        for (std::uint32_t v : block.vertices[i])
          number[v] = 0;
  };
  mark(mesh.tetrahedra);
  mark(mesh.pyramids);
  mark(mesh.prisms);
  mark(mesh.hexahedra);
  tubular::Mixed_mesh walls;
  for (std::size_t v = 0; v < number.size(); ++v)
    if (number[v] != none) {
      number[v] = std::uint32_t(kept.size());
      kept.push_back(std::uint32_t(v));
      walls.points.push_back(mesh.points[v]);
    }
  const auto is_of_wall = [](const auto&, int label) { return label != tubular::labels::lumen; };
  copy_block(mesh.tetrahedra, number, is_of_wall, walls.tetrahedra);
  copy_block(mesh.pyramids, number, is_of_wall, walls.pyramids);
  copy_block(mesh.prisms, number, is_of_wall, walls.prisms);
  copy_block(mesh.hexahedra, number, is_of_wall, walls.hexahedra);
  const auto bounds_wall = [&](const auto& facet, int label) {
    return openings.count(label) == 0 &&
           std::all_of(facet.begin(), facet.end(), [&](std::uint32_t v) { return number[v] != none; });
  };
  copy_block(mesh.triangles, number, bounds_wall, walls.triangles);
  copy_block(mesh.quads, number, bounds_wall, walls.quads);
  walls.region_names = mesh.region_names;
  walls.region_names.erase(tubular::labels::lumen);
  for (const auto& name : mesh.patch_names)
    if (openings.count(name.first) == 0)
      walls.patch_names.insert(name);
  return walls;
}

// Values in the cells of walls_of(), which are those of the mesh without the lumen's.
std::vector<tubular::Cell_array> arrays_of_walls(const tubular::Mixed_mesh& mesh,
                                                 std::vector<tubular::Cell_array> arrays) {
  const tubular::internal::cells::Numbered_cells cells(mesh);
  for (tubular::Cell_array& a : arrays) {
    std::size_t kept = 0;
    for (std::size_t c = 0; c < cells.size(); ++c)
      for (int k = 0; k < a.components && cells.region(c) != tubular::labels::lumen; ++k)
        a.values[kept++] = a.values[c * std::size_t(a.components) + std::size_t(k)];
    a.values.resize(kept);
  }
  return arrays;
}

Case_mesh mesh_of(const Run& run) {
  const Options& o = run.options;
  Case_mesh result;
  result.is_quadratic = o.is_quadratic();
  if (!o.solver_case.is_of_wall()) {
    if (o.is_quadratic())
      result.quadratic = run.quadratic;
    else
      result.linear = run.mesh;
  } else {
    std::vector<std::uint32_t> kept;
    std::set<int> openings;
    for (const tubular::Opening& opening : run.model.openings)
      openings.insert(opening.patch);
    result.linear = walls_of(run.cells(), openings, kept);
    if (o.fibres)
      result.cell_arrays = arrays_of_walls(run.cells(), run.fibres.arrays());
    if (o.is_quadratic()) { // with the nodes where they are on the edges of the whole
      result.quadratic = tubular::straight_quadratic_mesh(std::move(result.linear), o.complete_elements, o.threads);
      tubular::Quadratic_mesh& q = result.quadratic;
      for (std::uint32_t a = 0; a < q.linear.points.size(); ++a)
        for (std::size_t e = q.first_edge[a]; e < q.first_edge[a + 1]; ++e)
          q.edge_points[e] = run.quadratic.edge_points[run.quadratic.edge(kept[a], kept[q.edge_end[e]])];
    }
  }
  const double meters = o.physics.meters();
  scale(result.linear.points, meters);
  for (auto* points : {&result.quadratic.linear.points, &result.quadratic.edge_points, &result.quadratic.quad_points,
                       &result.quadratic.inner_points})
    scale(*points, meters);
  result.linear.point_arrays.clear(); // a metric is in the surface's unit, and no solver reads it
  result.quadratic.linear.point_arrays.clear();
  return result;
}

void make_executable(const std::filesystem::path& file) {
  namespace fs = std::filesystem;
  std::error_code ignored; // on a file system that has no such bit, the shell can be asked to run it
  fs::permissions(file, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec, fs::perm_options::add,
                  ignored);
}

void write_mesh(const std::filesystem::path& file, const Case_mesh& mesh, tubular::IO::Mesh_format format) {
  const auto np = tubular::parameters::format(format);
  if (mesh.is_quadratic)
    tubular::IO::write_mesh(file.string(), mesh.quadratic, mesh.cell_arrays, np);
  else
    tubular::IO::write_mesh(file.string(), mesh.linear, mesh.cell_arrays, np);
}

// --- OpenFOAM ---

// The velocities at the faces of an inlet, in the order that they have in the files.
std::string velocities(const tubular::IO::internal::Face_mesh& faces, const tubular::Mixed_mesh& mesh, int patch,
                       double flow_rate) {
  const Inlet_profile profile(mesh, patch);
  std::vector<double> height;
  double through = 0;
  for (const auto& side : faces.patches().at(patch)) {
    const auto corners = faces.corners(side);
    std::vector<Vector> p;
    for (std::size_t k = 0; k < tubular::internal::cells::number_of_corners(corners); ++k)
      p.emplace_back(mesh.points[corners[k]]);
    Vector area, center;
    double size = 0;
    for (std::size_t k = 2; k < p.size(); ++k) {
      const Vector half = 0.5 * cross(p[k - 1] - p[0], p[k] - p[0]);
      area += half;
      center += (norm(half) / 3) * (p[0] + p[k - 1] + p[k]);
      size += norm(half);
    }
    center = (1 / size) * center;
    height.push_back(profile(tubular::Point_3(center.x, center.y, center.z)));
    through += height.back() * std::abs(dot(area, profile.inward()));
  }
  if (!(through > 0))
    throw tubular::Meshing_error("An inlet has too few facets for a velocity that is 0 at its rim: make a finer mesh.");
  std::ostringstream s;
  s.precision(9);
  s << "        value nonuniform List<vector>\n" << height.size() << "\n(\n";
  for (double h : height) {
    const Vector v = (h * flow_rate / through) * profile.inward();
    s << "(" << v.x << " " << v.y << " " << v.z << ")\n";
  }
  s << ");\n";
  return s.str();
}

void add_openfoam(const std::vector<Case_patch>& patches, const tubular::Mixed_mesh& mesh, double flow_rate,
                  double density, Words& words) {
  const tubular::IO::internal::Face_mesh faces(mesh, "the case");
  // on tetrahedra and prisms Gauss' gradients are not consistent: the pressure drop is up to a tenth off
  const bool has_hexahedra_alone = mesh.tetrahedra.empty() && mesh.pyramids.empty() && mesh.prisms.empty();
  words["GRADIENT"] = has_hexahedra_alone ? "Gauss linear" : "pointCellsLeastSquares";
  std::string& u = words["VELOCITIES"];
  std::string& p = words["PRESSURES"];
  std::string& functions = words["FUNCTIONS"];
  for (const Case_patch& patch : patches) {
    const std::string name = "    \"" + patch.name + "\"\n    {\n        type ";
    if (patch.kind == Case_patch::inlet) {
      u += name + "fixedValue;\n" + velocities(faces, mesh, patch.label, flow_rate) + "    }\n";
      p += name + "zeroGradient;\n    }\n";
    } else if (patch.kind == Case_patch::outlet) {
      // where there is backflow, which zeroGradient alone does not survive, it brings no momentum with it
      u += name + "inletOutlet;\n        inletValue uniform (0 0 0);\n        value uniform (0 0 0);\n    }\n";
      p += name + "fixedValue;\n        value uniform " + number(patch.pressure / density) + ";\n    }\n";
    } else {
      u += name + "noSlip;\n    }\n";
      p += name + "zeroGradient;\n    }\n";
      continue;
    }
    for (const char* const* f : std::array<const char* const [2], 2> {
           {
             {"p", "areaAverage"}, {
               "phi", "sum"
             }
           }
         })
      functions += "    \"" + std::string(f[0]) + "_" + patch.name +
                   "\" { type surfaceFieldValue; libs (\"libfieldFunctionObjects.so\"); regionType patch; name \"" +
                   patch.name + "\"; operation " + f[1] + "; fields (" + f[0] +
                   "); writeFields no; log no; writeControl writeTime; }\n";
  }
}

// --- svMultiPhysics ---

std::string xml_element(const std::string& name, const std::string& value, int indent) {
  return std::string(std::size_t(indent), ' ') + "<" + name + "> " + value + " </" + name + ">\n";
}

void add_svmultiphysics(const std::vector<Case_patch>& patches, const Run& run, Words& words) {
  const Physical_options& physics = run.options.physics;
  std::string& faces = words["FACES"];
  std::string& conditions = words["CONDITIONS"];
  double area = 0, volume_of_lines = 0;
  for (const tubular::Opening& o : run.model.openings)
    area = (std::max)(area, o.area * physics.meters() * physics.meters());
  for (const auto& b : run.model.centerlines.branches())
    volume_of_lines += b.length * physics.meters();
  for (const Case_patch& p : patches) {
    faces += "  <Add_face name=\"" + p.name + "\">\n" +
             xml_element("Face_file_path", "mesh-complete/mesh-surfaces/" + p.name + ".vtp", 4) + "  </Add_face>\n";
    conditions += "  <Add_BC name=\"" + p.name + "\">\n";
    conditions += xml_element("Type", p.kind == Case_patch::outlet ? "Neu" : "Dir", 4);
    conditions += xml_element("Time_dependence", "Steady", 4);
    conditions += xml_element("Value",
                              p.kind == Case_patch::inlet    ? number(-physics.flow_rate * 1e-6)
                              : p.kind == Case_patch::outlet ? number(p.pressure)
                                                             : "0.0",
                              4);
    if (p.kind == Case_patch::inlet)
      conditions += xml_element("Profile", "Parabolic", 4) + xml_element("Impose_flux", "true", 4);
    conditions += "  </Add_BC>\n";
  }
  const int steps = 300, passages = 3;
  const double time = volume_of_lines * area / (physics.flow_rate * 1e-6); // to pass through
  words["TIME_STEPS"] = std::to_string(steps);
  words["TIME_STEP"] = number(passages * time / steps);
}

// --- FEniCSx and FreeFEM ---

Json vector_of(const Vector& v) {
  return {v.x, v.y, v.z};
}

std::string case_json(const std::vector<Case_patch>& patches, const Case_mesh& mesh, const Run& run) {
  const Physical_options& physics = run.options.physics;
  Json json = {{"surface", run.options.surface}, {"density", physics.density},
               {"viscosity", physics.viscosity}, {"flow_rate", physics.flow_rate * 1e-6},
               {"inlets", Json::array()},        {"outlets", Json::array()},
               {"walls", Json::array()}};
  for (const Case_patch& p : patches) {
    Json patch = {{"name", p.name}, {"label", p.label}};
    if (p.kind == Case_patch::inlet) {
      const Inlet_profile profile =
          mesh.is_quadratic ? Inlet_profile(mesh.quadratic, p.label) : Inlet_profile(mesh.linear, p.label);
      patch["area"] = profile.area();
      patch["center"] = vector_of(profile.center());
      patch["inward"] = vector_of(profile.inward());
      patch["axes"] = {vector_of(profile.axes()[0]), vector_of(profile.axes()[1])};
      patch["rim"] = profile.rim();
    } else if (p.kind == Case_patch::outlet)
      patch["pressure"] = p.pressure;
    json[p.kind == Case_patch::inlet ? "inlets" : p.kind == Case_patch::outlet ? "outlets" : "walls"].push_back(patch);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

template <class Range> std::string array(const Range& values) {
  std::string text;
  for (const auto& v : values)
    text += (text.empty() ? "[" : ", ") + v;
  return text + "]";
}

// An array of arrays, row by row: there is no other way to fill one.
std::string rows(const std::string& name, const std::vector<std::vector<double>>& values) {
  std::ostringstream s;
  s.precision(12);
  s << "real[int, int] " << name << "(" << values.size() << ", " << values.front().size() << ");\n";
  for (std::size_t i = 0; i < values.size(); ++i)
    for (std::size_t j = 0; j < values[i].size(); ++j)
      s << name << "(" << i << ", " << j << ") = " << values[i][j] << ";" << (j % 4 == 3 ? "\n" : " ");
  s << "\n";
  return s.str();
}

std::string case_edp(const std::vector<Case_patch>& patches, const tubular::Mixed_mesh& mesh,
                     const Physical_options& physics, Words& words) {
  std::vector<std::string> inlets, openings, names, walls;
  std::vector<std::vector<double>> center, inward, axis1, axis2, rim;
  for (const Case_patch& p : patches) {
    const std::string label = std::to_string(p.label);
    if (p.kind == Case_patch::wall) {
      walls.push_back(label);
      continue;
    }
    openings.push_back(label);
    names.push_back("\"" + p.name + "\"");
    if (p.kind == Case_patch::outlet) {
      words["PRESSURES"] +=
          "  - int2d(Th, " + label + ")(" + number(p.pressure) + " * (N.x * vx + N.y * vy + N.z * vz))\n";
      continue;
    }
    const std::string k = std::to_string(inlets.size()),
                      shape = "speed[" + k + "] * profile(" + k + ", x, y, z) * inward(" + k;
    words["INLETS"] +=
        "  + on(" + label + ", wx = " + shape + ", 0), wy = " + shape + ", 1), wz = " + shape + ", 2))\n";
    inlets.push_back(label);
    const Inlet_profile profile(mesh, p.label);
    for (const auto& [rows, v] : {std::make_pair(&center, profile.center()), std::make_pair(&inward, profile.inward()),
                                  std::make_pair(&axis1, profile.axes()[0]), std::make_pair(&axis2, profile.axes()[1])})
      rows->push_back({v.x, v.y, v.z});
    rim.push_back(profile.rim());
  }
  const std::string list = array(walls);
  words["WALLS"] = list.substr(1, list.size() - 2);
  return "// The fluid, in Pa s and kg/m3, and the flow at each inlet, in m3/s.\nreal viscosity = " +
         number(physics.viscosity) + ", density = " + number(physics.density) +
         ", flowRate = " + number(physics.flow_rate * 1e-6) +
         ";\n\n// Numbers of patches in the mesh.\nint[int] inletLabel = " + array(inlets) +
         ";\nint[int] openingLabel = " + array(openings) + ";\nstring[int] openingName(" +
         std::to_string(names.size()) + ");\n" +
         [&] {
           std::string text;
           for (std::size_t i = 0; i < names.size(); ++i)
             text += "openingName[" + std::to_string(i) + "] = " + names[i] + ";\n";
           return text;
         }() +
         "\n// Of each inlet.\n" + rows("center", center) + rows("inward", inward) + rows("axis1", axis1) +
         rows("axis2", axis2) + rows("rim", rim);
}

// --- CalculiX ---

void add_calculix(const tubular::Mixed_mesh& walls, const Run& run, Words& words) {
  const Case_options& c = run.options.solver_case;
  const Physical_options& physics = run.options.physics;
  const auto patches = tubular::IO::internal::patch_names_in_file(walls, run.options.mesh_format());
  std::set<int> regions, labels(walls.triangles.label.begin(), walls.triangles.label.end());
  labels.insert(walls.quads.label.begin(), walls.quads.label.end());
  for (const auto* block : {&walls.tetrahedra.label, &walls.prisms.label, &walls.hexahedra.label})
    regions.insert(block->begin(), block->end());
  for (int r : regions)
    words["SECTIONS"] +=
        "*SOLID SECTION, ELSET=" + tubular::IO::internal::as_abaqus_name("region_" + walls.region_names.at(r)) +
        ", MATERIAL=TISSUE" + (run.options.fibres ? ", ORIENTATION=fibres" : "") + "\n";
  const int outer = tubular::labels::outer_wall_for(tubular::labels::wall + int(run.model.openings.size()));
  for (int label : labels)
    if (label > outer + 1)
      words["CLAMPED"] += patches.at(label) + ", 1, 3\n";
  words["INSIDE"] = patches.at(tubular::labels::wall);
  words["YOUNGS_MODULUS"] = number(physics.youngs_modulus);
  words["POISSONS_RATIO"] = number(c.poissons_ratio);
  words["WALL_PRESSURE"] = number(c.wall_pressure);
}

} // namespace

std::unique_ptr<tubular::IO::Output_folder> open_case(const Options& options) {
  return std::make_unique<tubular::IO::Output_folder>(options.output, belongs);
}

void write_case(tubular::IO::Output_folder& folder, const Run& run) {
  const Options& o = run.options;
  const Case_options& c = o.solver_case;
  const Physical_options& physics = o.physics;
  const Case_mesh mesh = mesh_of(run);
  std::string surface = o.surface; // into comments, of one line
  std::replace(surface.begin(), surface.end(), '\n', ' ');
  Words words = {{"SURFACE", surface},
                 {"DENSITY", number(physics.density)},
                 {"VISCOSITY", number(physics.viscosity)},
                 {"KINEMATIC_VISCOSITY", number(physics.viscosity / physics.density)},
                 {"FLOW_RATE", number(physics.flow_rate * 1e-6)}};
  const auto add_file = [&](const std::string& name, const std::string& text) { folder.file(name).write(text); };
  if (c.is_of_wall())
    add_calculix(mesh.cells(), run, words);
  else {
    const std::vector<Case_patch> patches = case_patches(run, mesh.cells());
    if (c.solver == "openfoam")
      add_openfoam(patches, mesh.cells(), physics.flow_rate * 1e-6, physics.density, words);
    else if (c.solver == "svmultiphysics")
      add_svmultiphysics(patches, run, words);
    else if (c.solver == "fenicsx")
      add_file("case.json", case_json(patches, mesh, run));
    else
      add_file("case.edp", case_edp(patches, mesh.cells(), physics, words));
  }
  for (const auto& [path, text] : case_templates()) {
    const std::size_t slash = path.find('/');
    if (path.substr(0, slash) != c.solver)
      continue;
    const std::string name = path.substr(slash + 1);
    add_file(name, filled(text, words));
  }
  folder.finish();
  for (const auto& [path, text] : case_templates()) // scripts
    if (path.rfind(c.solver + "/", 0) == 0 && text.rfind("#!", 0) == 0)
      make_executable(folder.folder() / path.substr(c.solver.size() + 1));
  write_mesh(folder.folder() / mesh_file(c.solver), mesh, o.mesh_format());
}
