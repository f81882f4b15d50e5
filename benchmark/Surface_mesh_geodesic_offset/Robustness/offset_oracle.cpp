// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves face by face against exact arrangements of the same windows: the same gates must be connected, the number
// of loops equal, and chains no farther apart than rounding.
//
//   offset_oracle [--seed N] [--faces N] [--random] [--real] [--each N] [--seconds S] [--windows N] [--printed N]
//
// --random: one level in each of --faces faces (1000) with random windows: point and parallel windows, near and distant
// images, tangent circles, ties. --real: as many faces of generated meshes, at most --each (20) per mesh, with point and
// polyline sources; half of the levels are general, half of them at or near events. Without either option, both. Case i has
// seed N + i; so `--seed N --faces 1 --random` repeats a random face, and `--seed N --real --each E --faces 1` starts with
// the same mesh. Faces with more than --windows windows (80) are skipped. No case starts after --seconds. Up to --printed
// differences (20) are printed, with the windows of the face.
//
// A table on stdout, one row per kind: faces; of these, faces not crossed by the level; chains from gate to gate, loops and
// pieces of the tracer; windows; faces with the topology of a level that differs by rounding, see offset_oracle.h; faces
// whose chains bound the level of a distance that differs by rounding; faces whose chains are farther apart than rounding,
// as are the exact chains of levels that differ by rounding; skipped faces; faces with another topology; faces whose chains
// are too far apart; faces with forced joints; exceptions; and the largest distance of well-conditioned chains, in levels
// plus lengths of the longest edge of the face. The exit code is 1 if anything differs, and 2 for wrong options.

#include "oracle_run.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

int run(int argc, char** argv)
{
  test::Oracle_options options;
  bool random = false, real = false;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--random" || name == "--real")
    {
      (name == "--random" ? random : real) = true;
      continue;
    }
    if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
    const std::string text = argv[++i];
    if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
      throw std::invalid_argument(name + ": not a number from 0 to 999999999: " + text);
    const std::size_t value = std::stoul(text);
    if (name == "--seed") options.seed = static_cast<unsigned>(value);
    else if (name == "--faces") options.faces = value;
    else if (name == "--each") options.each = value;
    else if (name == "--windows") options.windows = value;
    else if (name == "--printed") options.printed = value;
    else if (name == "--seconds") options.seconds = double(value);
    else throw std::invalid_argument("unknown option " + name);
  }
  test::Oracle_run::print_head();
  std::size_t differences = 0;
  if (random || !real)
  {
    test::Oracle_run run(options);
    run.random_windows();
    run.print("random windows");
    differences += run.counts().differences();
  }
  if (real || !random)
  {
    test::Oracle_run run(options);
    run.real_faces();
    run.print("real faces");
    differences += run.counts().differences();
  }
  return differences == 0 ? 0 : 1;
}

} // namespace

int main(int argc, char** argv)
{
  try
  {
    return run(argc, argv);
  }
  catch (const std::exception& e)
  {
    std::cerr << "offset_oracle: " << e.what() << '\n';
    return 2;
  }
}
