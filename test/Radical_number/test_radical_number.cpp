// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Exact number type for square roots: identities, and near identities, against algebra and CORE::Expr. Every equality is
// also tested with a tiny error, which must be detected.

#include "test_check.h"

#include <CGAL/Radical_number.h>

#include <CGAL/Cartesian.h>
#include <CGAL/squared_distance_2.h>

#include <algorithm>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace test_radical_number {

using CGAL::Exact_rational;
using CGAL::Radical_numbers::internal::Radical_sign;
typedef CGAL::Radical_number Number;

Number root(const Number& x) { return CGAL::sqrt(x); }

Number power(const Number& x, unsigned n)
{
  Number p = 1, b = x;
  for (; n != 0; n /= 2, b *= b)
    if (n % 2 == 1) p *= b;
  return p;
}

Number tiny(unsigned digits) { return 1 / power(10, digits); }

// Compares equal numbers, and the same numbers with an error, in all ways.
void check_equal(const Number& a, const Number& b, const std::string& what)
{
  const Number e = tiny(120);
  CHECK_DETAIL(a < b + e && b - e < a && a + e > b && a != b + e, what);
  CHECK_DETAIL(CGAL::compare(a + e, b) == CGAL::LARGER && CGAL::sign(a - (b + e)) == CGAL::NEGATIVE, what);
  CHECK_DETAIL(CGAL::compare(a, b) == CGAL::EQUAL, what);
  CHECK_DETAIL(a == b && a <= b && a >= b && !(a != b) && !(a < b) && !(a > b), what);
  CHECK_DETAIL(CGAL::sign(a - b) == CGAL::ZERO && CGAL::is_zero(b - a), what);
}

void check_less(const Number& a, const Number& b, const std::string& what)
{
  CHECK_DETAIL(CGAL::compare(a, b) == CGAL::SMALLER && CGAL::compare(b, a) == CGAL::LARGER, what);
  CHECK_DETAIL(CGAL::is_negative(a - b) && CGAL::is_positive(b - a) && a != b, what);
}

class Random
{
public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  // Without std::uniform_int_distribution, whose results depend on the library.
  int below(int n) { return int(m_engine() % std::uint64_t(n)); }
  Exact_rational rational(int size) { return Exact_rational(1 + below(size)) / (1 + below(size)); }
  double coordinate() { return std::ldexp(double(m_engine() >> 11), -53) - 0.5; }
  Number integer(unsigned bits)
  {
    Number n = 1;
    for (unsigned i = 0; i + 32 < bits; i += 32) n = n * 4294967296. + double(m_engine() >> 32);
    return n;
  }

private:
  std::mt19937_64 m_engine;
};

void test_constants()
{
  CHECK(CGAL::is_zero(Number()) && Number(0) == 0 && Number(0.) == Number(Exact_rational(0)));
  CHECK(Number(3) == 3 && Number(3) == 3. && 3 == Number(3) && Number(2) < 2.5 && 2.5f > Number(2));
  CHECK(Number(0.1) != Number(Exact_rational(Exact_rational(1) / 10)) && Number(0.1) > Number(1) / 10);
  CHECK(Number(CGAL::Gmpq(1, 3)) == Number(1) / 3 && Number(Exact_rational(Exact_rational(1) / 3)) * 3 == 1);
  CHECK(Number(-7LL) == -7 && Number(7u) == 7 && Number(std::uint64_t(1) << 63) == power(2, 63));
  CHECK(Number(std::numeric_limits<double>::denorm_min()) == power(Number(1) / 2, 1074));
  CHECK(root(0) == 0 && root(Number(9) / 4) == Number(3) / 2 && root(0.25) == 0.5);
  Number x = 5;
  x += 2;
  x *= x;
  x -= 1.5;
  x /= 2;
  CHECK(x == 23.75 && -x == -23.75 && +x == x && -(-x) == x);
  CHECK_THROWS(Number(1) / Number(0), std::domain_error);
  CHECK_THROWS(root(-1), std::domain_error);
  CHECK_THROWS(Number{std::numeric_limits<double>::infinity()}, std::domain_error);
  CHECK_THROWS(CGAL::sign(1 / (root(2) * root(3) - root(6)) - 1), std::domain_error);
}

