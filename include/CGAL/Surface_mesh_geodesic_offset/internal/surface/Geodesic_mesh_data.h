// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The data that copies of a Geodesic_mesh share: surface, locator and traits; classification of locations.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_GEODESIC_MESH_DATA_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_GEODESIC_MESH_DATA_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/Geodesic_surface.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/point_conversion.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/mesh/Surface_locator.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/workers/Concurrency.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <array>
#include <list>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace CGAL::Geodesic_offset::internal {

// The map as the type that the class has for it.
template <class Map, class Given>
Map converted_map(const Given& map)
{
  static_assert(std::is_convertible<const Given&, Map>::value,
                "Surface_mesh_geodesic_offset: the type of a map must be given as a template parameter of the class");
  return map;
}

template <class Surface_>
struct Geodesic_mesh_data
{
  typedef Surface_ Surface;
  typedef typename Surface::Traits Traits;
  typedef typename Surface::Computing_traits Computing_traits;
  typedef typename Surface::Number Number;
  typedef internal::Surface_point<Number> Surface_point;
  typedef internal::Located_point<Number> Located_point;
  typedef internal::Surface_locator<Space_kernel<typename Surface::Kernel>, Number> Locator;
  typedef typename Surface::Graph_traits Graph_traits;
  typedef typename Surface::vertex_descriptor vertex_descriptor;
  typedef typename Surface::face_descriptor face_descriptor;

  template <class VertexIndexMap, class FaceIndexMap, class VertexPointMap, class NamedParameters>
  Geodesic_mesh_data(const typename Surface::Triangle_mesh& tm, const VertexIndexMap& vim, const FaceIndexMap& fim,
                     const VertexPointMap& vpm, const NamedParameters& np)
    : Geodesic_mesh_data(tm, vim, fim, vpm, traits_of(np), np)
  {
  }

  Geodesic_mesh_data(const Geodesic_mesh_data&) = delete;
  Geodesic_mesh_data& operator=(const Geodesic_mesh_data&) = delete;

  const Surface& surface() const { return *shared_surface; }

  // \throws std::logic_error if the mesh has lengths instead of points
  const Surface& surface_with_points() const
  {
    surface().check_points();
    return *shared_surface;
  }

  const Locator& locator() const
  {
    surface_with_points();
    std::call_once(m_locator_once, [this] { m_locator = std::make_shared<Locator>(unfolded().without_barriers(), surface()); });
    return *static_cast<const Locator*>(m_locator.get());
  }

  const Unfolded_mesh<Number>& unfolded() const { return surface().unfolded; }

  // The memory of a build for the next one: a list of one Geodesic_build, or of a null pointer. It is to be given back.
  std::list<std::shared_ptr<void>> take_memory() const
  {
    const std::lock_guard<std::mutex> lock(m_memory_mutex);
    std::list<std::shared_ptr<void>> result;
    if (m_memory.empty()) result.emplace_back();
    else result.splice(result.begin(), m_memory, m_memory.begin());
    return result;
  }
  void give_back_memory(std::list<std::shared_ptr<void>>& memory) const
  {
    const std::lock_guard<std::mutex> lock(m_memory_mutex);
    m_memory.splice(m_memory.begin(), memory);
  }

  // \throws std::invalid_argument if the vertex is null, removed or of another mesh
  Located_point classified(vertex_descriptor v) const
  {
    Surface_point p = Surface_point::at_vertex(surface().checked_index_of(v));
    p.is_any_copy = true;
    return p;
  }

  // Coordinates of another number type are converted.
  template <class Coordinate>
  Located_point classified(const std::pair<face_descriptor, std::array<Coordinate, 3>>& l) const
  {
    return surface().classified(converted_location<typename Surface::FT>(l));
  }

  // Chosen for points in space.
  template <class Point, class = std::enable_if_t<is_point_in_space<Point>>>
  Located_point classified(const Point&) const
  {
    static_assert(!is_point_in_space<Point>, CGAL_GEODESIC_OFFSET_NEEDS_LOCATION);
    return Surface_point::at_vertex(0);
  }

  Computing_traits traits;
  std::shared_ptr<const Surface> shared_surface;

private:
  template <class NamedParameters>
  static Traits traits_of(const NamedParameters& np)
  {
    if constexpr (has_parameter<internal_np::geom_traits_t, NamedParameters>)
      return parameters::get_parameter(np, internal_np::geom_traits);
    else return (void)np, Traits();
  }

  template <class VertexIndexMap, class FaceIndexMap, class VertexPointMap, class NamedParameters>
  Geodesic_mesh_data(const typename Surface::Triangle_mesh& tm, const VertexIndexMap& vim, const FaceIndexMap& fim,
                     const VertexPointMap& vpm, const Traits& user_traits, const NamedParameters& np)
    : traits(Computation<Traits>::computing_traits(user_traits))
  {
    static_assert(
      has_core_functions<Computing_traits>,
      "Surface_mesh_geodesic_offset: the compiled library has the functions for kernels on double. With other number "
      "types, or traits with functors of their own, include "
      "<CGAL/Surface_mesh_geodesic_offset/core_definitions.h> first, or link the target without ::compiled");
    typedef Concurrency_tag_of<NamedParameters> Tag;
    static_assert(std::is_convertible<Tag, Sequential_tag>::value,
                  "Surface_mesh_geodesic_offset: concurrency_tag() needs a concurrency tag");
    {
      auto&& team = Concurrency<Tag, Number>::Team::make();
      shared_surface = std::make_shared<Surface>(
        tm, vim, fim, vpm,
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::geodesic_edge_length_map), No_lengths()),
        parameters::choose_parameter(parameters::get_parameter(np, internal_np::edge_is_constrained), No_barriers()),
        user_traits, team);
    }
  }

  // Made by the first location, so that the locator is compiled only where it is used.
  mutable std::once_flag m_locator_once;
  mutable std::shared_ptr<const void> m_locator; // a Locator
  mutable std::mutex m_memory_mutex;
  mutable std::list<std::shared_ptr<void>> m_memory; // of builds
};

// Tag: the named parameters may be more than those of a mesh.
struct More_parameters
{
};

// Access of the other classes of the package to the data of a mesh.
struct Mesh_access
{
  template <class Mesh, class NamedParameters>
  static Mesh make(const typename Mesh::Triangle_mesh& tm, const NamedParameters& np)
  {
    return Mesh(tm, np, More_parameters());
  }

  template <class Mesh>
  static const typename Mesh::Data& data(const Mesh& mesh)
  {
    return mesh.data();
  }

  template <class Mesh>
  static typename Mesh::Surface surface_type(const Mesh*);
};

template <class Mesh>
using Surface_of = decltype(Mesh_access::surface_type(static_cast<const Mesh*>(nullptr)));

// Access of the other classes of the package to the build of a field.
struct Field_access
{
  template <class Field, class Mesh, class Build>
  static Field make(const Mesh& mesh, Build&& build)
  {
    return Field(mesh, std::forward<Build>(build));
  }

  template <class Field>
  static const auto& shared_build(const Field& field)
  {
    return field.m_build;
  }
};

} // namespace CGAL::Geodesic_offset::internal

#endif
