// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "quality.h"

#include <CGAL/Tubular_meshing/Patches/metric_surface_report.h>
#include <CGAL/Tubular_meshing/Quadratic/quadratic_quality.h>
#include <CGAL/Tubular_meshing/Quality/boundary_layer_report.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

Json statistics(const tubular::Measure_statistics& s) {
  return {{"count", s.count()},    {"min", s.min()},        {"mean", s.mean()},        {"max", s.max()},
          {"p1", s.percentile(1)}, {"p5", s.percentile(5)}, {"p50", s.percentile(50)}, {"histogram", s.histogram()}};
}

// Of a measure that is large where it is bad, and has no bound; a cell that is flat has none at all.
Json statistics_of_excess(const tubular::Measure_statistics& s) {
  const auto number = [](double x) { return std::isfinite(x) ? Json(x) : Json(); };
  return {{"count", s.count()},
          {"min", number(s.min())},
          {"mean", number(s.mean())},
          {"max", number(s.max())},
          {"p50", number(s.percentile(50))},
          {"p95", number(s.percentile(95))},
          {"p99", number(s.percentile(99))}};
}

// The measures of quality in the order of the table, with what they are called there.
const std::vector<std::pair<const char*, const char*>>& measures() {
  static const std::vector<std::pair<const char*, const char*>> list = {{"gamma_tau", "tetrahedra, gamma_tau"},
                                                                        {"scaled_jacobian", "hexahedra, Jacobian"},
                                                                        {"zeta_H", "hexahedra, zeta_H"},
                                                                        {"gamma_T", "triangles, gamma_T"},
                                                                        {"eta_q", "quads, eta_q"}};
  return list;
}

bool is_lumen_alone(const tubular::Mixed_mesh& mesh) {
  return std::all_of(mesh.tetrahedra.label.begin(), mesh.tetrahedra.label.end(),
                     [](int region) { return region == tubular::labels::lumen; });
}

void add_fit_to_metric(Json& json, const tubular::Quality_report& quality) {
  json["Q_tau"] = statistics(quality.Q_tau);
  json["Q_tau"]["share_below_3"] = quality.Q_tau.share_below(3);
  json["efficiency"] = quality.efficiency;
}

void print_table(const Json& quality) {
  std::printf("%-22s %8s %8s %8s\n", "quality", "min", "1 %", "mean");
  for (const auto& m : measures()) {
    if (!quality.contains(m.first) || quality[m.first]["count"] == 0)
      continue;
    const auto& s = quality[m.first];
    std::printf("%-22s %8.3f %8.3f %8.3f\n", m.second, s["min"].get<double>(), s["p1"].get<double>(),
                s["mean"].get<double>());
  }
}

void print_quadratic(const Json& q) {
  std::printf("\n%-22s %8s %8s %8s\n", "whole cells, Jacobian", "min", "1 %", "mean");
  for (const auto& kind : q["scaled_jacobian"].items())
    if (kind.key() != "cells")
      std::printf("%-22s %8.3g %8.3f %8.3f\n", kind.key().c_str(), kind.value()["min"].get<double>(),
                  kind.value()["p1"].get<double>(), kind.value()["mean"].get<double>());
  std::printf("order 2: %s\n", q["sentence"].get<std::string>().c_str());
}

// Those of finite volumes.
void print_excesses(const Json& q) {
  const std::pair<const char*, const char*> list[] = {
      {"aspect", "cells, aspect"}, {"non_orthogonality", "faces, non-orthogonal"}, {"skewness", "faces, skewness"}};
  if (!q.contains("aspect"))
    return;
  const auto text = [](const Json& x) {
    char buffer[32];
    std::snprintf(buffer, sizeof buffer, "%8.3f", x.is_null() ? HUGE_VAL : x.get<double>());
    return std::string(buffer);
  };
  std::printf("\n%-22s %8s %8s %8s\n", "finite volumes", "max", "99 %", "mean");
  for (const auto& m : list)
    std::printf("%-22s %s %s %s\n", m.second, text(q[m.first]["max"]).c_str(), text(q[m.first]["p99"]).c_str(),
                text(q[m.first]["mean"]).c_str());
}

void print_metric_quality(const Json& q) {
  std::printf("in the metric: Q %.2f on average, at most %.2f; efficiency %.3f\n", q["Q_tau"]["mean"].get<double>(),
              q["Q_tau"]["max"].get<double>(), q["efficiency"].get<double>());
  std::printf("first layer: %.2f of the height asked for on average, within 30 %% of it at %.1f %% of the wall\n",
              q["first_height"]["mean"].get<double>(),
              100 * q["first_height"]["share_within_30_percent"].get<double>());
  if (q["alignment"]["count"] > 0)
    std::printf("long edges: %.1f %% within 15 degrees of the centerline's direction\n",
                100 * q["alignment"]["share_below_15_degrees"].get<double>());
}

