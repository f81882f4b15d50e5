// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Search for wrong runs, crashes and endless loops: meshes unchanged and perturbed, sources of all kinds, levels at and
// near vertex distances.
//
//   corpus [--seed N] [--runs N] [--seconds S] [--printed N] [--verbose] [--write PREFIX] [MESH or FOLDER]...
//
// Without a mesh, the generated meshes of offset_search. Run i has seed N + i, which determines the mesh, its perturbation,
// the sources and the levels: each mesh meets each perturbation once before a combination repeats. So `--seed N --runs 1`
// repeats a run with the same meshes. A run is a separate process, which ends after --seconds (60).
//
// A run reads the mesh as the program geodesic_offset does, perturbs it, and reads it again. Distances must be 1-Lipschitz
// and within certified bounds, curves valid, both up to 1e-10 of the distance plus the diagonal.
//
// Output: failing runs, up to --printed (50), then outcomes by perturbation and by source. --write PREFIX writes the meshes
// and sources of wrong runs. The exit code is 1 if a run fails, and 2 for wrong options.

#include "corpus_run.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <iostream>
#include <stdexcept>
#include <string>

namespace {

std::size_t number(const std::string& name, const std::string& text)
{
  if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
    throw std::invalid_argument(name + ": not a number from 0 to 999999999: " + text);
  return std::stoul(text);
}

void add_meshes(const std::filesystem::path& path, test::Corpus_options& options)
{
  if (!std::filesystem::exists(path)) throw std::invalid_argument(path.string() + " does not exist");
  if (!std::filesystem::is_directory(path)) return options.files.push_back(path);
  for (const auto& entry : std::filesystem::directory_iterator(path))
  {
    const std::string extension = entry.path().extension().string();
    if (extension == ".off" || extension == ".obj" || extension == ".ply" || extension == ".stl")
      options.files.push_back(entry.path());
  }
}

int run(int argc, char** argv)
{
  test::Corpus_options options;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name == "--verbose") options.verbose = true;
    else if (name.compare(0, 2, "--") != 0) add_meshes(name, options);
    else if (i + 1 == argc) throw std::invalid_argument(name + " needs a value, or is unknown");
    else if (name == "--seed") options.seed = static_cast<unsigned>(number(name, argv[++i]));
    else if (name == "--runs") options.runs = number(name, argv[++i]);
    else if (name == "--seconds") options.seconds = static_cast<unsigned>(number(name, argv[++i]));
    else if (name == "--printed") options.printed = number(name, argv[++i]);
    else if (name == "--write") options.write = argv[++i];
    else throw std::invalid_argument("unknown option " + name);
  }
  std::sort(options.files.begin(), options.files.end());
  test::Corpus_run corpus(options);
  corpus.run();
  corpus.print_tables();
  return corpus.failures() == 0 ? 0 : 1;
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
    std::cerr << "corpus: " << e.what() << '\n';
    return 2;
  }
}
