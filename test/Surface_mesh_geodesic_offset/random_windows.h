// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A face with random windows, as a front may leave them: point and parallel windows with near and distant images, tangent
// circles, ties, and sources in the face. The windows of each edge are the lower envelope of the images beyond it, so they
// partition the edge; paths bend at all three corners, so the distance is continuous.

#ifndef GEODESIC_OFFSET_TEST_RANDOM_WINDOWS_H
#define GEODESIC_OFFSET_TEST_RANDOM_WINDOWS_H

#include "offset_oracle.h"
#include "search_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace test {

class Random_windows
{
public:
  typedef Face_tracing::Index Index;
  typedef Geodesic::Face_location Face_location;

  explicit Random_windows(Random& random)
    : random_(random), on_grid_(uniform(random) < 0.3), mesh_(random_mesh()), geodesic_(mesh_)
  {
    add_sources();
    geodesic_.build(CGAL::parameters::keep_windows(true));
    face_ = geodesic_.field_index(*mesh_.faces().begin());
    const auto& mesh = geodesic_.mesh();
    field_.clear(mesh, {});
    field_.lists = CGAL::Geodesic_offset::internal::Window_lists<double>(mesh.number_of_halfedges());
    for (std::size_t k = 0; k < 3; ++k)
    {
      length_[k] = mesh[3 * face_ + Index(k)].length;
      size_ = (std::max)(size_, length_[k]);
    }
    draw_images();
    for (std::size_t k = 0; k < 3; ++k) add_envelope(k);
    set_corners();
  }

  const Face_tracing::Mesh& mesh() const { return geodesic_.mesh(); }
  const Face_tracing::Initial& initial() const { return geodesic_.initial(); }
  const Face_tracing::Field& field() const { return field_; }
  Index face() const { return face_; }

  /// A level that passes through the face, unless rounding decides: general, on a grid, or at or near a distance where the
  /// topology changes. Never as small as the rounding of 0.
  double level()
  {
    double result = 0;
    while (!(result > 1e-9 * size_)) result = one_level();
    return result;
  }

private:
  double one_level()
  {
    const Face_field field(mesh(), initial(), field_, face_);
    std::size_t nearest;
    const double kind = uniform(random_);
    double d = field.distance(field.frame().point(random_barycentric(random_)), nearest);
    if (kind < 0.4) return d;
    if (kind < 0.5) return (std::max)(std::round(16 * d) / 16, 1. / 16);
    const std::vector<double> events = features(field);
    if (!events.empty()) d = events[uniform_index(random_, events.size())];
    const double near = uniform(random_);
    if (near < 0.2) return d;
    if (near < 0.4) return level_cut_at(d); // cut at d
    const double off = log_uniform(random_, -15, near < 0.9 ? -9 : -3) * (d + size_);
    return uniform(random_) < 0.5 && off < d ? d - off : d + off;
  }

  typedef CGAL::Geodesic_offset::internal::Window<double> Window;

  // Distance along an edge via an image beyond it, in the frame of the edge.
  struct Image
  {
    bool is_parallel;
    double x, y, sigma;

    double at(double t) const { return is_parallel ? sigma - x * t : sigma + std::hypot(t - x, y); }
    double slope(double t) const { return is_parallel ? -x : (t - x) / std::hypot(t - x, y); }
  };

