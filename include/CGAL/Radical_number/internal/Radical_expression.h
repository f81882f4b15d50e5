// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Expressions as directed acyclic graphs of nodes, each of which caches bounds of its value.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_EXPRESSION_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_EXPRESSION_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Multiprecision_interval.h>
#include <CGAL/Radical_number/internal/Radical_field.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/number_utils.h>

#include <boost/smart_ptr/intrusive_ptr.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

enum class Radical_operation : std::uint8_t {
  RATIONAL,    // constant
  CLOSED_FORM, // constant: sum of roots of rationals
  CORE_NUMBER, // constant: a number that only CORE can represent
  NEGATE,
  ADD,
  SUBTRACT,
  MULTIPLY,
  DIVIDE,
  SQUARE_ROOT
};

// The result of an operation, no constant, in an arithmetic: a class with one function per operation. operand(i) is operand i in
// the arithmetic.
template <class Arithmetic, class Operand>
auto apply(Radical_operation operation, Arithmetic&& arithmetic, const Operand& operand)
{
  decltype(auto) a = operand(0); // before the other one
  switch (operation)
  {
  case Radical_operation::NEGATE: return arithmetic.negative(a);
  case Radical_operation::ADD: return arithmetic.sum(a, operand(1));
  case Radical_operation::SUBTRACT: return arithmetic.difference(a, operand(1));
  case Radical_operation::MULTIPLY: return arithmetic.product(a, operand(1));
  case Radical_operation::DIVIDE: return arithmetic.quotient(a, operand(1));
  default: return arithmetic.square_root(a);
  }
}

// The arithmetic of a type with operators.
template <class Number>
struct Operator_arithmetic
{
  static Number negative(const Number& a) { return -a; }
  static Number sum(const Number& a, const Number& b) { return a + b; }
  static Number difference(const Number& a, const Number& b) { return a - b; }
  static Number product(const Number& a, const Number& b) { return a * b; }
  static Number quotient(const Number& a, const Number& b) { return a / b; }
  static Number square_root(const Number& a) { return CGAL::sqrt(a); }
};

// Visits the needed nodes at and below `top`, operands first: `operands(n)` is a range of pointers, some of which may be null.
// A visited node must no longer be needed. Without recursion, which long chains of operations would take too deep.
template <class Node, class Operands, class Is_needed, class Visitor>
void visit_operands_first(Node* top, const Operands& operands, const Is_needed& is_needed, const Visitor& visitor)
{
  std::vector<Node*> pending(1, top);
  while (!pending.empty())
  {
    Node* n = pending.back();
    const std::size_t size = pending.size();
    if (is_needed(n))
    {
      for (Node* o : operands(n))
        if (o && is_needed(o)) pending.push_back(o);
      if (pending.size() > size) continue;
      visitor(n);
    }
    pending.pop_back();
  }
}

// Core_rational is CORE::BigRat, which is a number of Boost or, in CGAL 5, CORE's own.
template <class Core_rational>
Big_rational rational_of_core(const Core_rational& q)
{
  if constexpr (std::is_constructible<Big_rational, const Core_rational&>::value) return Big_rational(q);
  else
  {
    Big_rational r;
    mpq_set(r.backend().data(), q.get_mp());
    return r;
  }
}

// CORE approximates with an absolute or relative error of at most 2^-bits.
inline std::pair<Big_rational, Big_rational> bounds_by_core(const CORE::Expr& x, long bits)
{
  const Big_rational middle = rational_of_core(x.approx(bits + 8, bits + 8).BigRatValue());
  Big_rational error = 1 + boost::multiprecision::abs(middle);
  mpq_div_2exp(error.backend().data(), error.backend().data(), mp_bitcnt_t(bits));
  return {middle - error, middle + error};
}

class Radical_node
{
public:
  typedef boost::intrusive_ptr<Radical_node> Reference; // Null stands for zero, which is never an operand.

