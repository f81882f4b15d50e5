// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Surface_locator.h. Projections on triangles are our own, since those of the kernels can be inaccurate on needle
// faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/weighted_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Nearest point of a segment to a point p, by its parameter in [0, 1], and its distance from p.
template <class Kernel>
struct Nearest_on_edge
{
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;

  Nearest_on_edge(const Point_3& a, const Point_3& b, const Point_3& p)
  {
    const typename Kernel::Vector_3 e = b - a, v = p - a;
    parameter = (std::min)(FT(1), (std::max)(FT(0), FT((v * e) / e.squared_length())));
    // measured from the nearer end, so that it is exactly zero there
    squared_distance = FT(2) * parameter < FT(1) ? FT((v - parameter * e).squared_length())
                                                 : FT((p - b + (FT(1) - parameter) * e).squared_length());
  }

  FT parameter, squared_distance;
};

// Projection on the plane of a triangle. The frame consists of the longest edge and the height over it, so the error is of
// the order of rounding of the edges' length also in needles; areas or a Gram matrix do not achieve this.
template <class Kernel>
class Triangle_projection
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef Per_corner<FT> Coordinates;

  explicit Triangle_projection(const Per_corner<Point_3>& corners) : m_corner(corners)
  {
    FT longest(-1);
    for (int k = 0; k < 3; ++k)
    {
      const FT l = (corners[(k + 1) % 3] - corners[k]).squared_length();
      if (l > longest)
      {
        longest = l;
        m_first = k;
      }
    }
    m_base = corners[(m_first + 1) % 3] - corners[m_first];
    const Vector_3 v = corners[(m_first + 2) % 3] - corners[m_first];
    m_foot = (v * m_base) / m_base.squared_length();
    m_height = v - m_foot * m_base;
  }

  // Barycentric coordinates of the point of the triangle nearest to p.
  Coordinates nearest(const Point_3& p) const
  {
    Coordinates w = coordinates(components(p - m_corner[m_first]), FT(1));
    if (w[0] >= FT(0) && w[1] >= FT(0) && w[2] >= FT(0)) return w;
    FT least(-1);
    for (int k = 0; k < 3; ++k)
    {
      const Nearest_on_edge<Kernel> e(m_corner[k], m_corner[(k + 1) % 3], p);
      if (least >= FT(0) && e.squared_distance >= least) continue;
      least = e.squared_distance;
      w[k] = FT(1) - e.parameter;
      w[(k + 1) % 3] = e.parameter;
      w[(k + 2) % 3] = FT(0);
    }
    return w;
  }

  // Smallest t such that source + t direction is in the triangle. Precondition: the ray meets the triangle.
  FT first_parameter(const Point_3& source, const Vector_3& direction) const
  {
    const Components s = components(source - m_corner[m_first]), d = components(direction);
    const FT across = d.rest.squared_length();
    if (across > CGAL::square(Number_policy<FT>::rounding(16)) * direction.squared_length())
      return (std::max)(FT(0), FT(-(s.rest * d.rest) / across));
    // ray in the plane of the triangle: where it enters
    const Coordinates at = coordinates(s, FT(1)), speed = coordinates(d, FT(0));
    FT enters(0);
    for (int k = 0; k < 3; ++k)
      if (at[k] < FT(0) && speed[k] > FT(0)) enters = (std::max)(enters, FT(-at[k] / speed[k]));
    return enters;
  }

private:
  struct Components // components of a vector: along the base, along the height, and orthogonal to both
  {
    FT base, height;
    Vector_3 rest;
  };

  Components components(const Vector_3& v) const
  {
    const FT b = (v * m_base) / m_base.squared_length();
    const Vector_3 above = v - b * m_base;
    const FT h = (above * m_height) / m_height.squared_length();
    return {b, h, above - h * m_height};
  }

  Coordinates coordinates(const Components& c, const FT& sum) const
  {
    Coordinates w;
    w[(m_first + 2) % 3] = c.height;
    w[(m_first + 1) % 3] = c.base - c.height * m_foot;
    w[m_first] = sum - c.base - c.height * (FT(1) - m_foot);
    return w;
  }

  Per_corner<Point_3> m_corner;
  int m_first = 0; // source of the longest edge
  Vector_3 m_base, m_height;
  FT m_foot; // foot of the height, as a parameter on the base
};

template <class Kernel, class Number>
class Surface_locator<Kernel, Number>::Search
{
public:
  Search(const Unfolded_mesh<Number>& m, const Surface_points<Kernel>& p) : mesh(m), points(p) {}

