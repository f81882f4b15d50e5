<?xml version="1.0" encoding="UTF-8" standalone="yes"?>
<!-- Copyright (c) 2026 The Surface_mesh_geodesic_offset developers. -->
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- The anchors of CGAL's manual that PackageDescription.txt refers to, for Doxyfile_without_CGAL.in. -->
<tagfile>
  <compound kind="page">
    <name>packages</name>
    <title>Package Overview</title>
    <filename>packages</filename>
    <docanchor file="packages.html" title="CGAL and the Boost Graph Library">PkgBGL</docanchor>
    <docanchor file="packages.html" title="Polygon Mesh Processing">PkgPolygonMeshProcessing</docanchor>
    <docanchor file="packages.html" title="3D Fast Intersection and Distance Computation">PkgAABBTree</docanchor>
    <docanchor file="packages.html" title="2D and 3D Linear Geometry Kernel">PkgKernel23</docanchor>
  </compound>
  <compound kind="page">
    <name>license</name>
    <title>License</title>
    <filename>license</filename>
    <docanchor file="license.html" title="GPL">licensesGPL</docanchor>
  </compound>
</tagfile>
