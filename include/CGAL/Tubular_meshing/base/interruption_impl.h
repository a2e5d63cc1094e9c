// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_IMPL_H
#define CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_IMPL_H

#include <CGAL/Tubular_meshing/base/interruption.h>

#include <utility>

namespace CGAL::Tubular_meshing {
namespace internal {

inline Interruption_check*& interruption_of_this_thread() {
  thread_local Interruption_check* check = nullptr;
  return check;
}

CGAL_TUBULAR_MESHING_INLINE void check_interruption() {
  if (Interruption_check* check = interruption_of_this_thread())
    (*check)();
}

CGAL_TUBULAR_MESHING_INLINE void check_interruption_now() {
  if (const Interruption_check* check = interruption_of_this_thread())
    check->call();
}

} // namespace internal

CGAL_TUBULAR_MESHING_INLINE Interruption_check::Interruption_check(std::function<void()> check)
    : check_(std::move(check))
    , last_(std::chrono::steady_clock::now())
    , outer_(std::exchange(internal::interruption_of_this_thread(), this)) {}

CGAL_TUBULAR_MESHING_INLINE Interruption_check::~Interruption_check() {
  internal::interruption_of_this_thread() = outer_;
}

CGAL_TUBULAR_MESHING_INLINE void Interruption_check::operator()() {
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < std::chrono::milliseconds(50))
    return;
  last_ = now;
  check_();
}

} // namespace CGAL::Tubular_meshing

#endif // CGAL_TUBULAR_MESHING_BASE_INTERRUPTION_IMPL_H
