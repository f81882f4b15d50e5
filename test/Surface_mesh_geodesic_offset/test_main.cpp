// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Main function of all tests:
//
//   PROGRAM TEST [--generated-meshes | --data-meshes] [ARGUMENT...]
//
// TEST is optional if the program has a single test. Without an option the test uses also the meshes of the data directory
// if they exist. With --data-meshes it uses only these; the exit code is 77 if there are none.

#include "data_directory.h"
#include "test_check.h"
#include "test_registry.h"

#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

int run(const std::string& name, test::Test_function function, std::vector<char*> arguments)
{
  bool only_data = false;
  if (arguments.size() > 1 && arguments[1] == std::string("--data-meshes")) only_data = true;
  else if (arguments.size() > 1 && arguments[1] == std::string("--generated-meshes")) test::mesh_kinds().data = false;
  if (only_data || !test::mesh_kinds().data) arguments.erase(arguments.begin() + 1);
  test::mesh_kinds().generated = !only_data;
  if (only_data && test::data_files().empty())
  {
    std::cout << name << ": skipped, there are no meshes in the folder GEODESIC_OFFSET_DATA_DIR, which is '"
              << test::data_directory() << "'" << std::endl;
    return test::skipped;
  }

  const int count = static_cast<int>(arguments.size());
  arguments.push_back(nullptr);
  int result = 1;
  try
  {
    result = function(count, arguments.data());
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
    return test::Report::instance().finish(name);
  }
  if (only_data && test::Report::instance().checks() == 0)
  {
    std::cout << name << ": skipped, the folder GEODESIC_OFFSET_DATA_DIR, which is '" << test::data_directory()
              << "', has none of its meshes" << std::endl;
    return test::skipped;
  }
  return result;
}

} // namespace

int main(int argc, char* argv[])
{
  const auto& tests = test::registered_tests();
  const auto named = argc > 1 ? tests.find(argv[1]) : tests.end();
  if (named != tests.end()) return run(named->first, named->second, std::vector<char*>(argv + 1, argv + argc));
  if (tests.size() == 1) return run(tests.begin()->first, tests.begin()->second, std::vector<char*>(argv, argv + argc));
  std::cerr << "usage: " << argv[0] << " TEST [--generated-meshes | --data-meshes] [ARGUMENT...]\nTEST is one of";
  for (const auto& test : tests) std::cerr << ' ' << test.first;
  std::cerr << std::endl;
  return 2;
}
