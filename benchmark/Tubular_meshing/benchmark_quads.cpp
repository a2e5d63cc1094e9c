// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles to quads: the argument is the number of squares on a side of a grid with random diagonals and vertices.
// Walls of quads: the argument is the number of branches of a generated tree, cut and mapped beforehand.

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Quads/quadrangulate_patches.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace {

typedef CGAL::Tubular_meshing::Point_3 Point;

struct Triangles {
  std::vector<Point> points;
  std::vector<std::array<std::size_t, 3>> triangles;
};

Triangles random_grid(std::size_t n) {
  Triangles mesh;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> shift(-0.35, 0.35);
  for (std::size_t j = 0; j <= n; ++j)
    for (std::size_t i = 0; i <= n; ++i)
      mesh.points.emplace_back(double(i) + shift(random), double(j) + shift(random), 0);
  for (std::size_t j = 0; j < n; ++j)
    for (std::size_t i = 0; i < n; ++i) {
      const std::size_t a = j * (n + 1) + i, b = a + 1, c = b + n + 1, d = a + n + 1;
      const bool other = random() % 2 == 0;
      mesh.triangles.push_back({{a, b, other ? d : c}});
      mesh.triangles.push_back({{other ? b : a, c, d}});
    }
  return mesh;
}

void recombine(benchmark::State& state, bool odd) {
  Triangles mesh = random_grid(std::size_t(state.range(0)));
  if (odd)
    mesh.triangles.erase(mesh.triangles.begin() + std::ptrdiff_t(mesh.triangles.size() / 3));
  CGAL::Tubular_meshing::Recombination_report report;
  for (auto _ : state)
    report = CGAL::Tubular_meshing::recombine_triangles(mesh.points, mesh.triangles).report;
  state.counters["triangles"] = double(mesh.triangles.size());
  state.counters["left"] = double(report.triangles);
  state.counters["split"] = double(report.split_vertices);
  state.counters["invalid"] = double(report.invalid_quads);
}
BENCHMARK_CAPTURE(recombine, even, false)->Arg(71)->Arg(224)->Arg(708)->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(recombine, odd, true)->Arg(71)->Arg(224)->Unit(benchmark::kMillisecond);

void quadrangulate(benchmark::State& state) {
  typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point_3;
  namespace tubular = CGAL::Tubular_meshing;
  const auto skeleton = tubular::bronchial_tree(std::size_t(state.range(0)));
  CGAL::Surface_mesh<Point_3> surface;
  tubular::generate_tubular_surface(skeleton, surface, tubular::parameters::points_per_circumference(16));
  auto model = tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton));
  const tubular::Centerline_sizing_field size(tubular::Centerline_field(model.centerlines),
                                              tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall),
                                              tubular::parameters::points_per_circumference(16));
  const auto cut = tubular::cut_by_centerlines(model.surface, model.centerlines, model.patch);
  const auto maps = tubular::parameterize_patches(model.surface, cut);
  tubular::Quad_report quads;
  for (auto _ : state)
    quads =
        tubular::quadrangulate_patches(model.surface, cut, maps, size, tubular::parameters::number_of_threads(1)).quads;
  state.counters["quads"] = double(quads.wall_quads());
  state.counters["irregular"] = double(quads.irregular_vertices);
  state.counters["least_eta"] = quads.least_eta;
  state.counters["mean_eta"] = quads.mean_eta;
}
BENCHMARK(quadrangulate)->Arg(11)->Arg(101)->Arg(1001)->Unit(benchmark::kMillisecond);

} // namespace
