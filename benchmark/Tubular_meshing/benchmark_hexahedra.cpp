// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// The optimizer of hexahedra, on grids of n x n x n in a box and on O-grids in a cylinder. Counters: hexahedra a second,
// their least and mean scaled Jacobian afterwards, those still inverted, and the peak of memory for each, the mesh
// included.

#include <CGAL/Tubular_meshing/Hexahedra/optimize_hexahedra.h>

#include "../../test/Tubular_meshing/hexahedral_shapes.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <array>
#include <cstddef>

namespace {

using namespace hexahedral_shapes;

double peak_of_memory() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return 1024. * double(usage.ru_maxrss);
}

void run(benchmark::State& state, const Mesh& start, const tubular::Labelled_surface& surface, double quality) {
  tubular::Optimize_hexahedra_report report;
  const double before = peak_of_memory();
  for (auto _ : state) {
    state.PauseTiming();
    Mesh mesh = start;
    state.ResumeTiming();
    report = tubular::optimize_hexahedra(
        mesh, surface, tubular::parameters::quality_wanted(quality).number_of_threads(int(state.range(1))));
  }
  const double n = double(start.hexahedra.size());
  state.counters["hexahedra"] = n;
  state.counters["per_second"] = benchmark::Counter(n, benchmark::Counter::kIsIterationInvariantRate);
  state.counters["least"] = report.min_scaled_jacobian;
  state.counters["mean"] = report.mean_scaled_jacobian;
  state.counters["inverted"] = double(report.inverted);
  state.counters["sweeps"] = double(report.sweeps);
  // no more than this: earlier runs may have had a higher peak
  state.counters["bytes_each"] = (peak_of_memory() - before) / n;
}

std::array<double, 3> lengths_of(int n) {
  return {double(n), double(n), double(n)};
}

// One vertex of each 1,000 is thrown away from its place.
void few_places(benchmark::State& state) {
  const int n = int(state.range(0));
  Mesh mesh = box_grid({n, n, n}, lengths_of(n));
  for (std::size_t v = 500; v < mesh.points.size(); v += 997) {
    const Point& p = mesh.points[v];
    if (p.x() > 0 && p.x() < n - 2 && p.y() > 0 && p.y() < n && p.z() > 0 && p.z() < n)
      mesh.points[v] = Point(p.x() + 1.5, p.y(), p.z());
  }
  run(state, mesh, box_surface(lengths_of(n)), 0.5);
}

// All vertices are, and all hexahedra are worked on.
void everywhere(benchmark::State& state) {
  const int n = int(state.range(0));
  Mesh mesh = box_grid({n, n, n}, lengths_of(n));
  shake_box(mesh, 0.5, lengths_of(n));
  run(state, mesh, box_surface(lengths_of(n)), 0.9);
}

// The same in a cylinder, with a twelfth of the vertices on its wall.
void cylinder(benchmark::State& state) {
  const int s = int(state.range(0));
  const double length = 4;
  Mesh mesh = o_grid(s, s, 5 * s, length);
  shake(mesh, 0.3 / s, [](std::size_t, const Point& p) { return p; });
  run(state, mesh, cylinder_surface(32 * s, 20 * s, length), 0.9);
}

void sizes(benchmark::internal::Benchmark* b) {
  for (int n : {22, 46, 100})
    for (int threads : {1, 0})
      b->Args({n, threads});
  b->ArgNames({"n", "threads"})->Unit(benchmark::kMillisecond)->UseRealTime();
}
BENCHMARK(few_places)->Apply(sizes);
BENCHMARK(everywhere)->Apply(sizes);
BENCHMARK(cylinder)
    ->ArgsProduct({{5, 12}, {1, 0}})
    ->ArgNames({"s", "threads"})
    ->Unit(benchmark::kMillisecond)
    ->UseRealTime();

} // namespace
