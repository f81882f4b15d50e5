// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_VORONOI_DIAGRAM_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_VORONOI_DIAGRAM_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Bisector_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/vertex_results.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/chord_tolerance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Bisector_diagram.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <boost/iterator/counting_iterator.hpp>
#include <boost/iterator/transform_iterator.hpp>
#include <boost/range/iterator_range.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL {

template <class>
class Geodesic_voronoi_diagram;

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents an edge of a geodesic Voronoi diagram: an ordered chain of segments and arcs of parabolas and hyperbolas, each
inside one face, between the cells of two sources.

The curve is closed, or each of its ends is a vertex of the diagram or lies on the border of the mesh. Curves share the data of their
diagram, are valid after its destruction, and must not outlive the mesh. All member functions of a curve that was moved from throw
`std::logic_error`.

\tparam Surface_ an implementation detail; `Geodesic_voronoi_diagram::Curve` names the type
*/
template <class Surface_>
class Geodesic_bisector
{
  typedef Geodesic_offset::internal::Bisector_chain<double> Chain;
  typedef Geodesic_offset::internal::Bisector_diagram<double> Diagram;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  friend class Geodesic_voronoi_diagram<Surface_>;

  Geodesic_bisector(std::shared_ptr<const Context> context, std::shared_ptr<const Diagram> diagram, std::size_t number)
    : m_context(std::move(context)), m_diagram(std::move(diagram)), m_number(number)
  {
  }

public:
  /// \name Types
  /// @{

  /// the number type of distances and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in space
  typedef typename Surface_::Point_3 Point_3;
  /// a point of the surface, see `Geodesic_mesh::Face_location`
  typedef typename Surface_::Face_location Face_location;
  /// a piece of the curve
  typedef Geodesic_bisector_piece<Surface_> Piece;
  /// @}

  /// the id of the source whose cell is on the left of the direction of travel, seen from the outside of the surface.
  std::size_t source_on_left() const { return chain().arcs.front().left.label; }
  /// the id of the source whose cell is on the right.
  std::size_t source_on_right() const { return chain().arcs.front().right.label; }

  /// whether the curve is closed.
  bool is_closed() const { return chain().is_closed; }

  /// the index of the vertex of the diagram at the start; empty if the curve is closed or starts on the border.
  std::optional<std::size_t> start_vertex() const { return vertex(chain().start_vertex); }
  /// the index of the vertex of the diagram at the end; empty if the curve is closed or ends on the border.
  std::optional<std::size_t> end_vertex() const { return vertex(chain().end_vertex); }

  /// \name Pieces
  /// Each piece ends where the next one starts, up to rounding.
  /// @{

  /// the number of pieces.
  std::size_t number_of_pieces() const { return chain().arcs.size(); }

  /// the i-th piece. \pre `i < number_of_pieces()`
  Piece piece(std::size_t i) const
  {
    CGAL_precondition(i < chain().arcs.size());
    return Piece(*m_context, chain().arcs[i]);
  }

  /// all pieces, in order.
  auto pieces() const
  {
    const auto view = [context = m_context.get()](const Geodesic_offset::internal::Bisector_arc<double>& a) {
      return Piece(*context, a);
    };
    const auto& arcs = chain().arcs;
    return boost::make_iterator_range(boost::make_transform_iterator(arcs.begin(), view),
                                      boost::make_transform_iterator(arcs.end(), view));
  }
  /// @}

  /// \name Points
  /// @{

  /// calls `f(location, i)` for points along the curve, where `i` is the index of the piece that contains the point.
  ///
  /// Both ends of each piece are among the points, so two consecutive points share the face of a piece. The polyline through
  /// the points is nowhere farther from the curve than `chord_tolerance`. A closed curve repeats its first point at the end.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  template <class Function>
  void discretize(const FT& chord_tolerance, const Function& f) const
  {
    Geodesic_offset::internal::check_chord_tolerance(chord_tolerance); // before any output
    const std::size_t n = number_of_pieces();
    for (std::size_t i = 0; i < n; ++i)
    {
      const Piece p = piece(i);
      if (i == 0) f(p.start(), i);
      p.for_each_inner_location(chord_tolerance, [&](const Face_location& l) { f(l, i); });
      f(is_closed() && i + 1 == n ? piece(0).start() : p.end(), i);
    }
  }

  /// writes the points of `discretize()` as locations.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \param chord_tolerance a length
  /// \param out an output iterator for `Face_location`
  template <class OutputIterator>
  OutputIterator face_locations(const FT& chord_tolerance, OutputIterator out) const
  {
    discretize(chord_tolerance, [&](const Face_location& l, std::size_t) { *out++ = l; });
    return out;
  }

  /// writes the points of `discretize()` as points in space.
  /// \throws std::invalid_argument unless `chord_tolerance > 0`
  /// \param chord_tolerance a length
  /// \param out an output iterator for `Point_3`
  template <class OutputIterator>
  OutputIterator points(const FT& chord_tolerance, OutputIterator out) const
  {
    discretize(chord_tolerance, [&](const Face_location& l, std::size_t) { *out++ = point(l); });
    return out;
  }

