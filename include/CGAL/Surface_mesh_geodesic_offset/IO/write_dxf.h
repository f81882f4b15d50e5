// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_DXF_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_DXF_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Dxf_document.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Plane_of_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>

#include <CGAL/number_type_config.h>

#include <cmath>
#include <cstddef>
#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Plane of an LWPOLYLINE. The format derives the axes from the normal; those of a horizontal plane are x and y.
inline Plane_axes axes_of_entity(const Plane_of_faces& plane)
{
  constexpr double rounding = Geodesic_offset::internal::Piece_in_space::same_curve;
  const Space_vector& n = plane.normal();
  Plane_axes axes;
  axes.normal = std::hypot(n.x(), n.y()) <= rounding ? Space_vector(0, 0, 1) : n;
  const bool is_near_z = std::abs(n.x()) < 1. / 64 && std::abs(n.y()) < 1. / 64;
  axes.x = cross_product(is_near_z ? Space_vector(0, 1, 0) : Space_vector(0, 0, 1), axes.normal);
  axes.x = axes.x / Geodesic_offset::internal::length(axes.x);
  axes.y = cross_product(axes.normal, axes.x);
  return axes;
}

template <class Curve>
Dxf_polyline flat_polyline(const Curve& curve, const Plane_of_faces& plane)
{
  Dxf_polyline p;
  p.axes = axes_of_entity(plane);
  p.elevation = p.axes.normal * plane.point();
  const auto add = [&p](const Plane_point& q, double bulge) {
    p.vertices.push_back({coordinates(q[0] * p.axes.x + q[1] * p.axes.y + p.elevation * p.axes.normal), bulge});
  };
  const std::vector<Plane_piece> pieces = p.axes.pieces(curve, 0);
  for (const Plane_piece& piece : pieces)
    for_each_part(piece, CGAL_PI * (1 + 1e-12), [&](const Plane_piece& part) { add(part.start, std::tan(part.sweep / 4)); });
  // every polyline has at least two vertices, however short the curve
  if (!curve.is_closed() || p.vertices.size() < 2) add(pieces.back().end, 0);
  return p;
}

// The entity of a curve that is not empty.
template <class Curve>
Dxf_polyline dxf_polyline(const Curve& curve, double chord_tolerance, std::size_t layer)
{
  const Plane_of_faces plane([&curve](const auto& f) { for_each_face(curve, f); });
  Dxf_polyline p;
  if (plane.is_exact()) p = flat_polyline(curve, plane);
  else
    for (const Coordinates& c : points_of(curve, chord_tolerance)) p.vertices.push_back({c, 0});
  p.is_flat = plane.is_exact();
  p.is_closed = curve.is_closed();
  p.layer = layer;
  if (p.is_closed && !p.is_flat) p.vertices.pop_back();
  return p;
}

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves as a DXF file (ASCII, AutoCAD 2000), in three dimensions.

Each curve is one entity, with the flag "closed" if the curve is closed.
- A curve that crosses faces of one plane only becomes an `LWPOLYLINE` with the segments and arcs of
  `Geodesic_offset_curve::elements()`, arcs as bulges: an arc is one bulge (or two, if it is longer than a half turn) however many
  faces it crosses. In a horizontal plane the coordinates are x and y, and the elevation is z, whether the normals of the faces
  point up or down. Other planes have an extrusion direction, and coordinates in the axes that the format defines for it.
- Any other curve becomes a 3D `POLYLINE` with few points, see `Geodesic_offset_curve::points()`.

Faces lie in one plane if the distances of their corners from it are rounding: at most 1e-9 of the extent of the faces plus 1e-12
of the largest coordinate. There is one layer per distance, named `offset_` and the distance. One unit of the file is one unit of
the mesh.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{chord_tolerance}
    \cgalParamDescription{the largest distance of a 3D polyline from its curve, in the units of the mesh's points}
    \cgalParamType{a number type, convertible to `double`; positive}
    \cgalParamDefault{that of `write_offset_curves()`}
  \cgalParamNEnd
  \cgalParamNBegin{length_unit}
    \cgalParamDescription{the unit of the mesh, for `$INSUNITS`; without one, the file is unitless}
    \cgalParamType{`IO::Length_unit`}
    \cgalParamDefault{`IO::Length_unit::NONE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument unless `chord_tolerance > 0`; then nothing has been written
\throws std::length_error as `Geodesic_offset_curve::points()`; then nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_DXF(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  const double chord_tolerance = internal::chord_tolerance_of<Geodesic_offset::internal::Drawing_parameters>(curves, np);
  const Length_unit unit = internal::length_unit_of<Geodesic_offset::internal::Drawing_parameters>(np);
  internal::check_numbers_of_points(curves, chord_tolerance); // before any output
  std::vector<std::string> layers;
  std::map<std::string, std::size_t> layer_of;
  std::vector<internal::Dxf_polyline> polylines;
  for (const auto& curve : curves)
  {
    if (curve.number_of_pieces() == 0) continue;
    const std::string name = "offset_" + internal::short_number(CGAL::to_double(curve.distance()));
    const auto layer = layer_of.emplace(name, layers.size());
    if (layer.second) layers.push_back(name);
    polylines.push_back(internal::dxf_polyline(curve, chord_tolerance, layer.first->second));
  }

  Bbox_3 box;
  for (const auto& polyline : polylines)
    for (const auto& vertex : polyline.vertices) box += internal::bbox(vertex.point);
  if (polylines.empty()) box = Bbox_3(0, 0, 0, 0, 0, 0);

  const internal::Full_precision precision(os);
  internal::Dxf_document(os).write(layers, polylines, box, unit);
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif
