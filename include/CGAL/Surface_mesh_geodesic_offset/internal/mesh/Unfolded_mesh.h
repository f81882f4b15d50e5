// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Step 1 of the pipeline: the mesh as flat arrays, each face laid out in the plane.
//
// Halfedge 3f+k is the k-th halfedge of face f, starting at halfedge(f). Its frame has its origin at the source of the
// halfedge, its x axis along the halfedge, and the face above. Border halfedges have no index.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_UNFOLDED_MESH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/memory/prefetch.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Barriers.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_links.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Index_renumbering.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/assertions.h>

#include <boost/container/vector.hpp>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class FT>
struct Unfolded_halfedge
{
  FT length;
  FT apex_x, apex_y; // third vertex of the face, in the frame of this halfedge
  Index twin;        // no_index on the border
  Index origin;      // source vertex
};

// Direction at a vertex: a vector in the frame of an outgoing halfedge, inside the corner between this halfedge and the
// next one counterclockwise.
template <class FT>
struct Ray_at_vertex
{
  Index corner = no_index;
  FT x = FT(0), y = FT(0);
};

template <class FT_>
class Unfolded_mesh
{
public:
  typedef FT_ FT;
  typedef Unfolded_halfedge<FT> Halfedge;

  Unfolded_mesh() = default;

  // links: by mesh index of the face; face_at: mesh index of each face, out of range for unused indices; points: of the
  // vertices. `Team`: Single_worker or Worker_team.
  template <class Traits, class Team>
  Unfolded_mesh(const Index_renumbering& numbers, const All_face_links& links, const std::vector<Index>& face_at,
                const std::vector<typename Traits::Point_3>& points, const Traits& traits, Team& team);

  // From the lengths of the halfedges instead of points.
  template <class Team>
  Unfolded_mesh(const Index_renumbering& numbers, const All_face_links& links, const std::vector<Index>& face_at,
                std::size_t number_of_vertices, const std::vector<FT>& lengths, Team& team);

  // False if a face has no area (see has_area()); then the object must not be used.
  bool is_laid_out() const { return m_is_laid_out; }

  bool has_area(Index face) const;

  // Of one halfedge of a face.
  static bool has_area(const FT& length, const FT& apex_y)
  {
    return length > FT(0) && Number_policy<FT>::is_finite(length) && apex_y > FT(0);
  }

  // True if products of four lengths are within the range of the number type. Also true if the longest edge is zero or not
  // finite.
  bool has_usable_scale() const;

  std::size_t number_of_faces() const { return m_halfedges.size() / 3; }
  std::size_t number_of_halfedges() const { return m_halfedges.size(); }
  std::size_t number_of_vertices() const { return m_corner.size(); }

  const Halfedge& operator[](Index h) const
  {
    CGAL_precondition(h < m_halfedges.size());
    return m_halfedges[h];
  }

  // Prefetches the face of h.
  void prefetch_face(Index h) const
  {
    const Halfedge* const first = &m_halfedges[3 * face(h)];
    prefetch(first, 3 * sizeof(Halfedge));
    prefetch(&first[2].origin); // possibly in a further cache line
  }

  // Without comparisons: compilers make branches of them, which are unpredictable.
  static Index next(Index h) { return h + 1 - 3 * ((h % 3) >> 1); }
  static Index previous(Index h) { return h - 1 + 3 * ((2 - h % 3) >> 1); }
  static Index face(Index h) { return h / 3; }

  Index twin(Index h) const { return m_halfedges[h].twin; }
  Index source(Index h) const { return m_halfedges[h].origin; }
  Index target(Index h) const { return m_halfedges[next(h)].origin; }
  Index apex(Index h) const { return m_halfedges[previous(h)].origin; }

  // The next corner around the source counterclockwise or clockwise; a corner is the halfedge that leaves the vertex.
  Index corner_ccw(Index h) const { return twin(previous(h)); }
  Index corner_cw(Index h) const { return twin(h) == no_index ? no_index : next(twin(h)); }

  // First corner of the vertex: the most clockwise one on the border; no_index if the vertex is isolated.
  Index corner(Index v) const { return m_corner[v]; }

  // The most clockwise corner of the fan of c if the border bounds it; no_index for a closed fan.
  Index first_on_border(Index c) const
  {
    Index first = c;
    for (Index d = corner_cw(c); d != no_index; d = corner_cw(d))
    {
      if (d == c) return no_index;
      first = d;
    }
    return first;
  }

  // Calls f with the first corner of each fan; only a pinched vertex has several.
  template <class Function>
  void for_each_fan(Index v, const Function& f) const
  {
    if (m_corner[v] == no_index) return;
    f(m_corner[v]);
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    for (; it != m_more_fans.end() && it->first == v; ++it) f(it->second);
  }

  // True if f(corner) is true for a corner of a fan; visits corners counterclockwise and stops at the first success.
  template <class Function>
  bool any_corner(Index first, const Function& f) const
  {
    Index c = first;
    do {
      if (f(c)) return true;
      c = corner_ccw(c);
    } while (c != no_index && c != first);
    return false;
  }

