// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lower envelopes of random windows on a halfedge, against the nearest of all windows at random points: images with one or
// several sigmas, parallel rays, windows that are nested, adjacent or duplicate, in order and in any order, and added to an
// envelope that was propagated before. Also the test for monotone lists.

#include "test_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Lower_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_bisector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace test_lower_envelope {

typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, CGAL::Surface_mesh<Kernel::Point_3>> Traits;
typedef CGAL::Geodesic_offset::internal::Window<double> Window;
typedef std::vector<Window> Windows;

// Returns copies.
class Envelope : public CGAL::Geodesic_offset::internal::Lower_envelope<Traits>
{
  typedef CGAL::Geodesic_offset::internal::Lower_envelope<Traits> Base;

public:
  using Base::Base;

  template <class... Arguments>
  Windows operator()(const Arguments&... arguments)
  {
    const auto& envelope = Base::operator()(arguments...);
    return Windows(envelope.begin(), envelope.end());
  }
};

class Random
{
public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  double operator()(double from, double to) { return std::uniform_real_distribution<double>(from, to)(m_engine); }
  int below(int n) { return std::uniform_int_distribution<int>(0, n - 1)(m_engine); }

private:
  std::mt19937 m_engine;
};

void set_interval(Window& w, double b0, double b1)
{
  w.set_begin(b0, w.distance_at(b0));
  w.set_end(b1, w.distance_at(b1));
}

// Windows of sources about `away` from the halfedge, with few different sigmas and positive distances; sometimes with the image
// of another window, or at its end.
Windows random_windows(Random& random, int number, double length, double away)
{
  Windows windows;
  for (int i = 0; i < number; ++i)
  {
    Window w;
    const bool is_again = i > 0 && random.below(8) == 0;
    if (is_again) w = windows[std::size_t(random.below(i))];
    else
    {
      const int origin = random.below(3);
      const bool is_parallel = random.below(10) == 0;
      const double angle = random(-1.2, 1.2);
      w.x = is_parallel ? std::sin(angle) : random(-1, 2) * length;
      w.y = is_parallel ? -std::cos(angle) : -away * random(0.9, 1.1);
      w.sigma = is_parallel ? away + length : 0.05 * origin * away;
      w.source_ref = CGAL::Geodesic_offset::internal::Source_ref(0, CGAL::Source_side::NONE);
      w.bits = Window::make_bits(is_parallel, origin == 0 ? CGAL::Geodesic_offset::internal::no_index : unsigned(origin));
    }
    double b0 = random(0, length), b1 = random(0, length);
    if (i > 0 && random.below(3) == 0) b0 = windows[std::size_t(random.below(i))].b1;
    if (b0 > b1) std::swap(b0, b1);
    if (!(b1 - b0 > 1e-6 * length)) continue;
    set_interval(w, b0, b1);
    windows.push_back(w);
  }
  return windows;
}

Windows in_order(const Windows& windows)
{
  const auto begins_first = [](const Window& a, const Window& b) { return a.b0 < b.b0; };
  Windows sorted;
  for (const Window& w : windows) sorted.insert(std::upper_bound(sorted.begin(), sorted.end(), w, begins_first), w);
  return sorted;
}

double nearest(const Windows& windows, double t)
{
  double d = std::numeric_limits<double>::infinity();
  for (const Window& w : windows)
    if (w.b0 <= t && t <= w.b1) d = (std::min)(d, w.distance_at(t));
  return d;
}

void check_envelope(Random& random, const Windows& envelope, const Windows& all, double length)
{
  double largest = length; // of all rounded lengths
  for (const Window& w : all) largest = (std::max)({largest, std::abs(w.x), std::abs(w.y), w.sigma, w.d0, w.d1});
  for (std::size_t i = 0; i < envelope.size(); ++i)
  {
    const Window& w = envelope[i];
    CHECK(w.b0 < w.b1);
    CHECK(i == 0 || envelope[i - 1].b1 <= w.b0);
    CHECK(std::abs(w.distance_at(w.b0) - w.d0) <= 1e-14 * largest);
    CHECK(std::abs(w.distance_at(w.b1) - w.d1) <= 1e-14 * largest);
  }
  for (int i = 0; i < 50; ++i)
  {
    const double t = random(0, length), expected = nearest(all, t), d = nearest(envelope, t);
    CHECK(d == expected || std::abs(d - expected) <= 1e-14 * largest);
  }
}

