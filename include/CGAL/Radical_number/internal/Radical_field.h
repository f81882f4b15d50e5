// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Exact arithmetic of one evaluation: quotients of sums of square roots of rationals, and of symbols for nested roots.
//
// A nested root becomes a new symbol only if the existing symbols are not known to generate it. Symbols are independent
// if no product of them is proved to be a sum of roots of rationals; a sum of independent symbols is zero only if all
// its coefficients are. Other symbols can prove that a sum is zero, but not that it is nonzero.

#ifndef CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_FIELD_H
#define CGAL_RADICAL_NUMBER_INTERNAL_RADICAL_FIELD_H

#include <CGAL/license/Radical_number.h>

#include <CGAL/Radical_number/internal/Multiprecision_interval.h>
#include <CGAL/Radical_number/internal/Radical_sum.h>
#include <CGAL/Radical_number/internal/Radical_tower.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

namespace CGAL::Radical_numbers::internal {

// Quotient with nonzero denominator.
struct Radical_quotient
{
  Radical_sum numerator, denominator = Radical_sum(1);

  bool is_sum() const { return denominator.is_one(); }
  bool has_symbols() const { return (numerator.symbols() | denominator.symbols()) != 0; }
};

enum class Vanishing { ZERO, NOT_ZERO, UNKNOWN };

class Radical_field
{
public:
  explicit Radical_field(std::size_t steps) : m_steps_for_square((std::min)(steps, most_steps_for_square)), m_work(steps) {}

  Radical_quotient sum(const Radical_quotient& a, const Radical_quotient& b)
  {
    m_work.spend(a.numerator.size() + b.numerator.size());
    if (a.denominator == b.denominator) return {a.numerator + b.numerator, a.denominator};
    return {product(a.numerator, b.denominator) + product(b.numerator, a.denominator), product(a.denominator, b.denominator)};
  }
  static Radical_quotient negative(Radical_quotient a)
  {
    a.numerator.negate();
    return a;
  }
  Radical_quotient difference(const Radical_quotient& a, const Radical_quotient& b) { return sum(a, negative(b)); }
  Radical_quotient product(const Radical_quotient& a, const Radical_quotient& b)
  {
    return {product(a.numerator, b.numerator), product(a.denominator, b.denominator)};
  }
  Radical_quotient quotient(const Radical_quotient& a, Radical_quotient b)
  {
    b.numerator.reduce(m_work);
    if (b.numerator.is_empty()) throw std::domain_error("division by zero");
    const Radical_sum over = product(a.numerator, b.denominator);
    if (const auto inverse = inverse_of(b.numerator)) return {product(over, *inverse), a.denominator};
    return {over, product(a.denominator, b.numerator)};
  }
  Radical_quotient square_root(const Radical_quotient& a)
  {
    if (a.is_sum()) return {square_root(a.numerator), Radical_sum(1)};
    Radical_sum under = a.denominator;
    if (sign(under) < 0) under.negate();
    return {square_root(product(a.numerator, a.denominator)), std::move(under)};
  }

  // A number known only by its value; equal `identity` means equal numbers.
  Radical_quotient unknown_number(const void* identity)
  {
    std::size_t i = 0;
    while (i < m_symbols.size() && m_symbols[i].identity != identity) ++i;
    if (i == m_symbols.size()) new_symbol({Radical_sum(), identity, false});
    return {Radical_sum::symbol(unsigned(i)), Radical_sum(1)};
  }

  Vanishing vanishing(const Radical_quotient& a)
  {
    Radical_sum s = a.numerator;
    s.reduce(m_work);
    if (s.is_empty()) return Vanishing::ZERO;
    return are_independent(s.symbols()) ? Vanishing::NOT_ZERO : Vanishing::UNKNOWN;
  }

private:
  static constexpr std::size_t most_symbols = 64;
  static constexpr std::size_t most_levels = 10; // for recognizing squares
  static constexpr std::size_t most_steps_for_square = 1 << 17;
  static constexpr std::size_t most_levels_inverted = 4; // inverses in higher fields are too long to be useful
  static constexpr std::size_t least_products_with_base = 32;
  static constexpr std::size_t most_bits = 1 << 14;

  struct Symbol
  {
    Radical_sum square;   // contains only earlier symbols
    const void* identity; // of an unknown number, whose square is not used
    bool is_independent;  // of all earlier independent symbols
  };

  // Integer factors: fractions would have to be reduced in each product of terms.
  Radical_sum product(Radical_sum a, Radical_sum b)
  {
    if (a.is_empty() || b.is_empty()) return Radical_sum();
    if (a.is_one()) return b;
    if (b.is_one()) return a;
    if (a.size() == 1 || b.size() == 1) return product_of_terms(a, b);
    const Big_rational content_of_a = a.content(), content_of_b = b.content();
    a.scale(1 / content_of_a);
    b.scale(1 / content_of_b);
    Radical_sum result = product_of_terms(a, b);
    result.scale(content_of_a * content_of_b);
    return result;
  }

