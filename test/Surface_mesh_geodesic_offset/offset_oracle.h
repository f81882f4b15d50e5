// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Comparison of the tracer's result for one level in one face with the exact arrangement of the same windows: the same
// gates are connected, the same loops exist, and the Hausdorff distance of the chains is within rounding.
//
// The tracer's topology must be that of the exact level, or of the exact level lowered or raised by `Oracle_unit::margin`:
// then the topology changes within that multiple of rounding, and both results are correct. If several events are that
// close to one level, or the level runs along an edge, the chains must bound the region nearer than the level of some
// distance that differs from the exact one by at most the margin: no point of the chains is farther from the level, and all
// points that are nearer, or farther, by more than twice the margin are on the correct side. Chains of the size of rounding
// prove that the topology changes within rounding, and are not compared. Any other deviation is a difference.

#ifndef GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H
#define GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H

#include "face_oracle.h"
#include "field_features.h"
#include "geodesic_types.h"

#include <CGAL/Surface_mesh_geodesic_offset/internal/offsets/Face_cutting.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <limits>
#include <string>
#include <vector>

namespace test {

/// Lengths in units of the level plus the longest edge of the faces around the corners of the face, as in Vertex_reach. The unit
/// bounds the coordinates of all images whose circles cross the face, and of those in the faces that their windows come from.
struct Oracle_unit
{
  /// Widening of strips that start in the face, so that the strips on both sides of a source meet: 2^9 units in the last
  /// place.
  static constexpr double widening = 1.2e-13;
  /// Levels within this of a change of topology are undecided: 2^11 units in the last place, twice the shift of level cuts
  /// (see the manual).
  static constexpr double margin = 4.6e-13;
  /// Chains within this distance are equal: 2^14 units in the last place, the size of cells that the tracer does not
  /// divide. Other chains must be as close as exact chains of levels that differ by the margin.
  static constexpr double apart = 3.7e-12;
};

/// Geodesic object whose faces can be cut one by one.
class Cut_geodesic : public Open_geodesic
{
public:
  using Open_geodesic::Open_geodesic;

  const auto& mesh() const { return data().unfolded(); }
  const auto& initial() const { return last_build().initial; }
  const auto& field() const { return last_build().field; }
};

/// The tracer's chains of single levels in single faces.
class Face_tracing
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;
  typedef CGAL::Geodesic_offset::internal::Unfolded_mesh<double> Mesh;
  typedef CGAL::Geodesic_offset::internal::Initial_windows<double> Initial;
  typedef CGAL::Geodesic_offset::internal::Geodesic_field<double> Field;

  Face_tracing(const Mesh& mesh, const Initial& initial, const Field& field)
    : mesh_(mesh), initial_(initial), field_(field), reach_(mesh), sources_(initial, field, reach_),
      longest_at_(mesh.number_of_vertices(), 0), cut_(mesh, initial, field), windows_(mesh, initial, field)
  {
    for (Index f = 0; 3 * f < mesh.number_of_halfedges(); ++f)
    {
      if (mesh.source(3 * f) == CGAL::Geodesic_offset::internal::no_index) continue;
      const double longest = longest_edge(f);
      for (Index h = 3 * f; h < 3 * f + 3; ++h) longest_at_[mesh.source(h)] = (std::max)(longest_at_[mesh.source(h)], longest);
    }
  }

  std::vector<Level_chain> operator()(Index face, double level)
  {
    const CGAL::Offset_levels<double> levels(std::vector<double>{level});
    CGAL::Geodesic_offset::internal::Face_cutting<double> cutting(mesh_, initial_, field_, reach_, sources_, levels,
                                                                  field_.maximum, {});
    cut_.levels = cutting.levels_of(face, field_.maximum);
    cutting.find_crossings(face, field_.maximum, {0, 0, 0}, cut_); // on all three edges
    std::vector<double> position;                                  // of gates
    for (int k = 0; k < 3; ++k)
      for (auto& c : cut_.crossings[std::size_t(k)])
      {
        c.gate = Index(position.size());
        position.push_back(position_of(3 * face + Index(k), c.position));
      }
    cutting.find_chains(cut_);
    forced_joints_ += cutting.number_of_forced_joints();

    std::vector<Level_chain> chains;
    for (const auto& c : cut_.chains)
    {
      const bool is_loop = c.start == CGAL::Geodesic_offset::internal::no_index;
      Level_chain chain{is_loop, is_loop ? 0 : position[c.start], is_loop ? 0 : position[c.end], {}};
      for (std::size_t i = c.first; i < c.last; ++i)
      {
        const auto& p = (*cut_.pieces)[i];
        if (p.is_straight) chain.arcs.emplace_back(p.start, p.end);
        else chain.arcs.emplace_back(p.start, p.end, p.center, p.radius);
      }
      chains.push_back(std::move(chain));
    }
    return chains;
  }

