// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Removal of degenerate faces from a polygon soup: the work of remove_degenerate_faces_in_polygon_soup().

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_DEGENERATE_FACE_REMOVAL_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_MESH_DEGENERATE_FACE_REMOVAL_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <limits>
#include <numeric>
#include <queue>
#include <set>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

/*
A triangle is degenerate if Unfolded_mesh rejects it (it has no area), or if its height, that of its middle corner above its longest
side, is only rounding:
- at most 64 units in the last place of its shortest side: no ray from the middle corner through the longest side has a width, or
- at most 16 units in the last place of the coordinates there, the larger of those of the middle corner and of the longest side beside
  it: a point that is computed between two others is beside their line by up to five of these units (three roundings of three
  coordinates), so the three corners may have been meant to be on one line.

Two steps remove such triangles; displacements are rounding, too:

1. Contraction: the ends of a side of length zero become one point. A polygon that has less than three corners then vanishes, and its
   neighbours at two sides that become one edge are neighbours of each other.
2. Division, for a degenerate triangle between three different points: let ac be its longest side and b the third corner, which is on
   ac. The triangle vanishes, and every other polygon at the edge ac receives the corner b between a and c; a triangle acx becomes
   abx and bcx. So the neighbours at ab, bc and ac become neighbours of each other along ab and bc. With one other polygon at ac
   this is an edge flip. Without any, ac is on the border.

A polygon with more than three corners may have spikes, corners with both sides in the same direction: they are cut off as degenerate
triangles. Triangles that result from a degenerate one are degenerate, whatever rounding makes of their height: otherwise parts of a
cluster would stay between faces that have become neighbours. Needles among them, whose shortest side is less than eight times their
height, are contracted at this side instead of divided; so are triangles that have no area only because products of lengths underflow.

Degenerate triangles are divided in the order of their longest sides, the longest first. If all are exactly flat, the other degenerate
triangles at ac lie between a and c then, and are divided into shorter ones, and triangles with an area into triangles with an area.

Termination: contraction reduces the number of points. Division removes the triple {a, b, c} from the soup, as every polygon with it
has the edge ac and the corner b, and vanishes, too. The triple is recorded, and a division that would create a triangle with a
recorded triple is refused; as there are finitely many triples, the number of divisions is finite. If all degenerate triangles are
exactly flat, none is refused, since the longest sides of those that are divided do not increase, and the parts are shorter. A triangle
that is refused because of rounding stays if Unfolded_mesh accepts it; otherwise it is contracted at its shortest side.
*/
template <class Traits, class Point_of, class PolygonRange>
class Degenerate_face_removal
{
  typedef typename Traits::FT FT;
  typedef typename Traits::Point_3 Point_3;
  typedef std::vector<Index> Corners;
  typedef std::array<Index, 3> Triple; // sorted

public:
  // point_of(i): the point with the index i.
  Degenerate_face_removal(std::size_t number_of_points, const Point_of& point_of, PolygonRange& polygons, const Traits& traits)
    : m_number_of_points(number_of_points), m_point_of(point_of), m_polygons(polygons), m_traits(traits)
  {
  }

  // True if a polygon of the range is degenerate, has less than three corners, or a side of length zero or a corner twice.
  bool is_needed() const
  {
    Corners corners;
    for (const auto& polygon : m_polygons)
    {
      corners.clear();
      for (const auto& corner : polygon) corners.push_back(Index(corner));
      if (is_degenerate(corners)) return true;
    }
    return false;
  }

  // Removes the degenerate faces.
  void run()
  {
    m_root.resize(m_number_of_points);
    std::iota(m_root.begin(), m_root.end(), Index(0));
    m_origin.resize(m_polygons.size());
    std::iota(m_origin.begin(), m_origin.end(), std::size_t(0));
    m_is_alive.assign(m_polygons.size(), 1);
    m_is_degenerate.assign(m_polygons.size(), 0);
    contract_sides_without_length();
    for (std::size_t f = 0, n = m_polygons.size(); f < n; ++f)
    {
      const Corners corners = corners_of(f);
      const std::vector<Corners> parts = parts_of(corners);
      if (parts.size() > 1 || (parts.size() == 1 && parts.front().size() != corners.size())) ++m_shortened_faces;
      replace(f, parts);
    }
    queue_degenerate_triangles();
    if (!m_queue.empty()) remove_degenerate_triangles();
    compress();
  }

