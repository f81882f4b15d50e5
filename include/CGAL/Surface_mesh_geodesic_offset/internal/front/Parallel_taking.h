// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front on several threads, in rounds: all halfedges that wait in the bucket are taken at one time. The front is divided
// into parts, always equally many. In the first phase of a round, any thread propagates the windows of the halfedges of a
// part, on the distances of the vertices as they are at the beginning of the round; in the second phase any thread takes in
// what has come for a part. So the result depends neither on the number of threads nor on which of them does what.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PARALLEL_TAKING_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PARALLEL_TAKING_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_mail.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Halfedge_taking.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Worker_team.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

template <class Traits>
class Halfedge_taking<Traits, Parallel_tag>
{
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef Window_arena<Window> Arena;
  typedef typename Wavefront_state<FT>::Part State_part;

public:
  Halfedge_taking(Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                  const Merging_tolerance<FT>& tolerance)
    : m_state(state), m_team((std::min)(Worker_team::possible_size(), unsigned(state.parts.number()))),
      m_part(state.parts.number(), Part(state)), m_told(m_part.size())
  {
    m_state.field.lists.set_number_of_arenas(m_team.size());
    for (unsigned i = 0; i < m_team.size(); ++i)
      m_batches.push_back(std::make_unique<Halfedge_batch<Traits>>(state, source_of, traits, tolerance));
  }

  // Enough for threads to find work, few enough for what they tell each other to stay in the caches.
  static Front_parts parts() { return Front_parts(8); }

  // Looks at the faces of the bucket; those that the front has passed are added to `passed`.
  void pass_faces(const Face_passing<FT>& passing, Passed_faces& passed)
  {
    const std::size_t n = count([](const Bucket_queue& q) { return q.number_of_faces(); });
    if (n == 0) return;
    for_each_part(n >= 64, [this, &passing](unsigned, Index i) { passing.look(i, this->m_part[i].passed); });
    for (Part& p : m_part) passed.append(p.passed);
  }

  // Gives up the lists of faces that the front has passed, in the next round.
  void release(const std::vector<Index>& faces)
  {
    for (Index f : faces) m_part[m_state.parts.of_face(f)].given_up.push_back(f);
  }

  // Works on all halfedges and vertices of the bucket, in rounds of what waits there: the halfedges, if there are any, else
  // the vertices.
  void take_all(const Ray_spreading<Traits>& spreading)
  {
    while (true)
    {
      const std::size_t halfedges = count([](const Bucket_queue& q) { return q.number_of_halfedges(); });
      const std::size_t vertices = halfedges > 0 ? 0 : count([](const Bucket_queue& q) { return q.number_of_vertices(); });
      if (halfedges + vertices == 0) return;
      // rounds of less work take less time than other threads need to notice them
      const bool is_worth_help = halfedges > 0 ? halfedges >= 8 : vertices >= 16;
      std::fill(m_told.begin(), m_told.end(), 0); // who takes no turn tells nobody anything
      for_each_part(is_worth_help, [this, &spreading, halfedges](unsigned worker, Index i) {
        this->give_up(i, worker);
        if (halfedges > 0) this->take_halfedges(i, worker);
        else this->spread(i, spreading);
        this->m_told[i] = this->m_part[i].sender.take_told();
      });
      find_receivers();
      for_each_part(is_worth_help, [this](unsigned worker, Index i) { this->receive(i, worker); });
      m_state.field.lists.look_for_peak();
      if ((++m_rounds & 15u) == 0) m_state.field.lists.balance_arenas();
    }
  }

  const Window_merging<FT>& merging() const { return m_batches.front()->merging(); }
  Merging_counts merging_counts() const
  {
    Merging_counts counts;
    for (const auto& b : m_batches) counts.add(b->merging().counts());
    return counts;
  }

private:
  // What a part has for itself, beside its share of the state.
  struct alignas(64) Part
  {
    explicit Part(const Wavefront_state<FT>& state) : sender(state) {}

    Front_sender<FT> sender;
    Passed_faces passed;
    std::vector<Index> given_up; // faces
  };

  // How many things wait in all parts. Those parts take turns in which something waits, or which have faces to give up. The
  // team begins with the last parts in the order, those with the most work, so that all threads end at about the same time.
  template <class Number>
  std::size_t count(const Number& number)
  {
    std::size_t sum = 0;
    m_order.clear();
    for (Index i = 0; i < m_part.size(); ++i)
    {
      const std::size_t n = number(m_state.part(i).queue);
      sum += n;
      if (n > 0 || !m_part[i].given_up.empty()) m_order.emplace_back(n, i);
    }
    std::sort(m_order.begin(), m_order.end());
    return sum;
  }

