# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The core for `double`, compiled once: the target Surface_mesh_geodesic_offset::compiled. Each part is one translation unit, see
# internal/compilation/compiled_functions.h.

# add_geodesic_offset_library(target [EXCLUDE_FROM_ALL]): a library of the core
function(add_geodesic_offset_library target)
  set(folder "${PROJECT_BINARY_DIR}/compiled_parts")
  set(files)
  foreach(part IN ITEMS # those that take longest first
      "PARALLEL_FRONT Geodesic_build"
      "CUTTING offsets/level_cutting"
      "FRONT Geodesic_build"
      "VORONOI voronoi/Bisector_diagram"
      "CERTIFIED certified/Certified_build"
      "PATH Geodesic_build"
      "LOCATOR mesh/Surface_locator Polyline_joining"
      "MESH mesh/Unfolded_mesh mesh/Index_renumbering"
      "SOURCE sources/Source_set offsets/Inner_sides")
    string(REPLACE " " ";" headers "${part}")
    list(GET headers 0 GEODESIC_OFFSET_PART)
    list(REMOVE_AT headers 0)
    set(GEODESIC_OFFSET_DEFINITIONS)
    foreach(header IN LISTS headers)
      string(APPEND GEODESIC_OFFSET_DEFINITIONS
        "#include <CGAL/Surface_mesh_geodesic_offset/internal/${header}_impl.h>\n")
    endforeach()
    string(TOLOWER "${GEODESIC_OFFSET_PART}" name)
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/compiled_part.cpp.in" "${folder}/${name}.cpp" @ONLY)
    list(APPEND files "${folder}/${name}.cpp")
  endforeach()
  add_library(${target} STATIC ${ARGN} ${files})
  target_link_libraries(${target} PUBLIC Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)
  if(TARGET CGAL::TBB_support)
    target_link_libraries(${target} PUBLIC CGAL::TBB_support)
  endif()
  target_compile_definitions(${target} PUBLIC CGAL_GEODESIC_OFFSET_COMPILED PRIVATE CGAL_GEODESIC_OFFSET_BUILDS_LIBRARY)
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
