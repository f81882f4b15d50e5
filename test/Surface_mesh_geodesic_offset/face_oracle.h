// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Level of a distance field in one face as an exact arrangement. The region {D < d} in a face is the union over its windows
// of the points on rays of the window nearer than d: a cone within a disk, or a strip within a half-plane, clipped by the
// face. The coordinates of windows are doubles, hence rational, and CGAL's circle and segment traits unite the regions
// exactly. The oracle shares no code with the tracer.
//
// Windows are rounded, so the cones of neighbours may leave gaps as wide as rounding. Paths that bend at an end of a window
// are valid everywhere and close the gaps: they can be added as separate disks. The half strips on both sides of a source
// in the face are widened by `Oracle_unit::widening`, so that they meet at the source.

#ifndef GEODESIC_OFFSET_TEST_FACE_ORACLE_H
#define GEODESIC_OFFSET_TEST_FACE_ORACLE_H

#include "edge_profile.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Face_frame.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/General_polygon_set_2.h>
#include <CGAL/Gps_circle_segment_traits_2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace test {

/// A segment, or an arc counterclockwise around its center, given by its ends.
struct Chain_arc
{
  bool is_straight;
  Point_in_face start, end, center;
  double radius, turn;

  Chain_arc(const Point_in_face& start, const Point_in_face& end)
    : is_straight(true), start(start), end(end), center{0, 0}, radius(0), turn(0)
  {
  }
  Chain_arc(const Point_in_face& start, const Point_in_face& end, const Point_in_face& center, double radius)
    : is_straight(false), start(start), end(end), center(center), radius(radius), turn(angle_of(end))
  {
    if (turn > 1.5 * CGAL_PI) turn = 0; // no arc exceeds a half turn: its ends are one point up to rounding
  }

  Point_in_face at(double t) const
  {
    if (is_straight) return start + t * (end - start);
    const Point_in_face v = start - center;
    const double c = std::cos(t * turn), s = std::sin(t * turn);
    return center + Point_in_face{c * v.x - s * v.y, s * v.x + c * v.y};
  }

  double distance(const Point_in_face& p) const
  {
    if (is_straight)
    {
      const Point_in_face v = end - start;
      const double vv = dot(v, v), t = vv > 0 ? dot(p - start, v) / vv : 0;
      return length(p - at((std::max)(0., (std::min)(1., t))));
    }
    if (angle_of(p) <= turn) return std::abs(length(p - center) - radius);
    return (std::min)(length(p - start), length(p - end));
  }

  double twice_area_from(const Point_in_face& o) const
  {
    return cross(start - o, end - o) + radius * radius * (turn - std::sin(turn));
  }

private:
  // Counterclockwise angle from the start, from 0 to 2 pi.
  double angle_of(const Point_in_face& p) const
  {
    const double s = std::atan2(cross(start - center, p - center), dot(start - center, p - center));
    return s < 0 ? s + 2 * CGAL_PI : s;
  }
};

/// Part of the boundary of a region inside a face: a curve with the region on its left.
struct Level_chain
{
  bool is_closed;
  double from, to; // on the boundary of the face: k + t at parameter t of halfedge k; open chains only
  std::vector<Chain_arc> arcs;

  double distance(const Point_in_face& p) const
  {
    double best = std::numeric_limits<double>::infinity();
    for (const Chain_arc& a : arcs) best = (std::min)(best, a.distance(p));
    return best;
  }
};

/// Connections of the chains in a face, independent of their shape.
class Chain_topology
{
public:
  Chain_topology() = default;
  explicit Chain_topology(const std::vector<Level_chain>& chains)
  {
    struct End
    {
      double position;
      std::size_t chain;
      bool is_start;
    };
    std::vector<End> ends;
    for (std::size_t i = 0; i < chains.size(); ++i)
    {
      if (chains[i].is_closed)
      {
        ++(is_counterclockwise(chains[i]) ? loops_round_sources_ : loops_round_maxima_);
        continue;
      }
      ends.push_back({chains[i].from, i, true});
      ends.push_back({chains[i].to, i, false});
    }
    std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) { return a.position < b.position; });
    for (std::size_t i = 0; i < ends.size(); ++i)
      for (std::size_t j = 0; j < ends.size(); ++j)
        if (i != j && ends[i].chain == ends[j].chain)
        {
          const int way = int((j + ends.size() - i) % ends.size());
          partners_.push_back(ends[i].is_start ? way : -way);
        }
  }

  std::size_t number_of_open_chains() const { return partners_.size() / 2; }
  std::size_t number_of_loops() const { return loops_round_sources_ + loops_round_maxima_; }

  /// Equal if there are as many loops of each kind, and the ends around the face are connected equally. Ends at a corner
  /// may be on either edge.
  bool operator==(const Chain_topology& other) const
  {
    if (loops_round_sources_ != other.loops_round_sources_ || loops_round_maxima_ != other.loops_round_maxima_ ||
        partners_.size() != other.partners_.size())
      return false;
    if (partners_.empty()) return true;
    std::vector<int> turned = other.partners_;
    for (std::size_t i = 0; i < turned.size(); ++i)
    {
      if (turned == partners_) return true;
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    }
    return false;
  }