  // Index of the point into which a point has been merged, itself if it has not.
  std::vector<std::size_t> merged_points()
  {
    std::vector<std::size_t> result(m_root.size());
    for (Index v = 0; v < m_root.size(); ++v) result[v] = root(v);
    return result;
  }

  // For each polygon, the index of the polygon of the input of which it is a part.
  const std::vector<std::size_t>& origins() const { return m_origin; }

  std::size_t number_of_merged_points() const { return m_merged_points; }
  std::size_t number_of_collapsed_faces() const { return m_collapsed_faces; }
  std::size_t number_of_shortened_faces() const { return m_shortened_faces; }
  std::size_t number_of_flipped_faces() const { return m_flipped_faces; }
  std::size_t number_of_dropped_faces() const { return m_dropped_faces; }

private:
  struct Shape
  {
    bool is_good = false;                  // not degenerate
    bool has_area = false;                 // as in Unfolded_mesh
    bool is_cap = false;                   // no needle, if degenerate
    std::size_t longest = 0, shortest = 0; // sides, each numbered by its first corner
    FT length = FT(0);                     // of the longest side
  };

  struct Queued_triangle
  {
    FT length; // of its longest side
    std::size_t face;
    Triple triple;

    bool operator<(const Queued_triangle& t) const
    {
      return length != t.length ? length < t.length : face > t.face; // faces with equal lengths in their order
    }
  };

  typedef std::array<Point_3, 3> Points; // of a triangle

  bool is_degenerate(const Corners& polygon) const
  {
    if (polygon.size() < 3 || has_repetition(polygon)) return true;
    if (polygon.size() == 3) return !shape_of(polygon).is_good;
    for (std::size_t k = 0; k < polygon.size(); ++k)
      if (has_no_length(polygon[k], polygon[(k + 1) % polygon.size()])) return true;
    return spike_of(polygon) != polygon.size();
  }

  Points points_of(const Corners& triangle) const
  {
    return {m_point_of(triangle[0]), m_point_of(triangle[1]), m_point_of(triangle[2])};
  }

  Shape shape_of(const Corners& triangle) const { return shape_of(points_of(triangle)); }

  Shape shape_of(const Points& points) const
  {
    const auto apices = m_traits.construct_apices_2_object()(points[0], points[1], points[2]);
    Shape shape;
    shape.has_area = true;
    for (std::size_t k = 0; k < 3; ++k)
    {
      shape.has_area &= Unfolded_mesh<FT>::has_area(apices[k].length, apices[k].y);
      if (apices[k].length > apices[shape.longest].length) shape.longest = k;
      if (apices[k].length < apices[shape.shortest].length) shape.shortest = k;
    }
    shape.length = apices[shape.longest].length;
    const FT shortest = apices[shape.shortest].length, height = apices[shape.longest].y;
    shape.is_good = shape.has_area && height > largest_height(points, apices, shape.longest, shortest);
    shape.is_cap = has_normal_square(FT(shape.length * shortest)) && !(height > shortest / FT(8));
    return shape;
  }

