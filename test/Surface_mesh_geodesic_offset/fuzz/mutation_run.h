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
  std::size_t accepted = 0, rejected = 0;
  double slowest = 0; // seconds of processor time
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

/// A program that reads mutated files: geodesic_offset, or validate_geodesic_offsets by its name.
class Tested_program
{
  const Scratch_directory& m_scratch;
  const std::string m_program, m_name, m_mesh, m_curves;

public:
  Tested_program(const std::string& program, const std::string& mesh_bytes, const Scratch_directory& scratch)
    : m_scratch(scratch), m_program(program), m_name(std::filesystem::path(program).filename().string()),
      m_mesh((scratch / "mesh.off").string()), m_curves((scratch / "curves.polylines.txt").string())
  {
    write_file(m_mesh, mesh_bytes);
    write_file(m_curves, sample_curves().bytes);
  }

  bool is_given() const { return !m_program.empty(); }
  bool is_validation() const { return m_name == "validate_geodesic_offsets"; }

  /// Returns whether the program accepts a file with the extension. Throws std::logic_error.
  bool accepts(const std::string& extension, const std::string& bytes) const
  {
    const std::string file = (m_scratch / ("file" + extension)).string();
    write_file(file, bytes);
    const Program_result result = run_program(m_program, arguments(extension == ".polylines.txt", file));
    constexpr int not_certified = 3;
    const bool is_accepted = result.exit_code == 0 || (is_validation() && result.exit_code == not_certified);
    require(is_accepted || result.exit_code == 1 || result.exit_code == 2, "a signal, or another exit code");
    require(result.output.empty() != (is_validation() && is_accepted), "a wrong output");
    check_errors(result.errors, is_accepted ? 0 : 1);
    return is_accepted;
  }

private:
  std::vector<std::string> arguments(bool is_polyline, const std::string& file) const
  {
    const std::string &mesh = is_polyline ? m_mesh : file, &curves = is_polyline ? file : m_curves;
    if (is_validation()) return {mesh, "--source-vertex", "0", "--distance", "3", "--curves", curves};
    if (is_polyline) return {mesh, "--source-polyline", file, "--distance", "0.5", "--quiet"};
    return {mesh, "--source-vertex", "0", "--distance", "0.5", "--quiet"};
  }

  // Warnings may precede the error.
  void check_errors(const std::string& errors, std::size_t expected) const
  {
    require(errors.empty() || errors.back() == '\n', "a line that does not end");
    const std::string prefix = m_name + ": ", warning = prefix + "warning: ";
    std::size_t found = 0;
    std::istringstream lines(errors);
    for (std::string line; std::getline(lines, line);)
    {
      require(line.compare(0, prefix.size(), prefix) == 0, "a line that is no message");
      found += line.compare(0, warning.size(), warning) == 0 ? 0 : 1;
    }
    require(found == expected, "a wrong number of errors");
  }
};

/// Runs `count` mutations, number i with seed `seed` + i, with the readers, or with a program if one is given, which reads
/// only meshes, and polylines or curves. A file that causes a fault is written to the current folder and named on standard error.
/// Returns the tallies by extension, and the number of these files, at most 20.
inline std::pair<std::map<std::string, Mutation_tally>, int> run_mutations(std::uint64_t count, std::uint64_t seed,
                                                                           const std::string& program = "")
{
  constexpr double most_seconds = 5; // elapsed
  std::vector<Sample_file> samples = sample_meshes();
  const Scratch_directory scratch;
  const Tested_program tested(program, samples.front().bytes, scratch);
  for (const Sample_file& sample : other_samples())
    if (program.empty() || sample.extension == ".polylines.txt") samples.push_back(sample);
  if (tested.is_validation()) samples.push_back(sample_curves());
  // extensions are equally likely, however many samples they have
  std::map<std::string, std::vector<const Sample_file*>> by_extension;
  for (const Sample_file& sample : samples) by_extension[sample.extension].push_back(&sample);
  std::vector<std::string> extensions;
  for (const auto& entry : by_extension) extensions.push_back(entry.first);

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
    Mutation_tally& tally = tallies[extension];
    const double start = processor_seconds();
    const auto clock_start = std::chrono::steady_clock::now();
    try
    {
      const bool is_accepted = tested.is_given() ? tested.accepts(extension, text)
                                                 : read_input("file" + extension, std::string_view(bytes.data(), bytes.size()));
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
