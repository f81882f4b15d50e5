// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Test of the readers of the programs, or of a program itself, with mutated files of all formats. Every file must be
// accepted, or rejected with one line that names it, within 5 seconds.

#ifndef GEODESIC_OFFSET_TEST_MUTATION_RUN_H
#define GEODESIC_OFFSET_TEST_MUTATION_RUN_H

#include "../program_runner.h"
#include "mutations.h"
#include "read_input.h"
#include "sample_files.h"

#include <sys/resource.h>

#include <chrono>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <iostream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace test {

struct Mutation_tally
{
  std::size_t   accepted = 0, rejected = 0;
  double        slowest = 0; // seconds of processor time
  std::uint64_t slowest_seed = 0;
};

/// The processor time of this process and of the programs that it has run, in seconds.
inline double processor_seconds()
{
  double result = 0;
  for (const auto who : {RUSAGE_SELF, RUSAGE_CHILDREN})
  {
    rusage usage;
    getrusage(who, &usage);
    for (const timeval& t : {usage.ru_utime, usage.ru_stime})
      result += static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  }
  return result;
}

/// Returns whether the program accepts the file. Throws std::logic_error.
inline bool accepted_by_program(const std::string& program, const std::string& file, const std::string& mesh)
{
  const bool is_polyline = geodesic_offset::has_extension(file, ".polylines.txt");
  const std::vector<std::string> arguments =
    is_polyline ? std::vector<std::string>{mesh, "--source-polyline", file, "--distance", "0.5", "--quiet"}
                : std::vector<std::string>{file, "--source-vertex", "0", "--distance", "0.5", "--quiet"};
  const Program_result result = run_program(program, arguments);
  require(result.exit_code >= 0 && result.exit_code <= 2, "a signal, or an exit code that is not 0, 1 or 2");
  require(result.output.empty(), "an output");
  require(result.errors.empty() || result.errors.back() == '\n', "a line that does not end");
  std::size_t errors = 0; // warnings may precede it
  std::istringstream lines(result.errors);
  for (std::string line; std::getline(lines, line);)
  {
    require(line.compare(0, 17, "geodesic_offset: ") == 0, "a line that is no message");
    errors += line.compare(17, 9, "warning: ") == 0 ? 0 : 1;
  }
  require(errors == (result.exit_code == 0 ? 0u : 1u), "a wrong number of errors");
  return result.exit_code == 0;
}

/// Runs `count` mutations, number i with seed `seed` + i, with the readers, or with a program if one is given, which reads
/// only meshes and polylines. A file that causes a fault is written to the current folder and named on standard error.
/// Returns the tallies by extension, and the number of these files, at most 20.
inline std::pair<std::map<std::string, Mutation_tally>, int> run_mutations(std::uint64_t count, std::uint64_t seed,
                                                                         const std::string& program = "")
{
  constexpr double most_seconds = 5; // elapsed
  std::vector<Sample_file> samples = sample_meshes();
  for (const Sample_file& sample : other_samples())
    if (program.empty() || sample.extension == ".polylines.txt") samples.push_back(sample);
  // extensions are equally likely, however many samples they have
  std::map<std::string, std::vector<const Sample_file*>> by_extension;
  for (const Sample_file& sample : samples) by_extension[sample.extension].push_back(&sample);
  std::vector<std::string> extensions;
  for (const auto& entry : by_extension) extensions.push_back(entry.first);

  const Scratch_directory scratch;
  const std::string mesh = (scratch / "mesh.off").string();
  write_file(mesh, samples.front().bytes);
  std::map<std::string, Mutation_tally> tallies;
  int failures = 0;
  for (std::uint64_t i = 0; i < count; ++i)
  {
    File_mutator mutator(seed + i);
    const std::string& extension = extensions[i % extensions.size()];
    const auto& group = by_extension[extension];
    const std::string& whole = group[mutator.below(group.size())]->bytes;
    // exact-size copy, so that sanitizers detect reads beyond the end
    const std::string text = mutator(whole, samples[mutator.below(samples.size())].bytes);
    const std::vector<char> bytes(text.begin(), text.end());
    const std::string path = program.empty() ? "file" + extension : (scratch / ("file" + extension)).string();
    Mutation_tally& tally = tallies[extension];
    const double start = processor_seconds();
    const auto clock_start = std::chrono::steady_clock::now();
    try
    {
      if (!program.empty()) write_file(path, text);
      const bool is_accepted = program.empty() ? read_input(path, std::string_view(bytes.data(), bytes.size()))
                                               : accepted_by_program(program, path, mesh);
      ++(is_accepted ? tally.accepted : tally.rejected);
      const double seconds = processor_seconds() - start;
      if (seconds > tally.slowest)
      {
        tally.slowest = seconds;
        tally.slowest_seed = seed + i;
      }
      const std::chrono::duration<double> in_all = std::chrono::steady_clock::now() - clock_start;
      require(in_all.count() < most_seconds, "too slow");
    }
    catch (const std::exception& error)
    {
      const std::string file = "mutated_" + std::to_string(seed + i) + extension;
      write_file(file, text);
      std::cerr << file << " (seed " << seed + i << "): " << error.what() << std::endl;
      if (++failures == 20) break;
    }
  }
  return {tallies, failures};
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_MUTATION_RUN_H
