// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_RADICAL_NUMBER_H
#define CGAL_RADICAL_NUMBER_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Core_conversion.h>
#include <CGAL/Radical_number/internal/Radical_expression.h>
#include <CGAL/Radical_number/internal/Radical_sign.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <boost/operators.hpp>

#include <cmath>
#include <cstddef>
#include <iostream>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {

/*!
\ingroup PkgRadicalNumberRef

An exact number that is computed from rational numbers by + - * / and square roots.

A number is a reference to an expression, which other numbers may share. Expressions cache bounds and other properties of their
values, without locks: numbers with common subexpressions must not be used by several threads at once.

Numbers are read from streams and written to them as `double`. The square root is `CGAL::sqrt()`, as for all models of
`FieldWithSqrt`.

\cgalModels{FieldWithSqrt}
\cgalModels{RealEmbeddable}
*/
class Radical_number : private boost::ordered_field_operators<Radical_number>
{
  typedef Radical_numbers::internal::Radical_node Node;
  typedef Radical_numbers::internal::Radical_expression Expression;
  typedef Radical_numbers::internal::Radical_sign Exact_sign;

public:
  /// Zero.
  Radical_number() = default;

  /// An integer.
  template <class Integer, std::enable_if_t<std::is_integral<Integer>::value>* = nullptr>
  Radical_number(Integer i) : m_node(Node::make(Radical_numbers::internal::Big_rational(i)))
  {
  }

  /// The exact value of a `double`. Throws `std::domain_error` if it is not finite.
  Radical_number(double d)
  {
    if (!std::isfinite(d)) throw std::domain_error("not a finite number");
    m_node = Node::make(Radical_numbers::internal::Big_rational(d));
  }

  /// A rational number.
  Radical_number(const Gmpq& q) : Radical_number(q.mpq()) {}

#ifdef CGAL_USE_GMPXX
  /// A rational number.
  Radical_number(const mpq_class& q) : Radical_number(q.get_mpq_t()) {}
#endif

  /// A rational number of Boost.
  template <boost::multiprecision::expression_template_option Option>
  Radical_number(const boost::multiprecision::number<boost::multiprecision::gmp_rational, Option>& q)
    : Radical_number(q.backend().data())
  {
  }

  /// A number of CORE.
  Radical_number(const CORE::Expr& x) : m_node(Radical_numbers::internal::Core_conversion::from_core(x)) {}

  /// Conversion to CORE, in a short form if simplification is cheap. CORE is recursive: expressions thousands of operations deep
  /// throw `std::length_error`.
  CORE::Expr core_expression() const
  {
    Exact_sign::simplify(m_node);
    return Radical_numbers::internal::Core_conversion::to_core(m_node);
  }

  /// The sign.
  CGAL::Sign sign() const
  {
    const int s = Exact_sign::of(m_node);
    if (s == 0) m_node = nullptr;
    return CGAL::Sign(s);
  }

  /// Comparison with another number.
  Comparison_result compare(const Radical_number& o) const
  {
    const int s = Exact_sign::of_difference(m_node, o.m_node);
    if (s == 0)
    {
      // Both numbers become the simpler one of the two equal expressions.
      const bool mine = !m_node || (o.m_node && m_node->depth() <= o.m_node->depth());
      (mine ? o : *this).m_node = (mine ? *this : o).m_node;
    }
    return Comparison_result(s);
  }

  /// Comparison by intervals of at most 256 bits, which may be uncertain.
  Uncertain<Comparison_result> compare_by_intervals(const Radical_number& o) const
  {
    if (m_node == o.m_node) return EQUAL;
    const int s = Exact_sign::of_difference_by_intervals(m_node, o.m_node);
    return s == 0 ? Uncertain<Comparison_result>::indeterminate() : make_uncertain(Comparison_result(s));
  }

  /// Approximation, correct within a few units in the last place; 0 only for zero and for numbers too small for a double.
  double to_double() const { return Exact_sign::approximate(m_node) ? m_node->approximation() : 0; }

  /// Bounds that are a few units in the last place apart.
  std::pair<double, double> to_interval() const
  {
    return Exact_sign::approximate(m_node) ? m_node->interval().pair() : std::pair<double, double>(0, 0);
  }

