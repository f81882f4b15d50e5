// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves where they are hard to cut: levels at and next to the distances where their topology changes, on meshes
// with ties, noise far below the size of the faces, and needles. Is any curve wrong?
//
//   offset_search [--seed N] [--meshes N] [--seconds S] [--levels N] [--kind NAME] [--level D] [--validate N]
//                 [--printed N] [--write PREFIX] [--patience S] [--verbose]
//
// Case i has the seed N + i, which determines its mesh, its sources and its levels; so `--seed N --meshes 1` repeats a case
// (with the same --kind and --levels), and `--level D` one level of it. Every --validate-th mesh is judged by a second
// validator, too. --write puts the mesh and the sources of each wrong case into files.
//
// Wrong cases, then a table by kind of meshes on stdout: the number of levels within rounding of a change of topology, whose
// curves differ between kept windows and one pass; of levels with wrong curves; of joints that were forced; of exceptions; levels by kind of fault; meshes that the second validator rejects; and the largest gap between pieces, the
// farthest point outside of its face and the farthest point off its level, in levels plus diagonals of the bounding box. The
// exit code is 1 if anything is wrong. A case that takes longer than --patience, 60 s, ends the program with exit code 3:
// an endless loop.

#include "offset_search.h"

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

void watch(const test::Offset_search& search, double patience)
{
  for (;;)
  {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    if (!(search.seconds_of_running_case() > patience)) continue;
    std::cerr << "offset_search: the case with seed " << search.running_seed() << " takes more than " << patience
              << " s" << std::endl;
    std::fflush(stdout);
    std::_Exit(3);
  }
}

int run(int argc, char** argv)
{
  test::Search_options options;
  double patience = 60;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--verbose")
    {
      options.verbose = true;
      continue;
    }
    if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
    const std::string text = argv[++i];
    const auto number = [&] {
      std::size_t end = 0;
      double x = 0;
      try
      {
        x = std::stod(text, &end);
      }
      catch (const std::exception&)
      {
      }
      if (end == 0 || end != text.size() || !(x >= 0) || !(x <= 4e9))
        throw std::invalid_argument(name + ": not a number from 0 to 4e9: " + text);
      return x;
    };
    if (name == "--seed") options.seed = static_cast<unsigned>(number());
    else if (name == "--meshes") options.meshes = static_cast<std::size_t>(number());
    else if (name == "--seconds") options.seconds = number();
    else if (name == "--levels") options.levels = static_cast<std::size_t>(number());
    else if (name == "--level") options.level = number();
    else if (name == "--validate") options.validate = static_cast<std::size_t>(number());
    else if (name == "--printed") options.printed = static_cast<std::size_t>(number());
    else if (name == "--patience") patience = number();
    else if (name == "--write") options.write = text;
    else if (name == "--kind")
    {
      options.kind = text;
      bool is_known = false;
      std::string all;
      for (const auto& k : test::Search_meshes::kinds())
      {
        is_known = is_known || k.first == text;
        all += (all.empty() ? "" : ", ") + k.first;
      }
      if (!is_known) throw std::invalid_argument("--kind: none of " + all + ": " + text);
    }
    else throw std::invalid_argument("unknown option " + name);
  }
  const auto search = std::make_shared<test::Offset_search>(options);
  std::thread([search, patience] { watch(*search, patience); }).detach();
  search->run();
  search->print_table();
  const test::Search_counts total = search->total();
  return total.wrong + total.forced_joints + total.exceptions + total.invalid == 0 ? 0 : 1;
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
    std::cerr << "offset_search: " << e.what() << '\n';
    return 2;
  }
}
