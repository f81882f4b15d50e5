// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Offset_curve.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_distance.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_side.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetClasses

\brief computes exact geodesic distances and exact geodesic offset curves on a triangle mesh, from any number of points,
polylines and edges, by the extended Xin-Wang algorithm \cgalCite{XYH11}.

The distance of a point of the surface is the length of the shortest path on the surface from the point to the nearest
source. The use has three steps: add the sources, call `build()`, which propagates the distances, and call the const member
functions. With floating point numbers the const member functions may be called from several threads at once. Points that no
path reaches are at `infinity()`.

Adding or removing sources does not change the result of the last build; only `build()`, `update()` and
`build_with_offset_curves()` replace it. Callbacks may build anew, see \ref Surface_mesh_geodesic_distance_callbacks
"Callbacks, Copies, Moves".

The mesh is neither copied nor modified; it must outlive the object and must not change meanwhile. A vertex that several fans
of faces share is one point of the surface: paths pass through it from each fan into the others, whether the fans are open or
closed. Lengths and distances are in the units of the mesh's points. Offset curves need a number type with at least the precision of `double`; distances
are also available with `float`.

Functions that propagate, and the constructors, take a concurrency tag, see \ref Surface_mesh_geodesic_distance_threads
"Several Threads".

\tparam Traits a model of `SurfaceMeshGeodesicOffsetTraits`
\tparam VertexIndexMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and an unsigned integer type as
        value: indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam FaceIndexMap a model of `ReadablePropertyMap` with `face_descriptor` as key and an unsigned integer type as value:
        indices from 0. %Default: the internal map of the mesh, or a map that the constructor makes.
\tparam VertexPointMap a model of `ReadablePropertyMap` with `vertex_descriptor` as key and a 3D point as value.
        %Default: the `vertex_point` map of the mesh.

