// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// certify_offset(): the tolerances that it proves are those of a dense sample, for regions of all shapes; the package's own
// offsets have tolerances of rounding; linear interpolation does not; and curves with faults are found.

#include "data_directory.h"
#include "data_meshes.h"
#include "geodesic_types.h"
#include "interpolated_offset.h"
#include "query_cases.h"
#include "test_check.h"

#include <CGAL/Polygon_mesh_processing/locate.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_piece.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_certified_offsets {

using namespace test;

typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, test::Surface_mesh>> Enclosure;
typedef Enclosure::Polyline Polyline;
typedef CGAL::Offset_certificate_limit Limit;
typedef CGAL::Geodesic_offset_certificate<Face_location> Certificate;

// Of the diagonal of the bounding box, as the issue of certified offsets asks for.
constexpr double own_tolerance = 1e-11;
// Of bounds of points, relative to the size of the mesh.
constexpr double rounding = 1e-12;

struct Case
{
  Case(const std::string& name, const test::Surface_mesh& m)
    : name(name), mesh(m), diagonal(bounding_box_diagonal(m)), geodesic(m), enclosure(m)
  {
  }

  template <class Source>
  void add_source(const Source& source)
  {
    geodesic.add_source_point(source);
    enclosure.add_source_point(source);
  }

  void build()
  {
    geodesic.build(CGAL::parameters::keep_windows(true));
    enclosure.build(CGAL::parameters::keep_windows(true));
  }

  std::vector<Geodesic::Offset_curve> offsets(double d)
  {
    std::vector<Geodesic::Offset_curve> curves;
    Geodesic other(geodesic);
    other.build_with_offset_curves(std::vector<double>{d}, std::back_inserter(curves));
    return curves;
  }

  std::string name;
  const test::Surface_mesh& mesh;
  double diagonal;
  Geodesic geodesic;
  Enclosure enclosure;
};

Polyline polyline_of(const Geodesic::Offset_curve& curve, double chord_tolerance)
{
  Polyline p;
  curve.face_locations(chord_tolerance, std::back_inserter(p.locations));
  p.is_closed = curve.is_closed();
  if (p.is_closed && p.locations.size() > 1 && p.locations.front() == p.locations.back()) p.locations.pop_back();
  return p;
}

std::vector<Polyline> polylines_of(const std::vector<Geodesic::Offset_curve>& curves, double chord_tolerance)
{
  std::vector<Polyline> result;
  for (const auto& c : curves) result.push_back(polyline_of(c, chord_tolerance));
  return result;
}

// The largest deviation of sampled points of curves: no certificate may promise less.
double deviation(const Enclosure& enclosure, const Geodesic::Offset_curve& curve, double d)
{
  double result = 0;
  for (const auto& piece : curve.pieces())
    for (double t : {0., 0.21, 0.5, 0.83})
    {
      const auto b = enclosure.distance_bounds(piece.location(t));
      result = (std::max)({result, b.first - d, d - b.second});
    }
  return result;
}

double worst_of_ours = 0, least_of_interpolation = infinity;
std::size_t number_of_offsets = 0;

void check_ours(Case& c, double d)
{
  const auto curves = c.offsets(d);
  const Certificate own = c.enclosure.certify_offset(d, curves);
  ++number_of_offsets;
  CHECK_DETAIL(own.bounds_region, c.name);
  CHECK_DETAIL(own.tolerance <= own_tolerance * c.diagonal, values(d, own.tolerance / c.diagonal));
  CHECK(own.number_of_reversed_curves == 0 && !own.first_reversed_curve);
  worst_of_ours = (std::max)(worst_of_ours, own.tolerance / c.diagonal);
  for (const auto& curve : curves) CHECK_DETAIL(deviation(c.enclosure, curve, d) <= own.tolerance, values(d, own.tolerance));
  if (curves.empty()) return;

  // chords are off the arcs by less than their tolerance
  const double chord_tolerance = 1e-5 * c.diagonal;
  const Certificate chords = c.enclosure.certify_offset(d, polylines_of(curves, chord_tolerance));
  CHECK(chords.bounds_region && chords.number_of_reversed_curves == 0);
  CHECK_DETAIL(chords.tolerance <= chord_tolerance + own_tolerance * c.diagonal, values(chords.tolerance, chord_tolerance));
}

