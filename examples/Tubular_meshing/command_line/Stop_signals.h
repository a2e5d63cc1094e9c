// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_STOP_SIGNALS_H
#define COMMAND_LINE_STOP_SIGNALS_H

#include <CGAL/Tubular_meshing/IO/unfinished_outputs.h>

#include <pthread.h>
#include <signal.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <thread>
#include <vector>

namespace command_line {

/* Thrown out of work that Ctrl-C, or another signal that ends programs, has stopped. */
struct Interrupted {
  int signal;
};

/* Ends the program as the signal would have done it: the shell sees 128 and its number, 130 for Ctrl-C, and a loop of
 * the shell ends, too. */
[[noreturn]] inline void end_by(int signal) {
  ::signal(signal, SIG_DFL);
  sigset_t one;
  sigemptyset(&one);
  sigaddset(&one, signal);
  pthread_sigmask(SIG_UNBLOCK, &one, nullptr);
  raise(signal);
  _exit(128 + signal);
}

/* Waits for the signals that end programs: SIGINT, SIGTERM, SIGHUP, those of them that are not ignored. Work that calls
 * check() is left by an exception, so that all is in order behind it; work that does not within a second is ended all
 * the same, and the files that it has begun are removed.
 *
 * It must be made before other threads are, which are to leave the signals to it. */
class Stop_signals {
public:
  Stop_signals() {
    sigemptyset(&signals_);
    for (int s : {SIGINT, SIGTERM, SIGHUP}) {
      struct sigaction action;
      if (sigaction(s, nullptr, &action) == 0 && action.sa_handler != SIG_IGN)
        sigaddset(&signals_, s);
    }
    waker_ = signals_;
    sigaddset(&waker_, SIGUSR1); // from the destructor, to the thread alone
    pthread_sigmask(SIG_BLOCK, &waker_, nullptr);
    thread_ = std::thread([this] { wait(); });
  }
  Stop_signals(const Stop_signals&) = delete;
  ~Stop_signals() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    over_.notify_all();
    pthread_kill(thread_.native_handle(), SIGUSR1);
    thread_.join();
  }

  /// Throws Interrupted if there was a signal.
  void check() const {
    if (const int s = signal_)
      throw Interrupted{s};
  }

private:
  void wait() {
    int s = 0;
    while (sigwait(&waker_, &s) != 0)
      ;
    if (s == SIGUSR1)
      return;
    signal_ = s;
    std::unique_lock<std::mutex> lock(mutex_);
    if (over_.wait_for(lock, std::chrono::seconds(1), [this] { return is_over_; }))
      return;
    CGAL::Tubular_meshing::IO::remove_unfinished_outputs();
    end_by(s);
  }

  sigset_t signals_, waker_;
  std::atomic<int> signal_{0};
  std::mutex mutex_;
  std::condition_variable over_;
  bool is_over_ = false;
  std::thread thread_;
};

} // namespace command_line

#endif // COMMAND_LINE_STOP_SIGNALS_H