  /// Windows of the face, which becomes the current one.
  const Face_field& windows_of(Index face)
  {
    windows_.set_face(face);
    return windows_;
  }
  const Face_field& windows() const { return windows_; }

  /// The longest edge of the faces around the corners of a face.
  double size_about(Index face) const
  {
    double size = 0;
    for (Index h = 3 * face; h < 3 * face + 3; ++h) size = (std::max)(size, longest_at_[mesh_.source(h)]);
    return size;
  }

  std::size_t number_of_forced_joints() const { return forced_joints_; }

private:
  double longest_edge(Index face) const
  {
    return (std::max)({mesh_[3 * face].length, mesh_[3 * face + 1].length, mesh_[3 * face + 2].length});
  }

  // On the boundary of a face, from 0 to 3. `t`: position of a crossing on the edge of h.
  double position_of(Index h, double t) const
  {
    const double length = mesh_[h].length, along = mesh_.twin(h) < h ? length - t : t;
    return h % 3 + (std::max)(0., (std::min)(1., along / length));
  }

  const Mesh& mesh_;
  const Initial& initial_;
  const Field& field_;
  const CGAL::Geodesic_offset::internal::Vertex_reach<double> reach_;
  const CGAL::Geodesic_offset::internal::Offset_sources<double> sources_;
  std::vector<double> longest_at_; // per vertex, the longest edge of its faces
  CGAL::Geodesic_offset::internal::Face_cut<double> cut_;
  Face_field windows_; // of the current face
  std::size_t forced_joints_ = 0;
};

struct Oracle_counts
{
  std::size_t faces = 0;                                    // compared faces, each at one level
  std::size_t empty = 0;                                    // of these, not crossed by the level
  std::size_t chains = 0, loops = 0, arcs = 0, windows = 0; // in these; arcs are the tracer's
  std::size_t with_points = 0;                              // with chains of the size of rounding, which are not compared
  std::size_t near_event = 0;                               // with the topology of a level within the margin
  std::size_t within_band = 0;                              // with chains that bound the level of a distance within the margin
  // Chains deviate by more than rounding, and so do those of exact levels within the margin.
  std::size_t ill_conditioned = 0;
  std::size_t left_out = 0;  // faces with too many windows
  std::size_t topology = 0;  // differences: connections of gates, or loops
  std::size_t apart = 0;     // differences: distance of chains
  std::size_t forced = 0;    // joints
  std::size_t thrown = 0;    // exceptions
  double worst_distance = 0; // of chains that are not ill-conditioned, in units

  void add(const Oracle_counts& o)
  {
    faces += o.faces;
    empty += o.empty;
    chains += o.chains;
    loops += o.loops;
    arcs += o.arcs;
    windows += o.windows;
    with_points += o.with_points;
    near_event += o.near_event;
    within_band += o.within_band;
    ill_conditioned += o.ill_conditioned;
    left_out += o.left_out;
    topology += o.topology;
    apart += o.apart;
    forced += o.forced;
    thrown += o.thrown;
    worst_distance = (std::max)(worst_distance, o.worst_distance);
  }
  std::size_t differences() const { return topology + apart + forced + thrown; }
};

class Offset_oracle
{
public:
  typedef Face_tracing::Index Index;
  typedef std::vector<Level_chain> Chains;

  std::size_t most_windows = 80; // faces with more are skipped: exact unions are slow

  Oracle_counts counts;

