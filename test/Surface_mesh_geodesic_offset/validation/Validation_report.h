// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of a validation of offset curves: checks and failures of each kind, and the worst figures.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_REPORT_H
#define GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_REPORT_H

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

enum Validation_kind : unsigned char {
  CLOSEDNESS,  // pieces are joined; open curves begin and end on the border
  ON_LEVEL,    // points of curves are at the distance of the curve
  EDGE_PARITY, // an edge is crossed an odd number of times iff its ends are on different sides
  SEPARATION,  // points of an edge or a face are on different sides iff curves separate them
  ORIENTATION, // the smaller distances are on the left
  NO_CROSSING, // curves of one level do not cross in any face
  NESTING,     // curves of different levels do not cross; near regions grow with the level
  AREA,        // the near area of a face from the curves agrees with bounds from the field
  NUMBER_OF_VALIDATION_KINDS
};

inline const char* name_of(Validation_kind kind)
{
  static const char* const names[] = {"closedness",  "on level",    "edge parity", "separation",
                                      "orientation", "no crossing", "nesting",     "area"};
  return names[kind];
}

inline std::string validation_text(double x)
{
  char buffer[32];
  std::snprintf(buffer, sizeof(buffer), "%.6g", x);
  return buffer;
}

struct Validation_options
{
  std::size_t probes = 1000;         // points in faces per level (at least `probes_in_face` per face)
  std::size_t probes_in_face = 3;    // per face that the level may pass through
  std::size_t quadrature_faces = 8;  // faces per level whose area is compared with the field
  std::size_t quadrature_depth = 12; // bisections of a face: two more halve the undecided area
  std::size_t largest_number_of_texts = 20;
  unsigned seed = 1;

  // Lengths in diagonals of the bounding box. The joint of two arcs that meet at a small angle is less accurate than a
  // distance, and so are the distances of points from their level.
  double joint_tolerance = 1e-12; // between the end of a piece and the start of the next one
  double level_tolerance = 1e-9;  // of points from their level; also of crossing depth
};

class Validation_report
{
public:
  typedef std::array<std::size_t, NUMBER_OF_VALIDATION_KINDS> Counts;

  explicit Validation_report(std::size_t largest_number_of_texts = 20) : m_largest_number_of_texts(largest_number_of_texts) {}

  // `text` returns the description of a failure; it is called for the first failures only.
  template <class Text>
  bool check(Validation_kind kind, bool ok, const Text& text)
  {
    ++m_checks[kind];
    if (ok) return true;
    ++m_failures[kind];
    if (m_failures[kind] <= (std::max)(m_largest_number_of_texts / NUMBER_OF_VALIDATION_KINDS, std::size_t(1)))
      m_texts.push_back(std::string(name_of(kind)) + ": " + m_context + text());
    return false;
  }

  // Prefix of failure descriptions.
  void set_context(std::string context) { m_context = std::move(context); }

  std::size_t checks(Validation_kind kind) const { return m_checks[kind]; }
  std::size_t failures(Validation_kind kind) const { return m_failures[kind]; }
  std::size_t checks() const { return sum(m_checks); }
  std::size_t failures() const { return sum(m_failures); }
  bool is_valid() const { return failures() == 0; }

  // The first failures of each kind.
  const std::vector<std::string>& texts() const { return m_texts; }

  // Adds the counts and figures of another validation, without its texts.
  void add(const Validation_report& other)
  {
    for (std::size_t k = 0; k < NUMBER_OF_VALIDATION_KINDS; ++k)
    {
      m_checks[k] += other.m_checks[k];
      m_failures[k] += other.m_failures[k];
    }
    curves += other.curves;
    closed_curves += other.closed_curves;
    pieces += other.pieces;
    points += other.points;
    loops_in_faces += other.loops_in_faces;
    most_loops_in_face = (std::max)(most_loops_in_face, other.most_loops_in_face);
    separating_edges += other.separating_edges;
    undecided_vertices += other.undecided_vertices;
    separated_on_edges += other.separated_on_edges;
    separated_in_faces += other.separated_in_faces;
    compared_pairs += other.compared_pairs;
    oriented_pieces += other.oriented_pieces;
    areas += other.areas;
    undecided_share += other.undecided_share;
    worst_joint = (std::max)(worst_joint, other.worst_joint);
    worst_off_level = (std::max)(worst_off_level, other.worst_off_level);
    worst_crossing = (std::max)(worst_crossing, other.worst_crossing);
    worst_undecided_share = (std::max)(worst_undecided_share, other.worst_undecided_share);
  }

  std::size_t curves = 0, closed_curves = 0, pieces = 0;
  std::size_t points = 0;                                     // whose distance was computed
  std::size_t loops_in_faces = 0;                             // closed curves that stay in one face
  std::size_t most_loops_in_face = 0;                         // of one level
  std::size_t separating_edges = 0;                           // with ends on different sides
  std::size_t undecided_vertices = 0;                         // whose side rounding leaves undecided
  std::size_t separated_on_edges = 0, separated_in_faces = 0; // neighbouring probes on different sides
  std::size_t compared_pairs = 0;                             // pieces close to each other
  std::size_t oriented_pieces = 0;                            // long enough to determine the side of the smaller distances
  std::size_t areas = 0;                                      // compared with the field
  double undecided_share = 0;                                 // sum over these areas of the undecided fraction of the face
  double worst_undecided_share = 0;
  double worst_joint = 0, worst_off_level = 0, worst_crossing = 0; // in diagonals

private:
  static std::size_t sum(const Counts& counts)
  {
    std::size_t result = 0;
    for (std::size_t c : counts) result += c;
    return result;
  }

  std::size_t m_largest_number_of_texts;
  Counts m_checks{}, m_failures{};
  std::vector<std::string> m_texts;
  std::string m_context;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_VALIDATION_REPORT_H
