// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front on several threads, in rounds. The division of the mesh into parts is always the same. In a round, any thread works
// on a part: it reads the messages of the previous round, then processes all pending halfedges of the part's bucket like a
// sequential front, or spreads rays from its vertices. Distances at vertices shared by parts are those of the beginning of the
// round. So the result depends neither on the number of threads nor on their assignment to parts.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PARALLEL_FRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_PARALLEL_FRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_sender.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Front_partition.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Sequential_front.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Worker_team.h>

#include <CGAL/assertions.h>

#include <algorithm>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Traits>
class Parallel_front
{
  typedef typename Traits::FT FT;
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;
  typedef typename Window_lists<FT>::Arena Arena;
  typedef std::uint64_t Parts; // a set of parts, by bits

public:
  typedef Front_partition Partition;

  Parallel_front(Wavefront_state<FT>& state, const std::vector<Index>& source_of, const Traits& traits,
                 const Merging_tolerance<FT>& tolerance)
    : m_state(state), m_team((std::min)(Worker_team::possible_size(), unsigned(state.parts.number()))),
      m_waiting(state.parts.number())
  {
    for (Index i = 0; i < state.parts.number(); ++i) m_part.emplace_back(state, i);
    m_state.field.lists.set_number_of_arenas(m_team.size());
    for (unsigned i = 0; i < m_team.size(); ++i)
      m_batches.push_back(std::make_unique<Halfedge_batch<Traits>>(state, source_of, traits, tolerance));
  }

  // Advances to the next nonempty bucket. Returns false if no event is left that can move the front.
  bool advance()
  {
    bool is_left = Number_policy<FT>::is_finite(m_nearest_told);
    std::size_t next = first_message();
    for (const Waiting& w : m_waiting)
    {
      is_left |= w.has_events;
      next = (std::min)(next, w.first);
    }
    if (is_left) m_state.move_to((std::max)(next, m_state.current()));
    return is_left;
  }

  // Notifies the front of changes of the state from outside.
  void refresh_all_parts()
  {
    for (Index i = 0; i < m_part.size(); ++i) refresh_part(i);
  }

  // Examines the faces of the bucket. Appends finalized faces to `finalized`.
  void finalize_faces(const Face_finalizer<FT>& finalizer, Finalized_faces& finalized)
  {
    m_turns.clear();
    for (Index i = 0; i < m_part.size(); ++i)
      if (m_waiting[i].first <= m_state.current() || has_bit(m_recipients | m_gives_up, i)) m_turns.push_back({i, 1});
    m_gives_up = 0;
    round<&Bucket_queue::number_of_faces>(m_turns.size() >= worthwhile_faces, [this, &finalizer](unsigned, Index i) {
      finalizer.examine_bucket(i, this->m_part[i].finalized);
    });
    for (const Turn& t : m_turns) finalized.append(m_part[t.part].finalized);
  }

  // Releases the lists of finalized faces, in the next round.
  void release(const std::vector<Index>& faces)
  {
    for (Index f : faces)
    {
      const Index i = m_state.parts.of_face(f);
      m_part[i].given_up.push_back(f);
      m_gives_up |= bit(i);
    }
  }

  // Processes all halfedges and vertices of the bucket, in rounds: halfedges as long as any are pending, otherwise vertices.
  void process_bucket(const Ray_spreading<Traits>& spreading)
  {
    while (true)
    {
      // Updates of vertices must be read before a round in which rays start from vertices.
      const bool is_recipient = m_recipients != 0 && (m_tells_vertices || first_message() <= m_state.current());
      if (const std::size_t halfedges = find_turns(&Waiting::halfedges, m_pending); halfedges > 0 || is_recipient)
      {
        round<&Bucket_queue::number_of_halfedges>(halfedges >= worthwhile_halfedges, [this](unsigned worker, Index i) {
          this->process_halfedges(i, worker);
        });
        m_tells_vertices = false;
      }
      else if (const std::size_t vertices = find_turns(&Waiting::vertices, 0); vertices > 0)
      {
        round<&Bucket_queue::number_of_vertices>(vertices >= worthwhile_vertices, [this, &spreading](unsigned, Index i) {
          this->spread(i, spreading);
        });
        m_tells_vertices = true;
      }
      else break;
    }
    CGAL_postcondition(is_bucket_processed());
  }

