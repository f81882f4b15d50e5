// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The inner side of a closed polyline: the one with the smaller area, or the only one if the polyline runs along the border.
// The field of the polyline alone decides: if the polyline divides the surface, every shortest path to it stays on one side.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_INNER_SIDE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Border_polyline.h>

#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Inner_side
{
public:
  typedef typename Traits::FT FT;

  // `polyline`: a set with this source only. Propagates over the whole surface.
  Inner_side(const Unfolded_mesh<FT>& mesh, const Traits& traits, const Source_set<FT>& polyline)
    : m_mesh(mesh), m_build(mesh, polyline, {Number_policy<FT>::infinity(), true, {}, {}})
  {
    m_build.template propagate<Sequential_tag, Geodesic_build<Traits>::parts_for(KEPT_WINDOWS)>(traits);
    Face_field<FT> field(mesh, m_build.initial, m_build.field);
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
      if (mesh.source(3 * f) != no_index && !add_whole(f))
      {
        field.set_face(f);
        add_parts(field);
      }
  }

  // True if the polyline divides its part of the surface.
  bool divides() const { return m_divides; }

  Source_side operator()() const
  {
    const bool right_is_smaller = area(Source_side::RIGHT) < area(Source_side::LEFT);
    const bool has_one_side = Border_polyline<FT>(m_mesh, m_build.initial)();
    return right_is_smaller != has_one_side ? Source_side::RIGHT : Source_side::LEFT;
  }

private:
  static constexpr int n = 16; // parts of an edge

  const FT& area(Source_side s) const { return m_area[int(s)]; }

  static bool are_opposite(Source_side a, Source_side b)
  {
    return (a == Source_side::LEFT && b == Source_side::RIGHT) || (a == Source_side::RIGHT && b == Source_side::LEFT);
  }

  // Adds a face. If the polyline is farther away than the edges are long, the whole face lies on one side, if there are sides.
  bool add_whole(Index f)
  {
    FT longest(0), nearest = Number_policy<FT>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      longest = (std::max)(longest, m_mesh[h].length);
      nearest = (std::min)(nearest, m_build.field.distance[m_mesh.source(h)]);
    }
    if (!(nearest > longest)) return false;
    if (!Number_policy<FT>::is_finite(nearest)) return true;
    const auto side = [&](int k) { return m_build.field.source_ref[m_mesh.source(3 * f + Index(k))].side(); };
    for (int k = 0; k < 3; ++k)
      if (are_opposite(side(k), side((k + 1) % 3))) m_divides = false;
    m_area[int(side(0))] += m_mesh[3 * f].length * m_mesh[3 * f].apex_y / FT(2);
    return true;
  }

  // Adds a face near the polyline, by small triangles. If two neighbours are on different sides, and the polyline is farther
  // away than they are from each other, a path leads from one side to the other.
  void add_parts(const Face_field<FT>& field)
  {
    typedef Point_in_face<FT> Point;
    const Face_frame<FT>& frame = field.frame();
    const Point u = FT(1. / n) * frame.corner(1), v = FT(1. / n) * frame.corner(2);
    const FT part = cross(u, v) / FT(2), step = length(u) + length(v) + length(u - v);
    const auto sample = [&](const Point& p, FT& distance) {
      std::size_t nearest;
      distance = field.distance(p, nearest);
      return Number_policy<FT>::is_finite(distance) ? field.windows()[nearest].source_ref.side() : Source_side::NONE;
    };
    // Beyond the edges, the sides are those of the vertices, which have one side for all their faces.
    for (int k = 0; k < 3; ++k)
    {
      const Index vertex = m_mesh.source(3 * field.face() + Index(k));
      FT distance;
      const Point center = FT(1. / 3) * (frame.corner(0) + frame.corner(1) + frame.corner(2));
      const Source_side side = sample(frame.corner(k) + FT(1. / n) * (center - frame.corner(k)), distance);
      if (m_build.field.distance[vertex] > step && distance > step &&
          are_opposite(m_build.field.source_ref[vertex].side(), side))
        m_divides = false;
    }
    Source_side below[n];
    FT below_distance[n];
    for (int j = 0; j < n; ++j)
    {
      Source_side left = Source_side::NONE;
      FT left_distance(0);
      for (int i = 0; i + j < n; ++i)
        for (const bool up : {true, false})
        {
          if (!up && i + j + 1 == n) continue;
          const FT shift(up ? 1. / 3 : 2. / 3);
          FT distance;
          const Source_side side = sample((FT(i) + shift) * u + (FT(j) + shift) * v, distance);
          m_area[int(side)] += part;
          if (left_distance > step && distance > step && are_opposite(left, side)) m_divides = false;
          if (up && j > 0 && below_distance[i] > step && distance > step && are_opposite(below[i], side)) m_divides = false;
          left = side;
          left_distance = distance;
          if (!up)
          { // read by the next row below its triangle i
            below[i] = side;
            below_distance[i] = distance;
          }
        }
    }
  }

  const Unfolded_mesh<FT>& m_mesh;
  Geodesic_build<Traits> m_build;
  FT m_area[4] = {FT(0), FT(0), FT(0), FT(0)}; // by side
  bool m_divides = true;
};

// Inner sides of all closed polylines. Throws if a polyline has no inside.
template <class Traits>
std::map<Index, Source_side> inner_sides(const Unfolded_mesh<typename Traits::FT>& mesh, const Traits& traits,
                                         const Source_set<typename Traits::FT>& sources)
{
  std::map<Index, Source_side> sides;
  sources.for_each_polyline([&](Index id, bool closed, const Source_set<typename Traits::FT>& alone) {
    if (!closed)
      throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                  " is an open polyline and has no inside");
    const Inner_side<Traits> inner(mesh, traits, alone);
    if (!inner.divides())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: source " + std::to_string(id) +
                                  " does not divide the surface into an inside and an outside");
    sides[id] = inner();
  });
  return sides;
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
