// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The distance field at the vertices, and on the halfedges where the front is or where windows are kept.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_GEODESIC_FIELD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_GEODESIC_FIELD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Kept_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Merge_error_code.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/windows/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <boost/config.hpp>

#include <map>
#include <vector>

namespace CGAL::Geodesic_offset::internal {

// First part of the shortest path from a vertex: its direction, and its end, the pseudo-source. Without a pseudo-source, the
// path is straight up to the source.
template <class FT>
struct Backtrace
{
  Index corner = no_index; // no_index at a source and at infinite distance
  Index pseudo_source = no_index;
  FT x = FT(0), y = FT(0);

  Backtrace() = default;
  Backtrace(const Ray_at_vertex<FT>& ray, Index vertex) : corner(ray.corner), pseudo_source(vertex), x(ray.x), y(ray.y) {}
  Ray_at_vertex<FT> ray() const { return {corner, x, y}; }
};

// The largest distance of the surface and a point that attains it, a vertex if possible. If points lie beyond the maximal
// distance of the build, that distance without a point.
template <class FT>
struct Farthest
{
  FT distance;
  Index face;             // no_index if points lie beyond
  Per_corner<FT> weights; // barycentric coordinates, exactly zero on edges
};

// What a front notes at the elements of a mesh. If it reaches few, they are listed, so that the next front clears only these.
struct Front_marks
{
  std::vector<char> vertex_state, face_state; // bits of Wavefront_state; 0: the front has not been there
  std::vector<char> is_finalized;             // true for finalized faces; read by all parts
  std::vector<Index> reached_in;              // of Pending_faces
  std::vector<Index> vertices, faces;         // those with marks, if
  bool are_listed = false;                    // all of them are in these lists

  // Longer lists do not pay: to propagate a face costs more than to pass over 64 faces.
  static std::size_t most_listed(std::size_t number_of_faces) { return 64 + number_of_faces / 64; }

  // Removes all marks.
  void clear(std::size_t number_of_vertices, std::size_t number_of_faces)
  {
    if (are_listed)
    {
      for (const Index v : vertices) vertex_state[v] = 0;
      for (const Index f : faces) face_state[f] = is_finalized[f] = 0;
    }
    else
    {
      vertex_state.assign(number_of_vertices, 0);
      face_state.assign(number_of_faces, 0);
      is_finalized.assign(number_of_faces, 0);
    }
    vertices.clear();
    faces.clear();
  }
};

template <class FT>
class Geodesic_field
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  FT maximum = Number_policy<FT>::infinity(); // distances up to this value are final after the build
  std::vector<FT> distance;                   // per vertex
  std::vector<Backtrace<FT>> back;            // per vertex
  std::map<Index, FT> path_length;            // of vertices near sources, see Near_path.h
  std::vector<Source_ref> source_ref;         // per vertex
  std::vector<double> error;                  // per vertex, with bounded error: largest excess of the true distance
  Window_lists<FT> lists;                     // of halfedges in the front
  Kept_windows<FT> kept;                      // of finalized faces, if kept
  Start_values<FT> start_values;              // of the source primitives
  bool keeps_memory = false;                  // of the front, for the next one on the same mesh
  bool has_grown = false;                     // by sources that were added later: the marks are those of the last one
  Front_marks marks;                          // of the last front, if its memory is kept

  // Initializes from another field and its windows. `other` must stay valid until release_front().
  void start_from(const Geodesic_field& other, const Start_values<FT>& starts)
  {
    distance = other.distance;
    back = other.back;
    source_ref = other.source_ref;
    kept = other.kept;
    set_start_values(starts);
    m_mesh = other.m_mesh;
    m_before = &other;
    m_add_earlier = &Geodesic_field::add_earlier_windows; // compiled only with updates
  }

