// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Triangulates one face with the points on its boundary and the pieces of offset curves in it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_FACE_TRIANGULATION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SPLITTING_FACE_TRIANGULATION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Arc_division.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/splitting/Split_points.h>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_plus_2.h>
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/assertions.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// The triangulation is that of exact points, of which those on edges are exactly there, so that the triangles of two faces have
// the same points on their common edge. Where chords cross all the same, arcs are divided further.
template <class Points, class Piece>
class Face_triangulation
{
public:
  typedef std::size_t Id;
  typedef typename Points::face_descriptor face_descriptor;
  typedef Split_piece<Piece> Piece_in_face;

  Face_triangulation(Points& points, double chord_tolerance)
    : m_points(points), m_division(chord_tolerance, points.snap_distance())
  {
  }

  // Triangulates a face. The result is valid until the next call.
  void operator()(face_descriptor f, const std::vector<Piece_in_face>& pieces)
  {
    m_face = f;
    m_flat = m_points.flat(f);
    m_boundary = m_points.boundary(f);
    m_chord_ends = m_division(pieces);
    // Chords cross where arcs of different centers are closer than the tolerance, or as far as two sources tie. The latter cross
    // however far they are divided, and become edges that end where they cross.
    std::size_t chords = 0; // of arcs
    for (const std::vector<double>& t : m_chord_ends) chords += t.empty() ? 0 : t.size() - 1;
    bool fits = triangulate(pieces, 1, false);
    for (std::size_t division = 2; !fits && is_worth_a_try(division, chords); division *= 2)
      fits = triangulate(pieces, division, false);
    if (!fits) triangulate(pieces, 1, true);
    m_triangles.clear();
    m_edges.clear();
    name_crossings();
    for (auto t = m_cdt.finite_faces_begin(); t != m_cdt.finite_faces_end(); ++t)
      m_triangles.push_back({id(t->vertex(0)), id(t->vertex(1)), id(t->vertex(2))});
    find_edges();
  }

  // Points of the boundary, counterclockwise from the first corner.
  const std::vector<Id>& boundary() const { return m_boundary; }
  // Counterclockwise triangles.
  const std::vector<std::array<Id, 3>>& triangles() const { return m_triangles; }
  // The parts of the pieces that are edges of triangles.
  const std::vector<Split_edge>& edges() const { return m_edges; }

private:
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact;
  typedef Exact::Point_2 Exact_point;
  static constexpr Id no_id = std::numeric_limits<Id>::max();
  struct Vertex_id
  {
    Id value = no_id;
    bool is_set() const { return value != no_id; }
  };
  typedef CGAL::Triangulation_data_structure_2<CGAL::Triangulation_vertex_base_with_info_2<Vertex_id, Exact>,
                                               CGAL::Constrained_triangulation_face_base_2<Exact>>
    Data_structure;
  // The points where chords cross are computed from the chords: of parts of chords, their digits would grow with each crossing.
  typedef CGAL::Constrained_triangulation_plus_2<
    CGAL::Constrained_Delaunay_triangulation_2<Exact, Data_structure, CGAL::Exact_intersections_tag>>
    Triangulation;
  typedef typename Triangulation::Vertex_handle Vertex_handle;
  struct Constraint
  {
    Vertex_handle from, to;
    std::size_t level;
    typename Triangulation::Constraint_id id = {}; // of the triangulation
  };

  // Arcs are divided at most 2^10 times further: then chords of arcs at the tolerance are within 2^-20 of it.
  static constexpr std::size_t most_divisions = 1 << 10;
  // But beyond eight times only up to this number of chords in a face, which bounds the time for curves that are closer than
  // rounding along their length: a triangulation of 2^12 points of circles takes a second, one of twice as many four times that.
  static constexpr std::size_t few_divisions = 1 << 3, most_chords = 1 << 12;

  bool is_worth_a_try(std::size_t division, std::size_t chords) const
  {
    if (chords == 0 || division > most_divisions) return false;
    return division <= few_divisions || division * chords <= most_chords;
  }

  // Builds the triangulation, with arcs divided `division` times further than the tolerance asks. Returns false if constraints
  // cross; then there is no triangulation, unless they may cross.
  bool triangulate(const std::vector<Piece_in_face>& pieces, std::size_t division, bool may_cross)
  {
    m_cdt.clear();
    m_vertex_of.clear();
    m_constraints.clear();
    m_inner.clear();
    for (const Id id : m_boundary) vertex(id);
    for (std::size_t i = 0; i < pieces.size(); ++i)
    {
      const Piece_in_face& p = pieces[i];
      Vertex_handle last = vertex(p.from);
      if (p.arc)
        for_each_inner_point(*p.arc, m_chord_ends[i], division, [&](const Flat_face::Weights& w) {
          const Vertex_handle v = m_cdt.insert(inside(w), last->face()); // beside the last one
          if (!v->info().is_set()) m_inner.push_back({v, w});
          last = constrain(last, v, p.level);
        });
      constrain(last, vertex(p.to), p.level);
    }
    const std::size_t expected = m_cdt.number_of_vertices();
    for (Constraint& c : m_constraints)
    {
      c.id = m_cdt.insert_constraint(c.from, c.to);
      if (m_cdt.number_of_vertices() != expected && !may_cross) return false;
    }
    return m_cdt.number_of_vertices() == expected;
  }

