// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A kernel with exact square roots: distances equal closed forms, as numbers of CORE, on boxes, the tetrahedron, the
// octahedron, prisms, a saddle, an L and a plane, from vertices, points on edges and in faces, and segments. Offsets have
// exact joints, and polylines with few points.

#include "generated_soup.h"
#include "test_check.h"

#include <CGAL/Exact_predicates_exact_constructions_kernel_with_sqrt.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>
#include <CGAL/Surface_mesh_geodesic_offset/Radical_numbers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test_exact_kernel {

using namespace test;

typedef CGAL::Exact_predicates_exact_constructions_kernel_with_sqrt Kernel;
typedef Kernel::FT FT;
typedef Kernel::Point_3 Point_3;
typedef CGAL::Surface_mesh<Point_3> Mesh;
typedef CGAL::Surface_mesh_geodesic_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>> Geodesic;
typedef Geodesic::Face_location Face_location;
typedef std::array<std::size_t, 3> Triangle;
typedef std::map<std::size_t, FT> Weights; // of vertices

FT root(const FT& x) { return CORE::sqrt(x); }
FT hypotenuse(const FT& x, const FT& y) { return root(x * x + y * y); }
const FT& least(const FT& a, const FT& b) { return b < a ? b : a; }

class Shape
{
public:
  Shape(const std::string& name, const std::vector<Point_3>& points, const std::vector<Triangle>& triangles) : name_(name)
  {
    for (const Point_3& p : points) vertices.push_back(mesh.add_vertex(p));
    for (const Triangle& t : triangles) mesh.add_face(vertices[t[0]], vertices[t[1]], vertices[t[2]]);
    CHECK(mesh.number_of_faces() == triangles.size());
  }

  // The point with the given weights of vertices of one face.
  Face_location at(const Weights& weights) const
  {
    for (auto f : mesh.faces())
    {
      Face_location l(f, {{FT(0), FT(0), FT(0)}});
      std::size_t found = 0, k = 0;
      for (auto v : CGAL::vertices_around_face(mesh.halfedge(f), mesh))
      {
        // coordinates start with the halfedge's source, which follows its target here
        const auto w = weights.find(std::size_t(v));
        if (w != weights.end())
        {
          l.second[(k + 1) % 3] = w->second;
          ++found;
        }
        ++k;
      }
      if (found == weights.size()) return l;
    }
    throw std::logic_error("not in one face");
  }

  Face_location middle(std::size_t a, std::size_t b) const { return at({{a, FT(1) / 2}, {b, FT(1) / 2}}); }
  Face_location center(std::size_t a, std::size_t b, std::size_t c) const
  {
    return at({{a, FT(1) / 3}, {b, FT(1) / 3}, {c, FT(1) / 3}});
  }
  Face_location vertex(std::size_t a) const { return at({{a, FT(1)}}); }

  void start(const std::vector<Face_location>& source)
  {
    geodesic_.reset(new Geodesic(mesh));
    if (source.size() == 1) geodesic_->add_source_point(source[0]);
    else geodesic_->add_source_polyline(source);
    geodesic_->build(CGAL::parameters::keep_windows(true));
    Report::instance().set_context(name_);
  }

  void expect(const Face_location& target, const FT& expected, const std::string& what) const
  {
    const FT d = geodesic_->distance_to_sources(target);
    CHECK_DETAIL(d == expected, what + ": " + values(CGAL::to_double(d), CGAL::to_double(expected)));
    CHECK_DETAIL(!(d == expected + FT(1) / FT(1e18)), what + ": equality says no to others");
  }
  void expect(std::size_t v, const FT& expected) const { expect(vertex(v), expected, "vertex " + std::to_string(v)); }

  const Geodesic& geodesic() const { return *geodesic_; }

  Mesh mesh;
  std::vector<Mesh::Vertex_index> vertices;

private:
  std::string name_;
  std::unique_ptr<Geodesic> geodesic_;
};

// The bits of i select the coordinates a, b, c of vertex i.
Shape box(const FT& a, const FT& b, const FT& c)
{
  std::vector<Point_3> p;
  for (int i = 0; i < 8; ++i) p.emplace_back(i & 1 ? a : FT(0), i & 2 ? b : FT(0), i & 4 ? c : FT(0));
  return Shape("box", p,
               {{{0, 2, 3}},
                {{0, 3, 1}},
                {{4, 5, 7}},
                {{4, 7, 6}},
                {{0, 1, 5}},
                {{0, 5, 4}},
                {{2, 6, 7}},
                {{2, 7, 3}},
                {{0, 4, 6}},
                {{0, 6, 2}},
                {{1, 3, 7}},
                {{1, 7, 5}}});
}

