// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Metafunctions for the traits, and for the property maps of the mesh type. A mesh type needs a map only if no named parameter
// gives one.

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_OWN_MAPS_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_INTERNAL_SURFACE_OWN_MAPS_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh/Surface_mesh_fwd.h>
#include <CGAL/boost/graph/named_params_helper.h>
#include <CGAL/boost/graph/properties.h>

#include <type_traits>

namespace CGAL {

template <class K, class TriangleMesh>
class Surface_mesh_geodesic_offset_traits;

namespace Geodesic_offset {
namespace internal {

template <class Traits>
constexpr void refuse_traits()
{
  static_assert(!std::is_same<Traits, Traits>::value,
                "Surface_mesh_geodesic_offset: the first template argument must be traits, a model of "
                "SurfaceMeshGeodesicOffsetTraits, such as Surface_mesh_geodesic_offset_traits<Kernel, Mesh>");
}

// The traits, if they are any. Otherwise traits for which all else compiles, so that the one message is not lost among others.
template <class Traits, class = void>
struct Checked_traits
{
  typedef Exact_predicates_inexact_constructions_kernel Epick;
  typedef std::enable_if_t<(refuse_traits<Traits>(), true),
                           Surface_mesh_geodesic_offset_traits<Epick, Surface_mesh<Epick::Point_3>>>
    type;
};

template <class Traits>
struct Checked_traits<Traits, std::void_t<typename Traits::Triangle_mesh>>
{
  typedef Traits type;
};

template <class TriangleMesh>
struct Own_vertex_index_map
{
  typedef typename GetInitializedVertexIndexMap<TriangleMesh>::const_type type;
};

template <class TriangleMesh>
struct Own_face_index_map
{
  typedef typename GetInitializedFaceIndexMap<TriangleMesh>::const_type type;
};

template <class TriangleMesh>
struct Own_vertex_point_map
{
  typedef typename boost::property_map<TriangleMesh, boost::vertex_point_t>::const_type type;
};

} // namespace internal
} // namespace Geodesic_offset
} // namespace CGAL

#endif
