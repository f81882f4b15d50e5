// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Plane sections as sources against the same sections sampled densely as points: the samples' distance is never smaller
// (1e-12 relative), and converges to that of the section as the sampling is refined. Polylines in the faces of planar grids against
// distances in the plane.

#include "closed_forms.h"
#include "data_meshes.h"
#include "flat_paths.h"
#include "generated_meshes.h"
#include "geodesic_types.h"
#include "plane_section.h"
#include "test_check.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test_polyline_sources {

using namespace test;

typedef std::vector<Section<test::Surface_mesh>> Sections;
typedef test::Locations<test::Surface_mesh> Locations;
typedef Geodesic::Face_location Face_location;

// Distances of all vertices from each segment's ends and inner points at `samples` equal steps; the longest step.
std::vector<double> sampled_distances(const test::Surface_mesh& mesh, const Sections& sections, std::size_t samples,
                                      double& longest_step)
{
  const Locations locations(mesh);
  Geodesic geodesic(mesh);
  longest_step = 0;
  for (const auto& section : sections)
    for (std::size_t i = 0; i < section.number_of_segments(); ++i)
    {
      const Point_3 a = locations.point(section.between(locations, i, 0));
      const Point_3 b = locations.point(section.between(locations, i, 1));
      longest_step = (std::max)(longest_step, std::sqrt(CGAL::squared_distance(a, b)) / static_cast<double>(samples));
      for (std::size_t k = 0; k <= samples; ++k)
        geodesic.add_source_point(section.between(locations, i, static_cast<double>(k) / static_cast<double>(samples)));
    }
  geodesic.build();
  std::vector<double> result;
  for (auto v : vertices(mesh)) result.push_back(geodesic.distance_to_sources(v));
  return result;
}

void run(const std::string& name, const test::Surface_mesh& mesh, unsigned seed)
{
  Report::instance().set_context(name + ", seed " + std::to_string(seed));
  const Sections sections = random_plane_section(mesh, seed);
  std::size_t segments = 0;
  Geodesic geodesic(mesh);
  for (const auto& section : sections)
  {
    geodesic.add_source_polyline(section.locations, CGAL::parameters::is_closed(section.closed));
    segments += section.number_of_segments();
  }
  CHECK(segments > 0);
  geodesic.build();

  const double scale = bounding_box_diagonal(mesh);
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * scale;
  double largest_excess = 0; // excess of the section's distance over that of the samples
  std::vector<double> gaps;
  for (std::size_t samples : {1, 4, 16, 64})
  {
    double longest_step, gap = 0;
    const std::vector<double> sampled = sampled_distances(mesh, sections, samples, longest_step);
    std::size_t i = 0;
    for (auto v : vertices(mesh))
    {
      const double exact = geodesic.distance_to_sources(v), approximate = sampled[i++];
      CHECK(std::isinf(exact) == std::isinf(approximate) && !std::isnan(exact));
      if (std::isinf(exact)) continue;
      CHECK_DETAIL(exact <= approximate * (1 + 1e-12) + rounding, values(exact, approximate));
      // The sample nearest to the foot of a shortest path is at most half a step away.
      CHECK_DETAIL(approximate <= exact + longest_step / 2 * (1 + 1e-12) + rounding, values(exact, approximate));
      largest_excess = (std::max)(largest_excess, exact - approximate);
      gap = (std::max)(gap, approximate - exact);
    }
    gaps.push_back(gap);
  }
  // The gap is between linear (vertices near the section) and quadratic (distant vertices) in the step: 64 times the
  // samples reduce it by a factor of at least eight.
  CHECK_DETAIL(gaps.back() <= gaps.front() / 8 + rounding, values(gaps.back(), gaps.front()));
  std::cout << Report::instance().context() << ": " << num_vertices(mesh) << " vertices, " << segments
            << " segments; the section's distance exceeds the samples' by " << largest_excess
            << ", the samples' exceeds the section's, at 1, 4, 16, 64 a segment, by";
  for (double gap : gaps) std::cout << ' ' << gap;
  std::cout << std::endl;
}

void run_guarded(const std::string& name, const test::Surface_mesh& mesh, unsigned seed)
{
  try
  {
    run(name, mesh, seed);
  }
  catch (const std::exception& e)
  {
    CHECK_DETAIL(!"an exception was thrown", e.what());
  }
}

// A location of a face: a corner, on an edge, beside an edge, or inside.
Face_location random_location(test::Surface_mesh::Face_index f, Random& random)
{
  Face_location l(f, random_barycentric(random));
  const std::size_t k = uniform_index(random, 3), kind = uniform_index(random, 5);
  if (kind == 4) return l;
  const double off = kind == 3 ? std::pow(10, uniform(random, -12, -2)) : 0;
  const double t = kind == 0 ? 0 : uniform(random) < 0.2 ? 0.5 : uniform(random, 0, 1 - off);
  l.second[k] = 1 - t - off;
  l.second[(k + 1) % 3] = t;
  l.second[(k + 2) % 3] = off;
  return l;
}

