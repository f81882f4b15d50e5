// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The front of certified bounds.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_FRONT_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_FRONT_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_envelope.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_propagation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_sources.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_state.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Rotation.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Source_pacing.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Vertex_sector.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Propagates all windows of a halfedge across its face: certified counterpart of Batch_propagation. A window that is not certain to miss the apex goes to both sides.
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
    check_errors();
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

  // \throws std::runtime_error if the errors of the windows are not proven, or too large for the schedule of the front
  void check_errors() const
  {
    if (m_most_faces >= most_faces)
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: a path may cross 2^16 faces without a bend; errors of "
                               "images are proven for fewer");
    if (!(m_largest_radius < m_state.queue.bucket_width()))
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: a distance is uncertain by more than a quarter of the "
                               "mean edge");
  }

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

class Certified_front
{
public:
  typedef Certified_window Window;
  typedef Ray_at_vertex<double> Ray;

  Certified_front(const Certified_mesh& mesh, bool keeps_windows, Certified_field& field)
    : m_mesh(mesh), m_unfolded(mesh.unfolded()), m_state(mesh, keeps_windows, field), m_sector(m_unfolded), m_propagate(m_state)
  {
  }

  void run(const Certified_sources& sources)
  {
    m_state.set_number_of_primitives(sources.vertices.size() + sources.in_faces.size());
    find_next_start_value(sources);
    while (true)
    {
      start_near(sources);
      if (!m_state.queue.advance() && !jumps_to_next_sources()) break;
      Index i;
      while (m_state.queue.pop_face(i)) m_state.try_to_finish(i);
      m_state.release_finished();
      if (m_state.queue.pop_halfedge(i))
      {
        m_state.prefetch_next();
        process_halfedge(i);
      }
      else if (m_state.queue.pop_vertex(i)) m_state.spread_arrivals(i, [&](const Arrival& a) { spread_behind(i, a); });
    }
    m_state.finish_all();
  }

private:
  // Starts the sources with start values not far beyond the front.
  void start_near(const Certified_sources& sources)
  {
    const double above = m_pacing.last();
    if (!has_next_sources() || !m_pacing.advance(m_state.queue, m_mesh.to_unit(m_unfolded.longest_edge()))) return;
    start(sources, [&](const auto& s) { return above < s.start_value && s.start_value <= m_pacing.last(); });
    find_next_start_value(sources);
  }

  bool has_next_sources() const { return m_pacing.has_next(Number_policy<double>::infinity()); }

  template <class Predicate>
  void start(const Certified_sources& sources, const Predicate& starts)
  {
    for (const Certified_source_vertex& s : sources.vertices)
      if (starts(s)) m_state.field.bounds.update(s.vertex, s.start_value, 0.);
    for (const Certified_source_vertex& s : sources.vertices)
      if (starts(s)) m_unfolded.for_each_fan(s.vertex, [&](Index first) { spread(Ray(), Ray(), first, s.start_value, 0.); });
    for (const Certified_source& s : sources.in_faces)
      if (starts(s))
      {
        m_state.schedule(s.face);
        for (int k = 0; k < 3; ++k) start_at_corner(sources, s, k);
      }
    for (const Certified_source& s : sources.in_faces)
      if (starts(s)) sources.for_each_window(s, [&](Index h, const Window& w) { m_state.add(h, w); });
  }

  void find_next_start_value(const Certified_sources& sources)
  {
    double next = Number_policy<double>::infinity();
    const auto consider = [&](const auto& s) {
      if (m_pacing.last() < s.start_value) next = (std::min)(next, s.start_value);
    };
    for (const Certified_source_vertex& s : sources.vertices) consider(s);
    for (const Certified_source& s : sources.in_faces) consider(s);
    m_pacing.set_next(next);
  }

  // Called when no event is left: moves to the sources with the next start value. Returns false if there are none.
  bool jumps_to_next_sources()
  {
    if (!has_next_sources()) return false;
    m_state.queue.jump_to(m_state.queue.bucket_of(m_pacing.next()));
    return true;
  }

  // Path from a source to a corner of its face.
  void start_at_corner(const Certified_sources& sources, const Certified_source& s, int k)
  {
    const Index h = 3 * s.face + Index(k);
    double reach;
    const Point_in_face<double> way = s.way_from(sources.corner(s.face, k), reach);
    const double distance = length(way);
    // direction to the nearest point of the source, in the frame of the corner's halfedge
    const Double_double_2 back = in_frame(sources.direction(s.face, k), {way.x, way.y});
    m_state.arrive(m_unfolded.source(h), s.start_value + distance, 4 * s.moved + length_error * s.start_value,
                   Ray{h, back.x.high, back.y.high},
                   distance > 0 ? length_error * (1 + reach / distance) : Number_policy<double>::infinity());
  }

