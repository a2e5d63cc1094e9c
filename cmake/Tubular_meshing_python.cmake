# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The Python for which the package is built, TUBULAR_MESHING_PYTHON: the first of these that has NumPy. And whether the
# package is built by default: where pybind11 and Python's headers are there.

if(NOT TUBULAR_MESHING_PYTHON)
  foreach(candidate IN ITEMS python3 /usr/bin/python3)
    execute_process(COMMAND ${candidate} -c "import numpy, sys; print(sys.executable)" RESULT_VARIABLE failed
                    OUTPUT_VARIABLE executable OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(NOT failed)
      set(TUBULAR_MESHING_PYTHON ${executable} CACHE FILEPATH "The Python for which the package is built")
      break()
    endif()
  endforeach()
endif()

set(TUBULAR_MESHING_PYTHON_DEFAULT OFF)
if(TUBULAR_MESHING_PYTHON AND CMAKE_SOURCE_DIR STREQUAL PROJECT_SOURCE_DIR)
  set(Python_EXECUTABLE ${TUBULAR_MESHING_PYTHON})
  set(PYBIND11_FINDPYTHON ON)
  find_package(Python COMPONENTS Interpreter Development.Module QUIET)
  find_package(pybind11 2.6 CONFIG QUIET)
  if(Python_Development.Module_FOUND AND pybind11_FOUND)
    set(TUBULAR_MESHING_PYTHON_DEFAULT ON)
  endif()
endif()
