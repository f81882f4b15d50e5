// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Time, memory and error of other methods and ours in one run, each in a separate process:
//
//   peers [--smsp-limit VERTICES] [--torus VERTICES]... [MESH]...
//
// on the given meshes, and on generated tori with waves, from one vertex, from 64 vertices, and from a plane section of the
// mesh. The methods: ours, exact and within relative tolerances; CGAL::Surface_mesh_shortest_path, up to 30000 vertices by
// default; CGAL::Heat_method_3, if built with Eigen; shortest paths along edges; fast marching. For the section, the sources of
// the other methods are the midpoints of its segments (SMSP, which in CGAL 5.5 finds wrong distances from sources on edges), the
// nearer end of each crossed edge (heat method), or all corners of its faces with their distances (edges, fast marching); ours
// also runs with k points per segment, for increasing k.
//
// A tab-separated table on stdout. `seconds` include the construction and the output of all distances. Errors are those of
// vertex distances, relative to our distances from the true source; `unreached` is the number of vertices at infinity for
// exactly one of the two. A failing method has no figures.

#include "edge_distances.h"
#include "fast_marching.h"
#include "fastest_run.h"
#include "plane_section.h"
#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <iostream>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;
typedef benchmark::Initial_distances<Mesh> Initial_distances;
typedef Geodesic::Face_location Face_location;
typedef test::Section<Mesh> Section;

// Sources of the methods.
struct Source
{
  std::string name;
  std::vector<Mesh::Vertex_index> vertices; // for the heat method; the exact source, if there is no curve
  Initial_distances initial;
  std::vector<Section> curve;
};

Source vertex_source(const std::string& name, const std::vector<Mesh::Vertex_index>& vertices)
{
  Source result{name, vertices, {}, {}};
  for (Mesh::Vertex_index v : vertices) result.initial.push_back({v, 0.});
  return result;
}

Source curve_source(const Mesh& mesh, const std::vector<Section>& curve)
{
  const test::Locations<Mesh> on_mesh(mesh);
  std::set<Mesh::Vertex_index> nearer;
  std::map<Mesh::Vertex_index, double> corners;
  for (const Section& s : curve)
  {
    for (const Face_location& l : s.locations)
    {
      const auto weights = on_mesh.support(l);
      nearer.insert(std::max_element(weights.begin(), weights.end(), [](const auto& a, const auto& b) {
                      return a.second < b.second;
                    })->first);
    }
    for (std::size_t i = 0; i < s.number_of_segments(); ++i)
    {
      const Face_location& end = s.locations[(i + 1) % s.locations.size()];
      const Kernel::Segment_3 segment(on_mesh.point(s.locations[i]), on_mesh.point(end));
      for (Mesh::Vertex_index v : on_mesh.corners(s.faces[i]))
      {
        const double d = std::sqrt(CGAL::squared_distance(mesh.point(v), segment));
        const auto inserted = corners.insert({v, d});
        inserted.first->second = (std::min)(inserted.first->second, d);
      }
    }
  }
  return {"curve", {nearer.begin(), nearer.end()}, {corners.begin(), corners.end()}, curve};
}

// k points on each segment, including its first end, and the ends of open curves.
std::vector<Face_location> samples(const Mesh& mesh, const std::vector<Section>& curve, std::size_t k)
{
  const test::Locations<Mesh> on_mesh(mesh);
  std::vector<Face_location> result;
  for (const Section& s : curve)
  {
    for (std::size_t i = 0; i < s.number_of_segments(); ++i)
    {
      result.push_back(s.locations[i]);
      for (std::size_t j = 1; j < k; ++j)
        result.push_back(s.between(on_mesh, i, static_cast<double>(j) / static_cast<double>(k)));
    }
    if (!s.closed) result.push_back(s.locations.back());
  }
  return result;
}

std::vector<Face_location> middles(const Mesh& mesh, const std::vector<Section>& curve)
{
  const test::Locations<Mesh> on_mesh(mesh);
  std::vector<Face_location> result;
  for (const Section& s : curve)
    for (std::size_t i = 0; i < s.number_of_segments(); ++i) result.push_back(s.between(on_mesh, i, 0.5));
  return result;
}

