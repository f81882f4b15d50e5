// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The order of the wavefront: buckets of equal width in distance. Within a bucket, faces come first, as the front finalizes
// them when it enters the bucket; then halfedges; then vertices, as a pseudo-source starts with its final distance.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_BUCKET_QUEUE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FRONT_BUCKET_QUEUE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Bucket_queue
{
public:
  struct Bucket
  {
    std::vector<Index> faces, halfedges, vertices;
    bool empty() const { return faces.empty() && halfedges.empty() && vertices.empty(); }
  };

  explicit Bucket_queue(double width) : m_width(width), m_scale(1 / width), m_ring(16), m_mask(m_ring.size() - 1)
  {
    CGAL_precondition(width > 0);
  }

  template <class FT>
  std::size_t bucket_of(const FT& distance) const
  {
    const double b = CGAL::to_double(distance) * m_scale;
    // the conversion to a signed integer is one instruction
    if (b < last_bucket) return b > 0 ? std::size_t(std::ptrdiff_t(b)) : 0;
    return std::size_t(Number_policy<FT>::is_finite(distance) ? last_bucket : bucket_of_infinity);
  }

  std::size_t current() const { return m_current; }
  double bucket_width() const { return m_width; }

  void push_halfedge(std::size_t bucket, Index h)
  {
    at(bucket).halfedges.push_back(h);
    ++m_events;
  }
  void push_vertex(std::size_t bucket, Index v)
  {
    at(bucket).vertices.push_back(v);
    ++m_events;
  }
  void push_face(std::size_t bucket, Index f) { at(bucket).faces.push_back(f); }

  // Advances to the next nonempty bucket. Returns false if no event is left that can move the front.
  bool advance()
  {
    if (!has_events()) return false;
    move_to(first());
    return true;
  }

  // The steps of advance(), for several queues that advance together: a test for events that can move the front; the first
  // nonempty bucket, `none` if all are empty; the move to a bucket, at or before that bucket.
  static constexpr std::size_t none = ~std::size_t(0);

  bool has_events() const { return m_events != 0; }

  std::size_t first() const
  {
    for (std::size_t i = 0; i < m_ring.size(); ++i)
      if (!m_ring[(m_begin + i) & m_mask].empty()) return m_current + i;
    return none;
  }

  void move_to(std::size_t bucket)
  {
    CGAL_precondition(bucket == m_current || (bucket > m_current && bucket <= first()));
    m_begin = (m_begin + (bucket - m_current)) & m_mask;
    m_current = bucket;
  }

  // Moves to a later bucket, however far ahead, and puts all faces into it. There must be no events.
  void jump_to(std::size_t bucket)
  {
    CGAL_precondition(!has_events() && bucket >= m_current);
    Bucket pending;
    for (Bucket& b : m_ring)
    {
      pending.faces.insert(pending.faces.end(), b.faces.begin(), b.faces.end());
      b.faces.clear();
    }
    m_current = bucket;
    m_ring[m_begin].faces = std::move(pending.faces);
  }

  // Number of elements in the current bucket.
  std::size_t number_of_faces() const { return m_ring[m_begin].faces.size(); }
  std::size_t number_of_halfedges() const { return m_ring[m_begin].halfedges.size(); }
  std::size_t number_of_vertices() const { return m_ring[m_begin].vertices.size(); }

  // The i-th next halfedge of the current bucket, if no other is added before; no_index if there is none.
  Index next_halfedge(std::size_t i = 0) const
  {
    const std::vector<Index>& h = m_ring[m_begin].halfedges;
    return i < h.size() ? h[h.size() - 1 - i] : no_index;
  }

  bool pop_face(Index& f) { return pop(&Bucket::faces, f); }
  bool pop_halfedge(Index& h) { return pop_event(&Bucket::halfedges, h); }
  bool pop_vertex(Index& v) { return pop_event(&Bucket::vertices, v); }

private:
  // The bucket of large finite distances, and that of an infinite one, which the front never reaches: it passes the last bucket
  // by a few only. Both are far below the largest number of type std::ptrdiff_t. Binding test: test_parallel.
  static constexpr double last_bucket = 0x1p61, bucket_of_infinity = 0x1p62;

  bool pop(std::vector<Index> Bucket::*items, Index& item)
  {
    std::vector<Index>& v = m_ring[m_begin].*items;
    if (v.empty()) return false;
    item = v.back();
    v.pop_back();
    return true;
  }

  bool pop_event(std::vector<Index> Bucket::*items, Index& item)
  {
    if (!pop(items, item)) return false;
    CGAL_assertion(m_events > 0);
    --m_events;
    return true;
  }

  Bucket& at(std::size_t bucket)
  {
    const std::size_t i = (std::max)(bucket, m_current) - m_current;
    if (BOOST_UNLIKELY(i > m_mask)) grow(i);
    return m_ring[(m_begin + i) & m_mask];
  }

  BOOST_NOINLINE void grow(std::size_t i)
  {
    std::size_t size = m_ring.size();
    while (size <= i) size *= 2;
    std::vector<Bucket> ring(size);
    for (std::size_t k = 0; k < m_ring.size(); ++k) ring[k] = std::move(m_ring[(m_begin + k) & m_mask]);
    m_begin = 0;
    m_ring.swap(ring);
    m_mask = size - 1;
    CGAL_postcondition(i < size && (size & (size - 1)) == 0);
  }

  double m_width, m_scale;
  std::size_t m_current = 0;
  std::size_t m_events = 0;   // pending halfedges and vertices
  std::vector<Bucket> m_ring; // size: a power of two; current bucket: m_begin
  std::size_t m_mask;         // size of the ring minus one
  std::size_t m_begin = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
