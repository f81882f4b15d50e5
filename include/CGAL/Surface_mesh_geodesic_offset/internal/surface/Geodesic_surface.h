// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The user's mesh together with its unfolded mesh, and conversions between the two. Immutable; shared by the main class and
// the offset curves.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_GEODESIC_SURFACE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_GEODESIC_SURFACE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Barriers.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Computation_number.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/weighted_points.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/Kernel/global_functions.h>
#include <CGAL/boost/graph/helpers.h>
#include <CGAL/boost/graph/iterator.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Precondition: all face indices are less than `end`.
template <class TriangleMesh, class Faces, class VertexIndexMap, class FaceIndexMap, class Team>
All_face_links face_links(const TriangleMesh& tm, const Faces& faces, const VertexIndexMap& vim, const FaceIndexMap& fim,
                          std::size_t end, Team& team)
{
  All_face_links links(end, boost::container::default_init);
  if (faces.size() < end) // some indices are unused
    std::fill(links.begin(), links.end(), Face_links{{no_index, no_index, no_index}, {no_index, no_index, no_index}});
  Blocks(faces.size(), team.size()).for_each(team, [&](Index, std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k)
    {
      const std::size_t i = std::size_t(get(fim, faces[k]));
      const auto h0 = halfedge(faces[k], tm), h1 = next(h0, tm), h2 = next(h1, tm);
      if (h1 == h0 || next(h2, tm) != h0)
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(i) + " is not a triangle");
      if (target(h0, tm) == target(h1, tm) || target(h1, tm) == target(h2, tm) || target(h2, tm) == target(h0, tm))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(i) + " has a vertex twice");
      const auto end_of = [&](const auto& h) { return Index(get(vim, target(h, tm))); };
      const auto beyond = [&](const auto& h) {
        const auto o = opposite(h, tm);
        return is_border(o, tm) ? no_index : Index(get(fim, face(o, tm)));
      };
      links[i] = {{end_of(h2), end_of(h0), end_of(h1)}, {beyond(h0), beyond(h1), beyond(h2)}};
    }
  });
  return links;
}

// Instead of a map of lengths: the mesh has points.
struct No_lengths
{
};

// Instead of a map of edges that are barriers.
struct No_barriers
{
};

template <class Traits_, class VertexIndexMap, class FaceIndexMap, class VertexPointMap>
struct Geodesic_surface : Surface_points<Space_kernel<typename Traits_::Kernel>>
{
  typedef Traits_ Traits;
  typedef typename Computation<Traits>::Computing_traits Computing_traits;
  typedef typename Computing_traits::FT Number; // number type of the unfolded mesh
  typedef typename Traits::Kernel Kernel;
  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  typedef typename Traits::Vector_3 Vector_3;
  typedef typename Space_kernel<Kernel>::Point_3 Space_point;
  typedef typename Traits::Triangle_mesh Triangle_mesh;
  typedef boost::graph_traits<Triangle_mesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::edge_descriptor edge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef std::array<FT, 3> Barycentric_coordinates;
  typedef std::pair<face_descriptor, Barycentric_coordinates> Face_location;

  // lengths: a map of the lengths of edges, or No_lengths; barriers: a map that is true for barrier edges, or No_barriers
  template <class LengthMap, class BarrierMap, class Team>
  Geodesic_surface(const Triangle_mesh& mesh, const VertexIndexMap& vim, const FaceIndexMap& fim, const VertexPointMap& points,
                   const LengthMap& lengths, const BarrierMap& barriers, const Traits& traits, Team& team)
    : Geodesic_surface(mesh, vim, fim, points, lengths, barriers,
                       std::vector<vertex_descriptor>(vertices(mesh).begin(), vertices(mesh).end()),
                       std::vector<face_descriptor>(faces(mesh).begin(), faces(mesh).end()), traits, team)
  {
  }

