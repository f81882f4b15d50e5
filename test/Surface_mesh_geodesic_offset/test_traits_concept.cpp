// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The concept of the traits, by its archetype.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "test_check.h"
#include "traits_archetype.h"

#include <CGAL/Surface_mesh_geodesic_offset/IO/write_offset_curves.h>

#include <cmath>
#include <iterator>
#include <sstream>
#include <vector>

namespace test_traits_concept {

using namespace test;

typedef Generated_mesh<test::Surface_mesh> Data;

// All operations compile with the concept's archetype, which is not default constructible, whose functors have a state, and whose
// numbers have no conversions. The functors are called, and the results are those of the default model.
void concept_archetype()
{
  typedef Traits_archetype<test::Surface_mesh> Archetype;
  typedef CGAL::Surface_mesh_geodesic_offset<Archetype> Geodesic_here;
  typedef typename Archetype::FT FT;
  const Data data(rotated(random_rectangle(2, 1, 30, 5, 4), 4));
  typename Archetype::Calls calls;
  const Archetype traits(calls);
  Geodesic_here geodesic(data.mesh, CGAL::parameters::geom_traits(traits));
  Geodesic expected(data.mesh);
  const auto add_sources = [&](auto& g) {
    g.add_source_point(data.vertices[3]);
    g.add_source_polyline(std::vector<Geodesic::Face_location>{Geodesic::Face_location(data.faces[5], {{0.5, 0.25, 0.25}}),
                                                               Geodesic::Face_location(data.faces[5], {{0.25, 0.25, 0.5}})});
    g.build(CGAL::parameters::keep_windows(true));
  };
  add_sources(geodesic);
  add_sources(expected);
  Worst_error worst(1e-12, 1);
  for (auto v : data.vertices)
    CHECK_CLOSE(worst, CGAL::to_double(geodesic.distance_to_sources(v)), expected.distance_to_sources(v));
  const Point_3& p = data.mesh.point(data.vertices[9]);
  const typename Archetype::Point_3 q(FT(p.x()), FT(p.y()), FT(p.z()));
  const typename Geodesic_here::Face_location location_here = geodesic.locate(q);
  const auto& weights = location_here.second;
  const Geodesic::Face_location location(
    location_here.first, {{CGAL::to_double(weights[0]), CGAL::to_double(weights[1]), CGAL::to_double(weights[2])}});
  CHECK_CLOSE(worst, CGAL::to_double(geodesic.distance_to_sources(location)), expected.distance_to_sources(location));
  const auto nearest = geodesic.nearest_source(location);
  CHECK(nearest && nearest->source == expected.nearest_source(location)->source);
  std::vector<typename Archetype::Point_3> path;
  geodesic.shortest_path_points_to_sources(location, std::back_inserter(path));
  CHECK(path.size() >= 2);
  CHECK(std::abs(CGAL::to_double(geodesic.gradient(location).value_or(CGAL::NULL_VECTOR).squared_length()) - 1) < 1e-12);
  const auto farthest = geodesic.farthest_point().value();
  CHECK_CLOSE(worst, CGAL::to_double(farthest.second), expected.farthest_point()->second);
  std::vector<Geodesic_here::Offset_curve> curves;
  geodesic.offset_curves(std::vector<FT>{FT(0.3) * farthest.second}, std::back_inserter(curves));
  CHECK(!curves.empty());
  std::ostringstream file;
  CHECK(CGAL::IO::write_offset_curves(file, CGAL::IO::Offset_file_format::SVG, curves) &&
        CGAL::IO::write_offset_curves(file, CGAL::IO::Offset_file_format::DXF, curves));
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  CHECK(geodesic.largest_distance().value() == farthest.second);
  CHECK_CLOSE(worst, CGAL::to_double(geodesic.largest_vertex_distance().value()), expected.largest_vertex_distance().value());
  const auto located = geodesic.locate_with_distance(q);
  CHECK(located.first == location_here && located.second < FT(1e-15));
  const typename Geodesic_here::Ray_3 ray(typename Archetype::Point_3(0, 0, 9), q);
  CHECK_CLOSE(worst, CGAL::to_double(geodesic.distance_to_sources(geodesic.locate(ray).value())),
              expected.distance_to_sources(location));
  typename Archetype::Calls other_calls;
  Geodesic_here borders(data.mesh, CGAL::parameters::geom_traits(Archetype(other_calls)));
  CHECK(borders.add_source_boundary().size() == 1 && !borders.add_source_sharp_edges(1));
  borders.add_source_points(data.vertices);
  CHECK(borders.number_of_sources() == 1 + data.vertices.size());
  geodesic.add_source_point(data.vertices[7]);
  geodesic.update();
  CHECK(geodesic.distance_to_sources(data.vertices[7]) == 0);
  CHECK(calls.apices == data.faces.size());
  CHECK(calls.frames > 0 && calls.entries == 0 && calls.distances > 0 && calls.comparisons > 0);
}

// Only for the compiler: the archetype with numbers that count as exact.
[[maybe_unused]] void exact_concept_archetype(const test::Surface_mesh& mesh)
{
  typedef Traits_archetype<test::Surface_mesh, true> Archetype;
  typename Archetype::Calls calls;
  CGAL::Surface_mesh_geodesic_offset<Archetype> geodesic(mesh, CGAL::parameters::geom_traits(Archetype(calls)));
  geodesic.add_source_boundary();
  geodesic.build();
  std::vector<CGAL::Surface_mesh_geodesic_offset<Archetype>::Offset_curve> curves;
  geodesic.offset_curves(std::vector<int>{1}, std::back_inserter(curves));
}

} // namespace test_traits_concept

GEODESIC_OFFSET_TEST(test_traits_concept)
{
  test_traits_concept::concept_archetype();
  return Report::instance().finish("test_traits_concept");
}
