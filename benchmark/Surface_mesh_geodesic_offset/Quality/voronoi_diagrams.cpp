// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Voronoi diagrams of random sources against the distances from each source alone, as a Markdown table:
//
//   voronoi_diagrams [--sources N] [--seed S] [--start-values] MESH...      default: 50 sources, seed 1
//
// `distances`: largest difference of the distances from the two sources of a curve, at three points of each of its pieces, and the
// largest excess over the least distance, relative to this distance plus 1 % of the diagonal. `labels`: random points of faces
// that no curve crosses, and how many of them are nearer to another source. `areas`: the sum of the areas of the cells of the split
// mesh, relative to that of the surface, minus 1. The exit code is 1 if a difference exceeds 1e-10 or a label is wrong.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/bbox.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <limits>
#include <random>
#include <set>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef Geodesic::Face_location Location;
typedef Mesh::Face_index Face_index;

constexpr double tolerance = 1e-10;
constexpr int number_of_labels = 3000;

struct Options
{
  std::size_t sources = 50;
  unsigned seed = 1;
  bool has_start_values = false;
};

struct Source
{
  Location location;
  double start;
};

struct Bisector_point
{
  Location location;
  std::size_t left, right; // sources; equal: the label of an uncrossed face
};

double seconds_since(std::chrono::steady_clock::time_point t)
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - t).count();
}

bool check(const std::string& file, const Options& options)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh))
  {
    std::cerr << file << " is not a manifold triangle mesh\n";
    return false;
  }
  std::mt19937 random(options.seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  const auto random_location = [&] {
    double a = uniform(random), b = uniform(random);
    if (a + b > 1)
    {
      a = 1 - a;
      b = 1 - b;
    }
    const std::size_t f = std::uniform_int_distribution<std::size_t>(0, mesh.number_of_faces() - 1)(random);
    return Location(Face_index(static_cast<Mesh::size_type>(f)), {1 - a - b, a, b});
  };
  const CGAL::Bbox_3 box = CGAL::Polygon_mesh_processing::bbox(mesh);
  const double diagonal = std::hypot(box.x_span(), box.y_span(), box.z_span()),
               area = CGAL::Polygon_mesh_processing::area(mesh);
  const double spacing = std::sqrt(area / double(options.sources));
  std::vector<Source> sources;
  for (std::size_t i = 0; i < options.sources; ++i)
  {
    const Location l = random_location();
    sources.push_back({l, options.has_start_values ? 0.1 * spacing * uniform(random) : 0});
  }
  const auto add = [](Geodesic& g, const Source& s) { g.add_source_point(s.location, CGAL::parameters::start_value(s.start)); };

  Geodesic geodesic(mesh);
  for (const Source& s : sources) add(geodesic, s);
  auto start = std::chrono::steady_clock::now();
  const auto field = geodesic.build(CGAL::parameters::keep_windows(true));
  const double build_seconds = seconds_since(start);
  start = std::chrono::steady_clock::now();
  const auto diagram = field.voronoi_diagram();
  const double diagram_seconds = seconds_since(start);

  std::vector<Bisector_point> points;
  std::set<Face_index> crossed;
  std::size_t pieces = 0;
  for (const auto& c : diagram.curves())
    for (const auto& p : c.pieces())
    {
      ++pieces;
      crossed.insert(p.face());
      for (const double t : {0., 0.4, 0.8}) points.push_back({p.location(t), p.source_on_left(), p.source_on_right()});
    }
  const std::size_t on_curves = points.size();
  for (int i = 0; i < number_of_labels; ++i)
  {
    const Location l = random_location();
    if (crossed.count(l.first) == 0) points.push_back({l, diagram.source_at_face(l.first), diagram.source_at_face(l.first)});
  }
  const double infinity = std::numeric_limits<double>::infinity();
  std::vector<double> least(points.size(), infinity), left(least), right(least);
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    Geodesic alone(geodesic.mesh());
    add(alone, sources[s]);
    const auto from_one = alone.build(CGAL::parameters::keep_windows(true));
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      const double d = from_one.distance_to_sources(points[i].location);
      least[i] = (std::min)(least[i], d);
      if (points[i].left == s) left[i] = d;
      if (points[i].right == s) right[i] = d;
    }
  }
  double distances = 0;
  std::size_t wrong = 0, unreached = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (!(least[i] < infinity))
    {
      ++unreached;
      wrong += points[i].left != Geodesic::Field::no_source() ? 1 : 0;
      continue;
    }
    const double error =
      (std::max)(std::abs(left[i] - right[i]), (std::max)(left[i], right[i]) - least[i]) / (least[i] + 0.01 * diagonal);
    if (i < on_curves) distances = (std::max)(distances, error);
    else wrong += error > tolerance ? 1 : 0;
  }

  auto cell = mesh.add_property_map<Face_index, std::size_t>("f:cell", 0).first;
  double reached = 0, cells = 0;
  for (const Face_index f : mesh.faces())
    if (diagram.source_at_face(f) != Geodesic::Field::no_source()) reached += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  start = std::chrono::steady_clock::now();
  CGAL::split_along_geodesic_voronoi_diagram(mesh, diagram, CGAL::parameters::face_source_map(cell));
  const double split_seconds = seconds_since(start);
  for (const Face_index f : mesh.faces())
    if (cell[f] < sources.size()) cells += CGAL::Polygon_mesh_processing::face_area(f, mesh);
  const bool is_right =
    distances <= tolerance && wrong == 0 && std::abs(cells / reached - 1) <= tolerance && CGAL::is_valid_polygon_mesh(mesh);
  std::printf("| %s | %zu | %zu | %zu | %zu | %zu | %zu | %zu | %.1e | %zu, %zu | %.1e | %.2f | %.2f | %.2f |\n",
              std::filesystem::path(file).stem().string().c_str(), diagram.number_of_curves(), diagram.number_of_vertices(),
              pieces, crossed.size(), diagram.number_of_divisions(), diagram.number_of_forced_cells(), on_curves, distances,
              points.size() - on_curves - unreached, wrong, cells / reached - 1, build_seconds, diagram_seconds, split_seconds);
  std::fflush(stdout);
  return is_right;
}

} // namespace

int main(int argc, char* argv[])
{
  Options options;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--sources" && i + 1 < argc) options.sources = std::stoul(argv[++i]);
    else if (word == "--seed" && i + 1 < argc) options.seed = static_cast<unsigned>(std::stoul(argv[++i]));
    else if (word == "--start-values") options.has_start_values = true;
    else files.push_back(word);
  }
  if (files.empty() || options.sources == 0)
  {
    std::cerr << "usage: voronoi_diagrams [--sources N] [--seed S] [--start-values] MESH...\n";
    return 2;
  }
  std::puts(
    "| mesh | curves | vertices | pieces | crossed faces | divisions | forced cells | points | distances | labels, wrong | "
    "areas | build, s | diagram, s | split, s |\n|---|---|---|---|---|---|---|---|---|---|---|---|---|---|");
  bool ok = true;
  for (const std::string& file : files) try
    {
      ok = check(file, options) && ok;
    }
    catch (const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      ok = false;
    }
  return ok ? 0 : 1;
}