  // Conversion between the numbers of the unfolded mesh and those of the user.
  static decltype(auto) exported(const Number& x) { return converted_number<FT>(x); }
  static decltype(auto) imported(const FT& x) { return converted_number<Number>(x); }
  static Barycentric_coordinates exported(const std::array<Number, 3>& w)
  {
    return {exported(w[0]), exported(w[1]), exported(w[2])};
  }
  static std::array<Number, 3> imported(const Barycentric_coordinates& w)
  {
    return {imported(w[0]), imported(w[1]), imported(w[2])};
  }

  // \throws std::logic_error if the mesh has lengths instead of points
  void check_points() const
  {
    if (!has_points)
      throw std::logic_error("Surface_mesh_geodesic_offset: this needs points, but the mesh has lengths instead of points");
  }

  // Converts the mesh's point to the traits' kernel.
  Point_3 position(vertex_descriptor v) const
  {
    check_points();
    return converted_point<Point_3, FT>(get(vpm, v));
  }

  Space_point point_of_vertex(Index v) const override
  {
    check_points();
    return converted_point<Space_point, FT>(get(vpm, vertex_of[v]));
  }

  std::size_t mesh_index_of_face(Index f) const override { return index_in_mesh(face_of[f]); }

  // Indices in the user's mesh.
  std::size_t index_in_mesh(vertex_descriptor v) const { return std::size_t(get(vertex_indices, v)); }
  std::size_t index_in_mesh(face_descriptor f) const { return std::size_t(get(face_indices, f)); }

  // Indices in the unfolded mesh; no_index or an unused index for elements of another mesh.
  Index index_of(vertex_descriptor v) const { return numbers.of_any_vertex(index_in_mesh(v)); }
  Index index_of(face_descriptor f) const { return numbers.of_any_face(index_in_mesh(f)); }
  Index index_of_halfedge(halfedge_descriptor h) const // precondition: h is not a border halfedge
  {
    const face_descriptor f = face(h, tm);
    const halfedge_descriptor first = halfedge(f, tm);
    return 3 * index_of(f) + (h == first ? 0 : next(first, tm) == h ? 1 : 2);
  }