  // True if shortest paths can bend at the vertex: true for saddle vertices (total angle above 2 pi), border vertices with
  // an inner angle above pi, and pinched vertices.
  bool can_be_pseudo_source(Index v) const { return m_can_bend[v] != 0; }

  bool has_several_fans(Index v) const
  {
    auto it = std::lower_bound(m_more_fans.begin(), m_more_fans.end(), std::make_pair(v, Index(0)));
    return it != m_more_fans.end() && it->first == v;
  }

  // The mesh is that of `whole` after a cut along barriers. Vertices and faces have the same numbers in both, but for copies.
  void set_barriers(Barriers barriers, Unfolded_mesh whole)
  {
    m_cut = std::make_shared<const Cut>(Cut{std::move(barriers), std::move(whole)});
  }

  const Unfolded_mesh& without_barriers() const { return m_cut ? m_cut->whole : *this; }

  // The halfedge on the other side of a barrier; no_index for a halfedge that is on none.
  Index across_barrier(Index h) const { return m_cut ? m_cut->barriers.across(h) : no_index; }

  // Calls f with one halfedge of each barrier.
  template <class Function>
  void for_each_barrier(const Function& f) const
  {
    if (m_cut) m_cut->barriers.for_each_edge(f);
  }

  // The vertex of which v is a copy, or v itself.
  Index first_copy(Index v) const { return m_cut ? m_cut->barriers.first_copy(v) : v; }

  // Calls f for all copies of a vertex, which is the only one unless it is on a barrier.
  template <class Function>
  void for_each_copy(Index v, const Function& f) const
  {
    if (m_cut) m_cut->barriers.for_each_copy(v, f);
    else f(v);
  }

  const FT& longest_edge() const { return m_longest_edge; }

  double mean_edge_length() const { return m_mean_edge_length; }

  // Cosine and sine of the corner at the source of h.
  void corner_direction(Index h, FT& c, FT& s) const
  {
    const FT l = m_halfedges[previous(h)].length;
    c = m_halfedges[h].apex_x / l;
    s = m_halfedges[h].apex_y / l;
  }

private:
  struct Cut; // see set_barriers()

  // Summary of a block of faces.
  struct Laid_out_faces
  {
    bool have_area = true;
    FT longest_edge = FT(0);
    std::size_t number = 0;
  };

  template <class Layout, class Team>
  void lay_out(const Index_renumbering& numbers, const All_face_links& links, const std::vector<Index>& face_at,
               const Layout& layout, Team& team);

  // first_corners: initially no_index; receives the lowest corner at each vertex.
  template <class Layout, class Team, class First_corners>
  void set_up(const Index_renumbering& numbers, const All_face_links& links, const std::vector<Index>& face_at,
              const Layout& layout, Team& team, First_corners& first_corners);

  // True if halfedges are paired consistently: twins have opposite ends and equal lengths.
  bool has_consistent_twins() const;

  template <class Layout, class First_corners>
  Laid_out_faces lay_out_faces(std::size_t begin, std::size_t end, const Index_renumbering& numbers,
                               const All_face_links& links, const std::vector<Index>& face_at, const Layout& layout,
                               First_corners& first_corners, std::vector<double>& lengths);

  // Corners around a vertex, from border to border or all around.
  struct Fan
  {
    Index first; // most clockwise corner if there is a border
    Index size;
    bool bends; // shortest paths can bend at the vertex
  };

  // Returns the number of corners in the first fans.
  template <class First_corners, class Team>
  std::size_t find_corners(const First_corners& first, Team& team);

  void find_more_fans();

  // The product of the apices as complex numbers has the sum of the corner angles as its angle. Each corner angle is less
  // than pi, so each half turn changes the half-plane of the product. Its magnitude is irrelevant.
  Fan fan_of(Index first) const;

  // Scales (x, y) such that its product with a length of usable scale does not overflow or underflow.
  static void keep_within_range(FT& x, FT& y);

  static constexpr double small_size() { return std::is_same<FT, float>::value ? 0x1p-32 : 0x1p-256; }

  boost::container::vector<Halfedge> m_halfedges;
  bool m_is_laid_out = true;
  FT m_longest_edge = FT(0);
  double m_mean_edge_length = 1;
  std::vector<Index> m_corner;
  std::vector<char> m_can_bend;
  std::vector<std::pair<Index, Index>> m_more_fans; // (vertex, first corner), sorted
  std::shared_ptr<const Cut> m_cut;                 // null without barriers
};

template <class FT>
struct Unfolded_mesh<FT>::Cut
{
  Barriers barriers;
  Unfolded_mesh whole;
};

} // namespace CGAL::Geodesic_offset::internal

#ifndef CGAL_GEODESIC_OFFSET_COMPILED
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh_impl.h>
#endif

#endif
