// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Splits the faces of a mesh along offset curves: collects the points of the curves, triangulates the crossed faces, replaces
// them, and finds the bands between the curves.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_MESH_SPLITTING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_MESH_SPLITTING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Face_triangulation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Piece_crossings.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_points.h>

#include <CGAL/assertions.h>
#include <CGAL/boost/graph/Euler_operations.h>
#include <CGAL/boost/graph/iterator.h>
#include <CGAL/boost/graph/properties.h>

#include <boost/graph/graph_traits.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class TriangleMesh, class VertexPointMap, class Curve>
class Mesh_splitting
{
public:
  typedef boost::graph_traits<TriangleMesh> Graph_traits;
  typedef typename Graph_traits::vertex_descriptor vertex_descriptor;
  typedef typename Graph_traits::halfedge_descriptor halfedge_descriptor;
  typedef typename Graph_traits::face_descriptor face_descriptor;
  typedef typename Curve::Piece Piece;
  typedef Split_points<TriangleMesh, VertexPointMap> Points;
  typedef typename Points::Id Id;
  typedef typename Points::Weights Weights;

  // `diagonal`: of the bounding box of the mesh.
  Mesh_splitting(TriangleMesh& tm, const VertexPointMap& vpm, double diagonal, double chord_tolerance)
    : m_mesh(tm), m_vpm(vpm), m_points(tm, vpm, diagonal), m_tolerance(chord_tolerance), m_number_at(get(Face_tag(), tm))
  {
    for (const face_descriptor f : faces(tm)) put(m_number_at, f, 0);
  }

  // Bands and cells do not spread across barriers of the surface that the curves are on.
  template <class Surface>
  void set_barriers(const Surface& surface)
  {
    surface.unfolded.for_each_barrier([&](auto h) { m_barriers.insert(edge(surface.halfedge_of(h), m_mesh)); });
  }

