// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Traversal of offset curves. Checks that pieces are joined, that their points are on the level, and that distances
// decrease to the left; records crossings with edges. Time: for each piece, the number of windows of its face.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_CURVE_VALIDATION_H
#define GEODESIC_OFFSET_TEST_VALIDATION_CURVE_VALIDATION_H

#include "Validation_level.h"
#include "Validation_report.h"

#include <string>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

template <class Geodesic>
class Curve_validation
{
public:
  typedef Validation_surface<Geodesic> Surface;
  typedef typename Geodesic::Offset_curve Offset_curve;
  typedef typename Offset_curve::Piece Piece;
  typedef Validation_face::Point Point;
  typedef Validation_face::Weights Weights;

  Curve_validation(const Surface& surface, const Validation_options& options, Validation_report& report)
    : m_surface(surface), m_options(options), m_report(report)
  {
  }

  // Adds the pieces, gates and crossings of the curve to `level`.
  void operator()(const Offset_curve& curve, Validation_level& level) const
  {
    const std::size_t n = curve.number_of_pieces();
    if (!m_report.check(CLOSEDNESS, n > 0, [] { return std::string("a curve without pieces"); })) return;
    ++m_report.curves;
    m_report.closed_curves += std::size_t(curve.is_closed());
    m_report.pieces += n;
    const std::size_t number = level.curves++;
    bool is_in_one_face = curve.is_closed();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Piece piece = curve.piece(i);
      const Validation_piece plane(piece, m_surface.index_of(piece.face()), number, level.number);
      check_points(piece, plane, level, !curve.is_closed() && i + 1 == n);
      check_orientation(plane, level);
      level.pieces.push_back(plane);
      is_in_one_face = is_in_one_face && piece.face() == curve.piece(0).face();
      if (i + 1 < n) check_joint(piece, curve.piece(i + 1), level);
    }
    if (curve.is_closed()) check_joint(curve.piece(n - 1), curve.piece(0), level);
    else
    {
      check_end(curve.piece(0), true, level);
      check_end(curve.piece(n - 1), false, level);
    }
    if (is_in_one_face) level.loops.push_back(level.pieces.back().face);
  }

