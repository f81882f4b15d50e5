// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

#ifndef CGAL_LICENSE_RADICAL_NUMBER_H
#define CGAL_LICENSE_RADICAL_NUMBER_H

// Every header of the package includes this file, as in CGAL. The package is offered under the GPL only, so there is no macro
// of a commercial licence to test.

#endif // CGAL_LICENSE_RADICAL_NUMBER_H