private:
  static bool is_counterclockwise(const Level_chain& chain)
  {
    double area = 0;
    for (const Chain_arc& a : chain.arcs) area += a.twice_area_from(chain.arcs[0].start);
    return area > 0;
  }

  std::size_t loops_round_sources_ = 0, loops_round_maxima_ = 0;
  std::vector<int> partners_; // ends around the face: offset of the partner; negative at the end of a chain
};

/// Regions of one face.
class Face_oracle
{
public:
  typedef CGAL::Exact_predicates_exact_constructions_kernel Exact_kernel;
  typedef CGAL::Gps_circle_segment_traits_2<Exact_kernel> Region_traits;
  typedef CGAL::General_polygon_set_2<Region_traits> Region;
  typedef Region_traits::Polygon_2 Region_polygon;
  typedef Region_traits::Polygon_with_holes_2 Region_part;
  typedef Region_traits::Curve_2 Curve;
  typedef Region_traits::X_monotone_curve_2 Monotone_curve;
  typedef Exact_kernel::FT Exact;
  typedef Exact_kernel::Point_2 Exact_point;

  /// `widening`: of strips that start in the face. `with_bent_paths`: include paths that bend at the ends of windows and at
  /// corners.
  Face_oracle(const Face_field& field, double widening, bool with_bent_paths) : frame_(field.frame()), widening_(widening)
  {
    namespace internal = CGAL::Geodesic_offset::internal;
    for (int k = 0; k < 3; ++k) corner_[std::size_t(k)] = exact(frame_.corner(k));
    for (std::size_t i = 0; i < field.windows().size(); ++i)
    {
      const Face_window& w = field.windows()[i];
      const bool is_corner = w.origin == internal::STARTS_AT_CORNER;
      if (is_corner && w.is_empty() && !with_bent_paths) continue;
      const bool is_everywhere = !w.is_parallel() && w.origin >= internal::STARTS_IN_FACE;
      add_part(w, field.lowest(i), cone(w, is_everywhere));
      if (!with_bent_paths || w.origin >= internal::STARTS_IN_FACE) continue;
      for (const Point_in_face& p : {w.left, w.right})
      {
        Face_window bent = w;
        bent.x = p.x;
        bent.y = p.y;
        bent.sigma = w.distance_at(p);
        bent.bits = 0;
        add_part(bent, bent.sigma, std::vector<Exact_point>(corner_.begin(), corner_.end()));
      }
    }
  }

  std::size_t number_of_windows() const { return parts_.size(); }

  /// Points nearer than d.
  Region nearer_than(double d) const
  {
    std::vector<Region> regions; // regions cannot be moved
    regions.reserve(parts_.size());
    for (const Part& part : parts_)
      if (part.lowest < d + widening_) add(part, d, regions);
    return united(regions);
  }

  /// Boundary of a region inside the face.
  std::vector<Level_chain> chains(const Region& region) const
  {
    std::vector<Region_part> parts;
    region.polygons_with_holes(std::back_inserter(parts));
    std::vector<Level_chain> result;
    for (const Region_part& part : parts)
    {
      add_chains(part.outer_boundary(), result);
      for (auto hole = part.holes_begin(); hole != part.holes_end(); ++hole) add_chains(*hole, result);
    }
    return result;
  }

private:
  struct Part
  {
    Face_window window;
    double lowest;                 // lower bound of distances, up to the widening
    std::vector<Exact_point> cone; // points of the face on the rays, counterclockwise
  };

  // 8 units in the last place: ends of windows this near a corner, relative to their edge, are there, and images this near an
  // entry edge, relative to the longest edge, are on it.
  static constexpr double edge_rounding = 1.8e-15;

  // End of a window, exactly on its entry edge: rounding off the edge could exclude a part of the edge if rays are parallel
  // to it. Snaps to corners.
  Exact_point end(const Face_window& w, const Point_in_face& p) const
  {
    if (w.origin >= CGAL::Geodesic_offset::internal::STARTS_IN_FACE) return exact(p);
    const double t = frame_.along(w.origin, p) / frame_.edge_length(w.origin);
    const Exact_point &a = corner_[w.origin], &b = corner_[(w.origin + 1u) % 3];
    return t <= edge_rounding ? a : t >= 1 - edge_rounding ? b : a + Exact(t) * (b - a);
  }

