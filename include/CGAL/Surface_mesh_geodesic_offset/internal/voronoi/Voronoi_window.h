// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A window in a face for the Voronoi step: rounded to double, with the label of its source and the half-planes of its cone.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_WINDOW_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_VORONOI_VORONOI_WINDOW_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Window_cone.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/voronoi/Voronoi_tolerances.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Face_window.h>

#include <CGAL/number_utils.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class NT>
struct Voronoi_window
{
  typedef Point_in_face<NT> Point;

  Face_window<NT> rays;
  Index label;                         // id of the source, or of another source with which it coincides
  std::array<Half_plane<NT>, 3> bound; // the cone; the third one is where parallel rays start
  int number_of_bounds;
  std::array<Point, 2> end;     // of the chord on the left and the right: where the bounding rays start, unless at the image
  std::array<NT, 2> tied{0, 0}; // so far beyond these rays, the distances of the next window tie with these
  NT start;                     // least distance of the rays: at their chord, or at their image in the face

  template <class FT>
  Voronoi_window(const Face_window<FT>& w, Index label_) : label(label_)
  {
    const auto point = [](const Point_in_face<FT>& p) { return Point{number_cast<NT>(p.x), number_cast<NT>(p.y)}; };
    rays.x = number_cast<NT>(w.x);
    rays.y = number_cast<NT>(w.y);
    rays.sigma = number_cast<NT>(w.sigma);
    rays.left = point(w.left);
    rays.right = point(w.right);
    rays.source_ref = w.source_ref;
    rays.bits = w.bits;
    rays.origin = w.origin;
    rays.edge = w.edge;
    rays.start_value = number_cast<NT>(w.start_value);
    rays.to = point(w.left_ray()); // before rounding, also of exact numbers
    rays.from = point(w.right_ray());
    const Point nl = (1 / length(rays.to)) * quarter_turn(rays.to), nr = (-1 / length(rays.from)) * quarter_turn(rays.from);
    bound[0] = {nl, dot(nl, is_parallel() ? rays.left : image())};
    bound[1] = {nr, dot(nr, is_parallel() ? rays.right : image())};
    start = starts_at_image() ? rays.sigma : is_strip() ? rays.start_value : least_at_chord();
    end = {rays.left, rays.right};
    number_of_bounds = is_parallel() ? 3 : 2;
    if (is_parallel()) start_at(start);
  }

  bool is_parallel() const { return rays.is_parallel(); }
  bool starts_at_image() const { return rays.origin >= STARTS_IN_FACE && !rays.is_parallel(); }
  bool is_strip() const { return rays.is_parallel() && rays.origin == STARTS_IN_FACE; }
  Point image() const { return rays.image(); } // the direction opposite to the rays, if parallel
  NT sigma() const { return rays.sigma; }
  NT distance_at(const Point& p) const { return rays.distance_at(p); }

  NT largest_at_chord() const { return (std::max)(distance_at(rays.left), distance_at(rays.right)); }

  bool contains(const Point& p, NT slack) const
  {
    for (int k = 0; k < number_of_bounds; ++k)
      if (bound[std::size_t(k)].value(p) > slack) return false;
    return true;
  }

  // True if the distances of the rays hold at p: also beyond a ray beside which they tie with others.
  bool holds_at(const Point& p, NT slack) const
  {
    return bound[0].value(p) <= slack + tied[0] && bound[1].value(p) <= slack + tied[1] &&
           (number_of_bounds == 2 || bound[2].value(p) <= slack + (is_strip() ? 0 : (std::max)(tied[0], tied[1])));
  }

  // Gradient of the distances; null at the image.
  Point gradient(const Point& p) const
  {
    const Point d = rays.ray_direction(p);
    const NT size = length(d);
    return size > 0 ? (1 / size) * d : Point{0, 0};
  }

  // Lower bound of the distances in a disk, as they are 1-Lipschitz: from the path to its center, through the chord or beside its
  // ends as far as the rays hold there. The center may be behind a source, where a strip has no path.
  NT lower_bound(const Point& center, NT radius) const
  {
    const NT beyond = (std::max)(tied[0] + length(end[0] - rays.left), tied[1] + length(end[1] - rays.right));
    return (is_strip() ? start + distance_from_chord(center) : rays.path_length(center)) - radius - beyond;
  }

