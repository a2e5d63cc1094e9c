# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Run as a script by the tests package/*: makes the package available in one WAY and builds the consumer with it.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE result OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(NOT result EQUAL 0)
    message(FATAL_ERROR "${ARGN}\nfailed (${result}):\n${output}")
  endif()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
if(WAY STREQUAL "installed")
  run(${CMAKE_COMMAND} -D CMAKE_INSTALL_LOCAL_ONLY=ON -D CMAKE_INSTALL_PREFIX=${WORK_DIR}/prefix -P
      ${PACKAGE_BINARY_DIR}/cmake_install.cmake)
  set(package -D CMAKE_PREFIX_PATH=${WORK_DIR}/prefix)
elseif(WAY STREQUAL "build_directory")
  set(package -D Tubular_meshing_DIR=${PACKAGE_BINARY_DIR})
else()
  set(package -D TUBULAR_MESHING_INCLUDE_DIR=${PACKAGE_SOURCE_DIR}/include)
endif()

run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/build -G ${GENERATOR} -D CMAKE_CXX_COMPILER=${CXX_COMPILER}
    -D CGAL_DIR=${CGAL_DIR} ${package})
run(${CMAKE_COMMAND} --build ${WORK_DIR}/build)
run(${WORK_DIR}/build/consumer)
