// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// State and results of the certified front.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_STATE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_CERTIFIED_CERTIFIED_STATE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/certified/Certified_window.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Bucket_queue.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_output.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_pruning.h>

#include <CGAL/assertions.h>

#include <boost/config.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// Bounds of vertex distances, and the paths that arrive at vertices where paths may bend.
class Distance_bounds
{
public:
  Distance_bounds() = default;
  explicit Distance_bounds(std::size_t number_of_vertices)
    : m_lower(number_of_vertices, Number_policy<double>::infinity()), m_upper(m_lower)
  {
  }

  double lower(Index v) const { return m_lower[v]; }
  double upper(Index v) const { return m_upper[v]; }

  // Processes a path of this length, with an error of at most the radius.
  void update(Index v, double distance, double radius)
  {
    CGAL_precondition(distance >= 0 && radius >= 0);
    m_lower[v] = (std::min)(m_lower[v], (std::max)(distance - radius, 0.));
    m_upper[v] = (std::min)(m_upper[v], distance + radius);
  }

private:
  std::vector<double> m_lower, m_upper;
};

// Candidate for the shortest path to a vertex, with the direction to its start, known up to an angle.
struct Arrival
{
  Ray_at_vertex<double> back;
  double angle;
  double distance, radius;
  bool has_spread;
  Index next; // next arrival at the same vertex

  double lower() const { return distance - radius; }

  // Merges a path with the same direction and length, up to rounding. Returns false for other paths.
  bool unite(const Arrival& o)
  {
    if (o.back.corner != back.corner || std::abs(o.distance - distance) > o.radius + radius) return false;
    const double cross = back.x * o.back.y - back.y * o.back.x, dot = back.x * o.back.x + back.y * o.back.y;
    if (!(std::abs(cross) <= same_direction * dot)) return false;
    const double from = (std::min)(lower(), o.lower()), to = (std::max)(distance + radius, o.distance + o.radius);
    if (from >= lower() && to <= distance + radius && o.angle + std::abs(cross) / dot <= angle) return true;
    if (has_spread) return false;
    distance = 0.5 * (from + to);
    // allows for the roundings of `from`, `to` and their mean
    radius = 0.5 * (to - from) * (1 + 0x1p-50) + 0x1p-51 * distance;
    angle = (std::max)(angle, 2 * std::abs(cross) / dot + o.angle);
    return true;
  }

  static constexpr double same_direction = 0x1p-40;
};

class Arrivals
{
public:
  // Lists of arrivals at a vertex, and of windows, that are allowed whatever the size of the mesh. In faces so thin that no path is
  // certainly shorter, they are reduced again and again without getting shorter, so the time of a build grows with the square of
  // their length: 512 take less than a second on a small mesh.
  static constexpr std::size_t longest_list = 512;

  Arrivals() = default;
  explicit Arrivals(std::size_t number_of_vertices) : m_first(number_of_vertices, no_index) {}

  // The number of source primitives, each of which may have own arrivals.
  void set_number_of_primitives(std::size_t n) { m_number_of_primitives = n; }

  // Returns false if the arrival is already covered.
  bool add(Index v, Arrival arrival)
  {
    std::size_t n = 0;
    for (Index i = m_first[v]; i != no_index; i = m_arrivals[i].next, ++n)
      if (m_arrivals[i].unite(arrival)) return !m_arrivals[i].has_spread;
    if (n >= longest_list + 4 * (m_first.size() + m_number_of_primitives))
      throw std::runtime_error("Surface_mesh_geodesic_enclosure: " + std::to_string(n) +
                               " paths to a vertex that may be shortest: faces are so thin that rounding does not let paths be "
                               "told apart");
    arrival.next = m_first[v];
    m_first[v] = Index(m_arrivals.size());
    m_arrivals.push_back(arrival);
    return true;
  }

  // Calls f(arrival) for arrivals that have not spread yet, and marks them. From then on, arrivals within a few roundings
  // of them count as covered.
  template <class Function>
  void spread(Index v, const Function& f)
  {
    for (Index i = m_first[v]; i != no_index; i = m_arrivals[i].next)
    {
      Arrival& a = m_arrivals[i];
      if (a.has_spread) continue;
      a.has_spread = true;
      a.radius += 0x1p-51 * a.distance;
      a.angle *= 4;
      f(Arrival(a));
    }
  }

private:
  std::vector<Index> m_first; // by vertex
  std::vector<Arrival> m_arrivals;
  std::size_t m_number_of_primitives = 0;
};