  // Where the left (0) or the right (1) bounding ray starts in the face.
  Point start_of_bound(int k) const { return starts_at_image() ? image() : k == 0 ? rays.left : rays.right; }

  // For a window whose right bounding ray starts where the left one of another window does: true if these are the same ray.
  bool continues_in(const Voronoi_window<NT>& next) const
  {
    const Point u = along_bound(1), v = next.along_bound(0);
    return CGAL::abs(cross(u, v)) <= Voronoi_tolerances<NT>::same_ray() && dot(u, v) > 0;
  }

  // A ray on which the distances of two windows are equal: behind a point that is in line with the other one, `apart` from it.
  struct Common_ray
  {
    Point start;
    Half_plane<NT> left; // what is on the left of it
    NT apart;            // infinite for parallel rays

    // How far beside the ray, at a distance from its start, the distances are equal within rounding.
    NT width(NT along_ray, NT tie) const
    {
      return Voronoi_tolerances<NT>::tied_width(along_ray * (1 + along_ray / apart), tie);
    }
  };

  // The common ray of this window and of one on its right, of two sources: the distances are equal on it, and differ by the
  // square of the distance from it on both sides. So within rounding, the cones may end anywhere beside the ray.
  std::optional<Common_ray> common_ray(const Voronoi_window<NT>& right, NT tie) const
  {
    if (label == right.label || !ties_on_ray(right, tie)) return std::nullopt;
    const bool starts_on_right = is_parallel() || (!right.is_parallel() && sigma() < right.sigma());
    const Voronoi_window<NT>&point = starts_on_right ? right : *this, &other = starts_on_right ? *this : right;
    const Point p = point.image(), back = other.is_parallel() ? other.image() : other.image() - p;
    const NT apart = length(back);
    if (apart <= tie) return std::nullopt;
    const Point n = (1 / apart) * quarter_turn(back);
    return Common_ray{p, {n, dot(n, p)}, other.is_parallel() ? std::numeric_limits<NT>::infinity() : apart};
  }

  // True if the distances are equal on a ray, were there no cones, and one of the windows is nearer everywhere else.
  bool ties_on_ray(const Voronoi_window<NT>& other, NT tie) const
  {
    if (is_parallel() && other.is_parallel()) return false;
    if (is_parallel()) return other.ties_on_ray(*this, tie);
    if (other.is_parallel()) return CGAL::abs(other.distance_at(image()) - sigma()) <= tie;
    return CGAL::abs(length(image() - other.image()) - CGAL::abs(sigma() - other.sigma())) <= tie;
  }

  // Ends the cone at a common ray on its left (0) or right (1). `along_edge`: unit vector along the edge of the chord, whose
  // own direction rounding may have lost. Precondition: is_bound().
  void end_at(const Common_ray& ray, int k, const Point& along_edge)
  {
    set_bound(k, k == 0 ? ray.left.opposite() : ray.left, along_edge);
  }

  // Extends the cone at its left (0) or right (1) bounding ray to that of another window, if these are one ray up to rounding.
  void extend_to(const Voronoi_window<NT>& other, int k, const Point& along_edge, NT radius, NT tie)
  {
    const Half_plane<NT>&own = bound[std::size_t(k)], &ray = other.bound[std::size_t(k)];
    const Point p = other.start_of_bound(k), q = p + radius * other.along_bound(k);
    NT along_ray = 0;
    for (const Voronoi_window<NT>* const w : {static_cast<const Voronoi_window<NT>*>(this), &other})
      if (!w->is_parallel()) along_ray = (std::max)(along_ray, length(w->start_of_bound(k) - w->image()));
    const NT width = Voronoi_tolerances<NT>::tied_width(along_ray, tie);
    const NT angle = Voronoi_tolerances<NT>::tied_turn(along_ray, width);
    if ((std::max)(own.value(p), own.value(q)) <= 0) return;
    if (CGAL::abs(own.value(p)) <= width && CGAL::abs(cross(own.n, ray.n)) <= angle) set_bound(k, ray, along_edge);
  }

