// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// Programs beside the project's own, that tests use where they are installed.

#ifndef TUBULAR_MESHING_TEST_INSTALLED_PROGRAMS_H
#define TUBULAR_MESHING_TEST_INSTALLED_PROGRAMS_H

#include <cstdlib>
#include <filesystem>
#include <string>
#include <sys/wait.h>
#include <vector>

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

constexpr int lacks_packages = 77; // what a script returns where Python lacks what it imports

/* Runs a Python script of this folder; all it says goes into a file. Returns its exit status, lacks_packages also where
 * there is no Python, and -1 if it crashed. */
inline int run_script(const std::string& name, const std::vector<std::string>& arguments, const std::string& log) {
  const std::filesystem::path script =
      std::filesystem::path(TUBULAR_MESHING_DATA).parent_path() / "test/Tubular_meshing" / name;
  if (!std::filesystem::exists("/usr/bin/python3"))
    return lacks_packages;
  std::string command = "/usr/bin/python3 '" + script.string() + "'";
  for (const std::string& argument : arguments)
    command += " '" + argument + "'";
  const int status = std::system((command + " > '" + log + "' 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

#endif // TUBULAR_MESHING_TEST_INSTALLED_PROGRAMS_H