  void expect(std::size_t queries) const
  {
    if (has_faces() && m_scans + queries > scans_for_a_tree) tree();
  }

  Face_location locate(const Point_3& p, const FT& tolerance) const
  {
    check(p - CGAL::ORIGIN, tolerance);
    const Index f = nearest_face(p);
    return snapped(Face_location(f, projection(f).nearest(p)), p, tolerance);
  }

  std::optional<Face_location> locate(const Ray_3& r, const FT& tolerance) const
  {
    const Point_3 source = r.source();
    const Vector_3 direction = r.to_vector();
    check(source - CGAL::ORIGIN, tolerance);
    check(direction, tolerance);
    if (direction == CGAL::NULL_VECTOR)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the ray to locate has no direction");
    std::optional<Face_location> first;
    Point_3 nearest = source;
    FT least(0);
    for (const Index f : hit_faces(r))
    {
      const Triangle_projection<Kernel> triangle = projection(f);
      const FT t = triangle.first_parameter(source, direction);
      if (first && !is_before(t, f, least, first->first)) continue;
      least = t;
      nearest = source + t * direction;
      first = Face_location(f, triangle.nearest(nearest));
    }
    if (first) first = snapped(*first, nearest, tolerance);
    return first;
  }

  double largest_coordinate() const
  {
    std::call_once(m_coordinate_once, [this] {
      for (Index v = 0; v < mesh.number_of_vertices(); ++v)
      {
        if (mesh.corner(v) == no_index) continue;
        for (const double x : coordinates(points.point_of_vertex(v)))
          m_largest_coordinate = (std::max)(m_largest_coordinate, std::abs(x));
      }
    });
    return m_largest_coordinate;
  }

  const Unfolded_mesh<Number>& mesh;
  const Surface_points<Kernel>& points;

private:
  // A face as an element of the tree.
  class Primitive
  {
  public:
    typedef Index Id;
    typedef typename Kernel::Point_3 Point;
    typedef typename Kernel::Triangle_3 Datum;

    Primitive(std::vector<Index>::const_iterator face, const Search* search) : m_face(*face), m_search(search) {}

    Id id() const { return m_face; }
    Datum datum() const
    {
      const Per_corner<Point_3> t = m_search->corners(m_face);
      return Datum(t[0], t[1], t[2]);
    }
    Point reference_point() const { return m_search->points.point_of_vertex(m_search->mesh.source(3 * m_face)); }

  private:
    Index m_face;
    const Search* m_search;
  };

#if __has_include(<CGAL/AABB_traits_3.h>)
  typedef AABB_tree<AABB_traits_3<Kernel, Primitive>> Tree;
#else
  typedef AABB_tree<AABB_traits<Kernel, Primitive>> Tree;
#endif
  typedef Per_corner<double> Coordinates;

  // Searches through all faces that take as long as building the tree: on meshes with 600 to 1.3 million faces, 600 to
  // 3,500 ns per face for the tree, and 6 to 44 ns per face for a search. If the tree is built after this many searches,
  // any number of queries takes at most twice the time of the better choice.
  static constexpr std::size_t scans_for_a_tree = 100;

  bool has_faces() const
  {
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      if (mesh.source(3 * f) != no_index) return true;
    return false;
  }

  // True if this query searches all faces; counts it.
  bool scans() const
  {
    if (!has_faces())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: there is nothing to locate on a mesh without faces");
    return m_scans < scans_for_a_tree && m_scans++ < scans_for_a_tree;
  }

  const Tree& tree() const
  {
    m_scans = scans_for_a_tree;
    std::call_once(m_tree_once, [&] {
      std::vector<Index> faces;
      for (Index f = 0; f < mesh.number_of_faces(); ++f)
        if (mesh.source(3 * f) != no_index) faces.push_back(f);
      m_tree.rebuild(faces.cbegin(), faces.cend(), this);
      std::vector<typename Tree::Point_and_primitive_id> hints; // the tree's own hints repeat each vertex
      for (Index v = 0; v < mesh.number_of_vertices(); ++v)
        if (mesh.corner(v) != no_index) hints.emplace_back(points.point_of_vertex(v), mesh.corner(v) / 3);
      m_tree.build(); // otherwise the first query would build the tree
      m_tree.accelerate_distance_queries(hints.begin(), hints.end());
    });
    return m_tree;
  }

  // Order of faces at parameters or squared distances s and t. Of equal ones, the first in the mesh wins, independent of
  // the order of the search.
  bool is_before(const FT& s, Index f, const FT& t, Index g) const
  {
    return s < t || (s == t && points.mesh_index_of_face(f) < points.mesh_index_of_face(g));
  }

  static Coordinates coordinates(const Point_3& p)
  {
    return {CGAL::to_double(p.x()), CGAL::to_double(p.y()), CGAL::to_double(p.z())};
  }

  // Generous bound of the rounding error of the distance of a point from the surface, or of a ray from its source.
  double slack(const Coordinates& p) const
  {
    const double unit = (std::max)(std::numeric_limits<double>::epsilon(), CGAL::to_double(Number_policy<FT>::rounding(1)));
    return 64 * unit * (std::abs(p[0]) + std::abs(p[1]) + std::abs(p[2]) + 3 * largest_coordinate());
  }

  // The nearest of the tried faces, by rounded distances.
  class Nearest_face
  {
  public:
    Nearest_face(const Search& search, const Point_3& p)
      : m_search(search), m_point(p), m_coordinates(coordinates(p)), m_slack(search.slack(m_coordinates))
    {
    }

    void try_face(Index f)
    {
      const Face_location l(f, m_search.projection(f).nearest(m_point));
      const FT d = (m_point - m_search.point(l)).squared_length();
      if (m_face != no_index && !m_search.is_before(d, f, m_distance, m_face)) return;
      m_face = f;
      m_distance = d;
      m_reach = std::sqrt(CGAL::to_double(d)) + m_slack;
    }

    // True if a face within the radius around c may be the nearest one.
    bool may_reach(const Coordinates& c, double radius) const
    {
      const double x = c[0] - m_coordinates[0], y = c[1] - m_coordinates[1], z = c[2] - m_coordinates[2];
      return !(x * x + y * y + z * z > CGAL::square(m_reach + radius));
    }

    Index face() const { return m_face; }

    // Interface of tree traversal.
    bool go_further() const { return true; }
    void intersection(const Point_3&, const Primitive& primitive) { try_face(primitive.id()); }
    template <class Node>
    bool do_intersect(const Point_3&, const Node& node) const
    {
      const Bbox_3 box = node.bbox();
      Coordinates nearest;
      for (int i = 0; i < 3; ++i) nearest[i] = (std::min)((std::max)(m_coordinates[i], (box.min)(i)), (box.max)(i));
      return may_reach(nearest, 0);
    }

    const Search& m_search;
    const Point_3& m_point;
    const Coordinates m_coordinates;
    const double m_slack;
    Index m_face = no_index;
    FT m_distance = FT(0); // squared
    double m_reach = std::numeric_limits<double>::infinity();
  };

  Index nearest_face(const Point_3& p) const
  {
    Nearest_face nearest(*this, p);
    if (scans())
      for_each_ball([&](Index f, const Coordinates& c, double radius) {
        if (nearest.may_reach(c, radius)) nearest.try_face(f);
      });
    else
    {
      nearest.try_face(tree().best_hint(p).second);
      tree().traversal(p, nearest);
    }
    return nearest.face();
  }

  // Faces that intersect the ray, by predicates: exact predicates leave no gaps between faces.
  std::vector<Index> hit_faces(const Ray_3& r) const
  {
    std::vector<Index> hit;
    if (!scans())
    {
      tree().all_intersected_primitives(r, std::back_inserter(hit));
      return hit;
    }
    const Coordinates s = coordinates(r.source()), d = coordinates(CGAL::ORIGIN + r.to_vector());
    const double length = std::hypot(d[0], d[1], d[2]), allowance = slack(s);
    for_each_ball([&](Index f, const Coordinates& c, double radius) {
      const double x = c[0] - s[0], y = c[1] - s[1], z = c[2] - s[2];
      const double u = y * d[2] - z * d[1], v = z * d[0] - x * d[2], w = x * d[1] - y * d[0]; // cross product with d
      if (u * u + v * v + w * w > CGAL::square((radius + allowance) * length)) return;
      const Per_corner<Point_3> t = corners(f);
      if (Kernel().do_intersect_3_object()(r, typename Kernel::Triangle_3(t[0], t[1], t[2]))) hit.push_back(f);
    });
    return hit;
  }