  // Sets how far beyond the left (0) or right (1) bounding ray the distances tie with those of the window there: as far as the
  // gradients where the ray starts differ by no more; and as paths from the end of a source segment are not longer than across
  // it by more.
  void set_tied(int k, const Voronoi_window<NT>& other, NT tie)
  {
    const std::size_t i = std::size_t(k);
    const Point p = end[i];
    if (!(CGAL::abs(distance_at(p) - other.distance_at(p)) <= tie)) return;
    const NT from_source = (std::min)(distance_from_source(p), other.distance_from_source(p));
    if (!(from_source > tie)) return;
    const NT slope = length(gradient(p) - other.gradient(p));
    const NT chord = length(other.rays.right - other.rays.left);
    tied[i] = (std::max)(tied[i], (std::min)({tie / slope, square_root<NT>(tie * from_source), chord}));
  }

  // How far beyond the start of its left (0) or right (1) bounding ray a cone may reach: as far as paths from the end of a
  // source segment are not longer than across it by more than a tie.
  NT extension(int k, NT tie) const { return Voronoi_tolerances<NT>::tied_width(distance_from_source(start_of_bound(k)), tie); }

  // True if the bounding ray on the left (0) or right (1) is a common ray up to rounding.
  bool is_bound(const Common_ray& ray, int k, NT tie) const
  {
    const Point p = start_of_bound(k), &n = bound[std::size_t(k)].n, outwards = (k == 0 ? -1. : 1.) * ray.left.n;
    const NT along_ray = length(p - ray.start), width = ray.width(along_ray, tie);
    const NT angle = Voronoi_tolerances<NT>::tied_turn(along_ray, width);
    return CGAL::abs(ray.left.value(p)) <= width && CGAL::abs(cross(outwards, n)) <= angle && dot(outwards, n) > 0;
  }

  // True if both bounding rays are one ray, up to `tie` at distances up to `radius`.
  bool is_one_ray(NT radius, NT tie) const
  {
    return length(bound[0].n + bound[1].n) * radius + CGAL::abs(bound[0].m + bound[1].m) <= tie;
  }

  // True if the distances are equal up to `tie` in the disk about `center`, were there no cones.
  bool is_same_function(const Voronoi_window<NT>& other, const Point& center, NT radius, NT tie) const
  {
    if (is_parallel() != other.is_parallel()) return false;
    const NT apart = length(image() - other.image());
    if (!is_parallel()) return apart <= tie && CGAL::abs(sigma() - other.sigma()) <= tie;
    return apart * radius <= tie && CGAL::abs(distance_at(center) - other.distance_at(center)) <= tie;
  }

  // Order of windows that tie. Beside a common ray, on which the distances are equal, the window with the farther image is
  // nearer, by the square of the distance from the ray only.
  bool precedes(const Voronoi_window<NT>& other) const
  {
    if (is_parallel() != other.is_parallel()) return is_parallel();
    if (!is_parallel() && sigma() != other.sigma()) return sigma() < other.sigma();
    return label < other.label;
  }

private:
  // Ends the cone at a ray beside the end of the chord.
  void set_bound(int k, const Half_plane<NT>& ray, const Point& along_edge)
  {
    const std::size_t i = std::size_t(k);
    bound[i] = ray;
    const Point p = k == 0 ? rays.left : rays.right;
    const NT slope = dot(ray.n, along_edge), value = ray.value(p);
    const bool meets_edge = CGAL::abs(slope) > Voronoi_tolerances<NT>::least_slope;
    end[i] = meets_edge ? p - (value / slope) * along_edge : p - value * ray.n;
    if (meets_edge && is_parallel() && !is_strip()) start_at((std::min)(start, distance_at(end[i])));
  }

  // Sets where parallel rays start.
  void start_at(NT distance)
  {
    start = distance;
    bound[2] = {rays.image(), rays.sigma - start};
  }

  NT distance_from_source(const Point& p) const
  {
    return is_parallel() ? distance_at(p) - rays.start_value : length(p - image());
  }

  // Unit vector along the left (0) or right (1) bounding ray.
  Point along_bound(int k) const { return (k == 0 ? -1. : 1.) * quarter_turn(bound[std::size_t(k)].n); }

