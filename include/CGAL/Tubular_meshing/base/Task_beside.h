// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_TASK_BESIDE_H
#define CGAL_TUBULAR_MESHING_BASE_TASK_BESIDE_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <utility>

#ifdef CGAL_LINKED_WITH_TBB
#include <tbb/task_group.h>
#endif

namespace CGAL::Tubular_meshing::internal {

/* One task at a time that another thread does, where there is one, while this thread goes on with what does not depend
 * on it. It is made, and waited for, inside of run_on(), whose threads it shares; on one thread it is done by wait(). */
class Task_beside {
public:
  Task_beside() = default;
  ~Task_beside() {
#ifdef CGAL_LINKED_WITH_TBB
    try {
      group_.wait();
    } catch (...) { // there is another exception already, or wait() would have been called
    }
#endif
  }
  Task_beside(const Task_beside&) = delete;
  Task_beside& operator=(const Task_beside&) = delete;

  /* The function and what it refers to must live until wait(). */
  template <class Function> void run(Function function) {
#ifdef CGAL_LINKED_WITH_TBB
    group_.run(std::move(function));
#else
    function();
#endif
  }

  /* Throws what the task has thrown. */
  void wait() {
#ifdef CGAL_LINKED_WITH_TBB
    group_.wait();
#endif
  }

private:
#ifdef CGAL_LINKED_WITH_TBB
  tbb::task_group group_;
#endif
};

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_BASE_TASK_BESIDE_H
