// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Many fields of a mesh, as Markdown tables:
//
//   many_fields [--sources N] [--peer-sources N] [--samples N] [--large VERTICES] [MESH]...
//
// Distance matrices of N sources (default: 2000) and all vertices of the given meshes, or of a wavy torus of 30000 vertices with
// noise: on one thread and on all that TBB allows, each against one thread; half of the matrix of the sources; a loop of builds; and
// peers, CGAL::Heat_method_3 with one factorisation (if built with Eigen) and CGAL::Surface_mesh_shortest_path. The last three
// compute fewer sources (default: 20), and `s for all` is extrapolated for them by the time per source without the set-up. Memory
// is that of the whole computation, without the mesh. Errors are those against the matrix on one thread, relative to the distance.
//
// Local builds on a torus of many vertices (default: 1000000), and on a tenth of it: the distance along an edge, and a row with a
// limit of five mean edges to all vertices, whose difference between both meshes is the share that depends on their size, and the
// time of cache misses; a call of the function for one row, which reads all targets; and the same row as builds of the class. Times
// are the means of runs around a thousand vertices.
//
// Farthest points on a torus of 100000 vertices with noise (default: 5000), and the time per window that they propagate; against
// update() of a field with kept windows for the first twenty, by the time per sample.

#include "measured_run.h"
#include "wavy_torus.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>
#include <CGAL/Surface_mesh_shortest_path.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#ifdef CGAL_EIGEN3_ENABLED
#include <CGAL/Heat_method_3/Surface_mesh_geodesic_distances_3.h>
#endif

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef Mesh::Vertex_index Vertex_index;
typedef std::vector<Vertex_index> Vertices;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, Mesh>> Shortest_path;

class Clock
{
public:
  double seconds() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count(); }

private:
  std::chrono::steady_clock::time_point m_start = std::chrono::steady_clock::now();
};

Mesh noisy_torus(std::size_t n)
{
  Mesh mesh = benchmark::Wavy_torus<Mesh>(n).mesh;
  const double noise = 0.1 * Geodesic(mesh).mesh().mean_edge_length();
  std::mt19937 random(7);
  const auto move = [&] { return noise * (double(random()) / 2147483648. - 1); };
  for (const Vertex_index v : mesh.vertices())
  {
    const double x = move(), y = move(), z = move();
    mesh.point(v) = mesh.point(v) + Kernel::Vector_3(x, y, z);
  }
  return mesh;
}

Vertices random_vertices(const Mesh& mesh, std::size_t n)
{
  std::mt19937 random(3);
  Vertices result(n);
  for (Vertex_index& v : result) v = Vertex_index(Mesh::size_type(random() % mesh.number_of_vertices()));
  return result;
}

// The methods for the matrix of one mesh.
class Matrices
{
public:
  Matrices(const std::string& name, const Mesh& mesh, std::size_t sources, std::size_t peer_sources)
    : m_name(name), m_mesh(mesh), m_all(mesh.vertices().begin(), mesh.vertices().end()),
      m_sources(random_vertices(mesh, sources)),
      m_few(m_sources.begin(), m_sources.begin() + std::ptrdiff_t((std::min)(sources, peer_sources)))
  {
  }

  void run()
  {
    run("matrix", true, [&](auto keep, auto&) { matrix<CGAL::Sequential_tag>(keep, m_all); });
#ifdef CGAL_LINKED_WITH_TBB
    run("matrix, all threads", true, [&](auto keep, auto&) { matrix<CGAL::Parallel_tag>(keep, m_all); });
#endif
    run("matrix of the sources", true, [&](auto, auto&) { matrix<CGAL::Sequential_tag>(nothing, m_sources); });
    run("half of it", true, [&](auto, auto&) { matrix<CGAL::Sequential_tag>(nothing, m_sources, true); });
    run("builds", false, [&](auto keep, double& set_up) {
      const Clock clock;
      Geodesic geodesic(m_mesh);
      set_up = clock.seconds();
      for (const Vertex_index v : m_few)
      {
        geodesic.clear_sources();
        geodesic.add_source_point(v);
        geodesic.build();
        keep(row([&](Vertex_index u) { return geodesic.distance_to_sources(u); }));
      }
    });
#ifdef CGAL_EIGEN3_ENABLED
    heat<CGAL::Heat_method_3::Direct>("heat method, direct");
    heat<CGAL::Heat_method_3::Intrinsic_Delaunay>("heat method, intrinsic Delaunay");
#endif
    run("SMSP", false, [&](auto keep, double& set_up) {
      const Clock clock;
      Shortest_path paths(m_mesh);
      set_up = clock.seconds();
      for (const Vertex_index v : m_few)
      {
        paths.remove_all_source_points();
        paths.add_source_point(v);
        keep(row([&](Vertex_index u) { return paths.shortest_distance_to_source_points(u).first; }));
      }
    });
  }

private:
  static void nothing(const std::vector<double>&) {}

