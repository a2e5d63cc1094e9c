// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops on several threads, and the limit of them.

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <vector>

namespace {

using namespace CGAL::Tubular_meshing::internal;

TEST(For_each_range, Visits_all_once) {
  for (int threads : {0, 1, 2, 3}) {
    std::vector<int> visits(100000, 0);
    for_each_range(visits.size(), threads, [&](std::size_t first, std::size_t last) {
      for (std::size_t i = first; i < last; ++i)
        ++visits[i];
    });
    EXPECT_EQ(visits, std::vector<int>(100000, 1));
  }
}

#ifdef CGAL_LINKED_WITH_TBB
// How many threads a loop may take.
int most_threads_of_loop(int threads) {
  int most = 0;
  run_on(threads, [&] { most = tbb::this_task_arena::max_concurrency(); });
  return most;
}

TEST(Thread_limit, Holds_for_loops_that_want_more) {
  const int all = most_threads_of_loop(0);
  {
    const Thread_limit one(1);
    EXPECT_EQ(most_threads_of_loop(0), 1);
    EXPECT_EQ(most_threads_of_loop(2), 1);
    {
      const Thread_limit none(0);
      EXPECT_EQ(most_threads_of_loop(0), all);
    }
    EXPECT_EQ(most_threads_of_loop(0), 1);
  }
  EXPECT_EQ(most_threads_of_loop(0), all);
}
#endif

} // namespace
