// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How the centerline graph and its fields grow: all of them as n log n at most.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/Wall_distance.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_metric_field.h>
#include <CGAL/Tubular_meshing/Fields/Centerline_sizing_field.h>
#include <CGAL/Tubular_meshing/Fields/Metric_tensor_3.h>
#include <CGAL/Tubular_meshing/Fields/curvature.h>
#include <CGAL/Tubular_meshing/base/parallel.h>
#include <CGAL/Tubular_meshing/base/labels.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/property_map.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Tubular_meshing::Centerline_polylines Polylines;
typedef CGAL::Tubular_meshing::Centerline_graph Graph;
typedef CGAL::Tubular_meshing::Centerline_field Field;
typedef CGAL::Tubular_meshing::Centerline_sizing_field Sizing_field;
typedef CGAL::Tubular_meshing::Centerline_metric_field Metric_field;
typedef CGAL::Tubular_meshing::Metric_tensor_3 Metric;

// A tree of branches that halve at each generation, 128 segments a branch, as the lines of single branches.
Polylines tree_of(std::size_t number_of_segments) {
  const std::size_t per_branch = 128;
  struct Tip {
    Point point;
    Vector direction, side;
    double length;
  };
  Polylines tree;
  std::vector<Tip> tips = {{Point(0, 0, 0), Vector(0, 0, 1), Vector(1, 0, 0), 1}};
  for (std::size_t next = 0; next * per_branch < number_of_segments; ++next) {
    const Tip tip = tips[next];
    std::vector<std::size_t> line;
    for (std::size_t i = 0; i <= per_branch; ++i) {
      line.push_back(tree.points.size());
      tree.points.push_back(tip.point + (double(i) / per_branch * tip.length) * tip.direction);
      tree.radius.push_back(0.12 * tip.length);
    }
    tree.lines.push_back(line);
    const Vector other = CGAL::cross_product(tip.direction, tip.side);
    for (double sign : {-1., 1.}) {
      const Vector direction = std::cos(0.6) * tip.direction + sign * std::sin(0.6) * tip.side;
      tips.push_back(Tip{tree.points.back(), direction, other, 0.8 * tip.length});
    }
  }
  return tree;
}

Graph graph_of(std::size_t number_of_segments) {
  const Polylines tree = tree_of(number_of_segments);
  return Graph(tree.points, tree.radius, tree.lines);
}

// Points in the lumen: along the branches in order, as a mesher asks, or at random.
std::vector<Point> queries(const Graph& graph, std::size_t number, bool in_order) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal(0, 0.5);
  std::vector<Point> result;
  for (std::size_t i = 0; i < number; ++i) {
    const std::size_t k = in_order ? i * graph.points().size() / number : random() % graph.points().size();
    result.push_back(graph.points()[k] + graph.radii()[k] * Vector(normal(random), normal(random), normal(random)));
  }
  return result;
}

void build_graph(benchmark::State& state) {
  const Polylines tree = tree_of(state.range(0));
  for (auto _ : state) {
    Graph graph;
    CGAL::Tubular_meshing::build_centerline_graph(tree, graph);
    benchmark::DoNotOptimize(graph.branches().data());
  }
  state.SetComplexityN(state.range(0));
}

void build_field(benchmark::State& state) {
  const Graph graph = graph_of(state.range(0));
  for (auto _ : state) {
    const Field field(graph);
    benchmark::DoNotOptimize(field.number_of_segments());
  }
  state.SetComplexityN(state.range(0));
}

// n queries on a fixed tree of 10^5 segments.
void query_descriptors(benchmark::State& state) {
  const Graph graph = graph_of(100000);
  const Field field(graph);
  const std::vector<Point> points = queries(graph, state.range(0), true);
  for (auto _ : state)
    for (const Point& p : points)
      benchmark::DoNotOptimize(field.descriptors(p));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}

void query_descriptors_and_frame(benchmark::State& state) {
  const Graph graph = graph_of(100000);
  const Field field(graph);
  const std::vector<Point> points = queries(graph, state.range(0), true);
  for (auto _ : state)
    for (const Point& p : points)
      benchmark::DoNotOptimize(field.descriptors_and_frame(p));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}

// 10^5 queries in no order on a tree of n segments.
void query_at_random(benchmark::State& state) {
  const Graph graph = graph_of(state.range(0));
  const Field field(graph);
  const std::vector<Point> points = queries(graph, 100000, false);
  for (auto _ : state)
    for (const Point& p : points)
      benchmark::DoNotOptimize(field.descriptors(p));
  state.SetItemsProcessed(state.iterations() * 100000);
  state.SetComplexityN(state.range(0));
}

// A helix of 24 triangles round and as long as the number of triangles asks for, and its centerline.
struct Long_tube {
  CGAL::Surface_mesh<Point> surface;
  Graph graph;

  explicit Long_tube(std::size_t number_of_triangles) {
    const std::size_t sides = 12, rings = number_of_triangles / (2 * sides) + 1;
    const double pi = std::acos(-1.), step = 2 * pi / sides;
    std::vector<Point> points;
    std::vector<std::size_t> line;
    for (std::size_t i = 0; i <= rings; ++i) {
      const double a = step * i / 20; // a helix of radius 20 and pitch 6
      const Vector out(std::cos(a), std::sin(a), 0), up(0, 0, 1);
      points.push_back(Point(0, 0, 6 * a / (2 * pi)) + 20 * out);
      line.push_back(i);
      for (std::size_t k = 0; k < sides; ++k)
        surface.add_vertex(points.back() + std::cos(step * k) * out + std::sin(step * k) * up);
    }
    const auto at = [&](std::size_t i, std::size_t k) {
      return CGAL::SM_Vertex_index(unsigned(i * sides + k % sides));
    };
    for (std::size_t i = 0; i < rings; ++i)
      for (std::size_t k = 0; k < sides; ++k) {
        surface.add_face(at(i, k), at(i + 1, k), at(i, k + 1)); // turned outward
        surface.add_face(at(i + 1, k), at(i + 1, k + 1), at(i, k + 1));
      }
    std::vector<double> radii(points.size(), 1);
    graph = Graph(std::move(points), std::move(radii), {line});
  }
};

