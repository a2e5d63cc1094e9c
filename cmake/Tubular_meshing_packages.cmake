# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# What `cpack` makes in the build directory, of what is built: Debian packages (tubular-meshing, the program;
# libtubular-meshing-dev; python3-tubular-meshing), by `cpack -G DEB`; and an archive that runs wherever it is unpacked,
# by `cpack -G TGZ`, with the libraries that it needs beside those of every system.

set(CMAKE_SKIP_INSTALL_ALL_DEPENDENCY ON) # tests and benchmarks, which are not installed, need not be built

# The manual page and the completion of the program, from what its --help says.
find_package(Python3 COMPONENTS Interpreter QUIET)
if(TARGET tubular_mesh AND Python3_FOUND)
  set(pages ${PROJECT_BINARY_DIR}/pages)
  file(MAKE_DIRECTORY ${pages})
  set(scripts ${PROJECT_SOURCE_DIR}/scripts)
  add_custom_command(
    OUTPUT ${pages}/tubular_mesh.1 ${pages}/tubular_mesh
    COMMAND ${Python3_EXECUTABLE} -B ${scripts}/man_page.py $<TARGET_FILE:tubular_mesh> > ${pages}/tubular_mesh.1
    COMMAND ${Python3_EXECUTABLE} -B ${scripts}/bash_completion.py $<TARGET_FILE:tubular_mesh> > ${pages}/tubular_mesh
    DEPENDS tubular_mesh ${scripts}/man_page.py ${scripts}/bash_completion.py ${scripts}/options_table.py
    COMMENT "Manual page and completion of tubular_mesh"
    VERBATIM)
  add_custom_target(tubular_mesh_pages ALL DEPENDS ${pages}/tubular_mesh.1 ${pages}/tubular_mesh)
  install(FILES ${pages}/tubular_mesh.1 DESTINATION ${CMAKE_INSTALL_MANDIR}/man1 COMPONENT program)
  install(FILES ${pages}/tubular_mesh DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT program)
endif()

if(TARGET tubular_mesh)
  install(FILES ${PROJECT_SOURCE_DIR}/README.md ${PROJECT_SOURCE_DIR}/CHANGES.md
                ${PROJECT_SOURCE_DIR}/doc/Tubular_meshing/options.md
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/tubular-meshing COMPONENT program)
endif()
foreach(component_and_package "program tubular-meshing" "development libtubular-meshing-dev"
                              "python python3-tubular-meshing")
  string(REPLACE " " ";" pair "${component_and_package}")
  list(GET pair 0 component)
  list(GET pair 1 package)
  install(FILES ${PROJECT_SOURCE_DIR}/package_info/Tubular_meshing/debian_copyright
          DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} RENAME copyright COMPONENT ${component})
endforeach()

set(CPACK_PACKAGE_NAME tubular-meshing)
set(CPACK_PACKAGE_VENDOR "The Tubular_meshing authors")
set(CPACK_PACKAGE_CONTACT "The Tubular_meshing authors <tubular-meshing@localhost>")
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "Meshes of blood vessels and airways from their triangulated surface")
set(CPACK_PACKAGE_DESCRIPTION_FILE ${PROJECT_SOURCE_DIR}/package_info/Tubular_meshing/long_description.txt)
set(CPACK_RESOURCE_FILE_LICENSE ${PROJECT_SOURCE_DIR}/package_info/Tubular_meshing/license.txt)
set(CPACK_GENERATOR DEB TGZ)
set(CPACK_STRIP_FILES ON)
set(CPACK_THREADS 0)
set(CPACK_PROJECT_CONFIG_FILE ${CMAKE_CURRENT_LIST_DIR}/Tubular_meshing_cpack.cmake)
set(CPACK_COMPONENTS_GROUPING IGNORE)

set(CPACK_COMPONENTS_ALL development)
if(TARGET tubular_mesh)
  list(APPEND CPACK_COMPONENTS_ALL program)
endif()
if(TARGET tubular_meshing_python)
  list(APPEND CPACK_COMPONENTS_ALL python)
endif()

set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME tubular-meshing)
set(CPACK_DEBIAN_PROGRAM_DESCRIPTION "meshes of blood vessels and airways from their surface\n\
 tubular_mesh turns the triangulated surface of a vessel or airway tree into a\n\
 mesh for simulations of flow or of wall mechanics: of tetrahedra, hexahedra, or\n\
 both, with layers along the wall, labelled boundaries, and a wall of its own.")

