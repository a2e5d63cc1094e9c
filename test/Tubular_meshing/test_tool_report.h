// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_REPORT_H
#define TUBULAR_MESHING_TEST_TOOL_REPORT_H

// What the tool's report has to say of the mesh that it made.

#include "test_tool_helpers.h"

#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Quality/validity_report.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <set>

namespace tool_test {

inline void expect_statistics(const Json& told, const tubular::Measure_statistics& measured) {
  EXPECT_EQ(told["count"], measured.count());
  EXPECT_NEAR(told["min"].get<double>(), measured.min(), 1e-9);
  EXPECT_NEAR(told["mean"].get<double>(), measured.mean(), 1e-9);
  EXPECT_NEAR(told["p1"].get<double>(), measured.percentile(1), 1e-9);
  EXPECT_EQ(told["histogram"], Json(measured.histogram()));
}

// Of a measure that is large where it is bad.
inline void expect_excess(const Json& told, const tubular::Measure_statistics& measured) {
  EXPECT_EQ(told["count"], measured.count());
  EXPECT_NEAR(told["max"].get<double>(), measured.max(), 1e-6 * measured.max());
  EXPECT_NEAR(told["p99"].get<double>(), measured.percentile(99), 1e-6 * measured.max());
  EXPECT_NEAR(told["mean"].get<double>(), measured.mean(), 1e-6 * measured.max());
}

inline double diagonal_of(const Mesh& mesh) {
  CGAL::Bbox_3 b;
  for (const Point& p : mesh.points)
    b += p.bbox();
  return std::hypot(b.xmax() - b.xmin(), b.ymax() - b.ymin(), b.zmax() - b.zmin());
}

// The cap of an opening in the mesh, and what the report says of it.
inline void expect_opening(const Json& told, const Mesh& mesh) {
  const int patch = told["patch"];
  EXPECT_EQ(told["name"], mesh.patch_names.at(patch));
  const auto vector = [&](const char* key) {
    return Kernel::Vector_3(told[key][0].get<double>(), told[key][1].get<double>(), told[key][2].get<double>());
  };
  const Kernel::Vector_3 center = vector("center"), normal = vector("normal");
  Kernel::Vector_3 area = CGAL::NULL_VECTOR;
  std::size_t triangles = 0;
  double off_plane = 0;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    if (mesh.triangles.label[i] == patch) {
      const auto& v = mesh.triangles.vertices[i];
      const Point &p = mesh.points[v[0]], &q = mesh.points[v[1]], &r = mesh.points[v[2]];
      area = area + CGAL::cross_product(q - p, r - p) / 2;
      off_plane = (std::max)(off_plane, std::abs((p - CGAL::ORIGIN - center) * normal));
      ++triangles;
    }
  EXPECT_EQ(told["triangles"], triangles);
  EXPECT_GE(triangles, 8u);
  EXPECT_LE(off_plane, 1e-9 * diagonal_of(mesh));
  // The caps' rims are polygons of at least ten sides.
  EXPECT_NEAR(area * normal, told["area"].get<double>(), 0.08 * told["area"].get<double>()) << told["name"];
}

inline void expect_report_of(const Json& report, const Mesh& mesh) {
  const tubular::Validity_report validity = tubular::validity_report(mesh);
  EXPECT_TRUE(validity.is_valid()) << validity.defects();
  EXPECT_EQ(report["valid"], true);
  EXPECT_EQ(report["boundary_euler"], validity.boundary_euler);
  EXPECT_EQ(report["points"], mesh.points.size());
  EXPECT_EQ(report["cells"]["tetrahedra"], mesh.number_of_cells());
  EXPECT_EQ(report["facets"]["triangles"], mesh.number_of_facets());
  const tubular::Quality_report quality = tubular::quality_report(mesh);
  expect_statistics(report["quality"]["gamma_tau"], quality.gamma_tau);
  expect_statistics(report["quality"]["gamma_T"], quality.gamma_T);
  EXPECT_FALSE(report["quality"].contains("scaled_jacobian")); // there are no hexahedra
  expect_excess(report["quality"]["aspect"], quality.aspect);
  expect_excess(report["quality"]["non_orthogonality"], quality.non_orthogonality);
  expect_excess(report["quality"]["skewness"], quality.skewness);
  EXPECT_EQ(report["openings"].size() + 1, mesh.patch_names.size()); // and the wall
  EXPECT_EQ(report["openings"][0]["name"], "inlet");
  for (const Json& opening : report["openings"])
    expect_opening(opening, mesh);
  EXPECT_EQ(std::set<int>(mesh.tetrahedra.label.begin(), mesh.tetrahedra.label.end()), std::set<int>{1});
}

// Of an isotropic mesh by the default: by patches, whose triangles are kept, and good.
inline void expect_by_patches(const Json& report) {
  EXPECT_EQ(report["fallbacks"], Json::array());
  if (tubular::default_volume_mesher() == tubular::Volume_mesher::mesh_3)
    return; // which made the surface as well
  ASSERT_TRUE(report.contains("patches"));
  EXPECT_GE(report["quality"]["gamma_tau"]["min"].get<double>(), 0.25);
  EXPECT_GE(report["quality"]["gamma_T"]["min"].get<double>(), 0.5);
}

inline void expect_by_mesh_3(const Json& report) {
  EXPECT_EQ(report["fallbacks"], Json::array()) << "it was asked for";
  EXPECT_FALSE(report.contains("patches"));
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_REPORT_H