// All methods on one mesh from one source.
class Comparison
{
public:
  Comparison(const std::string& name, const Mesh& mesh, const Source& source, std::size_t smsp_limit)
    : m_name(name), m_mesh(mesh), m_source(source)
  {
    run("ours", [&](std::vector<double>& distances, std::uint64_t& windows) { ours(0, distances, windows); });
    for (const char* tolerance : {"1e-6", "1e-5", "1e-4", "1e-3", "1e-2"})
      run(std::string("ours, tolerance ") + tolerance,
          [&](std::vector<double>& distances, std::uint64_t& windows) { ours(std::stod(tolerance), distances, windows); });
    if (source.curve.empty()) run_smsp(smsp_limit, m_source.vertices);
    else
    {
      run_smsp(smsp_limit, middles(m_mesh, m_source.curve));
      for (std::size_t k : {1, 2, 4, 8, 16})
        run("ours, " + std::to_string(k) + (k == 1 ? " point" : " points") + " per segment",
            [&](std::vector<double>& distances, std::uint64_t& windows) {
              Geodesic geodesic(m_mesh);
              for (const Face_location& l : samples(m_mesh, m_source.curve, k)) geodesic.add_source_point(l);
              build(geodesic, 0, distances, windows);
            });
    }
    run_heat_method();
    run("edges", [&](std::vector<double>& distances, std::uint64_t&) {
      distances = benchmark::edge_distances(m_mesh, m_source.initial);
    });
    run("fast marching", [&](std::vector<double>& distances, std::uint64_t&) {
      distances = benchmark::Fast_marching<Mesh>(m_mesh)(m_source.initial);
    });
  }

private:
  void build(Geodesic& geodesic, double tolerance, std::vector<double>& distances, std::uint64_t& windows) const
  {
    geodesic.build(CGAL::parameters::relative_tolerance(tolerance));
    for (Mesh::Vertex_index v : m_mesh.vertices()) distances.push_back(geodesic.distance_to_sources(v));
    windows = geodesic.statistics().windows_propagated;
  }

  void ours(double tolerance, std::vector<double>& distances, std::uint64_t& windows) const
  {
    Geodesic geodesic(m_mesh);
    if (m_source.curve.empty())
      for (Mesh::Vertex_index v : m_source.vertices) geodesic.add_source_point(v);
    for (const Section& s : m_source.curve) geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    build(geodesic, tolerance, distances, windows);
  }

  template <class Points>
  void run_smsp(std::size_t limit, const Points& points)
  {
    if (m_mesh.number_of_vertices() > limit) return;
    run("SMSP", [&](std::vector<double>& distances, std::uint64_t&) {
      Shortest_path shortest_path(m_mesh);
      for (const auto& p : points) add(shortest_path, p);
      shortest_path.build_sequence_tree();
      for (Mesh::Vertex_index v : m_mesh.vertices())
      {
        const double d = m_mesh.is_isolated(v) ? -1 : shortest_path.shortest_distance_to_source_points(v).first;
        distances.push_back(d < 0 ? std::numeric_limits<double>::infinity() : d);
      }
    });
  }

  static void add(Shortest_path& shortest_path, Mesh::Vertex_index v) { shortest_path.add_source_point(v); }
  static void add(Shortest_path& shortest_path, const Face_location& l) { shortest_path.add_source_point(l.first, l.second); }

#ifdef CGAL_EIGEN3_ENABLED
  template <class Mode>
  void run_heat_method(const std::string& name)
  {
    run(name, [&](std::vector<double>& distances, std::uint64_t&) {
      CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> heat(m_mesh);
      heat.add_sources(m_source.vertices);
      distances.resize(m_mesh.number_of_vertices());
      heat.estimate_geodesic_distances(boost::make_iterator_property_map(distances.begin(), get(boost::vertex_index, m_mesh)));
    });
  }

  void run_heat_method()
  {
    run_heat_method<CGAL::Heat_method_3::Direct>("heat method, direct");
    run_heat_method<CGAL::Heat_method_3::Intrinsic_Delaunay>("heat method, intrinsic Delaunay");
  }
#else
  void run_heat_method() {}
#endif

