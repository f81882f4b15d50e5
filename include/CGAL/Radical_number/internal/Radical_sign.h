// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sign of an expression, by methods of increasing strength and cost: intervals of doubles, intervals of more bits,
// identities of the parts of the expression, exact arithmetic with roots (which decides whether the number is zero),
// and root bounds, first Radical_bound, then CORE's.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_SIGN_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_SIGN_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Core_conversion.h>
#include <CGAL/Radical_number/internal/Radical_expression.h>
#include <CGAL/Radical_number/internal/Radical_field.h>
#include <CGAL/Radical_number/internal/Radical_identity.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

// Process-wide numbers of signs and comparisons by the method that decided them.
struct Radical_sign_counts
{
  typedef std::atomic<std::uint64_t> Counter;

  Counter by_identity{0};       // same expression, or a rational
  Counter by_doubles{0};        // intervals of doubles
  Counter by_precision{0};      // intervals of up to 256 bits
  Counter zero_by_identity{0};  // zero by an identity of parts of the expression
  Counter exactly_zero{0};      // zero by exact arithmetic
  Counter exactly_not_zero{0};  // nonzero by exact arithmetic; sign by intervals of any precision
  Counter by_high_precision{0}; // undecided by exact arithmetic; intervals of up to 65536 bits
  Counter by_root_bound{0};     // intervals of as many bits as the root bound needs
  Counter by_core{0};

  // Decisions that intervals of few bits did not make
  std::uint64_t exact() const
  {
    return zero_by_identity + exactly_zero + exactly_not_zero + by_high_precision + by_root_bound + by_core;
  }
  std::uint64_t all() const { return by_identity + by_doubles + by_precision + exact(); }
  void reset()
  {
    for (Counter* c : {&by_identity, &by_doubles, &by_precision, &zero_by_identity, &exactly_zero, &exactly_not_zero,
                       &by_high_precision, &by_root_bound, &by_core})
      *c = 0;
  }
};

// Lower bound of the absolute value of an expression that is not zero: C. Burnikel, S. Funke, K. Mehlhorn, S. Schirra
// and S. Schmitt, A Separation Bound for Real Algebraic Expressions, ESA 2001. Its degree is 2^k for k square roots, so
// it is useful only for few roots.
//
// CORE of CGAL 5.5 computes the same bound with a wrong degree for subexpressions whose roots also occur elsewhere: it
// returns zero for (s - t) * (s + t) with nearly equal sums s, t of roots.
class Radical_bound
{
public:
  // The number is a quotient of algebraic integers whose conjugates are at most 2^over and 2^under. The logarithms are
  // rounded up to integers, so their sums are exact.
  struct Size
  {
    double over, under;
  };

  // Returns n such that the number is zero or at least 2^-n in absolute value, if the bound gives an n up to `largest`.
  static std::optional<std::size_t> bits(Radical_node& top, std::size_t largest)
  {
    Radical_bound bound;
    top.visit([&](const Radical_node& n) { return bound.m_sizes.count(&n) == 0; },
              [&](const Radical_node& n) { bound.m_sizes.emplace(&n, bound.size(n)); });
    const Size s = bound.m_sizes.at(&top);
    if (bound.m_is_unknown || bound.m_roots > most_roots) return std::nullopt;
    const double n = s.under + (std::ldexp(1., int(bound.m_roots)) - 1) * s.over;
    if (!(n <= double(largest))) return std::nullopt;
    return std::size_t(n) + 1;
  }

  // The arithmetic of sizes
  static Size negative(const Size& a) { return a; }
  static Size sum(const Size& a, const Size& b)
  {
    return {(std::max)(a.over + b.under, a.under + b.over) + 1, a.under + b.under};
  }
  static Size difference(const Size& a, const Size& b) { return sum(a, b); }
  static Size product(const Size& a, const Size& b) { return {a.over + b.over, a.under + b.under}; }
  static Size quotient(const Size& a, const Size& b) { return product(a, {b.under, b.over}); }
  Size square_root(const Size& a)
  {
    ++m_roots;
    const double mean = std::ceil((a.over + a.under) / 2);
    return a.over >= a.under ? Size{mean, a.under} : Size{a.over, mean};
  }

private:
  static constexpr std::size_t most_roots = 40;

  static double log2_above(mpz_srcptr n) { return double(mpz_sizeinbase(n, 2)); }
  static Size size(const Big_rational& q) { return {log2_above(numerator_of(q)), log2_above(denominator_of(q))}; }

  Size size(const Radical_node& n)
  {
    switch (n.operation())
    {
    case Radical_operation::RATIONAL: return size(*n.rational());
    case Radical_operation::CORE_NUMBER: m_is_unknown = true; return {0, 0};
    case Radical_operation::CLOSED_FORM: break;
    default: return apply(n.operation(), *this, [&](int i) -> const Size& { return m_sizes.at(n.operand(i).get()); });
    }
    Size s{0, 0};
    for (const Radical_term& t : n.closed_form()->numerator.terms())
      s = sum(s, t.radicand == 1 ? size(t.factor) : product(size(t.factor), square_root(size(Big_rational(t.radicand)))));
    return s;
  }

  std::unordered_map<const Radical_node*, Size> m_sizes;
  std::size_t m_roots = 0;
  bool m_is_unknown = false;
};

// Exact value of an expression. Nodes cache values without nested roots.
class Radical_evaluation
{
public:
  static constexpr std::size_t most_steps = std::size_t(1) << 22;

  explicit Radical_evaluation(std::size_t steps = most_steps) : m_field(steps) {}