  // The threads, free for other work between rounds.
  Worker_team& team() { return m_team; }

  const auto& merging() const { return m_batches.front()->merging(); }
  Merging_counts merging_counts() const
  {
    Merging_counts counts;
    for (const auto& b : m_batches) counts.add(b->merging().counts());
    return counts;
  }

private:
  // Least work of a round for several threads: parts with pending faces, halfedges, vertices. The wake-up of threads costs more
  // than smaller rounds.
  static constexpr std::size_t worthwhile_faces = 4, worthwhile_halfedges = 8, worthwhile_vertices = 16;

  // Data of a part beside its share of the state.
  struct alignas(64) Part
  {
    Part(Wavefront_state<FT>& state, Index part) : sender(state, part) {}

    Front_sender<FT> sender;
    Finalized_faces finalized;
    std::vector<Index> given_up; // faces
  };

  // Queue snapshot of a part after its last turn.
  struct alignas(64) Waiting
  {
    std::size_t first = Bucket_queue::none; // bucket
    std::ptrdiff_t windows = 0;             // in the lists of the part
    Index halfedges = 0, vertices = 0;      // in this bucket
    bool has_events = false;
    bool has_shared_arrivals = false;
    Parts recipients = 0; // recipients of its messages, and the number of their pending halfedges in this bucket
    Index pending = 0;
    FT nearest_told = Number_policy<FT>::infinity();
  };

  struct Turn
  {
    Index part;
    std::size_t work;
  };

  static Parts bit(Index i) { return Parts(1) << i; }
  static bool has_bit(Parts parts, Index i) { return parts >> i & 1u; }

  // Bucket of the nearest message.
  std::size_t first_message() const { return m_state.part(0).queue.bucket_of(m_nearest_told); }

  // Selects the parts with pending elements and the recipients, which have `pending` more in all. Returns the number of pending
  // elements.
  std::size_t find_turns(Index Waiting::*number, std::size_t pending)
  {
    m_turns.clear();
    std::size_t sum = pending;
    const std::size_t recipients = std::bitset<Front_partition::largest_number>(m_recipients).count();
    const std::size_t pending_for_each = recipients > 0 ? pending / recipients : 0;
    for (Index i = 0; i < m_part.size(); ++i)
    {
      const std::size_t n = m_waiting[i].*number;
      sum += n;
      if (has_bit(m_recipients, i)) m_turns.push_back({i, n + 1 + pending_for_each});
      else if (n > 0) m_turns.push_back({i, n + 1});
    }
    return sum;
  }

  // False if a part has elements left in this or an earlier bucket. No later round would process them, and the front would not end.
  bool is_bucket_processed() const
  {
    return std::all_of(m_waiting.begin(), m_waiting.end(), [this](const Waiting& w) { return w.first > m_state.current(); });
  }

  // Processes a part in a round: reads messages and releases lists before f, and takes the snapshot after it. f processes all
  // elements of the bucket that `number` counts.
  template <std::size_t (Bucket_queue::*number)() const, class Function>
  void take_turn(Index i, unsigned worker, const Function& f)
  {
    Part& part = m_part[i];
    m_state.awake_part(i);
    part.sender.begin(m_round);
    give_up(part, worker);
    receive(i, worker);
    f(worker, i);
    CGAL_postcondition((m_state.part(i).queue.*number)() == 0);
    refresh_part(i);
    Waiting& w = m_waiting[i];
    w.recipients = part.sender.recipients();
    w.pending = Index(part.sender.pending());
    w.nearest_told = part.sender.nearest();
    w.has_shared_arrivals = !part.sender.shared_updates().empty();
  }

  template <std::size_t (Bucket_queue::*number)() const, class Function>
  void round(bool is_worth_help, const Function& f)
  {
    ++m_round;
    m_team.for_each(
      Index(m_turns.size()), [this](Index k) { return this->m_turns[k].work; }, is_worth_help && m_turns.size() > 1,
      [this, &f](unsigned worker, Index k) { this->template take_turn<number>(this->m_turns[k].part, worker, f); });
    deliver();
    m_state.field.lists.note_number(number_of_windows());
    if ((m_round & 15u) == 0) m_state.field.lists.balance_arenas();
  }

