// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Interpretation of a concurrency tag: the team of workers, and the division of work into blocks.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WORKERS_CONCURRENCY_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_WORKERS_CONCURRENCY_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#ifdef CGAL_LINKED_WITH_TBB
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Worker_team.h>
#endif

#include <CGAL/tags.h>

#include <algorithm>
#include <cstddef>
#include <type_traits>

namespace CGAL::Geodesic_offset::internal {

// Team of the calling thread alone.
struct Single_worker
{
  static constexpr unsigned size() { return 1; }

  template <class Weight, class Function>
  void for_each(Index n, const Weight&, bool, const Function& f) const
  {
    for (Index i = 0; i < n; ++i) f(0u, i);
  }
};

template <class Concurrency_tag>
struct Team_of
{
  typedef Single_worker Type;
  static Type make() { return Type(); }
};

#ifdef CGAL_LINKED_WITH_TBB
template <>
struct Team_of<Parallel_tag>
{
  typedef Worker_team Type;
  static Type make() { return Type(Worker_team::possible_size()); }
};
#endif

// The effective tag for a number type: always sequential unless FT is a built-in floating point type, since numbers of
// other types may share memory.
template <class Concurrency_tag, class FT>
struct Concurrency
{
  static constexpr bool is_parallel = std::is_convertible<Concurrency_tag, Parallel_tag>::value;
#ifndef CGAL_LINKED_WITH_TBB
  static_assert(!is_parallel, "Parallel_tag is enabled but TBB is unavailable.");
#endif
  typedef std::conditional_t<is_parallel && std::is_floating_point<FT>::value, Parallel_tag, Sequential_tag> Tag;
  typedef Team_of<Tag> Team;
};

// Number of items per call of Team::for_each() if the results of each item are stored until the call returns.
inline std::size_t items_at_once(unsigned team_size)
{
  constexpr std::size_t by_each = 64, most = 1 << 12;
  return team_size == 1 ? 1 : (std::min)(by_each * team_size, most);
}

// Division of a range of items into blocks for a team; one block for a single worker.
class Blocks
{
public:
  static constexpr std::size_t step = 1 << 10; // block boundaries are multiples of it

  Blocks(std::size_t items, unsigned team_size)
    : m_items(items), m_size(team_size == 1 ? items : (items / (std::min)(by_each * team_size, most) / step + 1) * step)
  {
  }

  Index number() const { return m_items == 0 ? 0 : Index((m_items - 1) / m_size + 1); }

  // Calls f(block, begin, end) for each block, concurrently.
  template <class Team, class Function>
  void for_each(Team& team, const Function& f) const
  {
    team.for_each(
      number(), [](Index) { return std::size_t(1); }, number() > 1,
      [this, &f](unsigned, Index i) { f(i, m_size * i, (std::min)(m_size * (i + 1), m_items)); });
  }

private:
  static constexpr std::size_t by_each = 8, most = 1 << 12;

  std::size_t m_items, m_size;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