void test_box(const FT& a, const FT& b, const FT& c)
{
  Shape s = box(a, b, c);
  const FT size[3] = {a, b, c};
  s.start({s.vertex(0)});
  for (std::size_t i = 0; i < 8; ++i)
  {
    FT squares(0);
    for (int k = 0; k < 3; ++k)
      if (i >> k & 1) squares += size[k] * size[k];
    if (i == 7) continue;
    s.expect(i, root(squares));
  }
  // the opposite corner: over any of the three edges between
  s.expect(7, least(least(hypotenuse(a, b + c), hypotenuse(b, a + c)), hypotenuse(c, a + b)));
  // the midpoint of edge 0 1: the vertices of the opposite side, through one or two sides
  s.start({s.middle(0, 1)});
  for (std::size_t i : {6, 7})
    s.expect(i, least(hypotenuse(a / 2, b + c), least(hypotenuse(a / 2 + b, c), hypotenuse(a / 2 + c, b))));
  for (std::size_t i : {2, 3}) s.expect(i, hypotenuse(a / 2, b));
  for (std::size_t i : {4, 5}) s.expect(i, hypotenuse(a / 2, c));
  // a point in the side z = 0, at (2a/3, b/3): the corners of the top, via the walls
  s.start({s.at({{0, FT(1) / 3}, {1, FT(1) / 3}, {3, FT(1) / 3}})});
  const FT x = 2 * a / 3, y = b / 3;
  for (std::size_t i = 0; i < 4; ++i)
  {
    const FT dx = i & 1 ? a - x : x, dy = i & 2 ? b - y : y;
    s.expect(i, hypotenuse(dx, dy));
    s.expect(i + 4, least(hypotenuse(dx, dy + c), hypotenuse(dy, dx + c)));
  }
  // the edge 0 1 as a segment: parallel rays sweep the adjacent sides
  s.start({s.vertex(0), s.vertex(1)});
  for (std::size_t i : {2, 3}) s.expect(i, b);
  for (std::size_t i : {4, 5}) s.expect(i, c);
  for (std::size_t i : {6, 7}) s.expect(i, hypotenuse(b, c)); // around the ends of the segment
  s.expect(s.center(0, 2, 3), 2 * b / 3, "in a side beside the segment");
}

void test_tetrahedron()
{
  Shape s("tetrahedron", {Point_3(1, 1, 1), Point_3(1, -1, -1), Point_3(-1, 1, -1), Point_3(-1, -1, 1)},
          {{{0, 1, 2}}, {{0, 2, 3}}, {{0, 3, 1}}, {{1, 3, 2}}});
  const FT edge = 2 * root(FT(2)), height = root(FT(6));
  s.start({s.vertex(0)});
  for (std::size_t i : {1, 2, 3}) s.expect(i, edge);
  s.expect(s.middle(1, 2), height, "the middle of an edge of the face opposite");
  s.expect(s.center(1, 2, 3), height * 4 / 3, "the center of the face opposite");
  s.start({s.middle(0, 1)});
  s.expect(s.middle(2, 3), edge, "the middle of the edge opposite");
  s.expect(s.middle(0, 2), edge / 2, "the middle of a neighbour");
  for (std::size_t i : {2, 3}) s.expect(i, height);
  s.start({s.center(0, 1, 2)});
  s.expect(s.center(0, 2, 3), height * 2 / 3, "the center of a neighbour");
  s.expect(3, height * 4 / 3);
  for (std::size_t i : {0, 1, 2}) s.expect(i, height * 2 / 3);
  s.start({s.vertex(0), s.vertex(1)});
  for (std::size_t i : {2, 3}) s.expect(i, height);
  // two of the faces in one plane: the edge opposite is parallel to the source
  s.expect(s.middle(2, 3), height, "the middle of the edge opposite to the segment");

  // the position of the largest distance is computed with doubles, its value there exactly
  Geodesic geodesic(s.mesh);
  geodesic.add_source_point(s.vertices[0]);
  geodesic.build(CGAL::parameters::compute_largest_distance(true));
  const FT largest = geodesic.largest_distance().value();
  CHECK(largest <= height * 4 / 3 && largest > height * 4 / 3 - FT(1e-12));
  CHECK(geodesic.largest_vertex_distance().value() == edge);
  geodesic.build(CGAL::parameters::compute_largest_distance(true).distance_limit(edge));
  CHECK(geodesic.largest_distance().value() == edge);
  geodesic.build(CGAL::parameters::compute_largest_distance(true).distance_limit(FT(1)));
  CHECK(geodesic.largest_distance().value() == FT(1));
  // all four faces are equally far from the center
  const auto located = geodesic.locate_with_distance(Point_3(0, 0, 0));
  CHECK(located.first.first == Mesh::Face_index(0) && located.second == 1 / root(FT(3)));
  CHECK(geodesic.add_source_sharp_edges(109) && !geodesic.add_source_sharp_edges(110));
}

