// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Points where the topology of the level sets of a distance field changes: vertices, points where fronts touch edges,
// joints of windows, saddles and maxima. They are computed from the windows of faces, without offsets.

#ifndef GEODESIC_OFFSET_TEST_FIELD_FEATURES_H
#define GEODESIC_OFFSET_TEST_FIELD_FEATURES_H

#include "edge_profile.h"
#include "geodesic_types.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace test {

/// Geodesic object with access to the windows of its faces.
class Open_geodesic : public Geodesic
{
public:
  using Geodesic::Geodesic;

  const auto& data() const { return CGAL::Geodesic_offset::internal::Mesh_access::data(Geodesic::mesh()); }
  const auto& last_build() const { return *CGAL::Geodesic_offset::internal::Field_access::shared_build(Geodesic::field()); }

  /// \pre built with kept windows
  test::Face_field face_field() const { return test::Face_field(data().unfolded(), last_build().initial, last_build().field); }
  /// Index of a face in `face_field()`.
  CGAL::Geodesic_offset::internal::Index field_index(face_descriptor f) const
  {
    return data().classified(Face_location(f, {{1. / 3, 1. / 3, 1. / 3}})).element;
  }
};

/// Point of a face with its distance.
struct Witness
{
  Point_in_face point;
  double distance;
};

/// Features of a field, and witnesses for each face. Time: linear in the number of windows of all faces, plus, for each
/// face, cubic in the number of windows that are nearest at one of its samples.
class Field_features
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;

  std::vector<double> vertices;                // distances of vertices
  std::vector<double> tangents;                // smallest distances of single windows along edges
  std::vector<double> joints;                  // distances where two windows meet on an edge
  std::vector<double> edge_maxima;             // largest distances along edges
  std::vector<double> saddles;                 // distances where two fronts meet head-on in a face
  std::vector<double> maxima;                  // largest distances in faces
  std::vector<std::vector<Witness>> witnesses; // by face
  std::vector<Edge_profile> profiles;          // by halfedge; the smaller halfedge of each edge

  Field_features(const Open_geodesic& geodesic, const Surface_mesh& mesh, const Judged_surface& surface, Random& random)
    : surface_(surface), random_(random), scale_(surface.diagonal())
  {
    for (std::size_t v = 0; v < surface.number_of_vertices(); ++v)
    {
      const double d = surface.vertex_distance(Index(v));
      if (std::isfinite(d) && d > 0) vertices.push_back(d);
    }
    witnesses.resize(surface.number_of_faces());
    profiles.resize(3 * surface.number_of_faces());
    test::Face_field field = geodesic.face_field();
    for (const auto f : mesh.faces())
    {
      const Index face = surface.index_of(f);
      field.set_face(geodesic.field_index(f));
      for (Index k = 0; k < 3; ++k)
      {
        const Index h = 3 * face + k, twin = surface.twin(h);
        profiles[(std::min)(h, twin)].add_windows(field, int(k), twin < h);
      }
      look_into(face, field);
    }
    for (Index h = 0; h < Index(profiles.size()); ++h)
    {
      if (!surface.is_used(h / 3) || surface.twin(h) < h) continue;
      const double d0 = surface.vertex_distance(surface.origin(h)), d1 = surface.vertex_distance(surface.target(h));
      profiles[h].leave_out_beyond((d0 + d1 + profiles[h].length) / 2 + Judge_tolerances::beyond * scale_);
      look_along(profiles[h]);
    }
  }

