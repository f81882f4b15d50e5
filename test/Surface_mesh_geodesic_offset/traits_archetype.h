// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Model of SurfaceMeshGeodesicOffsetTraits with exactly the requirements of the concept, and a number type with exactly those of
// FT: code that compiles with it has no other requirements.

#ifndef GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H
#define GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H

#include <CGAL/Algebraic_structure_traits.h>
#include <CGAL/Coercion_traits.h>
#include <CGAL/Real_embeddable_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/enum.h>
#include <CGAL/number_type_basic.h>
#include <CGAL/tags.h>

#include <boost/operators.hpp>

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>
#include <utility>

namespace test {

/// A `double` without its conversions. With `is_exact_`, only for the compiler.
template <bool is_exact_ = false>
class Number_archetype : boost::field_operators<Number_archetype<is_exact_>>
{
public:
  static constexpr bool is_exact = is_exact_;

  Number_archetype() = default;
  template <class Int, class = std::enable_if_t<std::is_same<Int, int>::value>> // no double becomes an int
  Number_archetype(Int x) : value_(x)
  {
  }
  explicit Number_archetype(double x) : value_(x) {}

  Number_archetype& operator+=(const Number_archetype& x) { return set(value_ + x.value_); }
  Number_archetype& operator-=(const Number_archetype& x) { return set(value_ - x.value_); }
  Number_archetype& operator*=(const Number_archetype& x) { return set(value_ * x.value_); }
  Number_archetype& operator/=(const Number_archetype& x) { return set(value_ / x.value_); }
  Number_archetype operator+() const { return *this; }
  Number_archetype operator-() const { return Number_archetype(-value_); }
  friend bool operator==(const Number_archetype& x, const Number_archetype& y) { return x.value_ == y.value_; }
  friend bool operator!=(const Number_archetype& x, const Number_archetype& y) { return x.value_ != y.value_; }
  friend bool operator<(const Number_archetype& x, const Number_archetype& y) { return x.value_ < y.value_; }
  friend bool operator>(const Number_archetype& x, const Number_archetype& y) { return x.value_ > y.value_; }
  friend bool operator<=(const Number_archetype& x, const Number_archetype& y) { return x.value_ <= y.value_; }
  friend bool operator>=(const Number_archetype& x, const Number_archetype& y) { return x.value_ >= y.value_; }
  friend bool operator<(const Number_archetype& x, double y) { return x.value_ < y; }
  friend bool operator>(const Number_archetype& x, double y) { return x.value_ > y; }
  friend bool operator<=(const Number_archetype& x, double y) { return x.value_ <= y; }
  friend bool operator>=(const Number_archetype& x, double y) { return x.value_ >= y; }
  friend bool operator<(double x, const Number_archetype& y) { return x < y.value_; }
  friend bool operator>(double x, const Number_archetype& y) { return x > y.value_; }
  friend bool operator<=(double x, const Number_archetype& y) { return x <= y.value_; }
  friend bool operator>=(double x, const Number_archetype& y) { return x >= y.value_; }

private:
  friend class CGAL::Real_embeddable_traits<Number_archetype>;
  friend class CGAL::Algebraic_structure_traits<Number_archetype>;

  Number_archetype& set(double x)
  {
    value_ = x;
    return *this;
  }

  double value_ = 0;
};

} // namespace test

namespace CGAL {

template <bool is_exact>
class Algebraic_structure_traits<test::Number_archetype<is_exact>>
  : public Algebraic_structure_traits_base<test::Number_archetype<is_exact>, Field_with_sqrt_tag>
{
  typedef test::Number_archetype<is_exact> Number;

public:
  typedef Boolean_tag<is_exact> Is_exact;
  typedef Tag_true Is_numerical_sensitive;

  struct Sqrt
  {
    typedef Number argument_type;
    typedef Number result_type;
    Number operator()(const Number& x) const { return Number(std::sqrt(x.value_)); }
  };
};

template <bool is_exact>
class Real_embeddable_traits<test::Number_archetype<is_exact>>
  : public INTERN_RET::Real_embeddable_traits_base<test::Number_archetype<is_exact>, Tag_true>
{
  typedef test::Number_archetype<is_exact> Number;

public:
  struct To_double
  {
    typedef Number argument_type;
    typedef double result_type;
    double operator()(const Number& x) const { return x.value_; }
  };

  struct To_interval
  {
    typedef Number argument_type;
    typedef std::pair<double, double> result_type;
    std::pair<double, double> operator()(const Number& x) const { return {x.value_, x.value_}; }
  };
};

CGAL_DEFINE_COERCION_TRAITS_FROM_TO_TEM(int, test::Number_archetype<is_exact>, bool is_exact)

template <bool is_exact>
struct Coercion_traits<test::Number_archetype<is_exact>, double>
{
  typedef Tag_true Are_explicit_interoperable;
  typedef Tag_false Are_implicit_interoperable;
  typedef test::Number_archetype<is_exact> Type;