  template <class Computation>
  void run(const std::string& method, const Computation& computation)
  {
    std::printf("%s\t%zu\t%s\t%s", m_name.c_str(), std::size_t(m_mesh.number_of_vertices()), m_source.name.c_str(),
                method.c_str());
    try
    {
      const benchmark::Measured_run result = benchmark::fastest_run(computation, 3);
      if (m_exact.empty()) m_exact = result.distances;
      print_figures(result);
    }
    catch (const std::exception& e)
    {
      std::printf("\t\t\t\t\t\t\n");
      std::cerr << m_name << ", " << m_source.name << ", " << method << ": " << e.what() << '\n';
    }
    std::fflush(stdout);
  }

  void print_figures(const benchmark::Measured_run& result) const
  {
    double largest = 0, sum = 0;
    std::size_t compared = 0, unreached = 0;
    for (std::size_t i = 0; i < m_exact.size(); ++i)
    {
      const double d = result.distances[i], exact = m_exact[i];
      if (std::isfinite(d) != std::isfinite(exact)) ++unreached;
      else if (std::isfinite(exact) && exact > 0)
      {
        const double error = std::abs(d - exact) / exact;
        largest = (std::max)(largest, error);
        sum += error;
        ++compared;
      }
    }
    std::printf("\t%.4f\t%.2f\t%llu\t%.3e\t%.3e\t%zu\n", result.seconds, static_cast<double>(result.peak_bytes) / 1e6,
                static_cast<unsigned long long>(result.windows), largest,
                compared == 0 ? 0 : sum / static_cast<double>(compared), unreached);
  }

  std::string m_name;
  const Mesh& m_mesh;
  const Source& m_source;
  std::vector<double> m_exact; // our distances from the true source
};

void compare(const std::string& name, const Mesh& mesh, std::size_t smsp_limit)
{
  std::vector<Mesh::Vertex_index> candidates, spread;
  for (Mesh::Vertex_index v : mesh.vertices())
    if (!mesh.is_isolated(v)) candidates.push_back(v);
  const std::size_t count = (std::min)(candidates.size(), std::size_t(64));
  for (std::size_t i = 0; i < count; ++i) spread.push_back(candidates[i * candidates.size() / count]);
  Comparison(name, mesh, vertex_source("vertex", {candidates.front()}), smsp_limit);
  Comparison(name, mesh, vertex_source(std::to_string(count) + " vertices", spread), smsp_limit);
  const std::vector<Section> curve = test::random_plane_section(mesh, 1);
  if (!curve.empty()) Comparison(name, mesh, curve_source(mesh, curve), smsp_limit);
}

int usage()
{
  std::cerr << "usage: peers [--smsp-limit VERTICES] [--torus VERTICES]... [MESH]...\n";
  return 2;
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t smsp_limit = 30000;
  std::vector<std::size_t> tori;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i) try
    {
      const std::string word = argv[i];
      if (word == "--smsp-limit" && i + 1 < argc) smsp_limit = std::stoul(argv[++i]);
      else if (word == "--torus" && i + 1 < argc) tori.push_back((std::max)(100ul, std::stoul(argv[++i])));
      else if (word.substr(0, 2) == "--") return usage();
      else files.push_back(word);
    }
    catch (const std::exception&)
    {
      return usage();
    }
  if (tori.empty() && files.empty()) return usage();
  std::printf("mesh\tvertices\tsource\tmethod\tseconds\tpeak_mb\twindows\tlargest_error\tmean_error\tunreached\n");
  int result = 0;
  for (std::size_t n : tori) compare("wavy torus", benchmark::Wavy_torus<Mesh>(n).mesh, smsp_limit);
  for (const std::string& file : files) try
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || mesh.number_of_faces() == 0)
        throw std::invalid_argument("not a manifold triangle mesh");
      compare(std::filesystem::path(file).stem().string(), mesh, smsp_limit);
    }
    catch (const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      result = 1;
    }
  return result;
}