// Operations used by generic code of CGAL.
void test_traits()
{
  typedef CGAL::Algebraic_structure_traits<Number> Algebra;
  typedef CGAL::Real_embeddable_traits<Number> Real;
  static_assert(std::is_same<Algebra::Algebraic_category, CGAL::Field_with_sqrt_tag>::value, "");
  static_assert(Algebra::Is_exact::value && Real::Is_real_embeddable::value, "");
  static_assert(std::is_same<CGAL::Coercion_traits<int, Number>::Type, Number>::value, "");

  const Number x = root(7);
  const auto square_root = [](const Number& a) { return CGAL::is_positive(a) ? Number(CGAL::sqrt(a)) : Number(0); };
  CHECK(square_root(x * x) == x && square_root(-x) == 0);
  CHECK(CGAL::abs(-x) == x && CGAL::square(x) == 7 && CGAL::sign(-x) == CGAL::NEGATIVE && CGAL::is_one(x / x));
  CHECK((std::min)(x, Number(3)) == x && (std::max)({x, Number(2), Number(1)}) == x);
  CHECK(CGAL::inverse(x) == x / 7 && CGAL::integral_division(x * root(2), x) == root(2));
  CHECK(CGAL::compare(x, 2.5) == CGAL::LARGER && CGAL::is_finite(x));
  const std::pair<double, double> i = CGAL::to_interval(x);
  CHECK(Number(i.first) < x && x < Number(i.second) && i.second - i.first < 1e-14);

  typedef CGAL::Cartesian<Number> Kernel;
  const Kernel::Point_2 p(0, root(2)), q(root(3), 0), r(root(3) / 2, root(2) / 2);
  CHECK(CGAL::squared_distance(p, q) == 5 && CGAL::collinear(p, r, q) && CGAL::midpoint(p, q) == r);
  CHECK(CGAL::orientation(p, q, r + Kernel::Vector_2(0, tiny(60))) == CGAL::LEFT_TURN);

  std::stringstream stream("1.5");
  Number y;
  stream >> y;
  CHECK(y == 1.5);
}

void test_identities()
{
  const Number s2 = root(2), s3 = root(3), s5 = root(5), s6 = root(6);
  check_equal((s2 + s3) * (s2 + s3), 5 + 2 * s6, "square of a sum");
  check_equal(root(8), 2 * s2, "sqrt 8");
  check_equal(root(Number(3) / 50), s6 / 10, "sqrt 3/50");
  check_equal(1 / (s2 + s3), s3 - s2, "inverse of a sum");
  check_equal(1 / (1 + s2 + s3 + s5) * (1 + s2 + s3 + s5), 1, "inverse of a longer sum");
  check_equal((s2 + s3) / (s5 - s2), (s2 + s3) * (s5 + s2) / 3, "quotient of sums");
  check_equal(root(6) * root(10) * root(15), 30, "common factors");
  check_equal(root(3) * root(12), 6, "a square from two roots");
  check_equal(power(s2 + s3 - s5, 2), 10 + 2 * s6 - 2 * root(10) - 2 * root(15), "square of three");
  check_equal(power((1 + s5) / 2, 20), (15127 + 6765 * s5) / 2, "powers of the golden ratio");

  Random random(1);
  for (int i = 0; i < 200; ++i)
  {
    Number x[3];
    for (Number& v : x)
      v = Number(random.rational(9)) - random.rational(9) + random.rational(9) * root(random.rational(9)) -
          root(random.rational(30));
    const Number &a = x[0], &b = x[1], &c = x[2];
    check_equal((a + b) * c, a * c + c * b, "distributive");
    check_equal((a - b) * (a + b), a * a - b * b, "difference of squares");
    check_equal((a + b) - (b + c) - (a - c), 0, "sum to zero");
    if (CGAL::is_zero(b) || CGAL::is_zero(c)) continue;
    check_equal(a / b / c, a / (c * b), "quotients");
    check_equal(a / b + b / c, (a * c + b * b) / (b * c), "sum of quotients");
    check_equal(CGAL::sqrt(b * b), CGAL::abs(b), "root of a square");
  }
}

