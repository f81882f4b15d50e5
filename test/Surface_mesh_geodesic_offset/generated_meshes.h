// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// All generators of test meshes: each returns a `Soup`, from which `Generated_mesh<TriangleMesh>` builds the mesh.

#ifndef GEODESIC_OFFSET_TEST_GENERATED_MESHES_H
#define GEODESIC_OFFSET_TEST_GENERATED_MESHES_H

#include "generated_curved_meshes.h"
#include "generated_flat_meshes.h"
#include "generated_soup.h"

#endif // GEODESIC_OFFSET_TEST_GENERATED_MESHES_H