  // Checked indices: the arrays of descriptors have those of the mesh, so removed elements, and elements of other meshes, differ.
  // \throws std::invalid_argument if the vertex is null, removed or of another mesh
  Index checked_index_of(vertex_descriptor v) const
  {
    if (v == Graph_traits::null_vertex()) throw std::invalid_argument("Surface_mesh_geodesic_offset: the null vertex");
    const Index i = index_of(v);
    if (!(i < vertex_of.size()) || vertex_of[i] != v)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: vertex " + std::to_string(index_in_mesh(v)) +
                                  " is not of this mesh, or is removed");
    return i;
  }

  // \throws std::invalid_argument if the face is null, removed or of another mesh
  Index checked_index_of(face_descriptor f) const
  {
    if (f == Graph_traits::null_face()) throw std::invalid_argument("Surface_mesh_geodesic_offset: the null face");
    const Index i = index_of(f);
    if (!(i < face_of.size()) || face_of[i] != f)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(index_in_mesh(f)) +
                                  " is not of this mesh, or is removed");
    return i;
  }

  // \throws std::invalid_argument if the location is not valid
  Located_point<Number> classified(const Face_location& l) const
  {
    const Index face = checked_index_of(l.first); // first: a null face has no index
    return classify<Number>(unfolded, face, index_in_mesh(l.first), imported(l.second));
  }

  // Index of the halfedge, or of its opposite if it is a border halfedge.
  // \throws std::invalid_argument if the halfedge is null, removed or of another mesh, or if the edge has no face
  Index index_beside_edge(halfedge_descriptor h) const
  {
    check_halfedge(h);
    if (is_border(h, tm)) h = opposite(h, tm);
    if (is_border(h, tm)) throw std::invalid_argument("Surface_mesh_geodesic_offset: an edge without a face");
    const Index f = index_of(face(h, tm));
    if (!(f < face_of.size()) || face_of[f] != face(h, tm)) throw_foreign_edge();
    const Index i = index_of_halfedge(h);
    if (halfedge_of(i) != h) throw_foreign_edge(); // a removed halfedge may still have its face
    return i;
  }

  // \throws std::invalid_argument if the halfedge is null or its index is unused. Pointers as descriptors are recognized by
  // their face.
  void check_halfedge(halfedge_descriptor h) const
  {
    if (h == Graph_traits::null_halfedge() || !has_index(tm, h, 0)) throw_foreign_edge();
  }

  Face_location location(Index face, const Point_in_face<Number>& p) const
  {
    return Face_location(face_of[face], exported(Face_frame<Number>(unfolded, face).barycentric(p)));
  }

  // Location of a point that lies on halfedge `edge` of the face; 3 if on none.
  Face_location location(Index face, const Point_in_face<Number>& p, int edge) const
  {
    if (edge == 3) return location(face, p);
    return Face_location(face_of[face], exported(Face_frame<Number>(unfolded, face).barycentric_on_edge(edge, p)));
  }

  // Location within the face of a point that rounding may have moved out of it; `edge` as above. A point outside is replaced by
  // the nearest point of the edge that it has crossed. Setting its negative coordinate to 0 would also move the point along this
  // edge, far if the face is thin.
  Face_location location_inside(Index face, const Point_in_face<Number>& p, int edge) const
  {
    Face_location l = location(face, p, edge);
    if (!CGAL::is_negative((std::min)({l.second[0], l.second[1], l.second[2]}))) return l;
    if (edge == 3) l = location(face, p, l.second[0] < FT(0) ? 1 : l.second[1] < FT(0) ? 2 : 0);
    for (FT& w : l.second) w = (std::max)(w, FT(0));
    const FT sum = l.second[0] + l.second[1] + l.second[2];
    for (FT& w : l.second) w = w / sum;
    return l;
  }

  // Location in the null face for an isolated vertex.
  Face_location location(const Surface_point<Number>& p) const
  {
    if (p.kind == Surface_point<Number>::FACE) return location(p.element, {p.x, p.y});
    const Index h = p.kind == Surface_point<Number>::EDGE ? p.element : unfolded.corner(p.element);
    if (h == no_index) return Face_location(Graph_traits::null_face(), Barycentric_coordinates{FT(0), FT(0), FT(0)});
    return location_on(h, p.kind == Surface_point<Number>::EDGE ? exported(Number(p.x / unfolded[h].length)) : FT(0));
  }

  // Location with the barycentric coordinates given by the user.
  Face_location location(const Located_point<Number>& p) const
  {
    if (p.kind != Surface_point<Number>::FACE) return location(static_cast<const Surface_point<Number>&>(p));
    return Face_location(face_of[p.element], exported(p.weights));
  }

  Face_location location(const Path_crossing<Number>& p) const { return location_on(p.halfedge, exported(p.part)); }

  // Location of a crossing, or of a vertex on a path.
  Face_location location_of_element(const Path_crossing<Number>& p) const
  {
    return p.halfedge == no_index ? location(Surface_point<Number>::at_vertex(p.source)) : location(p);
  }

  // Location with a face of the unfolded mesh.
  Face_location location(const std::pair<Index, Barycentric_coordinates>& l) const { return {face_of[l.first], l.second}; }

  // Location on halfedge h at parameter t.
  Face_location location_on(Index h, const FT& t) const
  {
    Face_location l(face_of[h / 3], Barycentric_coordinates{FT(0), FT(0), FT(0)});
    l.second[h % 3] = FT(1) - t;
    l.second[(h % 3 + 1) % 3] = t;
    return l;
  }

  Point_3 point(const Path_crossing<Number>& p) const { return between(p.source, p.target, exported(p.part)); }

  Point_3 point(const Located_point<Number>& p) const
  {
    return p.kind == Surface_point<Number>::FACE ? point(location(p)) : point(static_cast<const Surface_point<Number>&>(p));
  }

  Point_3 point(const Surface_point<Number>& p) const
  {
    if (p.kind == Surface_point<Number>::FACE) return point(location(p));
    if (p.kind == Surface_point<Number>::EDGE)
      return between(unfolded.source(p.element), unfolded.target(p.element),
                     exported(Number(p.x / unfolded[p.element].length)));
    return position(vertex_of[p.element]);
  }

  // The point on the segment from vertex a to vertex b at parameter t.
  Point_3 between(Index a, Index b, const FT& t) const
  {
    check_points();
    const auto &at_a = get(vpm, vertex_of[a]), &at_b = get(vpm, vertex_of[b]); // no copy if the map returns references
    const Point_3 &p = converted_point<Point_3, FT>(at_a), &q = converted_point<Point_3, FT>(at_b);
    return point_between(p, q, t);
  }

  halfedge_descriptor halfedge_of(Index h) const
  {
    const halfedge_descriptor first = halfedge(face_of[h / 3], tm);
    return h % 3 == 0 ? first : h % 3 == 1 ? next(first, tm) : prev(first, tm);
  }

  // Converts a vector in the frame of a halfedge to a vector in space.
  Vector_3 vector(Index halfedge, const Point_in_face<Number>& v) const
  {
    const halfedge_descriptor h = halfedge_of(halfedge);
    const auto corner = [&](halfedge_descriptor g) { return position(source(g, tm)); };
    const Point_3 p = corner(h);
    const auto unit = [](const Vector_3& u) { return u / square_root<FT>(u.squared_length()); };
    const Vector_3 x = unit(corner(next(h, tm)) - p);
    const Vector_3 y = CGAL::cross_product(CGAL::cross_product(x, unit(corner(prev(h, tm)) - p)), x);
    return exported(v.x) * x + exported(v.y) * unit(y);
  }

  Point_3 point(const Face_location& l) const
  {
    const halfedge_descriptor h = halfedge(l.first, tm);
    return weighted_point<Point_3, FT>(l.second,
                                       {position(source(h, tm)), position(target(h, tm)), position(target(next(h, tm), tm))});
  }

  const Triangle_mesh& tm;
  const bool has_points;
  VertexIndexMap vertex_indices;
  FaceIndexMap face_indices;
  VertexPointMap vpm;
  Index_renumbering numbers;
  Unfolded_mesh<Number> unfolded;
  std::vector<face_descriptor> face_of;     // by index in the unfolded mesh
  std::vector<vertex_descriptor> vertex_of; // by index in the unfolded mesh