  /// the point in space of a location.
  /// \throws std::invalid_argument if the face of the location is null, removed or of another mesh
  Point_3 point(const Face_location& location) const
  {
    chain(); // or an exception
    m_context->surface->checked_index_of(location.first);
    return m_context->surface->point(location);
  }
  /// @}

private:
  const Chain& chain() const
  {
    if (!m_diagram) throw std::logic_error("Surface_mesh_geodesic_offset: a bisector that was moved from has no pieces");
    return m_diagram->chains[m_number];
  }

  static std::optional<std::size_t> vertex(std::size_t v)
  {
    if (v == Chain::no_vertex) return std::nullopt;
    return v;
  }

  std::shared_ptr<const Context> m_context;
  std::shared_ptr<const Diagram> m_diagram;
  std::size_t m_number;
};

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief represents the exact geodesic Voronoi diagram of sources: the curves between the cells of different sources, and the
vertices where these curves meet.

The cell of a source consists of the points of the surface whose distance from the source is not larger than that from any other
source; start values of sources are additive weights. A cell may be empty, and need not be connected. The curves are the common
boundaries of two cells, exact up to the rounding of `double`, whatever the number type: the distances of a point of a curve from
both sources differ by rounding. Bisectors between different paths to one source are not among them.

If sources tie in a whole region, there are no curves in it, and it belongs to one of them. If the sources coincide, or have an end or
a corner in common, this is the one with the smallest id. Behind a vertex of the mesh where shortest paths to several sources bend, it is
the nearest source of this vertex, as `Geodesic_distance_field::source_labels()` writes it. Two points of a face coincide if their
distance is at most 2^-43 of the longest edge plus the largest distance of a vertex, and so do segments with such ends: rounding does
not determine the direction of the curves between them.

Closed curves shorter than 1.2e-7 of the size of a face plus its distances are omitted, unless the surface inside is larger, as in a
needle. Parts of cells that are narrower than 1e-11 of this size may be omitted, and curves may be wrong in or next to faces whose
height is less than 1e-9 of their length.

Sources that share a vertex or a segment, or of which one starts with the distance from another one, may tie along a whole ray or
edge. Beside it, their distances differ by the square of the distance from the ray. The curve may then run beside the ray, at points
where the distances are equal up to rounding, and may have very short pieces. Where rounding decides which bisectors meet, curves
contain straight links. Along a link, both distances are equal up to 2^-42 of the longest edge plus the largest distance.
`number_of_forced_cells()` is the number of parts of faces in which the links were not verified. It is 0 except with faces that need
more than about a hundred divisions per path that enters them, as faces whose height is less than 1e-5 of their length and in which
tens of segments cross.

Diagrams are immutable values: copies share the data, which may be read by several threads. A diagram must not outlive the mesh. It
does not need the field, but keeps the windows of the faces that curves cross. All member functions of a diagram that was moved from
throw `std::logic_error`.

\tparam Surface_ an implementation detail; `Geodesic_distance_field::Voronoi_diagram` names the type
*/
template <class Surface_>
class Geodesic_voronoi_diagram
{
  typedef Geodesic_offset::internal::Bisector_diagram<double> Diagram;
  typedef Geodesic_offset::internal::Curve_context<Surface_> Context;

  friend Context; // knows the surface

public:
  /// \name Types
  /// @{

  /// an edge of the diagram
  typedef Geodesic_bisector<Surface_> Curve;
  /// the number type of distances and of coordinates
  typedef typename Surface_::FT FT;
  /// a point in space
  typedef typename Surface_::Point_3 Point_3;
  /// a point of the surface, see `Geodesic_mesh::Face_location`
  typedef typename Surface_::Face_location Face_location;
  /// a face of the mesh
  typedef typename boost::graph_traits<typename Surface_::Triangle_mesh>::face_descriptor face_descriptor;
  /// @}

#ifndef DOXYGEN_RUNNING
  template <class Build>
  Geodesic_voronoi_diagram(const Geodesic_offset::internal::Geodesic_mesh_data<Surface_>& mesh, const Build& build)
    : m_context(std::make_shared<Context>(Context{mesh.shared_surface, build.initial.primitives}))
  {
    namespace internal = Geodesic_offset::internal;
    if (internal::Number_policy<typename Surface_::Number>::is_finite(build.maximum))
      throw std::logic_error("Surface_mesh_geodesic_offset: a Voronoi diagram needs distances everywhere, but they were not "
                             "computed beyond a distance");
    m_diagram = std::make_shared<Diagram>(internal::find_bisectors<double>(mesh.unfolded(), build.initial, build.field));
  }
#endif

  /// \name Curves
  /// @{

  /// the number of curves.
  std::size_t number_of_curves() const { return diagram().chains.size(); }

