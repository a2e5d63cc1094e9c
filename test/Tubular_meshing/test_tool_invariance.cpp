// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The command-line tool makes the same of a model elsewhere, turned, or in other units.

#include "test_tool_helpers.h"
#include "test_tool_report.h"

#include <CGAL/Tubular_meshing/IO/read_centerlines.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>

#ifdef TUBULAR_MESH_TOOL

namespace {

using namespace tool_test;

class Invariance : public Tool {
protected:
  Json report_of(const Sample& s) {
    succeed(Arguments{make("s.off", s.surface), "-c", make("c.vtk", s.lines), "-o", out("m.vtu"), "--report",
                      out("r.json")} +
            mesher);
    const Json report = json_in(out("r.json"));
    expect_report_of(report, mesh_in(out("m.vtu")));
    mesher.empty() ? expect_by_patches(report) : expect_by_mesh_3(report);
    return report;
  }

  Arguments mesher; // none: the default

  // Of a small model, rims make up much of the surface, and they count a few points more or less.
  double triangles_share = 0.03;

  void expect_the_same(const Json& report, const Json& original, double scale) {
    const auto near = [](const Json& a, const Json& b, double share) {
      EXPECT_NEAR(a.get<double>(), b.get<double>(), share * b.get<double>());
    };
    near(report["points"], original["points"], 0.02);
    near(report["cells"]["tetrahedra"], original["cells"]["tetrahedra"], 0.02);
    near(report["facets"]["triangles"], original["facets"]["triangles"], triangles_share);
    near(report["quality"]["gamma_tau"]["mean"], original["quality"]["gamma_tau"]["mean"], 0.01);
    near(report["quality"]["gamma_T"]["mean"], original["quality"]["gamma_T"]["mean"], 0.01);
    EXPECT_EQ(report["boundary_euler"], original["boundary_euler"]);
    ASSERT_EQ(report["openings"].size(), original["openings"].size());
    for (std::size_t i = 0; i < report["openings"].size(); ++i) // in the same order
      EXPECT_NEAR(report["openings"][i]["radius"].get<double>(),
                  scale * original["openings"][i]["radius"].get<double>(),
                  1e-4 * report["openings"][i]["radius"].get<double>());
    ASSERT_EQ(report["branches"].size(), original["branches"].size());
  }

  void expect_invariance(const Sample& s) {
    const Json original = report_of(s);
    for (double scale : {1000., 1e6, 1e-3}) {
      SCOPED_TRACE("scaled by " + std::to_string(scale));
      expect_the_same(
          report_of(transformed(s, [&](const Point& p) { return CGAL::ORIGIN + scale * (p - CGAL::ORIGIN); })),
          original, scale);
    }
    CGAL::Bbox_3 box;
    for (auto v : s.surface.vertices())
      box += s.surface.point(v).bbox();
    const Kernel::Vector_3 across(box.xmax() - box.xmin(), box.ymax() - box.ymin(), box.zmax() - box.zmin());
    {
      SCOPED_TRACE("moved by a hundred diagonals");
      expect_the_same(report_of(transformed(s, [&](const Point& p) { return p + 100 * across; })), original, 1);
    }
    for (const double angle : {0.4, 2.}) {
      SCOPED_TRACE("rotated by " + std::to_string(angle));
      const double c = std::cos(angle), i = std::sin(angle);
      expect_the_same(report_of(transformed(s,
                                            [&](const Point& p) { // about x, then about z
                                              const double y = c * p.y() - i * p.z(), z = i * p.y() + c * p.z();
                                              return Point(c * p.x() - i * y, i * p.x() + c * y, z);
                                            })),
                      original, 1);
    }
  }
};

TEST_F(Invariance, Of_a_bifurcation) {
  expect_invariance(bifurcation());
}

TEST_F(Invariance, Of_a_bifurcation_by_Mesh_3) {
  mesher = by_mesh_3 + reproducibly;
  expect_invariance(bifurcation());
}

// --- the same of a real vessel ---

const std::string aorta = "paper/aorta.stl", aorta_centerlines = "paper/centerlinesAORTA.vtk";

Sample aorta_sample() {
  Sample s;
  tubular::IO::read_surface(shared_file(aorta), s.surface);
  tubular::IO::read_centerlines(shared_file(aorta_centerlines), s.lines);
  return s;
}

#define NEEDS_AORTA()                                                                                                  \
  NEEDS(shared_file(aorta), fs::exists(shared_file(aorta)) && fs::exists(shared_file(aorta_centerlines)))

TEST_F(Invariance, Of_the_aorta) {
  NEEDS_AORTA();
  triangles_share = 0.02;
  expect_invariance(aorta_sample());
}

TEST_F(Invariance, Of_the_aorta_by_Mesh_3) {
  NEEDS_AORTA();
  mesher = by_mesh_3 + reproducibly;
  triangles_share = 0.02;
  expect_invariance(aorta_sample());
}

} // namespace

#endif // TUBULAR_MESH_TOOL
