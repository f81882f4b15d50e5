// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that the curves of a level separate nearer points from farther ones and no others: vertices along the edges,
// points of edges between crossings, and points in faces. It finds missing curves and duplicate curves.

#ifndef GEODESIC_OFFSET_TEST_VALIDATION_SIDE_VALIDATION_H
#define GEODESIC_OFFSET_TEST_VALIDATION_SIDE_VALIDATION_H

#include "Validation_level.h"
#include "Validation_report.h"

#include <algorithm>
#include <random>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

template <class Geodesic>
class Side_validation
{
public:
  typedef Validation_surface<Geodesic> Surface;
  typedef Validation_face::Point Point;
  typedef Validation_face::Weights Weights;

  Side_validation(const Surface& surface, const Validation_options& options, Validation_report& report)
    : m_surface(surface), m_options(options), m_report(report), m_tolerance(options.level_tolerance * surface.diagonal())
  {
  }

  // Checks every edge of the mesh: linear time, and one query per crossing. Precondition: the sides of the vertices are
  // known.
  void check_edges(const Validation_level& level, std::mt19937& random) const
  {
    for (Index f = 0; f < m_surface.number_of_faces(); ++f)
      for (Index h = 3 * f; m_surface.is_used(f) && h < 3 * f + 3; ++h)
        if (!(m_surface.twin(h) < h)) check_edge(h, level, random);
  }

  // `faces`: all faces that the level may pass through. One query per probe; each probe is compared with the pieces in its
  // face.
  void check_faces(const Validation_level& level, const std::vector<Index>& faces, std::mt19937& random) const
  {
    if (faces.empty()) return;
    const std::size_t n = (std::max)(m_options.probes_in_face, m_options.probes / faces.size());
    for (const Index f : faces) check_face(f, n, level, random);
  }

private:
  void check_edge(Index h, const Validation_level& level, std::mt19937& random) const
  {
    const Index u = m_surface.origin(h), v = m_surface.target(h);
    if (level.is_near[u] == Validation_level::either_side || level.is_near[v] == Validation_level::either_side) return;
    const auto range = level.crossings_of(h);
    const std::size_t n = std::size_t(range.second - range.first);
    const bool separating = level.is_near[u] != level.is_near[v];
    m_report.separating_edges += separating ? 1 : 0;
    m_report.check(EDGE_PARITY, n % 2 == (separating ? 1u : 0u), [&] {
      return std::to_string(n) + " crossings of the edge from " + at_vertex(u, level) + " to " + at_vertex(v, level);
    });
    if (n % 2 == (separating ? 1u : 0u))
      m_report.check(ORIENTATION, level.sum_of_steps(h) == level.is_near[v] - level.is_near[u], [&] {
        return "crossings in the wrong direction, of the edge from " + at_vertex(u, level) + " to " + at_vertex(v, level);
      });
    check_along_edge(h, level, random);
  }

  std::string at_vertex(Index v, const Validation_level& level) const
  {
    return "vertex " + std::to_string(v) + " (" + validation_text(m_surface.vertex_distance(v) - level.cut) + ")";
  }

  // Between its crossings, the edge is alternately near and far.
  void check_along_edge(Index h, const Validation_level& level, std::mt19937& random) const
  {
    const auto range = level.crossings_of(h);
    const double edge = m_surface.edge_length(h);
    const double d0 = m_surface.vertex_distance(m_surface.origin(h)), d1 = m_surface.vertex_distance(m_surface.target(h));
    if (range.first == range.second)
    {
      const double middle = (d0 + d1) / 2;
      if (std::abs(middle - level.cut) < edge / 2) check_on_edge(h, validation_random(random), level, 0);
      return;
    }
    int sum = 0;
    double last = 0;
    for (auto c = range.first; c != range.second; ++c)
    {
      if ((c->t - last) * edge > m_tolerance) check_on_edge(h, (last + c->t) / 2, level, sum);
      last = c->t;
      sum += c->step;
    }
    if ((1 - last) * edge > m_tolerance) check_on_edge(h, (last + 1) / 2, level, sum);
    m_report.separated_on_edges += std::size_t(range.second - range.first);
  }

  // `steps`: sum of the steps of all crossings before t.
  void check_on_edge(Index h, double t, const Validation_level& level, int steps) const
  {
    Weights w{{0, 0, 0}};
    w[h % 3] = 1 - t;
    w[(h + 1) % 3] = t;
    const double excess = m_surface.distance_at(h / 3, w) - level.cut;
    if (std::abs(excess) <= m_tolerance) return;
    m_report.check(SEPARATION, (level.is_near[m_surface.origin(h)] + steps == 1) == (excess < 0), [&] {
      return "a point of the edge from vertex " + std::to_string(m_surface.origin(h)) + " to " +
             std::to_string(m_surface.target(h)) + " is on the wrong side by " + validation_text(excess);
    });
  }

  // Compares each probe with the previous one.
  void check_face(Index f, std::size_t n, const Validation_level& level, std::mt19937& random) const
  {
    const Validation_face face = m_surface.face_at(f);
    // in thinner faces, rounding may move points to the other side of pieces; then only the edges are checked
    constexpr double rounding = 0x1p-46;
    if (!((std::min)({face.height(0), face.height(1), face.height(2)}) > rounding * m_surface.diagonal())) return;
    const auto pieces = level.pieces_in(f);
    Point last{0, 0};
    bool last_is_near = false, has_last = false;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Weights w = validation_random_weights(random);
      const Point p = face.point(w);
      const double excess = m_surface.distance_at(f, w) - level.cut;
      if (!(std::abs(excess) > m_tolerance)) continue;
      if (has_last)
      {
        std::size_t crossings = 0;
        for (auto q = pieces.first; q != pieces.second; ++q) crossings += std::size_t(q->separates(last, p));
        const bool separated = last_is_near != (excess < 0);
        m_report.separated_in_faces += separated ? 1 : 0;
        m_report.check(SEPARATION, crossings % 2 == (separated ? 1u : 0u), [&] {
          return std::to_string(crossings) + " crossings between two points in face " + std::to_string(f) +
                 (separated ? " on different sides" : " on the same side");
        });
      }
      last = p;
      last_is_near = excess < 0;
      has_last = true;
    }
  }

  const Surface& m_surface;
  const Validation_options& m_options;
  Validation_report& m_report;
  double m_tolerance;
};

} // namespace CGAL::Geodesic_offset::internal

#endif // GEODESIC_OFFSET_TEST_VALIDATION_SIDE_VALIDATION_H
