// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Construction of expressions, with simplifications that need no evaluation: results of operations on small rationals
// are rationals.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_EXPRESSION_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_EXPRESSION_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>

#include <cstddef>
#include <stdexcept>

namespace CGAL::Geodesic_offset::internal {

class Radical_expression
{
public:
  typedef Radical_node::Reference Reference;

  static Reference negative(const Reference& a)
  {
    if (!a) return a;
    if (a->rational()) return Radical_node::make(Big_rational(-*a->rational()));
    if (a->operation() == Radical_operation::NEGATE) return a->operand(0);
    return Radical_node::make(Radical_operation::NEGATE, a);
  }

  static Reference sum(const Reference& a, const Reference& b)
  {
    if (!a || !b) return a ? a : b;
    if (are_small(a, b))
    {
      Big_rational q = *a->rational() + *b->rational();
      if (is_small(q)) return Radical_node::make(std::move(q));
    }
    return Radical_node::make(Radical_operation::ADD, a, b);
  }

  static Reference difference(const Reference& a, const Reference& b)
  {
    if (!b) return a;
    if (!a) return negative(b);
    if (a == b) return Reference();
    if (are_small(a, b))
    {
      Big_rational q = *a->rational() - *b->rational();
      if (is_small(q)) return Radical_node::make(std::move(q));
    }
    return Radical_node::make(Radical_operation::SUBTRACT, a, b);
  }

  static Reference product(const Reference& a, const Reference& b)
  {
    if (!a || !b) return Reference();
    if (is_unit(a)) return with_sign_of(a, b);
    if (is_unit(b)) return with_sign_of(b, a);
    if (a == b && a->operation() == Radical_operation::SQUARE_ROOT) return a->operand(0);
    if (are_small(a, b))
    {
      Big_rational q = *a->rational() * *b->rational();
      if (is_small(q)) return Radical_node::make(std::move(q));
    }
    return Radical_node::make(Radical_operation::MULTIPLY, a, b);
  }

  static Reference quotient(const Reference& a, const Reference& b)
  {
    if (!b || (b->rational() && b->rational()->is_zero())) throw std::domain_error("division by zero");
    if (!a) return a;
    if (is_unit(b)) return with_sign_of(b, a);
    if (a == b) return Radical_node::make(Big_rational(1));
    if (are_small(a, b))
    {
      Big_rational q = *a->rational() / *b->rational();
      if (is_small(q)) return Radical_node::make(std::move(q));
    }
    return Radical_node::make(Radical_operation::DIVIDE, a, b);
  }

  static Reference square_root(const Reference& a)
  {
    if (!a) return a;
    if (a->interval().high < 0) throw std::domain_error("square root of a negative number");
    if (a->rational())
    {
      const Big_integer over(numerator_of(*a->rational())), under(denominator_of(*a->rational()));
      if (is_square(over) && is_square(under))
        return Radical_node::make(Big_rational(boost::multiprecision::sqrt(over), boost::multiprecision::sqrt(under)));
    }
    if (a->operation() == Radical_operation::MULTIPLY && a->operand(0) == a->operand(1))
    {
      const int sign = a->operand(0)->interval().sign();
      if (sign != 0) return sign > 0 ? a->operand(0) : negative(a->operand(0));
    }
    return Radical_node::make(Radical_operation::SQUARE_ROOT, a);
  }

private:
  static constexpr std::size_t most_bits = 2000; // larger rationals are not computed

  static bool is_small(const Big_rational& q) { return bits_of(q) < most_bits; }
  static bool are_small(const Reference& a, const Reference& b)
  {
    return a->rational() && b->rational() && is_small(*a->rational()) && is_small(*b->rational());
  }
  static bool is_unit(const Reference& a) { return a->rational() && boost::multiprecision::abs(*a->rational()) == 1; }
  static Reference with_sign_of(const Reference& unit, const Reference& a)
  {
    return unit->rational()->sign() > 0 ? a : negative(a);
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
