// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Judge of offset curves that uses the distance field and no knowledge of the construction of the curves.
//
// The curves of a level d must bound a region R with {D < c - e} in R and R in {D < c + e}, where c is the distance at
// which level d is cut, and e the rounding of distances. So the topology is free at critical levels within rounding, and
// only there:
// - the curves are closed or end on the border, and their pieces are joined;
// - all points of the pieces lie in their faces and on the level, and pieces turn by at most pi;
// - along each edge, the crossings separate the points nearer than c - e from those farther than c + e. Both sets are
//   completely known from the windows that reach the edge;
// - in each face, the pieces separate witnesses: samples, corners, and the local maxima of the distance;
// - the area of R in each face, by Green's theorem, lies between 0 and that of the face.

#ifndef GEODESIC_OFFSET_TEST_LEVEL_JUDGE_H
#define GEODESIC_OFFSET_TEST_LEVEL_JUDGE_H

#include "field_features.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace test {

/// Faults of the curves of a level.
enum Fault : unsigned char {
  GAP,      // pieces do not join, or a curve ends inside the surface
  OUTSIDE,  // a point lies outside of its face
  OFF,      // a point is off the level
  TURN,     // an arc turns by more than pi or backwards, a length is negative, or a segment runs backwards
  EDGE,     // crossings of an edge do not separate near points from far ones
  VERTEX,   // edges at a vertex put it on different sides
  FACE,     // pieces do not separate near witnesses in a face from far ones
  AREA,     // the near area of a face, or its growth with the level, is impossible
  SIDES,    // the offsets of both sides do not add up to the whole offset
  ONE_PASS, // curves cut during the propagation differ from those cut from kept windows
  NUMBER_OF_FAULTS
};

inline const char* name_of(Fault fault)
{
  static const char* const names[] = {"gap", "outside", "off", "turn", "edge", "vertex", "face", "area", "sides", "one pass"};
  return names[fault];
}

/// Judgement on the curves of one level.
struct Verdict
{
  std::size_t faults[NUMBER_OF_FAULTS] = {};
  std::vector<std::string> texts; // first fault of each kind
  double area = 0, length = 0;    // of the near region, and of the curves
  std::size_t pieces = 0;
  double worst_gap = 0, worst_outside = 0, worst_off = 0; // in levels plus diagonals

  bool is_right() const
  {
    return std::all_of(faults, faults + NUMBER_OF_FAULTS, [](std::size_t n) { return n == 0; });
  }

  template <class... Values>
  void add(Fault fault, const char* format, Values... values)
  {
    if (faults[fault]++ > 0) return;
    char buffer[256];
    std::snprintf(buffer, sizeof(buffer), format, values...);
    texts.push_back(std::string(name_of(fault)) + ": " + buffer);
  }
};

/// Judges the curves of a field that was built with kept windows.
class Level_judge
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;
  typedef Judged_surface::Face Face;
  typedef Judged_surface::Weights Weights;

  Level_judge(const Judged_surface& surface, const Field_features& features)
    : surface_(surface), features_(features), layout_(surface), labels_(surface.number_of_vertices())
  {
  }

  /// `curves`: all curves of the level, as a range of pointers to `Geodesic::Offset_curve`, or to a type with the same
  /// functions.
  template <class Curves>
  Verdict judge(double level, const Curves& curves)
  {
    Verdict verdict;
    cut_ = cut_of(level);
    scale_ = cut_ + surface_.diagonal();
    position_ = Judge_tolerances::position * scale_;
    margin_ = Judge_tolerances::side * scale_;
    clear();
    for (const auto* curve : curves) walk(*curve, verdict);
    if (verdict.faults[GAP] > 0) return verdict; // sides need closed curves
    judge_edges(verdict);
    judge_faces(verdict);
    return verdict;
  }

