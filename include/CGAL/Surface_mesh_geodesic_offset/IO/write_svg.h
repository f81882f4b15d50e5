// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_SVG_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_IO_WRITE_SVG_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/IO/Length_unit.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/discretized_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/Plane_of_faces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/plane_pieces.h>
#include <CGAL/Surface_mesh_geodesic_offset/IO/internal/writing_parameters.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/number_type_config.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <ostream>
#include <vector>

namespace CGAL {
namespace IO {
namespace Surface_mesh_geodesic_offset_internal {

// Bounding rectangle of pieces, parallel to the axes.
class Plane_box
{
public:
  void add(const Plane_piece& piece)
  {
    add(piece.start);
    add(piece.end);
    if (!piece.is_arc()) return;
    // the extreme points of an arc are in the directions of the axes
    const double first = std::atan2(piece.start[1] - piece.center[1], piece.start[0] - piece.center[0]);
    const double low = (std::min)(first, first + piece.sweep), high = (std::max)(first, first + piece.sweep);
    for (double quarter = std::ceil(low / (CGAL_PI / 2)); quarter <= high / (CGAL_PI / 2); ++quarter)
    {
      const double a = quarter * (CGAL_PI / 2);
      add(moved(piece.center, piece.radius, {std::cos(a), std::sin(a)}));
    }
  }

