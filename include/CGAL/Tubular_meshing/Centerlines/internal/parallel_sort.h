// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_PARALLEL_SORT_H
#define CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_PARALLEL_SORT_H

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/parallel_sort.h>
#endif

namespace CGAL::Tubular_meshing::internal {

/* Sorts a range in which no two are equal, on `threads` threads where oneTBB is there (0: as many as there are cores). */
template <class Iterator, class Less> void parallel_sort(Iterator first, Iterator last, const Less& less, int threads) {
#ifdef CGAL_LINKED_WITH_TBB
  if (threads != 1) {
    run_on(threads, [&] { tbb::parallel_sort(first, last, less); });
    return;
  }
#else
  static_cast<void>(threads);
#endif
  std::sort(first, last, less);
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_CENTERLINES_INTERNAL_PARALLEL_SORT_H