  // A row of the matrix: distance_to(v) for all vertices.
  template <class Query>
  std::vector<double> row(const Query& distance_to) const
  {
    std::vector<double> result;
    for (const Vertex_index v : m_all) result.push_back(distance_to(v));
    return result;
  }

  // Hands the rows of the first sources to `keep`.
  template <class Tag, class Keep>
  void matrix(const Keep& keep, const Vertices& targets, bool is_half = false) const
  {
    CGAL::geodesic_distance_matrix(
      m_mesh, m_sources, targets,
      [&](std::size_t i, const std::vector<double>& row) {
        if (i < m_few.size()) keep(row);
      },
      CGAL::parameters::concurrency_tag(Tag()).upper_half(is_half));
  }

#ifdef CGAL_EIGEN3_ENABLED
  template <class Mode>
  void heat(const std::string& method)
  {
    run(method, false, [&](auto keep, double& set_up) {
      const Clock clock;
      CGAL::Heat_method_3::Surface_mesh_geodesic_distances_3<Mesh, Mode> heat(m_mesh);
      std::vector<double> row(m_all.size());
      const auto map = boost::make_iterator_property_map(row.begin(), get(boost::vertex_index, m_mesh));
      heat.add_source(m_sources.front());
      heat.estimate_geodesic_distances(map); // factorises
      set_up = clock.seconds();
      for (const Vertex_index v : m_few)
      {
        heat.clear_sources();
        heat.add_source(v);
        heat.estimate_geodesic_distances(map);
        keep(row);
      }
    });
  }
#endif

  template <class Method>
  void run(const std::string& name, bool has_all, const Method& method)
  {
    const benchmark::Measured_run r = benchmark::measured_run([&](std::vector<double>& distances, std::uint64_t&) {
      double set_up = 0;
      method([&](const std::vector<double>& row) { distances.insert(distances.end(), row.begin(), row.end()); }, set_up);
      distances.push_back(set_up);
    });
    const double set_up = r.distances.back(), n = double(has_all ? m_sources.size() : m_few.size());
    const double by_source = (r.seconds - set_up) / n;
    const double all = has_all ? r.seconds : set_up + by_source * double(m_sources.size());
    if (m_exact.empty())
    {
      m_exact = r.distances;
      m_seconds = r.seconds;
    }
    double error = 0;
    for (std::size_t i = 0; i + 1 < r.distances.size(); ++i)
      if (m_exact[i] > 0) error = (std::max)(error, std::abs(r.distances[i] - m_exact[i]) / m_exact[i]);
    std::printf("| %s | %zu | %s | %.0f | %.3f | %.2f | %.1f%s | %.2f | %.1f | %.1e |\n", m_name.c_str(), m_all.size(),
                name.c_str(), n, set_up, 1e3 * by_source, all, has_all ? "" : ", extrapolated", m_seconds / all,
                double(r.peak_bytes) / 1e6, error);
    std::fflush(stdout);
  }

  const std::string m_name;
  const Mesh& m_mesh;
  const Vertices m_all, m_sources, m_few;
  std::vector<double> m_exact; // rows of the first sources
  double m_seconds = 0;        // of the matrix on one thread
};

