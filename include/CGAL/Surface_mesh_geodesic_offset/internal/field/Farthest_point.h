// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The point of the surface farthest from the sources, by branch and bound over faces and over triangles in them. Faces come all
// at once, or in batches as the front finalizes them.
//
// The distance in a face is the minimum of convex path lengths. In a triangle it is at most the minimum of the linear functions
// with the same values at the corners. The maximum of this minimum is an upper bound whose error is quadratic in the size of
// the triangle, and the point that attains it is the next candidate. No case is special: the maximum may be at a vertex, on an
// edge, where three path lengths tie in a face, or all along a ridge.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FARTHEST_POINT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_FARTHEST_POINT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Face_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Max_min.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Search in one face after another. Keeps the farthest point.
template <class FT>
class Farthest_in_face
{
public:
  typedef Point_in_face<FT> Point;
  typedef Face_window<FT> Window;
  typedef Per_corner<FT> Row;

  explicit Farthest_in_face(const FT& distance) : m_best(distance) {}

  // Records a point at this distance.
  void raise(const FT& distance) { m_best = (std::max)(m_best, distance); }

  // Values up to the threshold equal the largest distance up to rounding. `size`: longest edge of the face.
  FT threshold(const FT& size) const { return m_best + allowance(size); }

  // Sets the face. Returns an upper bound of its distances. `farther`: result of search().
  FT start(const Per_corner<Point>& corners, const std::vector<Window>& windows, const FT& size, bool& farther)
  {
    m_corner = corners;
    m_windows = &windows;
    m_size = size;
    m_farther = false;
    m_heap.clear();
    m_candidates.clear();
    m_values.clear();
    for (std::size_t i = 0; i < windows.size(); ++i)
    {
      Row values;
      for (int k = 0; k < 3; ++k) values[k] = path_length(windows[i], corners[k]);
      m_candidates.push_back(Candidate{i, values});
      m_values.push_back(values[0]);
    }
    const FT one(1), zero(0);
    add(Triangle{{Row{one, zero, zero}, Row{zero, one, zero}, Row{zero, zero, one}}, 0, windows.size(), zero}, 0);
    farther = m_farther;
    return m_heap.empty() ? FT(0) : m_heap.front().bound;
  }

  // Returns true if the face has a point farther than the farthest point so far. Call start() before.
  bool search()
  {
    m_farther = false;
    for (int count = 0; count < maximum_count && !m_heap.empty(); ++count)
    {
      std::pop_heap(m_heap.begin(), m_heap.end());
      const Triangle t = m_heap.back();
      m_heap.pop_back();
      if (!(t.bound > threshold(m_size))) break;
      split(t);
    }
    return m_farther;
  }

  const Row& weights() const { return m_weights; } // barycentric coordinates of the farthest point in its face

private:
  // Limit of the triangles per face. Usually some fifty are split per face, one per bit of the distance; thousands in needles
  // with the maximum on an edge.
  static constexpr int maximum_count = 20000;

  // A window that may attain the distance in a triangle, and its path lengths at the corners.
  struct Candidate
  {
    std::size_t window;
    Row values;
  };

  struct Triangle
  {
    Per_corner<Row> corner;  // barycentric coordinates in the face
    std::size_t first, last; // in m_candidates
    FT bound;
    friend bool operator<(const Triangle& a, const Triangle& b) { return a.bound < b.bound; }
  };

  // The rounding error of a distance; faces may be much larger than their distances.
  FT allowance(const FT& size) const
  {
    return Number_policy<FT>::rounding(64) * m_best + Number_policy<FT>::rounding(4) * size;
  }

  // Position of the point with barycentric coordinates w, exact at the corners.
  Point position(const Row& w) const
  {
    for (int k = 0; k < 3; ++k)
      if (w[k] == FT(1)) return m_corner[k];
    return w[0] * m_corner[0] + (w[1] * m_corner[1] + w[2] * m_corner[2]);
  }

  // Path length, convex in the whole face: behind a source segment inside the face, that of its other side.
  static FT path_length(const Window& w, const Point& p)
  {
    return w.is_in_front(p) ? w.path_length(p) : w.path_length(p + FT(2) * (w.distance_at(p) - w.start_value) * w.image());
  }

  FT edge_length(const Triangle& t, int k) const { return length(position(t.corner[(k + 1) % 3]) - position(t.corner[k])); }