  struct Cast
  {
    typedef Type result_type;
    Type operator()(const Type& x) const { return x; }
    Type operator()(double x) const { return Type(x); }
  };
};

template <bool is_exact>
struct Coercion_traits<double, test::Number_archetype<is_exact>> : Coercion_traits<test::Number_archetype<is_exact>, double>
{
};

} // namespace CGAL

namespace std {

// Exact numbers have no limits.
template <>
class numeric_limits<test::Number_archetype<false>> : public numeric_limits<double>
{
public:
  static test::Number_archetype<false> epsilon() { return test::Number_archetype<false>(numeric_limits<double>::epsilon()); }
  static test::Number_archetype<false> infinity() { return test::Number_archetype<false>(numeric_limits<double>::infinity()); }
};

} // namespace std

namespace test {

/// Functors with a state that counts calls, to test that the object's own functors are used.
template <class TriangleMesh, bool is_exact = false>
class Traits_archetype
{
public:
  typedef CGAL::Simple_cartesian<Number_archetype<is_exact>> Kernel;
  typedef TriangleMesh Triangle_mesh;
  typedef Number_archetype<is_exact> FT;
  typedef typename Kernel::Point_3 Point_3;
  typedef typename Kernel::Vector_3 Vector_3;

  struct Apex_2
  {
    FT length, x, y;
  };

  struct Image_2
  {
    FT x, y, sigma;
  };

  struct Calls
  {
    std::size_t apices = 0, frames = 0, entries = 0, distances = 0, comparisons = 0;
  };

private:
  // Functors can be copied, but have no default constructor and no assignment.
  class Functor
  {
  public:
    Functor(const Functor&) = default;
    Functor& operator=(const Functor&) = delete;

  protected:
    explicit Functor(Calls& calls) : calls_(calls) {}
    Calls& calls_;
  };

public:
  explicit Traits_archetype(Calls& calls) : calls_(&calls) {}

  class Construct_apices_2 : public Functor
  {
  public:
    std::array<Apex_2, 3> operator()(Point_3 p, Point_3 q, Point_3 r) const
    {
      ++this->calls_.apices;
      return {{apex(p, q, r), apex(q, r, p), apex(r, p, q)}};
    }

  private:
    friend class Traits_archetype;
    using Functor::Functor;

    static Apex_2 apex(const Point_3& p, const Point_3& q, const Point_3& r)
    {
      const Vector_3 u = q - p, v = r - p;
      const FT length = CGAL::sqrt(u.squared_length());
      return {length, u * v / length, CGAL::sqrt(CGAL::cross_product(u, v).squared_length()) / length};
    }
  };

  class Change_frame_2 : public Functor
  {
  public:
    Image_2 operator()(FT x, FT y, FT sigma, bool is_parallel, FT ox, FT oy, FT c, FT s) const
    {
      ++this->calls_.frames;
      if (is_parallel) return {c * x + s * y, c * y - s * x, sigma - x * ox - y * oy};
      return {c * (x - ox) + s * (y - oy), c * (y - oy) - s * (x - ox), sigma};
    }

  private:
    friend class Traits_archetype;
    using Functor::Functor;
  };

  class Compare_entry_with_apex_2 : public Functor
  {
  public:
    CGAL::Sign operator()(FT x, FT y, bool is_parallel, FT b, FT ax, FT ay) const
    {
      ++this->calls_.entries;
      return CGAL::sign(FT(b * (is_parallel ? -y : ay - y) - (x * ay - y * ax)));
    }

  private:
    friend class Traits_archetype;
    using Functor::Functor;
  };

  class Compute_distance_2 : public Functor
  {
  public:
    FT operator()(FT x, FT y, FT sigma, bool is_parallel, FT px, FT py) const
    {
      ++this->calls_.distances;
      if (is_parallel) return sigma - (x * px + y * py);
      return sigma + CGAL::sqrt(FT((px - x) * (px - x) + (py - y) * (py - y)));
    }

  private:
    friend class Traits_archetype;
    using Functor::Functor;
  };

  class Compare_distance_2 : public Functor
  {
  public:
    CGAL::Comparison_result operator()(FT d, FT e, FT scale) const
    {
      ++this->calls_.comparisons;
      const FT difference = d - e, allowance = FT(1e-15) * scale;
      return difference > allowance ? CGAL::LARGER : difference < -allowance ? CGAL::SMALLER : CGAL::EQUAL;
    }

  private:
    friend class Traits_archetype;
    using Functor::Functor;
  };

  Construct_apices_2 construct_apices_2_object() const { return Construct_apices_2(*calls_); }
  Change_frame_2 change_frame_2_object() const { return Change_frame_2(*calls_); }
  Compare_entry_with_apex_2 compare_entry_with_apex_2_object() const { return Compare_entry_with_apex_2(*calls_); }
  Compute_distance_2 compute_distance_2_object() const { return Compute_distance_2(*calls_); }
  Compare_distance_2 compare_distance_2_object() const { return Compare_distance_2(*calls_); }

private:
  Calls* calls_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_TRAITS_ARCHETYPE_H
