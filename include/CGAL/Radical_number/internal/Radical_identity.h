// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Proofs that an expression is zero by its structure, whatever the values of its parts.
//
// Most expressions that are zero are identities of a few quantities: the end of an arc lies on the arc, and two circles
// have the same intersections in either order. These quantities may be large expressions themselves. The expression is
// expanded to a given number of operations below the top; each subexpression below that depth is an indeterminate, and
// alike subexpressions are one indeterminate. Above it, a value is a quotient of polynomials, and a square root is an
// indeterminate with a known square. The expression is zero if its numerator is the zero polynomial. The depth
// increases until a proof is found or the polynomials get too large.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_IDENTITY_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_IDENTITY_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Radical_expression.h>
#include <CGAL/Radical_number/internal/Radical_sum.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

// True if two expressions apply the same operations to the same constants, as those of a number that is computed twice
// in the same way.
class Radical_likeness
{
public:
  bool are_alike(const Radical_node& a, const Radical_node& b) { return are_alike(a, b, 0); }

private:
  static constexpr std::size_t most_levels = 1000; // of recursion
  static constexpr std::size_t most_pairs = 1 << 14;

  bool are_alike(const Radical_node& a, const Radical_node& b, std::size_t level)
  {
    if (&a == &b) return true;
    if (!a.interval().do_overlap(b.interval()) || a.operation() != b.operation()) return false;
    if (a.rational()) return *a.rational() == *b.rational();
    if (!a.operand(0) || level == most_levels || m_known.size() == most_pairs) return false;
    const auto known = m_known.emplace(std::make_pair(&a, &b), false);
    if (!known.second) return known.first->second;
    for (int i = 0; i < 2 && a.operand(i); ++i)
      if (!are_alike(*a.operand(i), *b.operand(i), level + 1)) return false;
    return m_known[{&a, &b}] = true;
  }

  std::map<std::pair<const Radical_node*, const Radical_node*>, bool> m_known; // false while the comparison is in progress
};

// Polynomial in indeterminates with rational coefficients.
class Radical_polynomial
{
public:
  static constexpr std::size_t most_indeterminates = 32;
  typedef std::array<std::uint8_t, most_indeterminates> Exponents;

  Radical_polynomial() = default;
  explicit Radical_polynomial(const Big_rational& c)
  {
    if (!c.is_zero()) m_terms.emplace(Exponents{}, c);
  }
  static Radical_polynomial indeterminate(std::size_t i)
  {
    Exponents e{};
    e[i] = 1;
    Radical_polynomial p;
    p.m_terms.emplace(e, 1);
    return p;
  }

  bool is_zero() const { return m_terms.empty(); }
  unsigned degree(std::size_t i) const
  {
    std::uint8_t d = 0;
    for (const auto& t : m_terms) d = (std::max)(d, t.first[i]);
    return d;
  }

  Radical_polynomial negative() const
  {
    Radical_polynomial p(*this);
    for (auto& t : p.m_terms) t.second = -t.second;
    return p;
  }

  friend bool operator==(const Radical_polynomial& a, const Radical_polynomial& b) { return a.m_terms == b.m_terms; }

  static Radical_polynomial sum(Radical_polynomial a, const Radical_polynomial& b, Radical_work& work)
  {
    work.spend(b.m_terms.size());
    for (const auto& t : b.m_terms) a.add(t.first, t.second);
    return a;
  }

  static Radical_polynomial product(const Radical_polynomial& a, const Radical_polynomial& b, Radical_work& work)
  {
    work.spend(a.m_terms.size() * b.m_terms.size());
    Radical_polynomial p;
    for (const auto& s : a.m_terms)
      for (const auto& t : b.m_terms)
      {
        Exponents e = s.first;
        for (std::size_t i = 0; i < most_indeterminates; ++i)
        {
          if (e[i] + t.first[i] > most_degree) throw Radical_limit_exceeded();
          e[i] = std::uint8_t(e[i] + t.first[i]);
        }
        p.add(e, s.second * t.second);
      }
    return p;
  }

  // Substitutes over / under for the square of indeterminate i, and multiplies by the power of `under` that clears
  // denominators.
  Radical_polynomial with_square(std::size_t i, const Radical_polynomial& over, const Radical_polynomial& under,
                                 Radical_work& work) const
  {
    const unsigned squares = degree(i) / 2;
    if (squares == 0) return *this;
    std::vector<Radical_polynomial> parts(squares + 1); // indexed by the exponent of the square
    for (const auto& t : m_terms)
    {
      Exponents e = t.first;
      e[i] %= 2;
      parts[t.first[i] / 2].m_terms.emplace(e, t.second);
    }
    Radical_polynomial p = std::move(parts[squares]), power_of_under{Big_rational(1)};
    for (unsigned k = squares; k-- > 0;)
    {
      power_of_under = product(power_of_under, under, work);
      p = sum(product(p, over, work), product(parts[k], power_of_under, work), work);
    }
    return p;
  }

private:
  static constexpr unsigned most_degree = 255;

  void add(const Exponents& e, const Big_rational& c)
  {
    const auto t = m_terms.emplace(e, c);
    if (t.second) return;
    t.first->second += c;
    if (t.first->second.is_zero()) m_terms.erase(t.first);
  }

  std::map<Exponents, Big_rational> m_terms; // no coefficient is zero
};

