// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is known of the distance field: at the vertices always, on the edges as long as the front is there or if the windows
// are kept.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_GEODESIC_FIELD_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_FIELD_GEODESIC_FIELD_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/field/Kept_windows.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/front/Window_lists.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Unfolded_mesh.h>

#include <vector>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The beginning of the shortest path from a vertex: in which direction, and how far straight on, that is up to the
// pseudo-source; if there is none, up to the source.
template <class FT>
struct Way_back
{
  Index corner = no_index; // none at a source, and where the distance is infinite
  Index pseudo_source = no_index;
  FT x = FT(0), y = FT(0);

  Way_back() = default;
  Way_back(const Ray_at_vertex<FT>& ray, Index vertex)
    : corner(ray.corner), pseudo_source(vertex), x(ray.x), y(ray.y)
  {
  }
  Ray_at_vertex<FT> ray() const { return {corner, x, y}; }
};

template <class FT>
class Geodesic_field
{
public:
  typedef CGAL::Geodesic_offset::internal::Window<FT> Window;

  FT maximum = Number_policy<FT>::infinity(); // up to this distance all is final, or will be
  std::vector<FT> distance;       // per vertex
  std::vector<Way_back<FT>> back; // per vertex
  std::vector<Root> root;         // per vertex
  std::vector<char> has_margins;  // per vertex: whether it sends rays into the margins of its sectors
  std::vector<double> error;      // per vertex, if windows were merged within a tolerance: how much too small it may be
  Window_lists<FT> lists;         // of the halfedges where the front is
  Kept_windows<FT> kept;          // of the faces that it has passed, if they are kept

  // Starts with what another field says, and on its windows; it must live until the front has gone.
  void start_from(const Geodesic_field& other)
  {
    distance = other.distance;
    back = other.back;
    root = other.root;
    has_margins = other.has_margins;
    kept = other.kept;
    m_before = &other;
  }

  // All of the surface at infinity.
  void clear(const Unfolded_mesh<FT>& mesh)
  {
    distance.assign(mesh.number_of_vertices(), Number_policy<FT>::infinity());
    back.assign(mesh.number_of_vertices(), Way_back<FT>());
    root.assign(mesh.number_of_vertices(), Root());
    has_margins.assign(mesh.number_of_vertices(), 0);
    kept = Kept_windows<FT>();
  }

  void release_front()
  {
    lists = Window_lists<FT>();
    m_before = nullptr;
    kept.tidy();
  }

  // The list of a halfedge, with the windows that were there before. They have been propagated from pseudo-sources at the
  // distances that these had then.
  Window_list<FT>& list(Index h) { return list(h, lists.arena(0)); }
  Window_list<FT>& list(Index h, Window_arena<Window>& arena)
  {
    if (Window_list<FT>* const known = lists.find(h)) return *known;
    Window_list<FT>& list = lists.create(h);
    if (!m_before) return list;
    kept.for_each(h, m_before->distance, m_before->root, [&](const Window& w) {
      lists.append(h, list, &w, 1, arena);
      list.data[list.taken++].set_propagated();
    });
    return list;
  }

  // The root of a path that leads to v, in place of one with the root `known` that is as long: corners of polylines are on both
  // sides of them.
  Root root_by_way_of(Index v, Root known) const
  {
    const bool is_corner = CGAL::is_zero(distance[v]) && root[v].is_lateral();
    return is_corner && known.is_valid() && known.is_lateral() ? Root(root[v].primitive(), known.side()) : root[v];
  }

  // Calls f(window) for each window that is final on a halfedge, in order.
  template <class Function>
  void for_each_window(Index h, const Function& f) const
  {
    if (lists.has(h))
    {
      const Window_list<FT>& list = lists.get(h);
      for (Index i = 0; i < list.taken; ++i) f(list.data[i]);
    }
    else
      kept.for_each(h, distance, root, f);
  }

private:
  const Geodesic_field* m_before = nullptr;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
