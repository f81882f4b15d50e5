// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_VTK_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>

#include <cstddef>
#include <ostream>
#include <utility>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

struct Vtk_line
{
  std::vector<Coordinates> points;
  std::vector<std::size_t> sources; // source of each point
  std::vector<int> sides;
  double distance;
  bool is_closed;
};

template <class Curve, class FT>
Vtk_line vtk_line(const Curve& curve, const FT& chord_tolerance)
{
  Vtk_line line;
  // each segment belongs to one source and one side
  const auto is_change = [&](std::size_t i) {
    const std::size_t next = i + 1 < curve.number_of_pieces() ? i + 1 : curve.is_closed() ? 0 : i;
    return curve.piece(i).source() != curve.piece(next).source() || curve.piece(i).side() != curve.piece(next).side();
  };
  Discretized_curve discrete = discretized(curve, chord_tolerance, is_change);
  line.points = std::move(discrete.points);
  line.is_closed = curve.is_closed() && !line.points.empty();
  if (line.is_closed) line.points.pop_back();
  for (std::size_t i = 0; i < line.points.size(); ++i)
  {
    const typename Curve::Piece piece = curve.piece(discrete.pieces[i]);
    line.sources.push_back(piece.source());
    line.sides.push_back(int(piece.side()));
  }
  line.distance = CGAL::to_double(curve.distance());
  return line;
}

// The common value of all points; -1 if they differ.
template <class Number>
long long common_value(const std::vector<Number>& values)
{
  for (const Number& x : values)
    if (x != values.front()) return -1;
  return values.empty() ? -1 : static_cast<long long>(values.front());
}

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves as lines of a legacy VTK file (ASCII, polydata), for ParaView and other users of VTK.

Each curve is one line. A closed line ends with the index of its first point. The arrays are
- for lines: `distance`, `closed` (1 or 0), `source` (the id of the source), and `side` (0 none, 1 left, 2 right, 3 cap,
  as in `Source_side`). The last two are -1 if a curve belongs to several sources or sides;
- for points: `source` and `side`. A point between two pieces has the values of the first piece. Independent of the
  tolerance, all points where these values change are points of the line, so each segment of a line belongs to one source
  and one side: those of its end point.

`distance` is the active array. The arrays for lines serve to select curves, for instance by a threshold, those for points
to colour the curves.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param chord_tolerance the largest distance of a line from its curve; positive
\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance > 0`; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()`; then nothing has been written
*/
template <class OffsetCurveRange, class FT>
bool write_offset_VTK(std::ostream& os, const OffsetCurveRange& curves, const FT& chord_tolerance)
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  Geodesic_offset::internal::check_all_numbers_of_chords(curves, chord_tolerance); // before any output
  const internal::Full_precision precision(os);

  // the total number of points precedes the points
  std::vector<internal::Vtk_line> lines;
  std::size_t number_of_points = 0, number_of_indices = 0;
  for (const auto& curve : curves)
  {
    lines.push_back(internal::vtk_line(curve, chord_tolerance));
    number_of_points += lines.back().points.size();
    number_of_indices += lines.back().points.size() + (lines.back().is_closed ? 1 : 0);
  }

  os << "# vtk DataFile Version 3.0\ngeodesic offsets\nASCII\nDATASET POLYDATA\nPOINTS " << number_of_points << " double\n";
  for (const auto& line : lines)
    for (const auto& p : line.points)
    {
      internal::write_coordinates(os, p);
      os << '\n';
    }
  if (lines.empty()) return os.good();

  os << "LINES " << lines.size() << ' ' << lines.size() + number_of_indices << '\n';
  std::size_t first = 0;
  for (const auto& line : lines)
  {
    const std::size_t n = line.points.size();
    os << n + (line.is_closed ? 1 : 0);
    for (std::size_t i = 0; i < n; ++i) os << ' ' << first + i;
    if (line.is_closed) os << ' ' << first;
    os << '\n';
    first += n;
  }

  // readers load only the first of several scalars by default, but all fields
  os << "CELL_DATA " << lines.size() << "\nSCALARS distance double 1\nLOOKUP_TABLE default\n";
  for (const auto& line : lines) os << line.distance << '\n';
  os << "FIELD curves 3\nclosed 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << (line.is_closed ? 1 : 0) << '\n';
  os << "source 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << internal::common_value(line.sources) << '\n';
  os << "side 1 " << lines.size() << " int\n";
  for (const auto& line : lines) os << internal::common_value(line.sides) << '\n';

  os << "POINT_DATA " << number_of_points << "\nFIELD points 2\nsource 1 " << number_of_points << " int\n";
  for (const auto& line : lines)
    for (std::size_t source : line.sources) os << source << '\n';
  os << "side 1 " << number_of_points << " int\n";
  for (const auto& line : lines)
    for (int side : line.sides) os << side << '\n';
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif
