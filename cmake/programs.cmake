# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# What examples, programs, tests and benchmarks share. The folder of each is a project, as in CGAL: it is part of the whole
# repository, or configured alone.

include_guard(GLOBAL)

if(NOT TARGET Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset) # alone: the package of this repository
  add_subdirectory("${CMAKE_CURRENT_LIST_DIR}/.." Surface_mesh_geodesic_offset EXCLUDE_FROM_ALL)
endif()

# OpenMesh, by its files: the package configuration of Debian 12 does not find its library.
find_path(GEODESIC_OFFSET_OPENMESH_INCLUDE_DIR OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh)
find_library(GEODESIC_OFFSET_OPENMESH_LIBRARY OpenMeshCore)
if(GEODESIC_OFFSET_OPENMESH_INCLUDE_DIR AND GEODESIC_OFFSET_OPENMESH_LIBRARY)
  add_library(geodesic_offset_openmesh INTERFACE IMPORTED)
  set_target_properties(geodesic_offset_openmesh PROPERTIES
    INTERFACE_INCLUDE_DIRECTORIES "${GEODESIC_OFFSET_OPENMESH_INCLUDE_DIR}"
    INTERFACE_LINK_LIBRARIES "${GEODESIC_OFFSET_OPENMESH_LIBRARY}")
endif()

# add_untested_program(file [library...]): a program of one file that no test runs
function(add_untested_program file)
  get_filename_component(name ${file} NAME_WE)
  if(GEODESIC_OFFSET_ONLY_CHECK_PROGRAMS)
    check_program(${name} "${CMAKE_CURRENT_SOURCE_DIR}/${file}" ${ARGN})
  else()
    add_executable(${name} ${file})
    target_link_libraries(${name} PRIVATE Surface_mesh_geodesic_offset::compiled CGAL::Data ${ARGN})
  endif()
endfunction()
