// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Checks that count and print, also in Release builds.

#ifndef GEODESIC_OFFSET_TEST_CHECK_H
#define GEODESIC_OFFSET_TEST_CHECK_H

#include "test_registry.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace test {

/// Counts checks and failures; prints the first few failures of each source line.
class Report
{
public:
  static Report& instance();

  /// Counts a successful check and returns true.
  bool passed()
  {
    ++checks_;
    return true;
  }

  /// Counts and prints a failed check and returns false.
  bool failed(const char* expression, const char* file, int line, const std::string& detail);

  /// Prefix of all further failures.
  void set_context(const std::string& context) { context_ = context; }
  const std::string& context() const { return context_; }
  std::size_t checks() const { return checks_; }
  std::size_t failures() const { return failures_; }

  /// Prints the totals; returns the exit code.
  int finish(const std::string& name) const;

private:
  static constexpr std::size_t maximum_printed_ = 4;
  std::size_t checks_ = 0;
  std::size_t failures_ = 0;
  std::map<std::pair<std::string, int>, std::size_t> failures_at_;
  std::string context_;
};

/// Largest error, relative to a tolerance that grows with the expected value.
class Worst_error
{
public:
  /// `relative` applies to the expected distance; `scale` is the size of the coordinates, whose rounding (a few units in
  /// the last place) no solver can undo.
  Worst_error(double relative, double scale)
    : relative_(relative), absolute_(16 * std::numeric_limits<double>::epsilon() * scale)
  {
  }

  /// Whether `actual` equals `expected` (infinities are equal, NaN equals nothing).
  bool add(double actual, double expected)
  {
    ++count_;
    if (std::isinf(expected) || !std::isfinite(actual))
    {
      const bool same = (actual == expected);
      if (!same) error_ = std::numeric_limits<double>::infinity();
      return same;
    }
    const double difference = std::abs(actual - expected);
    if (difference > 0) error_ = (std::max)(error_, difference / (std::max)(expected, absolute_ / relative_));
    return difference <= relative_ * expected + absolute_;
  }

  double error() const { return error_; }
  std::size_t count() const { return count_; }

private:
  double relative_, absolute_;
  double error_ = 0;
  std::size_t count_ = 0;
};

std::string values(double actual, double expected);

bool check_close(Worst_error& worst, double actual, double expected, const char* expression, const char* file, int line);

} // namespace test

#define CHECK(condition) CHECK_DETAIL(condition, "")

/// `detail` is evaluated only for a failed check.
#define CHECK_DETAIL(condition, detail)                                                                                        \
  (static_cast<bool>(condition) ? ::test::Report::instance().passed()                                                          \
                                : ::test::Report::instance().failed(#condition, __FILE__, __LINE__, detail))

#define CHECK_CLOSE(worst, actual, expected)                                                                                   \
  ::test::check_close((worst), (actual), (expected), #actual " == " #expected, __FILE__, __LINE__)

#define CHECK_THROWS(expression, exception_type)                                                                               \
  do {                                                                                                                         \
    bool thrown_as_expected = false;                                                                                           \
    std::string what_happened = "nothing was thrown";                                                                          \
    try                                                                                                                        \
    {                                                                                                                          \
      expression;                                                                                                              \
    }                                                                                                                          \
    catch (const exception_type&)                                                                                              \
    {                                                                                                                          \
      thrown_as_expected = true;                                                                                               \
    }                                                                                                                          \
    catch (const std::exception& other)                                                                                        \
    {                                                                                                                          \
      what_happened = other.what();                                                                                            \
    }                                                                                                                          \
    if (thrown_as_expected) ::test::Report::instance().passed();                                                               \
    else ::test::Report::instance().failed(#expression " throws " #exception_type, __FILE__, __LINE__, what_happened);         \
  } while (false)

namespace test {

/// Calls f(); an exception is a failure.
template <class Function>
void guarded(const Function& f)
{
  try
  {
    f();
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

/// Runs the (name, function) pairs, each in its context; an exception is a failure. Returns the result of `finish`. The
/// case `data_case` runs if meshes of the data directory are requested, the others if generated meshes are.
template <class Tests>
int run_tests(const char* name, const Tests& tests)
{
  for (const auto& test : tests)
  {
    const bool is_wanted = test.first == std::string(data_case) ? mesh_kinds().data : mesh_kinds().generated;
    if (!is_wanted) continue;
    Report::instance().set_context(test.first);
    guarded(test.second);
  }
  return Report::instance().finish(name);
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CHECK_H
