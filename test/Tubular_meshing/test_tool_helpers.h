// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESHING_TEST_TOOL_HELPERS_H
#define TUBULAR_MESHING_TEST_TOOL_HELPERS_H

// What tests of a command-line tool need: a child process with limits, a directory for its input and one for its
// output, small surfaces with their centerlines.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Tubular_meshing/Generators/tubular_shapes.h>
#include <CGAL/Tubular_meshing/Generators/tubular_surface.h>
#include <CGAL/Tubular_meshing/IO/read_mesh.h>
#include <CGAL/Tubular_meshing/IO/write_centerlines.h>
#include <CGAL/Tubular_meshing/IO/write_surface.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tool_test {

namespace fs = std::filesystem;
namespace tubular = CGAL::Tubular_meshing;
typedef nlohmann::json Json;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef Kernel::Point_3 Point;
typedef CGAL::Surface_mesh<Point> Surface;
typedef tubular::Mixed_mesh Mesh;
typedef tubular::Centerline_polylines Centerlines;
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

// What stands on stderr beside progress, and the option parser's hint at --help.
inline std::vector<std::string> complaints(const Outcome& outcome) {
  std::vector<std::string> result;
  for (const std::string& line : lines_of(outcome.err))
    if (stage_in(line).empty() && line != "Run with --help for more information.")
      result.push_back(line);
  return result;
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

/* Directories of a test's own, for input and for output, which go when it has passed. */
class Tool : public ::testing::Test {
protected:
  void SetUp() override {
    const auto* info = ::testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(info->test_suite_name()) + "." + info->name();
    std::replace(name.begin(), name.end(), '/', '_');
    directory_ = fs::path(TUBULAR_MESHING_SCRATCH) / "test_tool" / name;
    fs::remove_all(directory_);
    fs::create_directories(directory_ / "in");
    fs::create_directories(directory_ / "out");
  }
  void TearDown() override {
    if (!HasFailure())
      fs::remove_all(directory_);
  }

public:
  std::string in(const std::string& name) const { return (directory_ / "in" / name).string(); }
  std::string out(const std::string& name) const { return (directory_ / "out" / name).string(); }
  fs::path output_directory() const { return directory_ / "out"; }

  std::string make(const std::string& name, const std::string& bytes) const {
    std::ofstream(in(name), std::ios::binary) << bytes;
    return in(name);
  }

  std::string make(const std::string& name, const Surface& surface) const {
    tubular::IO::write_surface(in(name), surface);
    return in(name);
  }

  std::string make(const std::string& name, const Centerlines& lines) const {
    tubular::IO::write_centerlines(in(name), lines);
    return in(name);
  }

  // In the directory for output, so that any file it leaves behind there is seen.
  Outcome run(const Arguments& arguments, const Limits& limits = Limits()) const {
    return Child_process(TUBULAR_MESH_TOOL, arguments, output_directory(), limits).wait();
  }

  // A run that has to succeed.
  Outcome succeed(const Arguments& arguments) const {
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.status, 0) << outcome.killed_by << "\n" << outcome.err;
    EXPECT_TRUE(complaints(outcome).empty()) << outcome.err;
    return outcome;
  }

  static Mesh mesh_in(const std::string& file) {
    Mesh mesh;
    tubular::IO::read_mesh(file, mesh);
    return mesh;
  }

  static Json json_in(const std::string& file) { return Json::parse(bytes_of(file)); }

private:
  fs::path directory_;
};

// --- input ---

struct Sample {
  Surface surface;
  Centerlines lines;
};

inline Sample sample_of(const tubular::Tubular_skeleton& skeleton) {
  Sample s;
  tubular::generate_tubular_surface(skeleton, s.surface, tubular::parameters::points_per_circumference(16));
  s.lines = tubular::centerlines_of(skeleton);
  return s;
}

// The cheapest there is: meshed in a tenth of a second.
inline Sample tube() {
  return sample_of(tubular::straight_tube(6, 1));
}

inline Sample bifurcation() {
  return sample_of(tubular::y_bifurcation());
}

template <class Transformation> Sample transformed(Sample s, const Transformation& move) {
  for (auto v : s.surface.vertices())
    s.surface.point(v) = move(s.surface.point(v));
  for (Point& p : s.lines.points)
    p = move(p);
  s.lines.radius.clear(); // of no use to the tool, and no longer true
  return s;
}

} // namespace tool_test

#endif // TUBULAR_MESHING_TEST_TOOL_HELPERS_H
