// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact conversion of expressions from and to CORE::Expr; shared subexpressions remain shared.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_CORE_CONVERSION_H
#define CGAL_RADICAL_NUMBER_INTERNAL_CORE_CONVERSION_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Radical_expression.h>

#include <CGAL/CORE_Expr.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

class Core_conversion
{
public:
  typedef Radical_node::Reference Reference;

  // CORE's operations + - * / and square roots become operations of ours.
  static Reference from_core(const CORE::Expr& x)
  {
    std::unordered_map<CORE::ExprRep*, Reference> made;
    visit_operands_first(
      x.Rep(), operands_of_core, [&](CORE::ExprRep* r) { return made.count(r) == 0; },
      [&](CORE::ExprRep* r) {
        const auto operand = [&](int i) -> const Reference& { return made.at(operands_of_core(r)[std::size_t(i)]); };
        made.emplace(r, operands_of_core(r)[0] ? apply(operation_of(r), Radical_expression(), operand) : constant(r));
      });
    return made.at(x.Rep());
  }

  // Evaluation and destruction in CORE are recursive; deeper expressions would overflow the stack.
  static constexpr std::size_t largest_depth = 5000;

  static CORE::Expr to_core(const Reference& a)
  {
    if (!a) return CORE::Expr(0);
    if (a->depth() > largest_depth) throw std::length_error("an expression too deep for CORE");
    a->refine(bits);
    Made made;
    visit_operands_first(
      a.get(), operands_of, [&](const Radical_node* n) { return made.count(n) == 0; },
      [&](const Radical_node* n) {
        const CORE::Expr x = converted(*n, made);
        pass_interval(*n, x);
        made.emplace(n, x);
      });
    return made.at(a.get());
  }

private:
  // The operands are protected members of CORE, accessible in derived classes.
  struct Unary : CORE::UnaryOpRep
  {
    static CORE::ExprRep* of(CORE::ExprRep* r) { return static_cast<CORE::UnaryOpRep*>(r)->*(&Unary::child); }
  };
  struct Binary : CORE::BinOpRep
  {
    static CORE::ExprRep* first_of(CORE::ExprRep* r) { return static_cast<CORE::BinOpRep*>(r)->*(&Binary::first); }
    static CORE::ExprRep* second_of(CORE::ExprRep* r) { return static_cast<CORE::BinOpRep*>(r)->*(&Binary::second); }
  };

  template <class Rep>
  static bool is(CORE::ExprRep* r)
  {
    return dynamic_cast<Rep*>(r) != nullptr;
  }

  // RATIONAL for all that has no counterpart.
  static Radical_operation operation_of(CORE::ExprRep* r)
  {
    if (is<CORE::NegRep>(r)) return Radical_operation::NEGATE;
    if (is<CORE::SqrtRep>(r)) return Radical_operation::SQUARE_ROOT;
    if (is<CORE::AddRep>(r)) return Radical_operation::ADD;
    if (is<CORE::SubRep>(r)) return Radical_operation::SUBTRACT;
    if (is<CORE::MultRep>(r)) return Radical_operation::MULTIPLY;
    if (is<CORE::DivRep>(r)) return Radical_operation::DIVIDE;
    return Radical_operation::RATIONAL;
  }

  static std::array<CORE::ExprRep*, 2> operands_of_core(CORE::ExprRep* r)
  {
    switch (operation_of(r))
    {
    case Radical_operation::RATIONAL: return {nullptr, nullptr};
    case Radical_operation::NEGATE:
    case Radical_operation::SQUARE_ROOT: return {Unary::of(r), nullptr};
    default: return {Binary::first_of(r), Binary::second_of(r)};
    }
  }