# A static library has no dependencies of its own: those of the headers, as CMake has found them.
set(development_packages g++ libcgal-dev libeigen3-dev libpugixml-dev zlib1g-dev)
foreach(pair "CGAL::TBB_support libtbb-dev" "Tubular_meshing_tetgen libtet1.5-dev" "Tubular_meshing_lemon liblemon-dev"
             "Tubular_meshing_lzma liblzma-dev" "Tubular_meshing_hdf5 libhdf5-dev" "Tubular_meshing_cgns libcgns-dev"
             "Tubular_meshing_exodus libexodusii-dev" "Tubular_meshing_metis libmetis-dev")
  string(REPLACE " " ";" pair "${pair}")
  list(GET pair 0 target)
  list(GET pair 1 package)
  if(TARGET ${target})
    list(APPEND development_packages ${package})
  endif()
endforeach()
string(REPLACE ";" ", " development_packages "${development_packages}")
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libtubular-meshing-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "${development_packages}")
set(CPACK_DEBIAN_DEVELOPMENT_DESCRIPTION "meshes of blood vessels and airways: C++ library\n\
 A package in the style of CGAL: the headers, the compiled library, and the\n\
 CMake package of Tubular_meshing.")

if(TARGET tubular_meshing_python)
  execute_process(COMMAND ${TUBULAR_MESHING_PYTHON} -c "import sys; print('%d.%d;%d' % (*sys.version_info[:2], sys.version_info[1] + 1))"
                  OUTPUT_VARIABLE versions OUTPUT_STRIP_TRAILING_WHITESPACE)
  list(GET versions 0 this_version)
  list(GET versions 1 next_minor)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_NAME python3-tubular-meshing)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SECTION python)
  # a module for this version of Python alone
  set(CPACK_DEBIAN_PYTHON_PACKAGE_DEPENDS "python3 (>= ${this_version}), python3 (<< 3.${next_minor}), python3-numpy")
  set(CPACK_DEBIAN_PYTHON_PACKAGE_SUGGESTS "python3-vtk9, python3-meshio, python3-matplotlib")
  set(CPACK_DEBIAN_PYTHON_DESCRIPTION "meshes of blood vessels and airways: Python module\n\
 Surfaces, centerlines and meshes as NumPy arrays, and every option of\n\
 tubular_mesh as a keyword argument.")
  set(control ${PROJECT_BINARY_DIR}/python_package_control)
  file(WRITE ${control}/postinst "#!/bin/sh\nset -e\nif [ \"$1\" = configure ] && command -v py3compile >/dev/null; then\n  py3compile -p python3-tubular-meshing\nfi\n")
  file(WRITE ${control}/prerm "#!/bin/sh\nset -e\nif command -v py3clean >/dev/null; then\n  py3clean -p python3-tubular-meshing\nfi\n")
  file(CHMOD ${control}/postinst ${control}/prerm PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ
                                                                GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
  set(CPACK_DEBIAN_PYTHON_PACKAGE_CONTROL_EXTRA ${control}/postinst ${control}/prerm)
endif()

# What the archive has beside them: the shared libraries of the program and of the Python module, found as the linker
# finds them, but for those that are the C library's, the compiler's, or Python's.
if(CMAKE_SYSTEM_NAME STREQUAL "Linux" AND TARGET tubular_mesh)
  set(programs $<TARGET_FILE:tubular_mesh>)
  if(TARGET tubular_meshing_python)
    list(APPEND programs $<TARGET_FILE:tubular_meshing_python>)
  endif()
  file(GENERATE OUTPUT ${PROJECT_BINARY_DIR}/install_libraries_$<CONFIG>.cmake CONTENT "
set(folder \"\$ENV{DESTDIR}\${CMAKE_INSTALL_PREFIX}/${CMAKE_INSTALL_LIBDIR}/tubular_meshing\")
file(GET_RUNTIME_DEPENDENCIES EXECUTABLES ${programs} RESOLVED_DEPENDENCIES_VAR libraries
     UNRESOLVED_DEPENDENCIES_VAR missing
     PRE_EXCLUDE_REGEXES \"^ld-linux\" \"^lib(c|m|dl|rt|pthread|resolv|util|gcc_s|stdc[+][+])[.]so\" \"^libpython\")
if(missing)
  message(FATAL_ERROR \"These libraries are not found: \${missing}\")
endif()
file(INSTALL DESTINATION \"\${folder}\" TYPE SHARED_LIBRARY FOLLOW_SYMLINK_CHAIN FILES \${libraries})
# a library that says where to look would look nowhere else
file(GLOB installed \"\${folder}/*\")
foreach(library IN LISTS installed)
  if(NOT IS_SYMLINK \"\${library}\")
    file(RPATH_REMOVE FILE \"\${library}\")
  endif()
endforeach()
")
  install(SCRIPT ${PROJECT_BINARY_DIR}/install_libraries_$<CONFIG>.cmake COMPONENT libraries EXCLUDE_FROM_ALL)
endif()

include(CPack)
