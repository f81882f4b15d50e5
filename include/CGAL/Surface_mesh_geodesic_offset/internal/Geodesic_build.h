// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One run of the pipeline: a copy of the sources, and their field.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_offset_statistics.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Build_request.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Farthest_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Near_path.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_tracing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <chrono>
#include <optional>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Geodesic_build
{
public:
  typedef typename Traits::FT FT;

  Geodesic_build(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& source_set, const Build_request<FT>& request)
    : sources(source_set), initial(sources.initial_windows(mesh)), maximum(request.maximum), kept(request.keeps_windows),
      suffixes(mesh.number_of_vertices()), suffixes_in_space(mesh.number_of_vertices()), m_mesh(mesh), m_request(request)
  {
    field.clear(mesh, initial.start_values);
  }

  // Continues another build with additional sources: starts from its distances and windows. The other build must have kept all
  // windows up to the maximum distance.
  Geodesic_build(const Geodesic_build& before, const Source_set<FT>& source_set, const Build_request<FT>& request)
    : sources(source_set), initial(sources.initial_windows(before.m_mesh)), maximum(request.maximum),
      kept(request.keeps_windows), suffixes(before.m_mesh.number_of_vertices()),
      suffixes_in_space(before.m_mesh.number_of_vertices()), m_mesh(before.m_mesh), m_request(request),
      m_first_new(Index(before.initial.primitives.size()))
  {
    field.start_from(before.field, initial.start_values);
  }

  // Propagates without a consumer of finalized faces. `may_search`: false if no request needs the farthest point; then the
  // search is not instantiated. Defined outside the class, as it may be compiled separately (separate_functions.h).
  template <class Concurrency_tag = Sequential_tag, bool may_search = false>
  void propagate(const Traits& traits);

  // Propagates and hands faces to a consumer, see Wavefront::run().
  template <class Concurrency_tag, bool may_search = false, class Consumer>
  void run(const Traits& traits, Consumer& consumer)
  {
    const Clock::time_point start = Clock::now();
    CGAL_precondition(may_search || !m_request.finds_farthest);
    if constexpr (may_search)
    {
      std::optional<Farthest_point<FT>> search;
      if (m_request.finds_farthest) search.emplace(m_mesh, initial, field);
      // An update passes on only the faces that it improves.
      const bool searches_on_the_way = search && m_first_new == 0;
      Searching_consumer<Consumer> searching{searches_on_the_way ? &*search : nullptr, consumer};
      run_front<Concurrency_tag>(traits, searching);
      if (search)
      {
        if (!searches_on_the_way) search->add_all();
        farthest = search->result();
        statistics.faces_searched = search->number_of_searched_faces();
      }
    }
    else run_front<Concurrency_tag>(traits, consumer);
    statistics.kept_bytes = field.kept.bytes();
    statistics.propagation_seconds = seconds_since(start);
    if (!is_cancelled && m_request.goes_on) m_request.goes_on(1.);
    m_request.release_inputs();
  }

  const Build_request<FT>& request() const { return m_request; }

  bool is_approximate() const { return !m_request.tolerance.is_zero(); }

  // True if the propagation reached all points within the distance limit.
  bool is_whole() const { return !is_cancelled && !has_all_targets; }

  const Source_set<FT> sources;
  const Initial_windows<FT> initial;
  FT maximum; // distances up to this value are final
  const bool kept;
  bool is_cancelled = false, has_all_targets = false;
  Geodesic_field<FT> field;
  std::optional<Farthest<FT>> farthest; // if requested and existing
  Geodesic_offset_statistics statistics;
  // caches for the paths of queries
  mutable Path_suffix_cache<FT, Path_crossing<FT>> suffixes;
  mutable Path_suffix_cache<FT, typename Traits::Point_3> suffixes_in_space;

private:
  typedef std::chrono::steady_clock Clock;

  static double seconds_since(Clock::time_point t) { return std::chrono::duration<double>(Clock::now() - t).count(); }

  template <class Concurrency_tag, class Consumer>
  void run_front(const Traits& traits, Consumer& consumer)
  {
    const std::size_t signs = Sign_decisions<FT>::all(), exact_signs = Sign_decisions<FT>::exact();
    typedef typename Concurrency<Concurrency_tag, FT>::Tag Tag;
    Wavefront<Traits, Tag> front(m_mesh, initial, traits, maximum, kept, Consumer::reads_lists, field, m_request.tolerance);
    std::size_t next_target = 0;
    const auto goes_on = [&](const FT& distance, std::size_t passed) {
      const auto& targets = m_request.targets;
      while (next_target < targets.size() && is_final(front, targets[next_target], distance)) ++next_target;
      has_all_targets = !targets.empty() && next_target == targets.size();
      if (has_all_targets) return false;
      is_cancelled = m_request.goes_on && !m_request.goes_on(double(passed) / double(m_mesh.number_of_faces()));
      return !is_cancelled;
    };
    front.run(consumer, goes_on, m_first_new);
    maximum = front.maximum();
    if (front.merging().is_on()) take_errors(front.merging(), front.merging_counts());
    else if (front.has_bent_paths()) follow_ways_back();
    statistics.sign_decisions = Sign_decisions<FT>::all() - signs;
    statistics.exact_decisions = Sign_decisions<FT>::exact() - exact_signs;
    statistics.windows_created = front.counts().windows_created;
    statistics.windows_propagated = front.counts().windows_propagated;
    statistics.windows_peak = field.lists.peak();
    field.release_front();
    field.path_length = Near_path<FT>(m_mesh, initial, field, !is_approximate()).lengths_at_vertices(maximum);
  }

  // Searches finalized faces for the farthest point if requested, and passes them on.
  template <class Consumer>
  struct Searching_consumer
  {
    static constexpr bool reads_lists = Consumer::reads_lists;
    Farthest_point<FT>* search;
    Consumer& consumer;

    template <class Team>
    void process_finalized(const std::vector<Index>& faces, Team& team)
    {
      if (search != nullptr) search->add(faces);
      consumer.process_finalized(faces, team);
    }
    void settled_up_to(const FT& distance) { consumer.settled_up_to(distance); }
    bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized)
    {
      return consumer.needs_pending_faces(settled, number, finalized);
    }
    template <class Team>
    void process_pending(const std::vector<Index>& faces, const FT& settled, Team& team)
    {
      consumer.process_pending(faces, settled, team);
    }
  };

  // Replaces directions at vertices by those of the traced paths, also where rounding hides the straight ones.
  void follow_ways_back()
  {
    const Path_tracing<FT> paths(m_mesh, initial, field);
    constexpr Index ahead = 16;
    for (Index v = 0; v < m_mesh.number_of_vertices(); ++v)
    {
      if (v + ahead < m_mesh.number_of_vertices() && field.back[v + ahead].corner != no_index)
        m_mesh.prefetch_face(field.back[v + ahead].corner);
      const Backtrace<FT> spread = field.back[v];
      if (paths.find_backtrace(v, field.back[v], field.source_ref[v]) && m_mesh.can_be_pseudo_source(v))
        field.back_of_sector.emplace(v, spread);
    }
  }

  // Stores the errors of merged windows. A merged window has no pseudo-source, so the backtrace ends at its image.
  void take_errors(const Window_merging<FT>& merging, const Merging_counts& counts)
  {
    statistics.windows_merged = counts.windows_merged;
    statistics.error_bound = counts.error_bound;
    statistics.relative_error_bound = counts.relative_error_bound;
    field.error.resize(field.back.size());
    for (std::size_t v = 0; v < field.error.size(); ++v) field.error[v] = merging.error_of_origin(field.back[v].pseudo_source);
    for (Backtrace<FT>& back : field.back)
      if (Merge_error_code::is_merged(back.pseudo_source)) back.pseudo_source = no_index;
  }

  // True if the distance of a point is final when the front is at a distance.
  template <class Front>
  bool is_final(const Front& front, const Surface_point<FT>& p, const FT& distance) const
  {
    if (p.kind == Surface_point<FT>::VERTEX) return field.distance[p.element] <= distance;
    return front.largest_distance(p.kind == Surface_point<FT>::EDGE ? m_mesh.face(p.element) : p.element) <= distance;
  }

  const Unfolded_mesh<FT>& m_mesh;
  Build_request<FT> m_request;
  const Index m_first_new = 0; // primitive
};

template <class Traits>
template <class Concurrency_tag, bool may_search>
void Geodesic_build<Traits>::propagate(const Traits& traits)
{
  Ignoring_consumer consumer;
  run<Concurrency_tag, may_search>(traits, consumer);
}

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
