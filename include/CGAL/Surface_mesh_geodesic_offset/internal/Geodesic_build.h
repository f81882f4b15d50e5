// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of the pipeline: the sources as they were, the field that came of them, and the offsets cut on the way or
// afterwards.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/Offset_levels.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Offset_extraction.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Wavefront.h>

#include <chrono>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Geodesic_build
{
public:
  typedef typename Traits::FT FT;

  Geodesic_build(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& sources, const FT& maximum, bool keep_windows)
    : sources(sources), initial(sources.initial_windows(mesh)), maximum(maximum), kept(keep_windows), m_mesh(mesh)
  {
  }

  // Without offsets.
  void propagate(const Traits& traits)
  {
    Nothing nothing;
    run(traits, nothing);
  }

  // Calls out(level index, Level_curves) for each level that has curves, as soon as it is finished.
  template <class Function>
  void propagate_and_cut(const Traits& traits, const Offset_levels<FT>& levels, const Function& out)
  {
    Cutter<Function> cutter{Offset_extraction<FT>(m_mesh, initial, field, levels), out};
    run(traits, cutter);
    cutter.finish();
    statistics.propagation_seconds -= cutter.seconds_within_propagation;
    statistics.offset_seconds = cutter.seconds;
    statistics.pieces = cutter.extraction.number_of_pieces();
    statistics.forced_joints = cutter.extraction.number_of_forced_joints();
  }

  // The same from kept windows.
  template <class Function>
  void cut(const Offset_levels<FT>& levels, const Function& out) const
  {
    Offset_extraction<FT> extraction(m_mesh, initial, field, levels);
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_mesh.source(3 * f) != no_index) extraction(f);
    extraction.release_all(out);
  }

  const Source_set<FT> sources;
  const Initial_windows<FT> initial;
  const FT maximum;
  const bool kept;
  Geodesic_field<FT> field;
  Geodesic_offset_statistics statistics;

private:
  typedef std::chrono::steady_clock Clock;
  static double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

  // Consumers of finished faces.
  struct Nothing
  {
    void take(const std::vector<Index>&) {}
    void settle(const FT&) {}
  };

  template <class Function>
  struct Cutter
  {
    Offset_extraction<FT> extraction;
    const Function& out;
    double seconds = 0, seconds_within_propagation = 0;

    void take(const std::vector<Index>& faces)
    {
      const Clock::time_point start = Clock::now();
      for (Index f : faces) extraction(f);
      const double time = seconds_since(start);
      seconds += time;
      seconds_within_propagation += time;
    }
    void settle(const FT& distance)
    {
      const Clock::time_point start = Clock::now();
      extraction.release(distance, out);
      seconds_within_propagation += seconds_since(start);
    }
    void finish() { extraction.release_all(out); }
  };

  template <class Consumer>
  void run(const Traits& traits, Consumer& consumer)
  {
    const Clock::time_point start = Clock::now();
    Wavefront<Traits> front(m_mesh, initial, traits, maximum, kept, field);
    front.run(consumer);
    statistics.windows_created = front.counts().windows_created;
    statistics.windows_propagated = front.counts().windows_propagated;
    statistics.windows_peak = field.lists.peak();
    statistics.propagation_seconds = seconds_since(start);
    if (!kept) field.release_lists();
  }

  const Unfolded_mesh<FT>& m_mesh;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
