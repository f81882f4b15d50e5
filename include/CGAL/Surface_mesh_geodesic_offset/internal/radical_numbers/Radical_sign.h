// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sign of an expression, by methods of increasing strength and cost: intervals of doubles, intervals of more bits,
// identities of the parts of the expression, exact arithmetic with roots (which decides whether the number is zero),
// and root bounds, first Radical_bound, then CORE's.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_SIGN_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_SIGN_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Double_interval.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_bound.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_to_core.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_expression.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_identity.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <unordered_map>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Number of signs and comparisons decided by each method. Concurrent increments may be lost.
struct Radical_number_counts
{
  class Counter
  {
  public:
    Counter() : m_value(0) {}
    void operator++() { m_value.store(value() + 1, std::memory_order_relaxed); }
    void reset() { m_value.store(0, std::memory_order_relaxed); }
    std::uint64_t value() const { return m_value.load(std::memory_order_relaxed); }

  private:
    std::atomic<std::uint64_t> m_value;
  };

  Counter by_identity;       // same expression, or a rational
  Counter by_doubles;        // intervals of doubles
  Counter by_precision;      // intervals of up to 256 bits
  Counter zero_by_identity;  // zero by an identity of parts of the expression
  Counter exactly_zero;      // zero by exact arithmetic
  Counter exactly_not_zero;  // nonzero by exact arithmetic; sign by intervals of any precision
  Counter by_high_precision; // undecided by exact arithmetic; intervals of up to 65536 bits
  Counter by_root_bound;     // intervals of as many bits as the root bound needs
  Counter by_core;

  void reset()
  {
    for (Counter* c : {&by_identity, &by_doubles, &by_precision, &zero_by_identity, &exactly_zero, &exactly_not_zero,
                       &by_high_precision, &by_root_bound, &by_core})
      c->reset();
  }
};

// Exact value of an expression. Nodes cache values without nested roots.
class Radical_evaluation
{
public:
  static constexpr std::size_t most_steps = std::size_t(1) << 22;

  explicit Radical_evaluation(std::size_t steps = most_steps) : m_field(steps) {}

  Vanishing operator()(Radical_node& top)
  {
    Vanishing result = Vanishing::UNKNOWN;
    try
    {
      Radical_node::visit(
        top, [this](const Radical_node& n) { return !is_known(n); }, [this](Radical_node& n) { evaluate(n); });
      result = m_field.vanishing(value(top));
    }
    catch (const Radical_limit_exceeded&)
    {
    }
    if (result == Vanishing::ZERO) top.set_closed_form(Radical_quotient());
    // operands come first, and a node drops only nodes that precede it
    m_evaluated.push_back(&top);
    for (Radical_node* n : m_evaluated) n->forget_operands();
    return result;
  }

private:
  static constexpr std::size_t most_terms_kept = 64;

  bool is_known(const Radical_node& n) const { return n.closed_form() || m_values.count(&n) != 0; }
  const Radical_quotient& value(const Radical_node& n) const { return n.closed_form() ? *n.closed_form() : m_values.at(&n); }

  void evaluate(Radical_node& n)
  {
    Radical_quotient q = computed(n);
    if (n.rational() || q.has_symbols() || q.numerator.size() + q.denominator.size() > most_terms_kept)
      m_values.emplace(&n, std::move(q));
    else
    {
      n.set_closed_form(std::move(q));
      m_evaluated.push_back(&n);
    }
  }

  Radical_quotient computed(Radical_node& n)
  {
    const auto operand = [&](int i) -> const Radical_quotient& { return value(*n.operand(i)); };
    switch (n.operation())
    {
    case Radical_operation::RATIONAL: return {Radical_sum(*n.rational()), Radical_sum(1)};
    case Radical_operation::CORE_NUMBER: return m_field.unknown_number(&n);
    case Radical_operation::NEGATE: return negative(operand(0));
    case Radical_operation::ADD: return m_field.sum(operand(0), operand(1));
    case Radical_operation::SUBTRACT: return m_field.sum(operand(0), negative(operand(1)));
    case Radical_operation::MULTIPLY: return m_field.product(operand(0), operand(1));
    case Radical_operation::DIVIDE: return m_field.quotient(operand(0), operand(1));
    case Radical_operation::SQUARE_ROOT: return m_field.square_root(operand(0));
    case Radical_operation::CLOSED_FORM: break;
    }
    return *n.closed_form();
  }
  static Radical_quotient negative(Radical_quotient q)
  {
    q.numerator.negate();
    return q;
  }

  Radical_field m_field;
  std::unordered_map<const Radical_node*, Radical_quotient> m_values;
  std::vector<Radical_node*> m_evaluated;
};

class Radical_sign
{
public:
  typedef Radical_node::Reference Reference;

  static Radical_number_counts& counts()
  {
    static Radical_number_counts c;
    return c;
  }

  static int of(const Reference& a)
  {
    if (!a || a->rational())
    {
      ++counts().by_identity;
      return a ? a->rational()->sign() : 0;
    }
    if (a->has_sign())
    {
      ++counts().by_doubles;
      return a->sign();
    }
    if (refined_has_sign(*a, Radical_node::first_precision, exact_from))
    {
      ++counts().by_precision;
      return a->sign();
    }
    int factor = 1;
    const Reference simpler = with_same_sign(a, factor);
    if (!(simpler == a))
    {
      const int s = factor * of(simpler);
      if (s == 0) set_zero(*a);
      return s;
    }
    if (Radical_identity::proves_zero(*a))
    {
      ++counts().zero_by_identity;
      set_zero(*a);
      return 0;
    }
    const Vanishing vanishing = Radical_evaluation()(*a);
    if (vanishing == Vanishing::ZERO)
    {
      ++counts().exactly_zero;
      return 0;
    }
    if (vanishing == Vanishing::NOT_ZERO)
    {
      refined_has_sign(*a, 2 * exact_from, ~std::size_t(0));
      ++counts().exactly_not_zero;
      return a->sign();
    }
    if (refined_has_sign(*a, 2 * exact_from, bound_from))
    {
      ++counts().by_high_precision;
      return a->sign();
    }
    int sign = 0;
    if (const auto bound = Radical_bound::bits(*a, most_bits_of_bound))
    {
      for (std::size_t bits = 2 * bound_from; !a->has_sign() && !a->is_below(*bound); bits *= 2) a->refine(bits);
      ++counts().by_root_bound;
      sign = a->sign();
    }
    else if (refined_has_sign(*a, 2 * bound_from, core_from))
    {
      ++counts().by_high_precision;
      sign = a->sign();
    }
    else
    {
      sign = Radical_to_core::convert(a).sign();
      ++counts().by_core;
    }
    if (sign == 0) set_zero(*a);
    return sign;
  }

  static int of_difference(const Reference& a, const Reference& b)
  {
    if (a == b || !a || !b)
    {
      if (!(a == b)) return a ? of(a) : -of(b);
      ++counts().by_identity;
      return 0;
    }
    const Double_interval &x = a->interval(), &y = b->interval();
    if (x.high < y.low || y.high < x.low || (x.is_point() && y.is_point()))
    {
      ++counts().by_doubles;
      return x.low > y.high ? 1 : x.high < y.low ? -1 : 0;
    }
    if (const auto parts = differing_parts(*a, *b)) return of_difference(*parts->first, *parts->second);
    if (Radical_likeness()(*a, *b))
    {
      ++counts().by_identity;
      return 0;
    }
    return of(Radical_expression::difference(a, b));
  }

  // Returns 0 if intervals of few bits do not decide.
  static int of_difference_by_intervals(const Reference& a, const Reference& b)
  {
    if (a == b) return 0;
    if (!a || !b) return of_difference(a, b);
    const Double_interval &x = a->interval(), &y = b->interval();
    if (x.low > y.high) return 1;
    if (x.high < y.low) return -1;
    const Reference d = Radical_expression::difference(a, b);
    return d && refined_has_sign(*d, Radical_node::first_precision, exact_from) ? d->sign() : 0;
  }

  // Computes closed forms of subexpressions within a small number of steps.
  static void simplify(const Reference& a)
  {
    if (a && !a->closed_form() && !a->rational()) Radical_evaluation{steps_to_simplify}(*a);
  }

  // Refines the interval of a number until it is tight. Returns false for zero.
  static bool approximate(const Reference& a)
  {
    if (!a) return false;
    for (std::size_t bits = Radical_node::first_precision; !a->interval().is_tight(); bits *= 2)
    {
      if (bits > exact_from && !a->has_sign() && of(a) == 0) return false;
      a->refine(bits);
    }
    return true;
  }

private:
  static constexpr std::size_t exact_from = 256, bound_from = 4096, core_from = 1 << 16; // bits
  static constexpr std::size_t steps_to_simplify = std::size_t(1) << 10;
  static constexpr std::size_t most_bits_of_bound = 1 << 21;

  // The parts to compare instead: the other terms of two sums with a common term, the radicands of two square roots.
  typedef std::pair<const Reference*, const Reference*> Parts;
  static std::optional<Parts> differing_parts(const Radical_node& a, const Radical_node& b)
  {
    if (a.operation() != b.operation()) return std::nullopt;
    if (a.operation() == Radical_operation::SQUARE_ROOT) return Parts(&a.operand(0), &b.operand(0));
    if (a.operation() != Radical_operation::ADD) return std::nullopt;
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        if (a.operand(i) == b.operand(j)) return Parts(&a.operand(1 - i), &b.operand(1 - j));
    return std::nullopt;
  }

  static void set_zero(Radical_node& n)
  {
    n.set_closed_form(Radical_quotient());
    n.forget_operands();
  }

  // Returns a number that needs fewer roots and quotients; its sign times `factor` is the sign of a.
  static Reference with_same_sign(Reference a, int& factor)
  {
    while (a && a->operand(0))
    {
      const Reference x = a->operand(0), y = a->operand(1);
      switch (a->operation())
      {
      case Radical_operation::NEGATE:
        factor = -factor;
        a = x;
        continue;
      case Radical_operation::MULTIPLY:
      case Radical_operation::DIVIDE:
        if (y->has_sign() && y->sign() != 0)
        {
          factor *= y->sign();
          a = x;
          continue;
        }
        if (a->operation() == Radical_operation::DIVIDE || !x->has_sign() || x->sign() == 0) return a;
        factor *= x->sign();
        a = y;
        continue;
      case Radical_operation::SUBTRACT:
        // for y > 0, sqrt(u) - y and u - y^2 have the same sign
        if (is_root(*x) && y->has_sign() && y->sign() > 0) a = Radical_expression::difference(x->operand(0), square(y));
        else if (is_root(*y) && x->has_sign() && x->sign() > 0) a = Radical_expression::difference(square(x), y->operand(0));
        else return a;
        continue;
      default: return a;
      }
    }
    return a;
  }
  static bool is_root(const Radical_node& n) { return n.operation() == Radical_operation::SQUARE_ROOT; }
  static Reference square(const Reference& a) { return is_root(*a) ? a->operand(0) : Radical_expression::product(a, a); }

  static bool refined_has_sign(Radical_node& n, std::size_t bits, std::size_t most_bits)
  {
    for (; bits <= most_bits && !n.has_sign(); bits *= 2) n.refine(bits);
    return n.has_sign();
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