bool is_monotone_list(const Windows& windows)
{
  return Envelope::is_monotone_list(windows.data(), windows.data() + windows.size());
}

void check_row(const Windows& windows)
{
  bool expected = true;
  for (std::size_t i = 1; i < windows.size(); ++i)
  {
    const Window &a = windows[i - 1], &b = windows[i];
    if (a.b0 > b.b0 || a.b1 > b.b1) expected = false;
    if (a.x == b.x && a.y == b.y && a.sigma == b.sigma && a.bits == b.bits) expected = false;
  }
  CHECK(is_monotone_list(windows) == expected);
}

// Consecutive windows, overlapping or not; then with an end out of order, or the image of a neighbour.
void test_rows(unsigned seed)
{
  Random random(seed);
  const double length = std::exp2(random(-20, 3)), away = length * std::exp2(random(-4, 10));
  Windows windows = random_windows(random, 1 + random.below(8), length, away);
  check_row(windows);
  check_row(in_order(windows));
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    const double b = double(i) * length;
    windows[i].x = b;
    windows[i].sigma = away; // give all images different distances
    windows[i].bits = 0;
    set_interval(windows[i], b, b + length * random(0.5, 1.5));
    if (i > 0) windows[i].b1 = (std::max)(windows[i].b1, windows[i - 1].b1);
  }
  check_row(windows);
  if (windows.size() < 2) return;
  const std::size_t i = 1 + std::size_t(random.below(int(windows.size()) - 1));
  Windows within = windows, twice = windows, again = windows;
  within[i].b1 = within[i - 1].b1 - length / 16;
  check_row(within);
  CHECK(!is_monotone_list(within));
  twice[i] = twice[i - 1];
  CHECK(!is_monotone_list(twice));
  // a common end is allowed; an empty list is monotone
  Windows common = windows;
  common[i].b0 = common[i - 1].b0;
  common[i].b1 = (std::max)(common[i].b1, common[i - 1].b1);
  CHECK(Envelope::is_monotone_list(common.data() + i - 1, common.data() + i + 1));
  CHECK(Envelope::is_monotone_list(common.data(), common.data()));
  // one image up to rounding, also of parallel rays, whose image is a unit vector for every length
  Windows parallel = {windows[i - 1], windows[i]};
  for (Window& w : parallel)
  {
    w.bits = Window::make_bits(true, CGAL::Geodesic_offset::internal::no_index);
    w.x = 0.6;
    w.y = -0.8;
    w.sigma = away + 16 * length; // all distances are positive
    set_interval(w, w.b0, w.b1);
  }
  parallel[1].x *= 1 + 4e-16;
  CHECK(!Envelope::is_monotone_list(parallel.data(), parallel.data() + 2));
  parallel[1].x = 0.61;
  parallel[1].b1 = (std::max)(parallel[1].b1, parallel[0].b1);
  check_row(parallel);
  again[i].x = again[i - 1].x * (1 + 1e-15);
  again[i].y = again[i - 1].y;
  CHECK(!is_monotone_list(again));
}

