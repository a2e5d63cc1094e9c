// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Child.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <fcntl.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#ifdef __linux__
#include <sys/prctl.h>
#endif

#include <cerrno>
#include <chrono>
#include <cstring>
#include <string>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;

namespace {

int open_to_write(const std::string& file) {
  const int opened = ::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0)
    throw tubular::Output_error("The file \"" + file + "\" cannot be written: " + std::strerror(errno) + ".");
  return opened;
}

constexpr int cannot_be_run = 127; // a shell's word

// Nothing here allocates: of the parent's threads only one is in the child.
[[noreturn]] void become(char* const* words, const char* folder, int out, int errors, const rlimit* memory) {
  ::setpgid(0, 0);
  const int nowhere = ::open("/dev/null", O_RDONLY);
  ::dup2(nowhere, 0);
  ::dup2(out, 1);
  ::dup2(errors, 2);
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr); // the parent leaves signals to one of its threads
  ::signal(SIGPIPE, SIG_DFL);
  ::signal(SIGXFSZ, SIG_DFL);
#ifdef __linux__
  ::prctl(PR_SET_PDEATHSIG, SIGTERM);
#endif
  if (memory)
    ::setrlimit(RLIMIT_DATA, memory);
  if (::chdir(folder) == 0)
    ::execv(words[0], words);
  const char* const why = std::strerror(errno);
  const ssize_t written = ::write(2, why, std::strlen(why));
  static_cast<void>(written);
  ::_exit(cannot_be_run);
}

} // namespace

Child::Child(const std::vector<std::string>& command, const std::string& folder, const std::string& out,
             const std::string& errors, const Limits& limits)
    : limits_(limits)
    , start_(std::chrono::steady_clock::now()) {
  std::vector<char*> words;
  for (const std::string& word : command)
    words.push_back(const_cast<char*>(word.c_str())); // it is not written to
  words.push_back(nullptr);
  const rlim_t bytes = rlim_t(limits.memory * (1 << 20));
  const rlimit memory = {bytes, bytes};
  const int out_file = open_to_write(out), error_file = open_to_write(errors);
  process_ = ::fork();
  if (process_ == 0)
    become(words.data(), folder.c_str(), out_file, error_file, limits.memory > 0 ? &memory : nullptr);
  const int reason = errno;
  ::close(out_file);
  ::close(error_file);
  if (process_ < 0)
    throw tubular::Meshing_error(std::string("No process can be started (") + std::strerror(reason) +
                                 "): use fewer --jobs.");
  ::setpgid(process_, process_); // whichever of the two is first
}

Child::~Child() {
  if (process_ <= 0)
    return;
  kill_all();
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR)
    ;
}

void Child::kill_all() const {
  ::kill(-process_, SIGKILL);
}

std::optional<Child_status> Child::poll() {
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  siginfo_t info = {};
  if (::waitid(P_PID, id_t(process_), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == 0) {
    if (limits_.seconds > 0 && seconds > limits_.seconds && !timed_out_) {
      timed_out_ = true;
      kill_all();
    }
    return std::nullopt;
  }
  kill_all(); // what it may have left; the group is there until the process has been waited for
  int status = 0;
  rusage usage = {};
  const pid_t ended = ::wait4(process_, &status, 0, &usage);
  process_ = -1;
  const int code = ended < 0 ? cannot_be_run : WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
  return Child_status{code, timed_out_, seconds, double(usage.ru_maxrss) / 1024};
}
