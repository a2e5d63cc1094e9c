// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_CHILD_H
#define TUBULAR_MESH_BATCH_CHILD_H

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

/* How a program has ended. */
struct Child_status {
  int status; // as a shell has it: of a signal, 128 and its number
  bool timed_out;
  double seconds, peak_memory; // MB
};

/* A program that runs beside this one, in a folder of its own, in a process group of its own, so that all it starts ends
 * with it; it does not survive this program either. What it says goes into two files. */
class Child {
public:
  struct Limits {
    double seconds, memory; // MB; 0: none
  };

  /* Throws an Output_error where the files cannot be written, and a Meshing_error if there can be no more processes. */
  Child(const std::vector<std::string>& command, const std::string& folder, const std::string& out,
        const std::string& errors, const Limits& limits);
  Child(const Child&) = delete;
  ~Child();

  /* Its ending, once; nothing while it runs. */
  std::optional<Child_status> poll();

private:
  void kill_all() const;

  pid_t process_ = -1;
  Limits limits_;
  std::chrono::steady_clock::time_point start_;
  bool timed_out_ = false;
};

#endif // TUBULAR_MESH_BATCH_CHILD_H
