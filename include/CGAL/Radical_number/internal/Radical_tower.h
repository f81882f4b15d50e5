// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tower of quadratic field extensions of the rationals: each step adjoins a square root that the field before does not
// have. Computes inverses and recognizes squares.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_TOWER_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_TOWER_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Radical_sum.h>

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

class Radical_tower
{
public:
  // Coefficients of the products of adjoined roots: bit i of the position stands for root i. The length is 2^k for an
  // element of the field with the first k roots.
  typedef std::vector<Big_rational> Element;

  explicit Radical_tower(Radical_work& work) : m_work(&work) {}

  std::size_t levels() const { return m_squares.size(); }
  std::size_t degree() const { return std::size_t(1) << levels(); }

  // Adjoins the square root of an element that has none in the field. Integers must be adjoined before all other
  // elements.
  void adjoin_root_of(const Big_integer& n)
  {
    Element square(degree());
    square[0] = n;
    m_squares.push_back(std::move(square));
    m_integers.push_back(n);
  }
  void adjoin_root_of(Element square)
  {
    square.resize(degree());
    m_squares.push_back(std::move(square));
  }

  static bool is_zero(const Element& a)
  {
    return std::all_of(a.begin(), a.end(), [](const Big_rational& c) { return c.is_zero(); });
  }

  Element product(const Element& a, const Element& b) const
  {
    m_work->spend(a.size());
    if (a.size() == 1) return Element(1, a[0] * b[0]);
    if (is_zero(a) || is_zero(b)) return Element(a.size());
    const Element a0 = low(a), a1 = high(a), b0 = low(b), b1 = high(b);
    return joined(sum(product(a0, b0), product(square_of_top(a), product(a1, b1))), sum(product(a0, b1), product(a1, b0)));
  }

  // Precondition: a is not zero.
  Element inverse(const Element& a) const
  {
    if (a.size() == 1) return Element(1, 1 / a[0]);
    const Element a0 = low(a), a1 = high(a);
    if (is_zero(a1)) return joined(inverse(a0), a1);
    const Element scale = inverse(norm(a, a0, a1));
    return joined(product(a0, scale), product(scaled(a1, -1), scale));
  }

  // Finds a = q b^2 with rational q, if possible. For a > 0 it is possible if and only if sqrt(a) is in the field F(R)
  // that also contains the square roots R of all other rationals: F(R) results from this field by adjoining roots of
  // rationals, so it contains no quadratic extensions except those by such roots.
  std::optional<std::pair<Big_rational, Element>> rational_times_square(const Element& a) const
  {
    if (a.size() == 1) return std::make_pair(a[0], Element(1, 1));
    const Element a0 = low(a), a1 = high(a), none(a0.size());
    if (is_zero(a1))
    {
      // a = q x^2, or a = q y^2 s with the square s of the top root; an integer s can be part of q
      if (auto r = rational_times_square(a0)) return std::make_pair(r->first, joined(r->second, none));
      const Element s = square_of_top(a);
      if (a.size() <= std::size_t(1) << m_integers.size()) return std::nullopt;
      if (auto r = rational_times_square(product(a0, s)))
        return std::make_pair(r->first, joined(none, product(r->second, inverse(s))));
      return std::nullopt;
    }
    // a = q (x + y root)^2, so the norm of a is d^2 with d = q (x^2 - s y^2), and q x^2 = (a0 + d) / 2
    const auto d = root(norm(a, a0, a1));
    if (!d) return std::nullopt;
    for (int sign : {1, -1})
    {
      const Element x2 = scaled(sum(a0, scaled(*d, sign)), Big_rational(1, 2));
      if (is_zero(x2)) continue;
      if (const auto x = rational_times_square(x2))
        return std::make_pair(x->first, joined(x->second, product(a1, inverse(scaled(x->second, 2 * x->first)))));
    }
    return std::nullopt;
  }

private:
  static Element low(const Element& a) { return Element(a.begin(), a.begin() + std::ptrdiff_t(a.size() / 2)); }
  static Element high(const Element& a) { return Element(a.begin() + std::ptrdiff_t(a.size() / 2), a.end()); }
  static Element joined(Element a, const Element& b)
  {
    a.insert(a.end(), b.begin(), b.end());
    return a;
  }
  static Element sum(Element a, const Element& b)
  {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += b[i];
    return a;
  }
  static Element scaled(Element a, const Big_rational& q)
  {
    for (Big_rational& c : a) c *= q;
    return a;
  }

  // Square of the last root that elements of this length contain.
  const Element& square_of_top(const Element& a) const
  {
    std::size_t level = 0;
    while (std::size_t(2) << level < a.size()) ++level;
    return m_squares[level];
  }
  Element norm(const Element& a, const Element& a0, const Element& a1) const
  {
    return sum(product(a0, a0), scaled(product(square_of_top(a), product(a1, a1)), -1));
  }

  // Square root within the field of elements of this length.
  std::optional<Element> root(const Element& a) const
  {
    const auto r = rational_times_square(a);
    if (!r) return std::nullopt;
    // a rational is a square in the field if its product with some of the adjoined integers is a rational square
    for (std::size_t set = 0; set < a.size() && set < std::size_t(1) << m_integers.size(); ++set)
    {
      m_work->spend(1);
      Big_integer chosen = 1;
      for (std::size_t i = 0; i < m_integers.size(); ++i)
        if (set >> i & 1) chosen *= m_integers[i];
      const auto root_of_product = rational_root_of(r->first * chosen);
      if (!root_of_product) continue;
      Element root_of_rational(a.size());
      root_of_rational[set] = *root_of_product / chosen;
      return product(root_of_rational, r->second);
    }
    return std::nullopt;
  }

  Radical_work* m_work;
  std::vector<Element> m_squares;
  std::vector<Big_integer> m_integers;
};

} // namespace CGAL::Radical_numbers::internal

#endif
