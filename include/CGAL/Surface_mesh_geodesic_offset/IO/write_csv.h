// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_CSV_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_CSV_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Curve_line.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <cstddef>
#include <ostream>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Writes ranges of curves one after the other into one file.
class Csv_lines
{
public:
  static void begin(std::ostream& os, const Point_options& options)
  {
    os << "curve,distance,source,side,x,y,z,nx,ny,nz,face,b0,b1,b2,tx,ty,tz"
       << (options.places.empty() ? "\n" : ",parent,inner_side\n");
  }

  template <class OffsetCurveRange>
  void add(std::ostream& os, const OffsetCurveRange& curves, const Point_options& options)
  {
    const Full_precision precision(os);
    for (const auto& curve : curves)
    {
      const Curve_line line = curve_line(curve, options);
      for (std::size_t k = 0; k < line.number_of_indices(); ++k)
      {
        const Line_point& p = line.points[line.index(k)];
        const auto write = [&os](const Coordinates& c) { os << ',' << c[0] << ',' << c[1] << ',' << c[2]; };
        os << m_curve << ',' << line.distance << ',' << p.source << ',' << p.side;
        write(p.point);
        write(p.normal);
        os << ',' << p.face;
        write(p.weights);
        write(p.tangent);
        if (!options.places.empty()) os << ',' << options.places[m_curve].parent << ',' << options.places[m_curve].inner_side;
        os << '\n';
      }
      ++m_curve;
    }
  }

  static void end(std::ostream&) {}

private:
  std::size_t m_curve = 0;
};

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes the points of offset curves as a table of comma-separated values with a line of names, for spreadsheets and scripts.

Each row is a point of a curve, in order. The columns are
- `curve`: the index of the curve, from 0; a closed curve repeats its first point;
- `distance`: that of the curve;
- `source` (the id of the source) and `side` (0 none, 1 left, 2 right, 3 cap, as in `Source_side`) at the point. A point between
  two pieces has the values of the first piece; each segment of a curve belongs to one source and one side: those of its end point;
- `x`, `y`, `z`: the point;
- `nx`, `ny`, `nz`: the outer unit normal of the face of the point, or the smooth normal; at a point between two pieces, that of the
  first piece;
- `face`, `b0`, `b1`, `b2`: the index of the face of the first piece, `Geodesic_offset_piece::face_index()`, and the barycentric
  coordinates of the point with respect to its vertices, in the order of `vertices_around_face(halfedge(face, tm), tm)`: for
  `Surface_mesh`, that in which the face was added;
- `tx`, `ty`, `tz`: the unit vector in the direction of travel, at the end of the first piece;
- with `curve_nesting` only, `parent` and `inner_side`: those of the curve.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a polyline from its curve, in the units of the mesh's points}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{that of `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{point_spacing}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{smooth_normals}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{curve_nesting}
    \cgalParamDescription{as in `write_offset_curves()`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance` and `point_spacing` are positive; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()` and `points_at_spacing()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_CSV(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  return Surface_mesh_geodesic_offset_internal::write_lines<Surface_mesh_geodesic_offset_internal::Csv_lines>(
    os, curves,
    Surface_mesh_geodesic_offset_internal::point_options_of<Geodesic_offset::internal::Table_parameters>(curves, np));
}

} // namespace IO
} // namespace CGAL

#endif
