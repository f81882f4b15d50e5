// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact conversion of expressions from CORE::Expr; shared subexpressions remain shared.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_FROM_CORE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_FROM_CORE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/core_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_expression.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>

#include <CGAL/CORE_Expr.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Decomposes CORE's expression: its operations + - * / and square roots become operations of ours.
class Radical_from_core
{
public:
  typedef Radical_node::Reference Reference;

  static Reference convert(const CORE::Expr& x)
  {
    std::unordered_map<CORE::ExprRep*, Reference> made;
    std::vector<CORE::ExprRep*> pending(1, x.Rep());
    while (!pending.empty())
    {
      CORE::ExprRep* r = pending.back();
      const std::size_t size = pending.size();
      if (made.count(r) == 0)
      {
        const std::pair<CORE::ExprRep*, CORE::ExprRep*> of = operands(r);
        for (CORE::ExprRep* o : {of.first, of.second})
          if (o && made.count(o) == 0) pending.push_back(o);
        if (pending.size() > size) continue;
        made.emplace(r, of.first ? operation(r, made.at(of.first), of.second ? made.at(of.second) : Reference()) : constant(r));
      }
      pending.pop_back();
    }
    return made.at(x.Rep());
  }

private:
  // The operands are protected members of CORE, accessible in derived classes.
  struct Unary : CORE::UnaryOpRep
  {
    static CORE::ExprRep* of(CORE::UnaryOpRep* r) { return r->*(&Unary::child); }
  };
  struct Binary : CORE::BinOpRep
  {
    static CORE::ExprRep* first_of(CORE::BinOpRep* r) { return r->*(&Binary::first); }
    static CORE::ExprRep* second_of(CORE::BinOpRep* r) { return r->*(&Binary::second); }
  };

  template <class Rep>
  static bool is(CORE::ExprRep* r)
  {
    return dynamic_cast<Rep*>(r) != nullptr;
  }

  // Returns null for operations without a counterpart.
  static std::pair<CORE::ExprRep*, CORE::ExprRep*> operands(CORE::ExprRep* r)
  {
    if (is<CORE::NegRep>(r) || is<CORE::SqrtRep>(r)) return {Unary::of(static_cast<CORE::UnaryOpRep*>(r)), nullptr};
    if (is<CORE::AddRep>(r) || is<CORE::SubRep>(r) || is<CORE::MultRep>(r) || is<CORE::DivRep>(r))
    {
      CORE::BinOpRep* b = static_cast<CORE::BinOpRep*>(r);
      return {Binary::first_of(b), Binary::second_of(b)};
    }
    return {nullptr, nullptr};
  }

  static Reference operation(CORE::ExprRep* r, const Reference& a, const Reference& b)
  {
    if (is<CORE::NegRep>(r)) return Radical_expression::negative(a);
    if (is<CORE::SqrtRep>(r)) return Radical_expression::square_root(a);
    if (is<CORE::AddRep>(r)) return Radical_expression::sum(a, b);
    if (is<CORE::SubRep>(r)) return Radical_expression::difference(a, b);
    if (is<CORE::MultRep>(r)) return Radical_expression::product(a, b);
    return Radical_expression::quotient(a, b);
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
      const Big_rational middle = rational_of_core(x.approx(bits + 8, bits + 8).BigRatValue());
      Big_rational error = 1;
      mpq_div_2exp(error.backend().data(), error.backend().data(), mp_bitcnt_t(bits));
      error *= 1 + boost::multiprecision::abs(middle);
      const Big_rational q = simplest_between(middle - error, middle + error);
      // a fraction that needs most of the bits is a coincidence
      if (2 * bits_of(q) > std::size_t(bits) * 3 && !is<CORE::ConstRealRep>(r)) continue;
      if (x == core_expression<CORE::BigRat>(q)) return Radical_node::make(q);
    }
    return Radical_node::make(x);
  }

  // The rational with the smallest denominator in an interval, by continued fractions.
  static Big_rational simplest_between(Big_rational low, Big_rational high)
  {
    if (low.sign() <= 0 && high.sign() >= 0) return 0;
    if (high.sign() < 0) return -simplest_between(-high, -low);
    std::vector<Big_integer> quotients;
    while (true)
    {
      Big_integer whole;
      mpz_fdiv_q(whole.backend().data(), numerator_of(low), denominator_of(low));
      const bool is_whole = low == Big_rational(whole);
      if (!is_whole) quotients.push_back(whole);
      if (is_whole || Big_rational(whole + 1) <= high)
      {
        Big_rational q = is_whole ? Big_rational(whole) : Big_rational(quotients.back() + 1);
        if (!is_whole) quotients.pop_back();
        for (std::size_t i = quotients.size(); i-- > 0;) q = Big_rational(quotients[i]) + 1 / q;
        return q;
      }
      const Big_rational next_low = 1 / (high - Big_rational(whole));
      high = 1 / (low - Big_rational(whole));
      low = next_low;
    }
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