  bool is_empty() const { return !(m_low[0] <= m_high[0]); }
  double low(std::size_t i) const { return m_low[i]; }
  double high(std::size_t i) const { return m_high[i]; }
  double size(std::size_t i) const { return m_high[i] - m_low[i]; }

private:
  void add(const Plane_point& p)
  {
    for (std::size_t i = 0; i < 2; ++i)
    {
      m_low[i] = (std::min)(m_low[i], p[i]);
      m_high[i] = (std::max)(m_high[i], p[i]);
    }
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  Plane_point m_low{infinity, infinity}, m_high{-infinity, -infinity};
};

struct Svg_path
{
  std::vector<Plane_piece> pieces;
  bool is_closed;
};

// The y axis of the format points down.
inline void write_path(std::ostream& os, const Svg_path& path)
{
  // an arc is given by its ends and radius, which is ill-conditioned near a half turn and ambiguous beyond
  constexpr double largest_sweep = 2 * CGAL_PI / 3;
  os << "<path d=\"M" << path.pieces.front().start[0] << ' ' << -path.pieces.front().start[1];
  for (const Plane_piece& piece : path.pieces)
    for_each_part(piece, largest_sweep * (1 + 1e-12), [&](const Plane_piece& part) {
      if (part.is_arc()) os << " A" << part.radius << ' ' << part.radius << " 0 0 " << (part.sweep > 0 ? 0 : 1) << ' ';
      else os << " L";
      os << part.end[0] << ' ' << -part.end[1];
    });
  os << (path.is_closed ? " Z\"/>\n" : "\"/>\n");
}

// Writes a length as an attribute; in millimeters for meters, which the format does not have.
inline void write_length(std::ostream& os, const char* attribute, double length, Length_unit unit)
{
  os << ' ' << attribute << "=\"" << (unit == Length_unit::METER ? 1000 * length : length)
     << (unit == Length_unit::INCH         ? "in"
         : unit == Length_unit::CENTIMETER ? "cm"
                                           : "mm")
     << '"';
}

} // namespace Surface_mesh_geodesic_offset_internal

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief returns whether a mesh lies in one plane, up to 1e-6 of its extent, so that `write_offset_SVG()` can write its offset
curves.

`write_offset_SVG()` checks curves again, relative to the extent of the faces that they cross. If coordinates are rounded to
fewer than about ten digits, it may reject a curve that crosses only a few small faces of a planar mesh. Curves of other
meshes can be written if all faces that they cross lie in one plane.

Takes linear time.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters a sequence of named parameters
\param tm the mesh; all its faces are triangles
\param np an optional sequence of named parameters among those listed below

\cgalNamedParamsBegin
  \cgalParamNBegin{vertex_point_map}
    \cgalParamDescription{the points of the vertices}
    \cgalParamType{a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value}
    \cgalParamDefault{`get(boost::vertex_point, tm)`}
  \cgalParamNEnd
\cgalNamedParamsEnd
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
bool can_write_offset_SVG(const TriangleMesh& tm, const NamedParameters& np = parameters::default_values())
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  Geodesic_offset::internal::check_named_parameters<Geodesic_offset::internal::Parameter_tags<internal_np::vertex_point_t>,
                                                    NamedParameters>();
  const auto points = parameters::choose_parameter(parameters::get_parameter(np, internal_np::vertex_point),
                                                   get_const_property_map(vertex_point, tm));
  const internal::Plane_of_faces plane([&](const auto& f) {
    for (const auto face : faces(tm))
    {
      const auto h = halfedge(face, tm);
      f(std::array<internal::Space_vector, 3>{internal::space_vector(get(points, source(h, tm))),
                                              internal::space_vector(get(points, target(h, tm))),
                                              internal::space_vector(get(points, target(next(h, tm), tm)))});
    }
  });
  return plane.contains_all();
}

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetIO

\brief writes offset curves that lie in one plane, such as those of a planar mesh, as an SVG file.

Each curve is a `path` of lines and true circular arcs, those of `Geodesic_offset_curve::elements()`: they are not divided where
they cross edges of the mesh. Closed
curves end with `Z`. There is one group `g` per distance, with the distance as its attribute `data-distance` and as its title.
One user unit is one unit of the mesh; the `viewBox` contains all curves and a margin.

The plane may have any position. A plane with a slope of less than 45 degrees is drawn as a map: from above, with the y axis
pointing up. So in a horizontal plane the coordinates of the paths are \f$ (x, -y) \f$, as the y axis of the format points
down. Other planes are drawn from the outside of the surface, with the z axis pointing up.

\tparam OffsetCurveRange a model of `ConstRange` with `Surface_mesh_geodesic_offset::Offset_curve` as value type
\param os the stream
\param curves the curves
\param np an optional named parameter

\cgalNamedParamsBegin
  \cgalParamNBegin{length_unit}
    \cgalParamDescription{the unit of the mesh. With a unit, the picture has a width and a height in this unit, or in millimeters
                          for meters; otherwise it fills the page or window that displays it.}
    \cgalParamType{`IO::Length_unit`}
    \cgalParamDefault{`IO::Length_unit::NONE`}
  \cgalParamNEnd
\cgalNamedParamsEnd

\return whether the stream is still good.
\throws std::invalid_argument if the faces that the curves cross do not lie in one plane, up to 1e-6 of their extent; then
        nothing has been written
*/
template <class OffsetCurveRange, class NamedParameters = parameters::Default_named_parameters>
bool write_offset_SVG(std::ostream& os, const OffsetCurveRange& curves,
                      const NamedParameters& np = parameters::default_values())
{
  namespace internal = Surface_mesh_geodesic_offset_internal;
  const Length_unit unit = internal::length_unit_of(np);
  const internal::Plane_of_faces plane = internal::plane_of_curves(curves);
  const internal::Plane_axes axes = plane.axes_of_drawing();
  std::map<double, std::vector<internal::Svg_path>> groups; // by distance
  internal::Plane_box box;
  for (const auto& curve : curves)
  {
    if (curve.number_of_pieces() == 0) continue;
    std::vector<internal::Svg_path>& paths = groups[CGAL::to_double(curve.distance())];
    paths.push_back({axes.pieces(curve, plane.tolerance()), curve.is_closed()});
    for (const internal::Plane_piece& piece : paths.back().pieces) box.add(piece);
  }

  const internal::Full_precision precision(os);
  const double size = box.is_empty() ? 1 : std::hypot(box.size(0), box.size(1));
  const double stroke = 0.002 * size, margin = 0.02 * size;
  const bool empty = box.is_empty();
  const double x = empty ? 0 : box.low(0) - margin, y = empty ? 0 : -box.high(1) - margin,
               width = empty ? 1 : box.size(0) + 2 * margin, height = empty ? 1 : box.size(1) + 2 * margin;
  os << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\"";
  if (unit != Length_unit::NONE)
  {
    internal::write_length(os, "width", width, unit);
    internal::write_length(os, "height", height, unit);
  }
  os << " viewBox=\"" << x << ' ' << y << ' ' << width << ' ' << height;
  os << "\">\n<title>geodesic offsets</title>\n<g fill=\"none\" stroke=\"black\" stroke-width=\"" << stroke
     << "\" stroke-linejoin=\"round\">\n";
  for (const auto& group : groups)
  {
    os << "<g data-distance=\"" << internal::exact_number(group.first) << "\"><title>distance "
       << internal::short_number(group.first) << "</title>\n";
    for (const internal::Svg_path& path : group.second) internal::write_path(os, path);
    os << "</g>\n";
  }
  os << "</g>\n</svg>\n";
  return os.good();
}

} // namespace IO
} // namespace CGAL

#endif