// Around points, distances are nowhere linear.
void check_interpolation(Case& c, double d, bool has_points)
{
  const auto curves = interpolated_offset(
    c.mesh, [&](auto v) { return c.geodesic.distance_to_sources(v); }, d);
  if (curves.empty()) return;
  const Certificate other = c.enclosure.certify_offset(d, curves);
  CHECK(other.bounds_region); // on coarse meshes not always on the side of the sources
  double least = 0;
  for (const auto& curve : curves)
    for (const auto& l : curve.locations)
    {
      const auto b = c.enclosure.distance_bounds(l);
      least = (std::max)({least, b.first - d, d - b.second});
    }
  CHECK_DETAIL(other.tolerance >= least, values(other.tolerance, least));
  CHECK(other.limit != Limit::NONE && other.location);
  if (has_points) least_of_interpolation = (std::min)(least_of_interpolation, other.tolerance / c.diagonal);
}

void check_levels(Case& c, std::size_t levels, bool has_points = true)
{
  const double largest = c.geodesic.largest_vertex_distance().value();
  for (std::size_t i = 1; i <= levels; ++i)
  {
    const double d = largest * (double(i) - 0.37) / double(levels);
    check_ours(c, d);
    check_interpolation(c, d, has_points);
  }
}

void own_offsets()
{
  const std::pair<const char*, Soup> soups[] = {
    {"torus", torus(12, 9)},
    {"icosphere", icosphere(2)},
    {"genus 5", marching_genus_5(8)},
    {"cube", cube_grid(4)},
    {"tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)},
    {"cone of 1.5 turns", Cone(8, 3 * CGAL_PI, 1).triangulated(25, 4, 5)},
    {"jittered grid", jittered_grid(10, 8, 7)},
    {"grid", planar_grid(7, 7, Diagonals::alternating)},
    {"needles", rotated(needle_fan(40), 3)},
    {"saddle", saddle_fan(5)}};
  Random random(5);
  for (const auto& soup : soups)
    for (int kind = 0; kind < 4; ++kind)
    {
      const Query_case q(soup.first, soup.second);
      Case c(soup.first, q.mesh);
      Report::instance().set_context(c.name + ", sources of kind " + std::to_string(kind));
      if (kind < 2)
        for (const auto& l : q.random_points(random, kind == 0 ? 1 : 3)) c.add_source(l);
      else
      {
        const Any_source s = q.random_source(random);
        if (s.locations.size() == 1) c.add_source(s.locations.front());
        else
        {
          c.geodesic.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
          c.enclosure.add_source_polyline(s.locations, CGAL::parameters::is_closed(s.closed));
        }
      }
      c.build();
      check_levels(c, 4, kind < 2);
      check_ours(c, 1e-3 * c.geodesic.largest_vertex_distance().value()); // loops inside faces
    }
  CHECK_DETAIL(least_of_interpolation > 1e3 * own_tolerance, values(least_of_interpolation, 0));
}

void data_meshes()
{
  for (const char* name : {"eight.off", "anchor.off", "elephant.off", "mask_cone.off", "mesh_with_border.off"})
  {
    test::Surface_mesh mesh;
    if (!read_data_mesh(std::filesystem::path(data_directory()) / name, 12000, mesh).empty()) continue;
    Case c(name, mesh);
    Report::instance().set_context(c.name);
    c.add_source(*mesh.vertices().begin());
    c.build();
    check_levels(c, 3);
  }
}

// Distances from triangles that are small or of no size, as those around an arc of no length at a vertex, to points far away and
// inside.
void distances_from_small_triangles()
{
  using namespace CGAL::Geodesic_offset::internal;
  const auto point = [](double x, double y) { return Double_double_2{Double_double(x), Double_double(y)}; };
  Random random(11);
  for (double size : {0., 1e-17, 1e-16, 1e-15, 1e-12, 1e-6, 1.})
    for (int i = 0; i < 100; ++i)
    {
      const double x = uniform(random, -1, 1), y = uniform(random, -1, 1);
      const auto near = [&] { return point(x + size * uniform(random, -1, 1), y + size * uniform(random, -1, 1)); };
      const Face_piece triangle = Face_piece::triangle(near(), near(), near());
      CHECK(triangle.distances_from(triangle.inner_point()).first <= 1e-15);
      const double far = 10 + uniform(random, 0, 1), least = far - 1.5 * size;
      CHECK_DETAIL(triangle.distances_from(point(x + far, y)).first >= least - 1e-14, values(size, far));
    }
}

// Near the largest distance, where curves are small loops inside faces, and beyond it.
void near_the_farthest_point()
{
  const std::pair<const char*, Soup> soups[] = {{"cube", cube_grid(2)},
                                                {"icosphere", icosphere(1)},
                                                {"torus", torus(7, 5)},
                                                {"tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)}};
  for (const auto& soup : soups)
  {
    const Generated_mesh<test::Surface_mesh> data(soup.second);
    Case c(soup.first, data.mesh);
    Report::instance().set_context(c.name);
    c.add_source(Face_location(data.faces[0], {{0.3, 0.25, 0.45}}));
    c.build();
    const double largest = c.geodesic.largest_distance().value();
    for (double part : {1 - 1e-3, 1 - 1e-6, 1 - 1e-9}) check_ours(c, part * largest);
    // no curve: the region is the surface
    const std::vector<Polyline> none;
    const Certificate whole = c.enclosure.certify_offset(0.8 * largest, none);
    CHECK(whole.bounds_region && whole.limit == Limit::REGION_TOO_FAR && !whole.curve);
    CHECK_DETAIL(std::abs(whole.tolerance - 0.2 * largest) <= 1e-11 * c.diagonal, values(whole.tolerance, 0.2 * largest));
    const auto bounds = c.enclosure.distance_bounds(whole.location.value());
    CHECK_DETAIL(largest - bounds.first <= 1e-6 * c.diagonal, values(largest, bounds.first));
    const Certificate beyond = c.enclosure.certify_offset(1.1 * largest, none);
    CHECK(beyond.bounds_region && beyond.tolerance == 0 && beyond.limit == Limit::NONE);
  }
}

// The border of a set of faces and of small triangles inside some faces, on meshes of all kinds: the tolerance is that of a
// dense sample of the region, up to the spacing of the sample.
class Sampled_region
{
public:
  Sampled_region(const Soup& soup, unsigned seed) : m_data(soup), m_random(seed), m_case("sampled region", m_data.mesh)
  {
    const auto f = m_data.faces[uniform_index(m_random, m_data.faces.size())];
    m_case.add_source(Face_location(f, {{0.2, 0.5, 0.3}}));
    m_case.build();
    for (const auto g : m_data.faces)
      if (uniform_index(m_random, 3) == 0) m_faces.insert(g);
    if (seed % 2) m_faces.insert(f);
    for (int i = 0; i < 3; ++i) m_holes.insert(m_data.faces[uniform_index(m_random, m_data.faces.size())]);
    m_source_is_in = (m_faces.count(f) == 1) != (m_holes.count(f) == 1 && is_in_hole({{0.2, 0.5, 0.3}}));
  }

  void check()
  {
    const double d = m_case.geodesic.largest_vertex_distance().value() * uniform(m_random, 0.1, 0.9);
    const Certificate c = m_case.enclosure.certify_offset(d, border());
    CHECK(c.bounds_region);
    const double least = sampled_tolerance(d);
    CHECK_DETAIL(c.tolerance >= least - rounding, values(c.tolerance, least));
    CHECK_DETAIL(c.tolerance <= least + spacing(), values(c.tolerance, least));
  }

private:
  typedef std::array<double, 3> Weights;
  static constexpr int steps = 12;

  // The triangle in a face where the weights of all three corners are at least 0.15.
  static bool is_in_hole(const Weights& w) { return w[0] > 0.15 && w[1] > 0.15 && w[2] > 0.15; }

  std::vector<Polyline> border() const
  {
    std::vector<Polyline> result;
    const auto is_in = [&](auto h) { return !is_border(h, m_data.mesh) && m_faces.count(face(h, m_data.mesh)) == 1; };
    for (const auto e : edges(m_data.mesh))
    { // each edge is a curve of its own, in any direction
      const auto h = halfedge(e, m_data.mesh), g = opposite(h, m_data.mesh);
      if (is_border(h, m_data.mesh) || is_border(g, m_data.mesh) || is_in(h) == is_in(g)) continue;
      Polyline p;
      auto k = halfedge(face(h, m_data.mesh), m_data.mesh);
      for (std::size_t i = 0; i < 3; ++i, k = next(k, m_data.mesh))
        if (k == h)
          for (std::size_t j : {i, (i + 1) % 3})
          {
            p.locations.push_back(Face_location(face(h, m_data.mesh), {{0., 0., 0.}}));
            p.locations.back().second[j] = 1;
          }
      result.push_back(p);
    }
    for (const auto f : m_holes)
    {
      Polyline p;
      p.is_closed = true;
      for (std::size_t j = 0; j < 3; ++j)
      {
        p.locations.push_back(Face_location(f, {{0.15, 0.15, 0.15}}));
        p.locations.back().second[j] = 0.7;
      }
      result.push_back(p);
    }
    return result;
  }

  double sampled_tolerance(double d) const
  {
    double result = 0;
    for (const auto f : m_data.faces)
      for (int i = 0; i <= steps; ++i)
        for (int j = 0; i + j <= steps; ++j)
        {
          // not on the border of the face, which belongs to several faces
          Weights w = {{double(i), double(j), double(steps - i - j)}};
          for (double& x : w) x = (x + 1e-3) / (steps + 3e-3);
          const bool is_in = (m_faces.count(f) == 1) != (m_holes.count(f) == 1 && is_in_hole(w));
          const auto b = m_case.enclosure.distance_bounds(Face_location(f, w));
          result = (std::max)(result, is_in == m_source_is_in ? b.first - d : d - b.second);
        }
    return result;
  }

  // The distance changes by no more between points of the sample.
  double spacing() const
  {
    double longest = 0;
    for (const auto e : edges(m_data.mesh))
    {
      const auto h = halfedge(e, m_data.mesh);
      longest = (std::max)(longest, std::sqrt(CGAL::squared_distance(m_data.mesh.point(source(h, m_data.mesh)),
                                                                     m_data.mesh.point(target(h, m_data.mesh)))));
    }
    return 1.1 * longest / steps;
  }

  Generated_mesh<test::Surface_mesh> m_data;
  Random m_random;
  Case m_case;
  std::set<Surface_mesh::Face_index> m_faces, m_holes;
  bool m_source_is_in = true;
};

void sampled_regions()
{
  for (unsigned seed = 1; seed <= 40; ++seed)
  {
    Report::instance().set_context("sampled region, seed " + std::to_string(seed));
    const Soup soup =
      seed % 5 == 0   ? torus(6, 5)
      : seed % 5 == 1 ? icosphere(1)
      : seed % 5 == 2 ? planar_grid(4, 5, Diagonals::alternating)
      : seed % 5 == 3 ? cube_grid(2)
                      : rotated(needle_fan(30), seed);
    Sampled_region(soup, seed).check();
  }
}

// Faults in the offset of a torus at half of the largest distance, which has several loops.
void faults()
{
  const Generated_mesh<test::Surface_mesh> data(torus(20, 14));
  Case c("faults", data.mesh);
  c.add_source(data.vertices[0]);
  c.build();
  const double d = 0.5 * c.geodesic.largest_vertex_distance().value();
  const auto curves = c.offsets(d);
  const std::vector<Polyline> good = polylines_of(curves, 1e-6 * c.diagonal);
  const double good_tolerance = c.enclosure.certify_offset(d, good).tolerance;
  CHECK(good.size() > 1 && good_tolerance < 1.1e-6 * c.diagonal);
  for (std::size_t i = 0; i < good.size(); ++i)
  {
    CHECK(good[i].is_closed);
    if (!good[i].is_closed || good[i].locations.size() < 4) continue;
    const std::size_t n = good[i].locations.size(), k = n / 3;

    std::vector<Polyline> bad = good;
    bad[i].is_closed = false; // the last segment
    Certificate found = c.enclosure.certify_offset(d, bad);
    CHECK(!found.bounds_region && found.limit == Limit::OPEN_END && found.curve == i && found.tolerance == infinity);
    CHECK(found.location);

    bad = good; // a loop
    bad.erase(bad.begin() + std::ptrdiff_t(i));
    found = c.enclosure.certify_offset(d, bad);
    const Certificate missing = found;
    CHECK(!found.bounds_region ? found.limit == Limit::NO_REGION : found.tolerance > 1e3 * good_tolerance);

    std::vector<Geodesic::Offset_curve> arcs = curves;
    arcs.erase(arcs.begin() + std::ptrdiff_t(i));
    found = c.enclosure.certify_offset(d, arcs);
    CHECK(found.bounds_region == missing.bounds_region && found.limit == missing.limit);

    bad = good; // twice the same loop is none
    bad.push_back(good[i]);
    found = c.enclosure.certify_offset(d, bad);
    CHECK(found.bounds_region == missing.bounds_region && found.limit == missing.limit);
    CHECK(found.tolerance == missing.tolerance || std::abs(found.tolerance - missing.tolerance) <= good_tolerance);

    bad = good; // backwards
    std::reverse(bad[i].locations.begin(), bad[i].locations.end());
    found = c.enclosure.certify_offset(d, bad);
    CHECK(found.bounds_region && found.number_of_reversed_curves == 1 && found.first_reversed_curve == i);
    CHECK_DETAIL(std::abs(found.tolerance - good_tolerance) <= rounding, values(found.tolerance, good_tolerance));

    bad = good; // a point away from the curve
    Face_location& l = bad[i].locations[k];
    const std::size_t zeros = std::size_t(std::count(l.second.begin(), l.second.end(), 0.));
    if (zeros == 1)
    { // along its edge
      const std::size_t z = std::size_t(std::find(l.second.begin(), l.second.end(), 0.) - l.second.begin());
      double &a = l.second[(z + 1) % 3], &b = l.second[(z + 2) % 3];
      const double shift = 0.4 * (a > b ? a : b);
      (a > b ? a : b) -= shift;
      (a > b ? b : a) += shift;
    }
    if (zeros == 1)
    {
      const auto bounds = c.enclosure.distance_bounds(l);
      const double least = (std::max)(bounds.first - d, d - bounds.second);
      found = c.enclosure.certify_offset(d, bad);
      CHECK(found.bounds_region);
      CHECK_DETAIL(found.tolerance >= least, values(found.tolerance, least));
      CHECK(least <= good_tolerance || (found.curve == i && found.limit != Limit::REGION_TOO_FAR));
    }

    bad = good; // a jump to a face far away
    bad[i].locations[k] = good[(i + 1) % good.size()].locations.front();
    found = c.enclosure.certify_offset(d, bad);
    CHECK(!found.bounds_region && found.limit == Limit::NOT_JOINED && found.curve == i);
  }
  // another distance
  const Certificate other = c.enclosure.certify_offset(1.01 * d, good);
  CHECK_DETAIL(std::abs(other.tolerance - 0.01 * d) <= 1.1e-6 * c.diagonal, values(other.tolerance, 0.01 * d));
  CHECK(other.limit == Limit::CURVE_TOO_NEAR);
}

void no_region_and_other_sources()
{
  const std::size_t n = 12, m = 9;
  const Generated_mesh<test::Surface_mesh> data(torus(n, m));
  Case c("torus", data.mesh);
  c.add_source(data.vertices[0]);
  c.build();
  // a single loop does not separate a torus: the shortest closed path of edges that is not a border of faces is one of m edges
  Polyline loop;
  for (std::size_t j = 0; j < m; ++j)
  {
    const auto h = halfedge(data.vertices[j], data.mesh);
    const auto g = is_border(h, data.mesh) ? opposite(h, data.mesh) : h;
    Face_location l(face(g, data.mesh), {{0., 0., 0.}});
    auto k = halfedge(l.first, data.mesh);
    for (std::size_t i = 0; i < 3; ++i, k = next(k, data.mesh))
      if (source(k, data.mesh) == data.vertices[j]) l.second[i] = 1;
    loop.locations.push_back(l);
  }
  loop.is_closed = true;
  const Certificate found = c.enclosure.certify_offset(0.3, std::vector<Polyline>{loop});
  CHECK(!found.bounds_region && found.limit == Limit::NO_REGION && found.location);
  CHECK(c.enclosure.certify_offset(0.3, std::vector<Polyline>{loop, loop}).bounds_region);

  // two sources, and the loop of one of them is missing
  Case two("two sources", data.mesh);
  two.add_source(Face_location(data.faces[0], {{0.3, 0.3, 0.4}}));
  two.add_source(Face_location(data.faces[n * m], {{0.3, 0.3, 0.4}}));
  two.build();
  const double d = 0.05;
  const auto curves = two.offsets(d);
  CHECK(curves.size() == 2);
  if (curves.size() != 2) return;
  CHECK(two.enclosure.certify_offset(d, curves).tolerance <= own_tolerance * two.diagonal);
  for (std::size_t i = 0; i < 2; ++i)
  { // one of the sources is outside of the region then, or the region is nearly everything
    const Certificate one = two.enclosure.certify_offset(d, std::vector<Geodesic::Offset_curve>{curves[i]});
    CHECK(one.bounds_region && one.tolerance >= d);
  }
}

// Surfaces in two parts, of which only one has a source; and points that are nowhere.
void use()
{
  Soup soup = planar_grid(3, 3);
  const std::size_t n = soup.points.size(), t = soup.triangles.size();
  for (std::size_t i = 0; i < n; ++i) soup.points.push_back(soup.points[i] + Kernel::Vector_3(10, 0, 0));
  for (std::size_t i = 0; i < t; ++i)
  {
    auto triangle = soup.triangles[i];
    for (auto& v : triangle) v += n;
    soup.add_triangle(triangle, soup.patches[i], soup.uv[i]);
  }
  const Generated_mesh<test::Surface_mesh> data(soup);
  Case c("two parts", data.mesh);
  c.add_source(data.vertices[0]);
  const std::vector<Polyline> none;
  const auto throws_logic_error = [&] {
    try
    {
      c.enclosure.certify_offset(0.5, none);
    }
    catch (const std::logic_error&)
    {
      return true;
    }
    return false;
  };
  CHECK(throws_logic_error());
  c.enclosure.build();
  CHECK(throws_logic_error());
  c.build();
  CHECK(!throws_logic_error());
  for (double d : {-1., infinity, std::numeric_limits<double>::quiet_NaN()})
  {
    bool is_refused = false;
    try
    {
      c.enclosure.certify_offset(d, none);
    }
    catch (const std::invalid_argument&)
    {
      is_refused = true;
    }
    CHECK(is_refused);
  }
  check_levels(c, 3);
  // a curve where no source reaches
  Polyline far;
  far.is_closed = true;
  for (std::size_t j = 0; j < 3; ++j)
  {
    far.locations.push_back(Face_location(data.faces[t], {{0.2, 0.2, 0.2}}));
    far.locations.back().second[j] = 0.6;
  }
  const Certificate unreached = c.enclosure.certify_offset(0.5, std::vector<Polyline>{far});
  CHECK(unreached.tolerance == infinity && unreached.limit == Limit::CURVE_TOO_FAR && unreached.curve == 0);
}

// Levels within rounding of a vertex, where a piece may have no length, and of the start value of a source.
void rounding_of_levels()
{
  test::Surface_mesh mesh;
  std::vector<test::Surface_mesh::Vertex_index> v;
  for (const Point_3& p : {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 0.7, 0), Point_3(1.1, 0.9, 0.2)})
    v.push_back(mesh.add_vertex(p));
  mesh.add_face(v[0], v[1], v[2]);
  mesh.add_face(v[1], v[3], v[2]);
  for (const double rounding : {0., 0x1p-43, 0x1p-42, 0x1p-41, 1.000003 * 0x1p-42})
    for (const double start : {0., 0.1, 0.7 * (1 - 0x1p-43), 0.7 * (1 - 0x1p-44), 0.7})
    {
      Case c("rounding of levels", mesh);
      c.geodesic.add_source_edges(std::vector<test::Surface_mesh::Edge_index>{test::Surface_mesh::Edge_index(0)});
      c.enclosure.add_source_edges(std::vector<test::Surface_mesh::Edge_index>{test::Surface_mesh::Edge_index(0)});
      if (start > 0)
      {
        c.geodesic.add_source_point(v[3], CGAL::parameters::start_value(start));
        c.enclosure.add_source_point(v[3], CGAL::parameters::start_value(start));
      }
      c.build();
      check_ours(c, 0.7 * (1 + rounding));
    }
}

// Fans that share vertices only: an offset at the distance of such a vertex may be this point, or nothing. From an attack.
void pinched_vertices()
{
  Random random(11);
  std::size_t without_curves = 0;
  for (int i = 0; i < 60; ++i)
  {
    test::Surface_mesh mesh;
    typedef test::Surface_mesh::Vertex_index Vertex;
    std::vector<Vertex> shared;
    const int fans = 2 + i % 3;
    for (int fan = 0; fan < fans; ++fan)
    { // around a shared vertex, or with one or two of them on its rim
      const int faces = 2 + int(uniform(random, 0, 4));
      std::vector<Vertex> v;
      for (int k = 0; k < faces + 2; ++k)
        v.push_back(mesh.add_vertex(Point_3(2 * fan + uniform(random, 0, 1), uniform(random, 0, 1), uniform(random, 0, 1))));
      if (fan > 0)
        mesh.remove_vertex(std::exchange(v[i % 2 == 0 ? 0 : 2], shared[std::size_t(uniform(random, 0, double(shared.size())))]));
      const auto is_free = [&](Vertex w) { return w != shared[0] && !mesh.halfedge(w, shared[0]).is_valid(); };
      if (fan > 1 && is_free(v[0]) && is_free(v[2])) mesh.remove_vertex(std::exchange(v[1], shared[0]));
      for (int k = 1; k <= faces; ++k) CHECK(mesh.add_face(v[0], v[k], v[k + 1]) != test::Surface_mesh::null_face());
      shared.insert(shared.end(), {v[0], v[2], v.back()});
    }
    mesh.collect_garbage();
    Case c("pinched vertices " + std::to_string(i), mesh);
    c.add_source(Face_location(*mesh.faces().begin(), {{0.3, 0.25, 0.45}}));
    if (i % 5 < 2) c.add_source(Face_location(test::Surface_mesh::Face_index(mesh.number_of_faces() - 1), {{0.2, 0.1, 0.7}}));
    c.build();
    for (const Vertex v : mesh.vertices())
      for (const int step : {-1024, -64, -1, 0, 1, 64, 1024})
      {
        const double d = c.geodesic.distance_to_sources(v) * (1 + step * 0x1p-52);
        if (!(d < infinity)) continue;
        check_ours(c, d);
        if (!c.offsets(d).empty()) continue;
        // but away from the vertex, the fans are one region
        const double deep = 1e-3 * d;
        const Certificate none = c.enclosure.certify_offset(d - deep, std::vector<Polyline>());
        const double most = c.geodesic.largest_distance().value() - (d - deep);
        CHECK_DETAIL(none.bounds_region && std::abs(none.tolerance - most) <= 1e-11 * c.diagonal, values(none.tolerance, most));
        if (d < 0.99 * c.geodesic.largest_distance().value()) ++without_curves;
      }
  }
  CHECK_DETAIL(without_curves > 20, std::to_string(without_curves));
}

// Curves within a tolerance at the distance of a pinched vertex leave the vertex out, which is farther by up to the tolerance. From
// an attack: a mesh of 67 vertices with two sources.
void pinched_vertices_within_tolerances()
{
  test::Surface_mesh mesh;
  if (!CHECK(CGAL::IO::read_polygon_mesh(std::string(GEODESIC_OFFSET_TEST_DIR) + "/data/tolerance_pinched.off", mesh))) return;
  Case c("pinched vertices within tolerances", mesh);
  typedef test::Surface_mesh::Face_index Face;
  const auto start = CGAL::parameters::start_value(0.66856635219183247);
  const std::vector<Face_location> line = {{Face(43), {{0.73627668129425983, 0, 0.26372331870574017}}},
                                           {Face(43), {{0.12206276574392733, 0.86038277609755576, 0.017554458158516837}}},
                                           {Face(43), {{0.0056551718316023422, 0.0052368035666373715, 0.98910802460176028}}},
                                           {Face(43), {{1. / 3, 1. / 3, 1. / 3}}}};
  const test::Surface_mesh::Vertex_index source(17), pinched(22);
  c.geodesic.add_source_point(source, start);
  c.enclosure.add_source_point(source, start);
  c.geodesic.add_source_polyline(line);
  c.enclosure.add_source_polyline(line);
  c.build();
  const auto field = c.geodesic.build(CGAL::parameters::merging_tolerance(1.0085301489111267).keep_windows(true));
  const double level = field.distance_to_sources(pinched), exact = c.enclosure.distance_bounds(pinched).first;
  CHECK_DETAIL(level < 0.99 * exact, values(level, exact)); // else the test has no effect
  for (const double d : {level, level * (1 - 1e-6)})
  {
    std::vector<Geodesic::Offset_curve> curves;
    field.offset_curves(d, std::back_inserter(curves));
    const Certificate certificate = c.enclosure.certify_offset(d, curves);
    CHECK(!curves.empty() && certificate.bounds_region && certificate.number_of_reversed_curves == 0);
    const double allowed = curves.empty() ? 0 : curves.front().tolerance();
    CHECK_DETAIL(certificate.tolerance <= allowed, values(certificate.tolerance, allowed));
    // Without its curves, the region is not bounded by pinched vertices.
    if (!curves.empty()) curves.pop_back();
    const Certificate part = c.enclosure.certify_offset(d, curves);
    CHECK_DETAIL(!part.bounds_region || part.tolerance > certificate.tolerance, values(part.tolerance, certificate.tolerance));
  }
}

// Curves on both sides of a polyline, near to each other in a face.
// Thin strips beside long source segments, which few triangles must cover: inside faces, and along the edges of a cube. A region
// with the incircle of a loop, whose inner curve is missing, still reaches as far as its center.
void thin_strips()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(1, 1, Diagonals::backward));
  Case c("thin strips", data.mesh);
  const Face_location corners[] = {
    {data.faces[0], {{0.6, 0.2, 0.2}}}, {data.faces[0], {{0.2, 0.6, 0.2}}}, {data.faces[0], {{0.2, 0.2, 0.6}}}};
  c.geodesic.add_source_polyline(corners, CGAL::parameters::is_closed(true));
  c.enclosure.add_source_polyline(corners, CGAL::parameters::is_closed(true));
  c.build();
  double perimeter = 0, double_area = 0;
  for (int i = 0; i < 3; ++i)
  {
    const Point_3 p = c.geodesic.mesh().triangle_mesh().point(data.vertices[0]); // the origin
    const auto at = [&](int k) { return CGAL::Polygon_mesh_processing::construct_point(corners[k % 3], data.mesh) - p; };
    perimeter += std::sqrt((at(i + 1) - at(i)).squared_length());
    double_area += CGAL::cross_product(at(i), at(i + 1)).z();
  }
  const double inradius = std::abs(double_area) / perimeter;
  for (const double d : {1e-2, 1e-3, 3e-4, 1e-4, 1e-5, 1e-7})
  {
    check_ours(c, d);
    std::vector<Geodesic::Offset_curve> curves = c.offsets(d);
    CHECK(curves.size() == 2);
    curves.erase(std::min_element(curves.begin(), curves.end(), [](const auto& a, const auto& b) {
      return a.length() < b.length();
    }));
    const Certificate whole = c.enclosure.certify_offset(d, curves);
    CHECK_DETAIL(whole.bounds_region && whole.limit == Limit::REGION_TOO_FAR &&
                   std::abs(whole.tolerance - (inradius - d)) < 1e-9,
                 values(whole.tolerance, inradius - d));
    // the curves of twice the level
    const Certificate twice = c.enclosure.certify_offset(d, c.offsets(2 * d));
    CHECK_DETAIL(twice.bounds_region && std::abs(twice.tolerance - d) < 1e-9 * d + own_tolerance, values(twice.tolerance, d));
  }
  const Generated_mesh<test::Surface_mesh> box(cube_grid(1));
  Case cube("edges of a cube", box.mesh);
  std::vector<test::Surface_mesh::Edge_index> edges;
  cube.geodesic.mesh().sharp_edges(40, std::back_inserter(edges));
  CHECK(edges.size() == 12);
  cube.geodesic.add_source_edges(edges);
  cube.enclosure.add_source_edges(edges);
  cube.build();
  for (const double d : {1e-3, 1e-6}) check_ours(cube, d);
}

