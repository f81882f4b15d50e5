// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// One-sided offsets of plane sections: left and right together are both, piece by piece, and each piece is on its side. Two
// oracles for the side: the equation of the plane if all curves of the section are sources (no shortest path to them
// crosses the plane), and the shortest path traced from the piece.

#include "query_cases.h"
#include "side_oracle.h"

#include <set>
#include <string>
#include <vector>

namespace test_offset_sides {

using namespace test;
using CGAL::Offset_end;
using CGAL::Offset_side;
using CGAL::Source_side;

struct Plane
{
  Point_3 point;
  Vector_3 normal;
  double height(const Point_3& p) const { return ((p - point) * normal) / std::sqrt(normal.squared_length()); }
};

Plane random_plane(const test::Surface_mesh& mesh, unsigned seed)
{
  Random random(seed);
  CGAL::Bbox_3 box;
  for (auto v : vertices(mesh)) box += mesh.point(v).bbox();
  const Point_3 middle(box.xmin() + uniform(random, 0.3, 0.7) * box.x_span(),
                       box.ymin() + uniform(random, 0.3, 0.7) * box.y_span(),
                       box.zmin() + uniform(random, 0.3, 0.7) * box.z_span());
  return Plane{middle, Vector_3(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1))};
}

std::vector<double> levels_of(const test::Surface_mesh& mesh, const Geodesic& geodesic)
{
  const double largest = largest_vertex_distance(geodesic, mesh);
  std::vector<double> result;
  for (double part : {0.011, 0.083, 0.27, 0.51, 0.74, 0.96}) result.push_back(part * largest);
  return result;
}

// All pieces of `a` and `b` together.
std::vector<Piece_key> together(const Offset_curves& a, const Offset_curves& b)
{
  std::vector<Piece_key> result = sorted_pieces(a), more = sorted_pieces(b);
  result.insert(result.end(), more.begin(), more.end());
  std::sort(result.begin(), result.end());
  return result;
}

std::size_t number_of_caps(const Offset_curves& curves)
{
  std::size_t result = 0;
  for (const Offset_curve& c : curves)
    for (const Offset_piece& p : c.pieces()) result += p.side() == Source_side::CAP ? 1 : 0;
  return result;
}

struct Totals
{
  std::size_t meshes = 0, closed_sections = 0, open_sections = 0, pieces = 0, traced = 0;
  double worst_length = 0, worst_height = 0;
};

// Compares both, left and right offsets, and checks sides. `plane` may be null.
void compare_sides(const test::Surface_mesh& mesh, const std::vector<Section<test::Surface_mesh>>& sections, const Plane* plane,
                   Totals& totals)
{
  Geodesic geodesic(mesh);
  std::vector<Oriented_polyline> polylines;
  bool all_closed = true;
  for (const auto& s : sections)
  {
    geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    polylines.push_back({s.locations, s.closed});
    all_closed = all_closed && s.closed;
  }
  geodesic.build(CGAL::parameters::keep_windows(true));
  Side_oracle oracle(mesh, geodesic, polylines);
  const double diagonal = bounding_box_diagonal(mesh);
  const std::vector<double> levels = levels_of(mesh, geodesic);

  const Offset_curves both = offsets(geodesic, levels);
  const Offset_curves left = offsets(geodesic, levels, {Offset_side::LEFT, Offset_end::BUTT});
  const Offset_curves right = offsets(geodesic, levels, {Offset_side::RIGHT, Offset_end::BUTT});
  const Offset_curves butt = offsets(geodesic, levels, {Offset_side::BOTH, Offset_end::BUTT});
  const std::size_t caps = number_of_caps(both);
  CHECK(!both.empty() && (plane == nullptr || (!left.empty() && !right.empty())));
  CHECK(number_of_caps(butt) == 0 && number_of_caps(left) == 0 && number_of_caps(right) == 0);
  CHECK(together(left, right) == sorted_pieces(butt));
  CHECK(sorted_pieces(butt).size() + caps == sorted_pieces(both).size());
  const double length = total_length(butt), sum = total_length(left) + total_length(right);
  totals.worst_length = (std::max)(totals.worst_length, std::abs(sum - length) / length);
  CHECK_DETAIL(std::abs(sum - length) <= 1e-12 * length, values(sum, length));
  // with round ends, each side also has the caps
  const Offset_curves round_left = offsets(geodesic, levels, Offset_side::LEFT);
  const Offset_curves round_right = offsets(geodesic, levels, Offset_side::RIGHT);
  CHECK(together(round_left, round_right).size() == sorted_pieces(both).size() + caps);
  CHECK(number_of_caps(round_left) == caps && number_of_caps(round_right) == caps);
  if (all_closed)
  {
    CHECK(caps == 0);
    CHECK(together(left, right) == sorted_pieces(both));
  }
  if (all_closed && plane)
  { // curves do not change sides
    CHECK_DETAIL(left.size() + right.size() == both.size(), std::to_string(left.size()) + " + " + std::to_string(right.size()) +
                                                              " curves, both: " + std::to_string(both.size()));
    CHECK(number_of_closed(left) + number_of_closed(right) == number_of_closed(both));
  }
  totals.pieces += sorted_pieces(both).size();
  totals.traced += oracle.check(left, 150) + oracle.check(right, 150) + oracle.check(both, 150);

  for (const Offset_curves* side : {&left, &right})
    for (const Offset_curve& curve : *side)
    {
      CHECK(curve.side() == (side == &left ? Source_side::LEFT : Source_side::RIGHT));
      for (const Offset_piece& piece : curve.pieces())
      {
        CHECK(piece.side() == (side == &left ? Source_side::LEFT : Source_side::RIGHT));
        if (!plane) continue;
        // sections run with the upper side of the plane on the left
        const double height = plane->height(piece.point(0.5)) * (side == &left ? 1 : -1);
        totals.worst_height = (std::max)(totals.worst_height, -height / diagonal);
        CHECK_DETAIL(height >= -1e-12 * diagonal, values(height, 0));
      }
    }
  for (const Offset_curve& curve : both)
  {
    std::set<Source_side> sides;
    for (const Offset_piece& piece : curve.pieces()) sides.insert(piece.side());
    CHECK(curve.side().has_value() == (sides.size() == 1));
  }
}

