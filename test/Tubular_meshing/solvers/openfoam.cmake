# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes hexahedra in a straight tube and has OpenFOAM's simpleFoam compute the flow through them: shear stress and
# pressure drop must be Poiseuille's.

find_program(SIMPLEFOAM simpleFoam)
if(NOT SIMPLEFOAM)
  message("Skipped: there is no OpenFOAM (Debian: openfoam)")
  return()
endif()
if(NOT PYTHON)
  message("Skipped: there is no Python 3")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${GENERATOR} tube --resolution 48 -o ${FOLDER}/surface.stl RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "no surface: ${result}")
endif()
execute_process(
  COMMAND ${TOOL} ${FOLDER}/surface.stl --quiet -t hexahedral --hex-fallback none -n 24 --boundary-layer-prisms 4
          --first-height 0.0485 --format openfoam -o ${FOLDER}/case/constant/polyMesh
  RESULT_VARIABLE result
  ERROR_VARIABLE error)
if(error MATCHES "LEMON")
  message("Skipped: ${error}")
  return()
endif()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "no mesh: ${error}")
endif()
execute_process(COMMAND ${PYTHON} ${SCRIPT} ${FOLDER}/case --poiseuille RESULT_VARIABLE result)
if(result EQUAL 77)
  message("Skipped: OpenFOAM does not run here")
elseif(NOT result EQUAL 0)
  message(FATAL_ERROR "openfoam_flow.py ended with ${result}")
endif()
