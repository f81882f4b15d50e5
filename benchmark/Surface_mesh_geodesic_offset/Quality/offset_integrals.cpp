// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lengths and areas of offsets: the derivative of the area of {D < d} with respect to d is the length of the offset at d,
// the integral of all lengths is the area of the surface, and both sides together are the whole offset.
//
//   offset_integrals [--faces LIMIT] [--levels N] [--whole LIMIT] [MESH or FOLDER]...
//
// Meshes of up to --faces faces (200000), with three sources each: the first vertex, five points in faces, a plane section.
// For each source N levels (10), with the derivative at random distances; on meshes of up to --whole faces (500), the
// integral over all levels.
//
// A tab-separated table on stdout: mesh, sources, faces; number of distances, and of those at events, where the derivative
// does not exist; the largest relative difference of derivative and length; that of both sides and the whole; that of the
// integral of all lengths and the area, the sum of the remainders over its levels, and their number. Unusable meshes are
// named on stderr. The exit code is 1 if a difference exceeds 1e-9.

#include "data_meshes.h"
#include "generated_meshes.h"
#include "locations.h"
#include "offset_integrals.h"
#include "plane_section.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using namespace test;

struct Options
{
  std::size_t faces = 200000, levels = 10, whole = 500;
};

class Run
{
public:
  explicit Run(const Options& options) : m_options(options) {}

  void operator()(const std::string& name, const Surface_mesh& mesh)
  {
    Random random(1);
    const auto sections = random_plane_section(mesh, 1);
    const auto vertex = [&](Geodesic& g) {
      for (const auto v : mesh.vertices())
        if (!mesh.is_isolated(v)) return (void)g.add_source_point(v);
    };
    const auto points = [&](Geodesic& g) {
      Random same(2);
      for (int i = 0; i < 5; ++i)
      {
        const auto f = *std::next(mesh.faces().begin(), std::ptrdiff_t(uniform_index(same, mesh.number_of_faces())));
        g.add_source_point(Face_location(f, random_barycentric(same)));
      }
    };
    const auto curve = [&](Geodesic& g) {
      for (const auto& s : sections) g.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    };
    run(name, "vertex", mesh, vertex, false, random);
    run(name, "points", mesh, points, false, random);
    if (!sections.empty()) run(name, "section", mesh, curve, true, random);
  }

  void operator()(const std::string& name, const Soup& soup)
  {
    const Generated_mesh<Surface_mesh> data(soup);
    (*this)(name, data.mesh);
  }

  bool is_right() const { return m_is_right; }

private:
  void run(const std::string& name, const std::string& sources, const Surface_mesh& mesh,
           const std::function<void(Geodesic&)>& add_sources, bool has_sides, Random& random)
  {
    try
    {
      Geodesic geodesic(mesh);
      add_sources(geodesic);
      geodesic.build(CGAL::parameters::keep_windows(true));
      Offset_integrals integrals(geodesic, mesh);
      std::size_t at_events = 0;
      double derivative = 0, sides = 0;
      for (std::size_t i = 0; i < m_options.levels; ++i)
      {
        const double d = uniform(random, 0.02, 0.98) * integrals.largest_distance();
        Coarea coarea;
        if (integrals.derivative_at(d, coarea)) derivative = (std::max)(derivative, coarea.relative_difference());
        else ++at_events;
        if (has_sides) sides = (std::max)(sides, lengths_by_side(geodesic, d).relative_difference());
      }
      std::printf("%s\t%s\t%zu\t%zu\t%zu\t%.1e\t%.1e", name.c_str(), sources.c_str(), std::size_t(mesh.number_of_faces()),
                  m_options.levels, at_events, derivative, sides);
      double whole = 0, left_over = 0;
      if (mesh.number_of_faces() <= m_options.whole)
      {
        const std::size_t before = integrals.number_of_levels();
        const Coarea sum = integrals.over_all_levels(2e-10, left_over);
        whole = (std::max)(std::abs(sum.area - integrals.total_area()), std::abs(sum.integral - integrals.total_area())) /
                integrals.total_area();
        left_over /= integrals.total_area();
        std::printf("\t%.1e\t%.1e\t%zu", whole, left_over, integrals.number_of_levels() - before);
      }
      std::printf("\n");
      m_is_right = m_is_right && derivative <= 1e-9 && sides <= 1e-9 && whole <= 1e-9 && left_over <= 1e-9;
    }
    catch (const std::exception& e)
    {
      std::cerr << name << ", " << sources << ": " << e.what() << '\n';
      m_is_right = false;
    }
    std::fflush(stdout);
  }

  const Options m_options;
  bool m_is_right = true;
};

void run_file(Run& run, const std::filesystem::path& file, std::size_t limit)
{
  Surface_mesh mesh;
  const std::string failure = read_data_mesh(file, limit, mesh);
  if (failure.empty()) run(file.filename().string(), mesh);
  else std::cerr << file.string() << ": " << failure << '\n';
}

int run(int argc, char** argv)
{
  Options options;
  std::vector<std::filesystem::path> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string name = argv[i];
    std::size_t* const value =
      name == "--faces"    ? &options.faces
      : name == "--levels" ? &options.levels
      : name == "--whole"  ? &options.whole
                           : nullptr;
    if (value != nullptr)
    {
      const std::string text = i + 1 < argc ? argv[++i] : "";
      if (text.empty() || text.size() > 9 || text.find_first_not_of("0123456789") != std::string::npos)
        throw std::invalid_argument(name + ": not a number: " + text);
      *value = std::stoul(text);
    }
    else if (std::filesystem::is_directory(name))
    {
      for (const auto& entry : std::filesystem::directory_iterator(name)) files.push_back(entry.path());
      std::sort(files.begin(), files.end());
    }
    else if (std::filesystem::exists(name)) files.push_back(name);
    else throw std::invalid_argument("no such file or option: " + name);
  }
  Run run(options);
  std::printf("mesh\tsources\tfaces\tdistances\tat events\tderivative\tsides\tintegral\tleft over\tlevels\n");
  run("torus", torus(16, 12));
  run("sphere", icosphere(2));
  run("cube", cube_grid(5));
  run("jittered grid", jittered_grid(12, 9, 7));
  run("cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5));
  for (const auto& file : files) run_file(run, file, options.faces);
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
    std::cerr << "offset_integrals: " << e.what() << '\n';
    return 2;
  }
}