class Radical_identity
{
public:
  // Returns true only if the number is zero. An unsuccessful search takes at most `most_depth` times `most_steps`
  // products of two terms.
  static bool proves_zero(const Radical_node& top)
  {
    for (std::size_t depth = 1; depth <= most_depth; ++depth)
    {
      Radical_identity identity;
      try
      {
        if (identity.vanishes(top, depth)) return true;
      }
      catch (const Radical_limit_exceeded&)
      { // a greater depth may need fewer indeterminates
      }
      if (identity.m_is_complete) return false;
    }
    return false;
  }

  struct Quotient
  {
    Radical_polynomial over, under;
  };

  // The arithmetic of quotients
  Quotient negative(const Quotient& a) { return {a.over.negative(), a.under}; }
  Quotient sum(const Quotient& a, const Quotient& b)
  {
    if (a.under == b.under) return {Radical_polynomial::sum(a.over, b.over, m_work), a.under};
    return {Radical_polynomial::sum(product(a.over, b.under), product(b.over, a.under), m_work), product(a.under, b.under)};
  }
  Quotient difference(const Quotient& a, const Quotient& b) { return sum(a, negative(b)); }
  Quotient product(const Quotient& a, const Quotient& b) { return {product(a.over, b.over), product(a.under, b.under)}; }
  Quotient quotient(const Quotient& a, const Quotient& b) { return product(a, {b.under, b.over}); }
  Quotient square_root(const Quotient& a)
  {
    return indeterminate([&](const Indeterminate& i) { return !i.node && is_zero(difference(a, i.square).over); },
                         {nullptr, a});
  }

private:
  static constexpr std::size_t most_steps = std::size_t(1) << 15;
  static constexpr std::size_t most_depth = 24;
  static constexpr std::size_t most_bits_of_coefficient = 512; // larger constants become indeterminates

  struct Indeterminate
  {
    const Radical_node* node; // null for a square root
    Quotient square;          // for a square root
  };

  Radical_identity() : m_work(most_steps) {}

  bool vanishes(const Radical_node& top, std::size_t depth)
  {
    // A node is expanded if every path from the top to it has fewer than `depth` operations. Users precede their
    // operands.
    typedef std::pair<std::size_t, const Radical_node*> Entry; // depth of the node, node
    std::map<Entry, std::size_t, std::greater<Entry>> pending; // longest path from the top, in operations
    std::vector<const Radical_node*> expanded;
    pending.emplace(Entry(top.depth(), &top), 0);
    m_is_complete = true;
    while (!pending.empty())
    {
      const Radical_node& n = *pending.begin()->first.second;
      const std::size_t operations = pending.begin()->second;
      pending.erase(pending.begin());
      if (!n.operand(0)) continue;
      if (operations >= depth)
      {
        m_is_complete = false;
        continue;
      }
      expanded.push_back(&n);
      for (int i = 0; i < 2 && n.operand(i); ++i)
      {
        const Radical_node* o = n.operand(i).get();
        std::size_t& known = pending.emplace(Entry(o->depth(), o), 0).first->second;
        known = (std::max)(known, operations + 1);
      }
    }
    std::reverse(expanded.begin(), expanded.end());
    for (const Radical_node* n : expanded)
      m_values.emplace(n, apply(n->operation(), *this, [&](int i) { return value(*n->operand(i)); }));
    return !expanded.empty() && is_zero(m_values.at(&top).over);
  }

  Quotient value(const Radical_node& n)
  {
    const auto known = m_values.find(&n);
    if (known != m_values.end()) return known->second;
    if (n.rational() && bits_of(*n.rational()) <= most_bits_of_coefficient)
      return {Radical_polynomial(*n.rational()), Radical_polynomial(1)};
    return indeterminate([&](const Indeterminate& i) { return i.node && m_likeness.are_alike(*i.node, n); }, {&n, {}});
  }

  // The known indeterminate that `is_wanted`, or else a new one.
  template <class Is_wanted>
  Quotient indeterminate(const Is_wanted& is_wanted, Indeterminate otherwise)
  {
    const auto known = std::find_if(m_indeterminates.begin(), m_indeterminates.end(), is_wanted);
    const std::size_t position = std::size_t(known - m_indeterminates.begin());
    if (known == m_indeterminates.end())
    {
      if (position == Radical_polynomial::most_indeterminates) throw Radical_limit_exceeded();
      m_indeterminates.push_back(std::move(otherwise));
    }
    return {Radical_polynomial::indeterminate(position), Radical_polynomial(1)};
  }

  // No denominator in an expression is zero, so multiplying by the denominator of a square preserves zeros.
  bool is_zero(Radical_polynomial p)
  {
    for (std::size_t i = m_indeterminates.size(); i-- > 0 && !p.is_zero();)
      if (!m_indeterminates[i].node)
        p = p.with_square(i, m_indeterminates[i].square.over, m_indeterminates[i].square.under, m_work);
    return p.is_zero();
  }

  Radical_polynomial product(const Radical_polynomial& a, const Radical_polynomial& b)
  {
    return Radical_polynomial::product(a, b, m_work);
  }

  Radical_work m_work;
  Radical_likeness m_likeness;
  bool m_is_complete = false; // all operations are expanded
  std::unordered_map<const Radical_node*, Quotient> m_values;
  std::vector<Indeterminate> m_indeterminates; // a square root comes after the indeterminates in its square
};

} // namespace CGAL::Radical_numbers::internal

#endif
