// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The pieces of one level, and their curves. Chains of pieces run between gates, and the two faces of an edge share its gates.
// So chains are linked by the numbers of gates, never by proximity.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CURVES_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_OFFSETS_LEVEL_CURVES_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/curves/Level_piece.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Offset_tolerances.h>

#include <CGAL/assertions.h>

#include <cstddef>
#include <deque>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
class Level_curves
{
public:
  typedef Level_piece<FT> Piece;

  // Adds a gate, which a chain crosses in each of the two faces of its edge, or in one face on the border.
  Index new_gate(bool on_border)
  {
    m_link_at.push_back(no_index);
    if (!on_border) ++m_waiting;
    return Index(m_link_at.size() - 1);
  }

  // Records that the second face of a gate was cut.
  void gate_found()
  {
    CGAL_precondition(m_waiting > 0);
    --m_waiting;
  }

  // True if all faces of the known curves were cut.
  bool is_complete() const { return m_waiting == 0; }

  // Adds a chain of pieces between two gates; no_index for a loop.
  void add_chain(Index start, Index end, const Piece* begin_of_pieces, const Piece* end_of_pieces)
  {
    CGAL_precondition((start == no_index) == (end == no_index) && begin_of_pieces != end_of_pieces);
    CGAL_precondition(start == no_index || (start < m_link_at.size() && m_link_at[start] == no_index));
    const std::size_t first = m_pieces.size();
    for (const Piece* p = begin_of_pieces; p != end_of_pieces; ++p)
    {
      if (m_pieces.size() > first && continues(m_pieces.back(), *p))
      {
        m_pieces.back().end = p->end;
        m_pieces.back().end_edge = p->end_edge;
      }
      else m_pieces.push_back(*p);
    }
    if (start != no_index) m_link_at[start] = Index(m_links.size());
    m_links.push_back({start, end, Index(first), Index(m_pieces.size())});
  }

  // Connects two chains in the faces of an edge, from a gate where one ends to a gate where one starts, by a piece along the
  // edge with the source of the second chain, or by none. Precondition: both chains were added.
  void connect(Index from, Index to, const Piece* piece)
  {
    CGAL_precondition(m_link_at[from] == no_index && m_link_at[to] != no_index);
    const Index first = Index(m_pieces.size());
    if (piece)
    {
      const Piece& next = m_pieces[m_links[m_link_at[to]].first];
      m_pieces.push_back(*piece);
      m_pieces.back().source_ref = next.source_ref;
      m_pieces.back().pseudo_source = next.pseudo_source;
    }
    m_link_at[from] = Index(m_links.size());
    m_links.push_back({from, to, first, Index(m_pieces.size())});
    gate_found();
    gate_found();
  }

  // Calls out(closed, pieces) for each curve, first those that start on the border.
  template <class Function>
  void for_each_curve(const Function& out) const
  {
    std::vector<char> used(m_links.size(), 0), entered(m_link_at.size(), 0);
    for (const Link& l : m_links)
      if (l.end != no_index) entered[l.end] = 1;
    for (const bool open : {true, false})
      for (std::size_t i = 0; i < m_links.size(); ++i)
      {
        if (used[i] || (open && (m_links[i].start == no_index || entered[m_links[i].start]))) continue;
        std::size_t number = 0;
        std::vector<Index> order;
        for (Index j = Index(i); j != no_index && !used[j];
             j = m_links[j].end == no_index ? no_index : m_link_at[m_links[j].end])
        {
          used[j] = 1;
          order.push_back(j);
          number += m_links[j].last - m_links[j].first;
        }
        std::vector<Piece> pieces;
        pieces.reserve(number);
        for (const Index j : order)
          pieces.insert(pieces.end(), m_pieces.begin() + m_links[j].first, m_pieces.begin() + m_links[j].last);
        out(!open, std::move(pieces));
      }
  }

  std::size_t number_of_pieces() const { return m_pieces.size(); }

private:
  struct Link // a chain
  {
    Index start, end;  // gates
    Index first, last; // pieces
  };

  // Neighbouring pieces of one image form one arc while it is shorter than a half turn.
  static bool continues(const Piece& a, const Piece& b)
  {
    if (a.is_straight != b.is_straight || !(a.source_ref == b.source_ref) || a.pseudo_source != b.pseudo_source) return false;
    if (!a.is_straight && !CGAL::is_positive(cross(a.start - a.center, b.end - a.center))) return false;
    // the center of a straight piece is a unit vector
    const FT of_center = Offset_tolerances<FT>::same_image(
      a.is_straight ? FT(1) : FT(CGAL::abs(a.radius) + CGAL::abs(a.center.x) + CGAL::abs(a.center.y)));
    const FT of_radius =
      a.is_straight ? Offset_tolerances<FT>::same_image(CGAL::abs(a.radius) + CGAL::abs(a.end.x) + CGAL::abs(a.end.y))
                    : of_center;
    return CGAL::abs(a.radius - b.radius) <= of_radius && CGAL::abs(a.center.x - b.center.x) <= of_center &&
           CGAL::abs(a.center.y - b.center.y) <= of_center;
  }

  std::deque<Piece> m_pieces; // grows without copies
  std::vector<Link> m_links;
  std::vector<Index> m_link_at; // the chain that starts at a gate
  std::size_t m_waiting = 0;    // gates of which one face was cut so far
};

} // namespace CGAL::Geodesic_offset::internal

#endif
