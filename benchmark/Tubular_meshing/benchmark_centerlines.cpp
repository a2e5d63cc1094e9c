// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time and memory of compute_centerlines(), without input and output: on generated trees of 10^3 to 10^6 triangles,
// which is to grow as n log n, and on the surfaces named on the command line (with --loops before them: all branches;
// with --threads N: by so many, not all there are).
// Peak memory is the process': to have that of one surface, run it alone, with --benchmark_filter.

#include <CGAL/Tubular_meshing/Centerlines/compute_centerlines.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Openings/close_openings.h>
#include <CGAL/Tubular_meshing/Openings/openings.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <exception>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef CGAL::Tubular_meshing::Centerline_graph Graph;
namespace tubular = CGAL::Tubular_meshing;

double peak_megabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

int threads = 0;

void measure(benchmark::State& state, Surface& surface, bool loops) {
  std::vector<tubular::Opening> openings = tubular::find_openings(surface);
  const auto patch = surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first;
  tubular::close_openings(surface, openings, patch);
  std::size_t branches = 0;
  for (auto _ : state) {
    Graph graph;
    tubular::compute_centerlines(surface, patch, openings, graph,
                                 tubular::parameters::loops(loops).number_of_threads(threads));
    branches = graph.branches().size();
  }
  state.counters["triangles"] = double(surface.number_of_faces());
  state.counters["openings"] = double(openings.size());
  state.counters["branches"] = double(branches);
  state.counters["peak_MB"] = peak_megabytes();
  state.SetComplexityN(int64_t(surface.number_of_faces()));
}

// A tree of so many branches, with so many points round each.
void tree(benchmark::State& state) {
  Surface surface;
  tubular::generate_tubular_surface(tubular::bronchial_tree(std::size_t(state.range(0))), surface,
                                    tubular::parameters::points_per_circumference(double(state.range(1))));
  measure(state, surface, false);
}

void file(benchmark::State& state, const std::string& name, bool loops) {
  try {
    Surface surface;
    tubular::IO::read_surface(name, surface);
    measure(state, surface, loops);
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
  }
}

BENCHMARK(tree)
    ->Args({3, 12})
    ->Args({31, 16})
    ->Args({305, 12})
    ->Args({305, 40})
    ->Args({3001, 12})
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);

} // namespace

int main(int argc, char* argv[]) {
  benchmark::Initialize(&argc, argv); // takes its own options out
  bool loops = false;
  for (int i = 1; i < argc; ++i)
    if (std::string(argv[i]) == "--loops")
      loops = true;
    else if (std::string(argv[i]) == "--threads" && i + 1 < argc)
      threads = std::stoi(argv[++i]);
    else
      benchmark::RegisterBenchmark(argv[i], file, std::string(argv[i]), loops)->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
