// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Offset curves of a build for the public classes: during the propagation, or after it.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CUT_OFFSET_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_CUT_OFFSET_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Geodesic_mesh_data.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Inner_side.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_extraction.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <map>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Levels from a distance, a range of distances, or an Offset_levels object.
template <class Surface, class Levels>
Offset_levels<typename Surface::Number> offset_levels(const Levels& levels)
{
  typedef typename Surface::Number Number;
  if constexpr (std::is_convertible<Levels, typename Surface::FT>::value)
    return Offset_levels<Number>(std::array<Number, 1>{Surface::imported(typename Surface::FT(levels))});
  else return Offset_levels<Number>(levels);
}

template <class Surface, class T>
Offset_levels<typename Surface::Number> offset_levels(const Offset_levels<T>& levels)
{
  return levels.template converted<typename Surface::Number>([](const T& d) {
    return Surface::imported(typename Surface::FT(d));
  });
}

// Callback that writes the curves of all levels to an output iterator, which must outlive the callback.
template <class Curve, class OutputIterator>
auto curve_writer(OutputIterator& out)
{
  return [&out](const auto&, std::vector<Curve>&& curves) { out = std::move(curves.begin(), curves.end(), out); };
}

// The output of the levels of a build to f. Propagates from each closed polyline if its inner or outer side is selected; then
// std::invalid_argument is thrown if a polyline has no such side. It is also thrown if unlimited levels are too close.
// `build`, `levels` and `f` must outlive the result.
template <class Surface, class Build, class Function>
auto make_curve_output(const Geodesic_mesh_data<Surface>& mesh, const Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  typedef Offset_tolerances<typename Surface::Number> Tolerances;
  // With a spacing below the rounding of distances, the number of levels would be practically unlimited.
  if (levels.is_unlimited() && levels[0] < Tolerances::least_spacing(mesh.unfolded().longest_edge()))
    throw std::invalid_argument("Surface_mesh_geodesic_offset: the spacing of offsets is less than the rounding of "
                                "distances");
  std::map<Index, Source_side> inside;
  if (selection.needs_inner_sides()) inside = inner_sides(mesh.unfolded(), mesh.traits, build.sources);
  return Curve_output<Surface, Function>(mesh.shared_surface, build.initial.primitives, build.field.distance,
                                         build.request().tolerance, levels, selection, std::move(inside), f);
}

// Receives the curves of a level, which is given by its index.
template <class FT>
using Level_output = std::function<void(std::size_t, const Level_curves<FT>&)>;

// Consumer of Wavefront::run() that cuts faces at all levels. Calls the output for each level that is complete and has curves.
template <class FT>
class Level_cutter
{
public:
  static constexpr bool reads_lists = true;

  // `out` must outlive this object.
  template <class Build>
  Level_cutter(const Unfolded_mesh<FT>& mesh, const Build& build, const Offset_levels<FT>& levels, const Level_output<FT>& out)
    : m_tolerance(build.request().tolerance),
      m_extraction(mesh, build.initial, build.field, levels, build.maximum, m_tolerance), m_out(out)
  {
  }

  template <class Team>
  void process_finalized(const std::vector<Index>& faces, Team& team)
  {
    add_time_of([&] { this->m_extraction.cut(faces, team); });
  }

  bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized)
  {
    return m_extraction.needs_pending_faces(m_tolerance.least_of(settled), number, finalized);
  }

  template <class Team>
  void process_pending(const std::vector<Index>& faces, const FT& settled, Team& team)
  {
    add_time_of([&] {
      this->m_extraction.cut_pending(faces, m_tolerance.least_of(settled), team, [this](const FT& distance) {
        this->release(distance);
      });
    });
  }

  void settled_up_to(const FT& distance) { release(m_tolerance.least_of(distance)); }

  // Releases the remaining curves up to the distance of the propagation, and completes the statistics of Geodesic_build::run(),
  // whose propagation time then excludes cutting and output. To be called once, after run().
  void finish(const FT& distance, Geodesic_offset_statistics& statistics)
  {
    m_extraction.release_all(distance, m_out);
    statistics.propagation_seconds -= m_seconds_within_propagation;
    statistics.offset_seconds = m_seconds;
    statistics.pieces = m_extraction.number_of_pieces();
    statistics.pieces_peak = m_extraction.largest_number_of_waiting_pieces();
    statistics.forced_joints = m_extraction.number_of_forced_joints();
  }

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

  void release(const FT& distance)
  {
    const Clock::time_point start = Clock::now();
    m_extraction.release(distance, m_out);
    m_seconds_within_propagation += seconds_since(start);
  }

  // Adds the time of cutting to both times. release(), which `cutting` may call, adds its own time to the second one only.
  template <class Cutting>
  void add_time_of(const Cutting& cutting)
  {
    const Clock::time_point start = Clock::now();
    const double before = m_seconds_within_propagation;
    cutting();
    const double time = seconds_since(start) - (m_seconds_within_propagation - before);
    m_seconds += time;
    m_seconds_within_propagation += time;
  }

  const Merging_tolerance<FT> m_tolerance; // unsettled points may be nearer than the settled distance by this
  Offset_extraction<FT> m_extraction;
  const Level_output<FT>& m_out;
  double m_seconds = 0;                    // of cutting
  double m_seconds_within_propagation = 0; // of cutting and output
};

