// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Limits of the process, as tests set them in place of full disks.

#ifndef TUBULAR_MESHING_TEST_RESOURCE_LIMITS_H
#define TUBULAR_MESHING_TEST_RESOURCE_LIMITS_H

#include <gtest/gtest.h>

#ifdef __unix__

#include <csignal>
#include <sys/resource.h>

/* A limit, RLIMIT_FSIZE or another one, as long as this is there; what would write more gets an error, not a signal. */
class Resource_limit {
public:
  Resource_limit(decltype(RLIMIT_FSIZE) resource, rlim_t most)
      : resource_(resource)
      , handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    getrlimit(resource_, &before_);
    rlimit tight = before_;
    tight.rlim_cur = most;
    setrlimit(resource_, &tight);
  }
  Resource_limit(const Resource_limit&) = delete;
  ~Resource_limit() {
    setrlimit(resource_, &before_);
    std::signal(SIGXFSZ, handler_);
  }

private:
  decltype(RLIMIT_FSIZE) resource_;
  void (*handler_)(int);
  rlimit before_ = {};
};

/* Calls write() under limits on the size of files, which it has to answer by an exception; then nothing_is_left(). */
template <class Exception, class Write, class Check>
void expect_no_file_within_limits(const Write& write, const Check& nothing_is_left) {
  for (rlim_t most : {100, 5000, 20000, 40000}) {
    SCOPED_TRACE(most);
    {
      const Resource_limit limit(RLIMIT_FSIZE, most);
      EXPECT_THROW(write(), Exception);
    }
    nothing_is_left();
  }
}

#endif // __unix__

#endif // TUBULAR_MESHING_TEST_RESOURCE_LIMITS_H