  Vanishing vanishing_of(Radical_node& top)
  {
    Vanishing result = Vanishing::UNKNOWN;
    try
    {
      top.visit([this](const Radical_node& n) { return !is_known(n); }, [this](Radical_node& n) { evaluate(n); });
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

  Radical_quotient computed(const Radical_node& n)
  {
    if (n.rational()) return {Radical_sum(*n.rational()), Radical_sum(1)};
    if (n.operation() == Radical_operation::CORE_NUMBER) return m_field.unknown_number(&n);
    return apply(n.operation(), m_field, [&](int i) -> const Radical_quotient& { return value(*n.operand(i)); });
  }

  Radical_field m_field;
  std::unordered_map<const Radical_node*, Radical_quotient> m_values;
  std::vector<Radical_node*> m_evaluated;
};

class Radical_sign
{
public:
  typedef Radical_node::Reference Reference;

  static Radical_sign_counts& counts()
  {
    static Radical_sign_counts c;
    return c;
  }

  static int of(const Reference& a)
  {
    if (!a || a->rational()) return counted(counts().by_identity, a ? a->rational()->sign() : 0);
    if (a->has_sign()) return counted(counts().by_doubles, a->sign());
    if (refined_has_sign(*a, Radical_node::first_precision, exact_from)) return counted(counts().by_precision, a->sign());
    int factor = 1;
    const Reference simpler = with_same_sign(a, factor);
    const int sign = simpler == a ? exact_sign(a) : factor * of(simpler);
    if (sign == 0) set_zero(*a);
    return sign;
  }

  static int of_difference(const Reference& a, const Reference& b)
  {
    if (a == b) return counted(counts().by_identity, 0);
    if (!a || !b) return a ? of(a) : -of(b);
    if (const auto c = certain_comparison(*a, *b)) return counted(counts().by_doubles, *c);
    if (const auto parts = differing_parts(*a, *b)) return of_difference(*parts->first, *parts->second);
    if (Radical_likeness().are_alike(*a, *b)) return counted(counts().by_identity, 0);
    return of(Radical_expression::difference(a, b));
  }

  // Returns 0 if intervals of few bits do not decide.
  static int of_difference_by_intervals(const Reference& a, const Reference& b)
  {
    if (a == b) return 0;
    if (!a || !b) return of_difference(a, b);
    if (const auto c = certain_comparison(*a, *b)) return *c;
    const Reference d = Radical_expression::difference(a, b);
    return d && refined_has_sign(*d, Radical_node::first_precision, exact_from) ? d->sign() : 0;
  }

  // Computes closed forms of subexpressions within a small number of steps.
  static void simplify(const Reference& a)
  {
    if (a && !a->closed_form() && !a->rational()) Radical_evaluation(steps_to_simplify).vanishing_of(*a);
  }

  // Refines the interval of a number until it is tight. Returns false for zero.
  static bool approximate(const Reference& a)
  {
    if (!a) return false;
    for (std::size_t bits = Radical_node::first_precision; !is_tight(a->interval()); bits *= 2)
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

  static int counted(Radical_sign_counts::Counter& counter, int sign)
  {
    ++counter;
    return sign;
  }

  // The sign of a number that neither intervals of `exact_from` bits nor simpler numbers decide.
  static int exact_sign(const Reference& a)
  {
    if (Radical_identity::proves_zero(*a)) return counted(counts().zero_by_identity, 0);
    const Vanishing vanishing = Radical_evaluation().vanishing_of(*a);
    if (vanishing == Vanishing::ZERO) return counted(counts().exactly_zero, 0);
    if (vanishing == Vanishing::NOT_ZERO)
    {
      refined_has_sign(*a, 2 * exact_from, ~std::size_t(0));
      return counted(counts().exactly_not_zero, a->sign());
    }
    if (refined_has_sign(*a, 2 * exact_from, bound_from)) return counted(counts().by_high_precision, a->sign());
    if (const auto bound = Radical_bound::bits(*a, most_bits_of_bound))
    {
      for (std::size_t bits = 2 * bound_from; !a->has_sign() && !a->is_below(*bound); bits *= 2) a->refine(bits);
      return counted(counts().by_root_bound, a->sign());
    }
    if (refined_has_sign(*a, 2 * bound_from, core_from)) return counted(counts().by_high_precision, a->sign());
    return counted(counts().by_core, Core_conversion::to_core(a).sign());
  }

  // The sign of a - b if intervals of doubles decide it.
  static std::optional<int> certain_comparison(const Radical_node& a, const Radical_node& b)
  {
    const Double_interval &x = a.interval(), &y = b.interval();
    if (x.inf() > y.sup()) return 1;
    if (x.sup() < y.inf()) return -1;
    return x.is_point() && y.is_point() ? std::optional<int>(0) : std::nullopt;
  }

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
      const Radical_operation operation = a->operation();
      const bool is_product = operation == Radical_operation::MULTIPLY, is_quotient = operation == Radical_operation::DIVIDE;
      const bool is_difference = operation == Radical_operation::SUBTRACT;
      if (operation == Radical_operation::NEGATE)
      {
        factor = -factor;
        a = x;
      }
      else if ((is_product || is_quotient) && y->sign() != 0)
      {
        factor *= y->sign();
        a = x;
      }
      else if (is_product && x->sign() != 0)
      {
        factor *= x->sign();
        a = y;
      }
      // for y > 0, sqrt(u) - y and u - y^2 have the same sign
      else if (is_difference && is_root(*x) && y->sign() > 0) a = Radical_expression::difference(x->operand(0), square(y));
      else if (is_difference && is_root(*y) && x->sign() > 0) a = Radical_expression::difference(square(x), y->operand(0));
      else break;
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

} // namespace CGAL::Radical_numbers::internal

#endif
