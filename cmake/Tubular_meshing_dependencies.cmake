# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The packages that the library's headers need, found alike by this project and by the installed
# Tubular_meshingConfig.cmake. After it, Tubular_meshing_dependency_targets lists what to link, and
# Tubular_meshing_format_targets those libraries whose headers a source or two alone need: those that write files,
# src/IO_libraries.cpp, and METIS, src/Partition.cpp.

include(CMakeFindDependencyMacro)
option(TUBULAR_MESHING_WITH_TETGEN "Use TetGen (AGPL), where it is found, for fill_with_tetgen()" ON)
option(TUBULAR_MESHING_WITH_LEMON "Use LEMON, where it is found, for recombine_triangles()" ON)
option(TUBULAR_MESHING_WITH_LZMA "Use liblzma, where it is found, to read VTK files that it has compressed" ON)
option(TUBULAR_MESHING_WITH_TBB "Use oneTBB, where it is found, to run on several threads" ON)
option(TUBULAR_MESHING_WITH_HDF5 "Use HDF5, where it is found, to write meshes for FEniCSx" ON)
option(TUBULAR_MESHING_WITH_CGNS "Use the CGNS library, where it is found, to write .cgns files" ON)
option(TUBULAR_MESHING_WITH_EXODUS "Use the Exodus II library, where it is found, to write .exo files" ON)
option(TUBULAR_MESHING_WITH_METIS "Use METIS, where it is found, to divide meshes into parts" ON)

find_dependency(CGAL 5.5)
find_dependency(Eigen3 3.3.7)
include(CGAL_Eigen3_support)
find_dependency(ZLIB)
find_dependency(pugixml)

set(Tubular_meshing_dependency_targets CGAL::CGAL CGAL::Eigen3_support ZLIB::ZLIB)
# pugixml 1.11 renamed its target and kept the old name as an alias only when asked to.
if(TARGET pugixml::pugixml)
  list(APPEND Tubular_meshing_dependency_targets pugixml::pugixml)
else()
  list(APPEND Tubular_meshing_dependency_targets pugixml)
endif()

# CONFIG: the FindTBB.cmake that CGAL 5.5 puts on the module path knows the older TBB only.
if(TUBULAR_MESHING_WITH_TBB)
  find_package(TBB QUIET CONFIG)
  include(CGAL_TBB_support)
  if(TARGET CGAL::TBB_support)
    list(APPEND Tubular_meshing_dependency_targets CGAL::TBB_support)
  endif()
endif()

# A header and a library without a CMake package of their own.
if(TUBULAR_MESHING_WITH_TETGEN)
  find_path(TETGEN_INCLUDE_DIR tetgen.h PATH_SUFFIXES tetgen)
  find_library(TETGEN_LIBRARY tet)
  mark_as_advanced(TETGEN_INCLUDE_DIR TETGEN_LIBRARY)
  if(TETGEN_INCLUDE_DIR AND TETGEN_LIBRARY)
    if(NOT TARGET Tubular_meshing_tetgen)
      add_library(Tubular_meshing_tetgen UNKNOWN IMPORTED)
      set_target_properties(
        Tubular_meshing_tetgen
        PROPERTIES IMPORTED_LOCATION "${TETGEN_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${TETGEN_INCLUDE_DIR}"
                   INTERFACE_COMPILE_DEFINITIONS CGAL_TUBULAR_MESHING_WITH_TETGEN)
    endif()
    list(APPEND Tubular_meshing_dependency_targets Tubular_meshing_tetgen)
  endif()
endif()

