// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Definitions for Geodesic_build.h.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_IMPL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_GEODESIC_BUILD_IMPL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Geodesic_build.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Farthest_point.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Wavefront.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Points_in_space.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Near_path.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_elements.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_suffix_cache.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/paths/Path_tracing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/seconds_since.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/sources/Source_set.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>

#include <CGAL/assertions.h>

#include <boost/container/small_vector.hpp>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Crossings as points in space, computed at once while the processor would wait for the next step of the walk.
template <class Kernel>
struct Passed_points : boost::container::small_vector<typename Kernel::Point_3, 128>
{
  explicit Passed_points(const Points_in_space<Kernel>& s) : space(s) {}

  // The first n points are known to be distinct, as a Strip_walk keeps away from vertices.
  void set_apart(std::size_t n) { m_apart = n; }

  void remove_repeated()
  {
    const auto first = this->begin() + std::ptrdiff_t(m_apart == 0 ? 0 : (std::min)(m_apart, this->size()) - 1);
    this->erase(std::unique(first, this->end()), this->end());
  }

  typename Kernel::Point_3 item(const Path_crossing<typename Kernel::FT>& c) const { return space.point(c); }

  const Points_in_space<Kernel>& space;

private:
  std::size_t m_apart = 0;
};

// Appends the points in space, including the end of each straight part, to a vector. Consecutive points equal up to rounding
// become one.
template <class Kernel>
class Path_points
{
public:
  typedef typename Kernel::FT FT;
  typedef typename Kernel::Point_3 Item;

  Path_points(const Points_in_space<Kernel>& space, std::vector<Item>& out) : m_space(space), m_out(out), m_passed(space) {}

  template <class P>
  void start(const P& p)
  {
    m_last = m_space.point(p);
    m_out.push_back(m_last);
  }
  Passed_points<Kernel>& passed() { return m_passed; }
  void end_part(const Suffix_end<FT>& end)
  {
    m_passed.push_back(m_space.point(end.point));
    m_passed.remove_repeated();
  }
  void append(const Item* q, const Item* last, const Suffix_end<FT>&)
  {
    if (q != last && *q == m_last) ++q;
    if (q == last) return;
    m_last = *(last - 1);
    m_out.insert(m_out.end(), q, last);
  }

private:
  const Points_in_space<Kernel>& m_space;
  std::vector<Item>& m_out;
  Item m_last; // last written item
  Passed_points<Kernel> m_passed;
};

// Searches finalized faces for the farthest point if requested, and passes them on.
template <class FT, class Team>
class Searching_consumer : public Face_consumer<FT, Team>
{
public:
  // search: null if there is none
  Searching_consumer(Farthest_point<FT>* search, Face_consumer<FT, Team>& consumer) : m_search(search), m_consumer(consumer) {}

  bool reads_lists() const override { return m_consumer.reads_lists(); }
  bool is_done() const override { return m_consumer.is_done(); }
  void process_finalized(const std::vector<Index>& faces, Team& team) override
  {
    if (m_search != nullptr) m_search->add(faces);
    m_consumer.process_finalized(faces, team);
  }
  void settled_up_to(const FT& distance) override { m_consumer.settled_up_to(distance); }
  bool needs_pending_faces(const FT& settled, std::size_t number, const std::vector<Index>& finalized) override
  {
    return m_consumer.needs_pending_faces(settled, number, finalized);
  }
  void process_pending(const std::vector<Index>& faces, const FT& settled, Team& team) override
  {
    m_consumer.process_pending(faces, settled, team);
  }

private:
  Farthest_point<FT>* m_search;
  Face_consumer<FT, Team>& m_consumer;
};

template <class Traits>
Geodesic_build<Traits>::Geodesic_build(const Unfolded_mesh<FT>& mesh, const Source_set<FT>& source_set,
                                       const Build_request<FT>& request, Geodesic_field<FT>&& memory)
  : sources(source_set), initial(sources.initial_windows(mesh)), maximum(request.maximum), kept(request.keeps_windows),
    field(std::move(memory)), suffixes(mesh.number_of_vertices()), suffixes_in_space(mesh.number_of_vertices()), m_mesh(mesh),
    m_request(request)
{
  field.keeps_memory = request.keeps_memory;
  field.clear(mesh, initial.start_values);
}

template <class Traits>
void Geodesic_build<Traits>::add_source(Index id, const Surface_point<FT>& p)
{
  CGAL_precondition(is_whole() && !is_approximate() && !kept && field.keeps_memory);
  sources.insert(id, {Source_set<FT>::POINT, {p}, {}, FT(0)});
  m_first_new = Index(initial.primitives.size());
  initial.local.clear();
  initial.edges.clear();
  initial.fans.clear();
  initial.seeds.clear();
  initial.set_start_value(FT(0));
  initial.add_point(id, p);
  initial.finish();
  field.set_start_values(initial.start_values);
  field.has_grown = true;
}

