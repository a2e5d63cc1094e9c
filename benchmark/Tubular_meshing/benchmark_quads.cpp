// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Triangles to quads: the argument is the number of squares on a side of a grid with random diagonals and vertices.

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Tubular_meshing/Quads/recombine_triangles.h>

#include <benchmark/benchmark.h>

#include <array>
#include <cstddef>
#include <random>
#include <vector>

namespace {

typedef CGAL::Simple_cartesian<double>::Point_3 Point;

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

} // namespace
