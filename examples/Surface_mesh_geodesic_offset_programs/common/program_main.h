// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Frame of every program: all errors end in one line of errors and an exit code.

#ifndef GEODESIC_OFFSET_PROGRAM_MAIN_H
#define GEODESIC_OFFSET_PROGRAM_MAIN_H

#include "messages.h"
#include "stop_signals.h"

#include <CGAL/assertions_behaviour.h>

#include <cerrno>
#include <cstring>
#include <exception>
#include <iostream>
#include <new>
#include <string>

namespace geodesic_offset {
namespace internal {

// CGAL's errors become exceptions, which are reported in one line.
inline void be_silent(const char*, const char*, const char*, int, const char*) {}

} // namespace internal

// Prints a warning; the program continues.
inline void print_warning(const std::string& program, const std::string& text)
{
  std::cerr << program << ": warning: " << one_line(text) << std::endl;
}

// Throws Input_error if printing to standard output failed.
inline void check_standard_output()
{
  if(std::cout) // otherwise a longer text has failed before this flush, and the error number is that of the failure
    errno = 0;
  std::cout.flush();
  if(!std::cout)
    throw Input_error("cannot write to the standard output" +
                      (errno == 0 ? std::string() : ": " + std::string(std::strerror(errno))));
}

// work() returns the exit code.
template <class Work>
int program_main(const std::string& name, const Work& work)
{
  CGAL::set_error_handler(internal::be_silent);
  CGAL::set_warning_handler(internal::be_silent);
  const auto fail = [&](int code, const std::string& text) {
    std::cerr << name << ": " << one_line(text) << std::endl;
    return code;
  };
  try
  {
    end_cleanly_on_signals();
    const int code = work();
    check_standard_output();
    return code;
  }
  catch(const Usage_error& error)
  {
    return fail(2, error.what());
  }
  catch(const std::bad_alloc&)
  {
    return fail(1, "out of memory");
  }
  catch(const std::exception& error)
  {
    return fail(1, error.what());
  }
  catch(...)
  {
    return fail(1, "unknown error");
  }
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PROGRAM_MAIN_H
