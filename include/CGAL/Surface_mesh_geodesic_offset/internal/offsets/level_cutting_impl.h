// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for level_cutting.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CUTTING_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_consumer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Curve_selection.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_extraction.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/level_cutting.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/seconds_since.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <chrono>
#include <cstddef>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Consumer of Wavefront::run() that cuts faces at all levels. Calls the output for each level that is complete and has curves.
template <class FT, class Team>
class Level_cutter : public Face_consumer<FT, Team>
{
public:
  bool reads_lists() const override { return true; }
  bool is_done() const override { return m_is_done; }

  // `request` and `out` must outlive this object.
  template <class Build>
  Level_cutter(const Unfolded_mesh<FT>& mesh, const Build& build, const Level_request<FT>& request,
               const Curve_selection<FT>& out)
    : m_tolerance(build.request().tolerance), m_request(request), m_last_start(build.initial.start_values.largest()),
      m_extraction(mesh, build.initial, build.field, request.levels, build.maximum, m_tolerance), m_out(out)
  {
  }

  void process_finalized(const std::vector<Index>& faces, Team& team) override
  {
    add_time_of([&] { this->m_extraction.cut(faces, team); });
  }

  bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized) override
  {
    return m_extraction.needs_pending_faces(m_tolerance.least_of(settled), number, finalized);
  }

  void process_pending(const std::vector<Index>& faces, const FT& settled, Team& team) override
  {
    add_time_of([&] {
      this->m_extraction.cut_pending(faces, m_tolerance.least_of(settled), team, [this](const FT& distance) {
        this->release(distance);
      });
    });
  }

  void settled_up_to(const FT& distance) override { release(m_tolerance.least_of(distance)); }

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

  void release(const FT& distance)
  {
    const Clock::time_point start = Clock::now();
    m_extraction.release(distance, [this](std::size_t level, const Level_curves<FT>& cut) {
      if (this->m_out(level, cut)) return;
      // paths to farther points of the selection would pass this level there, as all start values are less
      if (this->m_request.only_curves && this->m_request.levels[level] > this->m_last_start) this->m_is_done = true;
    });
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
  const Level_request<FT>& m_request;
  const FT m_last_start; // the largest start value
  Offset_extraction<FT> m_extraction;
  const Curve_selection<FT>& m_out;
  bool m_is_done = false;
  double m_seconds = 0;                    // of cutting
  double m_seconds_within_propagation = 0; // of cutting and output
};

template <class Concurrency_tag, class Traits>
void cut_all_faces(const Unfolded_mesh<typename Traits::FT>& mesh, const Geodesic_build<Traits>& build,
                   const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out)
{
  typedef typename Traits::FT FT;
  const Curve_selection<FT> select(mesh, build, request, out); // also without levels: checks the selection
  if (request.levels.size() == 0) return;
  constexpr std::size_t at_once = 1 << 12; // faces per call of cut(), which lists them with their levels
  Offset_extraction<FT> extraction(mesh, build.initial, build.field, request.levels, build.maximum, build.request().tolerance);
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
  extraction.release_all(build.maximum, select);
}

template <class Concurrency_tag, unsigned parts, class Traits>
void cut_finalized_faces(const Unfolded_mesh<typename Traits::FT>& mesh, Geodesic_build<Traits>& build, const Traits& traits,
                         const Level_request<typename Traits::FT>& request, const Level_output<typename Traits::FT>& out)
{
  typedef typename Traits::FT FT;
  const Curve_selection<FT> select(mesh, build, request, out);
  Level_cutter<FT, typename Concurrency<Concurrency_tag, FT>::Team::Type> cutter(mesh, build, request, select);
  build.template run<Concurrency_tag, parts>(traits, cutter);
  cutter.finish(build.maximum, build.statistics);
}

} // namespace CGAL::Geodesic_offset::internal

#endif