  // `level`: index of the distance of the curve among those of all curves, by increasing distance.
  void add(const Curve& curve, std::size_t level)
  {
    const std::size_t n = curve.number_of_pieces();
    Id first = 0, last = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      m_pieces.push_back(curve.piece(i));
      const Piece& p = m_pieces.back();
      if (i == 0) first = last = add(p.start());
      if (!m_points.is_on(p.face(), last)) last = link(last, add(p.start()), level);
      const bool is_last = curve.is_closed() && i + 1 == n, is_joined = is_last && m_points.is_on(p.face(), first);
      const Id next = is_joined ? first : add(p.end());
      faces_with(p.face()).push_back({last, next, level, p.is_arc() ? &p : nullptr});
      last = next;
      if (is_last && !is_joined) link(last, first, level);
    }
  }

  // Makes the points where pieces cross points of the mesh, and lets pieces pass points that are nearer than the snap distance. To be
  // called when all curves are added, if all pieces are straight.
  void cross_pieces()
  {
    for (Face_pieces& f : m_faces) f.crossings = Piece_crossings<Points, Piece>(m_points, f.face).find(f.pieces);
    m_crosses_pieces = true;
  }

  // Triangulates the crossed faces. To be called once, when all curves are added.
  void triangulate()
  {
    m_points.merge_on_edges();
    for (const auto& e : m_points.edges_with_points()) add_faces_beside(e.halfedge);
    Face_triangulation<Points, Piece> triangulation(m_points, m_tolerance);
    for (Face_pieces& f : m_faces)
    {
      std::vector<Id> ends = f.crossings;
      for (const auto& p : f.pieces) ends.insert(ends.end(), {p.from, p.to});
      m_points.merge_inside(f.face, ends);
      for (auto& p : f.pieces)
      {
        p.from = m_points.merged(p.from);
        p.to = m_points.merged(p.to);
      }
      if (m_crosses_pieces)
      {
        for (Id& id : ends) id = m_points.merged(id);
        const std::vector<Id> boundary = m_points.boundary(f.face);
        ends.insert(ends.end(), boundary.begin(), boundary.end());
        Piece_crossings<Points, Piece>(m_points, f.face).divide(f.pieces, ends);
      }
      triangulation(f.face, f.pieces);
      m_triangulated.push_back({f.face,
                                m_points[triangulation.boundary()[0]].vertex,
                                triangulation.boundary(),
                                triangulation.triangles(),
                                triangulation.edges(),
                                {}});
    }
  }

  // Finds the sources of the faces of the result, before the mesh changes. `source_of(face, weights)` is the nearest source of a
  // point, or another number that stands for it.
  template <class Function>
  void find_sources(const Function& source_of)
  {
    for (const face_descriptor f : faces(m_mesh))
      if (get(m_number_at, f) == 0) m_uncrossed.push_back({f, source_of(f, Weights{1. / 3, 1. / 3, 1. / 3})});
    for (Triangulated_face& f : m_triangulated)
      for (const auto& t : f.triangles)
      {
        Weights center = {0, 0, 0};
        for (const Id id : t)
          for (std::size_t k = 0; k < 3; ++k) center[k] += m_points.weights(f.face, id)[k] / 3;
        f.sources.push_back(source_of(f.face, center));
      }
  }

  // Changes the mesh. Sets the map to true for the new edges of curves. Calls `put_source(face, source)` for the results of
  // find_sources().
  template <class EdgeIsConstrainedMap, class Visitor, class PutSource>
  void split(EdgeIsConstrainedMap is_constrained, Visitor& visitor, const PutSource& put_source)
  {
    for (const auto& e : m_points.edges_with_points()) divide(e, visitor);
    for (const Triangulated_face& f : m_triangulated) replace(f, visitor, put_source);
    for (const Curve_edge& e : m_edges) put(is_constrained, edge(e.halfedge, m_mesh), true);
    for (const auto& f : m_uncrossed) put_source(f.first, f.second);
  }

  // Calls f with the level of a curve and a halfedge in its direction, for each edge of each curve. To be called after split().
  template <class Function>
  void for_each_edge(const Function& f) const
  {
    for (const Curve_edge& e : m_edges) f(e.level, e.halfedge);
  }

  // Writes the band of each face: the number of levels that do not exceed its distances. The band of a region follows from the
  // curves on its border. If there are none, or they contradict each other, as where the sides of a strip coincide in parts, it
  // follows from the mean of the smallest and the largest distance of its vertices; the largest may be a level whose curve is a
  // point. Without distances of vertices, such a region has the band by its curves, or the lowest one.
  template <class FaceBandMap, class Levels, class Distance>
  void write_bands(FaceBandMap band_map, const Levels& levels, const std::optional<Distance>& distance_of)
  {
    Face_labels regions(m_mesh, m_edges, m_barriers); // connected without crossing a curve
    std::vector<face_descriptor> first;               // a face of each
    for (const face_descriptor f : faces(m_mesh))
    {
      if (regions.is_set(f)) continue;
      regions.set(f, first.size());
      regions.spread();
      first.push_back(f);
    }
    // A region is nearer than all levels that it has on the left, and farther than those on the right. If chords cross, a
    // region may have edges of both.
    const std::size_t none = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> upper(first.size(), none), lower(first.size(), none);
    const auto directed = sorted_edges();
    for (const Curve_edge& e : m_edges)
    {
      // both sides of a strip that is a polyline: the edge does not tell on which side points are nearer
      if (std::binary_search(directed.begin(), directed.end(), std::array<std::size_t, 3>{e.to, e.from, e.level})) continue;
      const face_descriptor left = face(e.halfedge, m_mesh), right = face(opposite(e.halfedge, m_mesh), m_mesh);
      if (left != Graph_traits::null_face())
      {
        std::size_t& u = upper[regions.of(left)];
        u = (std::min)(u, e.level);
      }
      if (right != Graph_traits::null_face())
      {
        std::size_t& l = lower[regions.of(right)];
        l = l == none ? e.level + 1 : (std::max)(l, e.level + 1);
      }
    }
    std::vector<std::size_t> bands;
    std::vector<std::size_t> uncertain; // regions
    for (std::size_t r = 0; r < first.size(); ++r)
    {
      bands.push_back(upper[r] != none ? upper[r] : lower[r]);
      if (bands[r] == none || (lower[r] != none && lower[r] != bands[r])) uncertain.push_back(r);
    }
    for (std::size_t& b : bands) b = levels.band_behind(b == none ? 0 : b);
    if (distance_of && !uncertain.empty())
    {
      const auto middle = middle_distances(regions, first.size(), *distance_of);
      for (const std::size_t r : uncertain)
        if (middle[r]) bands[r] = levels.band_at(*middle[r]);
    }
    for (const face_descriptor f : faces(m_mesh)) put(band_map, f, bands[regions.of(f)]);
  }

  // Writes the label of each face: one of `labels_at(face)`, the nearest first. Where there are several, as at the centers of thin
  // triangles beside a curve, that of a neighbour on the same side of the curves, or of `labels_of(level)`, on the left and on the
  // right of a curve.
  template <class FaceSourceMap, class Function, class Labels_of>
  void write_cells(FaceSourceMap source_map, const Function& labels_at, const Labels_of& labels_of)
  {
    Face_labels labels(m_mesh, m_edges, m_barriers, [&](face_descriptor f, std::size_t label) {
      const std::vector<std::size_t>& allowed = labels_at(f);
      return std::find(allowed.begin(), allowed.end(), label) != allowed.end();
    });
    for (const face_descriptor f : faces(m_mesh))
      if (labels_at(f).size() == 1) labels.set(f, labels_at(f).front());
    labels.spread();
    for (const Curve_edge& e : m_edges)
    {
      const std::pair<std::size_t, std::size_t> sides = labels_of(e.level);
      labels.set(face(e.halfedge, m_mesh), sides.first);
      labels.set(face(opposite(e.halfedge, m_mesh), m_mesh), sides.second);
    }
    labels.spread();
    for (const face_descriptor f : faces(m_mesh)) put(source_map, f, labels.is_set(f) ? labels.of(f) : labels_at(f).front());
  }

