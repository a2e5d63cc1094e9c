// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef TUBULAR_MESH_TERMINAL_H
#define TUBULAR_MESH_TERMINAL_H

#include <sys/ioctl.h>
#include <unistd.h>

#include <cmath>
#include <cstddef>
#include <string>

/* What shows progress on the terminal of standard error: one line that changes. */

// Short, as it changes all the time.
inline std::string duration(double seconds) {
  const long s = std::lround(seconds);
  const auto two_digits = [](long n) { return (n < 10 ? "0" : "") + std::to_string(n); };
  return s < 60     ? std::to_string(s) + " s"
         : s < 3600 ? std::to_string(s / 60) + ":" + two_digits(s % 60) + " min"
                    : std::to_string(s / 3600) + ":" + two_digits(s / 60 % 60) + " h";
}

// Its own buffer is none: what another thread writes to the stream is not in the way, nor is a child process.
inline void write_to_terminal(const std::string& text) {
  const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
  static_cast<void>(written); // nowhere to complain
}

inline std::size_t width_of_terminal() {
  winsize size = {};
  return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col : 80;
}

// A character takes up to four bytes; they are all one column wide here.
inline std::string cut_to(std::string text, std::size_t columns) {
  std::size_t column = 0, i = 0;
  for (; i < text.size(); ++i)
    if ((text[i] & 0xC0) != 0x80 && ++column > columns)
      break;
  text.resize(i);
  return text;
}

// In place of what the line has shown; nothing clears it.
inline void show_in_line(const std::string& text) {
  write_to_terminal("\r\033[K" + cut_to(text, width_of_terminal() - 1));
}

#endif // TUBULAR_MESH_TERMINAL_H