void test_octahedron()
{
  Shape s("octahedron",
          {Point_3(1, 0, 0), Point_3(-1, 0, 0), Point_3(0, 1, 0), Point_3(0, -1, 0), Point_3(0, 0, 1), Point_3(0, 0, -1)},
          {{{0, 2, 4}}, {{2, 1, 4}}, {{1, 3, 4}}, {{3, 0, 4}}, {{2, 0, 5}}, {{1, 2, 5}}, {{3, 1, 5}}, {{0, 3, 5}}});
  const FT edge = root(FT(2)), height = root(FT(3) / 2);
  s.start({s.vertex(0)});
  s.expect(1, 2 * height);
  for (std::size_t i : {2, 3, 4, 5}) s.expect(i, edge);
  s.start({s.middle(0, 2)});
  for (std::size_t i : {4, 5}) s.expect(i, height);
  for (std::size_t i : {0, 2}) s.expect(i, edge / 2);
  // unfolded around vertex 4, at an angle of 120 degrees
  for (std::size_t i : {1, 3}) s.expect(i, root(FT(7) / 2));
  s.start({s.center(0, 2, 4)});
  s.expect(s.center(2, 1, 4), height * 2 / 3, "the center of a neighbour");
  for (std::size_t i : {1, 3, 5}) s.expect(i, height * 4 / 3);
  s.start({s.vertex(0), s.vertex(2)});
  for (std::size_t i : {4, 5}) s.expect(i, height);
}

// Lateral surface of a prism over a polygon, in two layers; vertex i + n j is above corner i.
Shape prism(const std::vector<std::array<FT, 2>>& corners, const FT& height)
{
  const std::size_t n = corners.size();
  std::vector<Point_3> p;
  std::vector<Triangle> t;
  for (std::size_t j = 0; j < 3; ++j)
    for (const auto& c : corners) p.emplace_back(c[0], c[1], height * int(j) / 2);
  for (std::size_t j = 0; j < 2; ++j)
    for (std::size_t i = 0; i < n; ++i)
    {
      const std::size_t a = n * j + i, b = n * j + (i + 1) % n;
      t.push_back({{a, b, b + n}});
      t.push_back({{a, b + n, a + n}});
    }
  return Shape("prism", p, t);
}

void test_prism(const std::vector<std::array<FT, 2>>& corners, const FT& height)
{
  Shape s = prism(corners, height);
  const std::size_t n = corners.size();
  std::vector<FT> along(1, FT(0));
  for (std::size_t i = 0; i < n; ++i)
    along.push_back(along[i] + hypotenuse(corners[(i + 1) % n][0] - corners[i][0], corners[(i + 1) % n][1] - corners[i][1]));
  const FT period = along[n];
  const auto expect_from = [&](const FT& u, const FT& v) {
    for (std::size_t j = 0; j < 3; ++j)
      for (std::size_t i = 0; i < n; ++i)
      {
        const FT du = along[i] < u ? u - along[i] : along[i] - u;
        s.expect(n * j + i, hypotenuse(least(du, period - du), height * int(j) / 2 - v));
      }
  };
  s.start({s.vertex(0)});
  expect_from(FT(0), FT(0));
  s.start({s.middle(0, n)});
  expect_from(FT(0), height / 4);
  s.start({s.at({{0, FT(1) / 4}, {1, FT(1) / 2}, {n + 1, FT(1) / 4}})});
  expect_from(along[1] * 3 / 4, height / 8);
  // a segment up the wall
  s.start({s.vertex(0), s.vertex(n)});
  for (std::size_t i = 0; i < n; ++i)
  {
    const FT du = least(along[i], period - along[i]);
    s.expect(i, du);
    s.expect(n + i, du);
    s.expect(2 * n + i, hypotenuse(du, height / 2));
  }
}