  // Calls f(face, center, radius) for each face, with a ball that contains the face up to rounding.
  template <class Function>
  void for_each_ball(const Function& f) const
  {
    for (Index i = 0; i < mesh.number_of_faces(); ++i)
    {
      const auto &first = mesh[3 * i], &last = mesh[3 * i + 2];
      if (first.origin == no_index) continue;
      f(i, coordinates(points.point_of_vertex(first.origin)),
        (std::max)(CGAL::to_double(first.length), CGAL::to_double(last.length)));
    }
  }

  static void check(const Vector_3& v, const FT& tolerance)
  {
    if (!Number_policy<FT>::is_finite(v.squared_length()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: a coordinate to locate, or its square, is not finite");
    if (!(tolerance >= FT(0)))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the tolerance is negative or not a number");
  }

  Per_corner<Point_3> corners(Index f) const
  {
    return {points.point_of_vertex(mesh.source(3 * f)), points.point_of_vertex(mesh.source(3 * f + 1)),
            points.point_of_vertex(mesh.source(3 * f + 2))};
  }

  Triangle_projection<Kernel> projection(Index f) const { return Triangle_projection<Kernel>(corners(f)); }

  Point_3 point(const Face_location& l) const { return weighted_point<Point_3, FT>(l.second, corners(l.first)); }

  // Moves l, the location of p, to a vertex or an edge within the tolerance.
  Face_location snapped(const Face_location& l, const Point_3& p, const FT& tolerance) const
  {
    const Point_3 q = point(l);
    const FT limit = CGAL::square(tolerance);
    Face_location at_vertex = l, on_edge = l;
    FT to_vertex(-1), to_edge(-1); // squared; negative: none found
    std::vector<Index> reached(1, l.first);
    std::set<Index> seen{l.first};
    for (std::size_t i = 0; i < reached.size() && !CGAL::is_zero(to_vertex); ++i)
    {
      const Per_corner<Point_3> corner = corners(reached[i]);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Point_3 &a = corner[k], &b = corner[(k + 1) % 3];
        const FT v = (std::min)(FT((p - a).squared_length()), FT((q - a).squared_length()));
        if (v <= limit && (CGAL::is_negative(to_vertex) || v < to_vertex))
        {
          to_vertex = v;
          at_vertex = Face_location(reached[i], {FT(0), FT(0), FT(0)});
          at_vertex.second[k] = FT(1);
        }
        const Nearest_on_edge<Kernel> near_q(a, b, q), near_p(a, b, p);
        const FT e = (std::min)(near_q.squared_distance, near_p.squared_distance);
        if (e > limit) continue;
        if (CGAL::is_negative(to_edge) || e < to_edge)
        {
          to_edge = e;
          on_edge = Face_location(reached[i], {FT(0), FT(0), FT(0)});
          on_edge.second[k] = FT(1) - near_q.parameter;
          on_edge.second[(k + 1) % 3] = near_q.parameter;
        }
        const Index twin = mesh.twin(3 * reached[i] + Index(k));
        if (twin != no_index && seen.insert(mesh.face(twin)).second) reached.push_back(mesh.face(twin));
      }
    }
    return CGAL::is_negative(to_vertex) ? on_edge : at_vertex;
  }

  mutable std::atomic<std::size_t> m_scans{0};
  mutable std::once_flag m_tree_once, m_coordinate_once;
  mutable Tree m_tree;
  mutable double m_largest_coordinate = 0;
};

template <class Kernel, class Number>
Surface_locator<Kernel, Number>::Surface_locator(const Unfolded_mesh<Number>& mesh, const Surface_points<Kernel>& points)
  : m_search(new Search(mesh, points))
{
}

template <class Kernel, class Number>
Surface_locator<Kernel, Number>::~Surface_locator() = default;

template <class Kernel, class Number>
void Surface_locator<Kernel, Number>::expect(std::size_t queries) const
{
  m_search->expect(queries);
}

template <class Kernel, class Number>
std::pair<Index, std::array<typename Kernel::FT, 3>> Surface_locator<Kernel, Number>::locate(const Point_3& p,
                                                                                             const FT& tolerance) const
{
  return m_search->locate(p, tolerance);
}

template <class Kernel, class Number>
std::optional<std::pair<Index, std::array<typename Kernel::FT, 3>>> Surface_locator<Kernel, Number>::locate(
  const Ray_3& r, const FT& tolerance) const
{
  return m_search->locate(r, tolerance);
}

template <class Kernel, class Number>
typename Kernel::FT Surface_locator<Kernel, Number>::default_tolerance() const
{
  return Number_policy<FT>::rounding(64) * FT(m_search->largest_coordinate());
}

} // namespace CGAL::Geodesic_offset::internal

#endif
