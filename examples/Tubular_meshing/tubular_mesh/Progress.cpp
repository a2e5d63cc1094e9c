// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Progress.h"

#include "Run.h"
#include "Schedule.h"
#include "report/counts.h"
#include "report/json.h"
#include "terminal.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace tubular = CGAL::Tubular_meshing;

namespace {

typedef std::chrono::steady_clock Clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

double rounded(double seconds) {
  return std::round(1000 * seconds) / 1000;
}

// What is left, as exactly as it is known.
std::string about(double seconds) {
  const double unit = seconds < 10 ? 1 : seconds < 60 ? 5 : seconds < 600 ? 30 : 300;
  return duration((std::max)(unit * std::round(seconds / unit), 1.));
}

} // namespace

class Progress::Impl {
public:
  Impl(const Options& options, const std::string& version)
      : shows_line_(!options.quiet && isatty(STDERR_FILENO) != 0 && options.log_json != "-")
      , prints_stages_(!options.quiet && !shows_line_ && options.log_json != "-") {
    open_log(options);
    log({{"event", "begin"},
         {"program", "tubular_mesh " + version},
         {"input", options.surface},
         {"output", options.dry_run ? Json() : Json(options.output)},
         {"type", options.type},
         {"dry_run", options.dry_run}});
    if (shows_line_ || log_)
      ticker_ = std::thread([this] { tick(); });
  }

  ~Impl() {
    stop_ticker();
    clear_line();
    if (log_ && log_ != stderr)
      std::fclose(log_);
  }

  void begin(const std::string& stage) {
    const std::lock_guard<std::mutex> lock(mutex_);
    schedule_.begin(stage);
    stage_ = stage;
    stage_start_ = Clock::now();
    log(with_state({{"event", "stage"}, {"stage", stage}}));
    show_line();
  }

  void end(const std::string& stage, double seconds) {
    const std::lock_guard<std::mutex> lock(mutex_);
    schedule_.end(stage, seconds);
    stage_.clear();
    log({{"event", "stage_end"}, {"stage", stage}, {"seconds", rounded(seconds)}});
    if (prints_stages_)
      std::fprintf(stderr, "%8.2f s  %s\n", seconds_since(start_), stage.c_str());
    clear_line();
  }

  bool wants_estimate() const { return shows_line_ || log_; }

  template <class Change> void change_schedule(const Change& change) {
    const std::lock_guard<std::mutex> lock(mutex_);
    change(schedule_);
  }

  void last(Json event) {
    stop_ticker();
    const std::lock_guard<std::mutex> lock(mutex_);
    clear_line();
    log(std::move(event));
  }

  // That all of it is there: a full disk is no reason to end work, but one to say so.
  void check_log() const {
    if (log_ && std::ferror(log_) != 0)
      throw tubular::Output_error("The log of --log-json could not be written to the end, as on a full disk; the other "
                                  "files are whole.");
  }

private:
  void open_log(const Options& options) {
    if (options.log_json.empty())
      return;
    log_ = options.log_json == "-" ? stderr : std::fopen(options.log_json.c_str(), "w");
    if (!log_)
      throw tubular::Parameter_error("The file \"" + options.log_json +
                                     "\" cannot be written; check its directory and its permissions.");
  }

  // One object a line, which is there at once for who reads along.
  void log(Json event) {
    if (!log_)
      return;
    event["elapsed"] = rounded(seconds_since(start_));
    // file names need not be UTF-8
    const std::string line = event.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
    std::fwrite(line.data(), 1, line.size(), log_);
    std::fflush(log_);
  }

  Json with_state(Json event) const {
    const std::optional<Schedule::State> state = schedule_.state(stage_.empty() ? 0 : seconds_since(stage_start_));
    event["fraction"] = state ? Json(rounded(state->fraction)) : Json();
    event["remaining"] = state ? Json(rounded(state->remaining)) : Json();
    return event;
  }

  void tick() {
    const std::chrono::milliseconds step(200);
    const int steps_of_log = 5;
    std::unique_lock<std::mutex> lock(mutex_);
    for (int i = 1; !over_.wait_for(lock, step, [this] { return is_over_; }); ++i) {
      show_line();
      if (i % steps_of_log == 0 && !stage_.empty())
        log(with_state({{"event", "progress"}, {"stage", stage_}}));
    }
  }

  void stop_ticker() {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      is_over_ = true;
    }
    over_.notify_all();
    if (ticker_.joinable())
      ticker_.join();
  }

  void show_line() {
    if (!shows_line_ || stage_.empty())
      return;
    const std::optional<Schedule::State> state = schedule_.state(seconds_since(stage_start_));
    std::string line = state ? std::to_string(std::lround(100 * state->fraction)) + " %  " : "      ";
    line.insert(0, line.size() < 6 ? 6 - line.size() : 0, ' ');
    line += stage_ + ", " + duration(seconds_since(start_));
    if (state)
      line += ", about " + about(state->remaining) + " left";
    show_in_line(line);
    is_line_shown_ = true;
  }

  void clear_line() {
    if (is_line_shown_)
      show_in_line("");
    is_line_shown_ = false;
  }

  const bool shows_line_, prints_stages_;
  std::FILE* log_ = nullptr;
  Clock::time_point start_ = Clock::now(), stage_start_ = start_;
  Schedule schedule_;
  std::string stage_;
  bool is_line_shown_ = false, is_over_ = false;
  std::mutex mutex_;
  std::condition_variable over_;
  std::thread ticker_;
};

Progress::Progress(const Options& options, const std::string& version)
    : impl_(new Impl(options, version)) {}
Progress::~Progress() = default;

void Progress::begin(const std::string& stage) {
  impl_->begin(stage);
}
void Progress::end(const std::string& stage, double seconds) {
  impl_->end(stage, seconds);
}
void Progress::expect_preparation(const Options& options, double triangles) {
  impl_->change_schedule([&](Schedule& s) { s.expect_preparation(options, triangles); });
}
bool Progress::wants_estimate() const {
  return impl_->wants_estimate();
}
void Progress::expect_meshing(const Options& options, double triangles, double tetrahedra) {
  impl_->change_schedule([&](Schedule& s) { s.expect_meshing(options, triangles, tetrahedra); });
}

void Progress::finish(const Run& run) {
  const tubular::Mixed_mesh& mesh = run.cells();
  Json outputs = Json::array();
  if (!run.options.dry_run)
    for (const std::string& file : run.options.written_files())
      outputs.push_back(file);
  impl_->last({{"event", "end"},
               {"status", 0},
               {"outputs", outputs},
               {"cells", cells_by_kind(mesh.tetrahedra.size(), mesh.pyramids.size(), mesh.prisms.size(),
                                       mesh.hexahedra.size())}});
  impl_->check_log();
}

void Progress::fail(int status, const std::string& sentence) {
  impl_->last({{"event", "end"}, {"status", status}, {"sentence", sentence}});
}
