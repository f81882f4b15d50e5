// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Locates points and rays on the surface. An AABB tree says which face; where in it, and on which edge or vertex, is
// decided here. Projections on needle faces are our own too: those of the kernels can be far off.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_SURFACE_LOCATOR_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/AABB_face_graph_triangle_primitive.h>
#include <CGAL/AABB_tree.h>
#if __has_include(<CGAL/AABB_traits_3.h>) // CGAL 6
#include <CGAL/AABB_traits_3.h>
#else
#include <CGAL/AABB_traits.h>
#endif
#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/helpers.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <mutex>
#include <set>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A point of a segment, at the parameter in [0, 1], and its distance to another point.
template <class Kernel>
struct Nearest_on_edge
{
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;

  Nearest_on_edge(const Point_3& a, const Point_3& b, const Point_3& p)
  {
    const typename Kernel::Vector_3 e = b - a, v = p - a;
    parameter = (std::min)(FT(1), (std::max)(FT(0), FT((v * e) / e.squared_length())));
    // measured from the nearer end: exactly zero there
    squared_distance = FT(2) * parameter < FT(1) ? FT((v - parameter * e).squared_length())
                                                 : FT((p - b + (FT(1) - parameter) * e).squared_length());
  }

  FT parameter, squared_distance;
};

// Projects on the plane of a triangle. The frame starts with the longest edge and the height over it: so the result is
// within rounding of the edges' length from the right point also in needles, which it is not by areas or a Gram matrix.
template <class Kernel>
class Triangle_projection
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;
  typedef std::array<FT, 3> Coordinates;

  explicit Triangle_projection(const std::array<Point_3, 3>& corners) : m_corner(corners)
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

  // Barycentric coordinates of the point of the triangle that is nearest to p.
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

  // Where source + t direction, known to meet the triangle, meets it first.
  FT first_parameter(const Point_3& source, const Vector_3& direction) const
  {
    const Components s = components(source - m_corner[m_first]), d = components(direction);
    const FT across = d.rest.squared_length();
    if (across > CGAL::square(Number_policy<FT>::rounding(16)) * direction.squared_length())
      return (std::max)(FT(0), FT(-(s.rest * d.rest) / across));
    const Coordinates at = coordinates(s, FT(1)), speed = coordinates(d, FT(0)); // in the plane: where it enters
    FT enters(0);
    for (int k = 0; k < 3; ++k)
      if (at[k] < FT(0) && speed[k] > FT(0)) enters = (std::max)(enters, FT(-at[k] / speed[k]));
    return enters;
  }

private:
  struct Components // of a vector: along the base, along the height, and orthogonal to both
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

  std::array<Point_3, 3> m_corner;
  int m_first = 0; // where the longest edge starts
  Vector_3 m_base, m_height;
  FT m_foot; // of the height, on the base
};

// The kernel, as the tree uses it, with this projection.
template <class Kernel>
struct Kernel_with_triangle_projection : Kernel
{
  struct Construct_projected_point_3
  {
    typename Kernel::Point_3 operator()(const typename Kernel::Triangle_3& t, const typename Kernel::Point_3& p) const
    {
      const std::array<typename Kernel::Point_3, 3> c = {t[0], t[1], t[2]};
      const std::array<typename Kernel::FT, 3> w = Triangle_projection<Kernel>(c).nearest(p);
      return CGAL::barycenter(c[0], w[0], c[1], w[1], c[2], w[2]);
    }
  };

  Construct_projected_point_3 construct_projected_point_3_object() const { return Construct_projected_point_3(); }
};