// Eight right angles around vertex 0, in total 4 pi; legs have alternating lengths root 2 and root 3.
void test_saddle()
{
  std::vector<Point_3> p{Point_3(0, 0, 0)};
  const int x[8] = {1, 1, 0, -1, -1, -1, 0, 1}, y[8] = {0, 1, 1, 1, 0, -1, -1, -1};
  std::vector<Triangle> t;
  for (std::size_t i = 0; i < 8; ++i)
  {
    p.emplace_back(x[i], y[i], i % 2 == 0 ? 1 : -1);
    t.push_back({{0, 1 + i, 1 + (i + 1) % 8}});
  }
  Shape s("saddle", p, t);
  const FT leg[2] = {root(FT(2)), root(FT(3))};
  for (std::size_t first : {0, 1})
    for (int part : {1, 2, 3}) // the source divides a leg in thirds
    {
      s.start({part == 3 ? s.vertex(1 + first) : s.at({{0, FT(3 - part) / 3}, {1 + first, FT(part) / 3}})});
      const FT own = leg[first] * part / 3;
      s.expect(0, own);
      for (std::size_t i = 0; i < 8; ++i)
      {
        const std::size_t apart = (std::min)((i + 8 - first) % 8, (first + 8 - i) % 8);
        const FT& other = leg[i % 2];
        s.expect(1 + i, apart == 0 ? other - own : apart == 1 ? hypotenuse(own, other) : own + other);
      }
    }
  // the center of a face: a third of one leg away from the other
  s.start({s.center(0, 1, 2)});
  s.expect(0, hypotenuse(leg[0], leg[1]) / 3);
  for (std::size_t i : {3, 4, 5, 6}) s.expect(1 + i, hypotenuse(leg[0], leg[1]) / 3 + leg[i % 2]);
  s.expect(3, hypotenuse(leg[0] * 4 / 3, leg[1] / 3)); // straight from the first leg
  s.expect(8, hypotenuse(leg[0] / 3, leg[1] * 4 / 3)); // straight back from the second leg
}

// Squares [i, i + 1] x [j, j + 1] selected by `is_in`.
template <class Is_in>
Shape squares(const std::string& name, int n, int m, std::map<std::pair<int, int>, std::size_t>& number, const Is_in& is_in)
{
  std::vector<Point_3> p;
  std::vector<Triangle> t;
  const auto id = [&](int x, int y) {
    const auto found = number.emplace(std::make_pair(x, y), p.size());
    if (found.second) p.emplace_back(x, y, 0);
    return found.first->second;
  };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j)
      if (is_in(i, j))
      {
        t.push_back({{id(i, j), id(i + 1, j), id(i + 1, j + 1)}});
        t.push_back({{id(i, j), id(i + 1, j + 1), id(i, j + 1)}});
      }
  return Shape(name, p, t);
}

void test_l()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("L", 4, 4, id, [](int i, int j) { return i < 2 || j < 2; });
  // the reflex corner is (2, 2)
  const auto expect_from = [&](const FT& x, const FT& y) {
    for (const auto& v : id)
    {
      const FT u = v.first.first, w = v.first.second;
      // the path to the other arm passes the corner on the wrong side
      const bool is_hidden = w > 2 && (u - x) * (2 - y) > (w - y) * (2 - x);
      s.expect(v.second, is_hidden ? hypotenuse(x - 2, y - 2) + hypotenuse(u - 2, w - 2) : hypotenuse(x - u, y - w));
    }
  };
  s.start({s.vertex(id.at({4, 1}))});
  expect_from(FT(4), FT(1));
  s.start({s.middle(id.at({3, 1}), id.at({3, 2}))});
  expect_from(FT(3), FT(3) / 2);
  s.start({s.center(id.at({3, 1}), id.at({4, 1}), id.at({4, 2}))});
  expect_from(FT(11) / 3, FT(4) / 3);
}