  /// Compares one level in one face. Calls `report(text)` for differences.
  template <class Function>
  void compare(Face_tracing& tracing, Index face, double level, const Function& report)
  {
    if (tracing.windows_of(face).windows().size() > most_windows)
    {
      ++counts.left_out;
      return;
    }
    const auto report_level = [&](const std::string& text) {
      char buffer[64];
      std::snprintf(buffer, sizeof(buffer), "face %u, level %.17g: ", face, level);
      report(buffer + text + text_of(tracing.windows()));
    };
    ++counts.faces;
    try
    {
      const std::size_t forced = tracing.number_of_forced_joints();
      const Chains actual = tracing(face, level);
      if (tracing.number_of_forced_joints() > forced)
      {
        ++counts.forced;
        report_level("forced joints");
      }
      const double unit = level + tracing.size_about(face);
      compare(tracing.windows_of(face), cut_of(level), unit, actual, report_level);
    }
    catch (const std::exception& e)
    {
      ++counts.thrown;
      report_level(e.what());
    }
  }

  /// Overload for given chains. `unit`: see Oracle_unit.
  template <class Function>
  void compare(const Face_field& field, double cut, double unit, const Chains& all_actual, const Function& report)
  {
    counts.windows += field.windows().size();
    for (const Level_chain& c : all_actual) counts.arcs += c.arcs.size();
    const double apart = Oracle_unit::apart * unit, margin = Oracle_unit::margin * unit;
    const Chains actual = without_points(all_actual, apart);
    counts.with_points += actual.size() < all_actual.size();
    const Chain_topology topology(actual);
    count(topology);
    {
      const Face_oracle oracle(field, Oracle_unit::widening * unit, false);
      const Chains exact = without_points(oracle.chains(oracle.nearer_than(cut)), apart);
      if (topology == Chain_topology(exact) && note(farthest_chain(actual, exact), unit)) return;
    }
    // include all paths if rounding matters
    const Face_oracle oracle(field, Oracle_unit::widening * unit, true);
    const auto moved = [&](double margins) {
      return without_points(oracle.chains(oracle.nearer_than(cut + margins * margin)), apart);
    };
    const Chains exact[] = {moved(-2), moved(-1), moved(0), moved(1), moved(2)};
    bool fits[5];
    for (int i = 0; i < 5; ++i) fits[i] = topology == Chain_topology(exact[i]);
    // Near an event chains move with square roots: from the event to the margin they move 1 / (sqrt(2) - 1) times as far as
    // from the margin to twice the margin.
    double allowed = apart;
    for (int i = 0; i < 4; ++i)
      if (Chain_topology(exact[i]) == Chain_topology(exact[i + 1]))
        allowed = (std::max)(allowed, apart + 2.5 * farthest_chain(exact[i], exact[i + 1]));
    double least = std::numeric_limits<double>::infinity();
    for (int i = 1; i < 4; ++i)
      if (fits[i]) least = (std::min)(least, farthest_chain(actual, exact[i]));
    if (least <= allowed)
    {
      counts.near_event += !fits[2];
      counts.ill_conditioned += !note(least, unit);
      return;
    }
    if (lies_between(field, cut, margin, actual, exact[0], exact[4], apart))
    {
      ++counts.within_band;
      return;
    }
    if (!fits[1] && !fits[2] && !fits[3])
    {
      ++counts.topology;
      std::string text = text_of(all_actual) + " instead of " + text_of(exact[2]) + " (lowered by the margin " +
                         text_of(exact[1]) + "; raised " + text_of(exact[3]) + ")";
      for (double factor = 4; factor < 1e5; factor *= 4)
        for (const double sign : {-1., 1.})
          if (topology == Chain_topology(moved(sign * factor)))
            return report(text + "; right for the level moved by " + std::to_string(sign * factor) + " margins");
      return report(text);
    }
    ++counts.apart;
    char buffer[96];
    std::snprintf(buffer, sizeof(buffer), "chains are %.3g apart; rounding of the level moves them by %.3g: ", least, allowed);
    report(buffer + text_of(all_actual) + "; exactly " + text_of(exact[2]) + "; lowered by the margin " + text_of(exact[1]) +
           "; raised " + text_of(exact[3]));
  }

private:
  // Whether chains bound the region nearer than the level of a distance within the margin. They do if and only if no point
  // of them is off the level by more than the margin, each part of the region that is certainly nearer is on their left,
  // and each part that is certainly farther is on their right: no part can be on both sides, and the boundary of each part
  // contains a chain of the lowered or raised level. So rounding decides each of several events separately, and a level
  // along an edge may leave it anywhere, but no chain can be missing, displaced, or connected to a wrong gate.
  bool lies_between(const Face_field& field, double cut, double margin, const Chains& chains, const Chains& lowered,
                    const Chains& raised, double apart) const
  {
    std::size_t nearest;
    for (const Level_chain& c : chains)
    {
      for (std::size_t i = 0; i < c.arcs.size(); ++i)
      {
        for (int t = 0; t <= 16; ++t)
          if (std::abs(field.distance(c.arcs[i].at(t / 16.), nearest) - cut) > margin) return false;
        if (i + 1 < c.arcs.size() && length(c.arcs[i + 1].start - c.arcs[i].end) > apart) return false;
      }
      const Point_in_face &start = c.arcs[0].start, &end = c.arcs.back().end;
      if (c.is_closed ? length(end - start) > apart
                      : length(on_border(field, c.from) - start) > apart || length(on_border(field, c.to) - end) > apart)
        return false;
    }
    const double at_corner = field.distance(field.frame().corner(0), nearest) - cut;
    for (const bool is_near : {true, false})
    { // of the corner at position 0
      if (is_near ? at_corner > margin : at_corner < -margin) continue;
      const auto have_winding = [&](const Chains& samples, double expected) {
        bool result = true;
        for (const Level_chain& c : samples)
          for (const Chain_arc& a : c.arcs)
            for (const double t : {0.25, 0.5, 0.75})
              result = result && std::abs(winding(field, chains, is_near, a.at(t)) - expected) < 0.01;
        return result;
      };
      if (have_winding(lowered, 1) && have_winding(raised, 0)) return true;
    }
    return false;
  }

