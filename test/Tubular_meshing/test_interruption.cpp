// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Work that a program stops, by an exception of its own.

#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/Pipelines/Mesher.h>
#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <ctime>
#include <string>
#include <thread>
#include <vector>

namespace TM = CGAL::Tubular_meshing;

namespace {

struct Stopped {};

void wait_a_moment() {
  std::this_thread::sleep_for(std::chrono::milliseconds(60));
}

} // namespace

TEST(Interruption, Nothing_is_called_without_a_check) {
  TM::internal::check_interruption();
}

TEST(Interruption, A_check_is_called_in_its_thread_and_not_too_often) {
  int calls = 0;
  const TM::Interruption_check check([&] { ++calls; });
  for (int i = 0; i < 1000; ++i)
    TM::internal::check_interruption();
  EXPECT_LE(calls, 1);
  wait_a_moment();
  TM::internal::check_interruption();
  EXPECT_GE(calls, 1);
  const int before = calls;
  wait_a_moment();
  std::thread([] { TM::internal::check_interruption(); }).join();
  EXPECT_EQ(calls, before);
}

TEST(Interruption, A_check_is_called_in_any_case_before_what_is_not_taken_back) {
  TM::internal::check_interruption_now();
  int calls = 0;
  const TM::Interruption_check check([&] { ++calls; });
  for (int i = 0; i < 3; ++i)
    TM::internal::check_interruption_now();
  EXPECT_EQ(calls, 3);
}

TEST(Interruption, The_one_made_last_counts) {
  int outer = 0, inner = 0;
  const TM::Interruption_check first([&] { ++outer; });
  {
    const TM::Interruption_check second([&] { ++inner; });
    wait_a_moment();
    TM::internal::check_interruption();
    EXPECT_EQ(outer, 0);
    EXPECT_EQ(inner, 1);
  }
  wait_a_moment();
  TM::internal::check_interruption();
  EXPECT_EQ(outer, 1);
}

TEST(Interruption, A_loop_on_threads_ends) {
  const TM::Interruption_check check([] { throw Stopped(); });
  const auto loop = [] {
    for (;;)
      TM::internal::for_each_range(100000, 2, [](std::size_t, std::size_t) {});
  };
#ifdef CGAL_LINKED_WITH_TBB
  EXPECT_THROW(loop(), Stopped);
#else
  (void)loop;
#endif
}

// In each stage, by the observer or by the check, whichever is first: the mesher is as it was.
TEST(Interruption, A_mesher_can_be_used_again) {
  const TM::Tubular_skeleton skeleton = TM::straight_tube(8);
  TM::Surface surface;
  TM::generate_tubular_surface(skeleton, surface, TM::parameters::points_per_circumference(16));
  std::vector<std::string> stages;
  std::string last;
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  TM::Mesher mesher(
      model, TM::parameters::points_per_circumference(10).in_child_process(true).observer([&](const char* stage) {
        stages.push_back(stage);
        if (stage == last)
          throw Stopped();
      }));
  const TM::Mixed_mesh expected = mesher.isotropic();
  ASSERT_GT(expected.tetrahedra.size(), 100u);
  const std::vector<std::string> all = stages;
  for (const std::string& stage : all) {
    if (stage == "size field" || stage == "cut" || stage == "parameterization")
      continue; // done once
    last = stage;
    EXPECT_THROW(mesher.isotropic(), Stopped) << stage;
    last.clear();
    const TM::Mixed_mesh again = mesher.isotropic();
    EXPECT_EQ(again.points, expected.points) << stage;
    EXPECT_EQ(again.tetrahedra.vertices, expected.tetrahedra.vertices) << stage;
  }
}

// A fine mesh takes many seconds of processor time; a check that throws as soon as it may ends it long before.
TEST(Interruption, A_long_stage_ends_soon) {
  TM::Surface surface;
  TM::generate_tubular_surface(TM::straight_tube(20), surface, TM::parameters::points_per_circumference(16));
  const TM::Tubular_model model = TM::make_tubular_model(surface);
  for (const std::string wanted : {"surface mesh", "tetrahedra", "optimization"}) {
    bool is_there = false;
    std::clock_t begin = 0;
    const auto observer = [&](const char* stage) {
      is_there = is_there || stage == wanted;
      if (stage == wanted)
        begin = std::clock();
    };
    TM::Mesher mesher(
        model,
        TM::parameters::points_per_circumference(50).in_child_process(true).number_of_threads(2).observer(observer));
    const TM::Interruption_check check([&] {
      if (is_there)
        throw Stopped();
    });
    EXPECT_THROW(mesher.isotropic(), Stopped) << wanted;
    EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, 1.5) << wanted;
  }
}
