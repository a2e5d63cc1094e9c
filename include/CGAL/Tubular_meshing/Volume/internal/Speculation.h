// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SPECULATION_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SPECULATION_H

#include <CGAL/Tubular_meshing/base/parallel.h>

#include <algorithm>
#include <cstddef>
#include <deque>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

/* Does many local operations on a mesh, one after the other, and yet on several threads: what costs time is to find out
 * whether an operation is possible and what it would lead to, and that only reads. So candidates are looked at in
 * batches, all of a batch at the same time; then those that are possible are done in their order. If something that one
 * of them depends on has been changed by another one of its batch, which is rare, it is looked at once more.
 *
 * The result does not depend on the number of threads, as batches do not.
 */
template <class Worker> class Speculation {
public:
  // Many times the cores, and few compared with a mesh. Batches of one are what is done without any speculation.
  static constexpr std::size_t default_batch = 512;

  // `arguments`: of workers, which look at a candidate each and remember what they have found.
  template <class... Arguments>
  Speculation(int threads, std::size_t batch, const Arguments&... arguments)
      : possible_(batch)
      , threads_(threads) {
    for (std::size_t k = 0; k < batch; ++k)
      workers_.emplace_back(arguments...);
  }

  /* For each k < n, which may grow meanwhile:
   *   find(worker, k): whether k is possible; for several k at the same time
   *   now(): the time, which goes on with each change of the mesh
   *   is_fresh(worker, k, since): whether all that the worker has seen is as it was at that time
   *   commit(worker, k): does it. */
  template <class Number, class Now, class Find, class Is_fresh, class Commit>
  void run(const Number& n, const Now& now, const Find& find, const Is_fresh& is_fresh, const Commit& commit) {
    for (std::size_t first = 0, last; first < n(); first = last) {
      last = (std::min)(first + possible_.size(), n());
      const auto since = now();
      find_all(first, last, find);
      for (std::size_t i = 0; i < last - first; ++i)
        if (possible_[i] && (is_fresh(workers_[i], first + i, since) || find(workers_[i], first + i)))
          commit(workers_[i], first + i);
    }
  }

  /* The same where the mesh may be changed in several places at the same time:
   *   reserve(worker, k): makes room for that, and marks what will change as no longer fresh; false if k has to be done
   *     by commit()
   *   fill(worker, k): changes it.
   * What commit() is to do, and what has to be looked at once more, comes after all others of its batch. */
  template <class Number, class Now, class Find, class Is_fresh, class Reserve, class Fill, class Commit>
  void run(const Number& n, const Now& now, const Find& find, const Is_fresh& is_fresh, const Reserve& reserve,
           const Fill& fill, const Commit& commit) {
    std::vector<std::size_t> together, alone;
    for (std::size_t first = 0, last; first < n(); first = last) {
      last = (std::min)(first + possible_.size(), n());
      const auto since = now();
      find_all(first, last, find);
      together.clear();
      alone.clear();
      for (std::size_t i = 0; i < last - first; ++i)
        if (possible_[i]) {
          const bool is_reserved = is_fresh(workers_[i], first + i, since) && reserve(workers_[i], first + i);
          (is_reserved ? together : alone).push_back(i);
        }
      for_each_range(
          together.size(), threads_,
          [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
              fill(workers_[together[k]], first + together[k]);
          },
          grain);
      for (std::size_t i : alone)
        if (find(workers_[i], first + i))
          commit(workers_[i], first + i);
    }
  }

private:
  static constexpr std::size_t grain = 16;

  template <class Find> void find_all(std::size_t first, std::size_t last, const Find& find) {
    for_each_range(
        last - first, threads_,
        [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            possible_[i] = find(workers_[i], first + i);
        },
        grain);
  }

  std::deque<Worker> workers_; // which need not be movable
  std::vector<char> possible_; // of the candidates of a batch
  int threads_;
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_SPECULATION_H
