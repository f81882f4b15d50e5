// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Lower envelopes of random windows on a halfedge, against the nearest of all windows at random points: images with one or
// several sigmas, parallel rays, windows that are nested, adjacent or duplicate, in order and in any order, and added to an
// envelope that was propagated before. Also the test for monotone lists, and when gaps are closed.

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
  w.b0 = b0;
  w.b1 = b1;
  w.d0 = w.distance_at(b0);
  w.d1 = w.distance_at(b1);
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

// Whether t is in a gap between windows, or in a farther window between two others, at both ends of which w agrees with these up
// to rounding: then w may close the gap.
bool is_in_closed_gap(const Windows& all, const Window& w, double t, double largest)
{
  double from = -std::numeric_limits<double>::infinity(), to = -from;
  for (const Window& v : all)
  {
    if (v.b1 < t) from = (std::max)(from, v.b1);
    if (v.b0 > t) to = (std::min)(to, v.b0);
  }
  const double rounding = 0x1p-42 * largest; // above 256 u of two distances and a length
  const auto agrees = [&](double end) { return std::abs(w.distance_at(end) - nearest(all, end)) <= rounding; };
  return agrees(from) && agrees(to);
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
    const auto covers = [t](const Window& w) { return w.b0 <= t && t <= w.b1; };
    const bool is_closed_gap =
      d < expected && is_in_closed_gap(all, *std::find_if(envelope.begin(), envelope.end(), covers), t, largest);
    CHECK(d == expected || std::abs(d - expected) <= 1e-14 * largest || is_closed_gap);
  }
}

bool is_monotone_list(const Windows& windows, double length)
{
  return Envelope::is_monotone_list(windows.data(), windows.data() + windows.size(), length);
}

// Gaps that are wider than rounding and may be closed.
double widest_gap(const Window& first, double length)
{
  return (std::max)(length / 256, (std::min)(length, 0x1p-24 * first.d0));
}
bool may_be_closed(double gap, double length, double widest) { return gap > 0x1p-40 * length && gap < widest; }

void check_row(const Windows& windows, double length)
{
  const double widest = widest_gap(windows.front(), length);
  bool expected =
    !may_be_closed(windows.front().b0, length, widest) && !may_be_closed(length - windows.back().b1, length, widest);
  for (std::size_t i = 1; i < windows.size(); ++i)
  {
    const Window &a = windows[i - 1], &b = windows[i];
    if (a.b0 > b.b0 || a.b1 > b.b1 || may_be_closed(b.b0 - a.b1, length, widest)) expected = false;
    const double gap = b.b0 - a.b1; // a narrow window that is farther than the way from a allows may occupy a gap
    if (gap >= 0 && b.b1 - b.b0 < widest && b.d0 - a.d1 > gap) expected = false;
    if (a.x == b.x && a.y == b.y && a.sigma == b.sigma && a.bits == b.bits) expected = false;
  }
  CHECK(is_monotone_list(windows, length) == expected);
}

