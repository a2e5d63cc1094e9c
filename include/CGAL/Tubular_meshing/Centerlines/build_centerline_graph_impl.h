// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_IMPL_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_IMPL_H

#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Line_merger.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/Sampled_line.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/chain_lines.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/choose_root.h>
#include <CGAL/Tubular_meshing/Centerlines/internal/trace_branches.h>
#include <CGAL/Tubular_meshing/base/Nearest_tree.h>
#include <CGAL/Tubular_meshing/base/convert_surface.h>
#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

inline std::vector<Double_kernel::Point_3> checked_points(const Centerline_polylines& polylines) {
  std::vector<Double_kernel::Point_3> points;
  points.reserve(polylines.points.size());
  for (const Point_3& p : polylines.points) {
    points.push_back(to_double_point(p));
    const Double_kernel::Point_3& q = points.back();
    if (!std::isfinite(q.x()) || !std::isfinite(q.y()) || !std::isfinite(q.z()))
      throw Input_error("Point " + std::to_string(points.size() - 1) +
                        " of the centerlines has a coordinate that is not a number; repair the file.");
  }
  for (std::size_t i = 0; i < polylines.lines.size(); ++i) {
    if (polylines.lines[i].size() < 2)
      throw Input_error("Line " + std::to_string(i) + " of the centerlines has fewer than two points.");
    for (std::size_t p : polylines.lines[i])
      if (p >= points.size())
        throw Input_error("Line " + std::to_string(i) + " of the centerlines refers to point " + std::to_string(p) +
                          ", but there are only " + std::to_string(points.size()) + " points.");
  }
  if (polylines.lines.empty())
    throw Input_error("The centerlines hold no lines.");
  return points;
}

// f at each point; once only where lines repeat a point exactly, as VMTK's do.
inline std::vector<double> values_at(const std::vector<Double_kernel::Point_3>& points, Length_function f) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a] < points[b]; });
  std::vector<double> values(points.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    values[order[i]] =
        i > 0 && points[order[i]] == points[order[i - 1]] ? values[order[i - 1]] : f(to_core(points[order[i]]));
  return values;
}

// Points this close are one: what rounding to single precision, or to the six digits of a text file, makes of a point.
inline double coincidence(const std::vector<Double_kernel::Point_3>& points) {
  CGAL::Bbox_3 box;
  double largest = 0;
  for (const Double_kernel::Point_3& p : points) {
    box += p.bbox();
    largest = (std::max)({largest, std::abs(p.x()), std::abs(p.y()), std::abs(p.z())});
  }
  const double dx = box.xmax() - box.xmin(), dy = box.ymax() - box.ymin(), dz = box.zmax() - box.zmin();
  return (std::max)(1e-6 * std::sqrt(dx * dx + dy * dy + dz * dz) + 2e-7 * largest, 1e-300);
}

// The radius of a point that is on the wall, or outside, for the purpose of tolerances only.
inline double least_radius(const std::vector<double>& radius) {
  const double largest = radius.empty() ? 0 : *std::max_element(radius.begin(), radius.end());
  if (!(largest > 0) || !std::isfinite(largest))
    throw Input_error("The centerlines have no positive radius; give the surface, or centerlines with the array "
                      "MaximumInscribedSphereRadius.");
  return 1e-3 * largest;
}

// Long lines first, so that the result hardly depends on their order; ones that are equal but for rounding as they come.
inline void sort_by_length(std::vector<Sampled_line>& lines) {
  std::vector<double> lengths;
  for (const Sampled_line& line : lines)
    lengths.push_back(length(line));
  const double step = 1e-9 * *std::max_element(lengths.begin(), lengths.end());
  for (double& l : lengths)
    l = std::round(l / step);
  std::vector<std::size_t> order(lines.size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return lengths[a] > lengths[b]; });
  std::vector<Sampled_line> sorted;
  for (std::size_t i : order)
    sorted.push_back(std::move(lines[i]));
  lines.swap(sorted);
}

