// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sums of rational multiples of square roots of positive integers, in a form in which only zero has no terms.
//
// The square roots of distinct products of pairwise coprime non-square integers are linearly independent over the
// rationals. So a sum with such radicands is zero only if it has no terms. Greatest common divisors suffice to find a
// coprime base; no integer is factored into primes.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_SUM_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_SUM_H

#include <CGAL/license/Radical_number.h>

#include <boost/multiprecision/gmp.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

// without expression templates, so that the type of each expression is its value's
typedef boost::multiprecision::number<boost::multiprecision::gmp_int, boost::multiprecision::et_off> Big_integer;
typedef boost::multiprecision::number<boost::multiprecision::gmp_rational, boost::multiprecision::et_off> Big_rational;

inline mpz_srcptr numerator_of(const Big_rational& q) { return mpq_numref(q.backend().data()); }
inline mpz_srcptr denominator_of(const Big_rational& q) { return mpq_denref(q.backend().data()); }
inline std::size_t bits_of(const Big_rational& q)
{
  return mpz_sizeinbase(numerator_of(q), 2) + mpz_sizeinbase(denominator_of(q), 2);
}

inline bool is_square(const Big_integer& n) { return mpz_perfect_square_p(n.backend().data()) != 0; }

// The square root if it is rational.
inline std::optional<Big_rational> rational_root_of(const Big_rational& q)
{
  const Big_integer over(numerator_of(q)), under(denominator_of(q));
  if (q.sign() < 0 || !is_square(over) || !is_square(under)) return std::nullopt;
  return Big_rational(boost::multiprecision::sqrt(over), boost::multiprecision::sqrt(under));
}

// Thrown when an exact computation exceeds its limits.
struct Radical_limit_exceeded
{
};

// Step budget of an exact computation.
class Radical_work
{
public:
  explicit Radical_work(std::size_t steps) : m_left(steps) {}

  void spend(std::size_t steps)
  {
    if (steps > m_left) throw Radical_limit_exceeded();
    m_left -= steps;
  }

private:
  std::size_t m_left;
};

// Moves easily found squares from n > 0 to `root`: even powers of small primes, and n itself if it is a square.
inline void split_square(Big_integer& n, Big_integer& root)
{
  root = 1;
  const std::size_t twos = mpz_scan1(n.backend().data(), 0) / 2;
  n >>= 2 * twos;
  root <<= twos;
  for (unsigned p : {3u, 5u, 7u, 11u, 13u, 17u, 19u, 23u, 29u, 31u, 37u, 41u, 43u, 47u})
    while (mpz_divisible_ui_p(n.backend().data(), p * p))
    {
      n /= p * p;
      root *= p;
    }
  if (n != 1 && is_square(n))
  {
    root *= boost::multiprecision::sqrt(n);
    n = 1;
  }
}

// factor * sqrt(radicand), times the product of the symbols whose bits are set. A symbol is a nested root; its meaning
// is known only to the Radical_field of the sum.
struct Radical_term
{
  Big_rational factor;
  Big_integer radicand;
  std::uint64_t symbols;

  friend bool operator<(const Radical_term& a, const Radical_term& b)
  {
    return a.symbols != b.symbols ? a.symbols < b.symbols : a.radicand < b.radicand;
  }
  bool is_like(const Radical_term& o) const { return symbols == o.symbols && radicand == o.radicand; }

  // Precondition: the symbols are disjoint.
  friend Radical_term operator*(const Radical_term& a, const Radical_term& b)
  {
    Radical_term t{a.factor * b.factor, 1, a.symbols ^ b.symbols};
    if (a.radicand == 1 || b.radicand == 1) t.radicand = a.radicand == 1 ? b.radicand : a.radicand;
    else
    {
      const Big_integer common = boost::multiprecision::gcd(a.radicand, b.radicand);
      t.factor *= common;
      for (const Radical_term* s : {&a, &b})
      {
        const Big_integer rest = s->radicand / common;
        if (rest == 1) continue;
        // the two rests are coprime, so their product is a square only if both are
        if (is_square(rest)) t.factor *= boost::multiprecision::sqrt(rest);
        else t.radicand *= rest;
      }
    }
    return t;
  }
};

// Pairwise coprime non-square integers whose products represent all inserted integers, up to squares.
class Coprime_base
{
public:
  explicit Coprime_base(Radical_work& work) : m_work(&work) {}

  std::size_t size() const { return m_elements.size(); }
  const Big_integer& operator[](std::size_t i) const { return m_elements[i]; }

  void insert(const Big_integer& n)
  {
    std::vector<Big_integer> pending(1, n);
    while (!pending.empty())
    {
      Big_integer x = std::move(pending.back());
      pending.pop_back();
      while (x != 1 && is_square(x)) x = boost::multiprecision::sqrt(x);
      if (x == 1) continue;
      std::size_t i = 0;
      Big_integer common;
      m_work->spend(m_elements.size());
      for (; i < m_elements.size(); ++i)
        if ((common = boost::multiprecision::gcd(x, m_elements[i])) != 1) break;
      if (i == m_elements.size()) m_elements.push_back(std::move(x));
      else
      {
        if (common != m_elements[i])
        {
          pending.push_back(m_elements[i] / common);
          pending.push_back(common);
          m_elements.erase(m_elements.begin() + std::ptrdiff_t(i));
        }
        pending.push_back(x / common);
      }
    }
  }

