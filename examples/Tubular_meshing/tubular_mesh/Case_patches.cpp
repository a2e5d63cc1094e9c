// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Case_patches.h"

#include <CGAL/Tubular_meshing/IO/internal/names_in_files.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <map>
#include <set>
#include <utility>

namespace tubular = CGAL::Tubular_meshing;
typedef tubular::internal::Vector_3d Vector;

namespace {

constexpr double two_pi = 2 * CGAL_PI;

typedef std::pair<std::uint32_t, std::uint32_t> Edge;

// Calls f(points of a facet) for those of a patch, as triangles or quads.
template <class F> void for_each_facet(const tubular::Mixed_mesh& mesh, int patch, const F& f) {
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == patch)
      f(std::vector<std::uint32_t>(mesh.triangles.vertices[i].begin(), mesh.triangles.vertices[i].end()));
  for (std::size_t i = 0; i < mesh.quads.size(); ++i)
    if (mesh.quads.label[i] == patch)
      f(std::vector<std::uint32_t>(mesh.quads.vertices[i].begin(), mesh.quads.vertices[i].end()));
}

} // namespace

Inlet_profile::Inlet_profile(const tubular::Mixed_mesh& mesh, int patch)
    : Inlet_profile(mesh, nullptr, patch) {}
Inlet_profile::Inlet_profile(const tubular::Quadratic_mesh& mesh, int patch)
    : Inlet_profile(mesh.linear, &mesh, patch) {}

Inlet_profile::Inlet_profile(const tubular::Mixed_mesh& mesh, const tubular::Quadratic_mesh* nodes, int patch) {
  Vector normal, weighted;
  std::map<Edge, int> sides; // of each edge, how many facets it has
  for_each_facet(mesh, patch, [&](const std::vector<std::uint32_t>& facet) {
    const Vector origin(mesh.points[facet[0]]);
    for (std::size_t k = 0; k < facet.size(); ++k)
      ++sides[std::minmax(facet[k], facet[(k + 1) % facet.size()])];
    for (std::size_t k = 2; k < facet.size(); ++k) {
      const Vector a(mesh.points[facet[k - 1]]), b(mesh.points[facet[k]]);
      const Vector half = 0.5 * cross(a - origin, b - origin);
      normal += half;
      weighted += (norm(half) / 3) * (origin + a + b);
      area_ += norm(half);
    }
  });
  center_ = (1 / area_) * weighted;
  inward_ = -1 * normalized(normal); // facets of the boundary are turned outward
  const Vector other = std::abs(inward_.x) < 0.7 ? Vector(1., 0., 0.) : Vector(0., 1., 0.);
  axes_[0] = normalized(cross(inward_, other));
  axes_[1] = cross(inward_, axes_[0]);
  std::vector<std::array<Vector, 2>> edges;
  for (const auto& side : sides) {
    const Edge& e = side.first;
    if (side.second != 1)
      continue;
    const Vector a(mesh.points[e.first]), b(mesh.points[e.second]);
    if (nodes) {
      const Vector middle(nodes->edge_points[nodes->edge(e.first, e.second)]);
      edges.push_back({a, middle});
      edges.push_back({middle, b});
    } else
      edges.push_back({a, b});
  }
  find_rim(edges);
}

/* An edge is seen from the center between the angles of its ends; at an angle in between it is where the ray meets it.
 * What is farther counts. */
void Inlet_profile::find_rim(const std::vector<std::array<Vector, 2>>& edges) {
  rim_.assign(angles, 0);
  const double step = two_pi / angles;
  for (const auto& edge : edges) {
    std::array<double, 2> x, y;
    for (int i = 0; i < 2; ++i) {
      x[i] = dot(edge[i] - center_, axes_[0]);
      y[i] = dot(edge[i] - center_, axes_[1]);
    }
    const double turned = x[0] * y[1] - x[1] * y[0];
    if (turned == 0)
      continue;
    const int first = turned > 0 ? 0 : 1;
    const double from = std::atan2(y[first], x[first]);
    double span = std::atan2(y[1 - first], x[1 - first]) - from;
    span += span < 0 ? two_pi : 0;
    const double slack = 1e-9; // an angle between two edges is seen at one of them at least
    for (long k = std::lround(std::ceil(from / step - slack)); double(k) * step <= from + span + slack; ++k) {
      const double c = std::cos(double(k) * step), s = std::sin(double(k) * step);
      const double across = c * (y[1] - y[0]) - s * (x[1] - x[0]);
      double& r = rim_[std::size_t(((k % angles) + angles) % angles)];
      if (across != 0)
        r = (std::max)(r, turned / across);
    }
  }
  if (!(*std::min_element(rim_.begin(), rim_.end()) > 0))
    throw tubular::Meshing_error(
        "The inlet has no rim round its center, from which the velocity of a case is computed; "
        "extend it by --flow-extensions, or write the mesh alone.");
}

double Inlet_profile::operator()(const Point_3& p) const {
  const Vector d = Vector(p) - center_;
  const double u = dot(d, axes_[0]), v = dot(d, axes_[1]);
  const double t = (std::atan2(v, u) / two_pi + 1) * angles;
  const std::size_t i = std::size_t(t);
  const double a = rim_[i % angles], b = rim_[(i + 1) % angles], r = a + (t - double(i)) * (b - a);
  return (std::max)(1 - (u * u + v * v) / (r * r), 0.);
}

std::vector<Case_patch> case_patches(const Run& run, const tubular::Mixed_mesh& mesh) {
  const auto names = tubular::IO::internal::patch_names_in_file(mesh, run.options.mesh_format());
  std::set<int> inlets; // the first opening of each vessel
  std::size_t first = 0;
  for (std::size_t n : run.openings_of_parts) {
    if (n > 0)
      inlets.insert(run.model.openings[first].patch);
    first += n;
  }
  std::set<int> openings;
  for (const tubular::Opening& o : run.model.openings)
    openings.insert(o.patch);
  std::set<int> labels(mesh.triangles.label.begin(), mesh.triangles.label.end());
  labels.insert(mesh.quads.label.begin(), mesh.quads.label.end());
  std::vector<Case_patch> patches;
  for (int label : labels)
    patches.push_back({label, names.at(label),
                       inlets.count(label) > 0     ? Case_patch::inlet
                       : openings.count(label) > 0 ? Case_patch::outlet
                                                   : Case_patch::wall});
  for (const std::string& text : run.options.solver_case.outlet_pressures) {
    const std::size_t sign = text.rfind('=');
    const double pressure = std::strtod(text.c_str() + (sign == text.npos ? 0 : sign + 1), nullptr);
    bool is_there = false;
    for (Case_patch& p : patches) {
      const auto own = mesh.patch_names.find(p.label);
      const bool is_meant =
          p.kind == Case_patch::outlet &&
          (sign == text.npos || text.substr(0, sign) == (own == mesh.patch_names.end() ? p.name : own->second));
      if (is_meant)
        p.pressure = pressure;
      is_there = is_there || is_meant;
    }
    if (!is_there)
      throw tubular::Parameter_error("There is no outlet \"" + text.substr(0, sign) +
                                     "\" to have the pressure of --outlet-pressure; --dry-run lists the openings.");
  }
  return patches;
}