  // The largest height of a degenerate triangle with area.
  template <class Apices>
  static FT largest_height(const Points& points, const Apices& apices, std::size_t longest, const FT& shortest)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return FT(0);
    else
    {
      const std::size_t end = (longest + 1) % 3, middle = (longest + 2) % 3;
      const FT before = apices[middle].length, after = apices[end].length; // parts of the longest side
      const FT beside = (after * size_of(points[longest]) + before * size_of(points[end])) / (before + after);
      const FT size = (std::max)(size_of(points[middle]), beside);
      return (std::max)(FT(Number_policy<FT>::rounding(64) * shortest), FT(coordinate_rounding() * size));
    }
  }

  // Relative to the size of a point, its largest coordinate.
  static FT coordinate_rounding() { return Number_policy<FT>::rounding(16); }

  static FT size_of(const Point_3& p) { return (std::max)({FT(CGAL::abs(p.x())), FT(CGAL::abs(p.y())), FT(CGAL::abs(p.z()))}); }

  // Whether the square of a number is above the underflow range.
  static bool has_normal_square(const FT& x)
  {
    if constexpr (!Number_policy<FT>::is_inexact) return true;
    else if constexpr (std::numeric_limits<FT>::is_specialized) return x * x >= (std::numeric_limits<FT>::min)();
    else return CGAL::is_positive(x);
  }

  // Whether two points are the same up to rounding of their coordinates.
  bool has_no_length(Index v, Index w) const
  {
    const Point_3 p = m_point_of(v), q = m_point_of(w);
    const FT x = q.x() - p.x(), y = q.y() - p.y(), z = q.z() - p.z(), square = x * x + y * y + z * z;
    if constexpr (!Number_policy<FT>::is_inexact) return !CGAL::is_positive(square);
    else
    {
      const FT length = coordinate_rounding() * (std::max)(size_of(p), size_of(q));
      return !CGAL::is_positive(square) || (Number_policy<FT>::is_finite(square) && square <= length * length);
    }
  }

  // A corner of a polygon with more than three corners that is the end of a fold: both sides there have the same direction. The number
  // of corners if there is none.
  std::size_t spike_of(const Corners& polygon) const
  {
    const std::size_t n = polygon.size();
    std::size_t k = 0;
    for (; k < n; ++k)
    {
      const Shape shape = shape_of(Corners{polygon[(k + n - 1) % n], polygon[k], polygon[(k + 1) % n]});
      if (!shape.is_good && shape.is_cap && shape.longest != 2) break;
    }
    return k;
  }

  static bool has_repetition(const Corners& polygon)
  {
    for (std::size_t i = 0; i < polygon.size() && polygon.size() < 16; ++i)
      if (std::find(polygon.begin(), polygon.begin() + std::ptrdiff_t(i), polygon[i]) != polygon.begin() + std::ptrdiff_t(i))
        return true;
    if (polygon.size() < 16) return false;
    Corners sorted = polygon;
    std::sort(sorted.begin(), sorted.end());
    return std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
  }

  Corners corners_of(std::size_t face) const
  {
    Corners corners;
    for (const auto& corner : m_polygons[face]) corners.push_back(Index(corner));
    return corners;
  }

  // Union of points: a forest, whose roots have the smallest indices.
  Index root(Index v)
  {
    while (m_root[v] != v) v = m_root[v] = m_root[m_root[v]];
    return v;
  }

  // Returns the index that is no longer used.
  Index merge(Index v, Index w)
  {
    v = root(v);
    w = root(w);
    if (v == w) return no_index;
    ++m_merged_points;
    m_root[(std::max)(v, w)] = (std::min)(v, w);
    return (std::max)(v, w);
  }

  void contract_sides_without_length()
  {
    for (const auto& polygon : m_polygons)
    {
      if (polygon.size() < 2) continue;
      Index previous = Index(*std::prev(polygon.end()));
      for (const auto& corner : polygon)
      {
        if (Index(corner) != previous && has_no_length(previous, Index(corner))) merge(previous, Index(corner));
        previous = Index(corner);
      }
    }
  }

  // The polygons without repeated corners and spikes, with at least three corners each, of which a polygon consists after merging
  // points; spikes are triangles.
  std::vector<Corners> parts_of(Corners polygon)
  {
    for (Index& v : polygon) v = root(v);
    std::vector<Corners> parts, rest{std::move(polygon)};
    while (!rest.empty())
    {
      Corners part = std::move(rest.back());
      rest.pop_back();
      if (part.size() < 3) continue;
      if (has_repetition(part))
      {
        split_at_repetition(part, rest);
        continue;
      }
      for (std::size_t n = part.size(), k; n > 3 && (k = spike_of(part)) != n; --n)
      {
        parts.push_back({part[(k + n - 1) % n], part[k], part[(k + 1) % n]});
        part.erase(part.begin() + std::ptrdiff_t(k));
      }
      parts.push_back(std::move(part));
    }
    return parts;
  }

  static void split_at_repetition(const Corners& polygon, std::vector<Corners>& parts)
  {
    for (std::size_t j = 1; j < polygon.size(); ++j)
    {
      const auto end = polygon.begin() + std::ptrdiff_t(j), first = std::find(polygon.begin(), end, polygon[j]);
      if (first == end) continue;
      parts.emplace_back(first, end);
      parts.emplace_back(polygon.begin(), first);
      parts.back().insert(parts.back().end(), end, polygon.end());
      return;
    }
  }

  // Replaces a face by polygons; the first of these receives its index. Returns the indices.
  std::vector<std::size_t> replace(std::size_t face, const std::vector<Corners>& parts)
  {
    std::vector<std::size_t> faces;
    for (const Corners& part : parts)
    {
      faces.push_back(faces.empty() ? face : m_polygons.size());
      if (faces.back() == face)
      {
        assign(m_polygons[face], part);
        continue;
      }
      m_polygons.push_back(m_polygons[face]);
      assign(m_polygons.back(), part);
      m_origin.push_back(m_origin[face]);
      m_is_alive.push_back(1);
      m_is_degenerate.push_back(m_is_degenerate[face]);
    }
    if (parts.empty())
    {
      m_is_alive[face] = 0;
      ++m_collapsed_faces;
    }
    return faces;
  }

  template <class Polygon>
  static void assign(Polygon& polygon, const Corners& corners)
  {
    typedef typename std::iterator_traits<decltype(polygon.begin())>::value_type Corner;
    if (polygon.size() != corners.size()) resize(polygon, corners.size(), 0);
    std::transform(corners.begin(), corners.end(), polygon.begin(), [](Index v) { return Corner(v); });
  }

  template <class Polygon>
  static auto resize(Polygon& polygon, std::size_t size, int) -> decltype(polygon.resize(size))
  {
    return polygon.resize(size);
  }
  template <class Polygon> // arrays of three corners, which stay triangles
  static void resize(Polygon&, std::size_t, long)
  {
    CGAL_assertion_msg(false, "a polygon of fixed size that is not a triangle");
  }

  void queue_degenerate_triangles()
  {
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      if (m_is_alive[f]) queue_if_degenerate(f);
  }

  void queue_if_degenerate(std::size_t face)
  {
    if (m_polygons[face].size() != 3) return;
    const Corners triangle = corners_of(face);
    const Shape shape = shape_of(triangle);
    if (!shape.is_good) m_is_degenerate[face] = 1;
    if (m_is_degenerate[face]) m_queue.push({shape.length, face, triple_of(triangle)});
  }

  static Triple triple_of(const Corners& triangle)
  {
    Triple triple{{triangle[0], triangle[1], triangle[2]}};
    std::sort(triple.begin(), triple.end());
    return triple;
  }

  void remove_degenerate_triangles()
  {
    find_faces_at_points();
    while (!m_queue.empty())
    {
      const Queued_triangle queued = m_queue.top();
      m_queue.pop();
      if (!m_is_alive[queued.face] || m_polygons[queued.face].size() != 3) continue;
      const Corners triangle = corners_of(queued.face);
      if (triple_of(triangle) != queued.triple) continue; // an entry of a former polygon with this index
      const Shape shape = shape_of(triangle);
      if (!Number_policy<FT>::is_finite(shape.length)) continue;
      const bool is_refused = shape.is_cap && !divide_neighbours(queued, triangle, shape);
      if (!shape.is_cap || (is_refused && !shape.has_area))
        contract(triangle[shape.shortest], triangle[(shape.shortest + 1) % 3]);
    }
  }

  // Step 2; returns false, and changes nothing, if a triangle of a recorded triple would result.
  bool divide_neighbours(const Queued_triangle& queued, const Corners& triangle, const Shape& shape)
  {
    const Index a = triangle[shape.longest], c = triangle[(shape.longest + 1) % 3], b = triangle[(shape.longest + 2) % 3];
    std::vector<std::pair<std::size_t, std::vector<Corners>>> changes;
    for (const std::size_t g : faces_at_edge(a, c))
      if (g != queued.face) changes.emplace_back(g, with_corner(corners_of(g), a, c, b));
    for (const auto& change : changes)
      for (const Corners& part : change.second)
        if (part.size() == 3 && m_removed.count(triple_of(part))) return false;
    m_removed.insert(queued.triple);
    m_is_alive[queued.face] = 0;
    ++(changes.empty() ? m_dropped_faces : m_flipped_faces);
    for (const auto& change : changes) change_face(change.first, change.second);
    return true;
  }

  // The polygon with a corner b on its side ac; a triangle in two parts.
  std::vector<Corners> with_corner(Corners polygon, Index a, Index c, Index b)
  {
    const std::size_t n = polygon.size();
    std::size_t k = 0;
    while (!is_side(polygon[k], polygon[(k + 1) % n], a, c)) ++k;
    std::rotate(polygon.begin(), polygon.begin() + std::ptrdiff_t((k + 1) % n), polygon.end());
    polygon.push_back(b); // between the last corner and the first one
    if (n == 3 && polygon[1] != b) return {{polygon[3], polygon[0], polygon[1]}, {polygon[3], polygon[1], polygon[2]}};
    return parts_of(std::move(polygon));
  }

  static bool is_side(Index v, Index w, Index a, Index c) { return (v == a && w == c) || (v == c && w == a); }

  void change_face(std::size_t face, const std::vector<Corners>& parts)
  {
    for (const std::size_t f : replace(face, parts))
    {
      for (const auto& corner : m_polygons[f]) m_more_faces_at[Index(corner)].push_back(f);
      queue_if_degenerate(f);
    }
  }

  void contract(Index v, Index w)
  {
    const Index removed = merge(v, w);
    if (removed == no_index) return;
    for (const std::size_t f : faces_at(removed))
      if (m_is_alive[f]) change_face(f, parts_of(corners_of(f)));
  }

  void find_faces_at_points()
  {
    m_first_face_at.assign(m_number_of_points + 1, 0);
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      if (m_is_alive[f])
        for (const auto& corner : m_polygons[f]) ++m_first_face_at[std::size_t(corner) + 1];
    std::partial_sum(m_first_face_at.begin(), m_first_face_at.end(), m_first_face_at.begin());
    m_face_at.resize(m_first_face_at.back());
    std::vector<std::size_t> next(m_first_face_at.begin(), m_first_face_at.end() - 1);
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
      if (m_is_alive[f])
        for (const auto& corner : m_polygons[f]) m_face_at[next[std::size_t(corner)]++] = f;
  }

  std::size_t number_of_entries_at(Index v) const
  {
    const auto more = m_more_faces_at.find(v);
    return m_first_face_at[v + 1] - m_first_face_at[v] + (more == m_more_faces_at.end() ? 0 : more->second.size());
  }

  // The faces that have or had the point as a corner, each once.
  std::vector<std::size_t> faces_at(Index v) const
  {
    std::vector<std::size_t> faces(m_face_at.begin() + std::ptrdiff_t(m_first_face_at[v]),
                                   m_face_at.begin() + std::ptrdiff_t(m_first_face_at[v + 1]));
    const auto more = m_more_faces_at.find(v);
    if (more == m_more_faces_at.end()) return faces;
    faces.insert(faces.end(), more->second.begin(), more->second.end());
    std::sort(faces.begin(), faces.end());
    faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
    return faces;
  }

  std::vector<std::size_t> faces_at_edge(Index a, Index c) const
  {
    std::vector<std::size_t> faces;
    for (const std::size_t f : faces_at(number_of_entries_at(a) < number_of_entries_at(c) ? a : c))
    {
      if (!m_is_alive[f]) continue;
      Index previous = Index(*std::prev(m_polygons[f].end()));
      for (const auto& corner : m_polygons[f])
      {
        if (is_side(previous, Index(corner), a, c)) faces.push_back(f);
        previous = Index(corner);
      }
    }
    return faces;
  }

  void compress()
  {
    std::size_t kept = 0;
    for (std::size_t f = 0; f < m_polygons.size(); ++f)
    {
      if (!m_is_alive[f]) continue;
      if (kept != f) std::swap(m_polygons[kept], m_polygons[f]);
      m_origin[kept++] = m_origin[f];
    }
    m_polygons.resize(kept);
    m_origin.resize(kept);
  }

  const std::size_t m_number_of_points;
  const Point_of& m_point_of;
  PolygonRange& m_polygons;
  const Traits& m_traits;

  std::vector<Index> m_root;
  std::vector<std::size_t> m_origin;
  std::vector<char> m_is_alive, m_is_degenerate;
  std::priority_queue<Queued_triangle> m_queue;
  std::set<Triple> m_removed;

  // Faces at points before step 2, and those that step 2 has added. Contain faces that no longer have the point.
  std::vector<std::size_t> m_first_face_at, m_face_at;
  std::unordered_map<Index, std::vector<std::size_t>> m_more_faces_at;

  std::size_t m_merged_points = 0, m_collapsed_faces = 0, m_shortened_faces = 0, m_flipped_faces = 0, m_dropped_faces = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
