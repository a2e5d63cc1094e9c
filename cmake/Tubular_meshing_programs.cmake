# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# tubular_meshing_add_program(): what examples, tests and benchmarks have in common.

add_library(tubular_meshing_program_options INTERFACE)
target_link_libraries(tubular_meshing_program_options INTERFACE CGAL::Tubular_meshing)
target_compile_options(tubular_meshing_program_options INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra>)

# One precompiled header, made by one target and reused by the others, which must therefore have the same flags. It pays
# where there are many programs, as with the tests.
set(share_precompiled_header OFF)
if(TUBULAR_MESHING_PRECOMPILED_HEADERS AND TUBULAR_MESHING_BUILD_TESTS)
  set(share_precompiled_header ON)
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled.cpp CONTENT "")
  add_library(tubular_meshing_precompiled OBJECT ${PROJECT_BINARY_DIR}/precompiled.cpp)
  target_link_libraries(tubular_meshing_precompiled PRIVATE tubular_meshing_program_options)
  target_precompile_headers(tubular_meshing_precompiled PRIVATE ${CMAKE_CURRENT_LIST_DIR}/Tubular_meshing_precompiled.h)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(tubular_meshing_program_options INTERFACE -fpch-preprocess) # for ccache
  endif()
endif()

# One program of the given sources, linked with the library and the targets after LIBRARIES.
function(tubular_meshing_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE tubular_meshing_program_options ${ARG_LIBRARIES})
  if(share_precompiled_header)
    target_precompile_headers(${name} REUSE_FROM tubular_meshing_precompiled)
  endif()
endfunction()
