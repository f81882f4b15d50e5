// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Offset curves on a mesh of OpenMesh, whose points have coordinates of type double.

#include <OpenMesh/Core/IO/MeshIO.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <CGAL/boost/graph/graph_traits_TriMesh_ArrayKernelT.h>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh_geodesic_offset.h>

#include <iostream>
#include <iterator>
#include <string>
#include <vector>

struct Mesh_traits : OpenMesh::DefaultTraits
{
  typedef OpenMesh::Vec3d Point;
};
typedef OpenMesh::TriMesh_ArrayKernelT<Mesh_traits> Mesh;
typedef CGAL::Exact_predicates_inexact_constructions_kernel Kernel;
typedef CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Mesh> Traits;
typedef CGAL::Surface_mesh_geodesic_offset<Traits> Geodesic;

int main(int argc, char* argv[])
{
  const std::string filename = argc > 1 ? argv[1] : CGAL::data_file_path("meshes/elephant.off");
  Mesh mesh;
  if(!OpenMesh::IO::read_mesh(mesh, filename) || mesh.n_faces() == 0)
  {
    std::cerr << "Not a triangle mesh: " << filename << std::endl;
    return 1;
  }

  Geodesic geodesic(mesh);
  geodesic.add_source_point(*vertices(mesh).begin());
  geodesic.build(CGAL::parameters::keep_windows(true));
  std::vector<Geodesic::Offset_curve> curves;
  geodesic.offset_curves(geodesic.farthest_point()->second / 2, std::back_inserter(curves));
  std::cout << curves.size() << " offset curves half way to the farthest point" << std::endl;
  return 0;
}