// A source outside counts however near its start value is to the level, and so does a point that belongs to no piece. From an
// attack.
void outside_points()
{
  const Generated_mesh<test::Surface_mesh> data(planar_grid(4, 4, Diagonals::forward));
  Enclosure enclosure(data.mesh);
  const double start = 1e9, depth = 1e-4;
  enclosure.add_source_point(Face_location(data.faces[0], {{0.25, 0.5, 0.25}}), CGAL::parameters::start_value(start));
  enclosure.build(CGAL::parameters::keep_windows(true));
  const Certificate none = enclosure.certify_offset(start + depth, std::vector<Polyline>());
  CHECK_DETAIL(none.tolerance >= 0.99 * depth, values(none.tolerance, depth));
  enclosure.clear_sources();
  enclosure.add_source_point(data.vertices[0]);
  enclosure.build(CGAL::parameters::keep_windows(true));
  Polyline point;
  point.locations = {Face_location(data.faces.back(), {{0.25, 0.5, 0.25}})};
  const double far = enclosure.distance_bounds(point.locations[0]).first, level = 2 * far;
  for (const bool is_closed : {false, true})
  {
    point.is_closed = is_closed;
    const Certificate c = enclosure.certify_offset(level, std::vector<Polyline>{point});
    CHECK_DETAIL(c.tolerance >= 0.99 * (level - far), values(c.tolerance, level - far));
  }
}

} // namespace test_certified_offsets

GEODESIC_OFFSET_TEST(test_certified_offsets)
{
  const std::pair<const char*, void (*)()> tests[] = {
    {"use", use},
    {"own offsets", own_offsets},
    {data_case, data_meshes},
    {"small triangles", distances_from_small_triangles},
    {"near the farthest point", near_the_farthest_point},
    {"sampled regions", sampled_regions},
    {"rounding of levels", rounding_of_levels},
    {"pinched vertices", pinched_vertices},
    {"pinched vertices within tolerances", pinched_vertices_within_tolerances},
    {"thin strips", thin_strips},
    {"outside points", outside_points},
    {"faults", faults},
    {"no region, and other sources", no_region_and_other_sources}};
  const int result = run_tests("test_certified_offsets", tests);
  std::cout << number_of_offsets << " offsets, tolerances up to " << worst_of_ours
            << " of the diagonal; of linear interpolation " << least_of_interpolation << " at least" << std::endl;
  return result;
}
