// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A floating point number type with twice the digits of double.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_EXTENDED_NUMBER_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_NUMBERS_EXTENDED_NUMBER_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Double_double.h>

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Coercion_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/number_utils.h>

#include <boost/config.hpp>

#include <cmath>
#include <limits>
#include <utility>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// A Double_double as a model of FieldWithSqrt, with infinity. Relative errors of operations are at most 2^-103: 8 units of
// 2^-106 (Double_double.h). They are out of line: inlined into the front, they would double the time to compile it.
class Extended_number
{
public:
  Extended_number() = default;
  Extended_number(double x) : m_value(x) {}

  double high() const { return m_value.high; }
  double low() const { return m_value.low; }

  Extended_number operator-() const { return Extended_number(-m_value); }
  Extended_number operator+() const { return *this; }

  BOOST_NOINLINE Extended_number& operator+=(const Extended_number& o)
  {
    const double sum = high() + o.high();
    return set(sum, m_value + o.m_value);
  }
  Extended_number& operator-=(const Extended_number& o) { return *this += -o; }
  BOOST_NOINLINE Extended_number& operator*=(const Extended_number& o)
  {
    const double product = high() * o.high();
    return set(product, m_value * o.m_value);
  }
  BOOST_NOINLINE Extended_number& operator/=(const Extended_number& o)
  {
    const double quotient = high() / o.high();
    return o.is_finite() ? set(quotient, m_value / o.m_value) : set(quotient, quotient);
  }

  BOOST_NOINLINE Extended_number square_root() const
  {
    return is_finite() ? Extended_number(internal::square_root(m_value)) : *this;
  }

  friend Extended_number operator+(Extended_number a, const Extended_number& b) { return a += b; }
  friend Extended_number operator-(Extended_number a, const Extended_number& b) { return a -= b; }
  friend Extended_number operator*(Extended_number a, const Extended_number& b) { return a *= b; }
  friend Extended_number operator/(Extended_number a, const Extended_number& b) { return a /= b; }

  friend bool operator==(const Extended_number& a, const Extended_number& b)
  {
    return a.high() == b.high() && a.low() == b.low();
  }
  friend bool operator!=(const Extended_number& a, const Extended_number& b) { return !(a == b); }
  friend bool operator<(const Extended_number& a, const Extended_number& b)
  {
    return a.high() < b.high() || (a.high() == b.high() && a.low() < b.low());
  }
  friend bool operator>(const Extended_number& a, const Extended_number& b) { return b < a; }
  friend bool operator<=(const Extended_number& a, const Extended_number& b)
  {
    return a.high() < b.high() || (a.high() == b.high() && a.low() <= b.low());
  }
  friend bool operator>=(const Extended_number& a, const Extended_number& b) { return b <= a; }

private:
  explicit Extended_number(const Double_double& x) : m_value(x) {}

  bool is_finite() const { return std::abs(high()) <= (std::numeric_limits<double>::max)(); }

  // `rounded`: the result in double. If it is not finite, the error terms of `x` have no value.
  Extended_number& set(double rounded, const Double_double& x)
  {
    m_value = std::abs(rounded) <= (std::numeric_limits<double>::max)() ? x : Double_double(rounded);
    return *this;
  }

  Double_double m_value;
};

} // namespace internal
} // namespace Geodesic_offset

template <>
class Algebraic_structure_traits<Geodesic_offset::internal::Extended_number>
  : public Algebraic_structure_traits_base<Geodesic_offset::internal::Extended_number, Field_with_sqrt_tag>
{
public:
  typedef Geodesic_offset::internal::Extended_number Type;
  typedef Tag_false Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Sqrt : public CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return x.square_root(); }
  };
};

template <>
class Real_embeddable_traits<Geodesic_offset::internal::Extended_number>
  : public INTERN_RET::Real_embeddable_traits_base<Geodesic_offset::internal::Extended_number, Tag_true>
{
public:
  typedef Geodesic_offset::internal::Extended_number Type;

  struct Sgn : public CGAL::cpp98::unary_function<Type, ::CGAL::Sign>
  {
    ::CGAL::Sign operator()(const Type& x) const { return x.high() > 0 ? POSITIVE : x.high() < 0 ? NEGATIVE : ZERO; }
  };
  struct Abs : public CGAL::cpp98::unary_function<Type, Type>
  {
    Type operator()(const Type& x) const { return x.high() < 0 ? -x : x; }
  };
  struct To_double : public CGAL::cpp98::unary_function<Type, double>
  {
    double operator()(const Type& x) const { return x.high(); }
  };
  struct To_interval : public CGAL::cpp98::unary_function<Type, std::pair<double, double>>
  {
    std::pair<double, double> operator()(const Type& x) const
    {
      constexpr double infinity = std::numeric_limits<double>::infinity();
      return {x.low() < 0 ? std::nextafter(x.high(), -infinity) : x.high(),
              x.low() > 0 ? std::nextafter(x.high(), infinity) : x.high()};
    }
  };
};

CGAL_DEFINE_COERCION_TRAITS_FOR_SELF(Geodesic_offset::internal::Extended_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(int, Geodesic_offset::internal::Extended_number)
CGAL_DEFINE_COERCION_TRAITS_FROM_TO(double, Geodesic_offset::internal::Extended_number)

} // namespace CGAL

namespace std {

template <>
class numeric_limits<CGAL::Geodesic_offset::internal::Extended_number>
{
  typedef CGAL::Geodesic_offset::internal::Extended_number Number;

public:
  static constexpr bool is_specialized = true, is_signed = true, is_integer = false, is_exact = false, has_infinity = true;
  static Number infinity() { return numeric_limits<double>::infinity(); }
  // At least the error of an operation.
  static Number epsilon() { return 0x1p-103; }
};

} // namespace std

#endif