  // Square root of an inserted number: returns an integer, and calls `odd` with the position of each element under the
  // remaining root.
  template <class Element_visitor>
  Big_integer split(Big_integer n, Element_visitor odd) const
  {
    Big_integer root = 1;
    for (std::size_t i = 0; i < m_elements.size() && n != 1; ++i)
    {
      const mpz_srcptr e = m_elements[i].backend().data();
      const std::size_t power = mpz_remove(n.backend().data(), n.backend().data(), e);
      for (std::size_t k = 0; k < power / 2; ++k) root *= m_elements[i];
      if (power % 2 == 1) odd(i);
    }
    if (n != 1) throw std::logic_error("not a product of elements of the base");
    return root;
  }

private:
  Radical_work* m_work;
  std::vector<Big_integer> m_elements;
};

class Radical_sum
{
public:
  static constexpr std::size_t most_terms = 20000;

  Radical_sum() = default;
  Radical_sum(Big_rational q)
  {
    if (!q.is_zero()) m_terms.push_back({std::move(q), 1, 0});
  }
  explicit Radical_sum(Radical_term t)
  {
    if (!t.factor.is_zero()) m_terms.push_back(std::move(t));
  }
  explicit Radical_sum(std::vector<Radical_term> terms) : m_terms(std::move(terms)) { merge(); }

  static Radical_sum symbol(unsigned i) { return Radical_sum(Radical_term{1, 1, std::uint64_t(1) << i}); }

  static Radical_sum root_of(const Big_rational& q)
  {
    if (q.is_zero()) return Radical_sum();
    if (q.sign() < 0) throw std::domain_error("square root of a negative number");
    Big_integer over(numerator_of(q)), under(denominator_of(q)), over_root, under_root;
    split_square(over, over_root);
    split_square(under, under_root);
    under_root *= under;
    return Radical_sum(Radical_term{Big_rational(over_root, under_root), over * under, 0});
  }

  const std::vector<Radical_term>& terms() const { return m_terms; }
  std::size_t size() const { return m_terms.size(); }

  // An empty sum is zero. After reduce(), the converse holds for sums without symbols.
  bool is_empty() const { return m_terms.empty(); }
  bool is_rational() const { return is_empty() || (size() == 1 && m_terms[0].radicand == 1 && m_terms[0].symbols == 0); }
  bool is_one() const { return size() == 1 && is_rational() && m_terms[0].factor == 1; }
  Big_rational rational() const { return is_empty() ? Big_rational(0) : m_terms[0].factor; }

  std::uint64_t symbols() const
  {
    std::uint64_t all = 0;
    for (const Radical_term& t : m_terms) all |= t.symbols;
    return all;
  }

  friend bool operator==(const Radical_sum& a, const Radical_sum& b)
  {
    return std::equal(a.m_terms.begin(), a.m_terms.end(), b.m_terms.begin(), b.m_terms.end(),
                      [](const Radical_term& s, const Radical_term& t) { return s.is_like(t) && s.factor == t.factor; });
  }

  void negate()
  {
    for (Radical_term& t : m_terms) t.factor = -t.factor;
  }
  void scale(const Big_rational& q)
  {
    for (Radical_term& t : m_terms) t.factor *= q;
  }
  friend Radical_sum operator+(const Radical_sum& a, const Radical_sum& b)
  {
    Radical_sum sum;
    sum.m_terms.reserve(a.size() + b.size());
    std::merge(a.m_terms.begin(), a.m_terms.end(), b.m_terms.begin(), b.m_terms.end(), std::back_inserter(sum.m_terms));
    sum.add_like_terms();
    return sum;
  }
  friend Radical_sum operator-(const Radical_sum& a, Radical_sum b)
  {
    b.negate();
    return a + b;
  }

  // The positive rational whose division leaves coprime integer factors. Precondition: the sum is not empty.
  Big_rational content() const
  {
    Big_integer over = 0, under = 1;
    for (const Radical_term& t : m_terms)
    {
      over = boost::multiprecision::gcd(over, Big_integer(numerator_of(t.factor)));
      under = boost::multiprecision::lcm(under, Big_integer(denominator_of(t.factor)));
    }
    return Big_rational(over, under);
  }

  void insert_radicands(Coprime_base& base) const
  {
    const Big_integer* last = nullptr;
    for (const Radical_term& t : m_terms)
    {
      if (t.radicand != 1 && !(last && *last == t.radicand)) base.insert(t.radicand);
      last = &t.radicand;
    }
  }

  // Writes all radicands as products of distinct elements of a coprime base.
  void reduce(Radical_work& work)
  {
    const auto differs = [this](const Radical_term& t) { return t.radicand != m_terms[0].radicand; };
    if (std::none_of(m_terms.begin(), m_terms.end(), differs)) return;
    Coprime_base base(work);
    insert_radicands(base);
    work.spend(size() * base.size());
    for (Radical_term& t : m_terms)
    {
      Big_integer rest = 1;
      t.factor *= base.split(t.radicand, [&](std::size_t i) { rest *= base[i]; });
      t.radicand = std::move(rest);
    }
    merge();
  }

private:
  void merge()
  {
    std::sort(m_terms.begin(), m_terms.end());
    add_like_terms();
  }
  void add_like_terms()
  {
    std::size_t n = 0;
    for (std::size_t i = 0; i < m_terms.size();)
    {
      Radical_term t = std::move(m_terms[i]);
      for (++i; i < m_terms.size() && m_terms[i].is_like(t); ++i) t.factor += m_terms[i].factor;
      if (!t.factor.is_zero()) m_terms[n++] = std::move(t);
    }
    m_terms.resize(n);
    if (n > most_terms) throw Radical_limit_exceeded();
  }

  std::vector<Radical_term> m_terms; // sorted, no two alike, no factor zero
};

} // namespace CGAL::Radical_numbers::internal

#endif
