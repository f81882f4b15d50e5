// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Number of propagated windows, relative to the necessary number: windows that are nearest somewhere on their edge, that
// is, in the lower envelope of the windows from both sides and of the paths via the two vertices. As a Markdown table, with
// the memory of windows.
//
//   window_counts [--vertex I] MESH...        default: 0
//
// `set-up`: bytes per vertex of the unfolded mesh; `peak`: peak of a build, including unfolded mesh and front; `front`: the
// most windows held at one time, which are part of the peak.

#include "../Performance/counted_heap.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Lower_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>
#include <CGAL/boost/graph/IO/polygon_mesh_io.h>
#include <CGAL/boost/graph/helpers.h>

#include <cstdio>
#include <filesystem>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

namespace internal = CGAL::Geodesic_offset::internal;
typedef internal::Window<double> Window;
typedef boost::property_map<Mesh, boost::vertex_index_t>::const_type Vertex_index_map;
typedef boost::property_map<Mesh, boost::face_index_t>::const_type Face_index_map;
typedef boost::property_map<Mesh, boost::vertex_point_t>::const_type Vertex_point_map;
typedef internal::Geodesic_surface<Traits, Vertex_index_map, Face_index_map, Vertex_point_map> Surface;

// The window on the twin of its halfedge, which has the same length.
Window seen_from_behind(const Window& window, double length)
{
  Window w = window;
  if (w.is_parallel()) w.sigma -= w.x * length;
  w.x = w.is_parallel() ? -w.x : length - w.x;
  return Window(w, length - window.b1, length - window.b0);
}

std::size_t size_of_envelope(const Mesh& mesh, std::size_t source)
{
  internal::Single_worker alone;
  const Surface surface(mesh, get(boost::vertex_index, mesh), get(boost::face_index, mesh), get(boost::vertex_point, mesh),
                        internal::No_lengths(), internal::No_barriers(), Traits(), alone);
  const internal::Unfolded_mesh<double>& unfolded = surface.unfolded;
  internal::Source_set<double> sources;
  const Mesh::Vertex_index v(static_cast<Mesh::size_type>(source));
  sources.insert(0, {sources.POINT, {internal::Surface_point<double>::at_vertex(surface.index_of(v))}, {}, 0., {}});
  internal::Build_request<double> request;
  request.keeps_windows = true;
  typedef Surface::Computing_traits Computing_traits;
  typedef internal::Geodesic_build<Computing_traits> Build;
  Build build(unfolded, sources, request);
  const Computing_traits traits{};
  build.propagate<CGAL::Sequential_tag, Build::parts_for(internal::KEPT_WINDOWS)>(traits);

  internal::Lower_envelope<Computing_traits> envelope(build.initial.source_of, traits);
  std::vector<Window> windows;
  std::size_t number = 0;
  for (internal::Index h = 0; h < unfolded.number_of_halfedges(); ++h)
  {
    const internal::Index twin = unfolded.twin(h);
    // border halfedges have no twin, and are visited on their own
    if (unfolded.source(h) == internal::no_index || twin < h) continue;
    const double length = unfolded[h].length;
    const auto& distance = build.field.distance;
    const double allowance =
      internal::pruning_allowance<double>(distance[unfolded.source(h)] + length, unfolded.longest_edge());
    const internal::Window_pruning<double> pruning(length, distance[unfolded.source(h)], distance[unfolded.target(h)],
                                                   allowance);
    windows.clear();
    const auto add = [&](const Window& whole) {
      Window w = whole;
      if (pruning.trim(w)) windows.push_back(w);
    };
    build.field.kept.for_each(h, length, distance, build.field.source_ref, add);
    if (twin != internal::no_index)
      build.field.kept.for_each(twin, length, distance, build.field.source_ref, [&](const Window& w) {
        add(seen_from_behind(w, length));
      });
    const Window* const first = windows.data();
    number += envelope(first, first + windows.size(), length).size();
  }
  return number;
}

bool count(const std::string& file, std::size_t source)
{
  Mesh mesh;
  if (!CGAL::IO::read_polygon_mesh(file, mesh) || !CGAL::is_triangle_mesh(mesh) || source >= num_vertices(mesh))
  {
    std::cerr << file << " is not a manifold triangle mesh with a vertex " << source << '\n';
    return false;
  }
  const double n = static_cast<double>(num_vertices(mesh));
  const benchmark::Counted_heap heap;
  Geodesic geodesic(mesh);
  const double set_up = static_cast<double>(heap.bytes()) / n;
  geodesic.add_source_point(Mesh::Vertex_index(static_cast<Mesh::size_type>(source)));
  geodesic.build();
  const double peak = static_cast<double>(heap.peak_bytes()) / n;
  const auto& statistics = geodesic.statistics();
  const double front = static_cast<double>(statistics.windows_peak * sizeof(Window)) / n;
  const std::size_t envelope = size_of_envelope(mesh, source), propagated = statistics.windows_propagated;
  std::printf("| %s | %zu | %zu | %zu | %.3f | %.0f | %.0f | %.0f | %.0f |\n",
              std::filesystem::path(file).stem().string().c_str(), std::size_t(num_vertices(mesh)), propagated, envelope,
              static_cast<double>(propagated) / static_cast<double>(envelope), set_up, peak, front, peak - front);
  std::fflush(stdout);
  return true;
}

} // namespace

int main(int argc, char* argv[])
{
  std::size_t source = 0;
  std::vector<std::string> files;
  for (int i = 1; i < argc; ++i)
  {
    const std::string word = argv[i];
    if (word == "--vertex" && i + 1 < argc) source = std::stoul(argv[++i]);
    else files.push_back(word);
  }
  if (files.empty())
  {
    std::cerr << "usage: window_counts [--vertex I] MESH...\n";
    return 2;
  }
  std::puts("| mesh | vertices | windows propagated | in the envelope | ratio | set-up, bytes per vertex | peak | front | "
            "without front |\n|---|---|---|---|---|---|---|---|---|");
  bool ok = true;
  for (const std::string& file : files) try
    {
      ok = count(file, source) && ok;
    }
    catch (const std::exception& e)
    {
      std::cerr << file << ": " << e.what() << '\n';
      ok = false;
    }
  return ok ? 0 : 1;
}
