// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenFOAM's programs on a case of the least that they want; tests are skipped where these are not installed.

#ifndef TUBULAR_MESHING_TEST_OPENFOAM_CASE_H
#define TUBULAR_MESHING_TEST_OPENFOAM_CASE_H

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

inline bool has_program(const std::string& name) {
  return std::system(("command -v " + name + " > /dev/null 2>&1").c_str()) == 0;
}

inline void make_openfoam_case(const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder / "system");
  const auto begin = [&](const std::string& object) {
    std::ofstream out(folder / "system" / object);
    out << "FoamFile { version 2.0; format ascii; class dictionary; object " << object << "; }\n";
    return out;
  };
  begin("controlDict")
      << "application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;\n"
         "writeControl timeStep; writeInterval 1; writePrecision 16;\n";
  begin("fvSchemes") << "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }\n"
                        "divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }\n"
                        "interpolationSchemes { default linear; } snGradSchemes { default corrected; }\n";
  begin("fvSolution") << "solvers {}\n";
}

// Runs a program of OpenFOAM in a folder; what it says goes into a file. Debian's needs to be told where its own files
// are, unless the environment says so.
inline bool run_openfoam(const std::string& command, const std::filesystem::path& folder, const std::string& log) {
  const std::string line = "cd '" + folder.string() +
                           "' && WM_PROJECT_DIR=\"${WM_PROJECT_DIR:-/usr/share/openfoam}\" " + command + " > '" + log +
                           "' 2>&1";
  return std::system(line.c_str()) == 0;
}

#endif // TUBULAR_MESHING_TEST_OPENFOAM_CASE_H