  // Sets all distances to infinity. Takes the time of what a front has reached that has kept its memory on the same mesh.
  void clear(const Unfolded_mesh<FT>& mesh, const Start_values<FT>& starts)
  {
    m_mesh = &mesh;
    if (marks.are_listed && !has_grown)
    {
      for (const Index v : marks.vertices)
      {
        distance[v] = Number_policy<FT>::infinity();
        back[v] = Backtrace<FT>();
        source_ref[v] = Source_ref();
      }
      kept.clear(marks.faces);
    }
    else
    {
      distance.assign(mesh.number_of_vertices(), Number_policy<FT>::infinity());
      back.assign(mesh.number_of_vertices(), Backtrace<FT>());
      source_ref.assign(mesh.number_of_vertices(), Source_ref());
      kept = Kept_windows<FT>();
    }
    has_grown = false;
    path_length.clear();
    set_start_values(starts);
  }

  void release_front()
  {
    m_before = nullptr;
    m_add_earlier = nullptr;
    if (keeps_memory) return lists.reset(m_mesh->number_of_halfedges(), Front_parts());
    lists = Window_lists<FT>();
    kept.tidy();
  }

  // List of a halfedge. A new list starts with the windows of the earlier field, marked as propagated at the distances that
  // their pseudo-sources had in that field.
  Window_list<FT>& list(Index h) { return list(h, lists.arena(0)); }
  Window_list<FT>& list(Index h, typename Window_lists<FT>::Arena& arena)
  {
    if (Window_list<FT>* const known = lists.find(h)) return *known;
    Window_list<FT>& list = lists.create(h);
    if (BOOST_UNLIKELY(m_add_earlier != nullptr)) (this->*m_add_earlier)(h, list, arena);
    return list;
  }

  // With bounded error: that of the distance of a vertex or window with the given origin. If the distance of a pseudo-source has
  // decreased since, its new error is valid for the old distance too.
  double error_of_origin(Index origin) const
  {
    while (origin != no_index && !Merge_error_code::is_merged(origin)) origin = back[origin].pseudo_source;
    return origin == no_index ? 0 : Merge_error_code::error(origin);
  }

  // The distance of a vertex as the result of a query: near a source, the length of the path.
  const FT& distance_of_path(Index v) const
  {
    if (BOOST_LIKELY(path_length.empty())) return distance[v];
    const auto found = path_length.find(v);
    return found == path_length.end() ? distance[v] : found->second;
  }

  // True for a vertex whose shortest path has no length: it is a point of its nearest source.
  bool is_source(Index v) const
  {
    if (back[v].corner == no_index) return Number_policy<FT>::is_finite(distance[v]);
    return distance[v] == start_values.of(source_ref[v]);
  }

  // Source reference of a path through v. At a corner of a polyline, which lies on both sides, an equally long path with the
  // reference `known` keeps its side.
  Source_ref source_ref_via(Index v, Source_ref known) const
  {
    const bool is_corner = source_ref[v].is_lateral() && distance[v] == start_values.of(source_ref[v]);
    return is_corner && known.is_valid() && known.is_lateral()
           ? Source_ref(source_ref[v].primitive(), known.side())
           : source_ref[v];
  }

  // Calls f(window) for each final window of a halfedge, in order.
  template <class Function>
  void for_each_window(const Unfolded_mesh<FT>& mesh, Index h, const Function& f) const
  {
    if (lists.has(h))
    {
      const Window_list<FT>& list = lists.get(h);
      for (const auto& w : list.propagated) f(restored(w, mesh[h].length));
    }
    else kept.for_each(h, mesh[h].length, distance, source_ref, f);
  }

  void set_start_values(const Start_values<FT>& starts)
  {
    start_values = starts;
    kept.set_start_values(starts);
  }

private:
  // Out of line: its window on the stack would align the stack frame of every append.
  BOOST_NOINLINE void add_earlier_windows(Index h, Window_list<FT>& list, typename Window_lists<FT>::Arena& arena)
  {
    kept.for_each(h, (*m_mesh)[h].length, m_before->distance, m_before->source_ref, [&](const Window& w) {
      lists.replace(h, list, list.propagated.size, list.propagated.size, &w, &w + 1, arena);
    });
  }

  const Unfolded_mesh<FT>* m_mesh = nullptr; // until release_front()
  const Geodesic_field* m_before = nullptr;
  void (Geodesic_field::*m_add_earlier)(Index, Window_list<FT>&, typename Window_lists<FT>::Arena&) = nullptr;
};

} // namespace CGAL::Geodesic_offset::internal

#endif
