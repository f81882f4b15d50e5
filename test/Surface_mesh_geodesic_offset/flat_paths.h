// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Random polylines on a generated mesh, made of legs that are straight in the plane of a flat patch.

#ifndef GEODESIC_OFFSET_TEST_FLAT_PATHS_H
#define GEODESIC_OFFSET_TEST_FLAT_PATHS_H

#include "closed_forms.h"
#include "locations.h"

#include <vector>

namespace test {

/// A polyline for the library (`locations`, consecutive ones in a common face) and for the closed forms (`legs`, one per
/// straight part, however many faces it crosses).
template <class TriangleMesh>
struct Flat_path
{
  std::vector<typename Locations<TriangleMesh>::Face_location> locations;
  std::vector<Leg> legs;
};

/// Random locations and straight legs on a generated mesh.
template <class TriangleMesh>
class Flat_path_generator
{
public:
  typedef Generated_mesh<TriangleMesh> Mesh_data;
  typedef test::Locations<TriangleMesh> Locations;
  typedef typename Locations::vertex_descriptor vertex_descriptor;
  typedef typename Locations::halfedge_descriptor halfedge_descriptor;
  typedef typename Locations::face_descriptor face_descriptor;
  typedef typename Locations::Face_location Face_location;
  typedef typename Locations::Barycentric_coordinates Barycentric_coordinates;
  typedef test::Flat_path<TriangleMesh> Path;

  Flat_path_generator(const Mesh_data& data, unsigned seed) : data_(data), locations_(data.mesh), random_(seed)
  {
    for (std::size_t i = 0; i < data.faces.size(); ++i)
    {
      if (data.patches[i] >= faces_of_patch_.size()) faces_of_patch_.resize(data.patches[i] + 1);
      faces_of_patch_[data.patches[i]].push_back(data.faces[i]);
    }
  }

  /// Coordinates of a location in a patch that contains it.
  Point_2 uv(const Face_location& location, std::size_t patch) const
  {
    for (face_descriptor f : locations_.incident_faces(location))
      if (patch_of(f) == patch) return uv_in_face(location, f);
    throw std::logic_error("the location is not in the patch");
  }

  std::size_t patch_of(face_descriptor f) const { return data_.patches[data_.face_number(f)]; }

  /// Leg of length zero: a patch that contains the location, and the coordinates there.
  Leg leg_at(const Face_location& location) const
  {
    const std::size_t patch = patch_of(location.first);
    const Point_2 p = uv(location, patch);
    return Leg{patch, p, p};
  }

  /// In a face, on an edge or at a vertex of the patch, with equal probabilities.
  Face_location random_location(std::size_t patch)
  {
    const std::vector<face_descriptor>& faces = faces_of_patch_[patch];
    const face_descriptor f = faces[uniform_index(random_, faces.size())];
    halfedge_descriptor h = halfedge(f, data_.mesh);
    for (std::size_t turns = uniform_index(random_, 3); turns > 0; --turns) h = next(h, data_.mesh);
    switch (uniform_index(random_, 3))
    {
    case 0: return Face_location(f, random_barycentric(random_));
    case 1: return locations_.on_edge(h, uniform(random_, 0.02, 0.98));
    default: return locations_.at_vertex(target(h, data_.mesh), uniform_index(random_, 8));
    }
  }

  std::size_t random_patch() { return uniform_index(random_, faces_of_patch_.size()); }

  /// A polyline of `count` legs from patch to patch; every fourth leg is a zigzag within one face. A closed polyline stays
  /// in one patch, which must be convex so that it contains the closing leg.
  Path random_path(std::size_t count, bool closed = false)
  {
    for (std::size_t attempts = 0; attempts < 100; ++attempts)
    {
      std::size_t patch = random_patch();
      const Path path = random_open_path(count, patch, closed);
      if (path.legs.empty() || (closed && path.legs.size() < 2)) continue;
      if (!closed) return path;
      Path loop = path;
      if (add_leg(loop, path.locations.front(), patch))
      {
        loop.locations.pop_back(); // closed polylines do not repeat their first location
        return loop;
      }
    }
    throw std::logic_error("no path was found");
  }

