// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Tests that share a program and its translation unit. Each is a file with a namespace of its own, so that names do not clash:
//
//   namespace test_something {
//
//   using namespace test;
//   ...
//
//   } // namespace test_something
//
//   GEODESIC_OFFSET_TEST(test_something)
//   {
//     ... // argc, argv: the arguments, after the name of the test
//     return Report::instance().finish("test_something");
//   }
//
// test_main.cpp runs the test that is named on the command line.

#ifndef GEODESIC_OFFSET_TEST_REGISTRY_H
#define GEODESIC_OFFSET_TEST_REGISTRY_H

#include <cstdlib>
#include <map>
#include <string>

namespace test {

typedef int (*Test_function)(int argc, char* argv[]);

/// The tests of this program by name.
inline std::map<std::string, Test_function>& registered_tests()
{
  static std::map<std::string, Test_function> tests;
  return tests;
}

struct Test_registration
{
  Test_registration(const char* name, Test_function function) { registered_tests().emplace(name, function); }
};

/// The meshes of a test. A test with meshes of the data directory runs once per kind of mesh, so that the summary of ctest
/// shows whether the data was available.
struct Mesh_kinds
{
  bool generated = true;
  bool data = true;
};

inline Mesh_kinds& mesh_kinds()
{
  static Mesh_kinds kinds;
  return kinds;
}

/// The number of cases of a test: `few`, or `all` if the environment variable `GEODESIC_OFFSET_ALL_CASES` is set. The few
/// cases are of every kind; only repetitions with other seeds and larger meshes are left out.
template <class Number>
Number number_of_cases(Number few, Number all)
{
  return std::getenv("GEODESIC_OFFSET_ALL_CASES") ? all : few;
}

/// The case of `run_tests()` with the meshes of the data directory.
constexpr const char* data_case = "data meshes";

/// Exit code of a test without checks: the value of ctest's SKIP_RETURN_CODE.
constexpr int skipped = 77;

} // namespace test

/// The body of a test, in the namespace of the same name; returns the exit code.
#define GEODESIC_OFFSET_TEST(name)                                                                                             \
  namespace name {                                                                                                             \
  int test_main(int argc, char* argv[]);                                                                                       \
  const ::test::Test_registration registration(#name, &test_main);                                                             \
  }                                                                                                                            \
  int name::test_main([[maybe_unused]] int argc, [[maybe_unused]] char* argv[])

#endif // GEODESIC_OFFSET_TEST_REGISTRY_H
