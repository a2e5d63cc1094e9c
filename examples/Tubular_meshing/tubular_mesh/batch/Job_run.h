// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_BATCH_JOB_RUN_H
#define TUBULAR_MESH_BATCH_JOB_RUN_H

#include "../Options.h"
#include "Child.h"
#include "Job.h"

#include <chrono>
#include <memory>
#include <optional>
#include <string>

/* A job at work. All that the program writes goes into a folder of its own, which becomes that of the mesh when the program
 * has ended with status 0; if it has not, there is no mesh afterwards. The status file is written last. If the run is
 * destroyed before, nothing is left of it. */
class Job_run {
public:
  /* `status_file`: in the folder of the results, as of the job, which is there as long as this is. */
  Job_run(const Job& job, const std::string& status_file, const std::string& program, int threads,
          const Options& batch);
  Job_run(const Job_run&) = delete;
  ~Job_run();

  const Job& job() const { return job_; }

  /* Its result, once; nothing while it runs. */
  std::optional<Job_result> poll();

private:
  Job_result finish(const Child_status& ended);
  std::string results_path(const std::string& path) const { return results_ + "/" + path; }

  const Job& job_;
  std::string results_, status_file_, program_;
  double time_limit_;
  std::vector<std::string> command_;
  std::unique_ptr<Child> child_; // none where there is nothing to run
};

#endif // TUBULAR_MESH_BATCH_JOB_RUN_H