void test_random(unsigned seed)
{
  Random random(seed);
  const std::vector<unsigned> source_of(1, 0);
  const Traits traits;
  Envelope envelope(source_of, traits);
  const double length = std::exp2(random(-3, 3)), away = length * std::exp2(random(-4, 10));
  Windows all = random_windows(random, 1 + random.below(12), length, away);
  if (random.below(2) == 0) all = in_order(all);
  const Window* const end = all.data() + all.size();
  Windows list = envelope(all.data(), end, length);
  check_envelope(random, list, all, length);

  // more windows, added to propagated ones
  const std::size_t taken = list.size();
  for (Window& w : list) w.set_propagated();
  const Windows more = random_windows(random, 1 + random.below(random.below(8) == 0 ? 24 : 6), length, away);
  all.insert(all.end(), more.begin(), more.end());
  const Windows apart = envelope(list.data(), list.data() + taken, length, more.data(), more.data() + more.size());
  list.insert(list.end(), more.begin(), more.end());
  const Windows both = envelope(list.data(), list.data() + list.size(), length);
  check_envelope(random, both, all, length);
  // two arrays give the same result as one
  CHECK(apart.size() == both.size());
  for (std::size_t i = 0; i < (std::min)(apart.size(), both.size()); ++i)
  {
    const Window &v = apart[i], &w = both[i];
    CHECK(v.b0 == w.b0 && v.b1 == w.b1 && v.d0 == w.d0 && v.d1 == w.d1);
    CHECK(v.x == w.x && v.y == w.y && v.sigma == w.sigma && v.source_ref == w.source_ref && v.bits == w.bits);
  }
  // propagated windows have not grown
  double before = 0, after = 0;
  for (std::size_t i = 0; i < taken; ++i) before += list[i].b1 - list[i].b0;
  for (const Window& w : both) after += w.is_propagated() ? w.b1 - w.b0 : 0;
  CHECK(after <= before * (1 + 1e-12));
}

Window point_window(double x, double b0, double b1)
{
  Window w;
  w.x = x;
  w.y = -1;
  w.sigma = 0;
  w.source_ref = CGAL::Geodesic_offset::internal::Source_ref(0, CGAL::Source_side::NONE);
  w.bits = Window::make_bits(false, CGAL::Geodesic_offset::internal::no_index);
  set_interval(w, b0, b1);
  return w;
}

Window parallel_window(double x, double sigma, double b0, double b1, unsigned primitive)
{
  using namespace CGAL::Geodesic_offset::internal;
  Window w = point_window(0, b0, b1);
  w.x = x;
  w.y = -std::sqrt(1 - x * x);
  w.sigma = sigma;
  w.source_ref = Source_ref(primitive, CGAL::Source_side::LEFT);
  w.bits = Window::make_bits(true, no_index);
  set_interval(w, b0, b1);
  return w;
}

// Ties with an image that is 1e-13 to 1e-2 of the length away from the halfedge, against a strip or another image as near, on the
// whole halfedge: both distances agree there up to the rounding of coordinates. Squares of coordinates would lose ties within
// 1e-8 of the length of such an image.
void test_ties_near_images(unsigned seed)
{
  using namespace CGAL::Geodesic_offset::internal;
  Random random(seed);
  const double length = std::pow(10, random(-3, 3));
  const auto away = [&] { return length * std::pow(10, random(-13, -2)); };
  const double x = length * random(0.1, 0.9);
  Window a = point_window(x, 0, length);
  a.y = -away();
  set_interval(a, 0, length);
  Window b;
  if (seed % 2 == 0) // distance at x: more than that of a
    b = parallel_window(random(-1, 1) * a.y / length, 0, 0, length, 0);
  else
  {
    b = point_window(x + (random.below(2) ? away() : -away()), 0, length);
    b.y = -away();
  }
  b.sigma = 0;
  b.sigma = a.distance_at(x) - b.distance_at(x) + random(0.1, 1) * a.distance_at(x);
  set_interval(b, 0, length);

  const CGAL::Geodesic_offset::internal::Window_bisector<Traits> ties(Traits(), a, b);
  const double rounding = 16 * std::numeric_limits<double>::epsilon() / 2 * (length + std::abs(b.sigma));
  CHECK(seed % 2 != 0 || ties.number() == 2);
  for (int i = 0; i < ties.number(); ++i)
  {
    CHECK(std::abs(a.distance_at(ties[i]) - b.distance_at(ties[i])) <= rounding);
    CHECK(std::abs(a.distance_at(ties[i]) - ties.distance(i)) <= rounding);
  }
}

} // namespace test_lower_envelope

GEODESIC_OFFSET_TEST(test_lower_envelope)
{
  for (unsigned seed = 1; seed <= 4000; ++seed)
  {
    test::Report::instance().set_context("seed " + std::to_string(seed));
    test_random(seed);
    test_rows(seed);
    test_ties_near_images(seed);
  }
  return test::Report::instance().finish("test_lower_envelope");
}
