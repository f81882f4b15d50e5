// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 3 of the pipeline: the wavefront. A halfedge is processed with all windows of its list: the list is reduced to its lower
// envelope if required, and its new windows are propagated across the face together. Vertices where shortest paths bend become
// pseudo-sources. The consumer receives finalized faces, whose lists are then released.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WAVEFRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_WAVEFRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_consumer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Face_finalizer.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Ray_spreading.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Sequential_front.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Source_pacing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_merging.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Coinciding_places.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Initial_windows.h>

#include <CGAL/assertions.h>
#include <CGAL/number_utils.h>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#ifdef CGAL_LINKED_WITH_TBB
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Parallel_front.h>
#endif

namespace CGAL::Geodesic_offset::internal {

// The windows of two segments in line have the same distances, but where one of them is a segment of another source, too, or a
// point of it up to rounding, they may be of different cells of the Voronoi diagram, so such segments are groups of their own.
//
// Segments coincide here if their ends are no farther apart than 2^-43 of the longest edge times the number of faces plus the
// latest start value: more than Voronoi_tolerances::same_source(), since no distance is larger than this. More groups only keep
// more windows. Binding test: test_voronoi_diagram, shared segments.
template <class FT>
std::vector<Index> merging_groups(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial)
{
  std::vector<Index> group(initial.source_of);
  const std::size_t n = group.size();
  const bool has_two_sources =
    std::adjacent_find(group.begin(), group.end(), [](Index a, Index b) { return a != b; }) != group.end();
  const bool has_segments =
    std::any_of(initial.primitives.begin(), initial.primitives.end(), [](const auto& p) { return p.is_segment; });
  const auto separate_varying =
    [&] { // between segments with different slopes of start values, the distance has a ridge or a valley
      for (std::size_t i = 0; i < n; ++i)
        if (initial.primitives[i].varies) group[i] = Index(no_index - 1 - i);
    };
  if (!has_two_sources || !has_segments) return separate_varying(), group;
  const double longest = CGAL::to_double(mesh.longest_edge()) * double(mesh.number_of_faces() + 1);
  double latest = 0;
  for (std::size_t i = 0; i < n; ++i)
    latest = (std::max)(latest, CGAL::to_double(initial.start_values.of(Source_ref(Index(i), Source_side::NONE))));
  constexpr double tolerance = double(1 << 9) * std::numeric_limits<double>::epsilon();
  Coinciding_places<FT> places(mesh, tolerance * (longest + latest));
  std::map<std::pair<Index, Index>, Index> source_at; // by the numbers of the ends; no_index: several
  std::vector<std::pair<Index, Index>> ends(n);
  for (std::size_t i = 0; i < n; ++i)
  {
    const Index first = places.number_of(initial.places[i].first),
                second = initial.primitives[i].is_segment ? places.number_of(initial.places[i].second) : first;
    ends[i] = std::minmax({first, second});
    const auto known = source_at.emplace(ends[i], group[i]).first;
    if (known->second != group[i]) known->second = no_index;
  }
  const Index sources = *std::max_element(group.begin(), group.end()) + 1;
  for (std::size_t i = 0; i < n; ++i)
    if (initial.primitives[i].is_segment && source_at[ends[i]] == no_index) group[i] = sources + Index(i);
  return separate_varying(), group;
}

template <class Traits, class Concurrency_tag>
struct Front_type
{
  typedef Sequential_front<Traits> type;
};
#ifdef CGAL_LINKED_WITH_TBB
template <class Traits>
struct Front_type<Traits, Parallel_tag>
{
  typedef Parallel_front<Traits> type;
};
#endif

// `Traits`: Front_traits. `Concurrency_tag`: Sequential_tag, or Parallel_tag with floating point numbers.
template <class Traits, class Concurrency_tag = Sequential_tag>
class Wavefront
{
  typedef Wavefront_state<typename Traits::FT> State;
  typedef typename Front_type<Traits, Concurrency_tag>::type Front;

public:
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Face_consumer<FT, typename Team_of<Concurrency_tag>::Type> Consumer;

  Wavefront(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Traits& traits, const FT& maximum_distance,
            bool keep_lists, bool consumer_reads_lists, Geodesic_field<FT>& field,
            const Merging_tolerance<FT>& tolerance = Merging_tolerance<FT>())
    : m_mesh(mesh), m_keep(keep_lists), m_partition(mesh, !tolerance.is_zero()),
      m_state(mesh, maximum_distance, keep_lists || consumer_reads_lists, field, m_partition.parts()),
      m_start_values(initial.start_values), m_finalizer(m_state), m_spreading(m_state, initial, traits),
      m_groups(groups(mesh, initial, keep_lists)), m_front(m_state, m_groups, traits, tolerance)
  {
    m_state.field.lists.set_number_of_primitives(initial.primitives.size());
    m_state.starts_ties = tolerance.is_zero();
  }

