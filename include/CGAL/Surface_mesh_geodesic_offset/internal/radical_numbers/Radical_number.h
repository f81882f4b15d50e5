// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact number type for values computed from rationals by + - * / and square roots. Comparisons are certified, and fast
// also for equal numbers.
//
// To prove that a number with k square roots is zero, CORE::Expr needs a root bound of degree 2^k, which is infeasible
// from a dozen roots on. Radical_number evaluates such a number exactly, as a sum of square roots of integers
// (Radical_sum.h, Radical_field.h) with nested roots as symbols; CORE decides only the remaining cases. Evaluation is
// lazy and starts with intervals.
//
// A number is a reference to an expression, which other numbers may share. Expressions cache bounds and
// other properties of their values, without locks: numbers with common subexpressions must not be used by several threads at
// once.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_NUMBER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_RADICAL_NUMBERS_RADICAL_NUMBER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_from_core.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_to_core.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_expression.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_node.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/radical_numbers/Radical_sign.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>

#include <CGAL/CORE_Expr.h>
#include <CGAL/Exact_rational.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Uncertain.h>
#include <CGAL/number_type_basic.h>

#include <cmath>
#include <iostream>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// Access to the rational types of CGAL that are based on GMP.
template <class Q>
struct Gmp_rational_access
{
  static constexpr bool is_rational = false;
};
template <>
struct Gmp_rational_access<Gmpq>
{
  static constexpr bool is_rational = true;
  static mpq_srcptr data(const Gmpq& q) { return q.mpq(); }
};
template <boost::multiprecision::expression_template_option Option>
struct Gmp_rational_access<boost::multiprecision::number<boost::multiprecision::gmp_rational, Option>>
{
  static constexpr bool is_rational = true;
  static mpq_srcptr data(const boost::multiprecision::number<boost::multiprecision::gmp_rational, Option>& q)
  {
    return q.backend().data();
  }
};
#ifdef CGAL_USE_GMPXX
template <>
struct Gmp_rational_access<mpq_class>
{
  static constexpr bool is_rational = true;
  static mpq_srcptr data(const mpq_class& q) { return q.get_mpq_t(); }
};
#endif

class Radical_number
{
  typedef Radical_node::Reference Reference;
  typedef Radical_expression Make;

public:
  Radical_number() = default;

  template <class T, std::enable_if_t<std::is_integral<T>::value>* = nullptr>
  Radical_number(T i)
  {
    if (i != 0) m_node = Radical_node::make(Big_rational(i));
  }
  // The exact value of a finite double.
  Radical_number(double d)
  {
    if (!std::isfinite(d)) throw std::domain_error("not a finite number");
    if (d != 0) m_node = Radical_node::make(Big_rational(d));
  }
  template <class Q, std::enable_if_t<Gmp_rational_access<Q>::is_rational>* = nullptr>
  Radical_number(const Q& q)
  {
    Big_rational r;
    mpq_set(r.backend().data(), Gmp_rational_access<Q>::data(q));
    m_node = Radical_node::make(std::move(r));
  }
  Radical_number(const CORE::Expr& x) : m_node(Radical_from_core::convert(x)) {}

  // Conversion to CORE, in a short form if simplification is cheap. CORE is recursive: expressions thousands of
  // operations deep throw std::length_error.
  CORE::Expr core_expression() const
  {
    Radical_sign::simplify(m_node);
    return Radical_to_core::convert(m_node);
  }

  // Counts of the methods that decided signs and comparisons.
  static Radical_number_counts& counts() { return Radical_sign::counts(); }

  CGAL::Sign sign() const
  {
    const int s = Radical_sign::of(m_node);
    if (s == 0) m_node = Reference();
    return CGAL::Sign(s);
  }

  Comparison_result compare(const Radical_number& o) const
  {
    const int s = Radical_sign::of_difference(m_node, o.m_node);
    if (s == 0)
    {
      // Both numbers become the simpler one of the two equal expressions.
      const bool mine = !m_node || (o.m_node && m_node->depth() <= o.m_node->depth());
      (mine ? o : *this).m_node = (mine ? *this : o).m_node;
    }
    return Comparison_result(s);
  }

  // Correct within a few units in the last place; 0 only for zero and for numbers too small for a double.
  double to_double() const { return Radical_sign::approximate(m_node) ? m_node->approximation() : 0; }
  std::pair<double, double> to_interval() const
  {
    if (!Radical_sign::approximate(m_node)) return {0, 0};
    return {m_node->interval().low, m_node->interval().high};
  }

  // Bounds without a sign decision: usually a few units in the last place apart, wide where many digits cancel.
  std::pair<double, double> bounds() const
  {
    if (!m_node) return {0, 0};
    if (!m_node->interval().is_tight()) m_node->refine(Radical_node::first_precision);
    return {m_node->interval().low, m_node->interval().high};
  }

  Radical_number square_root() const { return Radical_number(Make::square_root(m_node)); }

  Radical_number operator+() const { return *this; }
  Radical_number operator-() const { return Radical_number(Make::negative(m_node)); }