  // Splits a triangle at the middle of its longest edge.
  void split(const Triangle& t)
  {
    int k = 0;
    for (int i = 1; i < 3; ++i)
      if (edge_length(t, i) > edge_length(t, k)) k = i;
    const int l = (k + 1) % 3;
    Row middle;
    for (int i = 0; i < 3; ++i) middle[i] = (t.corner[k][i] + t.corner[l][i]) / FT(2);
    const Point p = position(middle);
    m_values.clear();
    for (std::size_t i = t.first; i < t.last; ++i) m_values.push_back(path_length((*m_windows)[m_candidates[i].window], p));
    for (int corner : {k, l})
    {
      Triangle half = t;
      half.corner[corner] = middle;
      add(half, corner);
    }
  }

  // Tries the candidate point of a triangle, and stores the triangle if it may have a farther point. Its candidate windows are
  // those of the triangle that was split, with m_values at one corner.
  void add(Triangle t, int corner)
  {
    const FT size = (std::max)({edge_length(t, 0), edge_length(t, 1), edge_length(t, 2)});
    m_rows.clear();
    for (std::size_t i = t.first; i < t.last; ++i)
    {
      m_rows.push_back(m_candidates[i].values);
      m_rows.back()[corner] = m_values[i - t.first];
    }
    m_max_min(m_rows, threshold(m_size));
    t.bound = m_max_min.bound();
    if (!(t.bound > threshold(m_size)) || !Number_policy<FT>::is_finite(t.bound)) return;
    // Drop windows that are nowhere nearest: a path length falls by at most `size` from a corner to another point.
    const std::size_t first = m_candidates.size();
    for (std::size_t i = 0; i < m_rows.size(); ++i)
      if (Max_min<FT>::largest(m_rows[i]) <= t.bound + size)
        m_candidates.push_back(Candidate{m_candidates[t.first + i].window, m_rows[i]});
    t.first = first;
    t.last = m_candidates.size();
    try_point(t, m_max_min.weights());
    if (t.bound > threshold(m_size) && size > Number_policy<FT>::rounding(4) * m_size)
    {
      m_heap.push_back(t);
      std::push_heap(m_heap.begin(), m_heap.end());
    }
    else m_candidates.resize(first);
  }

  void try_point(const Triangle& t, const Row& weights)
  {
    Row w;
    for (int i = 0; i < 3; ++i) w[i] = weights[0] * t.corner[0][i] + weights[1] * t.corner[1][i] + weights[2] * t.corner[2][i];
    const Point p = position(w);
    FT d = Number_policy<FT>::infinity();
    for (std::size_t i = t.first; i < t.last; ++i) d = (std::min)(d, path_length((*m_windows)[m_candidates[i].window], p));
    // Rounding must not move the result away from a vertex.
    if (!(d > m_best + FT(0.25) * allowance(m_size))) return;
    m_best = d;
    m_weights = w;
    m_farther = true;
  }

  FT m_best;
  Row m_weights{};
  bool m_farther = false;

  Per_corner<Point> m_corner;
  const std::vector<Window>* m_windows = nullptr;
  FT m_size = FT(0);

  std::vector<Triangle> m_heap;
  std::vector<Candidate> m_candidates;
  std::vector<FT> m_values;
  std::vector<Row> m_rows;
  Max_min<FT> m_max_min;
};

// The farthest point of faces that come in batches as the front finalizes them, or all at once.
//
// Few faces are searched. The corners' distances give an upper bound per face, and a lower bound of the largest distance over
// all faces. A face is finalized when the front reaches its upper bound, which is hardly larger than the corners' distances of
// the other faces finalized then, so most faces are excluded at once. The others wait with a copy of their windows. One or two
// buckets later the lower bound exceeds their upper bounds, except for the last faces.
template <class FT>
class Farthest_point
{
public:
  typedef Point_in_face<FT> Point;
  typedef Per_corner<FT> Weights;

  Farthest_point(const Unfolded_mesh<FT>& mesh, const Initial_windows<FT>& initial, const Geodesic_field<FT>& field)
    : m_mesh(mesh), m_initial(initial), m_field(field)
  {
  }

  // Adds faces with points up to field.maximum. All distances up to there must be final in these faces, and their windows still
  // stored.
  void add(const std::vector<Index>& faces)
  {
    for (const Index f : faces) add_corners(f);
    leave_out_excluded();
    for (const Index f : faces)
      if (const NT bound = corner_bound(f); is_farther(bound)) wait(f, bound);
  }

  // Overload without a range: all faces, from kept windows.
  void add_all()
  {
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (is_reached(f)) add_corners(f);
    std::vector<std::pair<NT, Index>> farther;
    for (Index f = 0; f < m_mesh.number_of_faces(); ++f)
      if (m_mesh.source(3 * f) != no_index)
        if (const NT bound = corner_bound(f); is_farther(bound)) farther.emplace_back(bound, f);
    std::sort(farther.begin(), farther.end(), std::greater<std::pair<NT, Index>>());
    for (const auto& [bound, f] : farther)
      if (is_farther(bound)) wait(f, bound);
  }

  // Result; empty if no point is reached.
  std::optional<Farthest<FT>> result()
  {
    search();
    if (m_is_beyond || m_distance > m_field.maximum) return Farthest<FT>{m_field.maximum, no_index, {}};
    if (m_face == no_index) return std::nullopt;
    // Vertices near sources were measured since, and the result is not nearer than any of them.
    for (const auto& [v, d] : m_field.path_length)
      if (m_distance < d) set_vertex(m_mesh.face(m_mesh.corner(v)), int(m_mesh.corner(v) % 3), d);
    return Farthest<FT>{m_distance, m_face, m_weights};
  }

  std::size_t number_of_searched_faces() const { return m_number_of_searched_faces; }

private:
  // The search locates a point; floating-point numbers suffice if the distances are exact.
  typedef typename std::conditional<Number_policy<FT>::is_inexact, FT, double>::type NT;

  // Limit of the windows of waiting faces, beyond which all waiting faces are searched: the peak of the front's own windows. On
  // regular meshes most faces finalized in a bucket have the same bound and wait for two buckets, each a quarter of an edge
  // wide; on others some ten faces wait. The minimum, some 400 KB, serves small fronts and kept windows.
  std::size_t largest_number_of_waiting_windows() const { return (std::max)(std::size_t(1) << 12, m_field.lists.peak()); }

  struct Waiting_face
  {
    std::unique_ptr<Face_field<FT>> field;
    NT bound;
  };

  struct Entry
  {
    NT bound;
    std::size_t waiting;
    bool is_from_windows;
    friend bool operator<(const Entry& a, const Entry& b) { return a.bound < b.bound; }
  };

  bool is_finite(Index v) const { return Number_policy<FT>::is_finite(m_field.distance[v]); }

  bool is_reached(Index f) const
  {
    if (m_mesh.source(3 * f) == no_index) return false;
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      if (is_finite(m_mesh.source(h)) && m_field.distance[m_mesh.source(h)] <= m_field.maximum) return true;
    if (!Number_policy<FT>::is_finite(m_field.maximum)) return false;
    return !Face_field<FT>(m_mesh, m_initial, m_field, f).windows().empty(); // windows that end before a corner
  }

  // A face with a corner within and a corner beyond the maximum has a point at the maximum.
  void add_corners(Index f)
  {
    for (int k = 0; k < 3; ++k)
    {
      const FT& d = m_field.distance[m_mesh.source(3 * f + Index(k))];
      if (d > m_field.maximum) m_is_beyond = true;
      else if (Number_policy<FT>::is_finite(d) && (m_face == no_index || m_distance < d))
      {
        set_vertex(f, k, d);
        m_search.raise(approximate(d));
      }
    }
  }

  void set_vertex(Index f, int k, const FT& d)
  {
    m_distance = d;
    m_face = f;
    m_weights = {FT(0), FT(0), FT(0)};
    m_weights[k] = FT(1);
  }

  // Upper bound of the distances in a face: a corner's distance plus the longer edge there. Infinite if no corner has a
  // distance.
  NT corner_bound(Index f) const
  {
    NT bound = Number_policy<NT>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
    {
      if (!is_finite(m_mesh.source(h))) continue;
      const NT way = (std::max)(approximate(m_mesh[h].length), approximate(m_mesh[m_mesh.previous(h)].length));
      bound = (std::min)(bound, NT(approximate(m_field.distance[m_mesh.source(h)]) + way));
    }
    return bound;
  }

