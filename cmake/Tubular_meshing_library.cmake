# Copyright (c) 2026 The Tubular_meshing authors.
# SPDX-License-Identifier: GPL-3.0-or-later

# The target CGAL::Tubular_meshing, its installation, and its CMake package.

include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

# The dependencies are looked for as a package's are; here they are all required.
set(CMAKE_FIND_PACKAGE_NAME Tubular_meshing)
set(Tubular_meshing_FIND_REQUIRED TRUE)
include(Tubular_meshing_dependencies)
unset(CMAKE_FIND_PACKAGE_NAME)
unset(Tubular_meshing_FIND_REQUIRED)

# Two targets: the library, compiled once, and the headers alone, for those who would not link.
function(tubular_meshing_set_usage target scope)
  target_compile_features(${target} ${scope} cxx_std_17)
  target_include_directories(${target} ${scope} $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                                $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  # Not exported: Tubular_meshingConfig.cmake finds and links the dependencies where the package is used.
  foreach(dependency IN LISTS Tubular_meshing_dependency_targets)
    target_link_libraries(${target} ${scope} $<BUILD_INTERFACE:${dependency}>)
  endforeach()
endfunction()

file(GLOB library_sources CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
add_library(Tubular_meshing ${library_sources}) # static, or shared with BUILD_SHARED_LIBS
add_library(CGAL::Tubular_meshing ALIAS Tubular_meshing)
set_target_properties(Tubular_meshing PROPERTIES OUTPUT_NAME CGAL_Tubular_meshing VERSION ${PROJECT_VERSION}
                                                 SOVERSION ${PROJECT_VERSION_MAJOR} POSITION_INDEPENDENT_CODE ON)
target_compile_options(Tubular_meshing PRIVATE $<$<CXX_COMPILER_ID:GNU,Clang,AppleClang>:-Wall -Wextra>)
tubular_meshing_set_usage(Tubular_meshing PUBLIC)
if(TUBULAR_MESHING_PRECOMPILED_HEADERS)
  target_precompile_headers(Tubular_meshing PRIVATE ${CMAKE_CURRENT_LIST_DIR}/Tubular_meshing_precompiled.h)
  target_compile_options(Tubular_meshing PRIVATE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>) # for ccache
  # the longest to compile: done while the header is made
  set_source_files_properties(${PROJECT_SOURCE_DIR}/src/Mesh_3.cpp PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
endif()

# What writes files of some formats, or makes parts, is known to one source alone; programs link the libraries without
# their headers.
set(format_sources ${PROJECT_SOURCE_DIR}/src/IO_libraries.cpp ${PROJECT_SOURCE_DIR}/src/Partition.cpp)
set_source_files_properties(${format_sources} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
foreach(target IN LISTS Tubular_meshing_format_targets)
  get_target_property(includes ${target} INTERFACE_INCLUDE_DIRECTORIES)
  list(REMOVE_ITEM includes ${CMAKE_CXX_IMPLICIT_INCLUDE_DIRECTORIES})
  get_target_property(definitions ${target} INTERFACE_COMPILE_DEFINITIONS)
  set_property(SOURCE ${format_sources} APPEND PROPERTY INCLUDE_DIRECTORIES ${includes})
  set_property(SOURCE ${format_sources} APPEND PROPERTY COMPILE_DEFINITIONS ${definitions})
  get_target_property(library ${target} IMPORTED_LOCATION)
  target_link_libraries(Tubular_meshing PRIVATE $<BUILD_INTERFACE:${library}>)
endforeach()

add_library(Tubular_meshing_header_only INTERFACE)
add_library(CGAL::Tubular_meshing_header_only ALIAS Tubular_meshing_header_only)
target_compile_definitions(Tubular_meshing_header_only INTERFACE CGAL_TUBULAR_MESHING_HEADER_ONLY)
tubular_meshing_set_usage(Tubular_meshing_header_only INTERFACE)
foreach(target IN LISTS Tubular_meshing_format_targets)
  target_link_libraries(Tubular_meshing_header_only INTERFACE $<BUILD_INTERFACE:${target}>)
endforeach()

set(package_dir ${CMAKE_INSTALL_LIBDIR}/cmake/Tubular_meshing)
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/Tubular_meshingConfig.cmake.in
                              ${PROJECT_BINARY_DIR}/Tubular_meshingConfig.cmake INSTALL_DESTINATION ${package_dir})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/Tubular_meshingConfigVersion.cmake
                                 COMPATIBILITY SameMajorVersion)
configure_file(${CMAKE_CURRENT_LIST_DIR}/Tubular_meshing_dependencies.cmake
               ${PROJECT_BINARY_DIR}/Tubular_meshing_dependencies.cmake COPYONLY)

install(TARGETS Tubular_meshing Tubular_meshing_header_only EXPORT Tubular_meshing_targets
        ARCHIVE COMPONENT development LIBRARY COMPONENT development RUNTIME COMPONENT development)
install(EXPORT Tubular_meshing_targets NAMESPACE CGAL:: FILE Tubular_meshingTargets.cmake DESTINATION ${package_dir}
        COMPONENT development)
install(DIRECTORY ${PROJECT_SOURCE_DIR}/include/CGAL DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
        COMPONENT development FILES_MATCHING PATTERN "*.h")
install(FILES ${PROJECT_BINARY_DIR}/Tubular_meshingConfig.cmake
              ${PROJECT_BINARY_DIR}/Tubular_meshingConfigVersion.cmake
              ${PROJECT_BINARY_DIR}/Tubular_meshing_dependencies.cmake
        DESTINATION ${package_dir} COMPONENT development)

# The build directory is a package too: -DTubular_meshing_DIR=<build>.
export(EXPORT Tubular_meshing_targets NAMESPACE CGAL:: FILE ${PROJECT_BINARY_DIR}/Tubular_meshingTargets.cmake)
