// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Maximum over a triangle of the minimum of linear functions.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_MAX_MIN_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_MAX_MIN_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Per_corner.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <algorithm>
#include <array>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Each function is given by its values at the corners, so the maximum is the value of a matrix game. Every convex combination
// of the functions is an upper bound, whatever the rounding of its coefficients. An optimal combination has at most three
// members.
template <class FT>
class Max_min
{
public:
  typedef Per_corner<FT> Row;

  // Stops when the bound is at most `enough`.
  void operator()(const std::vector<Row>& rows, const FT& enough)
  {
    m_bound = Number_policy<FT>::infinity();
    m_size = 0;
    for (std::size_t i = 0; i < rows.size(); ++i)
    {
      const FT bound = largest(rows[i]);
      if (!(bound < m_bound)) continue;
      m_bound = bound;
      m_members[0] = i;
      m_size = 1;
    }
    if (m_size == 0) return;
    m_weights = Row{FT(0), FT(0), FT(0)};
    const Row& row = rows[m_members[0]];
    m_weights[row[0] == m_bound ? 0 : row[1] == m_bound ? 1 : 2] = FT(1);
    // The bound falls in each step. On a tie the loop may stop before the optimum; the caller then splits the triangle.
    for (int step = 0; step < 32 && m_bound > enough; ++step)
    {
      std::size_t lowest = 0;
      FT low = Number_policy<FT>::infinity();
      for (std::size_t i = 0; i < rows.size(); ++i)
      {
        const FT value = dot(rows[i], m_weights);
        if (!(value < low)) continue;
        low = value;
        lowest = i;
      }
      if (!(low < m_bound) || !exchange(rows, lowest)) return;
    }
  }

  static FT largest(const Row& row) { return (std::max)((std::max)(row[0], row[1]), row[2]); }

  const FT& bound() const { return m_bound; }
  const Row& weights() const { return m_weights; } // barycentric coordinates of the maximum

private:
  static FT dot(const Row& a, const Row& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
  static Row minus(const Row& a, const Row& b) { return Row{a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
  static Row cross(const Row& a, const Row& b)
  {
    return Row{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  // Makes the coordinates nonnegative, with sum 1.
  static bool normalize(Row& w)
  {
    for (int round = 0; round < 2; ++round)
    {
      const FT sum = w[0] + w[1] + w[2];
      if (CGAL::is_zero(sum)) return false;
      for (FT& x : w) x = (std::max)(FT(x / sum), FT(0));
    }
    return true;
  }

  // Tries combinations of row r with one or two members. Returns true if one lowers the bound.
  bool exchange(const std::vector<Row>& rows, std::size_t r)
  {
    const Per_corner<std::size_t> old = m_members;
    const int size = m_size;
    const FT before = m_bound;
    for (int i = 0; i < size; ++i)
    {
      combine(rows, r, old[i]);
      for (int j = 0; j < i; ++j) combine(rows, r, old[i], old[j]);
    }
    return m_bound < before;
  }

  // Two functions that are equal at a point of an edge.
  void combine(const std::vector<Row>& rows, std::size_t r, std::size_t s)
  {
    const Row d = minus(rows[r], rows[s]);
    for (int k = 0; k < 3; ++k)
    {
      const int a = (k + 1) % 3, b = (k + 2) % 3;
      Row w{FT(0), FT(0), FT(0)};
      w[a] = -d[b];
      w[b] = d[a];
      take_if_lower(rows, {r, s, s}, Row{rows[s][b] - rows[s][a], rows[r][a] - rows[r][b], FT(0)}, w, 2);
    }
  }

  // Three functions that are equal at an interior point.
  void combine(const std::vector<Row>& rows, std::size_t r, std::size_t s, std::size_t t)
  {
    const Row &a = rows[r], &b = rows[s], &c = rows[t];
    const Row u{a[0] - a[1], b[0] - b[1], c[0] - c[1]}, v{a[0] - a[2], b[0] - b[2], c[0] - c[2]};
    take_if_lower(rows, {r, s, t}, cross(u, v), cross(minus(a, b), minus(a, c)), 3);
  }

  void take_if_lower(const std::vector<Row>& rows, const Per_corner<std::size_t>& members, Row coefficients, Row weights,
                     int size)
  {
    if (!normalize(coefficients) || !normalize(weights)) return;
    Row sum{FT(0), FT(0), FT(0)};
    for (int k = 0; k < 3; ++k)
      for (int i = 0; i < size; ++i) sum[k] += coefficients[i] * rows[members[i]][k];
    const FT bound = largest(sum);
    if (!(bound < m_bound)) return;
    m_bound = bound;
    m_members = members;
    m_size = size;
    m_weights = weights;
  }

  FT m_bound = FT(0);
  Row m_weights{};
  Per_corner<std::size_t> m_members{};
  int m_size = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