void test_segments_in_plane()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("plane", 4, 3, id, [](int, int) { return true; });
  const std::size_t a = id.at({1, 1}), b = id.at({2, 1}), c = id.at({2, 2});
  const auto first = s.at({{a, FT(1) / 2}, {b, FT(1) / 4}, {c, FT(1) / 4}});
  const auto last = s.at({{a, FT(1) / 8}, {b, FT(1) / 4}, {c, FT(5) / 8}});
  const FT x0 = FT(3) / 2, y0 = FT(5) / 4, x1 = FT(15) / 8, y1 = FT(13) / 8;
  s.start({first, last});
  const auto distance = [&](const FT& x, const FT& y) {
    const FT u = x1 - x0, v = y1 - y0, t = (x - x0) * u + (y - y0) * v, l = u * u + v * v;
    if (t <= 0) return hypotenuse(x - x0, y - y0);
    if (t >= l) return hypotenuse(x - x1, y - y1);
    const FT cross = (x - x0) * v - (y - y0) * u;
    return (cross < 0 ? FT(-cross) : cross) / root(l);
  };
  for (const auto& v : id) s.expect(v.second, distance(FT(v.first.first), FT(v.first.second)));
  s.expect(s.center(id.at({3, 1}), id.at({4, 1}), id.at({4, 2})), distance(FT(11) / 3, FT(4) / 3), "in a face");
  // a path, the nearest point and the gradient are exact, too
  const auto target = s.vertices[id.at({4, 0})];
  std::vector<Point_3> path;
  s.geodesic().shortest_path_points_to_sources(target, std::back_inserter(path));
  CHECK(path.back() == Point_3(x0, y0, 0) || path.back() == Point_3(x1, y1, 0) ||
        (path.back().x() - x0) * (y1 - y0) == (path.back().y() - y0) * (x1 - x0));
  for (const Point_3& p : path) // straight
    CHECK((p.x() - 4) * path.back().y() == p.y() * (path.back().x() - 4));
  const auto g = s.geodesic().gradient(target).value_or(CGAL::NULL_VECTOR);
  CHECK(g.squared_length() == 1);
  CHECK(g.x() * (FT(0) - path.back().y()) == g.y() * (FT(4) - path.back().x()));
  CHECK(s.geodesic().nearest_source(target)->distance == distance(FT(4), FT(0)));
}

// Sources with start values in a plane, one of which lies where another one is nearer.
void test_start_values()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("start values", 4, 3, id, [](int, int) { return true; });
  const FT third = FT(1) / 3, far = root(FT(2)) - FT(1) / 5;
  Geodesic geodesic(s.mesh);
  const auto at = [&](int x, int y) { return s.vertices[id.at({x, y})]; };
  const std::size_t corner = geodesic.add_source_point(at(0, 0));
  const std::size_t edge = geodesic.add_source_polyline(
    std::vector<Face_location>{s.at({{id.at({3, 0}), FT(1)}}), s.at({{id.at({3, 0}), FT(1) / 2}, {id.at({4, 1}), FT(1) / 2}})},
    CGAL::parameters::start_value(third));
  const std::size_t opposite =
    geodesic.add_source_point(s.center(id.at({3, 2}), id.at({4, 3}), id.at({3, 3})), CGAL::parameters::start_value(far));
  geodesic.add_source_point(at(1, 0), CGAL::parameters::start_value(FT(1) + third)); // nowhere nearest
  geodesic.add_source_point(at(0, 1), CGAL::parameters::start_value(1));             // ties behind it
  geodesic.build(CGAL::parameters::keep_windows(true));
  const auto expect = [&](const auto& query, const FT& x, const FT& y) {
    const FT t = ((x - 3) + y) / 2; // along the segment from (3, 0) to (3.5, 0.5), of which 1/2 is the end
    const FT foot = t < 0 ? FT(0) : t > FT(1) / 2 ? FT(FT(1) / 2) : t;
    const FT to_corner = hypotenuse(x, y), to_edge = third + hypotenuse(x - 3 - foot, y - foot),
             to_opposite = far + hypotenuse(x - FT(10) / 3, y - FT(8) / 3);
    const FT d = least(least(to_corner, to_edge), to_opposite);
    CHECK(geodesic.distance_to_sources(query) == d);
    const auto nearest = geodesic.nearest_source(query);
    CHECK(nearest->distance == d);
    CHECK(nearest->source == corner     ? d == to_corner
          : nearest->source == edge     ? d == to_edge
          : nearest->source == opposite ? d == to_opposite
                                        : d == to_corner && x == 0);
  };
  for (const auto& v : id) expect(s.vertices[v.second], FT(v.first.first), FT(v.first.second));
  expect(s.center(id.at({1, 1}), id.at({2, 1}), id.at({2, 2})), FT(5) / 3, FT(4) / 3);
  expect(s.center(id.at({3, 0}), id.at({4, 0}), id.at({4, 1})), FT(11) / 3, third);
  // one arc about each of the three sources; that of the segment has a straight part on both sides
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.field().offset_curves(far, std::back_inserter(curves));
  std::set<std::size_t> sources;
  for (const auto& c : curves)
    for (const auto& piece : c.pieces())
    {
      sources.insert(piece.source());
      if (piece.source() == corner) CHECK(piece.radius() == far);
      if (piece.source() == edge && piece.is_arc()) CHECK(piece.radius() == far - third);
    }
  CHECK(sources == (std::set<std::size_t>{corner, edge}));
}

