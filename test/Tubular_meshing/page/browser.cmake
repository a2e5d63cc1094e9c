# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Runs test_page.mjs, if there is what it needs.

if(NOT NODE)
  message("Skipped: needs Node.js and npm")
  return()
endif()
if(NOT CHROMIUM)
  message("Skipped: needs a browser (Debian: chromium)")
  return()
endif()
file(SIZE ${BUNDLE} size)
if(size LESS 10000)
  message("Skipped: the program was built without the viewer, as npm could not get its packages")
  return()
endif()
set(ENV{TOOL} ${TOOL})
set(ENV{CHROMIUM} ${CHROMIUM})
set(ENV{SURFACE} ${DATA}/aortic_arch.stl)
set(ENV{CENTERLINES} ${DATA}/aortic_arch_centerlines.vtk)
set(ENV{FOLDER} ${FOLDER})
execute_process(COMMAND ${NODE} --test ${CMAKE_CURRENT_LIST_DIR}/test_page.mjs RESULT_VARIABLE failed)
if(failed)
  message(FATAL_ERROR "The page does not do what it has to.")
endif()