// The tree is built at the first query. Queries may come from several threads. A mesh without faces has no location: all
// functions throw std::invalid_argument. Isolated vertices are never found. Surface: a Geodesic_surface.
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

  // The location nearest to p. If that or p is within the tolerance (a length) of a vertex, it is exactly at the nearest
  // vertex; else, if of an edge, exactly on the nearest edge. Looks at the faces that hang together within the tolerance.
  Face_location locate(const Point_3& p, const FT& tolerance) const
  {
    check(p - CGAL::ORIGIN, tolerance);
    const face_descriptor f = tree().closest_point_and_primitive(p).second;
    return snapped(Face_location(f, projection(f).nearest(p)), p, tolerance);
  }

  // The first point of a ray on the surface, as above; a location in the null face if it misses.
  Face_location locate(const Ray_3& r, const FT& tolerance) const
  {
    const Point_3 source = r.source();
    const Vector_3 direction = r.to_vector();
    check(source - CGAL::ORIGIN, tolerance);
    check(direction, tolerance);
    if (direction == CGAL::NULL_VECTOR)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the ray to locate has no direction");
    std::vector<face_descriptor> hit; // by predicates: exact ones make no holes between faces
    tree().all_intersected_primitives(r, std::back_inserter(hit));
    Face_location first(Graph_traits::null_face(), {FT(0), FT(0), FT(0)});
    Point_3 nearest = source;
    FT least(0);
    for (const face_descriptor f : hit)
    {
      const Triangle_projection<Kernel> triangle = projection(f);
      const FT t = triangle.first_parameter(source, direction);
      if (first.first != Graph_traits::null_face() && t >= least) continue;
      least = t;
      nearest = source + t * direction;
      first = Face_location(f, triangle.nearest(nearest));
    }
    return hit.empty() ? first : snapped(first, nearest, tolerance);
  }

  // A length: what rounding can do to points with the coordinates of the mesh; zero for exact numbers.
  FT default_tolerance() const
  {
    const Bbox_3 box = tree().bbox();
    double largest = 0;
    for (int i = 0; i < 3; ++i)
      largest = (std::max)({largest, std::abs((box.min)(i)), std::abs((box.max)(i))});
    return Number_policy<FT>::rounding(64) * FT(largest);
  }

private:
  // Reads the surface's vertex point map. A tree needs a map that can be default constructed and assigned, with points of
  // its own kernel; the user's map need not be such a one.
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
  typedef AABB_tree<AABB_traits_3<Kernel_with_triangle_projection<Kernel>, Primitive>> Tree;
#else
  typedef AABB_tree<AABB_traits<Kernel_with_triangle_projection<Kernel>, Primitive>> Tree;
#endif

  const Tree& tree() const
  {
    const Triangle_mesh& tm = m_surface->tm;
    if (faces(tm).begin() == faces(tm).end()) // not in call_once(), which hangs after an exception with some libraries
      throw std::invalid_argument("Surface_mesh_geodesic_offset: there is nothing to locate on a mesh without faces");
    std::call_once(m_once, [&] {
      m_tree.rebuild(faces(tm).begin(), faces(tm).end(), tm, Point_map{m_surface.get()});
      std::vector<typename Tree::Point_and_primitive_id> hints; // the tree's own would have each vertex several times
      for (Index v = 0; v < m_surface->unfolded.number_of_vertices(); ++v)
      {
        const Index corner = m_surface->unfolded.corner(v);
        if (corner == no_index) continue;
        const face_descriptor f = m_surface->face_of[corner / 3];
        hints.emplace_back(corners(f)[corner % 3], f);
      }
      m_tree.accelerate_distance_queries(hints.begin(), hints.end()); // now, not in the first query
    });
    return m_tree;
  }

  static void check(const Vector_3& v, const FT& tolerance)
  {
    if (!Number_policy<FT>::is_finite(v.squared_length()))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: what to locate has a coordinate that is not finite, or "
                                  "whose square is not");
    if (!(tolerance >= FT(0)))
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the tolerance is negative or not a number");
  }

  std::array<Point_3, 3> corners(face_descriptor f) const
  {
    const Triangle_mesh& tm = m_surface->tm;
    const halfedge_descriptor h = halfedge(f, tm);
    const Point_map map{m_surface.get()};
    return {map.point(source(h, tm)), map.point(target(h, tm)), map.point(target(next(h, tm), tm))};
  }

  Triangle_projection<Kernel> projection(face_descriptor f) const
  {
    return Triangle_projection<Kernel>(corners(f));
  }

  // l, the location of p, moved to a vertex or an edge within the tolerance.
  Face_location snapped(const Face_location& l, const Point_3& p, const FT& tolerance) const
  {
    const Triangle_mesh& tm = m_surface->tm;
    const Point_3 q = m_surface->point(l);
    const FT limit = CGAL::square(tolerance);
    Face_location at_vertex = l, on_edge = l;
    FT to_vertex(-1), to_edge(-1); // squared; negative: none
    std::vector<face_descriptor> reached(1, l.first);
    std::set<Index> seen{m_surface->index_of(l.first)};
    for (std::size_t i = 0; i < reached.size() && !CGAL::is_zero(to_vertex); ++i)
    {
      const std::array<Point_3, 3> corner = corners(reached[i]);
      halfedge_descriptor h = halfedge(reached[i], tm);
      for (int k = 0; k < 3; ++k, h = next(h, tm))
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
  mutable std::once_flag m_once;
  mutable Tree m_tree;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
