# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# Makes hexahedra in a straight tube and has OpenFOAM's simpleFoam compute the flow through them: shear stress and
# pressure drop must be Poiseuille's.

include(${CMAKE_CURRENT_LIST_DIR}/steps.cmake)
find_program(SIMPLEFOAM simpleFoam)
needs(SIMPLEFOAM "OpenFOAM (Debian: openfoam)")
needs(PYTHON "Python 3")

make_surface(tube --resolution 48)
make_mesh(${TOOL} ${FOLDER}/surface.stl --quiet -t hexahedral --hex-fallback none -n 24 --boundary-layer-prisms 4
          --first-height 0.0485 --format openfoam -o ${FOLDER}/case/constant/polyMesh)
judge(OpenFOAM ${FOLDER}/case --poiseuille)
