// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_MESH_TYPE_H
#define CGAL_SURFACE_MESH_GEODESIC_OFFSET_GEODESIC_MESH_TYPE_H

#include <CGAL/license/Surface_mesh_geodesic_offset.h>

#include <CGAL/Surface_mesh_geodesic_offset/Geodesic_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_offset_traits.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/surface/own_maps.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/numbers/Number_policy.h>
#include <CGAL/Surface_mesh_geodesic_offset/internal/parameters/named_parameters.h>

#include <CGAL/Default.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Kernel_traits.h>
#include <CGAL/boost/graph/named_params_helper.h>

#include <boost/property_map/property_map.hpp>

#include <type_traits>

namespace CGAL {
namespace Geodesic_offset {
namespace internal {

// The types that free functions use for a mesh and a sequence of named parameters. The kernel is that of the points; if it has
// no square roots, as an exact one, the points are converted.
template <class TriangleMesh, class NamedParameters>
struct Types_of_call
{
  typedef typename Default::Lazy_get<Parameter_type<internal_np::vertex_point_t, NamedParameters, Default>,
                                     Own_vertex_point_map<TriangleMesh>>::type Point_map;
  typedef typename Kernel_traits<typename boost::property_traits<Point_map>::value_type>::Kernel Mesh_kernel;
  typedef std::conditional_t<has_square_roots<typename Mesh_kernel::FT>(), Mesh_kernel,
                             Exact_predicates_inexact_constructions_kernel>
    Kernel;
  template <class K>
  struct Traits_for
  {
    typedef Surface_mesh_geodesic_offset_traits<K, TriangleMesh> type;
  };
  typedef Parameter_type<internal_np::geom_traits_t, NamedParameters, typename Traits_for<Kernel>::type> Traits;
  typedef Geodesic_mesh<Traits, Parameter_type<internal_np::vertex_index_t, NamedParameters, Default>,
                        Parameter_type<internal_np::face_index_t, NamedParameters, Default>,
                        Parameter_type<internal_np::vertex_point_t, NamedParameters, Default>>
    Mesh;
};

} // namespace internal
} // namespace Geodesic_offset

/*!
\ingroup PkgSurfaceMeshGeodesicOffsetFunctions

\brief is the instance of `Geodesic_mesh` that free functions use for a triangle mesh: with the maps of the mesh, and with the
kernel of its points, or `Exact_predicates_inexact_constructions_kernel` if the number type of this kernel has no square roots.

\tparam TriangleMesh a model of `FaceListGraph`
\tparam NamedParameters the type of the named parameters of the call, which may have other maps and traits
*/
template <class TriangleMesh, class NamedParameters = parameters::Default_named_parameters>
#ifdef DOXYGEN_RUNNING
using Geodesic_mesh_type = Geodesic_mesh<unspecified_type>;
#else
using Geodesic_mesh_type = typename Geodesic_offset::internal::Types_of_call<TriangleMesh, NamedParameters>::Mesh;
#endif

} // namespace CGAL

#endif