  static Reference constant(CORE::ExprRep* r)
  {
    if (is<CORE::ConstDoubleRep>(r)) return Radical_node::make(Big_rational(r->ffVal.getValue()));
    r->incRef();
    const CORE::Expr x(r);
    // CORE gives only approximations of a rational constant, but they determine it.
    const long most_bits = is<CORE::ConstRealRep>(r) ? 1 << 16 : 1 << 8;
    for (long bits = 64; bits <= most_bits; bits *= 2)
    {
      const auto bounds = bounds_by_core(x, bits);
      const Big_rational q = simplest_between(bounds.first, bounds.second);
      // a fraction that needs most of the bits is a coincidence
      if (2 * bits_of(q) > std::size_t(bits) * 3 && !is<CORE::ConstRealRep>(r)) continue;
      if (x == core_constant<CORE::BigRat>(q)) return Radical_node::make(q);
    }
    return Radical_node::make(x);
  }

  // The rational with the smallest denominator in an interval, by continued fractions.
  static Big_rational simplest_between(Big_rational low, Big_rational high)
  {
    if (low.sign() <= 0 && high.sign() >= 0) return 0;
    if (high.sign() < 0) return -simplest_between(-high, -low);
    std::vector<Big_rational> quotients;
    while (true)
    {
      Big_integer floor;
      mpz_fdiv_q(floor.backend().data(), numerator_of(low), denominator_of(low));
      const Big_rational whole(floor);
      if (low == whole || whole + 1 <= high)
      {
        Big_rational q = low == whole ? whole : whole + 1;
        for (; !quotients.empty(); quotients.pop_back()) q = quotients.back() + 1 / q;
        return q;
      }
      quotients.push_back(whole);
      std::tie(low, high) = std::make_pair(1 / (high - whole), 1 / (low - whole));
    }
  }

  typedef std::unordered_map<const Radical_node*, CORE::Expr> Made;

  static constexpr std::size_t bits = 256;
  static constexpr int units_of_interval = 16;    // upper bound of its width, in units of 2^-53
  static constexpr double largest_double = 1e300; // far from overflow; its inverse is far from underflow

  // CORE first evaluates a number with doubles, and needs a root bound if they do not determine the sign. Our interval
  // replaces these doubles, so only zeros need root bounds.
  static void pass_interval(const Radical_node& n, const CORE::Expr& x)
  {
    const double middle = middle_of(n.interval()), size = std::abs(middle);
    if (has_sign(n.interval()) && is_tight(n.interval()) && size > 1 / largest_double && size < largest_double)
      x.Rep()->ffVal = CORE::filteredFp(middle, size, units_of_interval);
  }

  static std::array<Radical_node*, 2> operands_of(const Radical_node* n)
  {
    if (n->closed_form()) return {nullptr, nullptr};
    return {n->operand(0).get(), n->operand(1).get()};
  }

  static CORE::Expr converted(const Radical_node& n, const Made& made)
  {
    if (n.rational()) return converted(*n.rational());
    if (n.closed_form())
    {
      const Radical_quotient& q = *n.closed_form();
      return q.is_sum() ? converted(q.numerator) : converted(q.numerator) / converted(q.denominator);
    }
    if (n.operation() == Radical_operation::CORE_NUMBER) return n.core_number();
    return apply(n.operation(), Operator_arithmetic<CORE::Expr>(),
                 [&](int i) -> const CORE::Expr& { return made.at(n.operand(i).get()); });
  }

  static CORE::Expr converted(const Big_rational& q) { return core_constant<CORE::BigRat>(q); }

  // Core_number is CORE::BigInt for an integer, CORE::BigRat for a rational: numbers of Boost or, in CGAL 5, CORE's own.
  template <class Core_number, class Number>
  static CORE::Expr core_constant(const Number& n)
  {
    if constexpr (std::is_constructible<Core_number, const Number&>::value) return CORE::Expr(Core_number(n));
    else return CORE::Expr(Core_number(n.backend().data()));
  }

  // For sums without symbols.
  static CORE::Expr converted(const Radical_sum& s)
  {
    CORE::Expr sum(0);
    for (const Radical_term& t : s.terms())
    {
      const CORE::Expr factor = converted(t.factor);
      sum += t.radicand == 1 ? factor : factor * CORE::sqrt(core_constant<CORE::BigInt>(t.radicand));
    }
    return sum;
  }
};

} // namespace CGAL::Radical_numbers::internal

#endif
