// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_PROCESS_H
#define TUBULAR_MESHING_TEST_TOOL_PROCESS_H

// A command-line tool in a child process with limits: what it says, and which files it leaves.

#include <gtest/gtest.h>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace tool_test {

namespace fs = std::filesystem;
typedef std::vector<std::string> Arguments;

inline Arguments operator+(Arguments a, const Arguments& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// --- child processes ---

struct Limits {
  int seconds = 120;                // then it is killed, which no test forgives
  rlim_t file_size = RLIM_INFINITY; // as on a disk of which so many bytes are left
};

enum Exit_status { done = 0, usage = 2, input = 3, meshing = 4 };

struct Outcome {
  int status = -1; // -1: it did not exit, but was killed
  std::string killed_by, out, err;
};

class Child_process {
public:
  Child_process(const std::string& program, const Arguments& arguments, const fs::path& directory,
                const Limits& limits) {
    std::vector<char*> argv = {const_cast<char*>(program.c_str())};
    for (const std::string& a : arguments)
      argv.push_back(const_cast<char*>(a.c_str()));
    argv.push_back(nullptr);
    for (auto& pipe_ends : pipes_)
      if (pipe(pipe_ends) != 0)
        throw std::runtime_error("no pipe");
    id_ = fork();
    if (id_ < 0)
      throw std::runtime_error("no process");
    if (id_ == 0)
      become(argv.data(), directory.c_str(), limits);
    for (auto& pipe_ends : pipes_)
      close(pipe_ends[1]);
    deadline_ = Clock::now() + std::chrono::seconds(limits.seconds);
  }

  Outcome wait() {
    Outcome outcome;
    const bool in_time = read_all(outcome);
    if (!in_time)
      kill(id_, SIGKILL);
    for (auto& pipe_ends : pipes_)
      close(pipe_ends[0]);
    int status = 0;
    waitpid(id_, &status, 0);
    if (WIFEXITED(status))
      outcome.status = WEXITSTATUS(status);
    else
      outcome.killed_by = in_time ? "signal " + std::to_string(WTERMSIG(status)) : std::string("the test's time limit");
    return outcome;
  }

private:
  typedef std::chrono::steady_clock Clock;

  [[noreturn]] void become(char** argv, const char* directory, const Limits& limits) {
    dup2(pipes_[0][1], STDOUT_FILENO);
    dup2(pipes_[1][1], STDERR_FILENO);
    for (auto& pipe_ends : pipes_)
      for (int end : pipe_ends)
        close(end);
    const rlimit file_size = {limits.file_size, limits.file_size}, no_core = {0, 0};
    if (limits.file_size != RLIM_INFINITY)
      setrlimit(RLIMIT_FSIZE, &file_size);
    setrlimit(RLIMIT_CORE, &no_core);
    if (chdir(directory) == 0)
      execv(argv[0], argv);
    _exit(127);
  }

  // Until both pipes are closed; false if time is up before.
  bool read_all(Outcome& outcome) {
    std::string* const texts[2] = {&outcome.out, &outcome.err};
    pollfd open_ends[2] = {{pipes_[0][0], POLLIN, 0}, {pipes_[1][0], POLLIN, 0}};
    while (open_ends[0].fd >= 0 || open_ends[1].fd >= 0) {
      const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline_ - Clock::now()).count();
      if (left <= 0 || poll(open_ends, 2, int(left)) == 0)
        return false;
      for (int i = 0; i < 2; ++i)
        if (open_ends[i].fd >= 0 && open_ends[i].revents != 0) {
          char chunk[4096];
          const ssize_t n = read(open_ends[i].fd, chunk, sizeof chunk);
          if (n > 0)
            texts[i]->append(chunk, std::size_t(n));
          else
            open_ends[i].fd = -1; // which poll() ignores
        }
    }
    return true;
  }

  pid_t id_ = -1;
  int pipes_[2][2]; // of stdout and of stderr, each to read and to write
  Clock::time_point deadline_;
};

// --- what the tool says ---

inline std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);)
    lines.push_back(line);
  return lines;
}

// Of a line that tells of a stage done: its name; empty for any other line.
inline std::string stage_in(const std::string& line) {
  static const std::regex progress(" *[0-9]+\\.[0-9][0-9] s  (.+)");
  std::smatch match;
  return std::regex_match(line, match, progress) ? match[1].str() : std::string();
}

inline std::vector<std::string> stages_of(const Outcome& outcome) {
  std::vector<std::string> stages;
  for (const std::string& line : lines_of(outcome.err))
    if (!stage_in(line).empty())
      stages.push_back(stage_in(line));
  return stages;
}

// What stands on stderr beside progress.
inline std::vector<std::string> complaints(const Outcome& outcome) {
  std::vector<std::string> result;
  for (const std::string& line : lines_of(outcome.err))
    if (stage_in(line).empty())
      result.push_back(line);
  return result;
}

// It begins with a capital, or an option, and has one full stop, at the end.
inline bool is_a_sentence(const std::string& s) {
  return std::regex_match(s, std::regex("([A-Z]|--).*\\.")) && !std::regex_search(s, std::regex("\\. [A-Z]"));
}

inline void expect_one_sentence(const Outcome& outcome, const Arguments& mentioned) {
  const std::vector<std::string> said = complaints(outcome);
  ASSERT_EQ(said.size(), 1u) << outcome.err;
  const std::string prefix = "tubular_mesh: ";
  ASSERT_EQ(said[0].compare(0, prefix.size(), prefix), 0) << said[0];
  EXPECT_TRUE(is_a_sentence(said[0].substr(prefix.size()))) << said[0];
  EXPECT_LT(said[0].size(), 500u) << said[0];
  for (const std::string& word : mentioned)
    EXPECT_NE(said[0].find(word), std::string::npos) << "no mention of \"" << word << "\" in: " << said[0];
}

// --- files ---

inline std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream out;
  out << in.rdbuf();
  return out.str();
}

// All that is in a directory, with the sizes of files: a leftover or a changed file shows.
inline std::set<std::string> listing(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string() +
                 (entry.is_regular_file() ? " " + std::to_string(entry.file_size()) : std::string()));
  return names;
}

inline std::set<std::string> names_in(const fs::path& directory) {
  std::set<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory))
    names.insert(entry.path().filename().string());
  return names;
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_PROCESS_H