template <class Traits>
Geodesic_build<Traits>::Geodesic_build(const Geodesic_build& before, const Source_set<FT>& source_set,
                                       const Build_request<FT>& request)
  : sources(source_set), initial(sources.initial_windows(before.m_mesh)), maximum(request.maximum), kept(request.keeps_windows),
    suffixes(before.m_mesh.number_of_vertices()), suffixes_in_space(before.m_mesh.number_of_vertices()), m_mesh(before.m_mesh),
    m_request(request), m_first_new(Index(before.initial.primitives.size()))
{
  field.start_from(before.field, initial.start_values);
}

template <class Traits>
Geodesic_build<Traits>::~Geodesic_build() = default;

template <class Traits>
template <class Concurrency_tag, unsigned parts>
void Geodesic_build<Traits>::propagate(const Traits& traits)
{
  Face_consumer<FT, typename Concurrency<Concurrency_tag, FT>::Team::Type> consumer;
  run<Concurrency_tag, parts>(traits, consumer);
}

template <class Traits>
template <class Concurrency_tag, unsigned parts>
void Geodesic_build<Traits>::run(const Traits& traits, Consumer_of<Concurrency_tag>& consumer)
{
  const auto start = std::chrono::steady_clock::now();
  CGAL_precondition((parts & SEARCH) != 0 || !m_request.finds_farthest);
  if constexpr ((parts & SEARCH) != 0)
  {
    std::optional<Farthest_point<FT>> search;
    if (m_request.finds_farthest) search.emplace(m_mesh, initial, field);
    // An update passes on only the faces that it improves.
    const bool searches_on_the_way = search && m_first_new == 0;
    Searching_consumer<FT, typename Concurrency<Concurrency_tag, FT>::Team::Type> searching(
      searches_on_the_way ? &*search : nullptr, consumer);
    run_front<Concurrency_tag, parts & ~SEARCH>(traits, searching);
    if (search)
    {
      if (!searches_on_the_way) search->add_all();
      farthest = search->result();
      statistics.faces_searched = search->number_of_searched_faces();
    }
  }
  else run_front<Concurrency_tag, parts & ~SEARCH>(traits, consumer);
  statistics.kept_bytes = field.kept.bytes();
  statistics.propagation_seconds = seconds_since(start);
  if (!is_cancelled && m_request.goes_on) m_request.goes_on(1.);
  m_request.release_inputs();
}

template <class Traits>
template <class Concurrency_tag, unsigned parts>
void Geodesic_build<Traits>::run_front(const Traits& traits, Consumer_of<Concurrency_tag>& consumer)
{
  const std::size_t signs = Sign_decisions<FT>::all(), exact_signs = Sign_decisions<FT>::exact();
  typedef typename Concurrency<Concurrency_tag, FT>::Tag Tag;
  CGAL_precondition((parts & MERGING) != 0 || !is_approximate());
  const Front_traits<Traits, parts> front_traits(traits);
  Wavefront<Front_traits<Traits, parts>, Tag> front(m_mesh, initial, front_traits, maximum, kept, consumer.reads_lists(), field,
                                                    m_request.tolerance);
  std::size_t next_target = m_request.first_target;
  const auto goes_on = [&](const FT& distance, std::size_t passed) {
    const auto has_all = [&](const auto& targets) {
      while (next_target < targets.size() && is_final(front, targets[next_target], distance)) ++next_target;
      return !targets.empty() && next_target == targets.size();
    };
    has_all_targets = m_request.shared_targets ? has_all(*m_request.shared_targets) : has_all(m_request.targets);
    if (has_all_targets || consumer.is_done()) return false;
    is_cancelled = m_request.goes_on && !m_request.goes_on(double(passed) / double(m_mesh.number_of_faces()));
    return !is_cancelled;
  };
  front.run(consumer, goes_on, m_first_new);
  maximum = front.maximum();
  if constexpr ((parts & MERGING) != 0)
    if (front.merging().is_on()) take_errors(front.merging_counts());
  statistics.sign_decisions = Sign_decisions<FT>::all() - signs;
  statistics.exact_decisions = Sign_decisions<FT>::exact() - exact_signs;
  statistics.windows_created = front.counts().windows_created;
  statistics.windows_propagated = front.counts().windows_propagated;
  statistics.windows_peak = field.lists.peak();
  field.release_front();
  Near_path<FT>(m_mesh, initial, field, !is_approximate())
    .measure_vertices(m_first_new == 0 || field.has_grown ? front.changed_vertices() : nullptr,
                      field.has_grown ? m_first_new : 0, maximum, field.path_length);
}

