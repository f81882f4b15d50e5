// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nodes of expressions made of rationals by + - * / and square roots, and their evaluation with intervals.
//
// Nodes are reference-counted and shared. The value of a node is constant, but its cached bounds improve, and a node
// may drop its operands once its closed form is known. Neither is protected against concurrent access. Nothing here is
// recursive, so only memory limits the depth of an expression.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_NODE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_NODE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/core_numbers.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Double_interval.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Multiprecision_interval.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_field.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sum.h>

#include <CGAL/CORE_Expr.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

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

class Radical_node
{
public:
  // Reference-counted pointer. Null stands for zero, which is never an operand.
  class Reference
  {
  public:
    Reference() : m_node(nullptr) {}
    explicit Reference(Radical_node* n) : m_node(n) { ++n->m_references; }
    Reference(const Reference& o) : m_node(o.m_node)
    {
      if (m_node) ++m_node->m_references;
    }
    Reference(Reference&& o) noexcept : m_node(o.m_node) { o.m_node = nullptr; }
    Reference& operator=(Reference o) noexcept
    {
      std::swap(m_node, o.m_node);
      return *this;
    }
    ~Reference()
    {
      if (m_node) release(m_node);
    }

    explicit operator bool() const { return m_node != nullptr; }
    Radical_node& operator*() const { return *m_node; }
    Radical_node* operator->() const { return m_node; }
    Radical_node* get() const { return m_node; }
    friend bool operator==(const Reference& a, const Reference& b) { return a.m_node == b.m_node; }

  private:
    friend class Radical_node;
    Radical_node* m_node;
  };

  static Reference make(Big_rational q)
  {
    if (q.is_zero()) return Reference();
    Reference r(new Radical_node(Radical_operation::RATIONAL));
    Multiprecision_interval e(bits_of_double);
    e.set(q);
    r->m_interval = e.rounded();
    r->m_rational.reset(new Big_rational(std::move(q)));
    return r;
  }
  static Reference make(const CORE::Expr& x)
  {
    Reference r(new Radical_node(Radical_operation::CORE_NUMBER));
    r->m_interval = Double_interval::everything();
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
    r->m_interval = r->evaluate();
    return r;
  }

  Radical_operation operation() const { return m_operation; }
  const Reference& operand(int i) const { return m_operands[i]; }
  std::size_t depth() const { return m_depth; }
  const Big_rational* rational() const { return m_rational.get(); } // of a rational constant, else null
  const CORE::Expr& core_number() const { return *m_core; }
  const Double_interval& interval() const { return m_interval; }
  // Includes the multiprecision bounds, which have a sign also beyond the range of doubles.
  bool has_sign() const { return m_interval.has_sign() || (m_bounds && m_bounds->has_sign()); }
  int sign() const { return m_interval.has_sign() || !m_bounds ? m_interval.sign() : m_bounds->sign(); }
  // Nearest double or a close one, once the interval is tight.
  double approximation() const { return m_bounds ? m_bounds->low_to_nearest() : m_interval.middle(); }
  bool is_below(std::size_t bits) const { return m_bounds && m_bounds->is_below(bits); }
  std::size_t precision() const { return m_bounds ? std::size_t(m_bounds->precision()) : 0; }

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
      // zero gets bounds, too, so that no evaluation is needed to see its sign
      m_bounds.reset(new Multiprecision_interval(bits_of_double));
      m_bounds->set(*m_rational);
      m_interval.intersect(m_bounds->rounded());
    }
    else m_operation = Radical_operation::CLOSED_FORM;
    m_depth = 0;
    m_operands[0] = Reference();
    m_operands[1] = Reference();
  }

  // Visits the needed nodes at and below `top`, operands first. A visited node must no longer be needed.
  template <class Is_needed, class Visitor>
  static void visit(Radical_node& top, const Is_needed& is_needed, const Visitor& visitor)
  {
    std::vector<Radical_node*> pending(1, &top);
    while (!pending.empty())
    {
      Radical_node* n = pending.back();
      const std::size_t size = pending.size();
      if (is_needed(*n))
      {
        for (const Reference& o : n->m_operands)
          if (o && is_needed(*o)) pending.push_back(o.get());
        if (pending.size() > size) continue;
        visitor(*n);
      }
      pending.pop_back();
    }
  }

  // Evaluates the node with bounds of at least `bits` bits.
  void refine(std::size_t bits)
  {
    visit(
      *this, [&](const Radical_node& n) { return n.precision() < bits; }, [&](Radical_node& n) { n.evaluate_with(bits); });
  }

  static constexpr std::size_t first_precision = 128;