void build_sizing_field(benchmark::State& state) {
  const Long_tube tube(state.range(0));
  for (auto _ : state) {
    const Sizing_field size(Field(tube.graph), CGAL::Tubular_meshing::Wall_distance(tube.surface),
                            CGAL::Tubular_meshing::parameters::number_of_threads(1));
    benchmark::DoNotOptimize(size.estimated_number_of_tetrahedra());
  }
  state.SetComplexityN(state.range(0));
}

// n queries on a tube of 10^5 triangles.
void query_size(benchmark::State& state) {
  const Long_tube tube(100000);
  const Sizing_field size(Field(tube.graph), CGAL::Tubular_meshing::Wall_distance(tube.surface));
  const std::vector<Point> points = queries(tube.graph, state.range(0), true);
  for (auto _ : state)
    for (const Point& p : points)
      benchmark::DoNotOptimize(size(p));
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.SetComplexityN(state.range(0));
}

void build_curvatures(benchmark::State& state) {
  const Long_tube tube(state.range(0));
  typedef CGAL::Tubular_meshing::Vertex_curvature<Vector> Curvature;
  std::vector<Curvature> curvatures(tube.surface.number_of_vertices());
  const std::function<double(const Point&)> radius = [](const Point&) { return 1.; };
  for (auto _ : state) {
    CGAL::Tubular_meshing::compute_curvatures(tube.surface, CGAL::make_property_map(curvatures),
                                              CGAL::Tubular_meshing::parameters::local_radius(radius));
    benchmark::DoNotOptimize(curvatures.data());
  }
  state.SetComplexityN(state.range(0));
}

Metric_field metric_field_of(const Long_tube& tube, int threads) {
  namespace tubular = CGAL::Tubular_meshing;
  const CGAL::Constant_property_map<CGAL::SM_Face_index, int> all_wall(tubular::labels::wall);
  return Metric_field(tube.surface, all_wall, tube.graph, tubular::parameters::number_of_threads(threads));
}

void build_metric_field(benchmark::State& state) {
  const Long_tube tube(state.range(0));
  for (auto _ : state)
    benchmark::DoNotOptimize(metric_field_of(tube, 0).number_of_leaves());
  state.SetComplexityN(state.range(0));
}

// 10^6 queries on a tube of 10^5 triangles, on one thread and on as many as there are; half of them within the layer.
void query_metric(benchmark::State& state) {
  const Long_tube tube(100000);
  const Metric_field metric = metric_field_of(tube, 0);
  std::vector<Point> points = queries(tube.graph, 1000000, true);
  const int threads = int(state.range(0));
  std::vector<Metric> result(points.size());
  for (auto _ : state)
    CGAL::Tubular_meshing::internal::for_each_range(points.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        result[i] = metric(points[i]);
    });
  benchmark::DoNotOptimize(result.data());
  state.SetItemsProcessed(state.iterations() * points.size());
}

// What loops over a mesh do with tensors.
template <class Function> void query_tensors(benchmark::State& state, const Function& function) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> size(-2, 0);
  std::normal_distribution<double> normal(0, 1);
  std::vector<Metric> metrics;
  for (int i = 0; i < 1000; ++i) {
    Metric m(0, 0, 0, 0, 0, 0);
    for (int k = 0; k < 3; ++k)
      m += std::pow(10., -2 * size(random)) * Metric::dyad(Vector(normal(random), normal(random), normal(random)));
    metrics.push_back(m);
  }
  for (auto _ : state)
    for (std::size_t i = 0; i + 1 < metrics.size(); ++i)
      benchmark::DoNotOptimize(function(metrics[i], metrics[i + 1]));
  state.SetItemsProcessed(state.iterations() * (metrics.size() - 1));
}
void tensor_edge_length(benchmark::State& state) {
  query_tensors(state,
                [](const Metric& a, const Metric& b) { return Metric::edge_length(Metric::Vector(.1, .2, .3), a, b); });
}
void tensor_interpolation(benchmark::State& state) {
  query_tensors(state, [](const Metric& a, const Metric& b) { return Metric::interpolate(a, b, 0.3); });
}
void tensor_intersection(benchmark::State& state) {
  query_tensors(state, [](const Metric& a, const Metric& b) { return Metric::intersection(a, b); });
}

BENCHMARK(tensor_edge_length);
BENCHMARK(tensor_interpolation);
BENCHMARK(tensor_intersection);
BENCHMARK(build_curvatures)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(build_metric_field)
    ->RangeMultiplier(10)
    ->Range(1000, 100000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(query_metric)->ArgName("threads")->Arg(1)->Arg(0)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(build_sizing_field)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(query_size)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(build_graph)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(build_field)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oNLogN);
BENCHMARK(query_descriptors)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(query_descriptors_and_frame)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oN);
BENCHMARK(query_at_random)
    ->RangeMultiplier(10)
    ->Range(1000, 1000000)
    ->Unit(benchmark::kMillisecond)
    ->Complexity(benchmark::oLogN);

} // namespace