  // Propagates from the source primitives with numbers of at least `first_primitive`. Known distances stay unless a shorter path
  // is found.
  //
  // goes_on(distance, faces) is called periodically when all points up to `distance` are final; `faces` is the number of
  // finalized faces. If it returns false, `distance` becomes the distance limit.
  template <class Condition>
  void run(Consumer& consumer, const Condition& goes_on, Index first_primitive = 0)
  {
    m_is_update = first_primitive > 0;
    m_first_primitive = first_primitive;
    m_pacing.set_next(m_start_values.next(first_primitive, m_pacing.last()));
    m_state.field.maximum = m_state.maximum;
    std::size_t settled_bucket = 1, reported_bucket = 1;
    bool is_stopped = false;
    while (true)
    {
      start_sources();
      if (!m_front.advance() && !reveals_hidden_vertices() && !jumps_to_next_sources()) break;
      if (m_state.current() > reported_bucket)
      { // one bucket less: rounding may put a distance into the next bucket
        reported_bucket = m_state.current();
        const FT final_up_to = FT(double(reported_bucket - 1) * m_state.bucket_width());
        is_stopped = !goes_on(final_up_to, m_number_of_finalized);
        if (is_stopped)
        {
          m_state.maximum = (std::min)(m_state.maximum, final_up_to);
          m_state.field.maximum = m_state.maximum;
          break;
        }
      }
      if (consumer.reads_lists())
        if (const std::size_t oldest = m_state.pending_faces.oldest(m_state.current()); oldest > settled_bucket)
        { // one bucket less, likewise
          consumer.settled_up_to(FT(double(oldest - 1) * m_state.bucket_width()));
          settled_bucket = oldest;
        }
      m_front.finalize_faces(m_finalizer, m_finalized);
      if (consumer.reads_lists())
        if (m_state.current() > 1) hand_over_pending(consumer, (std::min)(m_state.maximum, settled_distance()));
      hand_over(consumer);
      reveal_vertices();
      m_front.process_bucket(m_spreading);
    }
    for_each_pending_face([this](Index f) { this->m_finalizer.finalize(f, this->m_finalized.faces); });
    if (consumer.reads_lists()) hand_over_pending(consumer, m_state.maximum);
    hand_over(consumer);
    const auto cut = [this](FT& d) {
      if (d > m_state.maximum) d = Number_policy<FT>::infinity();
    };
    if (m_state.has_marked_few() && !(m_is_update && is_stopped))
      for (const Index v : m_state.vertices) cut(m_state.field.distance[v]);
    else std::for_each(m_state.field.distance.begin(), m_state.field.distance.end(), cut);
  }

  Wavefront_counts counts() const { return m_state.counts(); }
  const auto& merging() const { return m_front.merging(); }
  Merging_counts merging_counts() const { return m_front.merging_counts(); }

  const FT& maximum() const { return m_state.maximum; }

  // The vertices whose distance may have changed; null if they are many.
  const std::vector<Index>* changed_vertices() const { return m_state.has_marked_few() ? &m_state.vertices : nullptr; }

  FT largest_distance(Index f) const { return m_state.largest_distance(f); }

private:
  static std::vector<Index> groups(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, bool keep_lists)
  {
    CGAL_precondition(Traits::may_keep_windows || !keep_lists);
    if constexpr (Traits::may_keep_windows)
      if (keep_lists ||
          std::any_of(initial.primitives.begin(), initial.primitives.end(), [](const auto& p) { return p.varies; }))
        return merging_groups(mesh, initial);
    return initial.source_of;
  }

  // Calls f for each pending face, in increasing order.
  template <class Function>
  void for_each_pending_face(const Function& function)
  {
    const auto visit = [&](Index f) {
      if (!m_finalizer.is_finalized(f) && (m_is_update ? m_state.face_state[f] != 0 : is_reached(f, m_state.maximum)))
        function(f);
    };
    if (m_state.has_marked_few())
      for (const Index f : marked_faces()) visit(f);
    else
      for (Index f = 0; f < m_mesh.number_of_faces(); ++f) visit(f);
  }