// Radicands whose common factors only greatest common divisors can find.
void test_large_radicands()
{
  Random random(2);
  for (int i = 0; i < 20; ++i)
  {
    const Number a = random.integer(100), b = random.integer(100), c = random.integer(100), q = random.integer(60);
    check_equal(root(a * b) * root(b * c), b * root(a * c), "common factor");
    check_equal(root(a * q * q) + root(b) - q * root(a), root(b), "a hidden square");
    check_equal(root(a * b * c) * root(c), root(a * b) * c, "a factor more");
    check_equal((root(a * b) + root(a * c)) / root(a), root(b) + root(c), "a factor less");
    check_less(root(a * b), root(a * b + 1), "radicands next to each other");
    check_less(q * root(a), root(a * q * q + 1), "a hidden square and one");
  }
}

void test_many_roots()
{
  const int primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  for (std::size_t n : {4u, 8u, 12u})
  {
    Number product = 1, radicand = 1, sum = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      product *= root(primes[i]);
      radicand *= primes[i];
      sum += root(primes[i] * 12);
    }
    check_equal(product, root(radicand), "product of roots");
    for (std::size_t i = 0; i < n; ++i) product /= root(primes[i]);
    check_equal(product, 1, "and divided back");
    for (std::size_t i = n; i-- > 0;) sum -= 2 * root(primes[i]) * root(3);
    check_equal(sum, 0, "sum of roots");
  }
  // 2^7 terms, in two ways
  Number p = 1, q = 1;
  for (int i = 0; i < 7; ++i)
  {
    p *= 1 + root(primes[i]);
    q *= root(primes[6 - i]) + 1;
  }
  check_equal(p, q, "a product of sums");
}

void test_near_equality()
{
  const Number s2 = root(2);
  for (unsigned digits : {10u, 17u, 40u, 80u, 150u, 400u, 1000u})
  {
    const Number e = tiny(digits);
    check_less(s2, s2 + e, "digits");
    check_less(root(2 + e) - s2, e / 2, "derivative of the root");
    check_less(root(3 + s2), root(3 + s2 + e), "nested");
    // the convergents of sqrt 2 are as close as their denominators allow
    Number p = 1, q = 1;
    for (unsigned i = 0; i < digits; ++i)
    {
      const Number next = p + 2 * q;
      q += p;
      p = next;
    }
    CHECK(CGAL::compare(p, q * s2) == (digits % 2 == 0 ? CGAL::SMALLER : CGAL::LARGER));
  }
  const Number close = (s2 + tiny(30)) - s2;
  CHECK(1 / close > power(10, 29) && 1 / close < power(10, 31) && -1 / close < -power(10, 29));
  // sums of square roots that agree in many digits
  check_less(root(5) + root(18), root(10) + root(11), "two roots");
  check_less(root(5) + root(6) + root(18), root(4) + root(12) + root(12), "three roots");
  check_equal(root(3 + 2 * s2), 1 + s2, "");
  const auto roots = [](std::initializer_list<int> list) {
    Number sum = 0;
    for (int i : list) sum += root(1000000 + i);
    return sum;
  };
  // equal sums of the first powers
  const Number left = roots({0, 3, 5, 6, 9, 10, 12, 15}), right = roots({1, 2, 4, 7, 8, 11, 13, 14});
  CHECK(CGAL::abs(left - right) < tiny(18));
  check_less(left, right, "Thue and Morse");
}