\sa `Surface_mesh_geodesic_distance`, the base class with the functions for distances and paths
\sa `Surface_mesh_geodesic_sources`, the base class with the functions for sources and locations
*/
template <class Traits, class VertexIndexMap = Default, class FaceIndexMap = Default, class VertexPointMap = Default>
class Surface_mesh_geodesic_offset
  : public Surface_mesh_geodesic_distance<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap>
{
  typedef Surface_mesh_geodesic_distance<Traits, VertexIndexMap, FaceIndexMap, VertexPointMap> Base;
  typedef typename Base::Build Build;
  typedef typename Base::Index Index;
  typedef typename Base::Number Number;
  typedef typename Base::Policy Policy;
  typedef typename Base::Surface Surface;
  typedef Offset_levels<Number> Levels_inside;

  using Base::m_built;
  using Base::m_sources;
  using Base::m_surface;
  using Base::m_traits;
  using Base::request;
  using Base::unfolded;

  template <class NamedParameters>
  using If_no_selection = std::enable_if_t<!std::is_convertible<NamedParameters, Offset_selection>::value>;

public:
  /// \name Types
  /// @{

#ifdef DOXYGEN_RUNNING
  /// an offset curve
  typedef Geodesic_offset_curve<unspecified_type> Offset_curve;
#else
  typedef typename Base::FT FT;
  typedef Geodesic_offset_curve<Surface> Offset_curve;
#endif
  /// @}

#ifdef DOXYGEN_RUNNING
  /// \name Construction
  /// @{

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  explicit Surface_mesh_geodesic_offset(const Triangle_mesh& tm, const Traits& traits = Traits(),
                                        const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_offset(const Triangle_mesh& tm, Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                               const ConcurrencyTag& tag = ConcurrencyTag());

  /// \copydoc CGAL::Surface_mesh_geodesic_sources::Surface_mesh_geodesic_sources(const Triangle_mesh&, Vertex_index_map, Face_index_map, Vertex_point_map, const Traits&, const ConcurrencyTag&)
  template <class ConcurrencyTag = Sequential_tag>
  Surface_mesh_geodesic_offset(const Triangle_mesh& tm, Vertex_index_map vertex_index_map, Face_index_map face_index_map,
                               Vertex_point_map vertex_point_map, const Traits& traits = Traits(),
                               const ConcurrencyTag& tag = ConcurrencyTag());
  /// @}
#else
  using Base::Base;
#endif

  /// \name Offset Curves
  /// @{

  /// builds the field as `build()` does and cuts the offset curves at the given levels in the same propagation.
  ///
  /// Curves come by increasing distance, as soon as the front has passed them: memory is that of the front and of the
  /// curves that the front crosses. Without `distance_limit`, distances beyond the largest level are computed, too. With a
  /// limit that is equal to the largest level, the curves are the same up to rounding, and nothing beyond is computed. Levels
  /// beyond the distance limit give no curves. A selection by inside or outside takes one more propagation per closed
  /// polyline: over the whole surface, on the calling thread, and with all windows in memory.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param levels a distance, a range of distances, or an `Offset_levels` object
  /// \param out an output iterator for `Offset_curve`
  /// \param selection the side of polylines, and the form at their ends
  /// \param np optional named parameters, as those of `build()`
  /// \throws std::invalid_argument if a distance is not a positive finite number; if the spacing of unlimited levels is less
  ///         than the rounding of distances; if the selection is inside or outside and a source is an open polyline, or a
  ///         closed polyline that does not divide the surface; or if there is a tolerance; and the exceptions of `build()`.
  ///         The last build is unchanged then.
  template <class ConcurrencyTag = Sequential_tag, class Levels, class OutputIterator,
            class NamedParameters = parameters::Default_named_parameters>
  OutputIterator build_with_offset_curves(const Levels& levels, OutputIterator out, const Offset_selection& selection,
                                          const NamedParameters& np = parameters::default_values())
  {
    build_with_offset_curves_by_distance<ConcurrencyTag>(levels, writer_to(out), selection, np);
    return out;
  }

  /// Overload without a selection: all curves.
  template <class ConcurrencyTag = Sequential_tag, class Levels, class OutputIterator,
            class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
            , class = If_no_selection<NamedParameters>
#endif
            >
  OutputIterator build_with_offset_curves(const Levels& levels, OutputIterator out,
                                          const NamedParameters& np = parameters::default_values())
  {
    return build_with_offset_curves<ConcurrencyTag>(levels, out, Offset_selection(), np);
  }

  /// builds the field and passes the offset curves to a callback, distance by distance.
  ///
  /// `f(distance, curves)` is called once per distance, in increasing order, with a `const FT&` and a
  /// `std::vector<Offset_curve>&&`, also if there are no curves. If the number of levels is unlimited, the last call is
  /// that of the largest level that has curves. All else is as in `build_with_offset_curves()`.
  template <class ConcurrencyTag = Sequential_tag, class Levels, class Function,
            class NamedParameters = parameters::Default_named_parameters>
  void build_with_offset_curves_by_distance(const Levels& levels, Function&& f, const Offset_selection& selection,
                                            const NamedParameters& np = parameters::default_values())
  {
    const Levels_inside wanted(as_levels(levels));
    const auto fresh = std::make_shared<Build>(unfolded(), m_sources, request(np));
    if (fresh->is_approximate())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: offset curves are exact, they take no tolerance");
    propagate_and_cut<ConcurrencyTag>(*fresh, wanted, selection, f);
    m_built = fresh;
  }

  /// Overload without a selection: all curves.
  template <class ConcurrencyTag = Sequential_tag, class Levels, class Function,
            class NamedParameters = parameters::Default_named_parameters
#ifndef DOXYGEN_RUNNING
            , class = If_no_selection<NamedParameters>
#endif
            >
  void build_with_offset_curves_by_distance(const Levels& levels, Function&& f,
                                            const NamedParameters& np = parameters::default_values())
  {
    build_with_offset_curves_by_distance<ConcurrencyTag>(levels, f, Offset_selection(), np);
  }

  /// cuts the offset curves at one or several distances of the last build. The curves are cut from the kept windows; if none
  /// were kept, one more propagation up to the largest level cuts all of them.
  ///
  /// A level on which a vertex or a whole edge lies is cut as if these were infinitesimally farther: the curve bounds the
  /// points that are strictly nearer. With an inexact number type every level is cut 1024 units in the last place below
  /// itself, with `double` \f$2^{-42}\f$ of its value. Levels beyond the largest distance of the surface, or beyond the
  /// distance limit of the build, give no curves.
  /// \tparam ConcurrencyTag `Sequential_tag`, `Parallel_tag` or `Parallel_if_available_tag`
  /// \param levels a distance, a range of distances, or an `Offset_levels` object
  /// \param out an output iterator for `Offset_curve`; curves come by increasing distance
  /// \param selection the side of polylines, and the form at their ends
  /// \throws std::invalid_argument as `build_with_offset_curves()`
  /// \throws std::logic_error if the build had a tolerance
  template <class ConcurrencyTag = Sequential_tag, class Levels, class OutputIterator>
  OutputIterator offset_curves(const Levels& levels, OutputIterator out,
                               const Offset_selection& selection = Offset_selection()) const
  {
    offset_curves_by_distance<ConcurrencyTag>(levels, writer_to(out), selection);
    return out;
  }

  /// passes the offset curves of the last build to a callback as that of `build_with_offset_curves_by_distance()`.
  /// All else is as in `offset_curves()`.
  template <class ConcurrencyTag = Sequential_tag, class Levels, class Function>
  void offset_curves_by_distance(const Levels& levels, Function&& f,
                                 const Offset_selection& selection = Offset_selection()) const
  {
    const Levels_inside wanted(as_levels(levels));
    const std::shared_ptr<const Build> last = this->shared_exact_build();
    const Build& b = *last;
    if (b.kept)
    {
      const auto output = curve_output(b, wanted, selection, f);
      b.template cut<ConcurrencyTag>(wanted, output);
      output.finish();
      return;
    }
    Number maximum = b.maximum;
    if (!wanted.is_unlimited() && wanted.size() > 0) maximum = (std::min)(maximum, wanted[wanted.size() - 1]);
    Build again(unfolded(), b.sources, {maximum, false, {}, {}, {}});
    propagate_and_cut<ConcurrencyTag>(again, wanted, selection, f);
  }

  /// @}

private:
  template <class Levels>
  static Levels_inside as_levels(const Levels& levels)
  {
    if constexpr (std::is_convertible<Levels, FT>::value)
      return Levels_inside(std::array<Number, 1>{Surface::imported(FT(levels))});
    else
      return as_levels_inside(levels);
  }

  template <class T>
  static Levels_inside as_levels_inside(const Offset_levels<T>& levels)
  {
    return levels.template converted<Number>([](const T& d) { return Surface::imported(FT(d)); });
  }

  template <class Range>
  static Levels_inside as_levels_inside(const Range& distances)
  {
    return Levels_inside(distances);
  }

  template <class OutputIterator>
  static auto writer_to(OutputIterator& out)
  {
    return [&out](const FT&, std::vector<Offset_curve>&& curves) {
      out = std::move(curves.begin(), curves.end(), out);
    };
  }

  // Levels nearer to each other than rounding would never come to an end.
  void check_spacing(const Levels_inside& levels) const
  {
    if (levels.is_unlimited() && levels[0] < Policy::rounding(1024) * unfolded().longest_edge())
      throw std::invalid_argument("Surface_mesh_geodesic_offset: the spacing of offsets is less than the rounding of "
                                  "distances");
  }

  template <class ConcurrencyTag, class Function>
  void propagate_and_cut(Build& b, const Levels_inside& levels, const Offset_selection& selection,
                         Function& f) const
  {
    const auto output = curve_output(b, levels, selection, f);
    b.template propagate_and_cut<ConcurrencyTag>(m_traits, levels, output);
    output.finish();
  }

  template <class Function>
  auto curve_output(const Build& b, const Levels_inside& levels, const Offset_selection& selection,
                    Function& f) const
  {
    check_spacing(levels);
    const bool by_inside = selection.side == Offset_side::INSIDE || selection.side == Offset_side::OUTSIDE;
    std::map<Index, Source_side> inside;
    if (by_inside) inside = Geodesic_offset::internal::inner_sides(unfolded(), m_traits, b.sources);
    return Geodesic_offset::internal::Curve_output<Surface, Function>(m_surface, b.initial.primitives, levels, selection,
                                                                     std::move(inside), f);
  }
};

} // namespace CGAL

#endif