  // Now those take turns that were told something.
  void find_receivers()
  {
    Index told = 0;
    for (Index t : m_told) told |= t;
    m_order.clear();
    for (Index i = 0; i < m_part.size(); ++i)
      if (told >> i & 1u) m_order.emplace_back(0, i);
  }

  template <class Function>
  void for_each_part(bool is_worth_help, const Function& f)
  {
    m_team.for_each(Index(m_order.size()), is_worth_help, [this, &f](unsigned worker, Index first, Index last) {
      for (Index i = last; i > first; --i) f(worker, this->m_order[i - 1].second);
    });
  }

  // The first phase.
  void give_up(Index part, unsigned worker)
  {
    Window_lists<FT>& lists = m_state.field.lists;
    lists.release_faces(m_part[part].given_up, lists.arena(worker));
    m_part[part].given_up.clear();
  }

  void take_halfedges(Index part, unsigned worker)
  {
    Bucket_queue& queue = m_state.part(part).queue;
    Index h;
    while (m_state.pop_halfedge(queue, h))
      take(h, m_part[part], m_state.part(part), *m_batches[worker], m_state.field.lists.arena(worker));
  }

  void take(Index h, Part& part, State_part& state_part, Halfedge_batch<Traits>& batch, Arena& arena)
  {
    Window_lists<FT>& lists = m_state.field.lists;
    Window_list<FT>* const known = lists.find(h);
    if (!known) return;
    Window_list<FT>& list = *known;
    if (list.bucket != state_part.queue.current() || !list.has_new()) return;
    list.bucket = Window_list<FT>::not_queued;
    if (const std::vector<Window>* const envelope = batch(h, list)) lists.assign(h, list, *envelope, arena);
    list.taken = list.size;
    const auto& propagated = batch.propagated();
    state_part.counts.windows_propagated += propagated.number_of_windows();
    part.sender.schedule(m_state.mesh.face(h));
    for (const auto& a : propagated.arrivals())
      part.sender.update_vertex(propagated.apex(), a);
    part.sender.append(propagated.left(), arena);
    part.sender.append(propagated.right(), arena);
  }

  void spread(Index part, const Ray_spreading<Traits>& spreading)
  {
    Bucket_queue& queue = m_state.part(part).queue;
    Index v;
    while (queue.pop_vertex(v)) spreading.spread_from_pseudo_source(v, m_part[part].sender);
  }

  // The second phase: what all parts have told this one.
  void receive(Index part, unsigned worker)
  {
    Arena& arena = m_state.field.lists.arena(worker);
    for (Index i = 0; i < m_part.size(); ++i)
    {
      if (!(m_told[i] >> part & 1u)) continue;
      Front_box<FT>& box = m_part[i].sender.box_for(part);
      for (Index f : box.faces) m_state.schedule(f);
      for (const auto& [vertex, arrival] : box.arrivals) m_state.update_vertex(vertex, arrival);
      for (const auto& w : box.windows) append(w, arena);
      for (const auto& w : box.single_windows) append(w, arena);
      box.clear();
    }
  }

  void append(const typename Front_box<FT>::Windows& w, Arena& arena)
  {
    Window_list<FT>& list = m_state.field.list(w.halfedge, arena);
    m_state.field.lists.append(w.halfedge, list, w.block, arena);
    m_state.enqueue(w.halfedge, list, w.block.size, w.nearest);
  }

  void append(const typename Front_box<FT>::Single_window& w, Arena& arena)
  {
    Window_list<FT>& list = m_state.field.list(w.halfedge, arena);
    m_state.field.lists.append(w.halfedge, list, &w.window, 1, arena);
    m_state.enqueue(w.halfedge, list, 1, minimum(w.window));
  }

  Wavefront_state<FT>& m_state;
  Worker_team m_team;
  std::vector<Part> m_part;
  std::vector<std::pair<std::size_t, Index>> m_order; // the parts that take turns, behind how much work is in each, if known
  std::vector<Index> m_told; // which parts each has told something, by bits
  std::vector<std::unique_ptr<Halfedge_batch<Traits>>> m_batches; // of each thread
  unsigned m_rounds = 0;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