// Cuts all faces at all levels. Precondition: build.kept. This function and cut_finalized_faces() may be compiled separately
// (separate_functions.h).
template <class Concurrency_tag, class Traits>
void cut_all_faces(const Unfolded_mesh<typename Traits::FT>& mesh, const Geodesic_build<Traits>& build,
                   const Offset_levels<typename Traits::FT>& levels, const Level_output<typename Traits::FT>& out)
{
  typedef typename Traits::FT FT;
  constexpr std::size_t at_once = 1 << 12; // faces per call of cut(), which lists them with their levels
  Offset_extraction<FT> extraction(mesh, build.initial, build.field, levels, build.maximum, build.request().tolerance);
  {
    auto&& team = Concurrency<Concurrency_tag, FT>::Team::make();
    std::vector<Index> faces;
    for (Index f = 0; f < mesh.number_of_faces(); ++f)
    {
      if (mesh.source(3 * f) != no_index) faces.push_back(f);
      if (faces.size() < at_once && f + 1 < mesh.number_of_faces()) continue;
      extraction.cut(faces, team);
      faces.clear();
    }
  }
  extraction.release_all(build.maximum, out);
}

// Propagates, and cuts the finalized faces at all levels. `may_search` as in Geodesic_build::propagate().
template <class Concurrency_tag, bool may_search, class Traits>
void cut_finalized_faces(const Unfolded_mesh<typename Traits::FT>& mesh, Geodesic_build<Traits>& build, const Traits& traits,
                         const Offset_levels<typename Traits::FT>& levels, const Level_output<typename Traits::FT>& out)
{
  Level_cutter<typename Traits::FT> cutter(mesh, build, levels, out);
  build.template run<Concurrency_tag, may_search>(traits, cutter);
  cutter.finish(build.maximum, build.statistics);
}

// Propagates, and calls f(distance, curves) for each level.
template <class Concurrency_tag, bool may_search = false, class Surface, class Build, class Function>
void propagate_and_cut(const Geodesic_mesh_data<Surface>& mesh, Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  const auto output = make_curve_output(mesh, build, levels, selection, f);
  cut_finalized_faces<Concurrency_tag, may_search>(mesh.unfolded(), build, mesh.traits, levels, std::cref(output));
  output.finish();
}

// Calls f(distance, curves) for each level of a finished build: from its windows, or, if they were not kept, by a second
// propagation up to the largest level.
template <class Concurrency_tag, class Surface, class Build, class Function>
void cut_offset_curves(const Geodesic_mesh_data<Surface>& mesh, const Build& build,
                       const Offset_levels<typename Surface::Number>& levels, const Offset_selection& selection, Function& f)
{
  if (build.kept || levels.size() == 0)
  {
    const auto output = make_curve_output(mesh, build, levels, selection, f); // also without levels: checks the selection
    if (levels.size() != 0) cut_all_faces<Concurrency_tag>(mesh.unfolded(), build, levels, std::cref(output));
    output.finish();
    return;
  }
  typename Surface::Number maximum = build.maximum;
  if (!levels.is_unlimited()) maximum = (std::min)(maximum, levels[levels.size() - 1]);
  Build second_build(mesh.unfolded(), build.sources, {maximum, false, {}, {}, build.request().tolerance});
  propagate_and_cut<Concurrency_tag>(mesh, second_build, levels, selection, f);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
