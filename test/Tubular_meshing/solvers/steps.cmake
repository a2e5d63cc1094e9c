# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Steps of tests that give a mesh to a solver. They are macros: what ends a test ends the script that calls them.

# Skips the test where a program was not found: needs(VARIABLE what it is)
macro(needs variable what)
  if(NOT ${variable})
    message("Skipped: there is no ${what}")
    return()
  endif()
endmacro()

# Makes FOLDER anew, and FOLDER/surface.stl: make_surface(options of generate_tubular_surface...)
macro(make_surface)
  file(REMOVE_RECURSE ${FOLDER})
  file(MAKE_DIRECTORY ${FOLDER})
  execute_process(COMMAND ${GENERATOR} ${ARGN} -o ${FOLDER}/surface.stl RESULT_VARIABLE result)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "no surface: ${result}")
  endif()
endmacro()

# Runs a mesher: make_mesh(program options...). Skips the test where it was built without a library that it needs.
macro(make_mesh)
  execute_process(
    COMMAND ${ARGN}
    RESULT_VARIABLE result
    ERROR_VARIABLE error)
  if(error MATCHES "built without LEMON")
    message("Skipped: ${error}")
    return()
  endif()
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "no mesh: ${error}")
  endif()
endmacro()

# Runs SCRIPT, which judges what a solver makes of the mesh: judge(what it is options...)
macro(judge what)
  execute_process(COMMAND ${PYTHON} ${SCRIPT} ${ARGN} RESULT_VARIABLE result)
  if(result EQUAL 77)
    message("Skipped: ${what} does not run here")
  elseif(NOT result EQUAL 0)
    message(FATAL_ERROR "${SCRIPT} ended with ${result}")
  endif()
endmacro()