# Headers alone are needed: LEMON's own CMake package would want its library, and GLPK's with it.
if(TUBULAR_MESHING_WITH_LEMON)
  find_path(LEMON_INCLUDE_DIR lemon/matching.h)
  mark_as_advanced(LEMON_INCLUDE_DIR)
  if(LEMON_INCLUDE_DIR)
    if(NOT TARGET Tubular_meshing_lemon)
      add_library(Tubular_meshing_lemon INTERFACE IMPORTED)
      set_target_properties(
        Tubular_meshing_lemon
        PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${LEMON_INCLUDE_DIR}"
                   INTERFACE_COMPILE_DEFINITIONS CGAL_TUBULAR_MESHING_WITH_LEMON)
    endif()
    list(APPEND Tubular_meshing_dependency_targets Tubular_meshing_lemon)
  endif()
endif()

if(TUBULAR_MESHING_WITH_LZMA)
  find_path(LZMA_INCLUDE_DIR lzma.h)
  find_library(LZMA_LIBRARY lzma)
  mark_as_advanced(LZMA_INCLUDE_DIR LZMA_LIBRARY)
  if(LZMA_INCLUDE_DIR AND LZMA_LIBRARY)
    if(NOT TARGET Tubular_meshing_lzma)
      add_library(Tubular_meshing_lzma UNKNOWN IMPORTED)
      set_target_properties(
        Tubular_meshing_lzma
        PROPERTIES IMPORTED_LOCATION "${LZMA_LIBRARY}" INTERFACE_INCLUDE_DIRECTORIES "${LZMA_INCLUDE_DIR}"
                   INTERFACE_COMPILE_DEFINITIONS CGAL_TUBULAR_MESHING_WITH_LZMA)
    endif()
    list(APPEND Tubular_meshing_dependency_targets Tubular_meshing_lzma)
  endif()
endif()

# Libraries that write one format each, and METIS: a header and a library without a CMake package, or with one that says less.
set(Tubular_meshing_format_targets "")
macro(tubular_meshing_find_format name header folder library)
  string(TOUPPER ${name} TUBULAR_MESHING_FORMAT)
  if(TUBULAR_MESHING_WITH_${TUBULAR_MESHING_FORMAT})
    find_path(TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_INCLUDE_DIR ${header} PATH_SUFFIXES ${folder})
    find_library(TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_LIBRARY NAMES ${library} ${ARGN})
    mark_as_advanced(TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_INCLUDE_DIR
                     TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_LIBRARY)
    if(TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_INCLUDE_DIR AND TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_LIBRARY)
      if(NOT TARGET Tubular_meshing_${name})
        add_library(Tubular_meshing_${name} UNKNOWN IMPORTED)
        set_target_properties(
          Tubular_meshing_${name}
          PROPERTIES IMPORTED_LOCATION "${TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_LIBRARY}"
                     INTERFACE_INCLUDE_DIRECTORIES "${TUBULAR_MESHING_${TUBULAR_MESHING_FORMAT}_INCLUDE_DIR}"
                     INTERFACE_COMPILE_DEFINITIONS CGAL_TUBULAR_MESHING_WITH_${TUBULAR_MESHING_FORMAT})
      endif()
      list(APPEND Tubular_meshing_format_targets Tubular_meshing_${name})
    endif()
  endif()
endmacro()
tubular_meshing_find_format(hdf5 hdf5.h hdf5/serial hdf5_serial hdf5)
if(TARGET Tubular_meshing_hdf5 AND EXISTS "${TUBULAR_MESHING_HDF5_INCLUDE_DIR}/H5pubconf.h")
  file(STRINGS "${TUBULAR_MESHING_HDF5_INCLUDE_DIR}/H5pubconf.h" TUBULAR_MESHING_HDF5_IS_PARALLEL
       REGEX "^#define H5_HAVE_PARALLEL 1")
  if(TUBULAR_MESHING_HDF5_IS_PARALLEL) # its header wants that of MPI
    list(REMOVE_ITEM Tubular_meshing_format_targets Tubular_meshing_hdf5)
  endif()
endif()
tubular_meshing_find_format(cgns cgnslib.h "" cgns)
tubular_meshing_find_format(exodus exodusII.h "" exoIIv2c exodusii exodus)
tubular_meshing_find_format(metis metis.h "" metis)
