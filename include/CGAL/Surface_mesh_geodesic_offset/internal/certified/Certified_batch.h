// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Propagation of all windows of a halfedge across its face.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BATCH_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_BATCH_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_state.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Certified counterpart of Batch_propagation. A window that is not certain to miss the apex goes to both sides.
class Certified_batch
{
public:
  typedef Certified_window Window;

  explicit Certified_batch(Certified_state& state) : m_state(state) {}

  void operator()(Index h, const Window* windows, std::size_t n)
  {
    const Unfolded_mesh<double>& mesh = m_state.unfolded;
    const Distance_bounds& bounds = m_state.field.bounds;
    const Certified_propagation face(m_state.mesh, h);
    double best, entry;
    sort_by_exit(h, face, windows, n, best, entry);
    if (m_most_faces >= most_faces)
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: a path may cross 2^16 faces without a bend; errors of "
                               "images are proven for fewer");
    if (!(m_largest_radius < m_state.queue.bucket_width()))
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: a distance is uncertain by more than a quarter of the "
                               "mean edge");
    const double room = Number_policy<double>::is_finite(best) ? face.error_of_entry(best, entry) : 0.;

    const double dp = bounds.upper(mesh.source(h)), dq = bounds.upper(mesh.target(h)), dr = bounds.upper(mesh.apex(h));
    const Index left = mesh.twin(mesh.previous(h)), right = mesh.twin(mesh.next(h));
    // bounds for all children: distances grow by less than `across`, radii by less than 4 length_error times that
    const double across = face.length + face.left_length + face.right_length;
    const double margin =
      pruning_margin(m_largest_radius + 16 * image_error * (m_farthest + across + 1), m_farthest + across, 4 * across);
    Certified_pruning by_left(face.left_length, dp, dr, margin), by_right(face.right_length, dr, dq, margin);
    // the far vertices in the frames of the exits: q seen from p -> r, p seen from r -> q
    by_left.set_far_vertex(face.cl * face.length, -face.sl * face.length, dq);
    by_right.set_far_vertex(face.right_length - face.cr * face.length, -face.sr * face.length, dp);
    auto to_left = m_left.start(left, m_state.accepts_windows(left), n);
    auto to_right = m_right.start(right, m_state.accepts_windows(right), n);
    for (std::size_t i = 0; i < n; ++i)
    {
      const Exit exit = m_exit[i].exit;
      if (exit == NONE) continue;
      const Window& w = windows[i];
      ++m_state.field.windows_propagated;
      bool goes_left = exit != RIGHT, goes_right = exit != LEFT, left_to_apex = false, right_from_apex = false;
      double left_end = w.b1, right_begin = w.b0;
      if (exit == BOTH)
      {
        // one angle, one split, with an allowance for rounding
        const double split = face.entry_of_apex(w);
        const bool may_be_best = w.is_parallel() || m_exit[i].lowest <= best;
        left_to_apex = may_be_best || split <= entry + room;
        right_from_apex = may_be_best || split >= entry - room;
        left_end = (std::min)(w.b1, entry + room);
        right_begin = (std::max)(w.b0, entry - room);
        goes_left = left_to_apex || left_end > w.b0;
        goes_right = right_from_apex || right_begin < w.b1;
      }
      if (goes_left && to_left.is_open())
      {
        Window& child = to_left.next();
        if (face.left_child(w, left_end, left_to_apex, m_exit[i].lateral, child) && !by_left.is_filtered(child.b0, child.d0) &&
            by_left.trim(child))
          to_left.keep(child.minimum());
      }
      if (goes_right && to_right.is_open())
      {
        Window& child = to_right.next();
        if (face.right_child(w, right_begin, right_from_apex, m_exit[i].lateral, child) &&
            !by_right.is_filtered(child.b1, child.d1) && by_right.trim(child))
          to_right.keep(child.minimum());
      }
    }
    m_left.finish(to_left);
    m_right.finish(to_right);
    m_state.append(m_left);
    m_state.append(m_right);
  }

private:
  enum Exit : char { NONE, LEFT, BOTH, RIGHT };
  struct Sorted
  {
    Exit exit;
    double lowest;  // BOTH: lower bound of the distance at the apex
    double lateral; // excess length of a path to the apex: zero if the apex is certainly in the rays
  };

  void sort_by_exit(Index h, const Certified_propagation& face, const Window* windows, std::size_t n, double& best,
                    double& entry)
  {
    auto& list = *m_state.lists.find(h);
    const Index apex = m_state.unfolded.apex(h);
    m_exit.resize(n);
    m_farthest = m_largest_radius = 0;
    m_most_faces = 0;
    for (std::size_t i = 0; i < n; ++i)
    {
      const Window& w = windows[i];
      if (w.is_propagated())
      {
        m_exit[i].exit = NONE;
        continue;
      }
      m_farthest = (std::max)(m_farthest, (std::max)(w.d0, w.d1));
      m_largest_radius = (std::max)(m_largest_radius, w.radius);
      m_most_faces = (std::max)(m_most_faces, w.faces());
      bool is_certain;
      m_exit[i].exit = exit_of(face, w, is_certain);
      m_exit[i].lateral = 0;
      if (m_exit[i].exit != BOTH) continue;
      if (!is_certain) m_exit[i].lateral = face.lateral_error(w);
      const double d = face.distance_at_apex(w), error = face.error_at_apex(w, d, m_exit[i].lateral);
      m_exit[i].lowest = d - error;
      if (d + error < list.split_distance)
      {
        list.split_distance = d + error;
        list.split_entry = face.entry_of_apex(w);
      }
      // direction back to the image, in the frame of the corner at the apex
      const Point_in_face<double> v = face.from_apex(w);
      const Ray_at_vertex<double> back{m_state.unfolded.previous(h), -(face.cl * v.x + face.sl * v.y),
                                       face.sl * v.x - face.cl * v.y};
      const double away = std::abs(v.x) + std::abs(v.y);
      const double angle = length_error * (1 + (face.length + face.left_length) / away) + 4 * w.error_of_image() / away;
      m_state.arrive(apex, d, error, back, angle);
    }
    best = list.split_distance;
    entry = list.split_entry;
  }

  // `is_certain`: BOTH, and the apex is certainly in the rays of the window.
  static Exit exit_of(const Certified_propagation& face, const Window& w, bool& is_certain)
  {
    const int side = face.clear_side(w, is_certain);
    if (is_certain) return side < 0 ? LEFT : side > 0 ? RIGHT : BOTH;
    const Sign from = face.side_of_apex(w, w.b0);
    if (from == POSITIVE) return RIGHT;
    const Sign to = face.side_of_apex(w, w.b1);
    if (to == NEGATIVE) return LEFT;
    is_certain = from == NEGATIVE && to == POSITIVE;
    return BOTH;
  }

  Certified_state& m_state;
  Certified_state::Output m_left, m_right;
  std::vector<Sorted> m_exit;
  double m_farthest = 0, m_largest_radius = 0; // of the propagated windows
  Index m_most_faces = 0;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
