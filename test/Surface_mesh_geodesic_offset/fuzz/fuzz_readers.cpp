// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Test of the readers of the programs with files whose first byte is the format, the rest the file: for libFuzzer (clang++
// -fsanitize=fuzzer,address,undefined), or, with GEODESIC_OFFSET_READ_FILES, as a program that reads files from the standard input,
// each after a line with its size, and prints for each "accepted", "rejected" or "fault", with seconds or an explanation.

#include "read_input.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

namespace {

bool reads(std::uint8_t format, const std::vector<char>& bytes)
{
  static const std::string paths[] = {"file.off",           "file.obj", "file.ply",      "file.stl",
                                      "file.polylines.txt", "file.txt", "file.table.ply"};
  return test::read_input(paths[format % 7], std::string_view(bytes.data(), bytes.size()));
}

} // namespace

#ifdef GEODESIC_OFFSET_READ_FILES

int main()
{
  constexpr double most_seconds = 5;
  for (std::string line; std::getline(std::cin, line);)
  {
    const int format = std::cin.get();
    std::vector<char> bytes(std::stoul(line) - 1); // an exact copy, so that sanitizers detect reads beyond its end
    if (!std::cin.read(bytes.data(), std::streamsize(bytes.size()))) return 2;
    try
    {
      const auto start = std::chrono::steady_clock::now();
      const bool is_accepted = reads(std::uint8_t(format), bytes);
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      test::require(seconds.count() < most_seconds, "too slow");
      std::cout << (is_accepted ? "accepted " : "rejected ") << seconds.count() << std::endl;
    }
    catch (const std::exception& error)
    {
      std::cout << "fault " << error.what() << std::endl;
    }
  }
}

#else

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  if (size < 2) return 0;
  try
  {
    reads(data[0], std::vector<char>(data + 1, data + size));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    std::abort();
  }
  return 0;
}

#endif
