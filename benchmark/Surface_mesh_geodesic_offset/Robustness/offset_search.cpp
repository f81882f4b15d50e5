// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for wrong offset curves, on meshes and at levels where cutting is difficult: levels at and near events; meshes
// with ties, noise far below the size of the faces, and needles. See the text of --help below, offset_search.h for the
// search, and level_judge.h for the criteria.

#include "offset_search.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <stdexcept>
#include <string>
#include <thread>

namespace {

const char* const usage =
  R"(usage: offset_search [option]...

Cuts offset curves of random cases and judges them. A case is a mesh with sources and levels. The seed of a case determines
all of them.

  --seed N       seed of the first case (1); the next cases have the seeds N + 1, N + 2, ...
  --meshes N     number of cases (1000)
  --seconds S    no case starts later than this (1e9)
  --levels N     levels per mesh, at most (16)
  --kind NAME    kind of all meshes: KINDS (all of them)
  --sources N    each case has sources of up to N kinds, and a third of the meshes is jittered; 0: one source or two, of one
                 kind each (0)
  --level D      cut only this level
  --validate N   pass every N-th mesh to a second validator; 0: none (10)
  --printed N    print at most N wrong cases (100)
  --write PREFIX write the mesh and the sources of each wrong case to PREFIX<seed>.off and PREFIX<seed>.sources.txt
  --patience S   end the program if a case takes longer (60)
  --verbose      print all cases
  --help         print this text

"--seed N --meshes 1" repeats the case with the seed N, if --kind and --levels are the same.

The output is a list of wrong cases and a table with a row per kind of meshes:
  critical       levels whose curves differ between kept windows and one pass, within rounding of a change of topology
  wrong          levels with wrong curves
  forced         joints that the tracer forced
  thrown         exceptions
  gap ... one pass   levels with this kind of fault
  invalid        meshes that the second validator rejects, and meshes that were passed to it
  gap, outside, off  largest gap between pieces, largest distance of a point from its face, and largest distance of a point
                 from its level, as multiples of the level plus the diagonal of the bounding box

Exit codes: 0 all curves are right; 1 some are wrong; 2 wrong options; 3 a case took longer than --patience.
)";

std::string kinds()
{
  std::string all;
  for (const auto& k : test::Search_meshes::kinds()) all += (all.empty() ? "" : ", ") + k.first;
  return all;
}

void print_usage()
{
  std::string text = usage;
  const std::string place = "KINDS";
  text.replace(text.find(place), place.size(), "\n                 " + kinds() + "\n                ");
  std::cout << text;
}

void watch(const test::Offset_search& search, double patience)
{
  for (;;)
  {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    if (!(search.seconds_of_running_case() > patience)) continue;
    std::cerr << "offset_search: the case with seed " << search.running_seed() << " takes more than " << patience << " s"
              << std::endl;
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
    if (name == "--help")
    {
      print_usage();
      return 0;
    }
    if (name == "--verbose")
    {
      options.verbose = true;
      continue;
    }
    if (i + 1 == argc) throw std::invalid_argument("option " + name + " is unknown, or its value is missing; see --help");
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
    else if (name == "--sources") options.sources = static_cast<std::size_t>(number());
    else if (name == "--level") options.level = number();
    else if (name == "--validate") options.validate = static_cast<std::size_t>(number());
    else if (name == "--printed") options.printed = static_cast<std::size_t>(number());
    else if (name == "--patience") patience = number();
    else if (name == "--write") options.write = text;
    else if (name == "--kind")
    {
      options.kind = text;
      const auto& known = test::Search_meshes::kinds();
      if (std::none_of(known.begin(), known.end(), [&](const auto& k) { return k.first == text; }))
        throw std::invalid_argument("--kind: unknown kind " + text + "; known are " + kinds());
    }
    else throw std::invalid_argument("unknown option " + name + "; see --help");
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
