// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_H
#define CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_H

#include <CGAL/Tubular_meshing/base/config.h>

#include <chrono>
#include <functional>

namespace CGAL::Tubular_meshing {

/*! \ingroup PkgTubularMeshingBase
 *
 * Lets a program stop what it has begun. While one of these is there, the package calls its function now and then, at
 * most twenty times a second, from the thread that has made it: as a loop on several threads begins, in the long loops of
 * filling, optimization and remeshing, and while TetGen is waited for. What the function throws comes out of the call that is running, and leaves nothing behind: a Mesher can
 * be used again. The name of each stage as it begins is had from the `observer` of a Mesher, which may throw as well.
 *
 * \code
 * const Interruption_check check([&] { if (stopped) throw Stopped(); });
 * const Mixed_mesh mesh = mesher.isotropic();
 * \endcode
 *
 * Where they are nested, the one made last counts. It must be destroyed by the thread that has made it.
 */
class Interruption_check {
public:
  explicit Interruption_check(std::function<void()> check);
  ~Interruption_check();
  Interruption_check(const Interruption_check&) = delete;
  Interruption_check& operator=(const Interruption_check&) = delete;

  /// Calls the function, unless it was called a moment ago.
  void operator()();
  /// Calls the function in any case: before what is not to be taken back.
  void call() const { check_(); }

private:
  std::function<void()> check_;
  std::chrono::steady_clock::time_point last_; // that it was called
  Interruption_check* outer_;
};

namespace internal {

/* Where a long stage can be stopped: calls the function of this thread's Interruption_check, if it has one. */
void check_interruption();
/* The same, however recently it was called: before what is not to be taken back. */
void check_interruption_now();

} // namespace internal
} // namespace CGAL::Tubular_meshing

#ifdef CGAL_TUBULAR_MESHING_HEADER_ONLY
#include <CGAL/Tubular_meshing/base/interruption_impl.h>
#endif

#endif // CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_H