private:
  typedef std::pair<Index, Weights> Location;

  Location plain(const typename Geodesic::Face_location& l) const
  {
    Location result;
    result.first = m_surface.index_of(l.first);
    for (std::size_t k = 0; k < 3; ++k) result.second[k] = CGAL::to_double(l.second[k]);
    return result;
  }

  std::string where(Index face) const { return " in face " + std::to_string(face); }

  // Checks that points are in the face and at the level, that both end points of a piece agree with their locations, and
  // that they are on the circle or line of the piece.
  void check_points(const Piece& piece, const Validation_piece& plane, const Validation_level& level, bool is_last) const
  {
    const Validation_face face = m_surface.face_at(plane.face);
    const double tolerance = m_options.level_tolerance * m_surface.diagonal();
    for (const bool at_start : {true, false})
    {
      const Location l = plain(at_start ? piece.start() : piece.end());
      const double off = length(face.point(l.second) - (at_start ? plane.start : plane.end));
      m_report.check(CLOSEDNESS, l.first == plane.face && off <= tolerance,
                     [&] { return "an end's location is " + validation_text(off) + " from its point" + where(plane.face); });
      const double off_circle = plane.off(at_start ? plane.start : plane.end);
      m_report.check(ON_LEVEL, off_circle <= tolerance, [&] {
        return "an end is " + validation_text(off_circle) + " off its circle or line" + where(plane.face);
      });
    }
    const std::size_t n =
      plane.chord() <= tolerance ? 1 : (std::max)(std::size_t(4), piece.number_of_chords(1e-5 * m_surface.diagonal()));
    for (std::size_t i = 0; i < n + (is_last ? 1 : 0); ++i)
    {
      const Location l = plain(piece.location(double(i) / double(n)));
      const double outside = face.outside(face.point(l.second));
      if (!m_report.check(ON_LEVEL, outside <= tolerance, [&] {
            return "a point is " + validation_text(outside) + " outside of its face" + where(plane.face);
          }))
        continue;
      const double off = std::abs(m_surface.distance_at(plane.face, l.second) - level.cut);
      ++m_report.points;
      m_report.worst_off_level = (std::max)(m_report.worst_off_level, off / m_surface.diagonal());
      m_report.check(ON_LEVEL, off <= tolerance, [&] {
        return "a point is off its level by " + validation_text(off / m_surface.diagonal()) + " diagonals" + where(plane.face);
      });
    }
  }

  // On the left of the piece, shortest paths run straight towards its center, so the distance decreases at unit rate.
  void check_orientation(const Validation_piece& plane, const Validation_level& level) const
  {
    const double tolerance = m_options.level_tolerance * m_surface.diagonal();
    if (!(plane.chord() > 4 * tolerance)) return;
    m_report.check(ORIENTATION, plane.runs_forward(), [&] { return "a piece runs backwards" + where(plane.face); });
    const Validation_face face = m_surface.face_at(plane.face);
    const Point m = plane.middle(), left = plane.left_at(m);
    double way = face.exit_distance(m, left);
    if (!plane.is_straight) way = (std::min)(way, plane.radius);
    way = (std::min)(way, level.cut) / 2;
    if (!(way > 4 * tolerance) || face.outside(m) > tolerance) return;
    ++m_report.oriented_pieces;
    const double d = m_surface.distance_at(face, m + way * left);
    m_report.check(ORIENTATION, std::abs(level.cut - way - d) <= tolerance, [&] {
      return validation_text(way) + " left of a piece the distance is smaller by " + validation_text(level.cut - d) +
             where(plane.face);
    });
  }

  void check_joint(const Piece& a, const Piece& b, Validation_level& level) const
  {
    const Location end = plain(a.end()), start = plain(b.start());
    const double gap = Surface::distance(m_surface.point(end.first, end.second), m_surface.point(start.first, start.second)) /
                       m_surface.diagonal();
    m_report.worst_joint = (std::max)(m_report.worst_joint, gap);
    m_report.check(CLOSEDNESS, gap <= m_options.joint_tolerance, [&] {
      return "pieces are " + validation_text(gap) + " diagonals apart, from face " + std::to_string(end.first) + " to " +
             std::to_string(start.first);
    });
    if (end.first == start.first) return;
    Index h = no_index;
    for (Index k = 0; k < 3; ++k)
    { // coordinate k + 2 is zero on halfedge k
      const Index g = m_surface.twin(3 * end.first + k);
      if (end.second[(k + 2) % 3] == 0 && g != no_index && g / 3 == start.first && start.second[(g % 3 + 2) % 3] == 0)
        h = 3 * end.first + k;
    }
    if (!m_report.check(CLOSEDNESS, h != no_index, [&] {
          return "pieces join over no edge, from face " + std::to_string(end.first) + " to " + std::to_string(start.first);
        }))
      return;
    const Index g = m_surface.twin(h);
    level.add_crossing(m_surface, h, end.second[(h + 1) % 3], false);
    level.add_gate(h, end.second[(h + 1) % 3], false);
    level.add_gate(g, start.second[(g + 1) % 3], true);
  }

  // Checks an end of an open curve.
  void check_end(const Piece& piece, bool is_start, Validation_level& level) const
  {
    const Location l = plain(is_start ? piece.start() : piece.end());
    Index h = no_index;
    for (Index k = 0; k < 3; ++k)
    { // at a corner with two border edges, the curve cuts off a farthest point: it starts before it and ends behind it
      const bool is_far_end = l.second[is_start ? k : (k + 1) % 3] == 1;
      if (l.second[(k + 2) % 3] == 0 && m_surface.twin(3 * l.first + k) == no_index && (h == no_index || !is_far_end))
        h = 3 * l.first + k;
    }
    if (!m_report.check(CLOSEDNESS, h != no_index, [&] { return "an open curve ends inside the surface" + where(l.first); }))
      return;
    level.add_crossing(m_surface, h, l.second[(h + 1) % 3], is_start);
    level.add_gate(h, l.second[(h + 1) % 3], is_start);
  }

  const Surface& m_surface;
  const Validation_options& m_options;
  Validation_report& m_report;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_CURVE_VALIDATION_H
