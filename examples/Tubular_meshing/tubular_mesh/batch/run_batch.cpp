// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "run_batch.h"

#include "../../command_line/Stop_signals.h"
#include "Batch_progress.h"
#include "Batch_row.h"
#include "Digest.h"
#include "Job.h"
#include "Job_run.h"
#include "Results_lock.h"
#include "write_index.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>
#include <CGAL/Tubular_meshing/base/interruption.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <list>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace tubular = CGAL::Tubular_meshing;
namespace fs = std::filesystem;

namespace {

typedef std::chrono::steady_clock Clock;

void check_batch(const Options& o) {
  if (o.output.empty())
    throw tubular::Parameter_error("--batch needs --output, the folder of the results; see --help.");
  if (o.dry_run)
    throw tubular::Parameter_error("--dry-run is for one surface: leave it or --batch away.");
  std::error_code ignored;
  if (!fs::exists(o.batch.surfaces, ignored))
    throw tubular::Input_error("There is no folder or table \"" + o.batch.surfaces + "\".");
}

void make_results_folder(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw tubular::Parameter_error("The folder \"" + folder + "\" cannot be made for the results: " + error.message() +
                                   ".");
}

/* The rows of a batch with what is asked for of each. */
class Batch {
public:
  Batch(const Options& options, const std::string& version)
      : options_(options) {
    for (const Batch_row& row : read_rows(options))
      jobs_.emplace_back(row, options, "tubular_mesh " + version);
  }

  const Options& options() const { return options_; }
  const std::vector<Job>& jobs() const { return jobs_; }

  const Job& job_of_status(const std::string& status_file) const {
    const std::string folder = fs::path(status_file).parent_path().string();
    for (const Job& job : jobs_)
      if (folder == batch_paths::statuses(job.row().id))
        return job;
    throw tubular::Parameter_error("--batch-step: no row has the status file \"" + status_file + "\".");
  }

  // Rows with what is there of them.
  std::vector<Indexed_row> indexed() const {
    std::vector<Indexed_row> rows;
    for (const Job& job : jobs_)
      rows.push_back(indexed_row(options_.output, job.row(), job.known()));
    return rows;
  }

private:
  const Options& options_;
  std::vector<Job> jobs_;
};

/* Runs the jobs that are not done, as many at a time as is wanted. If it is left, those at work are ended. */
class Batch_run {
public:
  Batch_run(const Batch& batch, const std::string& version, const std::string& program)
      : batch_(batch)
      , program_(program)
      , rows_(batch.indexed()) {
    for (std::size_t k = 0; k < batch.jobs().size(); ++k)
      if (!batch.jobs()[k].is_done()) {
        waiting_.push_back(k);
        rows_[k] = indexed_row(options().output, batch.jobs()[k].row(), std::nullopt); // of what it was made before
      }
    std::reverse(waiting_.begin(), waiting_.end()); // the first is at the end
    const std::size_t cores = (std::max)(std::thread::hardware_concurrency(), 1U);
    jobs_ = options().batch.jobs > 0 ? std::size_t(options().batch.jobs) : cores;
    const std::size_t at_a_time = (std::max)((std::min)(jobs_, waiting_.size()), std::size_t(1));
    threads_ = options().threads > 0 ? options().threads : int((std::max)(cores / at_a_time, std::size_t(1)));
    progress_ = std::make_unique<Batch_progress>(options(), version, rows_.size(), rows_.size() - waiting_.size());
  }

  void run() {
    const auto step = std::chrono::milliseconds(20);
    try {
      write();
      while (!waiting_.empty() || !running_.empty()) {
        tubular::internal::check_interruption();
        start();
        if (!collect())
          std::this_thread::sleep_for(step);
        show();
      }
      write();
    } catch (const command_line::Interrupted& e) {
      end_all();
      progress_->finish(128 + e.signal, "Interrupted.");
      write();
      throw;
    } catch (const std::exception& e) {
      end_all();
      progress_->finish(command_line::status_of(e), command_line::explanation_of(e));
      throw;
    }
    end_all();
    progress_->finish(status(), summary(rows_));
  }

  command_line::Exit_status status() const {
    const bool all =
        std::all_of(rows_.begin(), rows_.end(), [](const auto& r) { return r.outcome == Indexed_row::meshed; });
    return all ? command_line::done : command_line::some_failed;
  }
  const std::vector<Indexed_row>& rows() const { return rows_; }

private:
  struct Running {
    std::size_t row;
    std::unique_ptr<Job_run> run;
  };

  const Options& options() const { return batch_.options(); }

