// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_EXIT_STATUS_H
#define COMMAND_LINE_EXIT_STATUS_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <exception>
#include <new>
#include <string>
#include <system_error>

namespace command_line {

enum Exit_status { done = 0, wrong_usage = 2, unusable_input = 3, failed = 4, some_failed = 5 };

inline const char* exit_statuses() {
  return "Exit status: 0 done, 2 wrong usage (a file that cannot be written included), 3 input that cannot be read or "
         "used, 4 failed, 130 interrupted by Ctrl-C.";
}

/* That of a program which an exception has ended, ... */
inline Exit_status status_of(const std::exception& e) {
  namespace tubular = CGAL::Tubular_meshing;
  if (dynamic_cast<const tubular::Parameter_error*>(&e))
    return wrong_usage;
  return dynamic_cast<const tubular::Input_error*>(&e) ? unusable_input : failed;
}

/* A thread takes memory, too. The standard library and oneTBB have each a way to say that there can be none. */
inline bool lacks_threads(const std::exception& e) {
  const auto* system = dynamic_cast<const std::system_error*>(&e);
  return (system && system->code() == std::errc::resource_unavailable_try_again) ||
         std::string(e.what()).find("pthread_create has failed") != std::string::npos;
}

/* ... and what it says. */
inline std::string explanation_of(const std::exception& e) {
  if (dynamic_cast<const std::bad_alloc*>(&e))
    return "There is not enough memory; make the result coarser.";
  if (lacks_threads(e))
    return "There is not enough memory, or there are too many processes, for another thread; make the result coarser, "
           "or "
           "use fewer --threads.";
  if (dynamic_cast<const CGAL::Tubular_meshing::Error*>(&e))
    return e.what();
  return std::string("It failed: ") + e.what();
}

} // namespace command_line

#endif // COMMAND_LINE_EXIT_STATUS_H
