// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// How the centerline graph and its fields grow: all of them as n log n at most.

#include <CGAL/Tubular_meshing/Centerlines/Centerline_field.h>
#include <CGAL/Tubular_meshing/Centerlines/build_centerline_graph.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <benchmark/benchmark.h>

#include <cmath>
#include <random>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef Kernel::Vector_3 Vector;
typedef CGAL::Tubular_meshing::Centerline_polylines<Point> Polylines;
typedef CGAL::Tubular_meshing::Centerline_graph<Point> Graph;
typedef CGAL::Tubular_meshing::Centerline_field<Point> Field;

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
