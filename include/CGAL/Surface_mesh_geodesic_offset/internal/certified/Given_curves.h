// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The curves of an Offset_certification, as pieces in faces, with a check that pieces meet and that curves end properly.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_GIVEN_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_GIVEN_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_certificate.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Curve_region.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Face_piece.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// All lengths are in units of the certified mesh. Curves have the indices 0, 1, ... in the order of the calls.
class Given_curves
{
public:
  typedef Surface_point<double> Surface_point_;
  typedef Offset_certificate_limit Limit;

  // A point of a curve that belongs to no piece: a polyline of one point, or a repeated point.
  struct Single_point
  {
    Index face;
    Double_double_2 place;
    std::size_t curve;
  };

  // The first reason why the curves are refused, with a point; `limit` is NONE if there is no reason.
  struct Refusal
  {
    Limit limit = Limit::NONE;
    Index face = no_index;
    Double_double_2 place{};
    std::size_t curve = no_curve;
  };

  // `region`: only for the order of points and the border; it needs no pieces yet.
  Given_curves(const Certified_mesh& mesh, const Certified_sources& sources, const Curve_region& region)
    : m_mesh(mesh), m_sources(sources), m_region(region)
  {
  }

  // Adds a polyline. Returns false, with a refusal at the first point, if two consecutive points have no common face.
  bool add_polyline(const std::vector<Surface_point_>& given, bool is_closed)
  {
    const std::size_t curve = size++, n = given.size();
    if (n == 1) add_segment(given[0], given[0], curve);
    for (std::size_t i = 0; i + (is_closed ? 0 : 1) < n; ++i)
      if (!add_segment(given[i], given[(i + 1) % n], curve)) return refuse(Limit::NOT_JOINED, given[i], curve);
    if (!is_closed && n > 0) m_ends.insert(m_ends.end(), {{given.front(), curve}, {given.back(), curve}});
    return true;
  }

  // Adds an offset curve. Gaps between pieces are at most `joint_tolerance`. Returns false, with a refusal, if consecutive pieces do not meet or a piece is not in its face.
  bool add_pieces(const std::vector<Offset_curve_piece>& given, bool is_closed)
  {
    const std::size_t curve = size++, n = given.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Surface_point_& from = i > 0 ? given[i - 1].to : is_closed ? given[n - 1].to : given[0].from;
      if (!add_piece(given[i], from, curve)) return refuse(Limit::NOT_JOINED, given[i].from, curve);
    }
    if (!is_closed && n > 0) m_ends.insert(m_ends.end(), {{given.front().from, curve}, {given.back().to, curve}});
    return true;
  }

  // Checks the ends of open curves: an even number at each point that is not on the border. Returns false after a refusal.
  bool check_ends()
  {
    if (refusal.limit != Limit::NONE) return false;
    const auto less = [&](const auto& a, const auto& b) { return m_region.key(a.first) < m_region.key(b.first); };
    std::stable_sort(m_ends.begin(), m_ends.end(), less);
    for (std::size_t i = 0, next; i < m_ends.size(); i = next)
    {
      for (next = i + 1; next < m_ends.size() && !less(m_ends[i], m_ends[next]); ++next) {}
      if ((next - i) % 2 == 1 && !m_region.is_on_border(m_ends[i].first))
        return refuse(Limit::OPEN_END, m_ends[i].first, m_ends[i].second);
    }
    return true;
  }

  std::size_t size = 0; // number of curves
  std::vector<Curve_piece> pieces;
  std::vector<Single_point> points;
  Refusal refusal;

  // The longest edge is between 1 and 2. Joints of the package's offsets have errors of up to 2^-44 of the perimeter of the
  // face plus the distance (measured in test_certified_offsets; 99% are below 2^-52), so they may exceed this bound at
  // distances above 2^14 edges. Other pieces with larger gaps were not joined.
  static constexpr double joint_tolerance = 0x1p-30;

private:
  bool add_segment(const Surface_point_& from, const Surface_point_& to, std::size_t curve)
  {
    for (Index face : faces_of(m_mesh.unfolded(), from))
    {
      Double_double_2 p, q;
      unsigned p_edges, q_edges;
      if (!m_sources.place_in_face(from, face, p, p_edges) || !m_sources.place_in_face(to, face, q, q_edges)) continue;
      if (m_region.key(from) == m_region.key(to))
      {
        points.push_back({face, p, curve});
        return true;
      }
      const int edge = (p_edges & q_edges) ? edge_of_bit(p_edges & q_edges) : -1;
      pieces.push_back({face, from, to, Face_piece::segment(p, q), p, q, 0., curve, edge});
      return true;
    }
    return false;
  }

  bool add_piece(const Offset_curve_piece& given, const Surface_point_& from, std::size_t curve)
  {
    Double_double_2 p, q;
    unsigned p_edges, q_edges;
    if (!m_sources.place_in_face(from, given.face, p, p_edges) || !m_sources.place_in_face(given.to, given.face, q, q_edges))
      return false;
    // not along an edge: a straight piece of the size of rounding from a vertex to itself
    const bool is_along_edge = !(given.radius > 0) && (p_edges & q_edges) && m_region.key(from) != m_region.key(given.to);
    const auto point = [](const Point_in_face<double>& x) { return Double_double_2{Double_double(x.x), Double_double(x.y)}; };
    const Double_double_2 start = point(given.start), end = point(given.end);
    const Face_piece piece =
      given.radius > 0 ? Face_piece::arc(start, end, point(given.center), given.radius) : Face_piece::segment(start, end);
    double moved = (std::max)(length(difference(p, start)), length(difference(q, end)));
    moved = (std::max)({moved, piece.off_circle(), outside(piece, given.face)});
    if (!(moved <= joint_tolerance)) return false;
    pieces.push_back({given.face, from, given.to, piece, p, q, moved, curve,
                      is_along_edge ? edge_of_bit(p_edges & q_edges) : -1});
    return true;
  }

  // How far a piece is outside of its face.
  double outside(const Face_piece& piece, Index face) const
  {
    double result = 0;
    Face_piece f = piece;
    for (Index k = 0; k < 3; ++k)
    {
      result = (std::max)(result, -f.products_with({0., 1.}).first);
      f = f.in_next_frame(m_mesh, 3 * face + k);
    }
    return result;
  }

  bool refuse(Limit limit, const Surface_point_& p, std::size_t curve)
  {
    if (refusal.limit != Limit::NONE) return false;
    const std::vector<Index> faces = faces_of(m_mesh.unfolded(), p);
    refusal = {limit, faces.empty() ? no_index : faces.front(), Double_double_2{}, curve};
    unsigned edges;
    if (!faces.empty()) m_sources.place_in_face(p, faces.front(), refusal.place, edges);
    return false;
  }

  const Certified_mesh& m_mesh;
  const Certified_sources& m_sources;
  const Curve_region& m_region;
  std::vector<std::pair<Surface_point_, std::size_t>> m_ends; // of open curves, with the curve
};

} // namespace CGAL::Geodesic_offset::internal

#endif
