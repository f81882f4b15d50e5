# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The core for `double`, compiled once: the target Surface_mesh_geodesic_offset::compiled. The functions of each part are in
# internal/compilation/compiled_functions.h.

# add_geodesic_offset_library(target [EXCLUDE_FROM_ALL] [WITHOUT_THREADS]): a library of the core
function(add_geodesic_offset_library target)
  cmake_parse_arguments(PARSE_ARGV 1 arg "EXCLUDE_FROM_ALL;WITHOUT_THREADS" "" "")
  set(folder "${PROJECT_BINARY_DIR}/compiled_parts")
  set(files)
  # Parts share a translation unit, since half of the time of a part alone is that of reading headers.
  foreach(unit IN ITEMS
      "PARALLEL_FRONT;Geodesic_build;SOURCE;sources/Source_set;offsets/Inner_sides"
      "FRONT;Geodesic_build;CERTIFIED;certified/Certified_build"
      "CUTTING;offsets/level_cutting;VORONOI;voronoi/Bisector_diagram;MESH;mesh/Unfolded_mesh;mesh/Index_renumbering"
      "PATH;Geodesic_build;LOCATOR;mesh/Surface_locator;Polyline_joining")
    set(GEODESIC_OFFSET_DEFINITIONS)
    set(GEODESIC_OFFSET_FUNCTIONS)
    foreach(word IN LISTS unit)
      if(word MATCHES "^[A-Z_]+$")
        string(APPEND GEODESIC_OFFSET_FUNCTIONS "CGAL_GEODESIC_OFFSET_${word}_FUNCTIONS(template)\n")
      else()
        string(APPEND GEODESIC_OFFSET_DEFINITIONS
          "#include <CGAL/Surface_mesh_geodesic_offset/internal/${word}_impl.h>\n")
      endif()
    endforeach()
    list(GET unit 0 name)
    string(TOLOWER "${name}" name)
    configure_file("${CMAKE_CURRENT_FUNCTION_LIST_DIR}/compiled_part.cpp.in" "${folder}/${name}.cpp" @ONLY)
    list(APPEND files "${folder}/${name}.cpp")
  endforeach()
  add_library(${target} STATIC ${files})
  set_target_properties(${target} PROPERTIES EXCLUDE_FROM_ALL ${arg_EXCLUDE_FROM_ALL})
  target_link_libraries(${target} PUBLIC Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)
  if(TARGET CGAL::TBB_support AND NOT arg_WITHOUT_THREADS)
    target_link_libraries(${target} PUBLIC CGAL::TBB_support)
  endif()
  target_compile_definitions(${target} PUBLIC CGAL_GEODESIC_OFFSET_COMPILED PRIVATE CGAL_GEODESIC_OFFSET_BUILDS_LIBRARY)
  if(GMPXX_FOUND) # CGAL's exact numbers: those of Boost are not used, and take a quarter of the time of reading CGAL's kernel
    target_compile_definitions(${target} PRIVATE CGAL_DO_NOT_USE_BOOST_MP)
  endif()
  set_target_properties(${target} PROPERTIES POSITION_INDEPENDENT_CODE ON)
endfunction()