  void start() {
    while (running_.size() < jobs_ && !waiting_.empty()) {
      const Job& job = batch_.jobs()[waiting_.back()];
      progress_->begin(job.row());
      running_.push_back(
          {waiting_.back(), std::make_unique<Job_run>(job, job.status_file(), program_, threads_, options())});
      waiting_.pop_back();
    }
  }

  // Those at work; nothing is left of them.
  void end_all() {
    running_.clear();
    std::error_code ignored;
    fs::remove(fs::path(options().output) / batch_paths::all_scratch, ignored);
  }

  // Whether any has ended.
  bool collect() {
    bool any = false;
    for (auto i = running_.begin(); i != running_.end();) {
      std::optional<Job_result> result = i->run->poll();
      if (!result) {
        ++i;
        continue;
      }
      rows_[i->row] = indexed_row(options().output, i->run->job().row(), std::move(result));
      progress_->end(rows_[i->row]);
      i = running_.erase(i);
      any = true;
    }
    const auto between_pages = std::chrono::seconds(10); // to look at while the batch goes on
    if (any && Clock::now() - written_ > between_pages)
      write();
    return any;
  }

  void show() {
    std::vector<std::string> names;
    for (const Running& r : running_)
      names.push_back(r.run->job().row().name);
    progress_->show(names);
  }

  void write() {
    write_index(options().output, options().batch.surfaces, rows_);
    written_ = Clock::now();
  }

  const Batch& batch_;
  std::string program_;
  std::size_t jobs_;
  int threads_;
  std::vector<Indexed_row> rows_; // as the jobs
  std::vector<std::size_t> waiting_;
  std::list<Running> running_;
  std::unique_ptr<Batch_progress> progress_;
  Clock::time_point written_;
};

// What a workflow has to know: which rows there are, and what makes their status files others.
void print_plan(const Batch& batch) {
  Json rows = Json::array(), shown = Json::array();
  for (const Job& job : batch.jobs()) {
    rows.push_back({{"id", job.row().id}, {"name", job.row().name}, {"status_file", job.status_file()}});
    shown.push_back({job.row().name, job.row().given, job.row().options, job.row().shown});
  }
  const auto replace = Json::error_handler_t::replace;
  const Json plan = {{"rows", rows},
                     {"pages", {batch_paths::index_page, batch_paths::index_table}},
                     {"shown", digest(shown.dump(-1, ' ', false, replace))}};
  std::printf("%s\n", plan.dump(1, ' ', false, replace).c_str());
}

// Of one row, whatever becomes of it: its status file tells.
void make_row(const Batch& batch, const std::string& status_file, const std::string& program) {
  const Job& job = batch.job_of_status(status_file);
  const auto step = std::chrono::milliseconds(20);
  make_results_folder(batch.options().output);
  Job_run run(job, status_file, program, (std::max)(batch.options().threads, 1), batch.options());
  for (;;) {
    tubular::internal::check_interruption();
    if (const std::optional<Job_result> result = run.poll()) {
      std::printf("%s: %s\n", job.row().id.c_str(), result->status() == 0 ? "meshed" : result->sentence().c_str());
      return;
    }
    std::this_thread::sleep_for(step);
  }
}

void print_summary(const Options& o, const std::vector<Indexed_row>& rows) {
  if (o.quiet)
    return;
  std::printf("%s; see %s\n", summary(rows).c_str(),
              (fs::absolute(o.output) / batch_paths::index_page).lexically_normal().c_str());
  if (std::fflush(stdout) != 0)
    throw tubular::Output_error("The summary cannot be printed; the files are written.");
}

void take_step(const Batch& batch, const std::string& program) {
  const Options& o = batch.options();
  if (o.batch.step == "plan") {
    print_plan(batch);
  } else if (o.batch.step == "index") {
    make_results_folder(o.output);
    const std::vector<Indexed_row> rows = batch.indexed();
    write_index(o.output, o.batch.surfaces, rows);
    print_summary(o, rows);
  } else {
    make_row(batch, o.batch.step, program);
  }
}

} // namespace

command_line::Exit_status run_batch(const Options& options, const std::string& version, const std::string& program) {
  check_batch(options);
  if (!options.batch.step.empty()) { // what takes steps sees to it that no two are the same
    take_step(Batch(options, version), program);
    return command_line::done;
  }
  read_rows(options); // what is wrong with them leaves no folder
  make_results_folder(options.output);
  const Results_lock lock(options.output);
  std::error_code ignored;
  fs::remove_all(fs::path(options.output) / batch_paths::all_scratch, ignored); // of a batch that was killed
  const Batch batch(options, version);
  Batch_run run(batch, version, program);
  run.run();
  print_summary(options, run.rows());
  return run.status();
}
