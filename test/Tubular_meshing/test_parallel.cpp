// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops on several threads, and the limit of them.

#include <CGAL/Tubular_meshing/base/Task_beside.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#include <gtest/gtest.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>
#endif

#include <cstddef>
#include <numeric>
#include <stdexcept>
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

TEST(Task_beside, Is_done_by_wait) {
  for (int threads : {0, 1, 2}) {
    long of_task = 0, own = 0;
    run_on(threads, [&] {
      Task_beside task;
      for (int round = 0; round < 100; ++round) {
        task.run([&] {
          std::vector<long> numbers(1000, 1);
          for_each_range(numbers.size(), threads, [&](std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i)
              ++numbers[i];
          });
          of_task += std::accumulate(numbers.begin(), numbers.end(), 0L);
        });
        ++own;
        task.wait();
        EXPECT_EQ(of_task, 2000 * own);
      }
    });
  }
}

TEST(Task_beside, Throws_what_the_task_has_thrown) {
  const auto fail = [] { throw std::runtime_error("beside"); };
  run_on(0, [&] {
    Task_beside task;
    EXPECT_THROW((task.run(fail), task.wait()), std::runtime_error);
  });
#ifdef CGAL_LINKED_WITH_TBB
  const auto fail_beside = [&] {
    Task_beside task;
    task.run(fail);
    throw std::logic_error("here");
  };
  EXPECT_THROW(run_on(0, fail_beside), std::logic_error);
#endif
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