  // Whether the image is a point of the window's edge between its ends: rays then go into all directions of the face. Rounding of
  // the image could put the rays along the edge beside it.
  bool is_source_on_edge(const Face_window& w) const
  {
    if (w.is_parallel() || w.origin >= CGAL::Geodesic_offset::internal::STARTS_IN_FACE) return false;
    const Point_in_face image{w.x, w.y};
    return std::abs(frame_.height(w.origin, image)) <= edge_rounding * frame_.longest_edge() &&
           dot(w.left - image, w.right - image) < 0;
  }

  void add_part(const Face_window& w, double lowest, std::vector<Exact_point> cone)
  {
    if (cone.size() > 2) parts_.push_back(Part{w, lowest, std::move(cone)});
  }

  // a x + b y + c, with the coefficients of a double computation.
  struct Half_plane
  {
    Exact a, b, c;
    Exact at(const Exact_point& p) const { return a * p.x() + b * p.y() + c; }
  };

  static Exact_point exact(const Point_in_face& p) { return Exact_point(p.x, p.y); }

  // Left side of the ray with direction v through p, widened to its right.
  static Half_plane left_of(const Exact_point& p, const Exact& vx, const Exact& vy, double widening)
  {
    const double l = std::hypot(CGAL::to_double(vx), CGAL::to_double(vy));
    return {-vy, vx, Exact(vy * p.x() - vx * p.y() + Exact(widening * l))};
  }

  std::vector<Exact_point> cone(const Face_window& w, bool is_everywhere) const
  {
    std::vector<Exact_point> polygon(corner_.begin(), corner_.end());
    if (is_everywhere || is_source_on_edge(w)) return polygon;
    const Exact_point right = end(w, w.right), left = end(w, w.left);
    const auto direction = [&](const Exact_point& p, Exact& x, Exact& y) {
      x = w.is_parallel() ? Exact(-w.x) : Exact(p.x() - Exact(w.x));
      y = w.is_parallel() ? Exact(-w.y) : Exact(p.y() - Exact(w.y));
    };
    const bool starts_in_face = w.origin == CGAL::Geodesic_offset::internal::STARTS_IN_FACE;
    const double widening = starts_in_face ? widening_ : 0;
    Exact x, y;
    direction(right, x, y);
    clip(left_of(right, x, y, widening), polygon);
    direction(left, x, y);
    clip(left_of(left, Exact(-x), Exact(-y), widening), polygon);
    if (w.is_parallel() && starts_in_face) clip({Exact(-w.x), Exact(-w.y), Exact(Exact(w.sigma) + Exact(widening_))}, polygon);
    return polygon;
  }

