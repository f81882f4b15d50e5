// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves against exact arrangements of the same windows, face by face: on few faces with many sources, and on meshes.
//
//   offset_oracle [--seed N] [--faces N] [--seconds S] [--each N] [--limit FACES] [--printed N] [MESH or FOLDER]...
//
// With meshes, --faces faces (1000) on each of them, shared by ten levels from the first vertex, five points and the section
// by a plane; meshes with more than --limit faces (200000) are left out. Without, as many faces of random windows in all,
// at most --each (20) of a level; no case starts after --seconds.
//
// A table with tabs on stdout: name; faces; chains and loops of the level in them; pieces of the curves, and the most in one
// face; windows; faces that are undecided because rounding decides their topology; faces with too many windows; faces with
// other topology; faces whose curves are more than 1e-6 apart; exceptions of the arrangement; the largest distance of the
// curves. The exit code is 1 if anything differs.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "offset_oracle.h"
#include "plane_section.h"

#include <chrono>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace test;

struct Options
{
  unsigned seed = 1;
  std::size_t faces = 1000, each = 20, limit = 200000, printed = 20;
  double seconds = 1e9;
};

class Run
{
public:
  explicit Run(const Options& options) : options_(options)
  {
    std::printf("name\tfaces\tchains\tloops\tpieces\tmost\twindows\tundecided\tleft out\ttopology\tapart\tthrown\tdistance\n");
  }

  void random_windows()
  {
    Oracle_counts counts;
    const auto start = std::chrono::steady_clock::now();
    for (unsigned seed = options_.seed; counts.faces < options_.faces; ++seed)
    {
      if (std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() > options_.seconds) break;
      Random random(seed);
      const Generated_mesh<Surface_mesh> data(oracle_faces(random));
      Open_geodesic geodesic(data.mesh);
      add_oracle_sources(geodesic, data.mesh, random);
      compare("seed " + std::to_string(seed), data.mesh, geodesic, 3, options_.each, random, counts);
    }
    print("random windows", counts);
  }

  void mesh(const std::string& name, const Surface_mesh& mesh)
  {
    Random random(options_.seed);
    const auto sections = random_plane_section(mesh, 1);
    Oracle_counts counts;
    for (int kind = 0; kind < 3; ++kind)
    {
      Open_geodesic geodesic(mesh);
      if (kind == 0) geodesic.add_source_point(mesh.source(mesh.halfedge(*mesh.faces().begin())));
      for (int i = 0; kind == 1 && i < 5; ++i)
        geodesic.add_source_point(Face_location(
          *std::next(mesh.faces().begin(), std::ptrdiff_t(uniform_index(random, mesh.number_of_faces()))),
          random_barycentric(random)));
      for (std::size_t i = 0; kind == 2 && i < sections.size(); ++i)
        geodesic.add_source_polyline(sections[i].locations, sections[i].closed);
      if (geodesic.number_of_sources() == 0) continue;
      compare(name, mesh, geodesic, 10, options_.faces / 30 + 1, random, counts);
    }
    print(name, counts);
  }

  bool is_right() const { return is_right_; }

private:
  void compare(const std::string& name, const Surface_mesh& mesh, Open_geodesic& geodesic, int levels, std::size_t faces,
               Random& random, Oracle_counts& counts)
  {
    geodesic.build(CGAL::parameters::keep_windows(true));
    const double largest = geodesic.largest_distance();
    Offset_oracle oracle(geodesic, mesh);
    for (int i = 0; i < levels; ++i)
      counts.add(oracle(uniform(random, 0.02, 1) * largest, faces, random, [&](const std::string& text) {
        if (++printed_ <= options_.printed) std::printf("%s: %s\n", name.c_str(), text.c_str());
      }));
  }

  void print(const std::string& name, const Oracle_counts& c)
  {
    std::printf("%s\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%zu\t%.1e\n", name.c_str(), c.faces, c.chains, c.loops,
                c.arcs, c.most_arcs, c.windows, c.undecided, c.left_out, c.topology, c.apart, c.thrown, c.worst_distance);
    std::fflush(stdout);
    is_right_ = is_right_ && c.differences() == 0 && c.thrown == 0;
  }

  const Options options_;
  std::size_t printed_ = 0;
  bool is_right_ = true;
};

int run(int argc, char** argv)
{
  Options options;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    if (name.compare(0, 2, "--") == 0)
    {
      const std::string text = i + 1 < argc ? argv[++i] : "";
      if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument(name + ": not a number: " + text);
      const std::size_t value = std::stoul(text);
      if (name == "--seed") options.seed = static_cast<unsigned>(value);
      else if (name == "--faces") options.faces = value;
      else if (name == "--each") options.each = value;
      else if (name == "--limit") options.limit = value;
      else if (name == "--printed") options.printed = value;
      else if (name == "--seconds") options.seconds = double(value);
      else throw std::invalid_argument("unknown option " + name);
    }
    else if (std::filesystem::is_directory(name))
    {
      std::vector<std::filesystem::path> inside;
      for (const auto& entry : std::filesystem::directory_iterator(name)) inside.push_back(entry.path());
      std::sort(inside.begin(), inside.end());
      files.insert(files.end(), inside.begin(), inside.end());
    }
    else if (std::filesystem::exists(name)) files.push_back(name);
    else throw std::invalid_argument("no such file: " + name);
  }
  Run run(options);
  if (files.empty()) run.random_windows();
  for (const auto& file : files)
  {
    Surface_mesh mesh;
    const std::string failure = read_data_mesh(file, options.limit, mesh);
    if (failure.empty()) run.mesh(file.filename().string(), mesh);
    else std::cerr << file.string() << ": " << failure << '\n';
  }
  return run.is_right() ? 0 : 1;
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