  /// Appends the straight leg to `target` within `patch`; returns false without a change if the leg leaves the patch.
  bool add_leg(Path& path, const Face_location& target, std::size_t patch) const
  {
    const Point_2 a = uv(path.locations.back(), patch), b = uv(target, patch);
    if (a == b) return false;
    std::vector<Face_location> steps;
    if (!walk(path.locations.back(), target, a, b, patch, steps)) return false;
    path.locations.insert(path.locations.end(), steps.begin(), steps.end());
    path.legs.push_back(Leg{patch, a, b});
    return true;
  }

  const Locations& locations() const { return locations_; }
  Random& random() { return random_; }

private:
  Point_2 uv_in_face(const Face_location& location, face_descriptor f) const
  {
    Barycentric_coordinates w;
    locations_.express(location, f, w);
    const std::array<Point_2, 3>& corners = data_.uv[data_.face_number(f)];
    return Point_2(w[0] * corners[0].x() + w[1] * corners[1].x() + w[2] * corners[2].x(),
                   w[0] * corners[0].y() + w[1] * corners[1].y() + w[2] * corners[2].y());
  }

  // Another patch at the location if there is one.
  std::size_t leave(const Face_location& location, std::size_t patch) const
  {
    for (face_descriptor f : locations_.incident_faces(location))
      if (patch_of(f) != patch) return patch_of(f);
    return patch;
  }

  // Without closing leg; changes `patch` whenever possible unless `one_patch`.
  Path random_open_path(std::size_t count, std::size_t patch, bool one_patch)
  {
    Path path;
    path.locations.push_back(random_location(patch));
    for (std::size_t attempts = 0; path.legs.size() < count && attempts < 50 * count; ++attempts)
    {
      const Face_location last = path.locations.back();
      const bool zigzag = path.legs.size() % 4 == 3;
      if (zigzag && !one_patch) patch = patch_of(last.first);
      const Face_location target =
        (zigzag && patch_of(last.first) == patch)
          ? Face_location(last.first, random_barycentric(random_))
          : random_location(patch);
      if (add_leg(path, target, patch) && !one_patch) patch = leave(target, patch);
    }
    return path;
  }

  // The locations after `from` where the straight segment to `to` meets edges, and `to`.
  bool walk(const Face_location& from, const Face_location& to, const Point_2& a, const Point_2& b, std::size_t patch,
            std::vector<Face_location>& steps) const
  {
    Face_location current = from;
    Barycentric_coordinates w;
    for (std::size_t count = 0; count < 100000; ++count)
    {
      bool advanced = false;
      for (face_descriptor f : locations_.incident_faces(current))
      {
        if (patch_of(f) != patch) continue;
        if (locations_.express(to, f, w))
        {
          steps.push_back(Face_location(f, w));
          return true;
        }
      }
      for (face_descriptor f : locations_.incident_faces(current))
      {
        if (patch_of(f) != patch || (count > 0 && f == current.first)) continue;
        Face_location exit;
        if (!exit_of(current, f, a, b, exit)) continue;
        // The exit is described in the face just crossed.
        steps.push_back(exit);
        current = exit;
        advanced = true;
        break;
      }
      if (!advanced) return false;
    }
    return false;
  }

  // Exit from face f of the ray from the current location towards b, if the ray enters f.
  bool exit_of(const Face_location& current, face_descriptor f, const Point_2& a, const Point_2& b, Face_location& exit) const
  {
    Barycentric_coordinates w;
    locations_.express(current, f, w);
    const std::array<Point_2, 3>& corners = data_.uv[data_.face_number(f)];
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3; // the edge from i to j, opposite k
      if (w[k] == 0) continue;                            // the location is on this edge
      const bool i_right = CGAL::orientation(a, b, corners[i]) == CGAL::RIGHT_TURN;
      const bool j_left = CGAL::orientation(a, b, corners[j]) == CGAL::LEFT_TURN;
      if (!i_right || !j_left) continue;
      const Vector_2 ab = b - a;
      const Vector_2 ai = corners[i] - a, aj = corners[j] - a;
      const double ci = std::abs(ab.x() * ai.y() - ab.y() * ai.x()), cj = std::abs(ab.x() * aj.y() - ab.y() * aj.x());
      const double t = ci / (ci + cj);
      if (!(t > 0 && t < 1)) return false;
      exit.first = f;
      exit.second = {{0, 0, 0}};
      exit.second[i] = 1 - t;
      exit.second[j] = t;
      return true;
    }
    return false;
  }

  const Mesh_data& data_;
  Locations locations_;
  Random random_;
  std::vector<std::vector<face_descriptor>> faces_of_patch_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_FLAT_PATHS_H