private:
  // The nearest window changes between two samples: two functions are equal in between.
  void look_along(const Edge_profile& profile)
  {
    for (const Edge_span& s : profile.spans)
    {
      const double t = s.lowest(), d = s.distance(t);
      if (s.from < t && t < s.to && ties(profile.distance(t), d)) tangents.push_back(d);
    }
    const int n = Sampling::points_per_edge;
    std::size_t last = profile.spans.size();
    double last_t = 0;
    for (int i = 0; i <= n; ++i)
    {
      const double t = (std::min)(profile.length * (double(i) / n), profile.length);
      std::size_t nearest;
      profile.distance(t, nearest);
      if (i > 0 && nearest != last && nearest < profile.spans.size() && last < profile.spans.size())
        meet(profile, profile.spans[last], last_t, profile.spans[nearest], t);
      last = nearest;
      last_t = t;
    }
  }

  void meet(const Edge_profile& profile, const Edge_span& a, double low, const Edge_span& b, double high)
  {
    for (int i = 0; i < Sampling::halvings; ++i)
    {
      const double middle = (low + high) / 2;
      (a.distance(middle) < b.distance(middle) ? low : high) = middle;
    }
    const double d = a.distance(low);
    if (!ties(profile.distance(low), d) || !(d > 0)) return;
    const double step = Judge_tolerances::slope_step * profile.length;
    const bool is_maximum = a.distance(low - step) < d && b.distance(low + step) < d;
    (is_maximum ? edge_maxima : joints).push_back(d);
  }

  bool ties(double a, double b) const { return std::abs(a - b) <= Judge_tolerances::same_distance * (a + scale_); }

  void look_into(Index index, const test::Face_field& field)
  {
    const auto face = surface_.face_at(index);
    std::vector<std::size_t> nearest_windows;
    const int n = Sampling::rows_per_face;
    const double within = 1 - 3 * Sampling::from_sides, cells = n + Sampling::jitter;
    const auto weight = [&](int cell) {
      return Sampling::from_sides + within * (double(cell) + uniform(random_, 0, Sampling::jitter)) / cells;
    };
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
      {
        // inside, each in its own cell
        const double w0 = weight(i), w1 = weight(j);
        const Point_in_face p = face.point({{w0, w1, (std::max)(1 - w0 - w1, Sampling::from_sides / 2)}});
        if (face.outside(p) > 0) continue;
        std::size_t nearest;
        const double d = field.distance(p, nearest);
        if (!std::isfinite(d)) return;
        nearest_windows.push_back(nearest);
        if ((i + j) % 2 == 0) witnesses[index].push_back({p, d});
      }
    std::sort(nearest_windows.begin(), nearest_windows.end());
    nearest_windows.erase(std::unique(nearest_windows.begin(), nearest_windows.end()), nearest_windows.end());
    const std::size_t count = (std::min)(nearest_windows.size(), Sampling::windows_per_face);
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = i + 1; j < count; ++j)
      {
        const Face_window &a = field.windows()[nearest_windows[i]], &b = field.windows()[nearest_windows[j]];
        find_saddle(face, field, a, b);
        for (std::size_t k = j + 1; k < count; ++k) find_maximum(face, field, {{&a, &b, &field.windows()[nearest_windows[k]]}});
      }
  }

  // Two growing circles touch on the segment between their centers.
  void find_saddle(const Judged_surface::Face& face, const test::Face_field& field, const Face_window& a, const Face_window& b)
  {
    if (a.is_parallel() || b.is_parallel()) return;
    const Point_in_face v = b.image() - a.image();
    const double l = length(v), way = (l + b.sigma - a.sigma) / 2;
    if (!(way > 0) || !(way < l)) return;
    const Point_in_face p = a.image() + (way / l) * v;
    std::size_t nearest;
    if (face.outside(p) <= 0 && ties(field.distance(p, nearest), a.sigma + way)) saddles.push_back(a.sigma + way);
  }

  // Newton's method for a point equidistant from three windows.
  void find_maximum(const Judged_surface::Face& face, const test::Face_field& field,
                    const std::array<const Face_window*, 3>& windows)
  {
    Point_in_face p = (1. / 3) * (face.corner[0] + (face.corner[1] + face.corner[2])), g[3];
    double d = 0;
    for (int step = 0; step < Sampling::newton_steps; ++step)
    {
      double f[3];
      for (int i = 0; i < 3; ++i)
      {
        f[i] = windows[i]->distance_at(p);
        const Point_in_face ray = windows[i]->ray_direction(p);
        const double l = length(ray);
        if (!(l > 0)) return;
        g[i] = (1 / l) * ray;
      }
      d = f[0];
      const Point_in_face a = g[1] - g[0], b = g[2] - g[0];
      const double determinant = cross(a, b);
      if (!(std::abs(determinant) > Sampling::smallest_determinant)) return;
      const double r = f[0] - f[1], s = f[0] - f[2];
      const Point_in_face way{(r * b.y - s * a.y) / determinant, (a.x * s - b.x * r) / determinant};
      const double l = length(way), longest = face.longest_edge();
      p = p + (l > longest ? longest / l : 1) * way;
      if (l <= Sampling::last_newton_step * longest) break;
    }
    if (!(face.outside(p) < 0)) return;
    const bool turns = cross(g[0], g[1]) > 0;
    if ((cross(g[1], g[2]) > 0) != turns || (cross(g[2], g[0]) > 0) != turns) return;
    std::size_t nearest;
    const double actual = field.distance(p, nearest);
    if (!ties(actual, d)) return;
    maxima.push_back(actual);
    witnesses[face.face].push_back({p, actual});
  }

  const Judged_surface& surface_;
  Random& random_;
  double scale_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_FIELD_FEATURES_H
