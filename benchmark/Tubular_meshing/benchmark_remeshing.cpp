// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Remeshing of a cube to an anisotropic metric that turns from place to place, from ten thousand to two million
// tetrahedra; remeshing of a generated tree, and of the surfaces named on the command line, from isotropic tetrahedra to
// the anisotropic ones that tubular_mesh makes; and the same jobs through mmg3d_O3, where it is on the PATH. Counters:
// tetrahedra in the result and a second, their mean and largest Q, the efficiency index, and the peak of memory so far,
// of the program or of mmg3d_O3.

#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Generators/bronchial_tree.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/read_surface.h>
#include <CGAL/Tubular_meshing/IO/write_mesh.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/Quality/quality_report.h>
#include <CGAL/Tubular_meshing/Repair/repair_surface.h>
#include <CGAL/Tubular_meshing/Volume/anisotropic_tetrahedral_remeshing.h>
#include <CGAL/Tubular_meshing/base/Mixed_mesh.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include "../../test/Tubular_meshing/grid_of_tetrahedra.h"

#include <benchmark/benchmark.h>

#include <sys/resource.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef CGAL::Tubular_meshing::Mixed_mesh Mesh;
typedef CGAL::Tubular_meshing::Metric_tensor_3 Metric;
namespace tubular = CGAL::Tubular_meshing;
using tubular::internal::Vector_3d;

// The unit cube; the sides are labelled 1 to 6.
Mesh make_cube(int n) {
  return grid_of_tetrahedra(
      {n, n, n}, [n](int i, int j, int k) { return Point(double(i) / n, double(j) / n, double(k) / n); },
      [](int axis, int end) { return 1 + 2 * axis + end; });
}

// Sizes h, 8 h and 3 h, along circles around an axis outside of the cube.
struct Turning_metric {
  double h;
  Metric operator()(const Point& p) const {
    const Vector_3d u = normalized(Vector_3d(p.x() + 0.3, p.y() + 0.3, 0));
    return Metric::from_sizes(std::array<double, 3>{h, 8 * h, 3 * h},
                              std::array<Vector_3d, 3>{u, Vector_3d(-u.y, u.x, 0), Vector_3d(0, 0, 1)});
  }
};
Turning_metric metric_for(double tetrahedra) {
  return {std::cbrt(1.1 * 6 * std::sqrt(2.) / (24 * tetrahedra))}; // 1.1 √2/12 of the metric's volume for each
}

double peak_megabytes(int who) {
  rusage usage;
  getrusage(who, &usage);
  return double(usage.ru_maxrss) / 1024;
}

void report(benchmark::State& state, const Mesh& mesh, double seconds, double megabytes) {
  state.counters["peak_MB"] = megabytes;
  const auto q = tubular::quality_report(mesh);
  state.counters["tetrahedra"] = double(mesh.tetrahedra.size());
  state.counters["per_second"] = double(mesh.tetrahedra.size()) / seconds;
  state.counters["mean_Q"] = q.Q_tau.mean();
  state.counters["max_Q"] = q.Q_tau.max();
  state.counters["efficiency"] = q.efficiency;
}

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

template <class Metric_field> void give_metric(Mesh& mesh, const Metric_field& metric) {
  tubular::Point_array array{"metric", 6, {}};
  for (const Point& p : mesh.points)
    for (double component : metric(p).components())
      array.values.push_back(component);
  mesh.point_arrays.assign(1, array);
}

/* mmg3d_O3 interpolates the metric from the input's points, which must be close enough to carry it. The result is
 * measured by the field itself. */
template <class Metric_field> void run_mmg(benchmark::State& state, Mesh mesh, const Metric_field& metric) {
  if (std::system("command -v mmg3d_O3 > /dev/null 2>&1") != 0) {
    state.SkipWithError("mmg3d_O3 is not on the PATH");
    return;
  }
  const std::string name = (std::filesystem::temp_directory_path() / "benchmark_remeshing").string();
  give_metric(mesh, metric);
  tubular::IO::write_mesh(name + ".mesh", mesh);
  const std::string command = "mmg3d_O3 -v 0 -nr -hgrad -1 -in " + name + ".mesh -sol " + name + ".sol -out " + name +
                              ".o.mesh > " + name + ".log";
  double seconds = 0;
  for (auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    if (std::system(command.c_str()) != 0) {
      state.SkipWithError("mmg3d_O3 failed");
      return;
    }
    seconds += seconds_since(start);
  }
  tubular::IO::read_mesh(name + ".o.mesh", mesh);
  give_metric(mesh, metric);
  report(state, mesh, seconds / double(state.iterations()), peak_megabytes(RUSAGE_CHILDREN));
  for (const char* extension : {".mesh", ".sol", ".o.mesh", ".o.sol", ".log"})
    std::remove((name + extension).c_str());
}

