// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef COMMAND_LINE_RUN_TOOL_H
#define COMMAND_LINE_RUN_TOOL_H

#include "Stop_signals.h"
#include "exit_status.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <exception>
#include <string>
#include <type_traits>

/* What all the command-line tools have in common. */
namespace command_line {

// Prints one line, whatever the sentence holds.
inline int fail(const CLI::App& app, std::string sentence, Exit_status status) {
  std::replace(sentence.begin(), sentence.end(), '\n', ' ');
  std::fprintf(stderr, "%s: %s\n", app.get_name().c_str(), sentence.c_str());
  return status;
}

inline void replace_first(std::string& text, const std::string& words, const std::string& by) {
  const std::size_t at = text.find(words);
  if (at != std::string::npos)
    text.replace(at, words.size(), by);
}

// What the option parser says, in plain words, as a sentence.
inline std::string sentence_of(const CLI::ParseError& e) {
  std::string text = e.what();
  if (e.get_name() == "ArgumentMismatch") {
    const bool too_many = text.find("At Most") != std::string::npos;
    text = text.substr(0, text.find(':')) + (too_many ? " is given more than once" : " needs a value");
  } else if (e.get_name() == "RequiresError") {
    replace_first(text, " requires ", " needs ");
  } else if (e.get_name() == "ExcludesError") {
    replace_first(text, " excludes ", " cannot go with ");
  } else if (e.get_name() == "ValidationError") {
    replace_first(text, ": Value ", ": ");
    replace_first(text, " not in ", " is not in ");
  }
  if (!text.empty())
    text[0] = char(std::toupper(static_cast<unsigned char>(text[0])));
  return text + "; see --help.";
}

/* Parses the command line and runs, which may return a status that is not 0; whatever is thrown becomes one sentence and
 * the right exit status. */
template <class Run> int run_tool(CLI::App& app, int argc, char* argv[], const Run& run) {
  // a file too large, a reader gone: errors to report, not reasons to be killed
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    if (e.get_exit_code() == 0) // --help and --version
      return app.exit(e);
    return fail(app, sentence_of(e), wrong_usage);
  }
  try {
    if constexpr (std::is_void_v<decltype(run())>)
      run();
    else
      return run();
    return done;
  } catch (const Interrupted& e) {
    fail(app, "Interrupted; nothing was written.", failed);
    end_by(e.signal);
  } catch (const std::exception& e) {
    return fail(app, explanation_of(e), status_of(e));
  }
}

} // namespace command_line

#endif // COMMAND_LINE_RUN_TOOL_H