inline Centerline_graph graph_of(const std::vector<Line_point>& vertices, std::vector<Vertex_path> branches) {
  const std::size_t unused = std::size_t(-1);
  std::vector<std::size_t> renumbered(vertices.size(), unused);
  std::vector<Point_3> points;
  std::vector<double> radii;
  for (Vertex_path& b : branches)
    for (std::size_t& v : b) {
      if (renumbered[v] == unused) {
        renumbered[v] = points.size();
        points.push_back(Point_3(vertices[v].point.x(), vertices[v].point.y(), vertices[v].point.z()));
        radii.push_back(vertices[v].radius);
      }
      v = renumbered[v];
    }
  return Centerline_graph(std::move(points), std::move(radii), std::move(branches));
}

// radius: one a point of the polylines
inline Centerline_graph merged_graph(const Centerline_polylines& polylines,
                                     const std::vector<Double_kernel::Point_3>& points,
                                     const std::vector<double>& radius, Radius_at_new_point refined_radius,
                                     double tolerance) {
  if (!(tolerance > 0 && tolerance <= 0.5))
    throw Parameter_error("merge_tolerance is " + std::to_string(tolerance) +
                          "; it is a fraction of the local radius, more than 0 and at most 0.5.");
  const double least = least_radius(radius);
  const auto floored_radius = [&](const Double_kernel::Point_3& p, double r) {
    return (std::max)(least, refined_radius(p, r));
  };

  std::vector<Sampled_line> lines;
  for (const Index_line& chain : Line_chainer(points, polylines.lines, coincidence(points)).chains()) {
    Sampled_line line;
    for (std::size_t p : chain)
      line.push_back(Line_point{points[p], (std::max)(least, radius[p])});
    line = without_zigzags(without_short_steps(line));
    if (line.size() > 1)
      lines.push_back(with_short_steps(line, floored_radius));
  }
  if (lines.empty())
    throw Input_error("The centerlines have no length: all the points of each line coincide.");
  sort_by_length(lines);

  Line_merger merger(tolerance);
  for (const Sampled_line& line : lines)
    merger.insert(line);
  const std::vector<Line_point>& vertices = merger.vertices();
  Branch_tracer tracer(vertices.size(), without_spurs(merger.edges(), vertices, Line_merger::out_of_vessel));
  Centerline_graph graph = graph_of(vertices, without_short_inner_branches(tracer.branches(), vertices, tolerance));
  graph.direct_from(choose_root(graph, lines));
  return graph;
}

CGAL_TUBULAR_MESHING_INLINE void build_centerline_graph(const Centerline_polylines& polylines, Length_function radius,
                                                        Centerline_graph& graph,
                                                        const Build_centerline_graph_options& options) {
  const std::vector<Double_kernel::Point_3> points = checked_points(polylines);
  const auto measured = [&](const Double_kernel::Point_3& p, double) { return radius(to_core(p)); };
  const std::vector<double> radii = values_at(points, radius);
  graph = merged_graph(polylines, points, radii, measured, options.merge_tolerance);
  std::vector<double> exact;
  for (const Point_3& p : graph.points())
    exact.push_back(radius(p));
  graph.set_radii(std::move(exact));
}

CGAL_TUBULAR_MESHING_INLINE void build_centerline_graph(const Centerline_polylines& polylines, Centerline_graph& graph,
                                                        const Build_centerline_graph_options& options) {
  const std::vector<Double_kernel::Point_3> points = checked_points(polylines);
  if (polylines.radius.size() != points.size())
    throw Input_error("The centerlines carry no radii (the array MaximumInscribedSphereRadius); give the surface that "
                      "they belong to, so that radii can be measured.");
  for (std::size_t i = 0; i < points.size(); ++i)
    if (!std::isfinite(polylines.radius[i]) || polylines.radius[i] < 0)
      throw Input_error("The radius at point " + std::to_string(i) + " of the centerlines is " +
                        std::to_string(polylines.radius[i]) + "; it must be a number that is not negative.");
  const auto interpolated = [](const Double_kernel::Point_3&, double r) { return r; };
  graph = merged_graph(polylines, points, polylines.radius, interpolated, options.merge_tolerance);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_BUILD_CENTERLINE_GRAPH_IMPL_H
