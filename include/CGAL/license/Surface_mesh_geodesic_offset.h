// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_SURFACE_MESH_GEODESIC_OFFSET_H
#define CGAL_LICENSE_SURFACE_MESH_GEODESIC_OFFSET_H

// Every header of the package includes this file, as every header of a CGAL package includes the
// file of its package under CGAL/license/. Those files warn users of a commercial CGAL licence that
// does not cover a package. This package is offered under the GPL only, so there is no macro to
// test: whoever uses CGAL under a commercial licence gets no right to this package from it.

#endif // CGAL_LICENSE_SURFACE_MESH_GEODESIC_OFFSET_H