void run_local(std::size_t vertices)
{
  const Mesh mesh = benchmark::Wavy_torus<Mesh>(vertices).mesh;
  const Vertices all(mesh.vertices().begin(), mesh.vertices().end()), sources = random_vertices(mesh, 1000);
  Geodesic geodesic(mesh);
  const Geodesic::Mesh& set_up = geodesic.mesh();
  const double n = double(sources.size()), edge = set_up.mean_edge_length();
  const auto print = [&](const char* what, double seconds, double reached) {
    std::printf("| %zu | %s | %.1f | %.1f |\n", std::size_t(mesh.number_of_vertices()), what, 1e6 * seconds, reached);
    std::fflush(stdout);
  };
  for (const bool is_first : {true, false})
  {
    const Clock clock;
    for (const Vertex_index v : sources)
    {
      CGAL::geodesic_distance(set_up, v, mesh.source(mesh.halfedge(v)));
      if (is_first) break;
    }
    print(is_first ? "first pair" : "pair at an edge", clock.seconds() / (is_first ? 1 : n), 1);
  }
  for (const double edges : {0., 5.})
  {
    std::size_t reached = 0;
    const auto count = [&](std::size_t, const std::vector<double>&, const std::vector<std::size_t>& r) { reached += r.size(); };
    const auto limit = CGAL::parameters::distance_limit(edges * edge);
    const auto seconds = [&](const Vertices& rows) {
      reached = 0;
      const Clock clock;
      CGAL::geodesic_distance_matrix(set_up, rows, all, count, limit);
      return clock.seconds();
    };
    const double call = seconds(Vertices(1, sources[0])); // reads the targets
    const double row = (seconds(sources) - call) / (n - 1);
    print(edges == 0 ? "row, limit 0" : "row, limit 5 edges", row, double(reached) / n);
    print("call of one row", call, 1);
  }
  const Clock clock;
  for (int i = 0; i < 20; ++i)
  {
    geodesic.clear_sources();
    geodesic.add_source_point(sources[std::size_t(i)]);
    geodesic.build(CGAL::parameters::distance_limit(5 * edge));
  }
  print("build of the class, limit 5 edges", clock.seconds() / 20, 0);
}

void run_farthest(std::size_t vertices, std::size_t samples)
{
  namespace internal = CGAL::Geodesic_offset::internal;
  const Mesh mesh = noisy_torus(vertices);
  Geodesic geodesic(mesh);
  const Geodesic::Mesh& set_up = geodesic.mesh();
  Vertices selected;
  const Clock clock;
  const double radius = CGAL::geodesic_farthest_points(set_up, samples, std::back_inserter(selected));
  const double seconds = clock.seconds();

  // the same fronts, and their windows
  const auto& data = internal::Mesh_access::data(set_up);
  internal::Build_series<internal::Surface_of<Geodesic::Mesh>> series(data);
  std::size_t windows = 0;
  const Clock fronts;
  series.build({}, {});
  for (std::size_t i = 0; i < selected.size(); ++i)
  {
    series.add_source(internal::Index(i), internal::Surface_point<double>::at_vertex(data.surface().index_of(selected[i])));
    windows += series.last().statistics.windows_created;
  }
  const double in_fronts = fronts.seconds();

  geodesic.add_source_point(selected[0]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const Clock updates;
  const std::size_t n = (std::min)(selected.size(), std::size_t(21));
  for (std::size_t i = 1; i < n; ++i)
  {
    geodesic.add_source_point(selected[i]);
    geodesic.update();
  }
  std::printf("| %zu | %zu | %.2f | %.4f | %.2e | %.2f | %.2f | %.1f |\n", std::size_t(mesh.number_of_vertices()),
              selected.size(), seconds, radius, double(windows), 1e6 * seconds / double(windows),
              1e6 * in_fronts / double(windows), 1e3 * updates.seconds() / double(n - 1));
}

void run(int argc, char* argv[])
{
  std::size_t sources = 2000, peer_sources = 20, samples = 5000, large = 1000000;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string a = argv[i];
    std::size_t* const number =
      a == "--sources"        ? &sources
      : a == "--peer-sources" ? &peer_sources
      : a == "--samples"      ? &samples
      : a == "--large"        ? &large
                              : nullptr;
    if (number == nullptr) files.push_back(a);
    else if (i + 1 == argc) throw std::runtime_error(a + " needs a number");
    else *number = std::stoul(argv[++i]);
  }
  std::puts("| mesh | vertices | method | sources | set-up s | ms per source | s for all | times faster | MB | largest error |\n"
            "|---|---|---|---|---|---|---|---|---|---|");
  if (files.empty()) Matrices("wavy torus with noise", noisy_torus(30000), sources, peer_sources).run();
  for (const std::string& file : files)
  {
    Mesh mesh;
    if (!CGAL::IO::read_polygon_mesh(file, mesh)) throw std::runtime_error(file + " cannot be read");
    Matrices(file.substr(file.rfind('/') + 1), mesh, sources, peer_sources).run();
  }
  std::puts("\n| vertices | build | microseconds | vertices reached |\n|---|---|---|---|");
  for (const std::size_t n : {large / 10, large}) run_local(n);
  std::puts("\n| vertices | samples | s | covering radius | windows | us per window | of them in fronts | ms of an update() |\n"
            "|---|---|---|---|---|---|---|---|");
  run_farthest(100000, samples);
}

} // namespace

int main(int argc, char* argv[])
{
  try
  {
    run(argc, argv);
    return 0;
  }
  catch (const std::exception& e)
  {
    std::cerr << "many_fields: " << e.what() << '\n';
    return 1;
  }
}