  static Reference make(Big_rational q)
  {
    if (q.is_zero()) return Reference();
    Reference r(new Radical_node(Radical_operation::RATIONAL));
    r->m_interval = Multiprecision_arithmetic(bits_of_double).enclosure(q).rounded();
    r->m_rational.reset(new Big_rational(std::move(q)));
    return r;
  }
  static Reference make(const CORE::Expr& x)
  {
    Reference r(new Radical_node(Radical_operation::CORE_NUMBER));
    r->m_interval = Double_interval::largest();
    r->m_core.reset(new CORE::Expr(x));
    r->refine(first_precision);
    return r;
  }
  static Reference make(Radical_operation op, const Reference& a, const Reference& b = Reference())
  {
    Reference r(new Radical_node(op));
    r->m_operands[0] = a;
    r->m_operands[1] = b;
    r->m_depth = 1 + (std::max)(a->m_depth, b ? b->m_depth : std::uint32_t(0));
    r->m_interval = apply(op, Operator_arithmetic<Double_interval>(), [&](int i) -> const Double_interval& {
      return r->m_operands[i]->m_interval;
    });
    return r;
  }

  Radical_operation operation() const { return m_operation; }
  const Reference& operand(int i) const { return m_operands[i]; }
  std::size_t depth() const { return m_depth; }
  const Big_rational* rational() const { return m_rational.get(); } // of a rational constant, else null
  const CORE::Expr& core_number() const { return *m_core; }
  const Double_interval& interval() const { return m_interval; }
  // Includes the multiprecision bounds, which have a sign also beyond the range of doubles. The sign is 0 if it is not known.
  bool has_sign() const { return internal::has_sign(m_interval) || (m_bounds && m_bounds->has_sign()); }
  int sign() const { return internal::has_sign(m_interval) || !m_bounds ? sign_of(m_interval) : m_bounds->sign(); }
  // Nearest double or a close one, once the interval is tight.
  double approximation() const { return m_bounds ? m_bounds->low_to_nearest() : middle_of(m_interval); }
  bool is_below(std::size_t bits) const { return m_bounds && m_bounds->is_below(bits); }

  // Closed form without symbols, or null if unknown.
  const Radical_quotient* closed_form() const { return m_closed_form.get(); }
  void set_closed_form(Radical_quotient q) { m_closed_form.reset(new Radical_quotient(std::move(q))); }

  // Turns a node with a short closed form into a constant.
  void forget_operands()
  {
    if (!m_operands[0] || !m_closed_form || !m_closed_form->is_sum()) return;
    const Radical_sum& s = m_closed_form->numerator;
    if (s.size() > most_terms_of_constant) return;
    if (s.is_rational())
    {
      m_rational.reset(new Big_rational(s.rational()));
      m_operation = Radical_operation::RATIONAL;
      evaluate(bits_of_double); // also of zero, so that no evaluation is needed to see its sign
    }
    else m_operation = Radical_operation::CLOSED_FORM;
    m_depth = 0;
    m_operands[0] = nullptr;
    m_operands[1] = nullptr;
  }

  // Visits the needed nodes at and below this one.
  template <class Is_needed, class Visitor>
  void visit(const Is_needed& is_needed, const Visitor& visitor)
  {
    visit_operands_first(
      this,
      [](const Radical_node* n) {
        return std::array<Radical_node*, 2>{n->m_operands[0].get(), n->m_operands[1].get()};
      },
      [&](const Radical_node* n) { return is_needed(*n); }, [&](Radical_node* n) { visitor(*n); });
  }

  // Evaluates the node with bounds of at least `bits` bits.
  void refine(std::size_t bits)
  {
    visit([&](const Radical_node& n) { return !n.m_bounds || n.m_bounds->precision() < bits; },
          [&](Radical_node& n) { n.evaluate(bits); });
  }

  static constexpr std::size_t first_precision = 128;

private:
  static constexpr std::size_t bits_of_double = 53;
  static constexpr std::size_t most_terms_of_constant = 4;

  explicit Radical_node(Radical_operation op) : m_operation(op), m_interval(0) {}

  friend void intrusive_ptr_add_ref(Radical_node* n) { ++n->m_references; }
  friend void intrusive_ptr_release(Radical_node* n)
  {
    if (--n->m_references != 0) return;
    // iterative, since a long chain of operands may die with its only user
    Radical_node* dying = n;
    while (dying)
    {
      n = dying;
      dying = n->m_next;
      for (Reference& o : n->m_operands)
      {
        Radical_node* operand = o.detach();
        if (!operand || --operand->m_references != 0) continue;
        operand->m_next = dying;
        dying = operand;
      }
      delete n;
    }
  }

