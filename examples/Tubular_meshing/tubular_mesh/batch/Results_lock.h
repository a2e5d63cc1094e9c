// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_RESULTS_LOCK_H
#define TUBULAR_MESH_BATCH_RESULTS_LOCK_H

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <string>

/* While it is there no other batch works in the folder. It is the folder itself that is locked: no file is left of it. */
class Results_lock {
public:
  explicit Results_lock(const std::string& folder)
      : file_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (file_ < 0)
      throw CGAL::Tubular_meshing::Parameter_error("The folder \"" + folder +
                                                   "\" cannot be used for the results: " + std::strerror(errno) + ".");
    if (::flock(file_, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK) // a file system may have no locks
      return;
    ::close(file_);
    throw CGAL::Tubular_meshing::Parameter_error("Another batch is at work in the folder \"" + folder +
                                                 "\": wait for it, or give another --output.");
  }
  Results_lock(const Results_lock&) = delete;
  ~Results_lock() { ::close(file_); }

private:
  int file_;
};

#endif // TUBULAR_MESH_BATCH_RESULTS_LOCK_H