// Polylines of up to five points in faces of a planar grid: their segments run along edges and back, and cross. Distances of
// vertices and of points in faces against those in the plane.
void run_in_faces_of_grid(unsigned seed)
{
  Random random(seed);
  const double jitter = uniform(random) < 0.5 ? 0 : 0.2;
  const Generated_mesh<test::Surface_mesh> data(planar_grid(1 + uniform_index(random, 4), 1 + uniform_index(random, 4),
                                                            Diagonals::random, 1, jitter, seed));
  const test::Surface_mesh& mesh = data.mesh;
  const Locations locations(mesh);
  const auto random_face = [&] {
    return test::Surface_mesh::Face_index(
      static_cast<test::Surface_mesh::size_type>(uniform_index(random, mesh.number_of_faces())));
  };

  std::vector<std::pair<Point_3, Point_3>> segments;
  Geodesic geodesic(mesh);
  const auto first = random_face();
  for (std::size_t i = 0, n = 1 + uniform_index(random, 3); i < n; ++i)
  {
    const auto f = uniform(random) < 0.7 ? first : random_face();
    std::vector<Face_location> polyline;
    for (std::size_t k = 0, m = 2 + uniform_index(random, 4); k < m; ++k) polyline.push_back(random_location(f, random));
    for (std::size_t k = 1; k < polyline.size(); ++k)
      segments.emplace_back(locations.point(polyline[k - 1]), locations.point(polyline[k]));
    geodesic.add_source_polyline(polyline);
  }
  const auto in_plane = [](const Point_3& p) { return Point_2(p.x(), p.y()); };
  const auto expected = [&](const Point_3& p) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& s : segments)
      least = (std::min)(least, segment_distance(in_plane(p), in_plane(s.first), in_plane(s.second)));
    return least;
  };
  geodesic.build(CGAL::parameters::keep_windows(true));
  double worst = 0;
  for (auto v : vertices(mesh)) worst = (std::max)(worst, std::abs(geodesic.distance_to_sources(v) - expected(mesh.point(v))));
  for (auto f : faces(mesh))
  {
    const Face_location l = random_location(f, random);
    worst = (std::max)(worst, std::abs(geodesic.distance_to_sources(l) - expected(locations.point(l))));
  }
  CHECK_DETAIL(worst <= 1e-12, "off by " + std::to_string(worst));
}

} // namespace test_polyline_sources

GEODESIC_OFFSET_TEST(test_polyline_sources)
{
  for (unsigned seed = 1; mesh_kinds().generated && seed <= number_of_cases(3000u, 10000u); ++seed)
  {
    Report::instance().set_context("grid, seed " + std::to_string(seed));
    run_in_faces_of_grid(seed);
  }
  std::cout.precision(3);
  const std::pair<const char*, Soup> generated[] = {
    {"torus", torus(30, 20)},
    {"icosphere", icosphere(3)},
    {"genus 5", marching_genus_5(10)},
    {"marching sphere", marching_sphere(10)},
    {"box", box_sides(1, 0.7, 0.45).triangulated(60, 5, 1)},
    {"tetrahedron", tetrahedron_sides().triangulated(60, 5, 2)},
    {"prism", Prism(6, 0.5, 1.5).triangulated(40, 4, 3)},
    {"cone of 0.75 turns", Cone(8, 1.5 * CGAL_PI, 1).triangulated(30, 4, 4)},
    {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(30, 4, 5)},
    {"rectangle", random_rectangle(2, 1, 300, 10, 6)},
    {"jittered grid", jittered_grid(16, 12, 7)},
    {"L", l_shape(80, 5, 8)}};
  if (mesh_kinds().generated)
    for (const auto& mesh : generated)
      for (unsigned seed : {1u, 2u})
        run_guarded(mesh.first, Generated_mesh<test::Surface_mesh>(rotated(mesh.second, seed)).mesh, seed);

  for (const char* name : {"eight.off", "anchor.off", "elephant.off", "sphere966.off", "cube-meshed.off", "head.off",
                           "rotor.off", "mask_cone.off", "patch-01.off", "blobby.off"})
  {
    test::Surface_mesh mesh;
    const std::string reason = read_data_mesh(std::filesystem::path(data_directory()) / name, 10000, mesh);
    if (reason.empty()) run_guarded(name, mesh, 3);
    else std::cout << name << ": skipped, " << reason << std::endl;
  }
  return Report::instance().finish("test_polyline_sources");
}