private:
  typedef std::decay_t<decltype(get(std::declval<const VertexPointMap&>(), std::declval<vertex_descriptor>()).x())> Coordinate;
  static constexpr bool has_plain_points = std::is_arithmetic<Coordinate>::value;

  template <class Team>
  static decltype(auto) team_or_alone(Team& team)
  {
    if constexpr (has_plain_points) return (team);
    else return (void)team, Single_worker();
  }

  // all_vertices, all_faces: in the order of the mesh
  template <class LengthMap, class BarrierMap, class Team>
  Geodesic_surface(const Triangle_mesh& mesh, const VertexIndexMap& vim, const FaceIndexMap& fim,
                   const VertexPointMap& point_map, const LengthMap& length_map, const BarrierMap& barrier_map,
                   std::vector<vertex_descriptor> all_vertices, const std::vector<face_descriptor>& all_faces,
                   const Traits& traits, Team& team)
    : tm(mesh), has_points(std::is_same<LengthMap, No_lengths>::value), vertex_indices(vim), face_indices(fim), vpm(point_map),
      numbers(end_of_indices(vim, all_vertices, (std::size_t(1) << 29) - 1),
              end_of_indices(fim, all_faces, (std::size_t(1) << 30) - 1))
  {
    All_face_links links = face_links(tm, all_faces, vim, fim, numbers.faces_end(), team), whole_links;
    std::vector<Index> indices; // in the mesh; copies have the numbers behind
    indices.reserve(all_vertices.size());
    for (const vertex_descriptor v : all_vertices) indices.push_back(Index(index_in_mesh(v)));
    Barriers barriers;
    if constexpr (!std::is_same<BarrierMap, No_barriers>::value)
    {
      whole_links = links;
      barriers = cut(links, all_faces, barrier_map);
      add_copies(barriers, all_vertices, indices);
    }
    // coordinates of other than built-in types may share memory, so one thread reads them
    auto&& readers_of_points = team_or_alone(team);
    if (has_points) renumber_if_scattered(links, all_vertices, indices, readers_of_points);
    barriers.renumber(numbers);
    const std::vector<Index> face_at = place_faces(all_faces, team);
    vertex_of.assign(numbers.vertices_end(), Graph_traits::null_vertex());
    const auto set_up = [&](const auto&... layout) {
      unfolded = Unfolded_mesh<Number>(numbers, links, face_at, layout..., team);
      if (!barriers.empty() && unfolded.is_laid_out())
        unfolded.set_barriers(barriers, Unfolded_mesh<Number>(numbers, whole_links, face_at, layout..., team));
    };
    if constexpr (std::is_same<LengthMap, No_lengths>::value)
    {
      std::vector<typename Computing_traits::Point_3> points(numbers.vertices_end());
      Blocks(all_vertices.size(), readers_of_points.size()).for_each(readers_of_points, [&](Index, auto begin, auto end) {
        for (std::size_t k = begin; k < end; ++k)
        {
          const vertex_descriptor v = all_vertices[k];
          const Index i = numbers.of_vertex(indices[k]);
          vertex_of[i] = v;
          // isolated vertices may have coordinates that are not convertible, such as NaN
          if (halfedge(v, tm) != Graph_traits::null_halfedge())
            points[i] = converted_point<typename Computing_traits::Point_3, Number>(get(vpm, v));
        }
      });
      set_up(points, Computation<Traits>::computing_traits(traits));
    }
    else
    {
      for (std::size_t k = 0; k < indices.size(); ++k) vertex_of[numbers.of_vertex(indices[k])] = all_vertices[k];
      std::vector<Number> lengths(3 * face_of.size(), Number(0)); // by halfedge
      for (const face_descriptor f : all_faces)
      {
        halfedge_descriptor h = halfedge(f, tm);
        for (Index k = 0; k < 3; ++k, h = next(h, tm))
          lengths[3 * index_of(f) + k] = imported(FT(get(length_map, edge(h, tm))));
      }
      set_up(vertex_of.size(), lengths);
    }
    if (!unfolded.has_usable_scale())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the longest edge is too long or too short for the number "
                                  "type: the mesh must be scaled");
    if (!unfolded.is_laid_out()) throw_degenerate_face();
  }

  // One more than the largest index; 0 if there are no elements.
  // \throws std::length_error if an index is not less than `limit`
  template <class IndexMap, class Descriptor>
  static std::size_t end_of_indices(const IndexMap& indices, const std::vector<Descriptor>& elements, std::size_t limit)
  {
    std::size_t largest = 0;
    for (const Descriptor e : elements) largest = (std::max)(largest, std::size_t(get(indices, e)));
    if (largest >= limit)
      throw std::length_error("Surface_mesh_geodesic_offset: the mesh has too many elements for 32-bit indices, or indices "
                              "that are not set");
    return elements.empty() ? 0 : largest + 1;
  }

  // Sets face_of. Returns the mesh index of each face.
  template <class Team>
  std::vector<Index> place_faces(const std::vector<face_descriptor>& all_faces, Team& team)
  {
    face_of.assign(numbers.faces_end(), Graph_traits::null_face()); // unused indices keep the null descriptor
    std::vector<Index> face_at(numbers.faces_end(), no_index);
    Blocks(all_faces.size(), team.size()).for_each(team, [&](Index, std::size_t begin, std::size_t end) {
      for (std::size_t k = begin; k < end; ++k)
      {
        const Index i = index_of(all_faces[k]);
        face_of[i] = all_faces[k];
        face_at[i] = Index(index_in_mesh(all_faces[k]));
      }
    });
    return face_at;
  }

  // Cuts the links along the edges for which the map is true.
  template <class BarrierMap>
  Barriers cut(All_face_links& links, const std::vector<face_descriptor>& all_faces, const BarrierMap& is_barrier) const
  {
    std::vector<face_descriptor> face_at(links.size(), Graph_traits::null_face());
    for (const face_descriptor f : all_faces) face_at[index_in_mesh(f)] = f;
    return Barriers(links, numbers.vertices_end(), [&](Index f, Index k) {
      const halfedge_descriptor first = halfedge(face_at[f], tm);
      return bool(get(is_barrier, edge(k == 0 ? first : k == 1 ? next(first, tm) : prev(first, tm), tm)));
    });
  }

  // Adds the copies of vertices on barriers to all vertices and their numbers.
  void add_copies(const Barriers& barriers, std::vector<vertex_descriptor>& all_vertices, std::vector<Index>& indices)
  {
    std::vector<vertex_descriptor> vertex_at(numbers.vertices_end(), Graph_traits::null_vertex());
    for (std::size_t i = 0; i < indices.size(); ++i) vertex_at[indices[i]] = all_vertices[i];
    Index next = Index(numbers.vertices_end());
    for (const Index v : barriers.copied())
    {
      indices.push_back(next++);
      all_vertices.push_back(vertex_at[v]);
    }
    numbers.add_vertices(barriers.copied().size());
  }

  template <class Team>
  void renumber_if_scattered(const All_face_links& links, const std::vector<vertex_descriptor>& all_vertices,
                             const std::vector<Index>& indices, Team& team)
  {
    const auto finite = [](const auto& x) {
      const double d = CGAL::to_double(x);
      return std::isfinite(d) ? d : 0.; // reported later
    };
    numbers.renumber_if_scattered(
      links, indices,
      [&](std::size_t i) {
        const auto& p = get(vpm, all_vertices[i]);
        return Per_corner<double>(finite(p.x()), finite(p.y()), finite(p.z()));
      },
      team);
  }

  // True if the index of a halfedge is in use, for meshes that provide this information, such as CGAL::Surface_mesh.
  template <class Mesh>
  static auto has_index(const Mesh& mesh, halfedge_descriptor h, int)
    -> decltype(mesh.has_valid_index(h) && !mesh.is_removed(h))
  {
    return mesh.has_valid_index(h) && !mesh.is_removed(h);
  }
  template <class Mesh>
  static bool has_index(const Mesh&, halfedge_descriptor, long)
  {
    return true;
  }

  [[noreturn]] static void throw_foreign_edge()
  {
    throw std::invalid_argument("Surface_mesh_geodesic_offset: an edge that is null, removed or of another mesh");
  }

  // Throws for the first face that has no layout.
  void throw_degenerate_face() const
  {
    for (face_descriptor f : faces(tm))
      if (!unfolded.has_area(index_of(f)))
        throw std::invalid_argument("Surface_mesh_geodesic_offset: face " + std::to_string(index_in_mesh(f)) +
                                    (has_points ? " is degenerate or has a coordinate that is not finite; "
                                                  "CGAL::remove_degenerate_faces_in_polygon_soup() removes degenerate faces"
                                                : ": the lengths of its edges do not satisfy the triangle inequality, or are "
                                                  "not finite"));
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
