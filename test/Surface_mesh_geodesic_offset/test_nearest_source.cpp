// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Nearest source of a point, and labels of vertices: in the plane against brute force over the sources. test_properties has the
// nearest sources on other meshes.

#include "path_tools.h"
#include "planar_polyline.h"

#include <map>
#include <string>
#include <vector>

namespace test_nearest_source {

using namespace test;

struct Totals
{
  std::size_t points = 0, ties = 0, at_segments = 0, at_points = 0;
  double location = 0;
};

// Source in the plane: a point, or a polyline of legs; `leg_of`: leg of each segment.
struct Planar_source
{
  Any_source source;
  std::vector<Point_2> points; // of source.locations
  std::vector<Leg> legs;
  std::vector<std::size_t> leg_of;
};

struct Candidate
{
  double distance;
  Point_2 foot;
  std::size_t source;
};

Point_2 uv_of(const Planar_mesh& plane, const Face_location& l)
{
  const std::array<Point_2, 3>& c = plane.data.uv[plane.data.face_number(l.first)];
  double x = 0, y = 0;
  for (std::size_t k = 0; k < 3; ++k)
  {
    x += l.second[k] * c[k].x();
    y += l.second[k] * c[k].y();
  }
  return Point_2(x, y);
}

Planar_source random_planar_source(Planar_mesh& plane, std::size_t number, unsigned seed)
{
  Planar_source result;
  result.source.closed = number % 3 == 2;
  if (number % 3 == 0) result.source.locations = {plane.generator.random_location(0)};
  else
  {
    const auto path = plane.generator.random_path(1 + (seed + number) % 4 + number % 3 / 2, result.source.closed);
    result.source.locations = path.locations;
    result.legs = path.legs;
  }
  for (const Face_location& l : result.source.locations) result.points.push_back(plane.uv(l));
  std::size_t leg = 0; // a leg ends at the location where its end is
  const std::size_t n = result.points.size();
  for (std::size_t i = 0; i + (result.source.closed ? 0 : 1) < n && !result.legs.empty(); ++i)
  {
    result.leg_of.push_back(leg);
    if (distance(result.points[(i + 1) % n], result.legs[leg].b) < 1e-12) ++leg;
  }
  CHECK(leg == result.legs.size());
  return result;
}

std::vector<Candidate> candidates(const std::vector<Planar_source>& sources, const Point_2& p)
{
  std::vector<Candidate> result;
  for (std::size_t s = 0; s < sources.size(); ++s)
  {
    if (sources[s].legs.empty()) result.push_back({distance(p, sources[s].points[0]), sources[s].points[0], s});
    for (const Leg& leg : sources[s].legs)
    {
      const double t = inner_foot(p, leg.a, leg.b);
      if (t > 0) result.push_back({segment_distance(p, leg.a, leg.b), leg.a + t * (leg.b - leg.a), s});
      for (const Point_2& end : {leg.a, leg.b}) result.push_back({distance(p, end), end, s});
    }
  }
  std::sort(result.begin(), result.end(), [](const Candidate& a, const Candidate& b) { return a.distance < b.distance; });
  return result;
}

// Checks the segment or point number, and the side, of a nearest source point at `foot`.
template <class Nearest>
void check_part(const Planar_source& source, const Nearest& nearest, const Point_2& p, const Point_2& foot, Totals& totals)
{
  if (source.legs.empty())
  {
    CHECK(!nearest.is_segment && nearest.part == 0 && nearest.side == CGAL::Source_side::NONE);
    ++totals.at_points;
    return;
  }
  double to_joint = infinity, to_corner = infinity; // from the foot
  for (const Point_2& q : source.points) to_joint = (std::min)(to_joint, distance(foot, q));
  for (const Leg& leg : source.legs)
    to_corner = (std::min)(to_corner, (std::min)(distance(foot, leg.a), distance(foot, leg.b)));
  if (to_joint > 1e-9) CHECK(nearest.is_segment);
  if (nearest.is_segment)
  {
    ++totals.at_segments;
    if (!CHECK(nearest.part < source.leg_of.size())) return;
    // on the line of the segment (collinear neighbours count as one with it), and orthogonal
    const Leg& leg = source.legs[source.leg_of[nearest.part]];
    const Vector_2 along = (leg.b - leg.a) / distance(leg.a, leg.b);
    CHECK(std::abs(along.x() * (foot - leg.a).y() - along.y() * (foot - leg.a).x()) <= 1e-11);
    if (to_corner > 1e-9) CHECK(std::abs((p - foot) * along) <= 1e-11);
  }
  else
  {
    ++totals.at_points;
    if (!CHECK(nearest.part < source.points.size())) return;
    CHECK(distance(source.points[nearest.part], foot) <= 1e-11);
  }
  const auto side = Signed_distance(source.legs, source.source.closed)(p, 1e-9).second;
  if (side != 0) CHECK_DETAIL(int(nearest.side) == side, values(double(int(nearest.side)), double(side)));
}

void compare_with_plane(Planar_mesh& plane, unsigned seed, Worst_error& worst, Totals& totals)
{
  std::vector<Planar_source> sources;
  std::map<std::size_t, std::size_t> number_of; // by id
  Geodesic geodesic(plane.data.mesh);
  const std::size_t gone = geodesic.add_source_point(plane.data.vertices[0]);
  for (std::size_t i = 0; i < 1 + seed % 4; ++i)
  {
    sources.push_back(random_planar_source(plane, i + seed, seed));
    number_of[sources.back().source.add_to(geodesic)] = i;
  }
  geodesic.remove_source(gone); // so that ids differ from the numbers of the sources
  geodesic.build(CGAL::parameters::keep_windows(true));
  std::map<Vertex_index, std::size_t> labels;
  geodesic.source_labels(boost::make_assoc_property_map(labels));
  CHECK(labels.size() == plane.data.vertices.size());

  const auto check = [&](const auto& query, const Point_2& p) {
    const auto nearest = geodesic.nearest_source(query);
    if (!CHECK(nearest.has_value()) || !CHECK(number_of.count(nearest->source) == 1)) return false;
    const std::vector<Candidate> all = candidates(sources, p);
    ++totals.points;
    CHECK_CLOSE(worst, nearest->distance, all[0].distance);
    const std::size_t source = number_of[nearest->source];
    const Point_2 foot = uv_of(plane, nearest->location);
    // in any case it is one of the nearest
    bool is_one = false, is_tie = false;
    for (const Candidate& c : all)
    {
      if (c.distance > all[0].distance + 1e-9) break;
      const double off = distance(c.foot, foot);
      if (c.source == source && off <= 1e-11) is_one = true;
      if (c.source != all[0].source || distance(c.foot, all[0].foot) > 1e-9) is_tie = true;
    }
    CHECK(is_one || is_tie);
    totals.ties += is_tie ? 1 : 0;
    if (is_tie) return false;
    totals.location = (std::max)(totals.location, distance(foot, all[0].foot));
    check_part(sources[source], *nearest, p, all[0].foot, totals);
    const Vector_3 gradient = geodesic.gradient(query).value_or(CGAL::NULL_VECTOR);
    if (all[0].distance > 1e-6) CHECK(std::abs(gradient.squared_length() - 1) <= 1e-12);
    return true;
  };
  for (auto v : plane.data.vertices)
    if (check(v, plane.uv(plane.generator.locations().at_vertex(v)))) CHECK(labels[v] == geodesic.nearest_source(v)->source);
  for (int i = 0; i < 150; ++i)
  {
    const Face_location l = plane.generator.random_location(0);
    check(l, plane.uv(l));
  }
  for (const Planar_source& s : sources)
    for (const Face_location& l : s.source.locations)
    {
      const auto nearest = geodesic.nearest_source(l);
      CHECK(nearest && nearest->distance <= 1e-14 * 16);
    }
}

void in_the_plane()
{
  Totals totals;
  Worst_error worst(1e-12, 4);
  const std::pair<const char*, Soup> planar[] = {
    {"rectangle", random_rectangle(4, 3, 120, 6, 1)},
    {"turned rectangle", rotated(random_rectangle(4, 3, 120, 6, 2), 3)},
    {"two triangles", random_rectangle(4, 3, 0, 0, 1)},
    {"jittered grid", jittered_grid(9, 7, 4)},
    {"alternating grid", planar_grid(8, 8, Diagonals::alternating, 0.5)}};
  for (const auto& soup : planar)
    for (unsigned seed = 1; seed <= 20; ++seed)
      guarded([&] {
        Report::instance().set_context(std::string(soup.first) + ", seed " + std::to_string(seed));
        Planar_mesh plane(soup.second, seed);
        compare_with_plane(plane, seed, worst, totals);
      });
  std::cout << "plane: " << totals.points << " points, " << totals.ties << " near ties, " << totals.at_segments
            << " nearest to segments, " << totals.at_points << " to points; worst relative error of the distance "
            << worst.error() << ", of the location " << totals.location << std::endl;
}

} // namespace test_nearest_source

GEODESIC_OFFSET_TEST(test_nearest_source)
{
  std::cout.precision(3);
  in_the_plane();
  return Report::instance().finish("test_nearest_source");
}