// Stores the errors of merged windows. A merged window has no pseudo-source, so the backtrace ends at its image.
template <class Traits>
void Geodesic_build<Traits>::take_errors(const Merging_counts& counts)
{
  statistics.windows_merged = counts.windows_merged;
  statistics.error_bound = counts.error_bound;
  statistics.relative_error_bound = counts.relative_error_bound;
  field.error.resize(field.back.size());
  for (std::size_t v = 0; v < field.error.size(); ++v) field.error[v] = field.error_of_origin(field.back[v].pseudo_source);
  for (Backtrace<FT>& back : field.back)
    if (Merge_error_code::is_merged(back.pseudo_source)) back.pseudo_source = no_index;
}

// True if the distance of a point is final when the front is at a distance.
template <class Traits>
template <class Front>
bool Geodesic_build<Traits>::is_final(const Front& front, const Surface_point<FT>& p, const FT& distance) const
{
  if (p.kind == Surface_point<FT>::VERTEX)
  {
    bool result = field.distance[p.element] <= distance;
    if (p.is_any_copy) m_mesh.for_each_copy(p.element, [&](Index v) { result |= field.distance[v] <= distance; });
    return result;
  }
  return front.largest_distance(p.kind == Surface_point<FT>::EDGE ? m_mesh.face(p.element) : p.element) <= distance;
}

template <class Traits>
typename Traits::FT Geodesic_build<Traits>::distance(const Located_point<FT>& p) const
{
  const Near_path<FT> near(m_mesh, initial, field, !is_approximate());
  if (!field.keeps_memory) return near.distance(p, suffixes);
  const No_suffix_cache<FT> no_suffixes{}; // a cache has the size of the mesh
  return near.distance(p, no_suffixes);
}

template <class Traits>
Path_start<typename Traits::FT> Geodesic_build<Traits>::path_start(const Located_point<FT>& p) const
{
  const Path_start<FT> start = Near_path<FT>(m_mesh, initial, field, !is_approximate())(p, suffixes);
  return start.distance > maximum ? Path_start<FT>() : start;
}

template <class Traits>
Suffix_end<typename Traits::FT> Geodesic_build<Traits>::path_end(const Located_point<FT>& p, const Path_start<FT>& start) const
{
  No_path_output<FT> nothing;
  return Path_tracing<FT>(m_mesh, initial, field)(p, start, suffixes, nothing);
}

// Sources and sides tie on curves, at which rounding decides by which window a path starts, but its end decides the result. A
// point is on none of these curves, mostly, if all corners around it have the source and side of its window, unless the curve
// starts at a source in the faces of the point. Behind short segments, ties within rounding have an extent.
template <class Traits>
Source_ref Geodesic_build<Traits>::source_ref(const Located_point<FT>& p, const Path_start<FT>& start) const
{
  if (is_approximate()) return start.source_ref;
  return are_of_one_side(p, start) ? start.source_ref : path_end(p, start).source_ref;
}

// True if the corners of all faces of p have the source and side of its window, these are not of a short segment, and the path is
// longer than all edges of these faces.
template <class Traits>
bool Geodesic_build<Traits>::are_of_one_side(const Surface_point<FT>& p, const Path_start<FT>& start) const
{
  const Source_ref source_ref = start.source_ref;
  const FT size = start.length();
  const Index source = initial.source_of[source_ref.primitive()];
  const auto differs = [&](Index h) {
    const Source_ref other = field.source_ref[m_mesh.source(h)];
    return !(m_mesh[h].length < size) || !other.is_valid() || other.side() != source_ref.side() ||
           initial.source_of[other.primitive()] != source;
  };
  if (initial.primitives[source_ref.primitive()].is_short) return false;
  const std::vector<Index> faces = faces_of(m_mesh, p);
  return std::none_of(faces.begin(), faces.end(), [&](Index f) {
    return differs(3 * f) || differs(3 * f + 1) || differs(3 * f + 2);
  });
}

template <class Traits>
Suffix_end<typename Traits::FT> Geodesic_build<Traits>::trace_path(const Located_point<FT>& p, const Path_start<FT>& start,
                                                                   std::vector<Path_element<FT>>& path) const
{
  Path_elements<FT> elements(path);
  return Path_tracing<FT>(m_mesh, initial, field)(p, start, suffixes, elements);
}

template <class Traits>
template <class Kernel>
void Geodesic_build<Traits>::trace_path_in_space(const Located_point<FT>& p, const Path_start<FT>& start,
                                                 const Surface_points<Kernel>& surface_points,
                                                 std::vector<typename Kernel::Point_3>& path) const
{
  const Points_in_space<Kernel> space(m_mesh, surface_points);
  Path_points<Kernel> points(space, path);
  Path_tracing<FT>(m_mesh, initial, field)(p, start, suffixes_in_space, points);
}

template <class Traits>
std::optional<Farthest<typename Traits::FT>> Geodesic_build<Traits>::find_farthest() const
{
  Farthest_point<FT> search(m_mesh, initial, field);
  search.add_all();
  return search.result();
}

} // namespace CGAL::Geodesic_offset::internal

#endif
