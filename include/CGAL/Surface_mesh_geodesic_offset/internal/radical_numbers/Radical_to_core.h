// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact conversion of expressions to CORE::Expr; shared subexpressions remain shared.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_TO_CORE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_TO_CORE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/core_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_expression.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>

#include <CGAL/CORE_Expr.h>

#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <unordered_map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

class Radical_to_core
{
public:
  // Evaluation and destruction in CORE are recursive; deeper expressions would overflow the stack.
  static constexpr std::size_t largest_depth = 5000;

  static CORE::Expr convert(const Radical_node::Reference& a)
  {
    if (!a) return CORE::Expr(0);
    if (a->depth() > largest_depth) throw std::length_error("an expression too deep for CORE");
    std::unordered_map<const Radical_node*, CORE::Expr> made;
    a->refine(bits);
    std::vector<Radical_node*> pending(1, a.get());
    while (!pending.empty())
    {
      Radical_node& n = *pending.back();
      const std::size_t size = pending.size();
      if (made.count(&n) == 0)
      {
        for (int i = 0; i < 2 && !n.closed_form(); ++i)
          if (n.operand(i) && made.count(n.operand(i).get()) == 0) pending.push_back(n.operand(i).get());
        if (pending.size() > size) continue;
        const CORE::Expr x = converted(n, made);
        tell_what_is_known(n, x);
        made.emplace(&n, x);
      }
      pending.pop_back();
    }
    return made.at(a.get());
  }

private:
  typedef std::unordered_map<const Radical_node*, CORE::Expr> Made;

  static constexpr std::size_t bits = 256;

  // CORE first evaluates a number with doubles, and needs a root bound if they do not determine the sign. Our interval
  // replaces these doubles, so only zeros need root bounds.
  static void tell_what_is_known(const Radical_node& n, const CORE::Expr& x)
  {
    const Double_interval& e = n.interval();
    if (!e.has_sign() || !e.is_tight() || !(std::abs(e.middle()) > 1e-300) || !(std::abs(e.middle()) < 1e300)) return;
    x.Rep()->ffVal = CORE::filteredFp(e.middle(), std::abs(e.middle()), units_of_interval);
  }
  static constexpr int units_of_interval = 16; // upper bound, in units of 2^-53

  static CORE::Expr converted(const Big_rational& q) { return core_expression<CORE::BigRat>(q); }

  static CORE::Expr converted(const Radical_node& n, const Made& made)
  {
    if (n.rational()) return converted(*n.rational());
    if (n.closed_form())
    {
      const Radical_quotient& q = *n.closed_form();
      return q.is_sum() ? converted(q.numerator) : converted(q.numerator) / converted(q.denominator);
    }
    const auto operand = [&](int i) -> const CORE::Expr& { return made.at(n.operand(i).get()); };
    switch (n.operation())
    {
    case Radical_operation::CORE_NUMBER: return n.core_number();
    case Radical_operation::NEGATE: return -operand(0);
    case Radical_operation::ADD: return operand(0) + operand(1);
    case Radical_operation::SUBTRACT: return operand(0) - operand(1);
    case Radical_operation::MULTIPLY: return operand(0) * operand(1);
    case Radical_operation::DIVIDE: return operand(0) / operand(1);
    case Radical_operation::SQUARE_ROOT: return CORE::sqrt(operand(0));
    default: throw std::logic_error("a constant without a value");
    }
  }

  // For sums without symbols.
  static CORE::Expr converted(const Radical_sum& s)
  {
    CORE::Expr sum(0);
    for (const Radical_term& t : s.terms())
    {
      const CORE::Expr factor = converted(t.factor);
      sum += t.radicand == 1 ? factor : factor * CORE::sqrt(core_expression<CORE::BigInt>(t.radicand));
    }
    return sum;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