  NT least_at_chord() const
  {
    const Point chord = rays.right - rays.left;
    const NT size = dot(chord, chord);
    const Point to = rays.is_parallel() ? Point{0, 0} : image() - rays.left;
    const NT t = size > 0 ? (std::max)(NT(0), (std::min)(NT(1), dot(to, chord) / size)) : NT(0);
    return (std::min)({distance_at(rays.left), distance_at(rays.right), distance_at(rays.left + t * chord)});
  }

  NT distance_from_chord(const Point& p) const
  {
    const Point chord = rays.right - rays.left;
    const NT size = dot(chord, chord);
    const NT t = size > 0 ? (std::max)(NT(0), (std::min)(NT(1), dot(p - rays.left, chord) / size)) : NT(0);
    return length(p - rays.left - t * chord);
  }
};

// The least length of a path to p through a window: straight if its rays hold there, else around an end of its chord.
// Continuous, also if the cone ends at a common ray.
template <class NT>
NT distance_through(const Voronoi_window<NT>& w, const Point_in_face<NT>& p, NT slack, bool& is_straight)
{
  is_straight = w.holds_at(p, slack);
  if (is_straight) return w.distance_at(p);
  NT result = w.rays.path_length(p);
  if (!w.starts_at_image())
    for (const Point_in_face<NT>& end : w.end) result = (std::min)(result, w.distance_at(end) + length(p - end));
  return result;
}

// The least length of a path to p through some of the windows, also around their ends: an upper bound of the distance.
template <class NT>
NT least_path_length(const std::vector<Voronoi_window<NT>>& windows, const std::vector<unsigned>& chosen,
                     const Point_in_face<NT>& p)
{
  NT result = std::numeric_limits<NT>::infinity();
  for (const unsigned i : chosen) result = (std::min)(result, windows[i].rays.path_length(p));
  return result;
}

// The nearest of some windows to a point, the least distance from a label, and the nearest window with it whose rays hold at
// the point.
template <class NT>
struct Nearest_windows
{
  static constexpr unsigned none = ~0u;
  unsigned any = none, with_label = none;
  NT distance = std::numeric_limits<NT>::infinity(), distance_with_label = std::numeric_limits<NT>::infinity();

  Nearest_windows(Index label, const std::vector<Voronoi_window<NT>>& windows, const std::vector<unsigned>& chosen,
                  const Point_in_face<NT>& p, NT slack)
  {
    NT least_straight = std::numeric_limits<NT>::infinity();
    for (const unsigned i : chosen)
    {
      bool is_straight;
      const NT d = distance_through(windows[i], p, slack, is_straight);
      if (d < distance)
      {
        distance = d;
        any = i;
      }
      if (windows[i].label != label) continue;
      distance_with_label = (std::min)(distance_with_label, d);
      if (!is_straight || !(d < least_straight)) continue;
      least_straight = d;
      with_label = i;
    }
  }

  bool label_is_nearest(NT tie) const { return distance_with_label <= distance + tie; }
};

// The least distance through the windows with a label; infinite if there are none.
template <class NT>
NT least_distance_from(Index label, const std::vector<Voronoi_window<NT>>& windows, const std::vector<unsigned>& chosen,
                       const Point_in_face<NT>& p, NT slack)
{
  NT result = std::numeric_limits<NT>::infinity();
  for (const unsigned i : chosen)
    if (bool is_straight; windows[i].label == label)
      result = (std::min)(result, distance_through(windows[i], p, slack, is_straight));
  return result;
}

// Least length of the paths through the chords of the windows with a label, also where a common ray ends their cones; infinite if
// there are none.
template <class NT>
NT least_path_length_from(Index label, const std::vector<Voronoi_window<NT>>& windows, const std::vector<unsigned>& chosen,
                          const Point_in_face<NT>& p)
{
  NT result = std::numeric_limits<NT>::infinity();
  for (const unsigned i : chosen)
    if (windows[i].label == label) result = (std::min)(result, windows[i].rays.path_length(p));
  return result;
}

} // namespace CGAL::Geodesic_offset::internal

#endif