  void evaluate(std::size_t bits)
  {
    m_bounds.reset(new Multiprecision_interval(bounds(Multiprecision_arithmetic(bits))));
    m_interval = intersection_of(m_interval, m_bounds->rounded());
  }

  Multiprecision_interval bounds(const Multiprecision_arithmetic& arithmetic) const
  {
    switch (m_operation)
    {
    case Radical_operation::RATIONAL: return arithmetic.enclosure(*m_rational);
    case Radical_operation::CLOSED_FORM: return arithmetic.enclosure(m_closed_form->numerator, no_symbol);
    case Radical_operation::CORE_NUMBER:
    {
      const auto bounds = bounds_by_core(*m_core, long(arithmetic.precision()));
      return arithmetic.enclosure(bounds.first, bounds.second);
    }
    default:
      return apply(m_operation, arithmetic,
                   [this](int i) -> const Multiprecision_interval& { return *m_operands[i]->m_bounds; });
    }
  }

  static Multiprecision_interval no_symbol(std::size_t) { throw std::logic_error("not a closed form"); }

  Radical_node* m_next = nullptr; // list of dying nodes
  std::size_t m_references = 0;
  std::uint32_t m_depth = 0;
  Radical_operation m_operation;
  Reference m_operands[2];
  Double_interval m_interval;
  std::unique_ptr<Big_rational> m_rational;
  std::unique_ptr<CORE::Expr> m_core;
  std::unique_ptr<Multiprecision_interval> m_bounds;
  std::unique_ptr<Radical_quotient> m_closed_form;
};

// The arithmetic of expressions, with simplifications that take no search.
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
    return result(Radical_operation::ADD, a, b, std::plus<Big_rational>());
  }

  static Reference difference(const Reference& a, const Reference& b)
  {
    if (!b) return a;
    if (!a) return negative(b);
    if (a == b) return Reference();
    return result(Radical_operation::SUBTRACT, a, b, std::minus<Big_rational>());
  }

  static Reference product(const Reference& a, const Reference& b)
  {
    if (!a || !b) return Reference();
    if (is_unit(a)) return with_sign_of(a, b);
    if (is_unit(b)) return with_sign_of(b, a);
    if (a == b && a->operation() == Radical_operation::SQUARE_ROOT) return a->operand(0);
    return result(Radical_operation::MULTIPLY, a, b, std::multiplies<Big_rational>());
  }

  static Reference quotient(const Reference& a, const Reference& b)
  {
    if (!b || (b->rational() && b->rational()->is_zero())) throw std::domain_error("division by zero");
    if (!a) return a;
    if (is_unit(b)) return with_sign_of(b, a);
    if (a == b) return Radical_node::make(Big_rational(1));
    return result(Radical_operation::DIVIDE, a, b, std::divides<Big_rational>());
  }

  static Reference square_root(const Reference& a)
  {
    if (!a) return a;
    if (a->interval().sup() < 0) throw std::domain_error("square root of a negative number");
    if (a->rational())
      if (const auto root = rational_root_of(*a->rational())) return Radical_node::make(*root);
    if (a->operation() == Radical_operation::MULTIPLY && a->operand(0) == a->operand(1))
    {
      const int sign = sign_of(a->operand(0)->interval());
      if (sign != 0) return sign > 0 ? a->operand(0) : negative(a->operand(0));
    }
    return Radical_node::make(Radical_operation::SQUARE_ROOT, a);
  }

private:
  static constexpr std::size_t most_bits = 2000; // larger rationals are not computed

  static bool is_small(const Big_rational* q) { return q && bits_of(*q) < most_bits; }
  static bool is_unit(const Reference& a) { return a->rational() && boost::multiprecision::abs(*a->rational()) == 1; }
  static Reference with_sign_of(const Reference& unit, const Reference& a)
  {
    return unit->rational()->sign() > 0 ? a : negative(a);
  }

  // A constant if operands and result are small rationals.
  template <class Function>
  static Reference result(Radical_operation op, const Reference& a, const Reference& b, const Function& function)
  {
    if (is_small(a->rational()) && is_small(b->rational()))
    {
      Big_rational q = function(*a->rational(), *b->rational());
      if (is_small(&q)) return Radical_node::make(std::move(q));
    }
    return Radical_node::make(op, a, b);
  }
};

} // namespace CGAL::Radical_numbers::internal

#endif
