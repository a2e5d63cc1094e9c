// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "Batch_progress.h"

#include "../terminal.h"

#include <CGAL/Tubular_meshing/base/exceptions.h>

#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

Batch_progress::Batch_progress(const Options& o, const std::string& version, std::size_t rows, std::size_t kept)
    : is_quiet_(o.quiet || o.log_json == "-")
    , shows_line_(!is_quiet_ && isatty(STDERR_FILENO) != 0)
    , rows_(rows)
    , kept_(kept) {
  if (!o.log_json.empty()) {
    log_.reset(o.log_json == "-" ? stderr : std::fopen(o.log_json.c_str(), "w"));
    if (!log_)
      throw CGAL::Tubular_meshing::Parameter_error("The file \"" + o.log_json +
                                                   "\" cannot be written; check its directory and its permissions.");
  }
  log({{"event", "begin"},
       {"program", "tubular_mesh " + version},
       {"input", o.batch.surfaces},
       {"output", o.output},
       {"surfaces", rows},
       {"kept", kept}});
  if (!is_quiet_ && kept > 0)
    std::fprintf(stderr, "%zu of %zu surfaces are done already\n", kept, rows);
}

void Batch_progress::begin(const Batch_row& row) {
  log({{"event", "surface"}, {"name", row.name}, {"id", row.id}});
}

void Batch_progress::end(const Indexed_row& row) {
  const Job_result& result = *row.result;
  ++done_;
  failed_ += result.status() != 0;
  log({{"event", "surface_end"},
       {"name", row.row.name},
       {"id", row.row.id},
       {"status", result.status()},
       {"sentence", result.sentence()},
       {"seconds", result.json["seconds"]}});
  if (is_quiet_ && result.status() == 0)
    return;
  clear();
  double cells = 0;
  for (const char* kind : {"tetrahedra", "pyramids", "prisms", "hexahedra"})
    cells += row.values.value(kind, 0.);
  if (log_ && log_.get() == stderr) // it has said so
    return;
  if (result.status() != 0)
    std::fprintf(stderr, "%zu/%zu  %s: failed. %s\n", kept_ + done_, rows_, row.row.name.c_str(),
                 result.sentence().c_str());
  else
    std::fprintf(stderr, "%zu/%zu  %s: %.0f cells, %.1f s\n", kept_ + done_, rows_, row.row.name.c_str(), cells,
                 result.json.value("seconds", 0.));
}

void Batch_progress::show(const std::vector<std::string>& names) {
  const auto step = std::chrono::milliseconds(500);
  if (!shows_line_ || Clock::now() - shown_ < step)
    return;
  shown_ = Clock::now();
  std::string text = std::to_string(kept_ + done_) + " of " + std::to_string(rows_) + " done, " +
                     std::to_string(failed_) + " failed, " + duration(elapsed());
  if (done_ > 0) {
    const double left = elapsed() / double(done_) * double(rows_ - kept_ - done_);
    text += ", about " + duration(left) + " left";
  }
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "; at work: " : ", ") + names[i];
  show_in_line(text);
  is_line_shown_ = true;
}

void Batch_progress::finish(int status, const std::string& sentence) {
  clear();
  log({{"event", "end"}, {"status", status}, {"sentence", sentence}, {"meshed", done_ - failed_}, {"failed", failed_}});
}

// One object a line, which is there at once for who reads along.
void Batch_progress::log(Json event) {
  if (!log_)
    return;
  event["elapsed"] = std::round(1000 * elapsed()) / 1000;
  const std::string line = event.dump(-1, ' ', false, Json::error_handler_t::replace) + "\n";
  std::fwrite(line.data(), 1, line.size(), log_.get());
  std::fflush(log_.get());
}

void Batch_progress::clear() {
  if (is_line_shown_)
    show_in_line("");
  is_line_shown_ = false;
}
