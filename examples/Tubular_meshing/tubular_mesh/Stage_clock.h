// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_STAGE_CLOCK_H
#define TUBULAR_MESH_STAGE_CLOCK_H

#include <sys/resource.h>

#include <chrono>
#include <cstddef>
#include <functional>
#include <string>
#include <utility>
#include <vector>

struct Options;

/* Is told how a run goes on. */
class Stage_listener {
public:
  virtual ~Stage_listener() = default;
  virtual void begin(const std::string& stage) = 0;
  virtual void end(const std::string& stage, double seconds) = 0;

  /* What there is to do, as soon as that is known: for a surface of so many triangles, ... */
  virtual void expect_preparation(const Options& options, double triangles) = 0;
  /* ... and for so many isotropic tetrahedra, if it wants to know them: they cost a little. */
  virtual bool wants_estimate() const = 0;
  virtual void expect_meshing(const Options& options, double triangles, double tetrahedra) = 0;
};

/* Times the stages of a run. An observer receives the name of each as it begins; what it throws ends the run. */
class Stage_clock {
public:
  typedef std::function<void(const std::string&)> Observer;

  explicit Stage_clock(Observer observer = Observer(), Stage_listener* listener = nullptr)
      : observer_(std::move(observer))
      , listener_(listener)
      , start_(Clock::now()) {}

  // Ends the stage before, if any, and begins this one.
  void begin(const std::string& stage) {
    finish();
    stage_ = stage;
    stage_start_ = Clock::now();
    if (listener_)
      listener_->begin(stage);
    if (observer_)
      observer_(stage);
  }

  void finish() {
    if (stage_.empty())
      return;
    const double time = seconds(stage_start_);
    add(stage_, time);
    if (listener_)
      listener_->end(stage_, time);
    stage_.clear();
  }

  // Who follows the run; null if nobody does.
  Stage_listener* listener() const { return listener_; }

  // Ends the run: times stay as they are, and the observer is let go.
  void stop() {
    finish();
    total_ = seconds(start_);
    observer_ = nullptr;
    listener_ = nullptr;
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
  Observer observer_;
  Stage_listener* listener_;
  Clock::time_point start_, stage_start_;
  double total_ = 0; // of a run that has stopped
  std::string stage_;
  std::vector<std::pair<std::string, double>> stages_;
};

#endif // TUBULAR_MESH_STAGE_CLOCK_H