  // True if points within the maximum may be farther than all points so far.
  bool is_farther(const NT& bound) const
  {
    return !m_is_beyond && bound > m_search.threshold(NT(0)) && Number_policy<NT>::is_finite(bound);
  }

  void wait(Index f, const NT& bound)
  {
    if (m_number_of_waiting_windows > largest_number_of_waiting_windows()) search();
    if (m_number_of_waiting == m_waiting.size())
      m_waiting.push_back({std::make_unique<Face_field<FT>>(m_mesh, m_initial, m_field), bound});
    Waiting_face& w = m_waiting[m_number_of_waiting++];
    w.field->set_face(f);
    w.bound = bound;
    m_number_of_waiting_windows += w.field->windows().size();
  }

  void leave_out_excluded()
  {
    const std::size_t number = std::exchange(m_number_of_waiting, 0);
    m_number_of_waiting_windows = 0;
    for (std::size_t i = 0; i < number; ++i)
    {
      if (!is_farther(m_waiting[i].bound)) continue;
      m_number_of_waiting_windows += m_waiting[i].field->windows().size();
      std::swap(m_waiting[m_number_of_waiting++], m_waiting[i]);
    }
  }

  // Searches the waiting faces.
  void search()
  {
    leave_out_excluded();
    for (std::size_t i = 0; i < m_number_of_waiting; ++i) push(Entry{m_waiting[i].bound, i, false});
    while (!m_heap.empty())
    {
      const Entry entry = pop();
      if (!(entry.bound > m_search.threshold(NT(0)))) break;
      search_face(entry);
    }
    m_heap.clear();
    m_number_of_waiting = m_number_of_waiting_windows = 0;
  }

  void search_face(const Entry& entry)
  {
    const Face_field<FT>& field = *m_waiting[entry.waiting].field;
    m_windows.clear();
    for (const Face_window<FT>& w : field.windows()) m_windows.push_back(approximate(w));
    const NT size = approximate(field.size());
    bool farther;
    const NT bound = m_search.start(corners(field.frame()), m_windows, size, farther);
    if (entry.is_from_windows) farther = m_search.search() || farther;
    else
    {
      ++m_number_of_searched_faces;
      // Other faces may have a larger bound.
      if (bound > m_search.threshold(size)) push(Entry{bound, entry.waiting, true});
    }
    if (!farther) return;
    const auto& w = m_search.weights();
    const Weights found{FT(w[0]), FT(w[1]), FT(w[2])};
    std::size_t nearest;
    const FT d = field.distance(field.frame().point(found), nearest);
    if (!(m_distance < d)) return;
    m_face = field.face();
    m_weights = found;
    m_distance = d;
  }

  void push(const Entry& entry)
  {
    m_heap.push_back(entry);
    std::push_heap(m_heap.begin(), m_heap.end());
  }

  Entry pop()
  {
    std::pop_heap(m_heap.begin(), m_heap.end());
    const Entry entry = m_heap.back();
    m_heap.pop_back();
    return entry;
  }

  static NT approximate(const FT& x)
  {
    if constexpr (Number_policy<FT>::is_inexact) return x;
    else return CGAL::to_double(x);
  }
  static Point_in_face<NT> approximate(const Point& p) { return {approximate(p.x), approximate(p.y)}; }
  static Face_window<NT> approximate(const Face_window<FT>& w)
  {
    return {approximate(w.x),
            approximate(w.y),
            approximate(w.sigma),
            approximate(w.left),
            approximate(w.right),
            w.source_ref,
            w.bits,
            w.origin,
            w.edge,
            approximate(w.start_value)};
  }
  static Per_corner<Point_in_face<NT>> corners(const Face_frame<FT>& frame)
  {
    return {approximate(frame.corner(0)), approximate(frame.corner(1)), approximate(frame.corner(2))};
  }

  const Unfolded_mesh<FT>& m_mesh;
  const Initial_windows<FT>& m_initial;
  const Geodesic_field<FT>& m_field;
  std::vector<Waiting_face> m_waiting; // memory is reused
  std::size_t m_number_of_waiting = 0, m_number_of_waiting_windows = 0;
  Farthest_in_face<NT> m_search{NT(0)};
  std::vector<Face_window<NT>> m_windows;
  std::vector<Entry> m_heap;
  Index m_face = no_index;
  Weights m_weights{};
  FT m_distance = FT(0);
  bool m_is_beyond = false;
  std::size_t m_number_of_searched_faces = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