  // The faces with marks, and those around the vertices with marks. Precondition: they are few.
  std::vector<Index> marked_faces() const
  {
    std::vector<Index> result = m_state.faces;
    for (const Index v : m_state.vertices)
      for (const Index f : faces_of(m_mesh, Surface_point<FT>::at_vertex(v))) result.push_back(f);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  // Starts the sources with start values not far beyond the front.
  void start_sources()
  {
    const FT last_started = m_pacing.last();
    if (!m_pacing.has_next(m_state.maximum) || !m_pacing.advance(m_state, m_mesh.longest_edge())) return;
    m_front.refresh_all_parts();
    m_state.pending_faces.oldest(m_state.current()); // drops the counts of the buckets before, which are empty
    m_spreading.start(m_first_primitive, last_started, m_pacing.last());
    m_front.refresh_all_parts();
    m_pacing.set_next(m_start_values.next(m_first_primitive, m_pacing.last()));
  }

  // Called when the queues are empty: moves to the sources with the next start value. Returns false if there are none.
  bool jumps_to_next_sources()
  {
    if (!m_pacing.has_next(m_state.maximum)) return false;
    m_state.jump_to((std::max)(m_state.bucket_of(m_pacing.next()), m_state.current()));
    m_front.refresh_all_parts();
    return true;
  }

  // Called when the queues are empty: finds hidden vertices, gives them the shorter distances along edges, and queues them.
  // Returns true if there are any.
  bool reveals_hidden_vertices()
  {
    for_each_pending_face([this](Index f) { this->m_finalizer.finds_hidden(f, this->m_finalized.hidden); });
    return reveal_vertices();
  }

  bool reveal_vertices()
  {
    if (m_finalized.hidden.empty()) return false;
    for (Index h : m_finalized.hidden) m_state.reveal_vertex(h);
    m_finalized.hidden.clear();
    m_front.refresh_all_parts();
    return true;
  }

  // True if the front has reached a face, or the distance of one of its corners is at most `distance`. False for a number
  // without a face.
  bool is_reached(Index f, const FT& distance) const
  {
    if (m_mesh.source(3 * f) == no_index) return false;
    if (m_state.face_state[f]) return true;
    for (Index k = 0; k < 3; ++k)
      if (m_state.field.distance[m_mesh.source(3 * f + k)] <= distance) return true;
    return false;
  }

  void hand_over(Consumer& consumer)
  {
    const std::vector<Index>& faces = m_finalized.faces;
    if (faces.empty()) return;
    auto&& team = m_front.team();
    consumer.process_finalized(faces, team);
    if constexpr (Traits::may_keep_windows)
      if (m_keep) m_state.field.kept.keep(faces, m_state.field.lists, m_state.field.distance, m_mesh, team);
    m_front.release(faces);
    m_number_of_finalized += faces.size();
    m_finalized.faces.clear();
  }

  // Margin of a settled distance, as a fraction of it: far above the relative rounding error of distances, which is at most
  // 2^-43, so that rounding does not change which faces are settled. A wider margin would only keep more levels in memory.
  static constexpr double settling_margin = 0x1p-20;

  // The largest distance known to be final: the end of the last processed bucket, as a face is finalized two buckets after its
  // largest distance (Wavefront_state::postpone()), less the smaller of the settling margin and one bucket.
  FT settled_distance() const
  {
    const double end = double(m_state.current() - 1) * m_state.bucket_width();
    return FT((std::max)(end * (1 - settling_margin), end - m_state.bucket_width()));
  }

  // Passes pending faces to the consumer if it needs them: faces with points up to `settled` that have not been handed over. Does
  // nothing if such a face has a hidden vertex, nor in an update, which hands over only the faces that it improves.
  void hand_over_pending(Consumer& consumer, const FT& settled)
  {
    const std::size_t number = m_state.pending_faces.number() + m_finalized.faces.size();
    if (m_is_update || !consumer.needs_pending_faces(settled, number, m_finalized.faces)) return;
    std::vector<Index> faces = m_finalized.faces;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
    {
      if (m_finalizer.is_finalized(f) || !is_reached(f, settled)) continue;
      if (m_finalizer.hides_vertex(f, settled)) return;
      faces.push_back(f);
    }
    auto&& team = m_front.team();
    consumer.process_pending(faces, settled, team);
  }

  const Unfolded_mesh<FT>& m_mesh;
  const bool m_keep;
  const typename Front::Partition m_partition;
  State m_state;
  const Start_values<FT>& m_start_values;
  const Face_finalizer<FT> m_finalizer;
  Ray_spreading<Traits> m_spreading;
  const std::vector<Index> m_groups; // per primitive, its group: only windows of one group may be merged
  Front m_front;
  Finalized_faces m_finalized; // not yet passed to the consumer
  bool m_is_update = false;
  Index m_first_primitive = 0;
  Source_pacing<FT> m_pacing;
  std::size_t m_number_of_finalized = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