void test_nested_roots()
{
  const Number s2 = root(2), s3 = root(3), s5 = root(5), s6 = root(6);
  const Number a = root(3 + s2), b = root(3 - s2);
  check_equal(root(5 + 2 * s6), s2 + s3, "denested");
  check_equal(root(2 + s3), (s6 + s2) / 2, "denested with a root outside");
  check_equal(root(10 + 2 * s6 + 2 * root(10) + 2 * root(15)), s2 + s3 + s5, "denested, three roots");
  check_equal(root(7 * (3 + s2)), root(7) * a, "a rational factor");
  check_equal(root((3 + s2) * power(1 - s2, 2)), a * (s2 - 1), "a square factor");
  check_equal(a * b, root(7), "conjugates");
  check_equal(power(a + b, 2), 6 + 2 * root(7), "sum of conjugates");
  check_equal(root(6 + 2 * root(7)), a + b, "and its root");
  check_equal(1 / (a + b), (a - b) / (2 * s2), "inverse");
  check_equal(1 / (a + root(1 + s3)) * (3 + s2 - 1 - s3), a - root(1 + s3), "inverse of two nested roots");
  check_equal(root(power(a, 4) + 2 * a * a + 1), 4 + s2, "a square");
  check_equal(root(a * a + 2 * a * s5 + 5), a + s5, "a square with a nested root");
  check_equal(root(1 + root(2 + s3)), root(1 + (s6 + s2) / 2), "three levels, denested");
  check_equal(root(1 + root(3 + s2)), root(1 + root(Number(12) / 4 + root(8) / 2)), "three levels");
  check_equal(power(root(1 + root(3 + s2)), 4), 4 + s2 + 2 * a, "power of three levels");
  check_equal(root(1 + a) * root(a - 1), root(2 + s2), "product at three levels");
  check_less(root(5 + 2 * s6), s2 + s3 + tiny(300), "");
  check_less(root(a + tiny(200)) - root(a), tiny(200), "");
  CHECK(a != b && root(1 + a) != root(1 + b) && a + b != root(12) && a * s2 != root(5 + s2));

  // all signs inside a square, which is made of two expressions so that it is not recognized as a square
  for (int signs = 0; signs < 32; ++signs)
  {
    const auto number = [&](bool nested) {
      Number x = 1;
      for (int k = 0; k < 3; ++k) x += (signs >> k & 1 ? -1 : 1) * root(k == 0 ? 2 : k == 1 ? 3 : 7);
      if (nested) x = x * (signs >> 3 & 1 ? -1 : 1) + (signs >> 4 & 1 ? -1 : 1) * root(5 + s2) * root(2);
      return x;
    };
    for (bool nested : {false, true}) check_equal(root(number(nested) * number(nested)), CGAL::abs(number(nested)), "signs");
  }
  // a quotient with a negative denominator whose rational form is too long
  const Number sum = s2 + s3 + s5 + root(7) + root(11);
  check_equal(root(-3 / (sum - 12)), root(3 / (12 - sum)), "negative numerator and denominator");
  check_equal(root(-3 / (sum - 12)) * (12 - sum), root(3 * (12 - sum)), "a quotient");

  Random random(3);
  for (int i = 0; i < 60; ++i)
  {
    // distances of a window: s + |p - a| with coordinates that have roots, computed in two ways
    const Number r = root(random.rational(20)), t = root(random.rational(20));
    const Number x = random.rational(9) + r, y = random.rational(9) * t, s = random.rational(9) * r + t;
    const Number n = root(random.rational(20)), f = random.rational(9);
    const Number d = s + root(x * x + y * y);
    check_equal(d, (s * n * f + root(power(x * n * f, 2) + power(y * f * n, 2))) / (n * f), "scaled");
    check_equal(d * (root(x * x + y * y) - s), x * x + y * y - s * s, "difference of squares");
    // rotation by an angle with rational cosine and sine
    const Number u = random.rational(9), c = (1 - u * u) / (1 + u * u), z = 2 * u / (1 + u * u);
    check_equal(d, root(power(c * x - z * y, 2) + power(z * x + c * y, 2)) + s, "turned");
    check_less(d, s + root(x * x + y * y + tiny(90)), "not quite");
  }
}

