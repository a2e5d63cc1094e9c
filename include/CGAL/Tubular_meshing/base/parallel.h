// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_PARALLEL_H
#define CGAL_TUBULAR_MESHING_BASE_PARALLEL_H

#include <CGAL/Tubular_meshing/base/Function_view.h>
#include <CGAL/Tubular_meshing/base/config.h>

#include <cstddef>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#endif

namespace CGAL::Tubular_meshing::internal {

/* Runs a parallel loop on at most `threads` threads (0: as many as there are cores). */
void run_on(int threads, Function_view<void()> loop);

/* While it lives, loops that this thread runs take no more than `threads` threads (0: as many as there are cores), also
 * those of functions that have no parameter for it. */
class Thread_limit {
public:
  explicit Thread_limit(int threads);
  ~Thread_limit();
  Thread_limit(const Thread_limit&) = delete;
  Thread_limit& operator=(const Thread_limit&) = delete;

private:
  int before_;
};

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

} // namespace CGAL::Tubular_meshing::internal

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/base/parallel_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_BASE_PARALLEL_H
