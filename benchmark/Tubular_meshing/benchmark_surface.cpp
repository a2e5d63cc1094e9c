// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time and memory of cutting, parameterization and remeshing, one after another, on generated trees and on the surfaces
// named on the command line (with --loops before them: all branches; --threads T: so many threads). Cutting is to grow
// with the cuts and the surface's n log n, the others as n log n in triangles, since patches do not grow with the tree.
// Peak memory is the process': to have that of one surface, run it alone, with --benchmark_filter.

#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/Patches/cut_by_centerlines.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Patches/parameterize_patch.h>
#include <CGAL/Tubular_meshing/Patches/remesh_patches.h>
#include <CGAL/Tubular_meshing/Pipelines/Tubular_model.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <exception>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
namespace tubular = CGAL::Tubular_meshing;
typedef tubular::Tubular_model Model;

int threads = 1;

double peak_megabytes() {
  rusage usage;
  getrusage(RUSAGE_SELF, &usage);
  return double(usage.ru_maxrss) / 1024;
}

class Stopwatch {
public:
  double lap() {
    const auto now = std::chrono::steady_clock::now();
    const double seconds = std::chrono::duration<double>(now - last_).count();
    last_ = now;
    return seconds;
  }

private:
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

// A copy of its own for each iteration, since cuts divide the surface.
struct Copy {
  Surface surface;
  tubular::Face_patch_map patch;

  explicit Copy(const Model& model)
      : surface(model.surface)
      , patch(surface.add_property_map<Surface::Face_index, int>("f:patch", 0).first) {}
};

void measure(benchmark::State& state, const Model& model, double points) {
  const auto np = tubular::parameters::number_of_threads(threads);
  const tubular::Centerline_sizing_field size(tubular::Centerline_field(model.centerlines),
                                              tubular::Wall_distance(model.surface, model.patch, tubular::labels::wall),
                                              tubular::parameters::points_per_circumference(points));
  double cutting = 0, mapping = 0, meshing = 0;
  std::size_t patches = 0, triangles = 0;
  for (auto _ : state) {
    state.PauseTiming();
    Copy copy(model);
    state.ResumeTiming();
    Stopwatch clock;
    const auto cut = tubular::cut_by_centerlines(copy.surface, model.centerlines, copy.patch);
    cutting += clock.lap();
    const auto maps = tubular::parameterize_patches(copy.surface, cut, np);
    mapping += clock.lap();
    const auto remeshed = tubular::remesh_patches(copy.surface, cut, maps, size, np);
    meshing += clock.lap();
    patches = cut.patches.size();
    triangles = remeshed.surface.number_of_faces();
  }
  const double n = double(state.iterations());
  state.counters["old"] = double(model.surface.number_of_faces());
  state.counters["new"] = double(triangles);
  state.counters["patches"] = double(patches);
  state.counters["cut_s"] = cutting / n;
  state.counters["map_s"] = mapping / n;
  state.counters["mesh_s"] = meshing / n;
  state.counters["peak_MB"] = peak_megabytes();
  state.SetComplexityN(int64_t(model.surface.number_of_faces() + triangles));
}

// A tree of so many branches.
void tree(benchmark::State& state) {
  const auto skeleton = tubular::bronchial_tree(std::size_t(state.range(0)));
  Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, tubular::parameters::points_per_circumference(16));
  measure(state, tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton)), 12);
}

void file(benchmark::State& state, const std::string& name, bool loops) {
  try {
    Surface surface;
    tubular::IO::read_surface(name, surface);
    tubular::repair_surface(surface);
    measure(state, tubular::make_tubular_model(surface, tubular::parameters::loops(loops)), 12);
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
  }
}

BENCHMARK(tree)->Arg(3)->Arg(31)->Arg(101)->Arg(305)->Unit(benchmark::kMillisecond)->Complexity(benchmark::oNLogN);

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