  typedef std::map<std::uint64_t, std::vector<Radical_term>> Terms_by_squares; // key: the set of squared symbols

  Radical_sum product_of_terms(const Radical_sum& a, const Radical_sum& b)
  {
    m_work.spend(a.size() * b.size());
    Terms_by_squares terms;
    if (a.size() * b.size() < least_products_with_base || !multiply_with_base(a, b, terms))
      for (const Radical_term& s : a.terms())
        for (const Radical_term& t : b.terms()) terms[s.symbols & t.symbols].push_back(s * t);
    Radical_sum result;
    for (auto& part : terms)
    {
      Radical_sum p(std::move(part.second));
      for (std::size_t i = 0; i < m_symbols.size(); ++i)
        if (part.first >> i & 1)
        {
          if (m_symbols[i].identity) throw Radical_limit_exceeded();
          p = product(p, m_symbols[i].square);
        }
      result = result + p;
    }
    return result;
  }

  // Product with radicands as sets of elements of a coprime base: one greatest common divisor per term and element
  // instead of one per pair of terms, and roots that are multiples of each other are recognized. Returns false if the
  // base gets too large.
  bool multiply_with_base(const Radical_sum& a, const Radical_sum& b, Terms_by_squares& result)
  {
    Coprime_base base(m_work);
    a.insert_radicands(base);
    b.insert_radicands(base);
    if (base.size() > 64) return false;
    struct Term
    {
      Big_rational factor;
      std::uint64_t set, symbols;
    };
    const auto with_sets = [&](const Radical_sum& sum) {
      std::vector<Term> terms;
      for (const Radical_term& t : sum.terms())
      {
        std::uint64_t set = 0;
        const Big_integer root = base.split(t.radicand, [&](std::size_t i) { set |= std::uint64_t(1) << i; });
        terms.push_back({t.factor * root, set, t.symbols});
      }
      return terms;
    };
    std::map<std::uint64_t, Big_integer> products; // of the elements in a set
    const auto product_of_set = [&](std::uint64_t set) -> const Big_integer& {
      const auto p = products.emplace(set, 1);
      for (std::size_t i = 0; p.second && i < base.size(); ++i)
        if (set >> i & 1) p.first->second *= base[i];
      return p.first->second;
    };
    std::map<std::array<std::uint64_t, 3>, Big_rational> sums; // key: squared symbols, other symbols, set of elements
    const std::vector<Term> a_terms = with_sets(a), b_terms = with_sets(b);
    for (const Term& s : a_terms)
      for (const Term& t : b_terms)
        sums[{s.symbols & t.symbols, s.symbols ^ t.symbols, s.set ^ t.set}] +=
          s.factor * t.factor * product_of_set(s.set & t.set);
    for (auto& s : sums)
      if (!s.second.is_zero()) result[s.first[0]].push_back({std::move(s.second), product_of_set(s.first[2]), s.first[1]});
    return true;
  }

  bool are_independent(std::uint64_t symbols) const
  {
    for (std::size_t i = 0; i < m_symbols.size(); ++i)
      if (symbols >> i & 1 && !m_symbols[i].is_independent) return false;
    return true;
  }

  std::size_t new_symbol(Symbol s)
  {
    if (m_symbols.size() == most_symbols) throw Radical_limit_exceeded();
    m_symbols.push_back(std::move(s));
    return m_symbols.size() - 1;
  }

  Radical_sum square_root(Radical_sum a)
  {
    a.reduce(m_work);
    if (a.is_rational()) return Radical_sum::root_of(a.rational());
    const Big_rational content = a.content();
    const Radical_sum outside = Radical_sum::root_of(content);
    a.scale(1 / content);
    for (std::size_t i = 0; i < m_symbols.size(); ++i)
      if (!m_symbols[i].identity && are_equal(a, m_symbols[i].square))
        return product(outside, Radical_sum::symbol(unsigned(i)));

    bool is_independent = false;
    if (const auto r = known_root(a, is_independent)) return product(outside, *r);
    return product(outside, Radical_sum::symbol(unsigned(new_symbol({std::move(a), nullptr, is_independent}))));
  }

  // Square root of a if no new symbol is needed; otherwise sets `is_independent` to whether the need is proved.
  std::optional<Radical_sum> known_root(const Radical_sum& a, bool& is_independent)
  {
    if (!are_independent(a.symbols())) return std::nullopt;
    Radical_work work(m_steps_for_square);
    try
    {
      Presentation field(*this, work);
      if (!field.contains(a, ~std::uint64_t(0), most_levels)) return std::nullopt;
      if (const auto r = field.tower().rational_times_square(field.element(a)))
      {
        Radical_sum root = product(Radical_sum::root_of(r->first), field.sum(r->second));
        if (sign(root) < 0) root.negate();
        return root;
      }
      is_independent = true;
    }
    catch (const Radical_limit_exceeded&)
    {
    }
    return std::nullopt;
  }

