# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The packages that the library's headers need, found alike by this project and by the installed
# Tubular_meshingConfig.cmake. After it, Tubular_meshing_dependency_targets lists what to link.

include(CMakeFindDependencyMacro)
option(TUBULAR_MESHING_WITH_TBB "Use oneTBB, where it is found, for CGAL's Parallel_tag" ON)

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