// A point that is unfolded from face to face around a vertex of a flat surface in space, as windows are, returns to its
// position.
void test_fan()
{
  Random random(4);
  const auto check_fan = [&](int n, bool doubles) {
    // a plane with an irrational area form, rays in it around the origin in order
    double u[] = {1, 2, 2}, v[] = {-1, 3, 1};
    if (doubles)
      for (int k = 0; k < 3; ++k) u[k] = random.coordinate(), v[k] = random.coordinate();
    std::vector<std::vector<Number>> ray;
    for (int i = 0; i < n; ++i)
    {
      const double angle = 2 * 3.14159 * (i + 0.3) / n, stretch = 2 + random.below(5);
      const Number a = std::floor(20 * stretch * std::cos(angle)), b = std::floor(20 * stretch * std::sin(angle));
      ray.push_back({a * u[0] + b * v[0], a * u[1] + b * v[1], a * u[2] + b * v[2]});
    }
    const auto dot = [](const std::vector<Number>& p, const std::vector<Number>& q) {
      return Number(p[0] * q[0] + p[1] * q[1] + p[2] * q[2]);
    };
    Number x = Number(1) / 3, y = root(5) / 7, distance = 0;
    for (int i = 0; i < n; ++i)
    {
      const std::vector<Number>&p = ray[i], &q = ray[(i + 1) % n];
      const Number c = dot(p, q) / (root(dot(p, p)) * root(dot(q, q))), s = root(1 - c * c);
      const Number turned = c * x + s * y;
      y = c * y - s * x;
      x = turned;
      distance += root(dot(p, p)) / root(dot(q, q)) * (i + 1) - root(dot(p, p) / dot(q, q)) * i;
    }
    check_equal(x, Number(1) / 3, "x after a turn");
    check_equal(y, root(5) / 7, "y after a turn");
    check_equal(root(x * x + y * y), root(Number(1) / 9 + Number(5) / 49), "length after a turn");
    check_less(0, distance, "lengths");
  };
  for (int n : {5, 8, 14}) check_fan(n, false);
  for (int n : {5, 9}) check_fan(n, true);
}

// Across a strip of triangles in space, both directions give the same length. Each length is the nested root of a sum with
// as many roots as there are triangles.
void test_strips()
{
  Random random(8);
  typedef std::vector<Number> Point;
  const auto squared_distance = [](const Point& p, const Point& q) {
    return Number(CGAL::square(p[0] - q[0]) + CGAL::square(p[1] - q[1]) + CGAL::square(p[2] - q[2]));
  };
  // position of c in the frame of the halfedge from a to b, above it
  const auto unfold = [&](const Point& a, const Point& b, const Point& c, Number& x, Number& y) {
    const Number ab = squared_distance(a, b), ac = squared_distance(a, c);
    x = (ab + ac - squared_distance(b, c)) / (2 * root(ab));
    y = root(ac - x * x);
  };
  const auto length = [&](const std::vector<Point>& p) {
    Number x, y, cx, cy;
    unfold(p[1], p[2], p[0], x, y);
    std::size_t i = 1;
    for (; i + 3 < p.size(); ++i)
    {
      // to the frame of the next edge, reflected so that the source stays on the positive side
      unfold(p[i], p[i + 1], p[i + 2], cx, cy);
      const Number e = root(squared_distance(p[i], p[i + 1])), f = root(squared_distance(p[i + 1], p[i + 2]));
      const Number c = (cx - e) / f, s = cy / f, u = x - e;
      x = c * u - s * y;
      y = c * y + s * u;
      y = CGAL::abs(y);
    }
    unfold(p[i], p[i + 1], p[i + 2], cx, cy);
    return root(CGAL::square(cx - x) + CGAL::square(cy + y));
  };
  for (int n = 4; n < 10; ++n)
    for (bool doubles : {false, true})
    {
      if (doubles && n > 7) continue;
      std::vector<Point> p, reversed;
      for (int i = 0; i < n; ++i)
        if (doubles) p.push_back({i + random.coordinate(), random.coordinate() + 3 * (i % 2), random.coordinate()});
        else p.push_back({4 * i + random.below(3), random.below(5) + 13 * (i % 2), random.below(7)});
      reversed.assign(p.rbegin(), p.rend());
      check_equal(length(p), length(reversed), "strip");
    }
}

