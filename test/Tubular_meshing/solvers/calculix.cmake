# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes a surface of the given SHAPE, the mesh of its wall, and has CalculiX press on it: a straight tube must move as
# Lame says.

find_program(CCX ccx)
if(NOT CCX)
  message("Skipped: there is no CalculiX (Debian: calculix-ccx)")
  return()
endif()
if(NOT PYTHON)
  message("Skipped: there is no Python 3")
  return()
endif()

file(REMOVE_RECURSE ${FOLDER})
file(MAKE_DIRECTORY ${FOLDER})
execute_process(COMMAND ${GENERATOR} ${SHAPE} --resolution 24 -o ${FOLDER}/surface.stl RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "no surface: ${result}")
endif()
execute_process(
  COMMAND ${MESHER} ${FOLDER}/surface.stl ${FOLDER}/wall.inp 24
  RESULT_VARIABLE result
  ERROR_VARIABLE error)
if(error MATCHES "built without LEMON")
  message("Skipped: ${error}")
  return()
endif()
if(NOT result EQUAL 0)
  message(FATAL_ERROR "no mesh: ${error}")
endif()
set(options "")
if(SHAPE STREQUAL "tube")
  set(options --lame)
endif()
execute_process(COMMAND ${PYTHON} ${SCRIPT} ${FOLDER}/wall.inp --folder ${FOLDER} ${options} RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "calculix_wall.py ended with ${result}")
endif()
