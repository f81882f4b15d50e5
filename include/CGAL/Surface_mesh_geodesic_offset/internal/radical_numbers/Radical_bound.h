// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lower bound of the absolute value of an expression that is not zero: C. Burnikel, S. Funke, K. Mehlhorn, S. Schirra
// and S. Schmitt, A Separation Bound for Real Algebraic Expressions, ESA 2001. Its degree is 2^k for k square roots, so
// it is useful only for few roots.
//
// CORE of CGAL 5.5 computes the same bound with a wrong degree for subexpressions whose roots also occur elsewhere: it
// returns zero for (s - t) * (s + t) with nearly equal sums s, t of roots.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_BOUND_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_BOUND_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unordered_map>

namespace CGAL::Geodesic_offset::internal {

class Radical_bound
{
public:
  // Returns n such that the number is zero or at least 2^-n in absolute value, if the bound gives an n up to `largest`.
  static std::optional<std::size_t> bits(Radical_node& top, std::size_t largest)
  {
    Radical_bound bound;
    Radical_node::visit(
      top, [&](const Radical_node& n) { return bound.m_sizes.count(&n) == 0; },
      [&](const Radical_node& n) { bound.m_sizes.emplace(&n, bound.size(n)); });
    const Size s = bound.m_sizes.at(&top);
    if (bound.m_is_unknown || bound.m_roots > most_roots) return std::nullopt;
    const double n = s.under + (std::ldexp(1., int(bound.m_roots)) - 1) * s.over;
    if (!(n <= double(largest))) return std::nullopt;
    return std::size_t(n) + 1;
  }

private:
  // The number is a quotient of algebraic integers whose conjugates are at most 2^over and 2^under. The logarithms are
  // rounded up to integers, so their sums are exact.
  struct Size
  {
    double over, under;
  };
  static constexpr std::size_t most_roots = 40;

  static double log2_above(mpz_srcptr n) { return double(mpz_sizeinbase(n, 2)); }
  static Size of(const Big_rational& q) { return {log2_above(numerator_of(q)), log2_above(denominator_of(q))}; }
  static Size sum(const Size& a, const Size& b)
  {
    return {(std::max)(a.over + b.under, a.under + b.over) + 1, a.under + b.under};
  }
  static Size product(const Size& a, const Size& b) { return {a.over + b.over, a.under + b.under}; }
  static Size root(const Size& a)
  {
    const double mean = std::ceil((a.over + a.under) / 2);
    return a.over >= a.under ? Size{mean, a.under} : Size{a.over, mean};
  }

  Size size(const Radical_node& n)
  {
    const auto operand = [&](int i) -> const Size& { return m_sizes.at(n.operand(i).get()); };
    switch (n.operation())
    {
    case Radical_operation::RATIONAL: return of(*n.rational());
    case Radical_operation::NEGATE: return operand(0);
    case Radical_operation::ADD:
    case Radical_operation::SUBTRACT: return sum(operand(0), operand(1));
    case Radical_operation::MULTIPLY: return product(operand(0), operand(1));
    case Radical_operation::DIVIDE: return product(operand(0), {operand(1).under, operand(1).over});
    case Radical_operation::SQUARE_ROOT: ++m_roots; return root(operand(0));
    case Radical_operation::CORE_NUMBER: m_is_unknown = true; return {0, 0};
    case Radical_operation::CLOSED_FORM: break;
    }
    Size s{0, 0};
    for (const Radical_term& t : n.closed_form()->numerator.terms())
    {
      if (t.radicand != 1) ++m_roots;
      s = sum(s, product(of(t.factor), root(of(Big_rational(t.radicand)))));
    }
    return s;
  }

  std::unordered_map<const Radical_node*, Size> m_sizes;
  std::size_t m_roots = 0;
  bool m_is_unknown = false;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