  static Point_in_face on_border(const Face_field& field, double position)
  {
    const int k = (std::min)(2, int(position));
    return field.frame().on_edge(k, (position - k) * field.frame().edge_length(k));
  }

  // Winding number of the boundary of the region on the left of the chains around q, a point inside the face. The boundary
  // consists of the chains and, from their ends to the next starts, parts of the boundary of the face.
  static double winding(const Face_field& field, const Chains& chains, bool is_near_at_corner, const Point_in_face& q)
  {
    const auto angle = [&](const Point_in_face& a, const Point_in_face& b) {
      return std::atan2(cross(a - q, b - q), dot(a - q, b - q));
    };
    const auto along_border = [&](double position) { // from the corner at position 0
      double sum = 0;
      const int k = (std::min)(2, int(position));
      for (int i = 0; i < k; ++i) sum += angle(field.frame().corner(i), field.frame().corner(i + 1));
      return sum + angle(field.frame().corner(k), on_border(field, position));
    };
    double sum = is_near_at_corner ? 2 * CGAL_PI : 0;
    for (const Level_chain& c : chains)
    {
      if (!c.is_closed) sum += along_border(c.from) - along_border(c.to);
      for (const Chain_arc& a : c.arcs)
      {
        sum += angle(a.start, a.end);
        if (!a.is_straight && is_between_chord_and_arc(a, q)) sum += 2 * CGAL_PI;
      }
    }
    return sum / (2 * CGAL_PI);
  }

  // An arc turns by at most pi, so these points are among its directions from the center. Beside an arc of the size of
  // rounding the side of the chord says nothing.
  static bool is_between_chord_and_arc(const Chain_arc& a, const Point_in_face& q)
  {
    return cross(a.start - a.center, q - a.center) >= 0 && cross(q - a.center, a.end - a.center) >= 0 &&
           cross(a.start - q, a.end - q) < 0 && length(q - a.center) < a.radius;
  }

