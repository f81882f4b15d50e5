// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Options of the user, with all checks that need no file.

#ifndef GEODESIC_DISTANCE_MATRIX_OPTIONS_H
#define GEODESIC_DISTANCE_MATRIX_OPTIONS_H

#include "common/command_line.h"
#include "common/common.h"
#include "common/file_identity.h"
#include "common/source_options.h"
#include "geodesic_offset/threads.h"

#include <cstddef>
#include <optional>
#include <ostream>
#include <string>

namespace geodesic_offset {

// Vertices: those of a file, a number of farthest ones, or all.
struct Vertex_choice
{
  std::string file; // empty: none
  std::optional<std::size_t> farthest;
};

struct Matrix_options
{
  std::string mesh, output;
  Vertex_choice sources, targets;
  std::optional<double> cutoff;
  std::optional<std::size_t> threads;
  bool resume = false, quiet = false, help = false, version = false;

  bool is_csv() const { return has_extension(output, ".csv"); }
};

namespace internal {

inline po::options_description matrix_options_description()
{
  po::options_description all(
    "geodesic_distance_matrix MESH --sources all|FILE|farthest N --output FILE [others]\n\n"
    "Writes the exact geodesic distances of vertices from vertices, a row per source. Runs on several machines under\n"
    "mpirun, if it is built with Boost.MPI. MESH is an .off, .obj or .ply file of triangles; it is not repaired.\n"
    "Exit code: 0 if all rows are written; 1 if something that the command line names is wrong, 2 if the command line\n"
    "is wrong. Rows that an aborted run has completed remain");
  const auto word = [](const char* name) { return po::value<std::string>()->value_name(name); };
  const auto choice = [] { return po::value<Words>()->multitoken()->value_name("all|FILE|farthest N"); };
  po::options_description options("Options");
  options.add_options()("sources", choice(),
                        "the vertices of the rows: all, the numbers in a text file, where '#' begins a comment, or N "
                        "vertices, each farthest from those before it")(
    "targets", choice(),
    "the vertices of the columns (default: all)")("cutoff", word("R"), "distances larger than this are inf, and not computed")(
    "output", word("FILE"), "an .npy file of NumPy, or a .csv file with a line per row. Rows that are not computed are nan")(
    "resume", po::bool_switch(),
    "keeps the complete rows of the output and computes the others; mesh, sources, targets and cutoff must be the same")(
    "threads", word("T"), "number of threads (default: all of the machine; 1 if mpirun starts several processes)")(
    "quiet", po::bool_switch(),
    "prints only warnings")("version", po::bool_switch(), "print the version")("help", po::bool_switch(), "print this");
  all.add(options);
  return all;
}

inline Vertex_choice vertex_choice(const po::variables_map& map, const char* name)
{
  const Words words = option_words(map, name);
  Vertex_choice choice;
  const bool is_farthest = !words.empty() && words[0] == "farthest";
  if(is_farthest)
  {
    std::size_t number = 0;
    if(words.size() < 2 || !parse_index(words[1], number) || number == 0)
      throw Usage_error("--" + std::string(name) + " farthest must be followed by a positive whole number" +
                        (words.size() < 2 ? std::string() : ", not " + quoted(words[1])));
    choice.farthest = number;
  }
  else if(!words.empty() && words[0] != "all")
    choice.file = words[0];
  if(words.size() > (is_farthest ? 2u : 1u))
    throw Usage_error("--" + std::string(name) + " is followed by one word too much: " + quoted(words.back()) +
                      "; MESH comes first");
  if(!words.empty() && words[0].empty()) throw Usage_error("--" + std::string(name) + " is empty");
  return choice;
}

inline Matrix_options checked_matrix_options(const po::variables_map& map)
{
  Matrix_options options;
  options.mesh = mesh_option(map);
  if(map.count("sources") == 0) throw Usage_error("no --sources given (all, a file, or farthest and a number)");
  options.sources = vertex_choice(map, "sources");
  options.targets = vertex_choice(map, "targets");
  options.cutoff = optional_positive_number(map, "cutoff");
  options.output = option_word(map, "output");
  if(options.output.empty()) throw Usage_error("no --output given");
  if(!options.is_csv() && !has_extension(options.output, ".npy"))
    throw Usage_error("--output must end in .npy or .csv, not " + quoted(options.output));
  options.threads = number_of_threads(map);
  options.resume = map["resume"].as<bool>();
  options.quiet = map["quiet"].as<bool>();
  Words read{options.mesh};
  for(const Vertex_choice* choice : {&options.sources, &options.targets})
    if(!choice->file.empty()) read.push_back(choice->file);
  check_different_files(read, {options.output});
  return options;
}

} // namespace internal

inline void print_matrix_help(std::ostream& out) { out << internal::matrix_options_description(); }

// Throws Usage_error.
inline Matrix_options parse_matrix_options(int argc, const char* const* argv)
{
  const boost::program_options::variables_map map =
    internal::parsed_command_line(argc, argv, internal::matrix_options_description());
  Matrix_options options;
  options.help = map["help"].as<bool>();
  options.version = map["version"].as<bool>();
  return options.help || options.version ? options : internal::checked_matrix_options(map);
}

} // namespace geodesic_offset

#endif // GEODESIC_DISTANCE_MATRIX_OPTIONS_H