  // After a round: finds the recipients, and updates shared vertices.
  void deliver()
  {
    m_recipients = 0;
    m_pending = 0;
    m_nearest_told = Number_policy<FT>::infinity();
    std::fill(m_senders.begin(), m_senders.end(), Parts(0));
    for (const Turn& t : m_turns)
    {
      const Waiting& w = m_waiting[t.part];
      m_recipients |= w.recipients;
      m_pending += w.pending;
      m_nearest_told = (std::min)(m_nearest_told, w.nearest_told);
      for_each_bit(w.recipients, [this, &t](Index i) { this->m_senders[i] |= bit(t.part); });
    }
    Parts changed = 0;
    for (const Turn& t : m_turns)
    {
      if (!m_waiting[t.part].has_shared_arrivals) continue;
      auto& updates = m_part[t.part].sender.shared_updates();
      for (const auto& [vertex, update] : updates)
      {
        m_state.update_vertex(vertex, update);
        changed |= bit(m_state.parts.of_vertex(vertex));
      }
      updates.clear();
    }
    for_each_bit(changed, [this](Index i) { this->refresh_part(i); });
  }

  // Updates the summary of the pending work of a part.
  void refresh_part(Index i)
  {
    const Bucket_queue& queue = m_state.awake_part(i).queue;
    Waiting& w = m_waiting[i];
    w.first = queue.first();
    w.has_events = queue.has_events();
    w.halfedges = Index(queue.number_of_halfedges());
    w.vertices = Index(queue.number_of_vertices());
    w.windows = m_state.field.lists.number_of_windows(i);
  }

  std::size_t number_of_windows() const
  {
    std::ptrdiff_t n = 0;
    for (const Waiting& w : m_waiting) n += w.windows;
    return std::size_t(n);
  }

  template <class Function>
  static void for_each_bit(Parts parts, const Function& f)
  {
    for (Index i = 0; parts != 0; ++i, parts >>= 1)
      if (parts & 1u) f(i);
  }

  void give_up(Part& part, unsigned worker)
  {
    Window_lists<FT>& lists = m_state.field.lists;
    lists.release_faces(part.given_up, lists.arena(worker));
    part.given_up.clear();
  }

  // Reads the messages of other parts from the previous round.
  void receive(Index part, unsigned worker)
  {
    Arena& arena = m_state.field.lists.arena(worker);
    for_each_bit(m_senders[part], [&](Index i) {
      Front_box<FT>& box = this->m_part[i].sender.box_for(part, this->m_round - 1);
      for (Index f : box.faces) this->m_state.schedule(f);
      for (const auto& [vertex, update] : box.updates) this->m_state.update_vertex(vertex, update);
      for (const auto& w : box.windows) this->append(w, arena);
      for (const auto& w : box.single_windows) this->append(w, arena);
      box.clear();
    });
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

  void process_halfedges(Index part, unsigned worker)
  {
    CGAL_precondition(m_state.is_awake(part));
    Bucket_queue& queue = m_state.part(part).queue;
    Index h;
    while (m_state.pop_halfedge(queue, h))
      process_halfedge(h, m_state, m_state.part(part), *m_batches[worker], m_state.field.lists.arena(worker),
                       m_part[part].sender);
  }

  void spread(Index part, const Ray_spreading<Traits>& spreading)
  {
    CGAL_precondition(m_state.is_awake(part));
    Bucket_queue& queue = m_state.part(part).queue;
    Index v;
    while (queue.pop_vertex(v)) spreading.spread_from_pseudo_source(v, m_part[part].sender);
  }

  Wavefront_state<FT>& m_state;
  Worker_team m_team;
  std::vector<Part> m_part;
  std::vector<Waiting> m_waiting;                                 // per part
  std::vector<Turn> m_turns;                                      // of the round, in the order of parts
  std::vector<std::unique_ptr<Halfedge_batch<Traits>>> m_batches; // per thread
  unsigned m_round = 0;
  // Of the previous round: recipients, the senders of each, pending halfedges of the recipients in this bucket, and the
  // smallest distance in the messages.
  Parts m_recipients = 0;
  std::vector<Parts> m_senders = std::vector<Parts>(Front_partition::largest_number, 0);
  std::size_t m_pending = 0;
  FT m_nearest_told = Number_policy<FT>::infinity();
  bool m_tells_vertices = false; // true if messages may have updates of vertices
  Parts m_gives_up = 0;          // parts with lists to release
};

} // namespace CGAL::Geodesic_offset::internal

#endif
