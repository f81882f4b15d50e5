// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Distances on planes, needle-faced planes, the L, boxes, the tetrahedron, prisms, closed and open cones, with several
// random triangulations, from points and polylines with vertices anywhere, against closed forms: 1e-12 relative.

#include "closed_forms.h"
#include "flat_paths.h"
#include "geodesic_types.h"
#include "test_check.h"

#include <string>
#include <vector>

namespace test_closed_forms {

using namespace test;

typedef Flat_path_generator<test::Surface_mesh> Generator;
typedef Generator::Face_location Face_location;

template <class ClosedForm>
class Case
{
public:
  Case(const std::string& name, const Soup& soup, const ClosedForm& closed_form, unsigned seed)
    : name_(name), seed_(seed), closed_form_(closed_form), data_(rotated(soup, seed)), generator_(data_, 1000 + seed),
      scale_(2 * bounding_box_diagonal(data_.mesh))
  {
    for (auto v : data_.vertices) targets_.push_back(generator_.leg_at(generator_.locations().at_vertex(v)));
  }

  void run()
  {
    point_sources();
    polyline_sources();
    mixed_sources();
  }

private:
  void point_sources()
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      Geodesic geodesic(data_.mesh);
      const auto v = data_.vertices[uniform_index(generator_.random(), data_.vertices.size())];
      geodesic.add_source_point(v);
      compare("vertex", geodesic, {generator_.leg_at(generator_.locations().at_vertex(v))});
    }
    for (std::size_t i = 0; i < 4; ++i)
    {
      Geodesic geodesic(data_.mesh);
      const Face_location location = generator_.random_location(generator_.random_patch());
      geodesic.add_source_point(location);
      compare("location", geodesic, {generator_.leg_at(location)});
    }
  }

  void polyline_sources()
  {
    for (std::size_t legs : {1, 2, 6, 25})
    {
      Geodesic geodesic(data_.mesh);
      const auto path = generator_.random_path(legs);
      geodesic.add_source_polyline(path.locations);
      compare("polyline of " + std::to_string(path.legs.size()) + " legs", geodesic, path.legs);
    }
    if (name_ == "L") // a straight closing leg may leave the L
      return;
    for (std::size_t legs : {2, 7})
    {
      Geodesic geodesic(data_.mesh);
      const auto path = generator_.random_path(legs, true);
      geodesic.add_source_polyline(path.locations, CGAL::parameters::is_closed(true));
      compare("closed polyline of " + std::to_string(path.legs.size()) + " legs", geodesic, path.legs);
    }
  }

  void mixed_sources()
  {
    Geodesic geodesic(data_.mesh);
    std::vector<Leg> legs;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto path = generator_.random_path(3);
      geodesic.add_source_polyline(path.locations);
      legs.insert(legs.end(), path.legs.begin(), path.legs.end());
      const Face_location location = generator_.random_location(generator_.random_patch());
      geodesic.add_source_point(location);
      legs.push_back(generator_.leg_at(location));
    }
    compare("three polylines and three points", geodesic, legs);
  }

  void compare(const std::string& sources, Geodesic& geodesic, const std::vector<Leg>& legs)
  {
    geodesic.build();
    Report::instance().set_context(name_ + ", seed " + std::to_string(seed_) + ", " + sources);
    Worst_error worst(1e-12, scale_);
    for (std::size_t i = 0; i < targets_.size(); ++i)
    {
      double expected = infinity;
      for (const Leg& leg : legs) expected = (std::min)(expected, closed_form_(targets_[i].patch, targets_[i].a, leg));
      CHECK_CLOSE(worst, geodesic.distance_to_sources(data_.vertices[i]), expected);
    }
    std::cout << Report::instance().context() << ": " << worst.count() << " vertices, worst relative error " << worst.error()
              << std::endl;
  }

  std::string name_;
  unsigned seed_;
  ClosedForm closed_form_;
  Generated_mesh<test::Surface_mesh> data_;
  Generator generator_;
  double scale_;
  std::vector<Leg> targets_;
};

template <class ClosedForm>
void run(const std::string& name, const Soup& soup, const ClosedForm& closed_form, unsigned seed)
{
  guarded([&] { Case<ClosedForm>(name, soup, closed_form, seed).run(); });
}

} // namespace test_closed_forms

GEODESIC_OFFSET_TEST(test_closed_forms)
{
  std::cout.precision(3);
  for (unsigned seed = 1; seed <= 4; ++seed)
  {
    run("Delaunay rectangle", random_rectangle(2, 1, 400, 12, seed), Plane_distance(), seed);
    run("needle rectangle", random_rectangle(1, 1e-4, 150, 10, seed), Plane_distance(), seed);
    run("jittered grid", jittered_grid(18, 14, seed), Plane_distance(), seed);
    run("alternating grid", planar_grid(12, 12, Diagonals::alternating, 0.1), Plane_distance(), seed);
    run("needle fan", needle_fan(250), Plane_distance(), seed);
    run("L", l_shape(80, 5, seed), L_shape_distance(), seed);

    const Polyhedron_sides box = box_sides(1, 0.7, 0.45), cube = box_sides(1, 1, 1), slab = box_sides(3, 2, 0.05);
    run("box", box.triangulated(50, 4, seed), Polyhedron_distance(box), seed);
    run("cube", cube.triangulated(30, 3, seed), Polyhedron_distance(cube), seed);
    run("slab", slab.triangulated(30, 3, seed), Polyhedron_distance(slab), seed);
    run("bare box", box.triangulated(0, 0, seed), Polyhedron_distance(box), seed);
    const Polyhedron_sides tetrahedron = tetrahedron_sides();
    run("tetrahedron", tetrahedron.triangulated(40, 3, seed), Polyhedron_distance(tetrahedron), seed);
    run("bare tetrahedron", tetrahedron.triangulated(0, 0, seed), Polyhedron_distance(tetrahedron), seed);

    for (std::size_t sides : {3, 8})
    {
      const Prism prism(sides, 0.5, 1.5);
      run("prism of " + std::to_string(sides) + " sides", prism.triangulated(40, 4, seed), Prism_distance(prism), seed);
    }
    for (double turns : {0.2, 0.75, 0.95, 1.1, 1.4, 2.2})
    {
      const Cone cone(8, turns * 2 * CGAL_PI, 1);
      run("cone of " + std::to_string(turns) + " turns", cone.triangulated(25, 3, seed), Cone_distance(cone), seed);
    }
    for (double turns : {0.45, 0.8, 1.15, 1.7, 2.6})
    {
      const Cone cone(8, turns * 2 * CGAL_PI, 1, true);
      run("open cone of " + std::to_string(turns) + " turns", cone.triangulated(25, 3, seed), Cone_distance(cone), seed);
    }
    const Cone cone(6, 0.6 * 2 * CGAL_PI, 1);
    run("bare cone", cone.triangulated(0, 0, seed), Cone_distance(cone), seed);
  }
  return Report::instance().finish("test_closed_forms");
}