// A window is certainly longer than another path if it is longer by this margin. `farthest`: largest distance in its
// interval; `size`: size of the faces on both sides of its halfedge.
inline double pruning_margin(double radius, double farthest, double size)
{
  return radius + length_error * (farthest + 2 * size);
}

// Certified counterpart of Window_pruning, with upper bounds of vertex distances. `margin`: an upper bound of the margins
// of all windows.
class Certified_pruning
{
public:
  Certified_pruning(double length, double upper_source, double upper_target, double margin)
    : m_length(length), m_margin(margin), m_by_source(upper_source + margin), m_by_target(upper_target + margin)
  {
  }

  void set_far_vertex(double x, double y, double upper)
  {
    m_far_x = x;
    m_far_yy = y * y;
    m_by_far = upper + 2 * m_margin;
  }

  // D(t) - t decreases, so a certain comparison at t also holds before t.
  BOOST_FORCEINLINE bool trim(Certified_window& w) const
  {
    const bool at_source = m_by_source + w.b0 < w.d0, at_target = m_by_target + (m_length - w.b1) < w.d1;
    return (!at_source && !at_target) || cut(w, at_source, at_target);
  }

  BOOST_FORCEINLINE bool is_filtered(double t, double d) const
  {
    const double u = t - m_far_x, r = d - m_by_far;
    return r > 0 && u * u + m_far_yy <= r * r;
  }

private:
  bool cut(Certified_window& w, bool at_source, bool at_target) const
  {
    if (m_by_source + w.b1 < w.d1 || m_by_target + (m_length - w.b0) < w.d0) return false;
    if (at_source)
    {
      const double t = tie_with_end(w, w.x, w.sigma, m_by_source + m_margin), d = w.distance_at(t);
      if (w.b0 < t && t < w.b1 && m_by_source + t < d)
      {
        w.b0 = t;
        w.d0 = d;
      }
    }
    if (at_target)
    {
      const double x = w.is_parallel() ? -w.x : m_length - w.x, at_end = w.is_parallel() ? w.sigma - w.x * m_length : 0.;
      const double t = m_length - tie_with_end(w, x, at_end, m_by_target + m_margin), d = w.distance_at(t);
      if (w.b0 < t && t < w.b1 && m_by_target + (m_length - t) < d)
      {
        w.b1 = t;
        w.d1 = d;
      }
    }
    return true;
  }

  const double m_length, m_margin, m_by_source, m_by_target;
  double m_far_x = 0, m_far_yy = 0, m_by_far = 0;
};

struct Certified_field
{
  Distance_bounds bounds;
  std::vector<Certified_window> windows; // kept windows by face, in the order of finalization
  std::vector<std::size_t> begin;        // four per face, as in Kept_windows, and one more: not empty for a mesh without faces
  std::size_t windows_created = 0, windows_propagated = 0;

  bool has_windows() const { return !begin.empty(); }

  template <class Function>
  void for_each_window(Index h, const Function& f) const
  {
    for (std::size_t i = begin[4 * (h / 3) + h % 3], n = begin[4 * (h / 3) + h % 3 + 1]; i < n; ++i) f(windows[i]);
  }
};

class Certified_state
{
public:
  typedef Certified_window Window;
  typedef Window_lists<double, Window, Window, Arrivals::longest_list> Lists;
  typedef Window_output<double, Window> Output;

  Certified_state(const Certified_mesh& m, bool keeps, Certified_field& f)
    : keeps_windows(keeps), mesh(m), unfolded(m.unfolded()), field(f), lists(unfolded.number_of_halfedges()),
      queue(0.25 * m.to_unit(unfolded.mean_edge_length())), m_arrivals(unfolded.number_of_vertices()),
      m_face_state(unfolded.number_of_faces(), 0)
  {
    field.bounds = Distance_bounds(unfolded.number_of_vertices());
    if (keeps_windows) field.begin.assign(4 * unfolded.number_of_faces() + 1, 0);
  }

  void set_number_of_primitives(std::size_t n)
  {
    lists.set_number_of_primitives(n);
    m_arrivals.set_number_of_primitives(n);
  }

  // Processes a path to v with an error of at most the radius; `back` is the direction to its start, known up to an angle.
  void arrive(Index v, double distance, double radius, const Ray_at_vertex<double>& back, double angle)
  {
    field.bounds.update(v, distance, radius);
    if (!mesh.can_be_pseudo_source(v) || distance - radius > field.bounds.upper(v)) return;
    if (m_arrivals.add(v, {back, angle, distance, radius, false, no_index}))
      queue.push_vertex((std::max)(queue.bucket_of(distance), queue.current()), v);
  }