  // Clips to the part where the function is not negative.
  static void clip(const Half_plane& h, std::vector<Exact_point>& polygon)
  {
    std::vector<Exact_point> result;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Exact_point &p = polygon[i], &q = polygon[(i + 1) % polygon.size()];
      const Exact at_p = h.at(p), at_q = h.at(q);
      if (at_p >= 0) result.push_back(p);
      if ((at_p > 0 && at_q < 0) || (at_p < 0 && at_q > 0))
      {
        const Exact t = at_p / (at_p - at_q);
        result.push_back(Exact_point(p.x() + t * (q.x() - p.x()), p.y() + t * (q.y() - p.y())));
      }
    }
    result.erase(std::unique(result.begin(), result.end()), result.end());
    while (result.size() > 1 && result.front() == result.back()) result.pop_back();
    polygon = std::move(result);
  }

  static Region_polygon as_region(const std::vector<Exact_point>& polygon)
  {
    Region_polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i)
      result.push_back(Monotone_curve(polygon[i], polygon[(i + 1) % polygon.size()]));
    return result;
  }

  static Region_polygon disk(const Exact_point& center, const Exact& radius)
  {
    Region_polygon result;
    const Region_traits traits;
    std::vector<CGAL::Object> arcs;
    traits.make_x_monotone_2_object()(Curve(Exact_kernel::Circle_2(center, radius * radius)), std::back_inserter(arcs));
    for (const CGAL::Object& o : arcs)
    {
      Monotone_curve arc;
      if (CGAL::assign(arc, o)) result.push_back(arc);
    }
    return result;
  }

  // By pairs of regions. The union of a range sweeps several of them at once; where three boundaries overlap, CGAL 5.5 then
  // depends on the order of addresses, and can start a common part at the wrong event (Surface_sweep_2::_intersect()).
  // Between two regions, no more than two boundaries overlap.
  static Region united(std::vector<Region>& regions)
  {
    if (regions.empty()) return Region();
    for (std::size_t step = 1; step < regions.size(); step *= 2)
      for (std::size_t i = 0; i + step < regions.size(); i += 2 * step)
      {
        regions[i].join(regions[i + step]);
        regions[i + step].clear();
      }
    return regions.front();
  }

  // Adds the part's points nearer than d.
  void add(const Part& part, double d, std::vector<Region>& regions) const
  {
    const Face_window& w = part.window;
    if (w.is_parallel())
    {
      std::vector<Exact_point> polygon = part.cone;
      clip({Exact(w.x), Exact(w.y), Exact(Exact(d) - Exact(w.sigma))}, polygon);
      if (polygon.size() > 2) regions.emplace_back(as_region(polygon));
      return;
    }
    const Exact radius = Exact(d) - Exact(w.sigma);
    if (radius <= 0) return;
    const Exact_point center(w.x, w.y);
    const Exact squared = radius * radius;
    regions.emplace_back(as_region(part.cone));
    if (std::any_of(part.cone.begin(), part.cone.end(),
                    [&](const Exact_point& p) { return CGAL::squared_distance(center, p) > squared; }))
      regions.back().intersection(disk(center, radius));
  }

  // Of the exact number: to_double() of a lazy one is right to 1e-5 only.
  static double rounded(const Exact& x) { return CGAL::to_double(CGAL::exact(x)); }

  // a + b sqrt(c). If the terms cancel, their difference is the exact difference of their squares over their sum.
  template <class Root_extension>
  static double rounded(const Root_extension& x)
  {
    if (!x.is_extended()) return rounded(x.a0());
    const double a = rounded(x.a0()), b = rounded(x.a1()) * std::sqrt(rounded(x.root()));
    if (a * b >= 0) return a + b;
    return rounded(Exact(x.a0() * x.a0() - x.a1() * x.a1() * x.root())) / (a - b);
  }

  template <class Point>
  static Point_in_face rounded_point(const Point& p)
  {
    return {rounded(p.x()), rounded(p.y())};
  }

  // Halfedge that contains a curve of a boundary, or 3 if the curve is inside the face.
  int side_of(const Monotone_curve& curve) const
  {
    if (!curve.is_linear()) return 3;
    const auto line = curve.supporting_line();
    for (int k = 0; k < 3; ++k)
      if (line.has_on(corner_[k]) && line.has_on(corner_[(k + 1) % 3])) return k;
    return 3;
  }

  double position(int k, const Point_in_face& p) const
  {
    return k + (std::max)(0., (std::min)(1., frame_.along(k, p) / frame_.edge_length(k)));
  }

  void add_chains(const Region_polygon& boundary, std::vector<Level_chain>& result) const
  {
    const std::vector<Monotone_curve> curves(boundary.curves_begin(), boundary.curves_end());
    const std::size_t n = curves.size();
    std::vector<int> side;
    for (const Monotone_curve& c : curves) side.push_back(side_of(c));
    const auto first = std::find_if(side.begin(), side.end(), [](int k) { return k < 3; });
    if (first == side.end())
    {
      Level_chain loop{true, 0, 0, {}};
      for (const Monotone_curve& c : curves) loop.arcs.push_back(rounded_arc(c));
      return result.push_back(std::move(loop));
    }
    const std::size_t start = std::size_t(first - side.begin());
    for (std::size_t i = 0; i < n; ++i)
    { // start at each inner curve that follows one on the boundary
      std::size_t j = (start + i) % n;
      const std::size_t next = (j + 1) % n;
      if (side[j] == 3 || side[next] < 3) continue;
      Level_chain chain{false, position(side[j], rounded_point(curves[j].target())), 0, {}};
      for (j = next; side[j] == 3; j = (j + 1) % n) chain.arcs.push_back(rounded_arc(curves[j]));
      chain.to = position(side[j], rounded_point(curves[j].source()));
      result.push_back(std::move(chain));
    }
  }

  // Regions are unions of disks, so all arcs are counterclockwise.
  static Chain_arc rounded_arc(const Monotone_curve& curve)
  {
    const Point_in_face a = rounded_point(curve.source()), b = rounded_point(curve.target());
    if (curve.is_linear()) return Chain_arc(a, b);
    const auto circle = curve.supporting_circle();
    return Chain_arc(a, b, rounded_point(circle.center()), std::sqrt(rounded(circle.squared_radius())));
  }

  const CGAL::Geodesic_offset::internal::Face_frame<double> frame_;
  const double widening_;
  std::array<Exact_point, 3> corner_;
  std::vector<Part> parts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_FACE_ORACLE_H
