// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// libFuzzer test of the readers of the programs (clang++ -fsanitize=fuzzer,address,undefined). The first byte is the
// format, the rest the file.

#include "read_input.h"

#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <string>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
  static const std::string paths[] = {"file.off",           "file.obj", "file.ply",      "file.stl",
                                      "file.polylines.txt", "file.txt", "file.table.ply"};
  if (size < 2) return 0;
  const std::vector<char> bytes(data + 1, data + size); // an exact copy
  try
  {
    test::read_input(paths[data[0] % 7], std::string_view(bytes.data(), bytes.size()));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << std::endl;
    std::abort();
  }
  return 0;
}
