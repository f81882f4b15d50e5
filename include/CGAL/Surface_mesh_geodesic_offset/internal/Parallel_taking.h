// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front on several threads, in rounds: all halfedges that wait in the bucket are taken at one time. In the first phase
// each is reduced to its lower envelope and propagated, on the distances of the vertices as they are at the beginning of the
// round, by any thread; in the second phase one thread applies what has come of it, in the order of the round. So the result
// depends neither on the number of threads nor on which of them does what.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PARALLEL_TAKING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_PARALLEL_TAKING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/Halfedge_taking.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Waiting_blocks.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/Worker_team.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Halfedge_taking<Traits, Parallel_tag>
{
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Window_block<Window> Block;
  typedef typename Batch_propagation<Traits>::Arrival Arrival;
  typedef typename Wavefront_state<FT>::Output Output;
  typedef typename Waiting_blocks<FT>::Blocks Blocks;

public:
  Halfedge_taking(Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                  const Merging_tolerance<FT>& tolerance)
    : m_state(state), m_team(Worker_team::possible_size())
  {
    m_state.field.lists.set_number_of_arenas(m_team.size());
    for (unsigned i = 0; i < m_team.size(); ++i)
      m_workers.push_back(std::make_unique<Worker>(state, source_of, traits, tolerance, m_state.field.lists.arena(i)));
  }

  // Works on all that waits in the bucket: the halfedges, if there are any, else the vertices.
  void step(Ray_spreading<Traits>& spreading)
  {
    if (m_state.queue.pop_halfedges(m_queued))
    {
      collect();
      propagate();
      apply();
      return;
    }
    Index v;
    while (m_state.queue.pop_vertex(v)) spreading.spread_from_pseudo_source(v);
  }

  // Gives the list of a halfedge up. Its memory is released in the next round.
  void release(Index h)
  {
    if (m_state.field.lists.has(h)) m_given_up.push_back(m_state.field.lists.detach(h));
  }

  const Window_merging<FT>& merging() const { return m_workers.front()->batch.merging(); }
  Merging_counts merging_counts() const
  {
    Merging_counts counts;
    for (const auto& w : m_workers) counts.add(w->batch.merging().counts());
    return counts;
  }

private:
  // Windows on their way to a halfedge.
  struct Way
  {
    Block block;
    Index halfedge;
    std::size_t bucket;
  };

  // What comes of a halfedge.
  struct Result
  {
    Index halfedge;
    Window_list<FT>* list;
    Blocks* waiting;
    std::ptrdiff_t more_windows;
    std::size_t number_of_windows;
    Way left, right;
    unsigned worker;
    Index apex, first_arrival, end_of_arrivals;
  };

  // What each thread has for itself. The halfedges that it works on are its own during a round.
  struct alignas(64) Worker
  {
    Worker(const Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
           const Merging_tolerance<FT>& tolerance, Window_arena<Window>& arena)
      : queue(state.queue), batch(state, source_of, traits, tolerance), arena(arena)
    {
    }

    void take(Result& r)
    {
      Window_list<FT>& list = *r.list;
      std::size_t n = list.size;
      if (r.waiting && r.waiting->number > 0)
      {
        n += r.waiting->number_of_windows();
        reserve(list, n);
        r.waiting->copy_to(list.data + list.size);
      }
      const std::vector<Window>& envelope =
        batch(r.halfedge, list.data, list.data + list.taken, list.data + n, list.split_distance, list.split_entry);
      list.size = 0;
      reserve(list, envelope.size());
      std::copy(envelope.begin(), envelope.end(), list.data);
      list.size = list.taken = Index(envelope.size());
      if (r.waiting) r.waiting->release(arena);
      const auto& propagated = batch.propagated();
      r.more_windows = std::ptrdiff_t(envelope.size()) - std::ptrdiff_t(n);
      r.number_of_windows = propagated.number_of_windows();
      r.apex = propagated.apex();
      r.first_arrival = Index(arrivals.size());
      arrivals.insert(arrivals.end(), propagated.arrivals().begin(), propagated.arrivals().end());
      r.end_of_arrivals = Index(arrivals.size());
      write(propagated.left(), r.left);
      write(propagated.right(), r.right);
    }

    void reserve(Window_list<FT>& list, std::size_t n)
    {
      if (list.data && n <= Window_arena<Window>::capacity(list.size_class)) return;
      const Block old{list.data, list.size, list.size_class};
      list.size_class = Window_arena<Window>::size_class(n, list.size_class);
      list.data = arena.allocate(list.size_class);
      if (!old.data) return;
      std::copy(old.data, old.data + old.size, list.data);
      arena.release(old.data, old.size_class);
    }

    void release(Window_list<FT>& list, Blocks* waiting)
    {
      if (list.data) arena.release(list.data, list.size_class);
      released_windows += list.size;
      if (!waiting) return;
      released_windows += waiting->number_of_windows();
      waiting->release(arena);
    }

    void write(const Output& output, Way& way)
    {
      way.block = Block();
      if (output.size() == 0) return;
      way.block = Block::copy(arena, output.begin(), output.size());
      way.halfedge = output.halfedge();
      way.bucket = queue.bucket_of(output.nearest());
    }

    const Bucket_queue& queue;
    Halfedge_batch<Traits> batch;
    Window_arena<Window>& arena;
    std::vector<Arrival> arrivals;
    std::size_t released_windows = 0;
  };

  // The halfedges of the round, each once.
  void collect()
  {
    Window_lists<FT>& lists = m_state.field.lists;
    m_results.clear();
    std::size_t number_of_windows = 0;
    for (const Index h : m_queued)
    {
      if (!lists.has(h)) continue;
      auto& list = lists.get(h);
      if (list.bucket != m_state.queue.current()) continue;
      Blocks* const waiting = m_waiting.find(lists.place(h));
      if (list.taken == list.size && !(waiting && waiting->number > 0)) continue;
      list.bucket = Window_list<FT>::not_queued;
      number_of_windows += list.size - list.taken;
      m_results.emplace_back();
      m_results.back().halfedge = h;
      m_results.back().list = &list;
      m_results.back().waiting = waiting;
    }
    m_is_worth_help = number_of_windows >= least_for_help;
  }

  // The first phase: halfedges, and lists that were given up.
  void propagate()
  {
    Window_lists<FT>& lists = m_state.field.lists;
    for (auto& w : m_workers) w->arrivals.clear();
    const Index n = Index(m_results.size()), n_given_up = Index(m_given_up.size());
    const auto work = [this, &lists, n, n_given_up](unsigned worker, Index first, Index last) {
      Worker& w = *m_workers[worker];
      for (Index i = first; i < last && i < n; ++i)
      {
        if (i + 1 < last && i + 1 < n) prefetch(m_results[i + 1]);
        m_results[i].worker = worker;
        w.take(m_results[i]);
      }
      const Index end = last > n ? (std::min)(n_given_up, (last - n) * at_one_time) : 0;
      for (Index k = first > n ? (first - n) * at_one_time : 0; k < end; ++k)
        w.release(lists.at(m_given_up[k]), m_waiting.find(m_given_up[k]));
    };
    m_team.for_each(n + (n_given_up + at_one_time - 1) / at_one_time, m_is_worth_help, work);
    lists.release_places(m_given_up);
    lists.balance_arenas();
    m_given_up.clear();
    for (auto& w : m_workers)
    {
      lists.count(-std::ptrdiff_t(w->released_windows));
      w->released_windows = 0;
    }
  }

  static void prefetch(const Result& r)
  {
    Window_lists<FT>::prefetch(r.list->data, r.list->size);
    if (!r.waiting) return;
    for (Index i = 0; i < r.waiting->number; ++i)
      Window_lists<FT>::prefetch(r.waiting->block[i].data, r.waiting->block[i].size);
  }

  // The second phase.
  void apply()
  {
    const Window_lists<FT>& lists = m_state.field.lists;
    const std::size_t n = m_results.size();
    for (std::size_t i = 0; i < n; ++i)
    {
      if (i + 8 < n)
        for (const Way* way : {&m_results[i + 8].left, &m_results[i + 8].right})
          if (way->block.size > 0) lists.prefetch_place(way->halfedge);
      if (i + 4 < n)
        for (const Way* way : {&m_results[i + 4].left, &m_results[i + 4].right})
          if (way->block.size > 0)
          {
            lists.prefetch_head(way->halfedge);
            m_waiting.prefetch(lists.place(way->halfedge));
          }
      apply(m_results[i]);
    }
  }

  void apply(const Result& r)
  {
    m_state.field.lists.count(r.more_windows);
    m_state.schedule(m_state.mesh.face(r.halfedge));
    m_state.counts.windows_propagated += r.number_of_windows;
    const std::vector<Arrival>& arrivals = m_workers[r.worker]->arrivals;
    for (Index i = r.first_arrival; i < r.end_of_arrivals; ++i)
    {
      const Arrival& a = arrivals[i];
      m_state.update_vertex(r.apex, a.distance, a.back, a.root, a.pseudo_source, a.is_bent);
    }
    append(r.left);
    append(r.right);
  }

  void append(const Way& way)
  {
    if (way.block.size == 0) return;
    Window_lists<FT>& lists = m_state.field.lists;
    auto& list = m_state.field.list(way.halfedge);
    m_waiting.add(lists, list, lists.place(way.halfedge), way.block);
    m_state.counts.windows_created += way.block.size;
    m_state.enqueue(way.halfedge, list, way.bucket);
  }

  // Rounds of less windows take less time than other threads need to notice them.
  static constexpr std::size_t least_for_help = 64;
  static constexpr Index at_one_time = 32; // lists that are given up

  Wavefront_state<FT>& m_state;
  Worker_team m_team;
  Waiting_blocks<FT> m_waiting;
  std::vector<std::unique_ptr<Worker>> m_workers;
  std::vector<Index> m_queued;
  std::vector<Index> m_given_up; // places of lists
  std::vector<Result> m_results; // in the order of the round
  bool m_is_worth_help = false;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