// Consecutive windows, overlapping or not; then with an end out of order, or the image of a neighbour.
void test_rows(unsigned seed)
{
  Random random(seed);
  const double length = std::exp2(random(-20, 3)), away = length * std::exp2(random(-4, 10));
  Windows windows = random_windows(random, 1 + random.below(8), length, away);
  check_row(windows, length);
  check_row(in_order(windows), length);
  for (std::size_t i = 0; i < windows.size(); ++i)
  {
    const double b = double(i) * length;
    windows[i].x = b;
    windows[i].sigma = away; // give all images different distances
    windows[i].bits = 0;
    set_interval(windows[i], b, b + length * random(0.5, 1.5));
    if (i > 0) windows[i].b1 = (std::max)(windows[i].b1, windows[i - 1].b1);
  }
  check_row(windows, length);
  if (windows.size() < 2) return;
  const std::size_t i = 1 + std::size_t(random.below(int(windows.size()) - 1));
  Windows within = windows, twice = windows, again = windows;
  within[i].b1 = within[i - 1].b1 - length / 16;
  check_row(within, length);
  CHECK(!is_monotone_list(within, length));
  twice[i] = twice[i - 1];
  CHECK(!is_monotone_list(twice, length));
  // a common end is allowed; an empty list is monotone
  Windows common = windows;
  common[i].b0 = common[i - 1].b0;
  common[i].b1 = (std::max)(common[i].b1, common[i - 1].b1);
  CHECK(Envelope::is_monotone_list(common.data() + i - 1, common.data() + i + 1, length));
  CHECK(Envelope::is_monotone_list(common.data(), common.data(), length));
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
  CHECK(!Envelope::is_monotone_list(parallel.data(), parallel.data() + 2, length));
  parallel[1].x = 0.61;
  parallel[1].b1 = (std::max)(parallel[1].b1, parallel[0].b1);
  check_row(parallel, length);
  again[i].x = again[i - 1].x * (1 + 1e-15);
  again[i].y = again[i - 1].y;
  CHECK(!is_monotone_list(again, length));
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

// Gaps between neighbours whose distances agree up to rounding, and beside the ends of the halfedge, are closed once the front
// has passed them; what was propagated before stays apart.
void test_gaps()
{
  const std::vector<unsigned> source_of(1, 0);
  const Traits traits;
  Envelope envelope(source_of, traits);
  const double infinity = std::numeric_limits<double>::infinity();
  Windows list = {point_window(0.5, 0, 0.4999), point_window(0.5 + 2e-10, 0.5001, 1)};
  const auto reduced = [&](double passed) {
    return envelope(list.data(), list.data() + list.size(), 1, nullptr, nullptr, Envelope::End(), Envelope::End(), passed);
  };
  const Windows open = reduced(0.9);
  CHECK(open.size() == 2 && open[0].b1 == 0.4999 && open[1].b0 == 0.5001);
  CHECK(!envelope.has_closed_gaps() && std::abs(envelope.nearest_gap() - 1) < 1e-6);
  const Windows closed = reduced(1.1);
  CHECK(closed.size() == 2 && closed[0].b1 == closed[1].b0);
  CHECK(envelope.has_closed_gaps() && envelope.nearest_gap() == infinity);
  for (Window& w : list) w.set_propagated();
  const Windows apart = reduced(1.1);
  CHECK(apart.size() == 3);
  if (apart.size() == 3)
  {
    CHECK(apart[0].is_propagated() && !apart[1].is_propagated() && apart[2].is_propagated());
    CHECK(apart[0].b1 == 0.4999 && apart[1].b0 == 0.4999 && apart[1].b1 == 0.5001 && apart[2].b0 == 0.5001);
  }
  // a window that fills the gap and comes before it is closed keeps it
  list.push_back(point_window(0.5 + 1e-10, 0.4999, 0.5001));
  const Windows filled = reduced(0.9);
  CHECK(filled.size() == 3 && filled[1].x == 0.5 + 1e-10);

  for (const bool is_propagated : {false, true})
  {
    Window w = point_window(0.5, 1e-4, 1 - 1e-4);
    if (is_propagated) w.set_propagated();
    Envelope::End end;
    end.distance = w.distance_at(0); // that of both ends
    const auto ends_of = [&](double passed) { return envelope(&w, &w + 1, 1, nullptr, nullptr, end, end, passed); };
    CHECK(ends_of(1).size() == 1 && std::abs(envelope.nearest_gap() - end.distance) < 1e-12);
    const Windows whole = ends_of(1.5);
    CHECK(whole.size() == (is_propagated ? 3 : 1));
    CHECK(whole.front().b0 == 0 && whole.back().b1 == 1 && !whole.front().is_propagated() && !whole.back().is_propagated());
    end.distance *= 1 - 1e-9; // the distance of a vertex that the window does not give
    CHECK(ends_of(1.5).size() == 1 && envelope.nearest_gap() == infinity);
  }
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

// Parallel rays fill a gap, between windows or at an end of the halfedge, only in front of their segment, and only as far from it
// as the distance beyond its end is the same up to rounding; although the distances agree up to the rounding of the halfedge.
// `slope`: of the distances along the halfedge; negative if they fall towards the gap.
void test_gaps_beside_segments(double slope, double gap, double away, bool is_closed)
{
  const std::vector<unsigned> source_of(2, 0);
  const Traits traits;
  Envelope envelope(source_of, traits);
  const double end = 0.75, rounding = 1e-15; // of distances up to 1: 9 u
  // two strips with the distance `away` beside the gap
  const Windows list = {parallel_window(-slope, away - slope * end, 0.5, end, 0),
                        parallel_window(slope, away + slope * (end + gap), end + gap, 1, 1)};
  const Windows between = envelope(list.data(), list.data() + 2, 1);
  CHECK(envelope.has_closed_gaps() == is_closed);
  CHECK(between.size() == 2 && (between[0].b1 == between[1].b0) == is_closed);
  for (const Window& w : between) CHECK((std::min)(w.d0, w.d1) > -rounding);
  // one strip with this distance beside the end of the halfedge, where the vertex has it, too
  Envelope::End vertex;
  vertex.distance = away;
  const Window at_source = parallel_window(slope, away + slope * gap, gap, 0.5, 0);
  const Window at_target = parallel_window(-slope, away - slope * (1 - gap), 0.5, 1 - gap, 0);
  const Windows from_source = envelope(&at_source, &at_source + 1, 1, nullptr, nullptr, vertex);
  CHECK(from_source.size() == 1 && (from_source.front().b0 == 0) == is_closed && from_source.front().d0 > -rounding);
  const Windows to_target = envelope(&at_target, &at_target + 1, 1, nullptr, nullptr, Envelope::End(), vertex);
  CHECK(to_target.size() == 1 && (to_target.front().b1 == 1) == is_closed && to_target.front().d1 > -rounding);
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
  test_gaps();
  // gaps wider than rounding: behind the segment by 4.5e-14, and beside its end
  test_gaps_beside_segments(-0.03, 1.5e-12, 0, false);
  test_gaps_beside_segments(-0.03, 1.5e-12, 1e-3, true);
  // distances beyond the end are longer by g^2 / (2 d) at most: 3.2e-13 and 3.2e-18; 256 u are 5.7e-14
  test_gaps_beside_segments(0, 8e-11, 0, false);
  test_gaps_beside_segments(0, 8e-11, 1e-8, false);
  test_gaps_beside_segments(0, 8e-11, 1e-3, true);
  test_gaps_beside_segments(0, 4e-8, 1, true);  // 8e-16
  test_gaps_beside_segments(0, 1e-6, 1, false); // 5e-13
  return test::Report::instance().finish("test_lower_envelope");
}