  // The face, and at each of its corners another face that shares only this vertex, so that paths bend there.
  Surface_mesh random_mesh()
  {
    std::array<Point_3, 3> p = {{Point_3(0, 0, 0), Point_3(1, 0, 0), Point_3(0.5, 0.5, 0)}};
    switch (on_grid_ ? 0 : uniform_index(random_, 4))
    {
    case 0: // sides 3, 4, 5, or 5, 5, 6, or legs of 1 or 2
    {
      static const double apex[][3] = {{4, 0, 3}, {6, 3, 4}, {1, 0, 1}, {2, 0, 2}, {1, 0, 2}, {2, 1, 1}};
      const double* const a = apex[uniform_index(random_, 6)];
      p[1] = Point_3(a[0], 0, 0);
      p[2] = Point_3(a[1], a[2], 0);
      break;
    }
    case 1: p[2] = Point_3(0.5, std::sqrt(0.75), 0); break;
    case 2: p[2] = Point_3(uniform(random_, -0.5, 1.5), log_uniform(random_, -4, 0), 0); break; // a needle
    default: p[2] = Point_3(uniform(random_, -0.5, 1.5), uniform(random_, 0.1, 1.5), 0);
    }
    Surface_mesh mesh;
    std::array<Surface_mesh::Vertex_index, 3> v;
    for (std::size_t i = 0; i < 3; ++i) v[i] = mesh.add_vertex(p[i]);
    mesh.add_face(v[0], v[1], v[2]);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point_3 &a = p[i], &b = p[(i + 1) % 3], &c = p[(i + 2) % 3];
      mesh.add_face(v[i], mesh.add_vertex(a + (a - b)), mesh.add_vertex(a + (a - c)));
    }
    return mesh;
  }

  // In the face, or only elsewhere.
  void add_sources()
  {
    const auto face = [&](std::size_t i) { return Surface_mesh::Face_index(static_cast<Surface_mesh::size_type>(i)); };
    const std::size_t kind = uniform_index(random_, 8);
    has_sources_ = kind <= 2;
    if (!has_sources_) geodesic_.add_source_point(Face_location(face(1), {{0.25, 0.25, 0.5}}));
    for (std::size_t i = 0; i < 3 && has_sources_; ++i)
    {
      const Face_location a(face(0), random_barycentric(random_)), b(face(0), random_barycentric(random_)),
        c(face(0), random_barycentric(random_));
      if (kind == 0 || (kind == 2 && i == 0)) geodesic_.add_source_point(a);
      else if (i == 1) geodesic_.add_source_polyline(std::vector<Face_location>{a, b, c});
      else if (uniform(random_) < 0.3) geodesic_.add_source_polyline(std::vector<Face_location>{a, b});
    }
  }

  double grid(double x) const { return on_grid_ ? std::round(8 * x) / 8 : x; }

  Image random_image(std::size_t k)
  {
    const double l = length_[k];
    const double kind = uniform(random_);
    std::vector<Image>& known = images_[k];
    if (kind < 0.25)
    { // parallel rays, often steep or along each other
      const double a = uniform(random_) < 0.4 ? CGAL_PI / 2 : uniform(random_, 0.02, CGAL_PI - 0.02);
      return on_grid_ && uniform(random_) < 0.5 ? Image{true, 0.6, -0.8, 0} : Image{true, std::cos(a), -std::sin(a), 0};
    }
    if (kind < 0.4 && !known.empty() && !known.back().is_parallel)
    { // mirror image: a tie in the middle of the edge
      Image m = known.back();
      m.x = l - m.x;
      return m;
    }
    Image image{false, uniform(random_, -0.5, 1.5) * l, 0, 0};
    if (kind < 0.6) image.y = -l * log_uniform(random_, -6, 0);
    else if (kind < 0.75)
    {
      image.y = -l * log_uniform(random_, 0, 6);
      image.x = uniform(random_, -1, 1) * image.y;
    }
    else image.y = -l * uniform(random_, 0.05, 2);
    image.x = grid(image.x);
    image.y = (std::min)(grid(image.y), on_grid_ ? -0.125 : -1e-9 * l);
    return image;
  }

  void draw_images()
  {
    double lowest = std::numeric_limits<double>::infinity();
    std::size_t number = 0;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double roll = uniform(random_);
      const std::size_t n = roll < 0.15 && (k < 2 || number > 0 || has_sources_) ? 0
                          : roll < 0.9                                           ? 1 + uniform_index(random_, 4)
                                                                                 : 4 + uniform_index(random_, 8);
      for (std::size_t i = 0; i < n; ++i, ++number)
      {
        Image image = random_image(k);
        const double t = uniform(random_) * length_[k];
        const double kind = uniform(random_);
        if (kind < 0.2 && !images_[k].empty() && !image.is_parallel && !images_[k].back().is_parallel)
        { // behind another image on a ray: circles touch from the inside
          const Image& front = images_[k].back();
          const double way = uniform(random_, 0.1, 1), ray = std::hypot(t - front.x, front.y);
          image = {false, front.x + way * (front.x - t), front.y + way * front.y, front.sigma - way * ray};
        }
        else if (kind < 0.35 && !images_[k].empty() && image.is_parallel == images_[k].back().is_parallel)
          image.sigma = images_[k].back().sigma;
        else image.sigma = (uniform(random_) < 0.3 ? 0 : uniform(random_, 0, 0.6) * size_) - image.at(t);
        image.sigma = grid(image.sigma);
        images_[k].push_back(image);
        lowest = (std::min)({lowest, image.is_parallel ? (std::min)(image.at(0), image.at(length_[k])) : image.sigma});
      }
    }
    if (number == 0) return;
    // corners at distance 0 would be sources
    const double start = grid(size_ * (uniform(random_) < 0.5 ? 0.125 : uniform(random_, 0.125, 1)));
    for (auto& of_edge : images_)
      for (Image& i : of_edge) i.sigma += start - lowest;
  }

  // Parts of an edge by nearest image; neighbours share their ends.
  void add_envelope(std::size_t k)
  {
    const std::vector<Image>& images = images_[k];
    if (images.empty()) return;
    const double l = length_[k];
    std::vector<double> ends = {0, l};
    for (std::size_t i = 0; i < images.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) meet(images[i], images[j], l, ends);
    std::sort(ends.begin(), ends.end());
    std::vector<Window> windows;
    std::size_t last = images.size();
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
    {
      const double b0 = ends[i], b1 = ends[i + 1];
      if (!(b0 < b1)) continue;
      const std::size_t nearest = nearest_along(images, b0, b1);
      if (nearest != last || uniform(random_) < 0.2) // or repeat the image, as behind a flat vertex
      {
        const Image& m = images[nearest];
        const Window w({m.x, m.y, m.sigma, 0, 0, source_ref(),
                        Window::make_bits(m.is_parallel, CGAL::Geodesic_offset::internal::no_index)},
                       b0, b1);
        if (!windows.empty()) windows.back().set_end(b0, windows.back().distance_at(b0));
        windows.push_back(w);
      }
      windows.back().set_end(b1, images[nearest].at(b1));
      last = nearest;
    }
    const Index h = 3 * face_ + Index(k);
    auto& list = field_.lists.create(h);
    field_.lists.replace(h, list, 0, 0, windows.data(), windows.data() + windows.size(), field_.lists.arena(0));
  }

  // The image that is nearest everywhere between two neighbouring ends, up to rounding. Images behind each other on a ray along
  // the edge tie on one side of the foot of the nearer one only, so one point does not decide.
  static std::size_t nearest_along(const std::vector<Image>& images, double b0, double b1)
  {
    const std::array<double, 3> points = {{b0, (b0 + b1) / 2, b1}};
    std::array<double, 3> lowest;
    for (std::size_t i = 0; i < 3; ++i)
    {
      lowest[i] = images[0].at(points[i]);
      for (const Image& m : images) lowest[i] = (std::min)(lowest[i], m.at(points[i]));
    }
    std::size_t result = 0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t j = 0; j < images.size(); ++j)
    {
      double excess = 0;
      for (std::size_t i = 0; i < 3; ++i) excess = (std::max)(excess, images[j].at(points[i]) - lowest[i]);
      if (!(excess < least)) continue;
      least = excess;
      result = j;
    }
    return result;
  }

  // Adds the points of an edge where two images are equally far, that is where their difference changes its sign. It is the
  // difference of convex functions with monotone slopes, so it has at most two zeros, found by fine subdivision.
  static void meet(const Image& a, const Image& b, double l, std::vector<double>& ends)
  {
    const auto difference = [&](double t) { return a.at(t) - b.at(t); };
    std::vector<double> t = {0, l};
    const int n = 16;
    for (int i = 1; i < n; ++i) t.push_back(l * i / n);
    for (const Image* m : {&a, &b}) // functions change fast near the feet of near images
      if (!m->is_parallel)
        for (const double way : {-8., -2., -0.5, 0., 0.5, 2., 8.})
          if (const double s = m->x - way * m->y; 0 < s && s < l) t.push_back(s);
    std::sort(t.begin(), t.end());
    for (std::size_t i = 0; i + 1 < t.size(); ++i)
    {
      double low = t[i], high = t[i + 1];
      const double at_low = difference(low), at_high = difference(high);
      if (at_low == 0) ends.push_back(low);
      if (!(at_low < 0 && at_high > 0) && !(at_low > 0 && at_high < 0)) continue;
      for (int step = 0; step < 70; ++step)
      {
        const double middle = (low + high) / 2;
        ((difference(middle) < 0) == (at_low < 0) ? low : high) = middle;
      }
      ends.push_back(low);
    }
  }

  // Distances of the corners from all windows.
  void set_corners()
  {
    const Face_field field(mesh(), initial(), field_, face_);
    std::array<double, 3> d;
    std::size_t nearest;
    for (std::size_t k = 0; k < 3; ++k)
    {
      d[k] = field.distance(field.frame().corner(int(k)), nearest);
      for (const Face_window& w : field.windows())
        for (const Point_in_face& end : {w.left, w.right}) // windows of other corners do not exist yet
          d[k] = (std::min)(d[k], w.distance_at(end) + length(field.frame().corner(int(k)) - end));
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      field_.distance[mesh().source(3 * face_ + Index(k))] = d[k];
      field_.source_ref[mesh().source(3 * face_ + Index(k))] = source_ref();
    }
  }

  static CGAL::Geodesic_offset::internal::Source_ref source_ref()
  {
    return CGAL::Geodesic_offset::internal::Source_ref(0, CGAL::Source_side::NONE);
  }

  // Distances where the topology of the level changes: at corners, at ends of windows, where circles touch edges or each
  // other, and where three of them meet.
  std::vector<double> features(const Face_field& field)
  {
    std::vector<double> result;
    const auto& frame = field.frame();
    const auto add = [&](const Point_in_face& p, double d) {
      for (int k = 0; k < 3; ++k)
        if (cross(frame.direction(k), p - frame.corner(k)) < -1e-9 * size_) return;
      std::size_t nearest;
      if (d > 0 && std::abs(field.distance(p, nearest) - d) <= 1e-9 * (d + size_)) result.push_back(d);
    };
    const std::vector<Face_window>& w = field.windows();
    for (int k = 0; k < 3; ++k) result.push_back(field_.distance[mesh().source(3 * face_ + Index(k))]);
    for (const Face_window& a : w)
    {
      if (a.origin < 3) add(a.left, a.distance_at(a.left));
      if (a.is_parallel()) continue;
      for (int k = 0; k < 3; ++k)
      {
        const double t = dot(frame.direction(k), a.image() - frame.corner(k));
        const Point_in_face foot = frame.on_edge(k, t);
        add(foot, a.distance_at(foot));
      }
    }
    for (int i = 0; i < 12 && w.size() > 1; ++i)
    {
      const Face_window &a = w[uniform_index(random_, w.size())], &b = w[uniform_index(random_, w.size())];
      if (a.is_parallel() || b.is_parallel()) continue;
      const Point_in_face v = b.image() - a.image();
      const double l = length(v), way = (l + b.sigma - a.sigma) / 2;
      if (way > 0 && way < l) add(a.image() + (way / l) * v, a.sigma + way);
    }
    for (int i = 0; i < 12 && w.size() > 2; ++i)
    {
      const std::array<const Face_window*, 3> three = {
        {&w[uniform_index(random_, w.size())], &w[uniform_index(random_, w.size())], &w[uniform_index(random_, w.size())]}};
      Point_in_face p = frame.point(random_barycentric(random_));
      for (int step = 0; step < 20; ++step)
      { // Newton's method: the differences of the distances vanish
        const auto gradient = [&](const Face_window& a) {
          const Point_in_face v = a.ray_direction(p);
          const double n = length(v);
          return n > 0 ? (1 / n) * v : v;
        };
        const Point_in_face g = gradient(*three[1]) - gradient(*three[0]), h = gradient(*three[2]) - gradient(*three[0]);
        const double d = three[0]->distance_at(p), e = d - three[1]->distance_at(p), f = d - three[2]->distance_at(p);
        const double det = cross(g, h);
        if (!(std::abs(det) > 1e-12)) break;
        p = p + Point_in_face{(e * h.y - f * g.y) / det, (f * g.x - e * h.x) / det};
      }
      if (std::isfinite(p.x) && std::isfinite(p.y)) add(p, three[0]->distance_at(p));
    }
    return result;
  }

  Random& random_;
  const bool on_grid_; // coordinates are multiples of 1/8 if possible
  Surface_mesh mesh_;
  Cut_geodesic geodesic_;
  bool has_sources_ = false; // in the face
  Index face_ = 0;
  double size_ = 0;
  std::array<double, 3> length_ = {{0, 0, 0}};
  std::array<std::vector<Image>, 3> images_;
  Face_tracing::Field field_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_RANDOM_WINDOWS_H