// Zeros by construction, whatever the parts are: the parts are too large for exact arithmetic.
void test_zero_by_construction()
{
  auto& counts = Radical_sign::counts();
  const auto sum_of_roots = [](int first) {
    Number s = 0;
    for (int i = first; i < first + 48; i += 4) s += root(Number(i));
    return s;
  };
  const Number r = sum_of_roots(2), x = sum_of_roots(3), y = sum_of_roots(5), u = sum_of_roots(6), v = sum_of_roots(7);
  std::uint64_t identities = 0;
  const auto check_zero = [&](const Number& a, const Number& b, const std::string& what) {
    counts.reset();
    CHECK_DETAIL(a == b, what);
    CHECK_DETAIL(counts.zero_by_identity + counts.by_identity == 1, what);
    CHECK_DETAIL(counts.exactly_zero + counts.by_root_bound + counts.by_core == 0, what);
    identities += counts.zero_by_identity;
    CHECK_DETAIL(a < b + tiny(100) && b < a + tiny(100) && a != b + tiny(100), what);
  };
  check_zero(root(x) * root(y), root(x * y), "product of roots");
  check_zero((x + y) * (x - y), x * x - y * y, "binomial");
  check_zero(1 / x + 1 / y, (x + y) / (x * y), "sum of fractions");
  check_zero(x / root(x), root(x), "quotient of roots");
  check_zero(root(x / y), root(x * y) / y, "root of a fraction");
  check_zero(sum_of_roots(8), sum_of_roots(8), "the same operations again");

  // Intersections of two circles, in both orders, and the midpoint of an arc.
  struct Point
  {
    Number x, y;
  };
  const auto distance = [](const Point& p, const Point& q) {
    return root((p.x - q.x) * (p.x - q.x) + (p.y - q.y) * (p.y - q.y));
  };
  const auto meet = [](const Point& c, const Number& rc, const Point& d, const Number& rd, int side) {
    const Number ux = d.x - c.x, uy = d.y - c.y, uu = ux * ux + uy * uy;
    const Number along = (uu + (rc + rd) * (rc - rd)) / (2 * uu);
    const Number across = side * root(((rc + rd) * (rc + rd) - uu) * (uu - (rc - rd) * (rc - rd))) / (2 * uu);
    return Point{c.x + along * ux - across * uy, c.y + along * uy + across * ux};
  };
  const Point c{x, y}, d{u, v};
  const Number rc = 3 * r, rd = 3 * r - 1;
  const Point p = meet(c, rc, d, rd, 1), q = meet(c, rc, d, rd, -1), from_d = meet(d, rd, c, rc, -1);
  check_zero(distance(p, c), rc, "on the first circle");
  check_zero(distance(p, d), rd, "on the second circle");
  check_zero(distance(q, d), rd, "the other point");
  check_zero(p.x, from_d.x, "from both circles");
  check_zero(p.y, from_d.y, "from both circles");
  const Number ax = p.x + q.x - 2 * c.x, ay = p.y + q.y - 2 * c.y, a = root(ax * ax + ay * ay);
  check_zero(distance({c.x + rc / a * ax, c.y + rc / a * ay}, c), rc, "the middle of an arc");
  CHECK(identities >= 10);

  // Nonzero, and zero for another reason: the parts of root 6 are not those of root 2 and root 3.
  counts.reset();
  CHECK(root(Number(2)) + root(Number(3)) == root(5 + 2 * root(Number(6))) && counts.zero_by_identity == 0);
  const Number z = root(Number(5)) - root(Number(5) + tiny(200));
  CHECK(CGAL::is_negative(x * z) && CGAL::is_negative(z / x) && counts.zero_by_identity == 0);
}

// Numbers that exact arithmetic does not decide.
void test_root_bounds()
{
  auto& counts = Radical_sign::counts();
  counts.reset();
  Number a = 0, b = 0;
  for (int p : {2, 5, 11, 17}) a += root(p);
  for (int p : {3, 7, 13, 19}) b += root(p);
  CHECK(root(a) + root(b) == root(a + b + 2 * root(a * b)) && counts.by_root_bound == 1);
  CHECK(root(a) + root(b) < root(a + b + 2 * root(a * b)) + tiny(400) && counts.by_high_precision == 1);
  CHECK(counts.by_core == 0);

  // CORE 1.7 of CGAL 5.5 computes zero for this difference
  const Number large = power(10, 14);
  Number s = 0, t = 0;
  for (int i : {0, 3, 5, 6, 9, 10, 12, 15}) s += root(large + i);
  for (int i : {1, 2, 4, 7, 8, 11, 13, 14}) t += root(large + i);
  const Number difference = s - t, sum = s + t;
  CHECK(CGAL::is_negative(difference * sum) && CGAL::is_negative(difference));

  // Each expression is at least as large as its bound, and the bound is not too pessimistic for a single root.
  typedef CGAL::Radical_numbers::internal::Radical_expression Make;
  using CGAL::Radical_numbers::internal::Big_rational;
  using CGAL::Radical_numbers::internal::Radical_bound;
  using CGAL::Radical_numbers::internal::Radical_node;
  typedef Radical_node::Reference Reference;
  const Reference two = Radical_node::make(Big_rational(2)), one = Radical_node::make(Big_rational(1));
  Reference small = Make::difference(Make::square_root(two), one);
  for (std::size_t n = 1; n <= 512; n *= 2, small = Make::product(small, small))
  {
    const auto bits = Radical_bound::bits(*small, 1 << 20);
    CHECK(bits && double(*bits) >= n * std::log2(std::sqrt(2.) + 1) && *bits <= 8 * n);
  }
  const auto root_of = [](int i) { return Make::square_root(Radical_node::make(Big_rational(100000000000000LL + i))); };
  Reference d;
  for (int i : {0, 3, 5, 6}) d = Make::sum(d, root_of(i));
  for (int i : {1, 2, 4, 7}) d = Make::difference(d, root_of(i));
  CHECK(Radical_bound::bits(*d, 1 << 20).value_or(0) > 80 && !Radical_bound::bits(*d, 80));
}

