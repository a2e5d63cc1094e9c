// Copyright (c) 2026 The Tubular_meshing authors.
// SPDX-License-Identifier: GPL-3.0-or-later

// OpenFOAM's programs on a case of the least that they want; tests are skipped where these are not installed.

#ifndef TUBULAR_MESHING_TEST_OPENFOAM_CASE_H
#define TUBULAR_MESHING_TEST_OPENFOAM_CASE_H

#include "installed_programs.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

// Ten steps of icoFoam, from inlet to outlet_1.
inline void make_openfoam_case(const std::filesystem::path& folder) {
  const auto begin = [&](const char* object, const char* kind = "dictionary") {
    std::filesystem::create_directories((folder / object).parent_path());
    std::ofstream out(folder / object);
    out << "FoamFile { version 2.0; format ascii; class " << kind << "; object "
        << std::filesystem::path(object).filename().string() << "; }\n";
    return out;
  };
  begin("system/controlDict")
      << "application icoFoam; startFrom startTime; startTime 0; stopAt endTime; endTime 0.01;\n"
         "deltaT 0.001; writeControl timeStep; writeInterval 10; writePrecision 16;\n";
  begin("system/fvSchemes")
      << "ddtSchemes { default Euler; } gradSchemes { default Gauss linear; }\n"
         "divSchemes { default Gauss linear; } laplacianSchemes { default Gauss linear corrected; }\n"
         "interpolationSchemes { default linear; } snGradSchemes { default corrected; }\n";
  begin("system/fvSolution") << "solvers {\n"
                                "  p { solver PCG; preconditioner DIC; tolerance 1e-9; relTol 0; } pFinal { $p; }\n"
                                "  U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-9; relTol 0; }\n"
                                "}\nPISO { nCorrectors 2; nNonOrthogonalCorrectors 1; pRefCell 0; pRefValue 0; }\n";
  begin("constant/transportProperties") << "nu [0 2 -1 0 0 0 0] 0.1;\n";
  begin("0/U", "volVectorField")
      << "dimensions [0 1 -1 0 0 0 0]; internalField uniform (0 0 0);\n"
         "boundaryField { wall { type noSlip; } inlet { type surfaceNormalFixedValue; refValue uniform -1; }\n"
         "  outlet_1 { type zeroGradient; } }\n";
  begin("0/p", "volScalarField") << "dimensions [0 2 -2 0 0 0 0]; internalField uniform 0;\n"
                                    "boundaryField { wall { type zeroGradient; } inlet { type zeroGradient; }\n"
                                    "  outlet_1 { type fixedValue; value uniform 0; } }\n";
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