// Two sources in a plane: the arcs of the offset meet where both sources are at the level.
void test_offsets()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("offset", 4, 4, id, [](int, int) { return true; });
  Geodesic geodesic(s.mesh);
  geodesic.add_source_point(s.vertices[id.at({1, 2})]);
  geodesic.add_source_point(s.vertices[id.at({3, 2})]);
  geodesic.build(CGAL::parameters::keep_windows(true));
  const FT level = FT(5) / 4;
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.offset_curves(level, std::back_inserter(curves));
  std::size_t joints = 0, pieces = 0;
  Report::instance().set_context("offset");
  for (const auto& curve : curves)
    for (const auto& piece : curve.pieces())
    {
      ++pieces;
      CHECK(piece.is_arc() && piece.radius() == level);
      for (const Face_location& l : {piece.start(), piece.end()})
      {
        const Point_3 p = curve.point(l);
        const FT to_first = (p.x() - 1) * (p.x() - 1) + (p.y() - 2) * (p.y() - 2),
                 to_second = (p.x() - 3) * (p.x() - 3) + (p.y() - 2) * (p.y() - 2);
        CHECK((to_first < to_second ? to_first : to_second) == level * level);
        if (to_first == to_second) ++joints;
      }
    }
  CHECK(pieces > 8);
  CHECK(joints == 4); // each of the two joints is the end of one piece and the start of the next
}

// A vertex, an edge that ends there, and a polyline back and forth along it: arcs touch segments and coincide with arcs.
// The offset is that of the edge.
void test_coinciding_sources()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("coinciding sources", 5, 4, id, [](int, int) { return true; });
  Report::instance().set_context("coinciding sources");
  const auto vertex = [&](int x, int y) { return s.vertices[id.at({x, y})]; };
  for (int kind = 0; kind < 4; ++kind)
  {
    Geodesic geodesic(s.mesh);
    if (kind != 1) geodesic.add_source_point(vertex(2, 2));
    if (kind != 2)
    {
      const auto h = s.mesh.halfedge(vertex(2, 2), vertex(3, 2));
      geodesic.add_source_edges(std::vector<Mesh::Edge_index>{s.mesh.edge(h)});
    }
    if (kind == 3) geodesic.add_source_point(vertex(3, 2));
    if (kind == 1 || kind == 2)
      geodesic.add_source_polyline(std::vector<Face_location>{s.vertex(id.at({3, 2})), s.vertex(id.at({2, 2}))},
                                   CGAL::parameters::is_closed(true));
    geodesic.build(CGAL::parameters::keep_windows(true));
    for (const FT& level : {FT(FT(1) / 8), FT(FT(1) / 3), FT(1)})
    {
      std::vector<Geodesic::Offset_curve> curves;
      geodesic.offset_curves(level, std::back_inserter(curves));
      CHECK(curves.size() == 1 && curves.front().is_closed());
      double length = 0;
      for (const auto& curve : curves)
      {
        length += CGAL::to_double(curve.length());
        for (const auto& piece : curve.pieces())
          for (const Face_location& l : {piece.start(), piece.end()})
          {
            const Point_3 p = curve.point(l);
            const FT beside = p.x() < 2 ? FT(2 - p.x()) : p.x() > 3 ? FT(p.x() - 3) : FT(0);
            CHECK(beside * beside + (p.y() - 2) * (p.y() - 2) == level * level);
          }
      }
      const double expected = 2 + 2 * CGAL_PI * CGAL::to_double(level);
      CHECK_DETAIL(std::abs(length - expected) < 1e-12, values(length, expected));
    }
  }
}

// Offset around a vertex and edges, one of which ends there, on a triangulation of points with coordinates that are
// multiples of 1/16. Returns its length, and the distance of ends of arcs from their circles.
template <class Traits>
std::array<double, 2> coinciding_offset(const typename Traits::Triangle_mesh& mesh, unsigned seed)
{
  CGAL::Surface_mesh_geodesic_offset<Traits> geodesic(mesh);
  const auto h = mesh.halfedge(typename Traits::Triangle_mesh::Edge_index(seed % num_edges(mesh)));
  geodesic.add_source_point(mesh.target(h));
  geodesic.add_source_edges(std::vector<typename Traits::Triangle_mesh::Edge_index>{
    mesh.edge(h), mesh.edge(mesh.opposite(mesh.next(mesh.opposite(h))))});
  geodesic.build(CGAL::parameters::keep_windows(true));
  std::vector<typename CGAL::Surface_mesh_geodesic_offset<Traits>::Offset_curve> curves;
  geodesic.offset_curves(typename Traits::FT(35) / 256, std::back_inserter(curves));
  std::array<double, 2> result{0, 0};
  for (const auto& curve : curves)
    for (const auto& piece : curve.pieces())
    {
      result[0] += CGAL::to_double(piece.length());
      if (!piece.is_arc()) continue;
      for (const auto& p : {piece.start_2(), piece.end_2()})
      {
        const auto d = CGAL::squared_distance(p, piece.center()) - piece.radius() * piece.radius();
        result[1] = (std::max)(result[1], std::abs(CGAL::to_double(d)));
      }
    }
  return result;
}