  // Calls f(weights) for the points between the chords of an arc, of which each is divided, but not within the snap distance of
  // the edges: where the arc comes there, for the last point before and the first one behind, so that the chord between them is
  // near to the edge, too.
  template <class Function>
  void for_each_inner_point(const Piece& arc, const std::vector<double>& ends, std::size_t division, const Function& f) const
  {
    const std::size_t n = (ends.size() - 1) * division;
    if (n == 1) return;
    const auto parameter = [&](std::size_t j) {
      const std::size_t i = j / division;
      return j % division == 0 ? ends[i] : ends[i] + double(j % division) / double(division) * (ends[i + 1] - ends[i]);
    };
    const auto weights = [&](double t) {
      const auto location = arc.location(typename Piece::FT(t));
      Flat_face::Weights w;
      for (std::size_t k = 0; k < 3; ++k) w[k] = CGAL::to_double(location.second[k]);
      return w;
    };
    const auto is_inside = [&](double t) { return m_points.is_inside(m_flat, weights(t)); };
    double before = 0;
    bool was_inside = is_inside(0);
    const auto visit = [&](double t, bool is_in) {
      const bool is_left_out = is_in ? before > 0 : t < 1; // an inner point, not an end
      if (is_in != was_inside && is_left_out) f(weights(last_inside(is_inside, is_in ? t : before, is_in ? before : t)));
      if (is_in && t < 1) f(weights(t));
      before = t;
      was_inside = is_in;
    };
    for (std::size_t j = 1; j <= n; ++j)
    {
      const double t = parameter(j);
      const bool is_in = is_inside(t);
      const double middle = 0.5 * (before + t); // of an arc that touches an edge at both ends
      if (!is_in && !was_inside && is_inside(middle)) visit(middle, true);
      visit(t, is_in);
    }
  }

  // The parameter between `in` and `out`, of a point inside and one that is not, at which the arc is inside last.
  template <class Condition>
  static double last_inside(const Condition& is_inside, double in, double out)
  {
    for (int i = 0; i < std::numeric_limits<double>::digits; ++i)
    {
      const double middle = 0.5 * (in + out);
      (is_inside(middle) ? in : out) = middle;
    }
    return in;
  }

  template <class Handle>
  static Id id(const Handle& v)
  {
    return v->info().value;
  }

  Vertex_handle constrain(Vertex_handle from, Vertex_handle to, std::size_t level)
  {
    if (from != to) m_constraints.push_back({from, to, level, {}});
    return to;
  }

  Vertex_handle vertex(Id id)
  {
    const auto known = m_vertex_of.find(id);
    if (known != m_vertex_of.end()) return known->second;
    const Vertex_handle v = m_cdt.insert(exact(id));
    if (!v->info().is_set()) v->info().value = id;
    m_vertex_of[id] = v;
    return v;
  }

  Exact_point corner(int k) const { return Exact_point(m_flat.x(k), m_flat.y(k)); }

  Exact_point inside(const Flat_face::Weights& w) const
  {
    const Exact::FT a(w[1]), b(w[2]);
    return Exact_point(a * m_flat.length + b * m_flat.apex_x, b * m_flat.apex_y);
  }

  Exact_point exact(Id id) const
  {
    const auto& p = m_points[id];
    if (p.place == Points::AT_VERTEX) return corner(m_points.corner_of(m_face, p.vertex));
    if (p.place == Points::IN_FACE) return inside(p.weights);
    // both faces have the same parameter
    const std::pair<int, bool> side = m_points.side_with(m_face, id);
    const int next = (side.first + 1) % 3;
    const Exact_point from = corner(side.second ? side.first : next), to = corner(side.second ? next : side.first);
    return from + Exact::FT(p.part) * (to - from);
  }

  // Points where chords cross, and inner points of arcs.
  void name_crossings()
  {
    for (const auto& p : m_inner)
      if (!p.first->info().is_set()) p.first->info().value = m_points.add_inside(m_face, p.second);
    for (auto v = m_cdt.finite_vertices_begin(); v != m_cdt.finite_vertices_end(); ++v)
      if (!v->info().is_set())
      {
        const double b = CGAL::to_double(v->point().y()) / m_flat.apex_y;
        const double a = (CGAL::to_double(v->point().x()) - b * m_flat.apex_x) / m_flat.length;
        v->info().value = m_points.add_inside(m_face, {1 - a - b, a, b});
      }
  }

  // Directs the constrained edges as their pieces. A constraint through other points consists of several edges.
  void find_edges()
  {
    for (const Constraint& c : m_constraints)
    {
      auto v = m_cdt.vertices_in_constraint_begin(c.id);
      CGAL_assertion(*v == c.from);
      for (auto next = std::next(v); next != m_cdt.vertices_in_constraint_end(c.id); v = next, ++next)
        m_edges.push_back({id(*v), id(*next), c.level});
    }
  }

  Points& m_points;
  Arc_division<Piece> m_division;
  std::vector<std::vector<double>> m_chord_ends; // per piece of the face
  face_descriptor m_face;
  Flat_face m_flat;
  Triangulation m_cdt;
  std::map<Id, Vertex_handle> m_vertex_of;
  std::vector<Constraint> m_constraints;
  std::vector<std::pair<Vertex_handle, Flat_face::Weights>> m_inner; // points of arcs
  std::vector<Id> m_boundary;
  std::vector<std::array<Id, 3>> m_triangles;
  std::vector<Split_edge> m_edges;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