template <class Remesh> void run(benchmark::State& state, const Mesh& before, const Remesh& remesh) {
  Mesh mesh;
  double seconds = 0;
  for (auto _ : state) {
    mesh = before;
    const auto start = std::chrono::steady_clock::now();
    remesh(mesh);
    seconds += seconds_since(start);
  }
  report(state, mesh, seconds / double(state.iterations()), peak_megabytes(RUSAGE_SELF));
}

void remesh(benchmark::State& state) {
  const Turning_metric metric = metric_for(double(state.range(0)));
  run(state, make_cube(8), [&](Mesh& mesh) {
    tubular::anisotropic_tetrahedral_remeshing(mesh, metric,
                                               tubular::parameters::number_of_threads(int(state.range(1))));
  });
}

void remesh_with_mmg(benchmark::State& state) {
  run_mmg(state, make_cube(16), metric_for(double(state.range(0))));
}

/* A model's isotropic tetrahedra, and the field of its anisotropic ones. */
struct Vessels {
  tubular::Tubular_model model;
  Mesh mesh = tubular::Mesher(model).isotropic();
  tubular::Centerline_metric_field metric =
      tubular::Centerline_metric_field(model.surface, model.patch, model.centerlines);
};

Vessels tree(std::size_t branches) {
  const auto skeleton = tubular::bronchial_tree(branches);
  Surface surface;
  tubular::generate_tubular_surface(skeleton, surface, tubular::parameters::points_per_circumference(24));
  return {tubular::make_tubular_model(surface, tubular::centerlines_of(skeleton))};
}

Vessels file(const std::string& name) {
  Surface surface;
  tubular::IO::read_surface(name, surface);
  tubular::repair_surface(surface);
  return {tubular::make_tubular_model(surface)};
}

template <class Make_vessels> void remesh_vessels(benchmark::State& state, const Make_vessels& make, bool with_mmg) {
  try {
    const Vessels vessels = make();
    if (with_mmg)
      run_mmg(state, vessels.mesh, vessels.metric);
    else
      run(state, vessels.mesh, [&](Mesh& mesh) {
        tubular::anisotropic_tetrahedral_remeshing(
            mesh, vessels.model.surface, vessels.model.patch, vessels.metric,
            tubular::parameters::number_of_threads(int(state.range(0)))
                .boundary_layer_patches(std::vector<int>{tubular::labels::wall}));
      });
  } catch (const std::exception& e) {
    state.SkipWithError(e.what());
  }
}

template <class Make_vessels> void register_vessels(const std::string& name, const Make_vessels& make) {
  const auto add = [&](const std::string& full_name, bool with_mmg) {
    return benchmark::RegisterBenchmark(full_name.c_str(),
                                        [=](benchmark::State& state) { remesh_vessels(state, make, with_mmg); })
        ->Unit(benchmark::kMillisecond)
        ->Iterations(1)
        ->UseRealTime();
  };
  add(name + "/mmg", true);
  add(name, false)->ArgName("threads")->Arg(1)->Arg(0);
}

// What it costs when nothing is to be done.
void remesh_again(benchmark::State& state) {
  const Turning_metric metric = metric_for(double(state.range(0)));
  Mesh once = make_cube(8), mesh;
  tubular::anisotropic_tetrahedral_remeshing(once, metric);
  for (auto _ : state) {
    mesh = once;
    tubular::anisotropic_tetrahedral_remeshing(mesh, metric);
  }
  state.counters["tetrahedra_before"] = double(once.tetrahedra.size());
  state.counters["tetrahedra"] = double(mesh.tetrahedra.size());
}

// first, as a process that is started has the peak of its parent to begin with
BENCHMARK(remesh_with_mmg)
    ->Arg(10000)
    ->Arg(100000)
    ->Arg(300000)
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();
BENCHMARK(remesh)
    ->ArgNames({"tetrahedra", "threads"})
    ->ArgsProduct({{10000, 30000, 100000, 300000, 1000000, 2000000}, {1, 0}})
    ->Unit(benchmark::kMillisecond)
    ->Iterations(1)
    ->UseRealTime();
BENCHMARK(remesh_again)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1)->UseRealTime();

} // namespace

int main(int argc, char* argv[]) {
  benchmark::Initialize(&argc, argv); // takes its own options out
  register_vessels("tree", [] { return tree(3); });
  for (int i = 1; i < argc; ++i)
    register_vessels(argv[i], [name = std::string(argv[i])] { return file(name); });
  benchmark::RunSpecifiedBenchmarks();
  return 0;
}