void test_coinciding_sources_in_general_position()
{
  typedef CGAL::Exact_predicates_inexact_constructions_kernel Inexact;
  typedef CGAL::Surface_mesh<Inexact::Point_3> Inexact_mesh;
  for (unsigned seed = 0; seed < 40; ++seed)
  {
    Report::instance().set_context("coinciding sources, seed " + std::to_string(seed));
    test::Random random(seed);
    std::vector<test::Point_2> points;
    std::set<std::pair<std::size_t, std::size_t>> known;
    while (points.size() < 16)
    {
      const std::size_t x = test::uniform_index(random, 16), y = test::uniform_index(random, 16);
      if (known.emplace(x, y).second) points.push_back(test::Point_2(double(x) / 16, double(y) / 16));
    }
    Inexact_mesh mesh;
    std::vector<Inexact_mesh::Vertex_index> v;
    for (const test::Point_2& p : points) v.push_back(mesh.add_vertex(Inexact::Point_3(p.x(), p.y(), 0)));
    for (const auto& t : test::delaunay_triangles(points)) mesh.add_face(v[t[0]], v[t[1]], v[t[2]]);
    const auto rounded = coinciding_offset<CGAL::Surface_mesh_geodesic_offset_traits<Inexact, Inexact_mesh>>(mesh, seed);
    const auto exact = coinciding_offset<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Inexact_mesh>>(mesh, seed);
    CHECK_DETAIL(std::abs(exact[0] - rounded[0]) < 1e-11, values(exact[0], rounded[0]));
    CHECK_DETAIL(exact[1] == 0, values(exact[1], 0));
  }
}

// Both offsets of a square: few points, and exact ends of pieces among them. The inner offset is a square, whose five
// points are its corners. The outer one has a quarter circle around each corner of the source.
void test_points()
{
  std::map<std::pair<int, int>, std::size_t> id;
  Shape s = squares("points", 6, 6, id, [](int, int) { return true; });
  Geodesic geodesic(s.mesh);
  std::vector<Face_location> source;
  for (int i = 1; i < 5; ++i) source.push_back(s.vertex(id.at({i, 1})));
  for (int i = 1; i < 5; ++i) source.push_back(s.vertex(id.at({5, i})));
  for (int i = 5; i > 1; --i) source.push_back(s.vertex(id.at({i, 5})));
  for (int i = 5; i > 1; --i) source.push_back(s.vertex(id.at({1, i})));
  geodesic.add_source_polyline(source, CGAL::parameters::is_closed(true));
  geodesic.build(CGAL::parameters::keep_windows(true));
  const FT level = 5 / FT(7), low = 1 + level, high = 5 - level;
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.offset_curves(level, std::back_inserter(curves));
  CHECK(curves.size() == 2);
  for (const FT& tolerance : {FT(FT(1) / 7), FT(FT(1) / 1000), FT(1) / FT(1000000)})
    for (const auto& curve : curves)
    {
      Report::instance().set_context("points, tolerance " + std::to_string(CGAL::to_double(tolerance)));
      std::vector<Point_3> points;
      std::size_t piecewise = 0;
      curve.points(tolerance, std::back_inserter(points));
      curve.discretize(tolerance, [&](const Face_location&, std::size_t) { ++piecewise; });
      if (!CHECK(points.size() >= 5 && points.front() == points.back())) continue;
      CHECK_DETAIL(points.size() < piecewise, std::to_string(points.size()) + " of " + std::to_string(piecewise));
      if (points[0].x() > 1 && points[0].x() < 5 && points[0].y() > 1 && points[0].y() < 5)
      {
        CHECK_DETAIL(points.size() == 5, std::to_string(points.size()));
        std::set<Point_3> actual(points.begin(), points.end());
        CHECK((actual ==
               std::set<Point_3>{Point_3(low, low, 0), Point_3(high, low, 0), Point_3(high, high, 0), Point_3(low, high, 0)}));
        continue;
      }
      // Exact where straight parts and arcs meet; a point inside an arc has the sine and cosine of a double. The midpoint
      // of a chord is within the tolerance.
      const auto off = [&](const Point_3& p) {
        const FT x = p.x() < 1 ? FT(1 - p.x())
                   : p.x() > 5 ? FT(p.x() - 5)
                               : FT(0),
                 y = p.y() < 1 ? FT(1 - p.y())
                   : p.y() > 5 ? FT(p.y() - 5)
                               : FT(0);
        return FT(level - hypotenuse(x, y));
      };
      for (std::size_t i = 1; i < points.size(); ++i)
      {
        CHECK(CGAL::abs(CGAL::to_double(off(points[i]))) < 1e-14);
        const FT height = off(CGAL::midpoint(points[i - 1], points[i]));
        CHECK(height < tolerance * (1 + FT(1e-9)) && height > FT(-1e-14));
      }
      const double angle = 4 * std::asin(std::sqrt(CGAL::to_double(tolerance / level) / 2)); // of the longest chord
      const double needed = 4 * std::ceil(CGAL_PI / 2 / angle) + 4 + 1;
      CHECK_DETAIL(double(points.size()) <= 1.3 * needed, std::to_string(points.size()) + " points, " + std::to_string(needed));
    }
}

