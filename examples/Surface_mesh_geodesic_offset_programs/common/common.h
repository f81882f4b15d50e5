// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Types shared by the programs.

#ifndef GEODESIC_OFFSET_COMMON_H
#define GEODESIC_OFFSET_COMMON_H

#include "messages.h"
#include "soup.h"

#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <limits>

namespace geodesic_offset {

using Vector = Kernel::Vector_3;
using Mesh = CGAL::Surface_mesh<Point>;
using Traits = CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh>;
using Geodesic = CGAL::Surface_mesh_geodesic_offset<Traits>;

using Geodesic_mesh = Geodesic::Mesh; // locates points

using Vertex = Mesh::Vertex_index;
using Halfedge = Mesh::Halfedge_index;
using Edge = Mesh::Edge_index;
using Face = Mesh::Face_index;
using Face_location = Geodesic::Face_location;
using Offset_curve = Geodesic::Offset_curve;

constexpr double infinity = std::numeric_limits<double>::infinity();

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_COMMON_H