  /// Bounds without a sign decision: usually a few units in the last place apart, wide where many digits cancel.
  std::pair<double, double> bounds() const
  {
    if (!m_node) return {0, 0};
    if (!Radical_numbers::internal::is_tight(m_node->interval())) m_node->refine(Node::first_precision);
    return m_node->interval().pair();
  }

  /// Square root. Throws `std::domain_error` for a negative number; for one whose sign is not yet known, the exception is thrown
  /// only when the sign of a result is computed.
  Radical_number square_root() const { return Radical_number(Expression::square_root(m_node)); }

  /// The number itself.
  Radical_number operator+() const { return *this; }

  /// Negation.
  Radical_number operator-() const { return Radical_number(Expression::negative(m_node)); }

  /// Addition.
  Radical_number& operator+=(const Radical_number& o)
  {
    m_node = Expression::sum(m_node, o.m_node);
    return *this;
  }

  /// Subtraction.
  Radical_number& operator-=(const Radical_number& o)
  {
    m_node = Expression::difference(m_node, o.m_node);
    return *this;
  }

  /// Multiplication.
  Radical_number& operator*=(const Radical_number& o)
  {
    m_node = Expression::product(m_node, o.m_node);
    return *this;
  }

  /// Division. Throws `std::domain_error` if the divisor is zero; for a divisor whose sign is not yet known, the exception is
  /// thrown only when the sign of a result is computed.
  Radical_number& operator/=(const Radical_number& o)
  {
    m_node = Expression::quotient(m_node, o.m_node);
    return *this;
  }

  friend bool operator==(const Radical_number& a, const Radical_number& b) { return a.compare(b) == EQUAL; }
  friend bool operator<(const Radical_number& a, const Radical_number& b) { return a.compare(b) == SMALLER; }

  friend std::ostream& operator<<(std::ostream& out, const Radical_number& a) { return out << a.to_double(); }
  friend std::istream& operator>>(std::istream& in, Radical_number& a)
  {
    double d;
    if (in >> d) a = Radical_number(d);
    return in;
  }

  /// Process-wide number of decided signs and comparisons.
  static std::size_t number_of_decisions() { return std::size_t(Exact_sign::counts().all()); }

  /// Process-wide number of signs and comparisons that intervals of at most 256 bits did not decide.
  static std::size_t number_of_exact_decisions() { return std::size_t(Exact_sign::counts().exact()); }

private:
  explicit Radical_number(mpq_srcptr q)
  {
    Radical_numbers::internal::Big_rational r;
    mpq_set(r.backend().data(), q);
    m_node = Node::make(std::move(r));
  }
  explicit Radical_number(Node::Reference node) : m_node(std::move(node)) {}

  mutable Node::Reference m_node; // a comparison may replace it by a simpler expression of equal value
};

#ifndef DOXYGEN_RUNNING

template <>
class Algebraic_structure_traits<Radical_number> : public Algebraic_structure_traits_base<Radical_number, Field_with_sqrt_tag>
{
public:
  typedef Radical_number Type;
  typedef Tag_true Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Sqrt : public CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return x.square_root(); }
  };
};

template <>
class Real_embeddable_traits<Radical_number> : public INTERN_RET::Real_embeddable_traits_base<Radical_number, Tag_true>
{
public:
  typedef Radical_number Type;

  struct Sgn : public CGAL::cpp98::unary_function<Type, ::CGAL::Sign>
  {
    ::CGAL::Sign operator()(const Type& x) const { return x.sign(); }
  };
  struct Compare : public CGAL::cpp98::binary_function<Type, Type, ::CGAL::Comparison_result>
  {
    ::CGAL::Comparison_result operator()(const Type& x, const Type& y) const { return x.compare(y); }
    CGAL_IMPLICIT_INTEROPERABLE_BINARY_OPERATOR_WITH_RT(Type, ::CGAL::Comparison_result)
  };
  struct To_double : public CGAL::cpp98::unary_function<Type, double>
  {
    double operator()(const Type& x) const { return x.to_double(); }
  };
  struct To_interval : public CGAL::cpp98::unary_function<Type, std::pair<double, double>>
  {
    std::pair<double, double> operator()(const Type& x) const { return x.to_interval(); }
  };
};

CGAL_DEFINE_COERCION_TRAITS_FOR_SELF(Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(short, Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(int, Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(long, Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(float, Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(double, Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(Exact_rational, Radical_number)

#endif

} // namespace CGAL

#endif