private:
  static constexpr signed char unknown = -1;

  void clear()
  {
    layout_.clear();
    undecided_edges_.clear();
    std::fill(labels_.begin(), labels_.end(), unknown);
  }

  // Curves

  template <class Curve>
  void walk(const Curve& curve, Verdict& verdict)
  {
    const std::size_t n = curve.number_of_pieces();
    if (n == 0) return verdict.add(GAP, "%s", "a curve without pieces");
    verdict.pieces += n;
    std::size_t longest = 0;
    double longest_length = -1;
    for (std::size_t i = 0; i < n; ++i)
    {
      const auto piece = curve.piece(i);
      const double l = piece.length();
      verdict.length += l;
      if (l > longest_length)
      {
        longest = i;
        longest_length = l;
      }
      examine(piece, !curve.is_closed() && i + 1 == n, verdict);
      if (i + 1 < n) join(piece, curve.piece(i + 1), verdict);
    }
    if (curve.is_closed()) join(curve.piece(n - 1), curve.piece(0), verdict);
    else
    {
      for (const bool is_start : {true, false})
        if (!layout_.add_end(curve.piece(is_start ? 0 : n - 1), is_start))
          verdict.add(GAP, "an open curve ends inside the surface, in face %u",
                      surface_.index_of(curve.piece(is_start ? 0 : n - 1).face()));
    }
    examine_side(curve.piece(longest), verdict);
  }

  template <class Piece>
  void examine(const Piece& piece, bool is_last, Verdict& verdict)
  {
    const Index f = surface_.index_of(piece.face());
    const Face face = surface_.face_at(f);
    const Curve_arc arc(piece);
    layout_.add_arc(f, arc);

    const double length = piece.length();
    if (!(length >= 0 && arc.angle >= 0 && arc.angle <= CGAL_PI + Judge_tolerances::angle))
      verdict.add(TURN, "face %u: length %.6g, angle %.6g", f, length, arc.angle);
    const Point_in_face chord = arc.end - arc.start;
    if (arc.is_straight)
    {
      if (cross(arc.center, chord) < -position_)
        verdict.add(TURN, "face %u: a segment runs backwards by %.3g", f, cross(arc.center, chord));
    }
    else
    {
      const double off = std::abs(CGAL::Geodesic_offset::internal::length(chord) - 2 * arc.radius * std::sin(arc.angle / 2));
      if (!(off <= position_)) verdict.add(TURN, "face %u: the chord of an arc is off by %.3g", f, off);
    }

    const int parts = length > Sampling::long_piece * scale_ ? 4 : 2;
    for (int i = 0; i < parts + (is_last ? 1 : 0); ++i)
    {
      const auto location = piece.location(double(i) / parts);
      const Weights w{{location.second[0], location.second[1], location.second[2]}};
      const Point_in_face p = face.point(w);
      const double outside = face.outside(p);
      verdict.worst_outside = (std::max)(verdict.worst_outside, outside / scale_);
      if (!(outside <= position_))
      {
        verdict.add(OUTSIDE, "face %u: a point lies %.3g outside", f, outside);
        continue;
      }
      const double off = (std::max)(std::abs(surface_.distance_at(f, w) - cut_), arc.off(p));
      verdict.worst_off = (std::max)(verdict.worst_off, off / scale_);
      if (!(off <= position_)) verdict.add(OFF, "face %u: a point is off its level by %.3g", f, off);
    }
  }

  // On the left of a piece, distances decrease at unit rate.
  template <class Piece>
  void examine_side(const Piece& piece, Verdict& verdict) const
  {
    const Index f = surface_.index_of(piece.face());
    const Face face = surface_.face_at(f);
    const Curve_arc arc(piece);
    const Point_in_face p = plain(piece.point_2(0.5));
    if (face.outside(p) > 0) return;
    Point_in_face left = -1. * arc.center;
    if (!arc.is_straight) left = (1 / length(arc.center - p)) * (arc.center - p);
    double way = (std::min)(face.exit_distance(p, left), cut_);
    if (!arc.is_straight) way = (std::min)(way, arc.radius);
    way /= 2;
    if (!(way > Judge_tolerances::steps_to_left * position_)) return;
    const double off = surface_.distance_at(face, p + way * left) - (cut_ - way);
    if (!(std::abs(off) <= position_))
      verdict.add(OFF, "face %u: %.3g left of a piece, the distance is off by %.3g", f, way, off);
  }

  template <class Piece>
  void join(const Piece& a, const Piece& b, Verdict& verdict)
  {
    const auto end = a.end(), start = b.start();
    const Index f = surface_.index_of(end.first), g = surface_.index_of(start.first);
    const double gap = Judged_surface::distance(surface_.point(f, weights(end)), surface_.point(g, weights(start)));
    verdict.worst_gap = (std::max)(verdict.worst_gap, gap / scale_);
    if (!(gap <= position_)) verdict.add(GAP, "%.3g between pieces in face %u and face %u", gap, f, g);
    if (!layout_.add_joint(a, b)) verdict.add(GAP, "pieces in face %u and face %u join over no edge", f, g);
  }

  // Edges

  void judge_edges(Verdict& verdict)
  {
    for (Index e = 0; e < Index(3 * surface_.number_of_faces()); ++e)
    {
      if (!surface_.is_used(e / 3) || surface_.twin(e) < e) continue;
      judge_edge(e, verdict);
    }
    spread_labels(verdict);
    for (std::size_t v = 0; v < labels_.size(); ++v)
    {
      if (labels_[v] != unknown) continue;
      labels_[v] = surface_.vertex_distance(Index(v)) < cut_;
      if (!undecided_edges_.empty()) spread_labels(verdict);
    }
  }

  // An edge whose points are all undecided, and that no curve crosses, has both ends on the same side.
  void spread_labels(Verdict& verdict)
  {
    std::size_t left = undecided_edges_.size() + 1;
    while (undecided_edges_.size() < left)
    {
      left = undecided_edges_.size();
      std::size_t kept = 0;
      for (const Index e : undecided_edges_)
      {
        const Index u = surface_.origin(e), v = surface_.target(e);
        if (labels_[u] != unknown) put_label(v, labels_[u], verdict);
        else if (labels_[v] != unknown) put_label(u, labels_[v], verdict);
        else undecided_edges_[kept++] = e;
      }
      undecided_edges_.resize(kept);
    }
  }

  void judge_edge(Index e, Verdict& verdict)
  {
    std::vector<Edge_crossing>& crossings = layout_.crossings(e);
    const Edge_profile& profile = features_.profiles[e];
    const Index vertex[2] = {surface_.origin(e), surface_.target(e)};
    const double d0 = surface_.vertex_distance(vertex[0]), d1 = surface_.vertex_distance(vertex[1]);
    const double eroded = Judge_tolerances::part_of_edge * scale_;
    if (crossings.empty() && !std::isfinite(d0)) return;
    if (crossings.empty() && (d0 + d1 + profile.length) / 2 < cut_ - margin_)
    { // all near
      put_label(vertex[0], 1, verdict);
      return put_label(vertex[1], 1, verdict);
    }
    std::sort(crossings.begin(), crossings.end(), [](const Edge_crossing& a, const Edge_crossing& b) { return a.t < b.t; });

    int base = unknown; // label of the first end
    const auto require = [&](double t, bool is_near) {
      int sum = 0;
      for (const Edge_crossing& c : crossings)
        if (c.t < t) sum += c.step;
      if (base == unknown) base = int(is_near) - sum;
      if (base + sum != int(is_near))
        verdict.add(EDGE, "the edge from vertex %u (%.3g) to vertex %u (%.3g), at %.6g of it, must be %s; %zu crossings",
                    vertex[0], d0 - cut_, vertex[1], d1 - cut_, t / profile.length, is_near ? "near" : "far", crossings.size());
    };
    if (std::abs(d0 - cut_) > margin_) require(-1, d0 < cut_);
    profile.nearer_than(cut_ - margin_, eroded, near_);
    for (const Interval& i : near_)
      if (i.length() > 2 * eroded) require(i.middle(), true);
    profile.nearer_than(cut_ + margin_, eroded, near_);
    double last = 0;
    near_.push_back({profile.length, profile.length});
    for (const Interval& i : near_)
    {
      if (i.from - last > 2 * eroded) require((last + i.from) / 2, false);
      last = i.to;
    }
    if (std::abs(d1 - cut_) > margin_) require(2 * profile.length, d1 < cut_);

    if (base == unknown && crossings.empty()) return undecided_edges_.push_back(e);
    int sum = 0, lowest = 0;
    for (const Edge_crossing& c : crossings)
    {
      sum += c.step;
      lowest = (std::min)(lowest, sum);
    }
    if (base == unknown) base = -lowest;
    // between crossings farther apart than rounding, the label is 0 or 1
    int label = base;
    for (std::size_t i = 0; i < crossings.size(); ++i)
    {
      label += crossings[i].step;
      if (i + 1 < crossings.size() && !(crossings[i + 1].t - crossings[i].t > eroded)) continue;
      if (label != 0 && label != 1)
        verdict.add(EDGE, "crossings of the edge from vertex %u to vertex %u do not alternate", vertex[0], vertex[1]);
    }
    put_label(vertex[0], base, verdict);
    put_label(vertex[1], base + sum, verdict);
  }

  void put_label(Index v, int label, Verdict& verdict)
  {
    if (labels_[v] != unknown && labels_[v] != label)
      verdict.add(VERTEX, "edges of vertex %u (%.3g) put it on different sides", v, surface_.vertex_distance(v) - cut_);
    labels_[v] = static_cast<signed char>(label);
  }

  // Faces

  void judge_faces(Verdict& verdict)
  {
    for (Index f = 0; f < Index(surface_.number_of_faces()); ++f)
      if (surface_.is_used(f) && std::isfinite(surface_.vertex_distance(surface_.origin(3 * f)))) judge_face(f, verdict);
  }

  void judge_face(Index f, Verdict& verdict)
  {
    const std::vector<Curve_arc>& arcs = layout_.arcs(f);
    const Face face = surface_.face_at(f);
    // compare with the point of the face whose side is most certain
    Witness reference{{0, 0}, cut_};
    const auto consider = [&](const Witness& w) {
      if (std::abs(w.distance - cut_) > std::abs(reference.distance - cut_)) reference = w;
    };
    for (int k = 0; k < 3; ++k) consider({face.corner[k], surface_.vertex_distance(surface_.origin(3 * f + Index(k)))});
    for (const Witness& w : features_.witnesses[f]) consider(w);
    if (std::abs(reference.distance - cut_) > margin_)
      for (const Witness& w : features_.witnesses[f])
      {
        if (std::abs(w.distance - cut_) <= margin_) continue;
        const bool separated = (w.distance < cut_) != (reference.distance < cut_);
        if (are_separated(arcs, reference.point, w.point) != separated &&
            are_separated_by_detours(arcs, face, reference.point, w.point) != separated)
          verdict.add(FACE, "face %u: the point (%.17g, %.17g), %.3g off the level, is on the wrong side", f, w.point.x,
                      w.point.y, w.distance - cut_);
      }

    const double area = layout_.near_area(face, [&](Index v) { return labels_[v] == 1; });
    verdict.area += area;
    const double tolerance = position_ * (face.edge_length(0) + face.edge_length(1) + face.edge_length(2));
    if (!(area >= -tolerance && area <= face.area() + tolerance))
      verdict.add(AREA, "face %u: the near part is %.6g of the face, %.6g", f, area / face.area(), area);
  }

  static bool are_separated(const std::vector<Curve_arc>& arcs, const Point_in_face& p, const Point_in_face& q)
  {
    bool result = false;
    for (const Curve_arc& arc : arcs) result ^= arc.separates(p, q);
    return result;
  }

  // The straight segment may lead through a joint of two arcs, where rounding lets it cross both or neither, as on
  // symmetric meshes. The majority of three other paths decides.
  static bool are_separated_by_detours(const std::vector<Curve_arc>& arcs, const Face& face, const Point_in_face& p,
                                       const Point_in_face& q)
  {
    int count = 0;
    for (const Weights& w : {Weights{{0.21, 0.34, 0.45}}, Weights{{0.37, 0.19, 0.44}}, Weights{{0.46, 0.31, 0.23}}})
    {
      const Point_in_face between = face.point(w);
      count += are_separated(arcs, p, between) != are_separated(arcs, between, q) ? 1 : 0;
    }
    return count >= 2;
  }

  template <class Location>
  static Weights weights(const Location& l)
  {
    return {{l.second[0], l.second[1], l.second[2]}};
  }

  const Judged_surface& surface_;
  const Field_features& features_;
  double cut_ = 0, scale_ = 0;
  double position_ = 0, margin_ = 0; // Judge_tolerances::position and side, as lengths
  Level_layout layout_;
  std::vector<Index> undecided_edges_;
  std::vector<signed char> labels_; // by vertex: 1 near, 0 far
  std::vector<Interval> near_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_LEVEL_JUDGE_H
