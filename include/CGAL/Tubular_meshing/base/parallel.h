// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PARALLEL_H
#define CGAL_TUBULAR_MESHING_BASE_PARALLEL_H

#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#endif

namespace CGAL {
namespace Tubular_meshing {
namespace internal {

#ifdef CGAL_LINKED_WITH_TBB
/* Runs a parallel loop on at most `threads` threads (0: as many as there are cores). Arenas are kept: some loops are as
 * short as their making, and those given up live on for as long as a thread has not left them. */
template <class Loop> void run_on(int threads, const Loop& loop) {
  if (threads <= 0 || threads >= tbb::this_task_arena::max_concurrency())
    return loop();
  static std::mutex mutex;
  static std::map<int, tbb::task_arena> arenas;
  tbb::task_arena* arena;
  {
    const std::lock_guard<std::mutex> lock(mutex);
    arena = &arenas.emplace(threads, threads).first->second;
  }
  arena->execute(loop);
}
#endif

/* Calls body(first, last) on pieces of [0, n), on `threads` threads where oneTBB is there (0: as many as there are
 * cores). The pieces, of about `grain`, may be done in any order: the body must not depend on it. */
template <class Body> void for_each_range(std::size_t n, int threads, const Body& body, std::size_t grain = 128) {
#ifdef CGAL_LINKED_WITH_TBB
  if (threads != 1 && n > 2 * grain) {
    run_on(threads, [&] {
      tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                        [&](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); });
    });
    return;
  }
#else
  static_cast<void>(threads);
  static_cast<void>(grain);
#endif
  if (n > 0)
    body(std::size_t(0), n);
}

/* Calls body(i) for each i < n: unlike the pieces of for_each_range(), each is work enough to be a task of its own. */
template <class Body> void for_each_task(std::size_t n, int threads, const Body& body) {
#ifdef CGAL_LINKED_WITH_TBB
  if (threads != 1 && n > 1) {
    run_on(threads, [&] {
      tbb::parallel_for(
          tbb::blocked_range<std::size_t>(0, n, 1),
          [&](const tbb::blocked_range<std::size_t>& r) {
            for (std::size_t i = r.begin(); i < r.end(); ++i)
              body(i);
          },
          tbb::simple_partitioner());
    });
    return;
  }
#endif
  static_cast<void>(threads);
  for (std::size_t i = 0; i < n; ++i)
    body(i);
}

} // namespace internal
} // namespace Tubular_meshing
} // namespace CGAL

#endif // CGAL_TUBULAR_MESHING_BASE_PARALLEL_H
