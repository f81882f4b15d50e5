// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distances near sources: the length of the traced path, which has smaller rounding errors there than distances by windows.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_NEAR_PATH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PATHS_NEAR_PATH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_elements.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_tracing.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Output of Path_tracing that sums up the lengths of the pieces of a path. Each piece is measured in a face that contains both
// of its ends.
template <class FT>
class Path_measurement
{
public:
  typedef Path_crossing<FT> Item;

  explicit Path_measurement(const Unfolded_mesh<FT>& mesh) : m_mesh(mesh) {}

  void start(const Surface_point<FT>& p) { m_last = p; }
  Passed_crossings<FT>& passed() { return m_passed; }
  void end_part(const Suffix_end<FT>&) {}

  void append(const Item* q, const Item* last, const Suffix_end<FT>& end)
  {
    for (; q != last; ++q)
      go_to(q->halfedge == no_index ? Surface_point<FT>::at_vertex(q->source)
                                    : Surface_point<FT>::on_edge(q->halfedge, q->part * m_mesh[q->halfedge].length));
    go_to(end.point);
  }

  // Infinity if two consecutive points have no face in common.
  const FT& length() const { return m_length; }
  std::size_t number_of_pieces() const { return m_pieces; }

private:
  void go_to(const Surface_point<FT>& p)
  {
    FT piece = Number_policy<FT>::infinity();
    for (const Index face : faces_of(m_mesh, m_last))
    {
      Point_in_face<FT> from, to;
      unsigned edges;
      if (position_in_face(m_mesh, m_last, face, from, edges) && position_in_face(m_mesh, p, face, to, edges))
        piece = (std::min)(piece, internal::length(to - from));
    }
    m_length += piece;
    ++m_pieces;
    m_last = p;
  }

  const Unfolded_mesh<FT>& m_mesh;
  Passed_crossings<FT> m_passed;
  Surface_point<FT> m_last;
  FT m_length = FT(0);
  std::size_t m_pieces = 0;
};

// The distance of a point and the start of its path. Both are those of Path_start_query, except near a source, where the
// distance is the length of the traced path. A window that Lower_envelope::close_gap() has extended beyond its rays gives
// distances that are too small by up to an allowance relative to the edges. Far from the source, the allowance is rounding of
// the distance; near the source, it is more. Vertices are measured once, after the build. The windows share the unmeasured
// distances of vertices, so the field keeps both.
template <class FT>
class Near_path
{
public:
  // `measures`: false if windows were merged within a tolerance; then paths cannot be traced.
  Near_path(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field, bool measures)
    : m_mesh(mesh), m_initial(initial), m_field(field), m_measures(measures)
  {
  }

  // `suffixes`: the cache of path suffixes of this field.
  template <class Suffix_cache>
  FT distance(const Located_point<FT>& p, Suffix_cache& suffixes) const;

  template <class Suffix_cache>
  Path_start<FT> operator()(const Located_point<FT>& p, Suffix_cache& suffixes) const;

  // Sets the distances by path length of the vertices near sources for which it differs from the distance by windows by more than
  // rounding: of some vertices (null: of all) not farther than `maximum`, whose nearest primitive is `first` or later.
  void measure_vertices(const std::vector<Index>* vertices, Index first, const FT& maximum, std::map<Index, FT>& result) const
  {
    if constexpr (Number_policy<FT>::is_inexact)
    {
      if (!m_measures) return;
      const Path_start_query<FT> starts(m_mesh, m_initial, m_field);
      const No_suffix_cache<FT> no_suffixes{};
      const FT limit = (std::min)(maximum, FT(m_field.start_values.largest() + FT(near_part) * m_mesh.longest_edge()));
      const auto measure_vertex = [&](Index v) {
        if (!(m_field.distance[v] <= limit) || m_field.source_ref[v].primitive() < first) return;
        if (first > 0) result.erase(v);
        const auto p = Surface_point<FT>::at_vertex(v);
        Path_start<FT> start = starts.at_vertex(v);
        if (start.halfedge == no_index || !is_near(p, start.length())) return;
        measure(p, no_suffixes, start);
        if (start.is_measured) result.emplace_hint(result.end(), v, start.distance);
      };
      if (vertices != nullptr) std::for_each(vertices->begin(), vertices->end(), measure_vertex);
      else
        for (Index v = 0; v < m_mesh.number_of_vertices(); ++v) measure_vertex(v);
    }
  }

private:
  template <class Suffix_cache>
  BOOST_NOINLINE Path_start<FT> measured(const Located_point<FT>& p, Suffix_cache& suffixes) const
  {
    return (*this)(p, suffixes);
  }

