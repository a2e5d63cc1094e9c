// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PARALLEL_IMPL_H
#define CGAL_TUBULAR_MESHING_BASE_PARALLEL_IMPL_H

#include <CGAL/Tubular_meshing/base/interruption.h>
#include <CGAL/Tubular_meshing/base/parallel.h>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_arena.h>

#include <map>
#include <mutex>
#endif

namespace CGAL::Tubular_meshing::internal {

CGAL_TUBULAR_MESHING_INLINE int& thread_limit() {
  thread_local int limit = 0;
  return limit;
}

CGAL_TUBULAR_MESHING_INLINE Thread_limit::Thread_limit(int threads)
    : before_(thread_limit()) {
  thread_limit() = threads;
}
CGAL_TUBULAR_MESHING_INLINE Thread_limit::~Thread_limit() {
  thread_limit() = before_;
}

/* Arenas are kept, one for each number of threads: some loops are as short as their making, and those given up live on
 * for as long as a thread has not left them. */
CGAL_TUBULAR_MESHING_INLINE void run_on(int threads, Function_view<void()> loop) {
  check_interruption();
  const int limit = thread_limit();
  if (limit > 0 && (threads == 0 || threads > limit))
    threads = limit;
#ifdef CGAL_LINKED_WITH_TBB
  if (threads > 0 && threads < tbb::this_task_arena::max_concurrency()) {
    static std::mutex mutex;
    static std::map<int, tbb::task_arena> arenas;
    tbb::task_arena* arena;
    {
      const std::lock_guard<std::mutex> lock(mutex);
      arena = &arenas.emplace(threads, threads).first->second;
    }
    arena->execute([&] { loop(); });
    return;
  }
#else
  static_cast<void>(threads);
#endif
  loop();
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_PARALLEL_IMPL_H
