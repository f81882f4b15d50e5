# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The program of each project, from the files CONSUMER_SOURCES: by the time this file is included, the target
# Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset must exist.

set(CMAKE_RUNTIME_OUTPUT_DIRECTORY "${CMAKE_CURRENT_BINARY_DIR}/bin/$<1:>")
list(TRANSFORM CONSUMER_SOURCES PREPEND "${CMAKE_CURRENT_LIST_DIR}/")
add_executable(package_use ${CONSUMER_SOURCES})
target_link_libraries(package_use
  PRIVATE Surface_mesh_geodesic_offset::Surface_mesh_geodesic_offset)

# Being used must not bring the package's own tests, examples and benchmarks along.
get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
if(NOT targets STREQUAL "package_use" OR TARGET geodesic_offset OR TARGET doc)
  message(FATAL_ERROR "targets that a user did not request: ${targets}")
endif()
