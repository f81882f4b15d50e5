# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The program of each project, from the translation units CONSUMER_UNITS, which link the compiled library if their names begin with
# `compiled`, and the headers alone otherwise. By the time this file is included, the targets of the package must exist.

# Being used must not bring the package's own tests, examples and benchmarks along.
get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
if(targets OR TARGET geodesic_offset OR TARGET doc)
  message(FATAL_ERROR "targets that a user did not request: ${targets}")
endif()

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/bin/$<1:>")
set(units)
add_executable(package_use "${CMAKE_CURRENT_LIST_DIR}/main.cpp")
target_include_directories(package_use PRIVATE "${CMAKE_CURRENT_BINARY_DIR}")
foreach(unit IN LISTS CONSUMER_UNITS)
  add_library(${unit} OBJECT "${CMAKE_CURRENT_LIST_DIR}/unit.cpp")
  target_compile_definitions(${unit} PRIVATE UNIT=${unit})
  if(unit MATCHES "^compiled")
    target_link_libraries(${unit} PRIVATE Surface_mesh_geodesic_offset::compiled)
    target_compile_definitions(${unit} PRIVATE EXPECTS_LIBRARY)
    target_link_libraries(package_use PRIVATE Surface_mesh_geodesic_offset::compiled)
  else()
    target_link_libraries(${unit} PRIVATE Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)
    target_link_libraries(package_use PRIVATE Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)
  endif()
  target_sources(package_use PRIVATE $<TARGET_OBJECTS:${unit}>)
  string(APPEND units "GEODESIC_OFFSET_UNIT(${unit})\n")
endforeach()
file(WRITE "${CMAKE_CURRENT_BINARY_DIR}/units.h" "${units}")
