// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_STAGE_CLOCK_H
#define TUBULAR_MESH_STAGE_CLOCK_H

#include <sys/resource.h>
#include <unistd.h>

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <functional>
#include <string>
#include <utility>
#include <vector>

/* Times the stages of a run and shows them as they go: on a terminal one line that changes, elsewhere a line a stage.
 * An observer receives the name of each as it begins; what it throws ends the run. */
class Stage_clock {
public:
  typedef std::function<void(const std::string&)> Observer;

  explicit Stage_clock(bool quiet, Observer observer = Observer())
      : quiet_(quiet)
      , observer_(std::move(observer))
      , terminal_(isatty(STDERR_FILENO) != 0)
      , start_(Clock::now()) {}
  ~Stage_clock() { end_line(); }

  // Ends the stage before, if any, and begins this one.
  void begin(const std::string& stage) {
    finish();
    stage_ = stage;
    stage_start_ = Clock::now();
    if (!quiet_ && terminal_)
      std::fprintf(stderr, "\r\033[K%8.2f s  %s …", seconds(start_), stage_.c_str());
    if (observer_)
      observer_(stage);
  }

  void finish() {
    if (stage_.empty())
      return;
    add(stage_, seconds(stage_start_));
    if (!quiet_ && !terminal_)
      std::fprintf(stderr, "%8.2f s  %s\n", seconds(start_), stage_.c_str());
    stage_.clear();
    end_line();
  }

  // Ends the run: times stay as they are, and the observer is let go.
  void stop() {
    finish();
    total_ = seconds(start_);
    observer_ = nullptr;
  }
  // The stages before are part of this run: of a surface or a model that was made earlier.
  void continue_from(const Stage_clock& before) {
    stages_ = before.stages_;
    start_ -= std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(before.total()));
  }

  double total() const { return total_ > 0 ? total_ : seconds(start_); }
  const std::vector<std::pair<std::string, double>>& stages() const { return stages_; }

  static std::size_t peak_memory() {
    rusage usage = {};
    getrusage(RUSAGE_SELF, &usage);
    return std::size_t(usage.ru_maxrss) * 1024;
  }

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds(Clock::time_point since) { return std::chrono::duration<double>(Clock::now() - since).count(); }
  // A stage that comes again, on another attempt, adds up.
  void add(const std::string& stage, double time) {
    for (auto& s : stages_)
      if (s.first == stage) {
        s.second += time;
        return;
      }
    stages_.emplace_back(stage, time);
  }
  void end_line() const {
    if (!quiet_ && terminal_)
      std::fprintf(stderr, "\r\033[K");
  }

  bool quiet_;
  Observer observer_;
  bool terminal_;
  Clock::time_point start_, stage_start_;
  double total_ = 0; // of a run that has stopped
  std::string stage_;
  std::vector<std::pair<std::string, double>> stages_;
};

#endif // TUBULAR_MESH_STAGE_CLOCK_H
