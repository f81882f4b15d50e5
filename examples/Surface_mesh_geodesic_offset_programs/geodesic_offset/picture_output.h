// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// From a build to its picture.

#ifndef GEODESIC_OFFSET_PICTURE_OUTPUT_H
#define GEODESIC_OFFSET_PICTURE_OUTPUT_H

#include "common/common.h"
#include "common/face_distances.h"
#include "common/picture.h"
#include "common/sources.h"
#include "common/view.h"
#include "options.h"
#include "paths.h"
#include "progress.h"
#include "threads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <map>
#include <vector>

namespace geodesic_offset {
namespace internal {

// 2 GB for a picture, at 40 bytes per window
constexpr std::size_t most_kept_windows = 50000000;

inline View view_of(const Options& options, const Mesh& mesh, const Sources& sources)
{
  const auto vector = [](const std::array<double, 3>& v) {
    return View::normalized(Vector(v[0], v[1], v[2]) / std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])}));
  };
  const Vector up = options.up ? vector(*options.up) : Vector(0, 1, 0);
  if(options.view) return View(vector(*options.view), up);
  std::vector<Point> points = sources.points();
  for(const Polyline& polyline : sources.polylines()) points.insert(points.end(), polyline.begin(), polyline.end());
  return choose_view(mesh, points, up);
}

// If some faces are too large for interpolation, builds again with kept windows unless the last build has them.
inline Face_distances face_distances(Geodesic& geodesic, const Mesh_input& input, const Options& options, double largest,
                                     Progress& progress)
{
  std::vector<Edge> barriers;
  for(Edge e : input.mesh().edges())
    if(input.has_barriers() && get(input.barriers(), e)) barriers.push_back(e);
  Face_distances distances(input.mesh(), geodesic, largest, barriers);
  if(!distances.need_windows() || options.needs_windows()) return distances;
  if(geodesic.statistics().windows_propagated > most_kept_windows)
  {
    progress.warning("the colours of " + quoted(options.picture) +
                     " are interpolated inside the large faces of the mesh: "
                     "with " +
                     std::to_string(geodesic.statistics().windows_propagated) +
                     " windows, exact ones would take too much memory");
    distances.interpolate_everywhere();
    return distances;
  }
  const auto show = [&](double done) {
    progress.show("distances inside faces", done);
    return true;
  };
  with_concurrency_tag(options.threads, [&](auto tag) {
    geodesic.build(CGAL::parameters::distance_limit(options.maximum_distance.value_or(infinity))
                     .keep_windows(true)
                     .relative_tolerance(options.relative_tolerance)
                     .merging_tolerance(options.merging_tolerance)
                     .visitor(show)
                     .concurrency_tag(tag));
  });
  return distances;
}

} // namespace internal

// `largest`: the largest distance of the surface. Precondition: the last build has all requested distances. May replace it
// by another build with the same distances.
inline Image picture_of(Geodesic& geodesic, const Mesh_input& input, const Sources& sources, const Options& options,
                        const std::vector<Offset_curve>& curves, const std::vector<Surface_path>& paths, double largest,
                        Progress& progress)
{
  const Mesh& mesh = input.mesh();
  const Face_distances distances = internal::face_distances(geodesic, input, options, largest, progress);
  const View view = internal::view_of(options, mesh, sources);
  const Picture_details& details = options.picture_details;
  Extent extent(mesh, view);
  CGAL::Bbox_3 box;
  for(Face f : mesh.faces())
    for(Vertex v : mesh.vertices_around_face(mesh.halfedge(f))) box += mesh.point(v).bbox();
  if(details.box) extent.add(box, view);
  Picture picture(mesh, distances, view, extent, Picture_size());
  if(details.box) picture.add_box(box);
  if(details.axes) picture.add_axes();
  if(details.boundaries)
    for(const auto& curve : geodesic.field().voronoi_diagram().curves())
    {
      Polyline polyline;
      curve.points(picture.chord_tolerance(), std::back_inserter(polyline));
      picture.add_boundary(polyline);
    }
  std::map<double, Polyline> at_distance;
  for(const Point& point : sources.points()) picture.add_source(point);
  for(const Polyline& polyline : sources.polylines()) picture.add_source(polyline);
  for(const Offset_curve& curve : curves)
  {
    Polyline polyline;
    curve.points(picture.chord_tolerance(), std::back_inserter(polyline));
    picture.add_offset(polyline);
    if(details.labels)
    {
      Polyline& points = at_distance[curve.distance()];
      points.insert(points.end(), polyline.begin(), polyline.end());
    }
  }
  if(details.labels)
  {
    const internal::Depth_probe probe(mesh, view);
    for(const auto& [distance, points] : at_distance)
      picture.add_label(distance, points, [&](const Point& p) { return probe.is_visible(view(p)); });
  }
  for(const Surface_path& path : paths) picture.add_path(path.points);
  for(Edge e : mesh.edges())
    if(input.has_barriers() && get(input.barriers(), e))
      picture.add_barrier({mesh.point(mesh.vertex(e, 0)), mesh.point(mesh.vertex(e, 1))});
  return picture.render([&](double done) { progress.show("picture", done); });
}

} // namespace geodesic_offset

#endif // GEODESIC_OFFSET_PICTURE_OUTPUT_H
