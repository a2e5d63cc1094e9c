# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes a surface of the given SHAPE, the mesh of its wall, and has CalculiX press on it: a straight tube must move as
# Lame says.

include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(CCX ccx)
needs(CCX "CalculiX (Debian: calculix-ccx)")
needs(PYTHON "Python 3")

make_surface(${SHAPE} --resolution 24)
make_mesh(${MESHER} ${FOLDER}/surface.stl ${FOLDER}/wall.inp 24)
set(options "")
if(SHAPE STREQUAL "tube")
  set(options --lame)
endif()
judge(CalculiX ${FOLDER}/wall.inp --folder ${FOLDER} ${options})
