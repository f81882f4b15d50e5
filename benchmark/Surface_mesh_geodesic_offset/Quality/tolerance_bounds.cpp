// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances of builds with a relative tolerance t against exact ones, at every vertex of meshes: none may be larger by more than
// rounding, nor smaller by more than its error_bound() or t times itself.
//
//   tolerance_bounds MESH...
//
// Five sources per mesh (points, segments across faces, and both), five tolerances; without and with kept windows, with two
// threads if TBB is linked. A Markdown table by tolerance; wrong vertices on stdout. The exit code is 1 if there is one.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/IO/polygon_mesh_io.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

namespace {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh<Kernel::Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;

// Relative rounding of distances, which no bound includes.
const double relative_rounding = 1e-13;

const double tolerances[] = {1e-6, 1e-5, 1e-4, 1e-3, 1e-2};

struct Totals
{
  std::size_t vertices = 0, wrong = 0;
  double too_long = 0, of_bound = 0, of_tolerance = 0; // largest relative excess, and largest parts of what is allowed
};
Totals totals[std::size(tolerances)];

// Sources of kind 0 to 4, the same for each call.
void add_sources(const Mesh& mesh, int kind, Geodesic& geodesic)
{
  std::mt19937 random(static_cast<unsigned>(kind + 1));
  const auto any_face = [&] { return Mesh::Face_index(static_cast<Mesh::size_type>(random() % mesh.number_of_faces())); };
  for (int i = 0; i < (kind + 1) / 2; ++i) // segments across a face
  {
    const auto f = any_face();
    geodesic.add_source_polyline(std::vector<Geodesic::Face_location>{{f, {{0.5, 0.5, 0}}}, {f, {{0, 0.25, 0.75}}}});
  }
  if (kind % 2 == 0)
    for (int i = 0; i <= kind; ++i)
      geodesic.add_source_point(Mesh::Vertex_index(static_cast<Mesh::size_type>(random() % mesh.number_of_vertices())));
}

void check(const std::string& name, const Mesh& mesh, int kind, std::size_t number, const Geodesic& exact,
           const Geodesic& merged)
{
  Totals& sum = totals[number];
  for (const auto v : mesh.vertices())
  {
    const double d = exact.distance_to_sources(v), m = merged.distance_to_sources(v), bound = merged.error_bound(v);
    ++sum.vertices;
    if (!std::isfinite(d) && !std::isfinite(m)) continue;
    const double rounding = relative_rounding * d;
    if (d > 0) sum.too_long = (std::max)(sum.too_long, (m - d) / d);
    if (bound > 0) sum.of_bound = (std::max)(sum.of_bound, (d - m - rounding) / bound);
    if (d > 0) sum.of_tolerance = (std::max)(sum.of_tolerance, (d - m - rounding) / (tolerances[number] * d));
    if (m <= d + rounding && d - m <= bound + rounding && d - m <= tolerances[number] * d + rounding) continue;
    if (++sum.wrong <= 20)
      std::printf("%s, sources %d, tolerance %g, vertex %u: %.17g, exactly %.17g, bound %g\n", name.c_str(), kind,
                  tolerances[number], static_cast<unsigned>(v), m, d, bound);
  }
}

template <class Concurrency_tag>
void check_all(const std::string& name, const Mesh& mesh, int kind, const Geodesic& exact, bool keeps)
{
  for (std::size_t i = 0; i < std::size(tolerances); ++i)
  {
    Geodesic merged(mesh);
    add_sources(mesh, kind, merged);
    merged.build(CGAL::parameters::relative_tolerance(tolerances[i]).keep_windows(keeps).concurrency_tag(Concurrency_tag()));
    check(name, mesh, kind, i, exact, merged);
  }
}

} // namespace

int main(int argc, char* argv[])
{
  if (argc < 2)
  {
    std::cerr << "tolerance_bounds: no mesh is given\n";
    return 2;
  }
  for (int i = 1; i < argc; ++i) try
    {
      Mesh mesh;
      if (!CGAL::IO::read_polygon_mesh(argv[i], mesh) || !CGAL::is_triangle_mesh(mesh) || is_empty(mesh)) continue;
      for (int kind = 0; kind < 5; ++kind)
      {
        Geodesic exact(mesh);
        add_sources(mesh, kind, exact);
        exact.build();
        check_all<CGAL::Sequential_tag>(argv[i], mesh, kind, exact, false);
        check_all<CGAL::Sequential_tag>(argv[i], mesh, kind, exact, true);
#ifdef CGAL_LINKED_WITH_TBB
        check_all<CGAL::Parallel_tag>(argv[i], mesh, kind, exact, false);
#endif
      }
    }
    catch (const std::exception& e)
    {
      std::cerr << argv[i] << ": " << e.what() << '\n';
    }
  std::printf("| tolerance | vertices | wrong | longer, relative | error of its bound | error of the tolerance |\n"
              "|---|---|---|---|---|---|\n");
  bool is_right = true;
  for (std::size_t i = 0; i < std::size(tolerances); ++i)
  {
    const Totals& t = totals[i];
    std::printf("| %g | %zu | %zu | %.1e | %.4f | %.4f |\n", tolerances[i], t.vertices, t.wrong, t.too_long, t.of_bound,
                t.of_tolerance);
    is_right = is_right && t.wrong == 0;
  }
  return is_right ? 0 : 1;
}
