// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_CHILD_PROCESS_H
#define CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_CHILD_PROCESS_H

#include <CGAL/Tubular_meshing/base/interruption.h>

#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/types.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstddef>
#include <new>
#include <type_traits>
#include <vector>

namespace CGAL::Tubular_meshing::internal {

// How a child process ended.
struct Child_ending {
  enum Kind {
    done,     // its work came to the end and all of its output is here
    gave_up,  // its work said so, by `code`, or the process was left by exit(code)
    killed,   // by the signal `code`
    no_child, // it could not be started, for the reason `code` (an errno)
  };
  Kind kind;
  int code;
};

// Moves all of the data by transfer(place, size), which is read() or write() and moves as much as it can.
template <class Byte, class Transfer> bool transfer_all(Byte* place, std::size_t size, const Transfer& transfer) {
  while (size > 0) {
    const ssize_t n = transfer(place, size);
    if (n < 0 && errno == EINTR)
      continue;
    if (n <= 0)
      return false;
    place += n;
    size -= std::size_t(n);
  }
  return true;
}

/* The child's end of the pipe to its parent: plain data goes in, in the order in which the parent reads it. */
class Pipe_writer {
public:
  explicit Pipe_writer(int file)
      : file_(file) {}

  bool write(const void* data, std::size_t size) const {
    return transfer_all(static_cast<const char*>(data), size,
                        [this](const char* p, std::size_t n) { return ::write(file_, p, n); });
  }
  // How many there are, then the values.
  template <class T> bool write(const std::vector<T>& values) const {
    static_assert(std::is_trivially_copyable<T>::value, "only plain data goes through a pipe");
    const std::size_t n = values.size();
    return write(&n, sizeof n) && write(values.data(), n * sizeof(T));
  }

private:
  int file_;
};

/* The parent's end. */
class Pipe_reader {
public:
  explicit Pipe_reader(int file)
      : file_(file) {}

  bool read(void* data, std::size_t size) const {
    return transfer_all(static_cast<char*>(data), size, [this](char* p, std::size_t n) {
      wait();
      return ::read(file_, p, n);
    });
  }
  template <class T> bool read(std::vector<T>& values) const {
    static_assert(std::is_trivially_copyable<T>::value, "only plain data goes through a pipe");
    std::size_t n = 0;
    if (!read(&n, sizeof n))
      return false;
    values.resize(n);
    return read(values.data(), n * sizeof(T));
  }

private:
  // The child may take long: the program can stop waiting.
  void wait() const {
    pollfd data = {file_, POLLIN, 0};
    const int milliseconds = 50;
    while (poll(&data, 1, milliseconds) == 0)
      check_interruption();
  }

  int file_;
};

/* What the child does before its work. The other threads of the parent are not there: the C library sees to it that
 * memory can be allocated all the same; the work must neither use nor wait for a thread. Whatever it prints goes
 * nowhere, a crash is nobody's business but the parent's (no handler of the program's, no core file), and when memory
 * runs out it is this process that goes, not the parent. */
inline void settle_in_child(rlim_t seconds) {
  const int nowhere = open("/dev/null", O_RDWR);
  for (int standard : {0, 1, 2})
    if (nowhere >= 0)
      dup2(nowhere, standard);
  for (int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGXCPU, SIGTERM, SIGINT, SIGHUP, SIGPIPE})
    std::signal(signal, SIG_DFL);
  sigset_t none;
  sigemptyset(&none);
  sigprocmask(SIG_SETMASK, &none, nullptr); // a thread of the program may wait for signals that others leave to it
  const rlimit time = {seconds, seconds + 1}, core = {0, 0};
  setrlimit(RLIMIT_CPU, &time);
  setrlimit(RLIMIT_CORE, &core);
  const int score = open("/proc/self/oom_score_adj", O_WRONLY); // Linux's; elsewhere there is no such file
  if (score >= 0) {
    const ssize_t written = ::write(score, "1000", 4);
    (void)written;
    close(score);
  }
}

constexpr int out_of_memory_code = 1; // TetGen's own
constexpr int crossing_facets_code = 3;

/* Runs `work(const Pipe_writer&)`, which returns 0 or a code from 1 to 255, in a copy of this process, and
 * `read(const Pipe_reader&)`, which returns whether it has got all, in this one. Whatever happens to the child, a
 * crash, exit(), `seconds` of processor time used up, this process goes on. If the wait is interrupted, the child is
 * killed. */
template <class Work, class Read>
Child_ending run_in_child_process(const Work& work, const Read& read, double seconds) {
  int ends[2];
  if (pipe(ends) != 0)
    return {Child_ending::no_child, errno};
  const pid_t child = fork();
  if (child < 0) {
    const int reason = errno;
    close(ends[0]);
    close(ends[1]);
    return {Child_ending::no_child, reason};
  }
  if (child == 0) {
    close(ends[0]);
    settle_in_child(rlim_t(seconds) + 1);
    int code = 255;
    try {
      code = work(Pipe_writer(ends[1]));
    } catch (const std::bad_alloc&) {
      code = out_of_memory_code;
    } catch (...) {
    }
    _exit(code); // neither destructors nor the buffers of the parent's streams are ours
  }
  close(ends[1]);
  int status = 0;
  pid_t ended = -1;
  const auto wait_for_child = [&] {
    close(ends[0]); // a child that still writes ends by it
    do
      ended = waitpid(child, &status, 0);
    while (ended < 0 && errno == EINTR);
  };
  bool complete = false;
  try {
    complete = read(Pipe_reader(ends[0]));
  } catch (const std::bad_alloc&) {
  } catch (...) {
    kill(child, SIGKILL);
    wait_for_child();
    throw;
  }
  wait_for_child();
  if (complete)
    return {Child_ending::done, 0};
  if (ended == child && WIFSIGNALED(status))
    return {Child_ending::killed, WTERMSIG(status)};
  return {Child_ending::gave_up, ended == child && WIFEXITED(status) ? WEXITSTATUS(status) : 255};
}

} // namespace CGAL::Tubular_meshing::internal

#endif // CGAL_TUBULAR_MESHING_VOLUME_INTERNAL_KEPT_BOUNDARY_CHILD_PROCESS_H