// The first plane with a closed, or open, section curve; returns false if there is none.
bool run(const std::string& name, const test::Surface_mesh& mesh, bool closed_wanted, Totals& totals)
{
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const Plane plane = random_plane(mesh, seed);
    const auto sections = plane_section(mesh, plane.point, plane.normal);
    std::size_t closed = 0;
    for (const auto& s : sections) closed += s.closed ? 1 : 0;
    if (closed_wanted ? closed == 0 : closed == sections.size()) continue;
    Report::instance().set_context(name + ", seed " + std::to_string(seed));
    guarded([&] {
      compare_sides(mesh, sections, &plane, totals);
      for (const auto& s : sections) // a single curve need not divide the surface
        if (s.closed == closed_wanted)
        {
          compare_sides(mesh, {s}, nullptr, totals);
          break;
        }
    });
    if (closed_wanted) ++totals.meshes;
    totals.closed_sections += closed;
    totals.open_sections += sections.size() - closed;
    return true;
  }
  return false;
}

// Reversing the polylines swaps left and right.
void reversed_section(const test::Surface_mesh& mesh, unsigned seed)
{
  Report::instance().set_context("reversed, seed " + std::to_string(seed));
  const Plane plane = random_plane(mesh, seed);
  Geodesic there(mesh), back(mesh);
  for (const auto& s : plane_section(mesh, plane.point, plane.normal))
  {
    there.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
    back.add_source_polyline(std::vector<Face_location>(s.locations.rbegin(), s.locations.rend()),
                             CGAL::parameters::is_closed(s.closed));
  }
  there.build(CGAL::parameters::keep_windows(true));
  back.build(CGAL::parameters::keep_windows(true));
  const std::vector<double> levels = levels_of(mesh, there);
  double worst = 0;
  for (const Offset_end end : {Offset_end::ROUND, Offset_end::BUTT})
  {
    CHECK(same_curves(offsets(there, levels, {Offset_side::LEFT, end}), offsets(back, levels, {Offset_side::RIGHT, end}),
                      levels.back(), worst));
    CHECK(same_curves(offsets(there, levels, {Offset_side::RIGHT, end}), offsets(back, levels, {Offset_side::LEFT, end}),
                      levels.back(), worst));
  }
  for (auto v : vertices(mesh))
  {
    const double a = or_nan(there.signed_distance_to_sources(v)), b = or_nan(back.signed_distance_to_sources(v));
    CHECK_DETAIL(std::isnan(a) ? std::isnan(b) : std::abs(a + b) <= 1e-12 * (std::abs(a) + levels.back()), values(a, -b));
  }
}

} // namespace test_offset_sides

GEODESIC_OFFSET_TEST(test_offset_sides)
{
  const std::size_t maximum_faces = argc > 1 ? std::stoul(argv[1]) : 6000;
  std::cout.precision(3);
  Totals totals;
  for_each_mesh(all_mesh_names(), {}, [&](const Query_case& c) {
    run(c.name, c.mesh, true, totals);
    run(c.name + ", open", c.mesh, false, totals);
    reversed_section(c.mesh, 5);
  });
  Report::instance().set_context("");
  if (mesh_kinds().generated) CHECK_DETAIL(totals.meshes >= 8, std::to_string(totals.meshes) + " meshes");
  const std::size_t from_generator = totals.meshes;
  for_each_mesh(
    {}, data_mesh_names(),
    [&](const Query_case& c) {
      run(c.name, c.mesh, true, totals);
      run(c.name + ", open", c.mesh, false, totals);
    },
    maximum_faces);
  Report::instance().set_context("");
  const std::size_t from_data = totals.meshes - from_generator;
  if (!data_files().empty()) CHECK_DETAIL(from_data >= 12, std::to_string(from_data) + " meshes");
  std::cout << totals.meshes << " meshes with closed sections, " << totals.closed_sections << " closed and "
            << totals.open_sections << " open curves of sections, " << totals.pieces << " pieces, " << totals.traced
            << " of them traced; left and right differ from both by " << totals.worst_length
            << " of their length, pieces are on the wrong side of the plane by " << totals.worst_height << " diagonals"
            << std::endl;
  return Report::instance().finish("test_offset_sides");
}
