// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Location of points and rays on the surface. The first queries search all faces, later ones an AABB tree; the results are
// the same. Projections on triangles are our own, since those of the kernels can be inaccurate on needle faces.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Bbox_3.h>
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

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

// Concurrent queries are safe. On a mesh without faces, all functions throw std::invalid_argument. Isolated vertices are
// ignored. Surface: a Geodesic_surface.
template <class Surface>
class Surface_locator
{
public:
  typedef typename Surface::Kernel Kernel;
  typedef typename Surface::FT FT;
  typedef typename Surface::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef typename Kernel::Ray_3 Ray_3;
  typedef typename Surface::Triangle_mesh Triangle_mesh;
  typedef boost::graph_traits<Triangle_mesh> Graph_traits;
  typedef typename Surface::vertex_descriptor vertex_descriptor;
  typedef typename Surface::halfedge_descriptor halfedge_descriptor;
  typedef typename Surface::face_descriptor face_descriptor;
  typedef typename Surface::Barycentric_coordinates Barycentric_coordinates;
  typedef typename Surface::Face_location Face_location;

  explicit Surface_locator(std::shared_ptr<const Surface> surface) : m_surface(std::move(surface)) {}

  // Announces the number of further queries: builds the tree at once if it pays.
  void expect(std::size_t queries) const
  {
    if (has_faces() && m_scans + queries > scans_for_a_tree) tree();
  }

  // The location nearest to p, snapped: if the location or p is within the tolerance (a length) of a vertex, the result is
  // exactly at the nearest vertex; otherwise, if of an edge, exactly on the nearest edge. The search covers adjacent faces
  // within the tolerance.
  Face_location locate(const Point_3& p, const FT& tolerance) const
  {
    check(p - CGAL::ORIGIN, tolerance);
    const face_descriptor f = nearest_face(p);
    return snapped(Face_location(f, projection(f).nearest(p)), p, tolerance);
  }

  // The first point of a ray on the surface, snapped likewise; a location in the null face if the ray misses the surface.
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
    for (const face_descriptor f : hit_faces(r))
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

  // Bound of the rounding error of points with the coordinates of the mesh; zero for exact numbers.
  FT default_tolerance() const { return Number_policy<FT>::rounding(64) * FT(largest_coordinate()); }

private:
  // Adapter of the surface's vertex point map for the tree, which needs a default-constructible, assignable map with points
  // of its kernel.
  struct Point_map
  {
    typedef vertex_descriptor key_type;
    typedef Point_3 value_type;
    typedef Point_3 reference;
    typedef boost::readable_property_map_tag category;

    friend Point_3 get(const Point_map& map, const vertex_descriptor& v) { return map.point(v); }

    Point_3 point(const vertex_descriptor& v) const { return surface->position(v); }

    const Surface* surface = nullptr;
  };

  typedef AABB_face_graph_triangle_primitive<Triangle_mesh, Point_map> Primitive;
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

  bool has_faces() const { return faces(m_surface->tm).begin() != faces(m_surface->tm).end(); }

  // True if this query searches all faces; counts it.
  bool scans() const
  {
    if (!has_faces())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: there is nothing to locate on a mesh without faces");
    return m_scans < scans_for_a_tree && m_scans++ < scans_for_a_tree;
  }

  const Tree& tree() const
  {
    const Triangle_mesh& tm = m_surface->tm;
    m_scans = scans_for_a_tree;
    std::call_once(m_tree_once, [&] {
      m_tree.rebuild(faces(tm).begin(), faces(tm).end(), tm, Point_map{m_surface.get()});
      std::vector<typename Tree::Point_and_primitive_id> hints; // the tree's own hints repeat each vertex
      for (Index v = 0; v < m_surface->unfolded.number_of_vertices(); ++v)
      {
        const Index corner = m_surface->unfolded.corner(v);
        if (corner == no_index) continue;
        const face_descriptor f = m_surface->face_of[corner / 3];
        hints.emplace_back(corners(f)[corner % 3], f);
      }
      m_tree.build(); // otherwise the first query would build the tree
      m_tree.accelerate_distance_queries(hints.begin(), hints.end());
    });
    return m_tree;
  }