  Radical_number& operator+=(const Radical_number& o)
  {
    m_node = Make::sum(m_node, o.m_node);
    return *this;
  }
  Radical_number& operator-=(const Radical_number& o)
  {
    m_node = Make::difference(m_node, o.m_node);
    return *this;
  }
  Radical_number& operator*=(const Radical_number& o)
  {
    m_node = Make::product(m_node, o.m_node);
    return *this;
  }
  // Throws std::domain_error if the divisor is zero; for a divisor whose sign is not yet known, the exception is thrown
  // only when the sign of a result is computed.
  Radical_number& operator/=(const Radical_number& o)
  {
    m_node = Make::quotient(m_node, o.m_node);
    return *this;
  }

  friend Radical_number operator+(const Radical_number& a, const Radical_number& b)
  {
    return Radical_number(Make::sum(a.m_node, b.m_node));
  }
  friend Radical_number operator-(const Radical_number& a, const Radical_number& b)
  {
    return Radical_number(Make::difference(a.m_node, b.m_node));
  }
  friend Radical_number operator*(const Radical_number& a, const Radical_number& b)
  {
    return Radical_number(Make::product(a.m_node, b.m_node));
  }
  friend Radical_number operator/(const Radical_number& a, const Radical_number& b)
  {
    return Radical_number(Make::quotient(a.m_node, b.m_node));
  }

  friend bool operator==(const Radical_number& a, const Radical_number& b) { return a.compare(b) == EQUAL; }
  friend bool operator!=(const Radical_number& a, const Radical_number& b) { return a.compare(b) != EQUAL; }
  friend bool operator<(const Radical_number& a, const Radical_number& b) { return a.compare(b) == SMALLER; }
  friend bool operator>(const Radical_number& a, const Radical_number& b) { return a.compare(b) == LARGER; }
  friend bool operator<=(const Radical_number& a, const Radical_number& b) { return a.compare(b) != LARGER; }
  friend bool operator>=(const Radical_number& a, const Radical_number& b) { return a.compare(b) != SMALLER; }

  // Input and output as double.
  friend std::ostream& operator<<(std::ostream& out, const Radical_number& a) { return out << a.to_double(); }
  friend std::istream& operator>>(std::istream& in, Radical_number& a)
  {
    double d;
    if (in >> d) a = Radical_number(d);
    return in;
  }

private:
  friend Uncertain<Comparison_result> compare_bounds(const Radical_number& a, const Radical_number& b)
  {
    if (a.m_node == b.m_node) return EQUAL;
    const int s = Radical_sign::of_difference_by_intervals(a.m_node, b.m_node);
    return s == 0 ? Uncertain<Comparison_result>::indeterminate() : make_uncertain(Comparison_result(s));
  }
  friend std::pair<double, double> bounds_of(const Radical_number& a) { return a.bounds(); }

  explicit Radical_number(Reference node) : m_node(std::move(node)) {}

  mutable Reference m_node; // a comparison may replace it by a simpler expression of equal value
};

} // namespace internal
} // namespace Geodesic_offset

template <>
class Algebraic_structure_traits<Geodesic_offset::internal::Radical_number>
  : public Algebraic_structure_traits_base<Geodesic_offset::internal::Radical_number, Field_with_sqrt_tag>
{
public:
  typedef Geodesic_offset::internal::Radical_number Type;
  typedef Tag_true Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Is_zero : public CGAL::cpp98::unary_function<Type, bool>
  {
    bool operator()(const Type& x) const { return x.sign() == ZERO; }
  };
  struct Sqrt : public CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return x.square_root(); }
  };
};

template <>
class Real_embeddable_traits<Geodesic_offset::internal::Radical_number>
  : public INTERN_RET::Real_embeddable_traits_base<Geodesic_offset::internal::Radical_number, Tag_true>
{
public:
  typedef Geodesic_offset::internal::Radical_number Type;

  struct Sgn : public CGAL::cpp98::unary_function<Type, ::CGAL::Sign>
  {
    ::CGAL::Sign operator()(const Type& x) const { return x.sign(); }
  };
  struct Is_positive : public CGAL::cpp98::unary_function<Type, bool>
  {
    bool operator()(const Type& x) const { return x.sign() == POSITIVE; }
  };
  struct Is_negative : public CGAL::cpp98::unary_function<Type, bool>
  {
    bool operator()(const Type& x) const { return x.sign() == NEGATIVE; }
  };
  struct Abs : public CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return x.sign() == NEGATIVE ? -x : x; }
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

namespace Geodesic_offset {
namespace internal {

template <>
struct Sign_decisions<Radical_number>
{
  static std::size_t exact()
  {
    const Radical_number_counts& c = Radical_number::counts();
    return std::size_t(c.zero_by_identity.value() + c.exactly_zero.value() + c.exactly_not_zero.value() +
                       c.by_high_precision.value() + c.by_root_bound.value() + c.by_core.value());
  }
  static std::size_t all()
  {
    const Radical_number_counts& c = Radical_number::counts();
    return std::size_t(c.by_identity.value() + c.by_doubles.value() + c.by_precision.value()) + exact();
  }
};

} // namespace internal
} // namespace Geodesic_offset

CGAL_DEFINE_COERCION_TRAITS_FOR_SELF(Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(short, Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(int, Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(long, Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(float, Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(double, Geodesic_offset::internal::Radical_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(Exact_rational, Geodesic_offset::internal::Radical_number)

} // namespace CGAL

#endif