  bool are_equal(const Radical_sum& a, const Radical_sum& b)
  {
    if (a.size() != b.size() || a.symbols() != b.symbols()) return false;
    Radical_sum difference = a - b;
    difference.reduce(m_work);
    return difference.is_empty();
  }

  std::optional<Radical_sum> inverse_of(const Radical_sum& a)
  {
    if (a.size() == 1 && a.symbols() == 0)
    {
      const Radical_term& t = a.terms()[0];
      return Radical_sum(Radical_term{1 / (t.factor * t.radicand), t.radicand, 0});
    }
    Presentation field(*this, m_work);
    if (!are_independent(a.symbols()) || !field.contains(a, a.symbols(), most_levels_inverted)) return std::nullopt;
    return field.sum(field.tower().inverse(field.element(a)));
  }

  // Tower of fields that contains all terms of a sum: first the roots of a coprime base, then symbols.
  class Presentation
  {
  public:
    Presentation(const Radical_field& field, Radical_work& work) : m_field(&field), m_base(work), m_tower(work) {}

    // Builds the tower, with the independent symbols in `wanted` and the symbols in their squares. Returns false if it
    // would have more than `levels` levels.
    bool contains(const Radical_sum& a, std::uint64_t wanted, std::size_t levels)
    {
      const std::vector<Symbol>& symbols = m_field->m_symbols;
      a.insert_radicands(m_base);
      for (std::size_t i = symbols.size(); i-- > 0;)
        if (wanted >> i & 1 && symbols[i].is_independent)
        {
          m_symbols.insert(m_symbols.begin(), i);
          wanted |= symbols[i].square.symbols();
          symbols[i].square.insert_radicands(m_base);
        }
      if (m_base.size() + m_symbols.size() > levels) return false;
      for (std::size_t i = 0; i < m_base.size(); ++i) m_tower.adjoin_root_of(m_base[i]);
      for (std::size_t i : m_symbols) m_tower.adjoin_root_of(element(symbols[i].square));
      return true;
    }

    const Radical_tower& tower() const { return m_tower; }

    Radical_tower::Element element(const Radical_sum& a) const
    {
      Radical_tower::Element e(m_tower.degree());
      for (const Radical_term& t : a.terms())
      {
        std::size_t position = 0;
        const Big_integer root = m_base.split(t.radicand, [&](std::size_t i) { position |= std::size_t(1) << i; });
        for (std::size_t k = 0; k < m_symbols.size(); ++k)
          if (t.symbols >> m_symbols[k] & 1) position |= std::size_t(1) << (m_base.size() + k);
        e[position] += t.factor * root;
      }
      return e;
    }

    Radical_sum sum(const Radical_tower::Element& e) const
    {
      std::vector<Radical_term> terms;
      for (std::size_t position = 0; position < e.size(); ++position)
      {
        if (e[position].is_zero()) continue;
        Radical_term t{e[position], 1, 0};
        for (std::size_t i = 0; i < m_base.size(); ++i)
          if (position >> i & 1) t.radicand *= m_base[i];
        for (std::size_t k = 0; k < m_symbols.size(); ++k)
          if (position >> (m_base.size() + k) & 1) t.symbols |= std::uint64_t(1) << m_symbols[k];
        terms.push_back(std::move(t));
      }
      return Radical_sum(std::move(terms));
    }

  private:
    const Radical_field* m_field;
    Coprime_base m_base;
    std::vector<std::size_t> m_symbols; // ascending, since a square contains only earlier symbols
    Radical_tower m_tower;
  };

  // Precondition: a is not zero.
  int sign(const Radical_sum& a)
  {
    for (std::size_t bits = 128; bits <= most_bits; bits *= 2)
      if (const int s = interval(a, Multiprecision_arithmetic(bits)).sign()) return s;
    throw Radical_limit_exceeded();
  }

  Multiprecision_interval interval(const Radical_sum& a, const Multiprecision_arithmetic& arithmetic)
  {
    m_work.spend(a.size());
    return arithmetic.enclosure(a, [&](std::size_t i) {
      if (m_symbols[i].identity) throw Radical_limit_exceeded();
      return arithmetic.square_root(interval(m_symbols[i].square, arithmetic));
    });
  }

  const std::size_t m_steps_for_square;
  Radical_work m_work;
  std::vector<Symbol> m_symbols;
};

} // namespace CGAL::Radical_numbers::internal

#endif