// Random expressions, evaluated here and by CORE.
void test_against_core()
{
  Random random(5);
  int zeros = 0;
  for (int i = 0; i < 300; ++i)
  {
    std::vector<Number> ours;
    std::vector<CORE::Expr> theirs;
    for (int k = 0; k < 3; ++k)
    {
      const int n = random.below(6) - 1;
      ours.push_back(n);
      theirs.push_back(CORE::Expr(n));
    }
    for (int k = 0, roots = 0; k < 7; ++k)
    {
      const std::size_t a = random.below(int(ours.size())), b = random.below(int(ours.size()));
      const int op = random.below(5);
      Number x;
      CORE::Expr y;
      if (op == 0) x = ours[a] + ours[b], y = theirs[a] + theirs[b];
      else if (op == 1) x = ours[a] - ours[b], y = theirs[a] - theirs[b];
      else if (op == 2) x = ours[a] * ours[b], y = theirs[a] * theirs[b];
      else if (op == 3 && theirs[b].sign() != 0) x = ours[a] / ours[b], y = theirs[a] / theirs[b];
      else if (op == 4 && theirs[a].sign() > 0 && ++roots <= 3) x = root(ours[a]), y = CORE::sqrt(theirs[a]);
      else continue;
      ours.push_back(x);
      theirs.push_back(y);
    }
    for (std::size_t a = 0; a < ours.size(); ++a)
      for (std::size_t b = 0; b < a; ++b)
      {
        const int expected = theirs[a].cmp(theirs[b]);
        if (expected == 0) ++zeros;
        CHECK(int(CGAL::compare(ours[a], ours[b])) == (expected > 0) - (expected < 0));
      }
    const Number &x = ours.back(), back(theirs.back());
    CHECK(back == x && CGAL::compare(x.core_expression(), theirs.back()) == CGAL::EQUAL);
    CHECK(std::abs(CGAL::to_double(x) - CGAL::to_double(theirs.back())) <= 1e-15 * std::abs(CGAL::to_double(x)));
  }
  CHECK(zeros > 500);
  check_equal(Number(CORE::Expr(CORE::BigRat(22, 7))), Number(22) / 7, "a rational of CORE");
  check_equal(Number(CORE::Expr("3.14159265358979323846264338327950288")),
              (power(10, 35) * 3 + Number(14159265358979323LL) * power(10, 18) + Number(846264338327950288LL)) / power(10, 35),
              "a long decimal of CORE");
  // a root of a polynomial, which only CORE can represent
  CORE::BigInt coefficients[] = {-2, 0, 0, 1};
  const Number cube_root(CORE::Expr(CORE::Polynomial<CORE::BigInt>(3, coefficients), 1));
  CHECK(cube_root > Number(1.25) && cube_root < Number(1.26) && cube_root + root(2) - cube_root == root(2));
}

void test_long_chains()
{
  Number sum = 0, product = root(2), roots = 0;
  const Number s2 = root(2);
  for (int i = 0; i < 100000; ++i) sum += s2;
  CHECK(sum > 141421 && sum < 141422);
  check_equal(sum, 100000 * s2, "a long sum");
  for (int i = 0; i < 100000; ++i) product = product * s2 / s2;
  check_equal(product, s2, "a long product");
  for (int i = 0; i < 100000; ++i) roots = root(roots + 2);
  CHECK(roots < 2 + tiny(5) && roots > 1.99);
  Number dropped = s2;
  for (int i = 0; i < 100000; ++i) dropped = (dropped + s2) / 2;
  CHECK(dropped.to_double() > 1.414);
}

