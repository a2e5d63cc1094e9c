// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Loops on several threads, and the limit of them.

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <mutex>
#include <set>
#include <thread>
#include <vector>

namespace {

using namespace CGAL::Tubular_meshing::internal;

// The threads that a loop ran on, which takes them all if it can.
std::size_t threads_of_loop(int threads) {
  std::set<std::thread::id> ids;
  std::mutex mutex;
  for_each_range(
      64, threads,
      [&](std::size_t, std::size_t) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        const std::lock_guard<std::mutex> lock(mutex);
        ids.insert(std::this_thread::get_id());
      },
      1);
  return ids.size();
}

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

TEST(Thread_limit, Holds_for_loops_that_want_more) {
  const std::size_t all = threads_of_loop(0);
  {
    const Thread_limit one(1);
    EXPECT_EQ(threads_of_loop(0), 1u);
    EXPECT_EQ(threads_of_loop(2), 1u);
    {
      const Thread_limit none(0);
      EXPECT_EQ(threads_of_loop(0), all);
    }
    EXPECT_EQ(threads_of_loop(0), 1u);
  }
  EXPECT_EQ(threads_of_loop(0), all);
}

} // namespace