  /// the i-th curve. \pre `i < number_of_curves()`
  Curve curve(std::size_t i) const
  {
    CGAL_precondition(i < number_of_curves());
    return Curve(m_context, m_diagram, i);
  }

  /// all curves.
  auto curves() const
  {
    const auto view = [*this](std::size_t i) { return this->curve(i); };
    return boost::make_iterator_range(
      boost::make_transform_iterator(boost::counting_iterator<std::size_t>(0), view),
      boost::make_transform_iterator(boost::counting_iterator<std::size_t>(number_of_curves()), view));
  }
  /// @}

  /// \name Faces
  /// @{

  /// the id of the source whose cell has the center of a face: the cell of all points of the face, if no curve has a piece in it.
  /// `Geodesic_distance_field::no_source()` if no path reaches the face.
  /// \throws std::invalid_argument if the face is null, removed or of another mesh
  std::size_t source_at_face(face_descriptor f) const
  {
    const Diagram& d = diagram();
    const auto label = d.label_of_face[m_context->surface->checked_index_of(f)];
    return label == Geodesic_offset::internal::no_index ? Geodesic_offset::internal::no_source_label : std::size_t(label);
  }

  /// the id of the source in whose cell a point lies: the nearest one; of those that tie, any.
  /// `Geodesic_distance_field::no_source()` if no path reaches the point. The time is linear in the number of windows in the
  /// face.
  /// \throws std::invalid_argument if the location is not valid
  std::size_t source_at(const Face_location& location) const
  {
    diagram();                                // or an exception
    m_context->surface->classified(location); // or an exception
    std::array<double, 3> weights;
    std::transform(location.second.begin(), location.second.end(), weights.begin(),
                   [](const FT& w) { return (std::max)(CGAL::to_double(w), 0.); }); // negative by rounding: on an edge
    const double sum = weights[0] + weights[1] + weights[2];
    for (double& w : weights) w /= sum;
    const auto* const cells = cells_of(location.first);
    return cells ? cells->labels(weights, 0).front() : source_at_face(location.first);
  }

#ifndef DOXYGEN_RUNNING
  // For splits: sources of a point of a part of a face, given by its barycentric coordinates, that are not farther than the
  // nearest one by more than `within`, the nearest first. A face that no curve crosses is one part, with one source.
  std::vector<std::size_t> sources_of_part(face_descriptor f, const std::array<double, 3>& weights, double within) const
  {
    const auto* const cells = cells_of(f);
    if (!cells || !cells->is_crossed) return {source_at_face(f)};
    const auto labels = cells->labels(weights, within);
    return std::vector<std::size_t>(labels.begin(), labels.end());
  }
#endif
  /// @}

  /// \name Vertices Points where three or more curves end: between three or more sources, or between two, as where two
  /// polylines cross. Where more than three cells meet up to rounding, there may be several vertices at one point, with curves
  /// between them.
  /// @{

  /// the number of vertices.
  std::size_t number_of_vertices() const { return diagram().vertices.size(); }

  /// the location of a vertex. \pre `i < number_of_vertices()`
  Face_location vertex(std::size_t i) const
  {
    CGAL_precondition(i < number_of_vertices());
    typedef typename Surface_::Number Number;
    const auto& v = diagram().vertices[i];
    return m_context->surface->location_inside(v.face, {Number(v.point.x), Number(v.point.y)}, v.edge);
  }

  /// the point in space of a vertex. \pre `i < number_of_vertices()`
  Point_3 vertex_point(std::size_t i) const
  {
    const Face_location l = vertex(i);
    return m_context->surface->point(l);
  }

  /// the indices of the curves that end at a vertex; that of a curve with both ends there occurs twice.
  /// \pre `i < number_of_vertices()`
  const std::vector<std::size_t>& curves_at_vertex(std::size_t i) const
  {
    CGAL_precondition(i < number_of_vertices());
    return diagram().vertices[i].curves;
  }
  /// @}

  /// \name Diagnosis
  /// @{

  /// the number of parts of faces, larger than rounding, in which curves do not fit together. They are crossed straight, so a
  /// curve may be wrong there. 0 in general.
  std::size_t number_of_forced_cells() const { return diagram().forced_cells; }
  /// @}

#ifndef DOXYGEN_RUNNING
  // For tests and benchmarks: divisions of cells that rounding did not let be connected at once
  std::size_t number_of_divisions() const { return diagram().divisions; }
#endif

private:
  const Diagram& diagram() const
  {
    if (!m_diagram) throw std::logic_error("Surface_mesh_geodesic_offset: a Voronoi diagram that was moved from");
    return *m_diagram;
  }

  // Null for a face with one source.
  const Geodesic_offset::internal::Face_cells<double>* cells_of(face_descriptor f) const
  {
    const auto cells = diagram().cells.find(Geodesic_offset::internal::Index(m_context->surface->index_of(f)));
    return cells == diagram().cells.end() ? nullptr : &cells->second;
  }

  std::shared_ptr<const Context> m_context;
  std::shared_ptr<const Diagram> m_diagram;
};

} // namespace CGAL

#endif