void print_surface_in_its_metric(const Json& q) {
  for (const char* part : {"wall", "caps"})
    if (q[part]["shape"]["count"] > 0)
      std::printf("in the metric, %s: shape %.3f at least, %.3f on average; %.1f %% of the edges of unit length\n",
                  part, q[part]["shape"]["min"].get<double>(), q[part]["shape"]["mean"].get<double>(),
                  100 * q[part]["share_of_unit_edges"].get<double>());
}

void print_histogram(const Json& measure, const char* name) {
  const auto& bins = measure["histogram"];
  const double most = *std::max_element(bins.begin(), bins.end());
  std::printf("\n%s\n", name);
  for (std::size_t i = 0; i < bins.size(); ++i)
    std::printf("  %4.2f %9ld %s\n", double(i) / double(bins.size()), bins[i].get<long>(),
                std::string(std::size_t(50 * bins[i].get<double>() / (std::max)(most, 1.)), '#').c_str());
}

} // namespace

// Of the measures of elements that are not always there, those of elements that are.
Json qualities_of(const tubular::Quality_report& quality) {
  Json q = {{"gamma_tau", statistics(quality.gamma_tau)}, {"gamma_T", statistics(quality.gamma_T)}};
  const auto add = [&](const char* name, const tubular::Measure_statistics& s) {
    if (s.count() > 0)
      q[name] = statistics(s);
  };
  add("eta_q", quality.eta_q);
  add("zeta_H", quality.zeta_H);
  add("scaled_jacobian", quality.scaled_jacobian);
  if (quality.aspect.count() > 0) {
    q["aspect"] = statistics_of_excess(quality.aspect);
    q["non_orthogonality"] = statistics_of_excess(quality.non_orthogonality);
    q["skewness"] = statistics_of_excess(quality.skewness);
  }
  return q;
}

// Of a mesh in a metric, with layers at the wall.
void add_metric_quality(Json& report, const tubular::Tubular_model& model, const tubular::Mixed_mesh& mesh,
                        const tubular::Quality_report& of_all, int threads) {
  const auto on_threads = tubular::parameters::number_of_threads(threads);
  if (is_lumen_alone(mesh))
    add_fit_to_metric(report["quality"], of_all);
  else
    add_fit_to_metric(report["quality"], tubular::quality_report(mesh, tubular::labels::lumen, on_threads));
  const tubular::Boundary_layer_report layer = tubular::boundary_layer_report(mesh, model.centerlines, on_threads);
  report["quality"]["first_height"] = statistics(layer.first_height);
  report["quality"]["first_height"]["share_within_30_percent"] = layer.share_of_first_heights(0.3);
  report["quality"]["alignment"] = statistics(layer.alignment);
  report["quality"]["alignment"]["share_below_15_degrees"] = layer.alignment.share_below(15);
}

// Of the triangles of a surface in a metric.
void add_metric_quality(Json& report, const tubular::Remeshed_surface& surface) {
  const tubular::Metric_surface_report fit = tubular::metric_surface_report(surface);
  const auto json = [](const tubular::Metric_fit& f) {
    return Json({{"shape", statistics(f.shape)},
                 {"edge_length", statistics(f.edge_length)},
                 {"share_of_unit_edges", f.share_of_unit_edges()},
                 {"wanted_triangles", f.wanted_triangles}});
  };
  report["quality"]["in_the_metric"] = {{"wall", json(fit.wall)}, {"caps", json(fit.caps)}};
}

// Of elements of the second order.
void add_quadratic(Json& report, const Run& run) {
  const tubular::Quadratic_quality_report quality = tubular::quality_report(run.quadratic, run.options.threads);
  const tubular::Quadratic_report& r = run.curving;
  Json q = {{"complete", run.options.complete_elements},
            {"corners", run.quadratic.linear.points.size()},
            {"curved_edges", r.curved_edges},
            {"largest_bend", r.largest_bend},
            {"largest_shift", r.largest_shift},
            {"relaxed", r.relaxed},
            {"straightened", r.straightened},
            {"corners_held_back", r.corners_held_back},
            {"nodes_not_found", r.not_found},
            {"invalid", quality.invalid},
            {"unproved", quality.unproved},
            {"sentence", r.text()}};
  const auto add = [&](const char* name, const tubular::Measure_statistics& s) {
    if (s.count() > 0)
      q["scaled_jacobian"][name] = statistics(s);
  };
  add("cells", quality.scaled_jacobian);
  add("tetrahedra", quality.tetrahedra);
  add("pyramids", quality.pyramids);
  add("prisms", quality.prisms);
  add("hexahedra", quality.hexahedra);
  report["quadratic"] = q;
  report["valid"] = report["valid"].get<bool>() && quality.is_valid();
}

void print_qualities(const Json& r) {
  const Json& quality = r["quality"];
  print_table(quality);
  if (r.contains("quadratic"))
    print_quadratic(r["quadratic"]);
  print_excesses(quality);
  if (quality.contains("Q_tau"))
    print_metric_quality(quality);
  if (quality.contains("in_the_metric"))
    print_surface_in_its_metric(quality["in_the_metric"]);
}

void print_histograms(const Json& quality) {
  for (const auto& m : measures())
    if (quality.contains(m.first))
      print_histogram(quality[m.first], m.second);
}
