# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The same program for each way of getting the package: by the time this file is included, the target
# Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset must exist.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/bin/$<1:>")
add_executable(package_use
  "${CMAKE_CURRENT_LIST_DIR}/main.cpp" "${CMAKE_CURRENT_LIST_DIR}/second_unit.cpp")
target_link_libraries(package_use
  PRIVATE Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)

# Being used must not bring the package's own tests, examples and benchmarks along.
get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
if(NOT targets STREQUAL "package_use" OR TARGET geodesic_offset OR TARGET doc)
  message(FATAL_ERROR "targets that a user did not request: ${targets}")
endif()