  void count(const Chain_topology& t)
  {
    counts.chains += t.number_of_open_chains();
    counts.loops += t.number_of_loops();
    counts.empty += t.number_of_open_chains() + t.number_of_loops() == 0;
  }

  // Calls f(point) for points of a chain.
  template <class Function>
  static void for_each_sample(const Level_chain& chain, const Function& f)
  {
    for (const Chain_arc& arc : chain.arcs)
      for (const double t : {0., 0.25, 0.5, 0.75, 1.}) f(arc.at(t));
  }

  // Largest distance of samples of one chain from another chain.
  static double farthest(const Level_chain& from, const Level_chain& to)
  {
    double worst = 0;
    for_each_sample(from, [&](const Point_in_face& p) { worst = (std::max)(worst, to.distance(p)); });
    return worst;
  }

  // Largest Hausdorff distance of paired chains, each paired with the nearest one. Precondition: a and b have the same
  // size.
  static double farthest_chain(const Chains& a, const Chains& b)
  {
    double worst = 0;
    std::vector<char> is_used(b.size(), 0);
    for (const Level_chain& c : a)
    {
      double best = std::numeric_limits<double>::infinity();
      std::size_t nearest = b.size();
      for (std::size_t j = 0; j < b.size(); ++j)
      {
        if (is_used[j] || c.is_closed != b[j].is_closed) continue;
        const double d = (std::max)(farthest(c, b[j]), farthest(b[j], c));
        if (d < best) nearest = j;
        best = (std::min)(best, d);
      }
      if (nearest < b.size()) is_used[nearest] = 1;
      worst = (std::max)(worst, best);
    }
    return worst;
  }

  // Records the distance of chains; returns whether it is within rounding.
  bool note(double distance, double unit)
  {
    if (!(distance <= Oracle_unit::apart * unit)) return false;
    counts.worst_distance = (std::max)(counts.worst_distance, distance / unit);
    return true;
  }

  // Removes chains of the size of rounding. Distances are 1-Lipschitz, so such a chain does not exist on a level that
  // differs by its size: the topology changes within that multiple of rounding.
  static Chains without_points(const Chains& chains, double size)
  {
    Chains result;
    for (const Level_chain& c : chains)
      if (size_of(c) > size) result.push_back(c);
    return result;
  }

  static double size_of(const Level_chain& chain)
  {
    double reach = 0;
    for_each_sample(chain, [&](const Point_in_face& p) { reach = (std::max)(reach, length(p - chain.arcs[0].start)); });
    return reach;
  }

  static std::string size_text(const Level_chain& chain)
  {
    char buffer[40];
    std::snprintf(buffer, sizeof(buffer), " of size %.2g", size_of(chain));
    return buffer;
  }

  static std::string text_of(const Chains& chains)
  {
    std::string text;
    for (const Level_chain& c : chains)
    {
      char buffer[80];
      if (c.is_closed) std::snprintf(buffer, sizeof(buffer), "a loop about (%.9g, %.9g)", c.arcs[0].start.x, c.arcs[0].start.y);
      else std::snprintf(buffer, sizeof(buffer), "%.15g to %.15g", c.from, c.to);
      text +=
        (text.empty() ? "" : ", ") + std::string(buffer) + " in " + std::to_string(c.arcs.size()) + " pieces" + size_text(c);
    }
    return text.empty() ? "nothing" : text;
  }

  static std::string text_of(const Face_field& field)
  {
    char buffer[400];
    const auto& frame = field.frame();
    std::snprintf(buffer, sizeof(buffer), "\n  face 0 0, %.17g %.17g, %.17g %.17g", frame.corner(1).x, frame.corner(1).y,
                  frame.corner(2).x, frame.corner(2).y);
    std::string text = buffer;
    for (const Face_window& w : field.windows())
    {
      std::snprintf(buffer, sizeof(buffer), "\n  %s, origin %d: %.17g %.17g, sigma %.17g, left %.17g %.17g, right %.17g %.17g",
                    w.is_parallel() ? "parallel" : "point", int(w.origin), w.x, w.y, w.sigma, w.left.x, w.left.y, w.right.x,
                    w.right.y);
      text += buffer;
    }
    return text;
  }
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H