  // Largest length of a measured path, as a part of the longest edge. The allowance of windows, 256 units of rounding of an
  // edge, is less than 1e-12 of a distance of 1/16 of that edge. Twice this part also covers an edge of an adjacent face.
  static constexpr double near_part = 1. / 8;

  // `length`: of the path from p.
  bool is_near(const Surface_point<FT>& p, const FT& length) const
  {
    if constexpr (!Number_policy<FT>::is_inexact) return (void)p, (void)length, false;
    return length <= FT(near_part) * m_mesh.longest_edge() && length <= FT(near_part) * extent(p) && m_measures;
  }

  // Longest edge of the faces that contain a point.
  FT extent(const Surface_point<FT>& p) const
  {
    const auto of_face = [&](Index f) {
      return (std::max)({m_mesh[3 * f].length, m_mesh[3 * f + 1].length, m_mesh[3 * f + 2].length});
    };
    if (p.kind == Surface_point<FT>::FACE) return of_face(p.element);
    FT size = FT(0);
    for (const Index f : faces_of(m_mesh, p)) size = (std::max)(size, of_face(f));
    return size;
  }

  template <class Suffix_cache>
  BOOST_NOINLINE void measure(const Surface_point<FT>& p, Suffix_cache& suffixes, Path_start<FT>& start) const
  {
    Path_measurement<FT> path(m_mesh);
    Path_start<FT> bypass;
    const bool is_vertex = p.kind == Surface_point<FT>::VERTEX; // the direction of its path is that of the build
    Path_tracing<FT>(m_mesh, m_initial, m_field)(p, start, suffixes, path, is_vertex ? nullptr : &bypass);
    // A path whose length differs by more than rounding gives no distance. The limit is twice the allowance of windows plus 4
    // units per change of the frame: a coordinate has two products and two sums, and frames are as exact as apexes.
    const FT allowance =
      Number_policy<FT>::rounding(512 + 4. * double(path.number_of_pieces())) * (start.distance + m_mesh.longest_edge());
    const FT error = CGAL::abs(path.length() - start.length());
    if (!(error <= allowance)) return;
    if (bypass.halfedge != no_index)
    {
      start.to = bypass.to;
      start.direction = bypass.direction;
    }
    if (error <= Number_policy<FT>::rounding(4) * start.distance) return; // no better
    const std::vector<Index> faces = faces_of(m_mesh, p);
    const bool is_on_source =
      !is_vertex && std::any_of(faces.begin(), faces.end(), [&](Index f) { return path.length() <= size_of_point(m_mesh, f); });
    set_distance(start.start_value + (is_on_source ? FT(0) : path.length()), start);
  }

  static void set_distance(const FT& distance, Path_start<FT>& start)
  {
    if (distance == start.distance) return;
    start.is_measured = true;
    start.distance_of_windows = start.distance;
    start.distance = distance;
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  const bool m_measures;
};

template <class FT>
template <class Suffix_cache>
FT Near_path<FT>::distance(const Located_point<FT>& p, Suffix_cache& suffixes) const
{
  if (p.kind == Surface_point<FT>::VERTEX) return m_field.distance_of_path(p.element);
  const FT d = Path_start_query<FT>(m_mesh, m_initial, m_field).distance(p);
  return d > FT(0) && is_near(p, FT(d - m_field.start_values.largest())) ? measured(p, suffixes).distance : d;
}

template <class FT>
template <class Suffix_cache>
Path_start<FT> Near_path<FT>::operator()(const Located_point<FT>& p, Suffix_cache& suffixes) const
{
  Path_start<FT> start = Path_start_query<FT>(m_mesh, m_initial, m_field)(p);
  if (p.kind == Surface_point<FT>::VERTEX) set_distance(m_field.distance_of_path(p.element), start);
  else if (!start.is_at_source() && is_near(p, start.length()) && start.halfedge != no_index) measure(p, suffixes, start);
  return start;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
