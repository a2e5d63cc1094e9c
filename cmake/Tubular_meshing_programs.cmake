# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# tubular_meshing_add_program(): what examples, tests and benchmarks have in common.

add_library(tubular_meshing_program_options INTERFACE)
target_link_libraries(tubular_meshing_program_options INTERFACE CGAL::Tubular_meshing)
target_compile_options(tubular_meshing_program_options INTERFACE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra>)

# Programs reuse the library's precompiled header, and must therefore have the same flags as it has.
if(TUBULAR_MESHING_PRECOMPILED_HEADERS AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(tubular_meshing_program_options INTERFACE -fPIC -fpch-preprocess) # the latter for ccache
elseif(TUBULAR_MESHING_PRECOMPILED_HEADERS)
  target_compile_options(tubular_meshing_program_options INTERFACE -fPIC)
endif()

# One program of the given sources, linked with the library and the targets after LIBRARIES.
function(tubular_meshing_add_program name)
  cmake_parse_arguments(PARSE_ARGV 1 ARG "" "" "SOURCES;LIBRARIES")
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE tubular_meshing_program_options ${ARG_LIBRARIES})
  if(TUBULAR_MESHING_PRECOMPILED_HEADERS)
    target_precompile_headers(${name} REUSE_FROM Tubular_meshing)
  endif()
endfunction()