  // Calls f(arrival) for each arrival at v that may be shortest and has not spread yet.
  template <class Function>
  void spread_arrivals(Index v, const Function& f)
  {
    m_arrivals.spread(v, [&](const Arrival& a) {
      if (a.lower() <= field.bounds.upper(v)) f(a);
    });
  }

  // Appends a window unless the ends of g prune it.
  void add(Index g, Window w)
  {
    auto output = m_single.start(g, accepts_windows(g), 1);
    if (!output.is_open() || !(w.b0 < w.b1)) return;
    output.next() = w;
    const double length = mesh.length(g);
    const double margin = pruning_margin(w.radius + 4 * w.error_of_image(), (std::max)(w.d0, w.d1), length);
    Certified_pruning pruning(length, field.bounds.upper(unfolded.source(g)), field.bounds.upper(unfolded.target(g)), margin);
    if (pruning.trim(output.next())) output.keep(output.next().minimum());
    m_single.finish(output);
    append(m_single);
  }

  // Prefetches the next halfedges of the queue.
  void prefetch_next() const
  {
    lists.prefetch_next(queue, [this](Index g) { prefetch_face(g); });
  }

  void prefetch_face(Index h) const
  {
    mesh.prefetch_face(h);
    unfolded.prefetch_face(h);
  }

  // False for border halfedges and finalized faces.
  bool accepts_windows(Index g) const { return g != no_index && m_face_state[g / 3] != FINISHED; }

  // Appends windows to the list of their halfedge, and inserts the halfedge into the queue.
  void append(const Output& output)
  {
    const std::size_t n = output.size();
    if (n == 0) return;
    auto& list = lists.get_or_create(output.halfedge());
    lists.append(output.halfedge(), list, output.begin(), n, lists.arena(0));
    field.windows_created += n;
    const std::size_t bucket = (std::max)(queue.bucket_of(output.nearest()), queue.current());
    if (bucket >= list.bucket) return;
    list.bucket = bucket;
    prefetch_face(output.halfedge());
    queue.push_halfedge(bucket, output.halfedge());
  }

  void schedule(Index f)
  {
    if (m_face_state[f]) return;
    m_face_state[f] = SCHEDULED;
    queue.push_face(queue.current() + 2, f);
  }

  // A face is final once the front has passed its largest distance by one bucket.
  void try_to_finish(Index f)
  {
    if (m_face_state[f] == FINISHED) return;
    double bound = Number_policy<double>::infinity();
    for (Index h = 3 * f; h < 3 * f + 3; ++h)
      bound = (std::min)(bound, field.bounds.upper(unfolded.source(h)) +
                                  (std::max)(mesh.length(h), mesh.length(unfolded.previous(h))));
    const std::size_t done = Number_policy<double>::is_finite(bound) ? queue.bucket_of(bound) + 2 : queue.current() + 2;
    if (done <= queue.current()) finish(f);
    else queue.push_face(done, f);
  }

  void finish_all()
  {
    for (Index f = 0; f < unfolded.number_of_faces(); ++f)
      if (m_face_state[f] == SCHEDULED) finish(f);
    release_finished();
  }

  // Releases the lists of finalized faces.
  void release_finished()
  {
    lists.release_faces(m_finished, lists.arena(0));
    m_finished.clear();
  }

  const bool keeps_windows;
  const Certified_mesh& mesh;
  const Unfolded_mesh<double>& unfolded;
  Certified_field& field;
  Lists lists;
  Bucket_queue queue;

private:
  enum Face_state : char { SCHEDULED = 1, FINISHED = 2 };

  void finish(Index f)
  {
    m_face_state[f] = FINISHED;
    m_finished.push_back(f);
    if (!keeps_windows) return;
    for (Index k = 0; k < 3; ++k)
    {
      const auto& list = lists.get(3 * f + k);
      field.begin[4 * f + k] = field.windows.size();
      field.windows.insert(field.windows.end(), list.propagated.begin(), list.propagated.end());
      field.begin[4 * f + k + 1] = field.windows.size();
    }
  }

  Output m_single;
  Arrivals m_arrivals;
  std::vector<char> m_face_state;
  std::vector<Index> m_finished; // faces with unreleased lists
};

} // namespace CGAL::Geodesic_offset::internal

#endif