// Traits derived from those of the package compute likewise with the package's own numbers.
void test_derived_traits()
{
  typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Package_traits;
  struct Derived_traits : Package_traits
  {
  };
  std::map<std::pair<int, int>, std::size_t> id;
  const Shape s = squares("derived traits", 6, 6, id, [](int, int) { return true; }); // CORE takes a minute
  CGAL::Surface_mesh_geodesic_offset<Derived_traits> geodesic(s.mesh);
  auto& counts = CGAL::Radical_numbers::internal::Radical_sign::counts();
  counts.reset();
  geodesic.add_source_point(s.vertices[0]);
  geodesic.build();
  CHECK(geodesic.statistics().sign_decisions > 0 && counts.by_doubles > 0 && counts.by_core == 0);
  for (const auto& v : id)
    CHECK(geodesic.distance_to_sources(s.vertices[v.second]) == hypotenuse(FT(v.first.first), FT(v.first.second)));
}

// A tolerance with exact numbers is an error.
void test_tolerance()
{
  const Shape box("tetrahedron", {Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0, 1, 0), Point_3(0, 0, 1)},
                  {{{0, 2, 1}}, {{0, 1, 3}}, {{1, 2, 3}}, {{2, 0, 3}}});
  Geodesic geodesic(box.mesh);
  geodesic.add_source_point(box.vertices[0]);
  CHECK_THROWS(geodesic.build(CGAL::parameters::relative_tolerance(1e-3)), std::invalid_argument);
  CHECK_THROWS(geodesic.build(CGAL::parameters::merging_tolerance(FT(1))), std::invalid_argument);
  geodesic.build(CGAL::parameters::relative_tolerance(0.).merging_tolerance(FT(0)));
  CHECK(geodesic.distance_to_sources(box.vertices[1]) == FT(1) && geodesic.error_bound(box.vertices[1]) == FT(0));
}

} // namespace test_exact_kernel

GEODESIC_OFFSET_TEST(test_exact_kernel)
{
  const std::pair<const char*, std::function<void()>> tests[] = {
    {"cube", [] { test_box(FT(1), FT(1), FT(1)); }},
    {"box of integers", [] { test_box(FT(4), FT(3), FT(2)); }},
    {"box of fractions", [] { test_box(FT(1), FT(3) / 4, FT(1) / 2); }},
    {"box of roots", [] { test_box(root(FT(2)), FT(1), root(FT(3))); }},
    {"tetrahedron", test_tetrahedron},
    {"octahedron", test_octahedron},
    {"prism over a rectangle",
     [] {
       test_prism({{{0, 0}}, {{3, 0}}, {{3, 4}}, {{0, 4}}}, FT(5));
     }},
    {"prism over a triangle",
     [] {
       test_prism({{{0, 0}}, {{2, 0}}, {{1, root(FT(3))}}}, FT(3));
     }},
    {"prism over a square",
     [] {
       test_prism({{{1, 0}}, {{0, 1}}, {{-1, 0}}, {{0, -1}}}, FT(2));
     }},
    {"saddle", test_saddle},
    {"L", test_l},
    {"segments in a plane", test_segments_in_plane},
    {"start values", test_start_values},
    {"offsets", test_offsets},
    {"points", test_points},
    {"coinciding sources", test_coinciding_sources},
    {"coinciding sources in general position", test_coinciding_sources_in_general_position},
    {"derived traits", test_derived_traits},
    {"tolerance", test_tolerance}};
  return run_tests("test_exact_kernel", tests);
}
