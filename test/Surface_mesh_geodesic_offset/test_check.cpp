// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#include "test_check.h"

#include <cstdio>
#include <iostream>

namespace test {

Report& Report::instance()
{
  static Report report;
  return report;
}

bool Report::failed(const char* expression, const char* file, int line, const std::string& detail)
{
  ++checks_;
  ++failures_;
  if (++failures_at_[std::make_pair(std::string(file), line)] <= maximum_printed_)
  {
    std::cout << "FAILED " << file << ":" << line << ": " << expression;
    if (!context_.empty()) std::cout << "  [" << context_ << "]";
    if (!detail.empty()) std::cout << "  " << detail;
    std::cout << std::endl;
  }
  return false;
}

int Report::finish(const std::string& name) const
{
  for (const auto& entry : failures_at_)
    if (entry.second > maximum_printed_)
      std::cout << entry.first.first << ":" << entry.first.second << ": " << entry.second << " failures in all\n";
  std::cout << name << ": " << checks_ << " checks, " << failures_ << " failures" << std::endl;
  if (checks_ == 0) std::cout << name << ": nothing was checked" << std::endl;
  return (failures_ == 0 && checks_ > 0) ? 0 : 1;
}

std::string values(double actual, double expected)
{
  const std::string text = "actual " + std::to_string(actual) + ", expected " + std::to_string(expected);
  char buffer[64];
  std::snprintf(buffer, sizeof(buffer), ", difference %.3g", actual - expected);
  return text + buffer;
}

bool check_close(Worst_error& worst, double actual, double expected, const char* expression, const char* file, int line)
{
  if (worst.add(actual, expected)) return Report::instance().passed();
  return Report::instance().failed(expression, file, line, values(actual, expected));
}

} // namespace test