private:
  typedef CGAL::dynamic_face_property_t<std::size_t> Face_tag;
  typedef Split_piece<Piece> Piece_in_face;
  struct Face_pieces
  {
    face_descriptor face;
    std::vector<Piece_in_face> pieces;
    std::vector<Id> crossings; // see cross_pieces()
  };
  struct Curve_edge : Split_edge // of the split mesh, in the direction of its curve
  {
    halfedge_descriptor halfedge;
  };
  typedef std::set<typename Graph_traits::edge_descriptor> Edges;
  // Labels of faces, spread over all edges but those of curves and barriers.
  class Face_labels
  {
  public:
    typedef std::function<bool(face_descriptor, std::size_t)> Is_allowed;

    Face_labels(const TriangleMesh& mesh, const std::vector<Curve_edge>& curves, const Edges& barriers,
                Is_allowed is_allowed = {})
      : m_mesh(mesh), m_is_allowed(std::move(is_allowed)), m_label(get(Face_tag(), mesh)), m_is_set(get(Set_tag(), mesh)),
        m_is_curve(get(Edge_tag(), mesh))
    {
      for (const face_descriptor f : faces(mesh)) put(m_is_set, f, false);
      for (const auto e : edges(mesh)) put(m_is_curve, e, false);
      for (const Curve_edge& e : curves) put(m_is_curve, edge(e.halfedge, mesh), true);
      for (const auto e : barriers) put(m_is_curve, e, true);
    }

    // The first label counts.
    void set(face_descriptor f, std::size_t label)
    {
      if (f == Graph_traits::null_face() || get(m_is_set, f) || (m_is_allowed && !m_is_allowed(f, label))) return;
      put(m_is_set, f, true);
      put(m_label, f, label);
      m_pending.push_back(f);
    }

    void spread()
    {
      while (!m_pending.empty())
      {
        const face_descriptor f = m_pending.front();
        m_pending.pop_front();
        for (const halfedge_descriptor h : halfedges_around_face(halfedge(f, m_mesh), m_mesh))
          if (!get(m_is_curve, edge(h, m_mesh))) set(face(opposite(h, m_mesh), m_mesh), get(m_label, f));
      }
    }

    bool is_set(face_descriptor f) const { return get(m_is_set, f); }
    std::size_t of(face_descriptor f) const { return get(m_label, f); }

  private:
    typedef CGAL::dynamic_face_property_t<bool> Set_tag;
    typedef CGAL::dynamic_edge_property_t<bool> Edge_tag;

    const TriangleMesh& m_mesh;
    const Is_allowed m_is_allowed;
    typename boost::property_map<TriangleMesh, Face_tag>::const_type m_label;
    typename boost::property_map<TriangleMesh, Set_tag>::const_type m_is_set;
    typename boost::property_map<TriangleMesh, Edge_tag>::const_type m_is_curve;
    std::deque<face_descriptor> m_pending;
  };
  struct Triangulated_face
  {
    face_descriptor face;
    vertex_descriptor first;  // source of the first halfedge of the face, before the split
    std::vector<Id> boundary; // from there on
    std::vector<std::array<Id, 3>> triangles;
    std::vector<Split_edge> edges;
    std::vector<std::size_t> sources; // of the triangles, if they are requested
  };

  // From, to and level of each
  std::vector<std::array<std::size_t, 3>> sorted_edges() const
  {
    std::vector<std::array<std::size_t, 3>> result;
    for (const Curve_edge& e : m_edges) result.push_back({e.from, e.to, e.level});
    std::sort(result.begin(), result.end());
    return result;
  }

  // The mean of the smallest and the largest distance of the original vertices of each region; none without such vertices.
  template <class Distance>
  auto middle_distances(const Face_labels& regions, std::size_t number, const Distance& distance_of) const
  {
    const auto is_new = get(CGAL::dynamic_vertex_property_t<bool>(), m_mesh);
    for (const vertex_descriptor v : vertices(m_mesh)) put(is_new, v, false);
    for (const vertex_descriptor v : m_new_vertices) put(is_new, v, true);
    typedef decltype(distance_of(vertex_descriptor())) FT;
    std::vector<std::optional<FT>> least(number), largest(number);
    for (const face_descriptor f : faces(m_mesh))
      for (const vertex_descriptor v : vertices_around_face(halfedge(f, m_mesh), m_mesh))
      {
        if (get(is_new, v)) continue;
        const std::size_t r = regions.of(f);
        const FT d = distance_of(v);
        if (!least[r] || d < *least[r]) least[r] = d;
        if (!largest[r] || d > *largest[r]) largest[r] = d;
      }
    for (std::size_t r = 0; r < number; ++r)
      if (least[r]) least[r] = (*least[r] + *largest[r]) / 2;
    return least;
  }

  template <class Location>
  Id add(const Location& l)
  {
    Weights w;
    for (std::size_t k = 0; k < 3; ++k) w[k] = CGAL::to_double(l.second[k]);
    return m_points.add(l.first, w);
  }

  // Joins the ends of two pieces in faces with no common edge: curves have no pieces in faces that they cross beside a vertex,
  // where rounding does not tell a piece from a point.
  Id link(Id from, Id to, std::size_t level)
  {
    const face_descriptor f = from == to ? Graph_traits::null_face() : m_points.common_face(from, to);
    if (f != Graph_traits::null_face()) faces_with(f).push_back({from, to, level, nullptr});
    return to;
  }

  std::vector<Piece_in_face>& faces_with(face_descriptor f)
  {
    std::size_t number = get(m_number_at, f);
    if (number == 0)
    {
      m_faces.push_back({f, {}, {}});
      number = m_faces.size();
      put(m_number_at, f, number);
    }
    return m_faces[number - 1].pieces;
  }

  void add_faces_beside(halfedge_descriptor h)
  {
    for (const halfedge_descriptor g : {h, opposite(h, m_mesh)})
      if (!is_border(g, m_mesh)) faces_with(face(g, m_mesh));
  }

  // Inserts the points of an edge.
  template <class Visitor>
  void divide(const typename Points::Edge_points& e, Visitor& visitor)
  {
    visitor.before_edge_split(e.halfedge, m_mesh);
    const bool is_barrier = m_barriers.count(edge(e.halfedge, m_mesh)) != 0;
    for (const Id id : e.ids)
    {
      const halfedge_descriptor h = CGAL::Euler::split_edge(e.halfedge, m_mesh);
      if (is_barrier) m_barriers.insert(edge(h, m_mesh));
      const vertex_descriptor v = target(h, m_mesh);
      m_new_vertices.push_back(v);
      put(m_vpm, v, m_points[id].point);
      m_points.set_vertex(id, v);
      visitor.new_vertex_added(v, m_mesh);
      visitor.edge_split(h, m_mesh);
    }
    visitor.after_edge_split();
  }

  // Replaces a face, whose edges are divided, by its triangles.
  template <class Visitor, class PutSource>
  void replace(const Triangulated_face& f, Visitor& visitor, const PutSource& put_source)
  {
    if (!f.sources.empty()) put_source(f.face, f.sources[0]);
    std::map<std::pair<Id, Id>, halfedge_descriptor> halfedge_between;
    halfedge_descriptor h = halfedge(f.face, m_mesh);
    while (source(h, m_mesh) != f.first) h = next(h, m_mesh);
    for (std::size_t i = 0; i < f.boundary.size(); ++i, h = next(h, m_mesh))
    {
      CGAL_assertion(source(h, m_mesh) == m_points[f.boundary[i]].vertex);
      halfedge_between[{f.boundary[i], f.boundary[(i + 1) % f.boundary.size()]}] = h;
    }
    if (f.triangles.size() > 1) create_triangles(f, halfedge_between, visitor, put_source);
    for (const Split_edge& e : f.edges)
    { // edges of the boundary are known in one direction
      const auto it = halfedge_between.find({e.from, e.to});
      m_edges.push_back({e, it != halfedge_between.end() ? it->second : opposite(halfedge_between.at({e.to, e.from}), m_mesh)});
    }
  }

  template <class Visitor, class PutSource>
  void create_triangles(const Triangulated_face& f, std::map<std::pair<Id, Id>, halfedge_descriptor>& halfedge_between,
                        Visitor& visitor, const PutSource& put_source)
  {
    visitor.before_subface_creations(f.face, m_mesh);
    for (std::size_t i = 0; i < f.triangles.size(); ++i)
    {
      const std::array<Id, 3>& t = f.triangles[i];
      if (i != 0) visitor.before_subface_created(m_mesh);
      const face_descriptor g = i == 0 ? f.face : add_face(m_mesh);
      std::array<halfedge_descriptor, 3> side;
      for (std::size_t k = 0; k < 3; ++k) side[k] = between(t[k], t[(k + 1) % 3], halfedge_between, visitor);
      for (std::size_t k = 0; k < 3; ++k)
      {
        set_next(side[k], side[(k + 1) % 3], m_mesh);
        set_face(side[k], g, m_mesh);
      }
      set_halfedge(g, side[0], m_mesh);
      if (i == 0) continue;
      if (!f.sources.empty()) put_source(g, f.sources[i]);
      visitor.after_subface_created(g, m_mesh);
    }
    visitor.after_subface_creations(m_mesh);
  }

  template <class Visitor>
  halfedge_descriptor between(Id from, Id to, std::map<std::pair<Id, Id>, halfedge_descriptor>& known, Visitor& visitor)
  {
    const auto it = known.find({from, to});
    if (it != known.end()) return it->second;
    const halfedge_descriptor h = halfedge(add_edge(m_mesh), m_mesh), g = opposite(h, m_mesh);
    known[{from, to}] = h;
    known[{to, from}] = g;
    set_target(h, vertex_at(to, h, visitor), m_mesh);
    set_target(g, vertex_at(from, g, visitor), m_mesh);
    return h;
  }

  // The vertex of a point; a new one, with the given halfedge, for a point in a face.
  template <class Visitor>
  vertex_descriptor vertex_at(Id id, halfedge_descriptor h, Visitor& visitor)
  {
    if (m_points[id].vertex != Graph_traits::null_vertex()) return m_points[id].vertex;
    const vertex_descriptor v = add_vertex(m_mesh);
    m_new_vertices.push_back(v);
    put(m_vpm, v, m_points[id].point);
    set_halfedge(v, h, m_mesh);
    m_points.set_vertex(id, v);
    visitor.new_vertex_added(v, m_mesh);
    return v;
  }

  TriangleMesh& m_mesh;
  const VertexPointMap m_vpm;
  Points m_points;
  const double m_tolerance;
  std::deque<Piece> m_pieces; // the addresses stay
  std::vector<Face_pieces> m_faces;
  std::vector<Triangulated_face> m_triangulated;
  std::vector<std::pair<face_descriptor, std::size_t>> m_uncrossed; // faces that no curve crosses, with their sources
  bool m_crosses_pieces = false;
  std::vector<Curve_edge> m_edges;
  Edges m_barriers;
  std::vector<vertex_descriptor> m_new_vertices;
  typename boost::property_map<TriangleMesh, Face_tag>::type m_number_at; // 1 + index in m_faces
};

} // namespace CGAL::Geodesic_offset::internal

#endif
