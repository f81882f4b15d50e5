# Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
# SPDX-License-Identifier: GPL-3.0-or-later

# The target `doc` of a build folder BUILD that was configured without the tools of the manual: looks for them again, and either
# says which are missing, or configures and builds the manual with them.
cmake_minimum_required(VERSION 3.16...3.25)
find_program(DOXYGEN doxygen)
find_program(PYTHON python3)
foreach(tool IN ITEMS Doxygen Python)
  string(TOUPPER "${tool}" path)
  if(NOT ${path})
    message(FATAL_ERROR "The manual cannot be written: ${tool} not found. It needs Doxygen and Python 3 "
      "(Debian: apt-get install doxygen python3)")
  endif()
endforeach()
foreach(arguments IN ITEMS "-DDOXYGEN_EXECUTABLE=${DOXYGEN};-DGEODESIC_OFFSET_PYTHON=${PYTHON};${BUILD}"
                           "--build;${BUILD};--target;doc")
  execute_process(COMMAND ${CMAKE_COMMAND} ${arguments} RESULT_VARIABLE result)
  if(result)
    message(FATAL_ERROR "The manual cannot be written, see above")
  endif()
endforeach()