private:
  static constexpr std::size_t bits_of_double = 53;
  static constexpr std::size_t most_terms_of_constant = 4;

  explicit Radical_node(Radical_operation op) : m_operation(op) {}

  static void release(Radical_node* n)
  {
    if (--n->m_references != 0) return;
    // iterative, since a long chain of operands may die with its only user
    Radical_node* dying = n;
    n->m_next = nullptr;
    while (dying)
    {
      n = dying;
      dying = n->m_next;
      for (Reference& o : n->m_operands)
      {
        Radical_node* child = o.m_node;
        o.m_node = nullptr;
        if (!child || --child->m_references != 0) continue;
        child->m_next = dying;
        dying = child;
      }
      delete n;
    }
  }

  Double_interval evaluate() const
  {
    const Double_interval& a = m_operands[0]->m_interval;
    switch (m_operation)
    {
    case Radical_operation::NEGATE: return -a;
    case Radical_operation::ADD: return a + m_operands[1]->m_interval;
    case Radical_operation::SUBTRACT: return a - m_operands[1]->m_interval;
    case Radical_operation::MULTIPLY: return a * m_operands[1]->m_interval;
    case Radical_operation::DIVIDE: return a / m_operands[1]->m_interval;
    default: return sqrt(a);
    }
  }

  void evaluate_with(std::size_t bits)
  {
    std::unique_ptr<Multiprecision_interval> e(new Multiprecision_interval(mpfr_prec_t(bits)));
    const auto bounds = [this](int i) -> const Multiprecision_interval& { return *m_operands[i]->m_bounds; };
    switch (m_operation)
    {
    case Radical_operation::RATIONAL: e->set(*m_rational); break;
    case Radical_operation::CLOSED_FORM: *e = interval_of_closed_form(bits); break;
    case Radical_operation::CORE_NUMBER: set_by_core(*e); break;
    case Radical_operation::NEGATE: e->set_negative(bounds(0)); break;
    case Radical_operation::ADD: e->set_sum(bounds(0), bounds(1)); break;
    case Radical_operation::SUBTRACT: e->set_difference(bounds(0), bounds(1)); break;
    case Radical_operation::MULTIPLY: e->set_product(bounds(0), bounds(1)); break;
    case Radical_operation::DIVIDE: e->set_quotient(bounds(0), bounds(1)); break;
    case Radical_operation::SQUARE_ROOT: e->set_root(bounds(0)); break;
    }
    m_bounds = std::move(e);
    m_interval.intersect(m_bounds->rounded());
  }

  Multiprecision_interval interval_of_closed_form(std::size_t bits) const
  {
    const auto no_symbol = [](std::size_t) -> Multiprecision_interval { throw std::logic_error("not a closed form"); };
    return interval_of(m_closed_form->numerator, mpfr_prec_t(bits), no_symbol);
  }

  // CORE approximates with an absolute or relative error of at most 2^-bits.
  void set_by_core(Multiprecision_interval& e) const
  {
    const long bits = long(e.precision());
    const Big_rational middle = rational_of_core(m_core->approx(bits + 8, bits + 8).BigRatValue());
    Big_rational unit = 1;
    mpq_div_2exp(unit.backend().data(), unit.backend().data(), mp_bitcnt_t(bits));
    const Big_rational error = (1 + boost::multiprecision::abs(middle)) * unit;
    e.set(middle - error, middle + error);
  }

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

} // namespace CGAL::Geodesic_offset::internal

#endif