  void process_halfedge(Index h)
  {
    auto* const known = m_state.lists.find(h);
    if (!known) return;
    auto& list = *known;
    if (list.bucket != m_state.queue.current() || !list.has_new()) return;
    list.bucket = Certified_state::Lists::List::not_queued;
    m_state.schedule(m_unfolded.face(h));
    // as in Halfedge_batch
    const std::size_t propagated = list.propagated.size;
    m_windows.assign(list.propagated.begin(), list.propagated.end());
    for (Window& w : m_windows) w.set_propagated();
    m_windows.insert(m_windows.end(), list.pending.begin(), list.pending.end());
    const Window *begin = m_windows.data(), *end = begin + m_windows.size();
    if (propagated > 0 || m_state.keeps_windows || !m_envelope.is_monotone_list(begin, end))
    {
      const std::vector<Window>& envelope = m_envelope(begin, end, m_mesh.length(h));
      begin = envelope.data();
      end = begin + envelope.size();
    }
    m_state.lists.replace(h, list, 0, propagated, begin, end, m_state.lists.arena(0));
    m_propagate(h, begin, std::size_t(end - begin)); // may move the list
  }

  // Emits rays behind a vertex, at angles of at least pi to the arriving path, within the error of its direction.
  void spread_behind(Index v, const Arrival& a)
  {
    const auto spread_sector = [&](const Ray& from, const Ray& to, Index first) {
      spread(from, to, first, a.distance, a.radius);
    };
    const auto spread_fan = [&](Index first) { spread(Ray(), Ray(), first, a.distance, a.radius); };
    const double angle = a.angle + walking_error(v);
    if (!(angle < largest_angle))
    { // all directions
      m_unfolded.for_each_fan(v, spread_fan);
      return;
    }
    bool is_empty = true;
    m_sector.for_each_sector_behind(
      a.back,
      [&](const Ray& from, const Ray& to, Index first) {
        is_empty = false;
        spread_sector(from, to, first);
      },
      angle);
    // In a corner of nearly half a turn, a widened sector may begin before the direction of the arriving path; without a
    // border it then seems empty. Emitting in all directions is correct, too.
    is_empty = is_empty && m_unfolded.first_on_border(a.back.corner) == no_index;
    if (m_unfolded.has_several_fans(v) || is_empty) m_unfolded.for_each_fan(v, spread_fan);
  }

  // A direction with a larger error counts as unknown.
  static constexpr double largest_angle = 0x1p-10;

  // Error of the direction of a ray that is transferred around a vertex and through a face.
  double walking_error(Index v) const
  {
    int corners = 0;
    m_unfolded.for_each_fan(v, [&](Index first) {
      Index c = first;
      do {
        ++corners;
        c = m_unfolded.corner_ccw(c);
      } while (c != no_index && c != first);
    });
    return (std::max)(0x1p-44, 16 * unit_roundoff * (corners + 8));
  }

  // Exit of a ray from the source of h, as in Vertex_sector::exit_of_ray(), but in the frame of twice the digits: in
  // doubles, the height of a flat face is known only up to the rounding of its length, and exits change with the height.
  // The error is at most 8 u of the exit edge, and that of a ray turned by 8 u.
  double exit_of_ray(Index h, const Ray& r) const
  {
    const Double_double_2 apex = m_mesh.apex(h);
    const double b = r.x * apex.y.high - r.y * apex.x.high, a = r.y * m_mesh.length(h),
                 size = m_mesh.length(m_unfolded.next(h));
    if (!(b > 0)) return 0.;
    return a > 0 ? b / (b + a) * size : size;
  }

  // Emits rays from a vertex into a sector.
  void spread(const Ray& from, const Ray& to, Index first, double sigma, double radius)
  {
    m_sector.for_each_corner(from, to, first, [&](Index h, const Ray* lower, const Ray* upper) {
      const Index e = m_unfolded.next(h), p = m_unfolded.previous(h), g = m_unfolded.twin(e);
      m_state.schedule(m_unfolded.face(h));
      const double along_e = sigma + m_mesh.length(h), along_p = sigma + m_mesh.length(p);
      const auto error = [&](double d) { return radius + length_error * d; };
      m_state.arrive(m_unfolded.source(e), along_e, error(along_e), Ray{e, m_unfolded[e].apex_x, m_unfolded[e].apex_y}, 0.);
      m_state.arrive(m_unfolded.source(p), along_p, error(along_p), Ray{p, 1., 0.}, 0.);
      if (g == no_index) return;
      const Double_double_2 apex = m_mesh.apex(e);
      Window w{};
      w.set_image({m_mesh[e].length - apex.x, -apex.y});
      w.sigma = sigma;
      w.radius = radius;
      // Exits are rounded outward by more than twice their rounding errors. In a flat face this turns rays by far more than
      // any error of their direction. The vertex sees the whole face, so the radius does not grow.
      const double size = m_mesh.length(e), rounding = length_error * size;
      const auto exit = [&](const Ray& r) { return exit_of_ray(h, r); };
      w.set_interval(upper ? (std::max)(exit(*upper) - rounding, 0.) : 0.,
                     lower ? (std::min)(exit(*lower) + rounding, size) : size);
      m_state.add(g, w);
    });
  }

  const Certified_mesh& m_mesh;
  const Unfolded_mesh<double>& m_unfolded;
  Certified_state m_state;
  Vertex_sector<double> m_sector;
  Certified_envelope m_envelope;
  std::vector<Window> m_windows; // of a list
  Certified_batch m_propagate;
  Source_pacing<double> m_pacing;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