  // Order of faces at parameters or squared distances s and t. Of equal ones, the first in the mesh wins, independent of
  // the order of the search.
  bool is_before(const FT& s, face_descriptor f, const FT& t, face_descriptor g) const
  {
    return s < t || (s == t && m_surface->numbers.index_in_mesh(f) < m_surface->numbers.index_in_mesh(g));
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

  double largest_coordinate() const
  {
    std::call_once(m_coordinate_once, [this] {
      for (Index v = 0; v < m_surface->unfolded.number_of_vertices(); ++v)
      {
        if (m_surface->unfolded.corner(v) == no_index) continue;
        for (const double x : coordinates(m_surface->position(m_surface->vertex_of[v])))
          m_largest_coordinate = (std::max)(m_largest_coordinate, std::abs(x));
      }
    });
    return m_largest_coordinate;
  }

  // The nearest of the tried faces, by rounded distances.
  class Nearest_face
  {
  public:
    Nearest_face(const Surface_locator& locator, const Point_3& p)
      : m_locator(locator), m_point(p), m_coordinates(coordinates(p)), m_slack(locator.slack(m_coordinates))
    {
    }

    void try_face(face_descriptor f)
    {
      const Face_location l(f, m_locator.projection(f).nearest(m_point));
      const FT d = (m_point - m_locator.m_surface->point(l)).squared_length();
      if (m_face != Graph_traits::null_face() && !m_locator.is_before(d, f, m_distance, m_face)) return;
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

    face_descriptor face() const { return m_face; }

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

  private:
    const Surface_locator& m_locator;
    const Point_3& m_point;
    const Coordinates m_coordinates;
    const double m_slack;
    face_descriptor m_face = Graph_traits::null_face();
    FT m_distance = FT(0); // squared
    double m_reach = std::numeric_limits<double>::infinity();
  };

  face_descriptor nearest_face(const Point_3& p) const
  {
    Nearest_face nearest(*this, p);
    if (scans())
      for_each_ball([&](face_descriptor f, const Coordinates& c, double radius) {
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
  std::vector<face_descriptor> hit_faces(const Ray_3& r) const
  {
    std::vector<face_descriptor> hit;
    if (!scans())
    {
      tree().all_intersected_primitives(r, std::back_inserter(hit));
      return hit;
    }
    const Coordinates s = coordinates(r.source()), d = coordinates(CGAL::ORIGIN + r.to_vector());
    const double length = std::hypot(d[0], d[1], d[2]), allowance = slack(s);
    for_each_ball([&](face_descriptor f, const Coordinates& c, double radius) {
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
    const auto& mesh = m_surface->unfolded;
    for (Index i = 0; i < mesh.number_of_faces(); ++i)
    {
      const auto &first = mesh[3 * i], &last = mesh[3 * i + 2];
      if (first.origin == no_index) continue;
      f(m_surface->face_of[i], coordinates(m_surface->position(m_surface->vertex_of[first.origin])),
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

  Per_corner<Point_3> corners(face_descriptor f) const
  {
    const Triangle_mesh& tm = m_surface->tm;
    const halfedge_descriptor h = halfedge(f, tm);
    const Point_map map{m_surface.get()};
    return {map.point(source(h, tm)), map.point(target(h, tm)), map.point(target(next(h, tm), tm))};
  }

  Triangle_projection<Kernel> projection(face_descriptor f) const { return Triangle_projection<Kernel>(corners(f)); }

  // Moves l, the location of p, to a vertex or an edge within the tolerance.
  Face_location snapped(const Face_location& l, const Point_3& p, const FT& tolerance) const
  {
    const Triangle_mesh& tm = m_surface->tm;
    const Point_3 q = m_surface->point(l);
    const FT limit = CGAL::square(tolerance);
    Face_location at_vertex = l, on_edge = l;
    FT to_vertex(-1), to_edge(-1); // squared; negative: none found
    std::vector<face_descriptor> reached(1, l.first);
    std::set<Index> seen{m_surface->index_of(l.first)};
    for (std::size_t i = 0; i < reached.size() && !CGAL::is_zero(to_vertex); ++i)
    {
      const Per_corner<Point_3> corner = corners(reached[i]);
      halfedge_descriptor h = halfedge(reached[i], tm);
      for (std::size_t k = 0; k < 3; ++k, h = next(h, tm))
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
        const halfedge_descriptor o = opposite(h, tm);
        if (!is_border(o, tm) && seen.insert(m_surface->index_of(face(o, tm))).second) reached.push_back(face(o, tm));
      }
    }
    return CGAL::is_negative(to_vertex) ? on_edge : at_vertex;
  }

  std::shared_ptr<const Surface> m_surface;
  mutable std::atomic<std::size_t> m_scans{0};
  mutable std::once_flag m_tree_once, m_coordinate_once;
  mutable Tree m_tree;
  mutable double m_largest_coordinate = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
