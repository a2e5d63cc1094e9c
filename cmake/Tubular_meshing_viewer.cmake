# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# TUBULAR_MESHING_VIEWER_SOURCE: the script of viewer/ as a C++ source, made while the program is built, by npm. Where
# npm is not there, or cannot get the packages of the lock file, it is empty, and reports have still pictures alone.

option(TUBULAR_MESHING_WITH_VIEWER "Show meshes in 3D in reports .html, where npm is found" ON)

set(viewer_dir ${PROJECT_SOURCE_DIR}/viewer)
set(viewer_build_dir ${PROJECT_BINARY_DIR}/viewer)
set(TUBULAR_MESHING_VIEWER_SOURCE ${viewer_build_dir}/viewer_bundle.cpp CACHE INTERNAL "")

find_program(TUBULAR_MESHING_NPM npm)
find_program(TUBULAR_MESHING_NODE NAMES node nodejs)
mark_as_advanced(TUBULAR_MESHING_NPM TUBULAR_MESHING_NODE)

set(viewer_command ${CMAKE_COMMAND} -D SOURCE_DIR=${viewer_dir} -D BUILD_DIR=${viewer_build_dir} -D
                   RESULT=${TUBULAR_MESHING_VIEWER_SOURCE})
if(TUBULAR_MESHING_WITH_VIEWER AND TUBULAR_MESHING_NPM AND TUBULAR_MESHING_NODE)
  list(APPEND viewer_command -D NPM=${TUBULAR_MESHING_NPM} -D NODE=${TUBULAR_MESHING_NODE})
endif()
file(GLOB viewer_files CONFIGURE_DEPENDS ${viewer_dir}/src/*.js)
list(APPEND viewer_files ${viewer_dir}/build.mjs ${viewer_dir}/package.json ${viewer_dir}/package-lock.json)
add_custom_command(
  OUTPUT ${TUBULAR_MESHING_VIEWER_SOURCE}
  COMMAND ${viewer_command} -P ${CMAKE_CURRENT_LIST_DIR}/bundle_viewer.cmake
  DEPENDS ${viewer_files} ${CMAKE_CURRENT_LIST_DIR}/bundle_viewer.cmake
  COMMENT "Bundling the viewer of reports"
  VERBATIM)

# What could not be made is tried again after each run of CMake.
if(EXISTS ${TUBULAR_MESHING_VIEWER_SOURCE})
  file(SIZE ${TUBULAR_MESHING_VIEWER_SOURCE} viewer_size)
  if(viewer_size LESS 10000)
    file(REMOVE ${TUBULAR_MESHING_VIEWER_SOURCE})
  endif()
endif()