void test_to_double()
{
  Random random(6);
  const auto check_double = [](const Number& x, double expected) {
    const double d = CGAL::to_double(x);
    const std::pair<double, double> i = CGAL::to_interval(x);
    const double unit = std::abs(expected) * std::numeric_limits<double>::epsilon();
    CHECK_DETAIL(std::abs(d - expected) <= 4 * unit && i.first <= d && d <= i.second, test::values(d, expected));
    CHECK(Number(i.first) <= x && x <= Number(i.second) && i.second - i.first <= 8 * unit);
  };
  for (int i = 0; i < 200; ++i)
  {
    const double a = random.coordinate() + 1, b = random.coordinate() + 1;
    const Number x = a, y = b;
    check_double(root(x), std::sqrt(a));
    check_double(x / y, a / b);
    check_double(x * y, a * b);
    check_double(root(x * x + y * y), std::hypot(a, b));
    // cancellation
    check_double(root(x + tiny(30)) - root(x), 1e-30 / (2 * std::sqrt(a)));
    check_double((root(x) + y) * power(10, 200) - power(10, 200) * root(x), b * 1e200);
  }
  CHECK(CGAL::to_double(root(2) * root(3) - root(6)) == 0);
  CHECK(CGAL::to_double(root(2) * power(10, 400)) == std::numeric_limits<double>::infinity());
  CHECK(CGAL::to_double(-root(2) * tiny(400)) == 0 && CGAL::sign(-root(2) * tiny(400)) == CGAL::NEGATIVE);
}

// All rounding modes give the same signs, and none is changed.
void test_rounding_modes()
{
  for (int mode : {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO})
  {
    std::fesetround(mode);
    Random random(7);
    for (int i = 0; i < 100; ++i)
    {
      const Number a = random.rational(1000), b = random.rational(1000), x = root(a), y = root(b);
      check_equal((x + y) * (x - y), a - b, "rounding mode");
      check_less(x * y, root(a * b + tiny(20)), "rounding mode");
      const std::pair<double, double> e = (x / 3 - y).to_interval();
      CHECK(Number(e.first) <= x / 3 - y && x / 3 - y <= Number(e.second));
    }
    CHECK(std::fegetround() == mode);
    std::fesetround(FE_TONEAREST);
  }
}

void test_counts()
{
  auto& counts = Radical_sign::counts();
  counts.reset();
  const Number x = root(2) + root(3), y = root(5 + 2 * root(6)), z = x;
  CHECK(x == z && counts.by_identity == 1);
  CHECK(x < 4 && counts.by_doubles == 1);
  CHECK(x < y + tiny(30) && counts.by_precision == 1);
  CHECK(x < y + tiny(300) && counts.exactly_not_zero == 1);
  CHECK(x == y && counts.exactly_zero == 1);
  // the equality is cached
  CHECK(x == y && counts.exactly_zero == 1 && counts.by_identity == 2);
  // a nested root that is proved to be independent of other roots
  const Number nested = root(3 + root(2));
  CHECK(nested * nested * nested < nested * (3 + root(2)) + tiny(300) && counts.exactly_not_zero == 2);
  CHECK(counts.by_core == 0 && counts.by_high_precision == 0 && counts.by_root_bound == 0);
  counts.reset();
  CHECK(counts.by_identity == 0 && counts.exactly_zero == 0);
}

} // namespace test_radical_number

GEODESIC_OFFSET_TEST(test_radical_number)
{
  test_constants();
  test_traits();
  test_identities();
  test_large_radicands();
  test_many_roots();
  test_near_equality();
  test_nested_roots();
  test_fan();
  test_strips();
  test_zero_by_construction();
  test_root_bounds();
  CHECK(Radical_sign::counts().by_core == 0);
  test_against_core();
  test_long_chains();
  test_to_double();
  test_rounding_modes();
  test_counts();
  return test::Report::instance().finish("test_radical_number");
}
