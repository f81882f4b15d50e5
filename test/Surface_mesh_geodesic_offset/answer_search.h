// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// A search for points whose answers do not agree: random meshes of many kinds with points, joined polylines, runs of collinear
// segments and edges as sources, or with sources that overlap and coincide. See answer_checker.h for what is checked.

#ifndef GEODESIC_OFFSET_TEST_ANSWER_SEARCH_H
#define GEODESIC_OFFSET_TEST_ANSWER_SEARCH_H

#include "answer_checker.h"
#include "generated_curved_meshes.h"
#include "generated_flat_meshes.h"

#include <boost/property_map/property_map.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <exception>
#include <map>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Results for the meshes of one kind.
struct Answer_counts
{
  std::size_t meshes = 0, queries = 0, points = 0, wrong = 0, exceptions = 0, wrong_polylines = 0;
  std::size_t faults[NUMBER_OF_ANSWER_FAULTS] = {};
  double worst_length = 0, worst_near_length = 0, worst_distance = 0;

  std::size_t total_wrong() const { return wrong + exceptions + wrong_polylines; }
};

class Answer_search
{
public:
  typedef Geodesic::Face_location Face_location;
  typedef Surface_mesh::Vertex_index Vertex_index;
  typedef Surface_mesh::Halfedge_index Halfedge_index;
  typedef Surface_mesh::Face_index Face_index;
  typedef std::map<std::size_t, Source> Sources_by_id;

  /// BESIDE: sources and points beside vertices, edges and each other, on meshes with faces of very different sizes. IN_FACES:
  /// polylines in faces, beside their edges.
  enum Sources { SPREAD, COINCIDING, BESIDE, IN_FACES };

  /// Up to `printed` faults are written to `log`; with `describes`, sources, query and path, too.
  Answer_search(std::ostream& log, std::size_t printed, std::size_t queries, Sources sources, bool describes = false)
    : log_(log), printed_(printed), queries_(queries), kind_of_sources_(sources), describes_(describes)
  {
  }

  /// Runs the case that a seed determines: a mesh, its sources and its queries.
  void run(unsigned seed)
  {
    random_.seed(seed);
    for (int i = 0; i < 8; ++i) random_();
    std::string kind;
    bool is_flat = false;
    const Soup soup = kind_of_sources_ == BESIDE ? make_hard_mesh(seed, kind, is_flat) : make_mesh(seed, kind, is_flat);
    Answer_counts& counts = counts_[kind];
    ++counts.meshes;
    context_ = kind + ", seed " + std::to_string(seed);
    const Generated_mesh<Surface_mesh> data(soup);
    mesh_ = &data.mesh;
    Answer_checker checker(data.mesh, is_flat, kind_of_sources_ == BESIDE);
    checker_ = &checker;
    try
    {
      run(counts);
    }
    catch (const std::exception& e)
    {
      ++counts.exceptions;
      print(e.what());
    }
    counts.points += checker.number_of_points;
    counts.worst_length = (std::max)(counts.worst_length, checker.worst_length);
    counts.worst_near_length = (std::max)(counts.worst_near_length, checker.worst_near_length);
    counts.worst_distance = (std::max)(counts.worst_distance, checker.worst_distance);
  }

  const std::map<std::string, Answer_counts>& counts() const { return counts_; }

private:
  Soup make_mesh(unsigned seed, std::string& kind, bool& is_flat)
  {
    const auto flat = [&](const char* name, const Soup& soup) {
      kind = name;
      is_flat = true;
      return soup;
    };
    const auto other = [&](const char* name, const Soup& soup) {
      kind = name;
      return soup;
    };
    const std::size_t size = uniform(random_) < 0.02 ? 6 : 1; // a few larger meshes
    const std::size_t n = size * (1 + uniform_index(random_, 6)), m = size * (1 + uniform_index(random_, 5));
    switch (uniform_index(random_, 17))
    {
    case 0:
      return flat("grids", planar_grid(n, m, uniform(random_) < 0.5 ? Diagonals::forward : Diagonals::random, 1, 0, seed));
    case 1: return flat("union flags", planar_grid(n, m, Diagonals::alternating));
    case 2: return flat("jittered grids", jittered_grid(n, m, seed));
    case 3: return flat("rectangles", random_rectangle(uniform(random_, 0.5, 2), 1, uniform_index(random_, 25), n, seed));
    case 4:
      return flat("needles", random_rectangle(1, std::pow(10, uniform(random_, -5, -1)), uniform_index(random_, 20), n, seed));
    case 5: return other("cones", Cone(3 + n, uniform(random_, 2, 6), 1).triangulated(n, m - 1, seed));
    case 6: return other("saddles", Cone(2 * (2 + n), uniform(random_, 6.5, 12), 1).triangulated(n, m - 1, seed));
    case 7: return other("open cones", Cone(3 + n, uniform(random_, 3, 9), 1, true).triangulated(m, m - 1, seed));
    case 8: return other("L shapes", l_shape(uniform_index(random_, 15), uniform_index(random_, 4), seed));
    case 9:
      return other("boxes", box_sides(1, uniform(random_, 0.1, 1), uniform(random_, 0.1, 1)).triangulated(n, m - 1, seed));
    case 10: return other("cubes", cube_grid(1 + uniform_index(random_, 3)));
    case 11: return other("tetrahedra", tetrahedron_sides().triangulated(n, m - 1, seed));
    case 12: return other("spheres", icosphere(uniform_index(random_, 2)));
    case 13: return other("tori", rotated(torus(3 + n, 3 + m), seed));
    case 14: return other("graded discs", graded_disc(6 + 4 * n, uniform(random_, 1, 5), uniform(random_, 0, 0.3), seed));
    case 15: return other("prisms", Prism(3 + n, 1, uniform(random_, 0.5, 3)).triangulated(m, m - 1, seed));
    default: return other("bent discs", bent(jittered_grid(n, m, seed)));
    }
  }

  Soup make_hard_mesh(unsigned seed, std::string& kind, bool& is_flat)
  {
    const std::size_t n = 1 + uniform_index(random_, 6), m = 1 + uniform_index(random_, 5);
    const auto in_place = [&](const char* name, Soup soup, const auto& change) {
      kind = name;
      for (Point_3& p : soup.points) p = change(p);
      return soup;
    };
    const auto any = [&]() -> Soup {
      switch (uniform_index(random_, 5))
      {
      case 0: return rotated(torus(3 + n, 3 + m), seed);
      case 1: return icosphere(uniform_index(random_, 2));
      case 2: return Cone(2 * (2 + n), uniform(random_, 6.5, 12), 1).triangulated(n, m - 1, seed);
      case 3: return bent(jittered_grid(n, m, seed));
      default: return rotated(Prism(3 + n, 1, uniform(random_, 0.5, 3)).triangulated(m, m - 1, seed), seed);
      }
    };
    const auto as_is = [](const Point_3& p) { return p; };
    const auto to_float = [](const Point_3& p) { return Point_3(float(p.x()), float(p.y()), float(p.z())); };
    const double far = std::pow(10, uniform(random_, 0, 6));
    switch (uniform_index(random_, 8))
    {
    case 0: return in_place("needle fans", needle_fan(3 + 20 * uniform_index(random_, 40)), as_is);
    case 1:
      return in_place("graded discs", graded_disc(6 + 4 * n, uniform(random_, 4, 9), uniform(random_, 0, 0.3), seed), as_is);
    case 2:
      return in_place(
        "crumpled needles",
        crumpled_needles(std::pow(10, uniform(random_, -5, -1)), std::pow(10, uniform(random_, -6, -2)), 3 * n, seed), as_is);
    case 3: return in_place("floats", any(), to_float);
    case 4: return in_place("floats", jittered_grid(n, m, seed), to_float);
    case 5:
      return in_place("far away", any(),
                      [far](const Point_3& p) { return Point_3(p.x() + far, p.y() - far, p.z() + 2 * far); });
    case 6:
      is_flat = true;
      return in_place("rectangles", random_rectangle(1, std::pow(10, uniform(random_, -4, 0)), 3 * n, m, seed), as_is);
    default: return in_place("others", any(), as_is);
    }
  }

  Soup bent(Soup soup)
  {
    for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), uniform(random_, -0.5, 0.5));
    return soup;
  }

  std::array<double, 3> turned(double a, double b, double c)
  {
    std::array<double, 3> w = {a, b, c};
    std::rotate(w.begin(), w.begin() + std::ptrdiff_t(uniform_index(random_, 3)), w.end());
    return w;
  }

  Face_index face() { return Face_index(std::uint32_t(uniform_index(random_, num_faces(*mesh_)))); }

  /// With coordinates that are multiples of 1/4: ties are frequent.
  Face_location on_lattice()
  {
    const double a = double(uniform_index(random_, 5)), b = double(uniform_index(random_, std::size_t(5 - a)));
    return Face_location(face(), turned(a / 4, b / 4, (4 - a - b) / 4));
  }

  /// Anywhere, but not nearer to an edge or a vertex than a thousandth of the face.
  Face_location anywhere()
  {
    const double choice = uniform(random_);
    if (choice < 0.2) return Face_location(face(), turned(1, 0, 0));
    if (choice < 0.4)
    {
      const double t = uniform(random_, 1e-3, 1 - 1e-3);
      return Face_location(face(), turned(t, 1 - t, 0));
    }
    const double a = uniform(random_, 1e-3, 1), b = uniform(random_, 1e-3, 1), c = uniform(random_, 1e-3, 1);
    return Face_location(face(), turned(a / (a + b + c), b / (a + b + c), c / (a + b + c)));
  }

  /// Beside a vertex or an edge by 1e-17 to 1e-9, or up to 1e-3.
  Face_location closely_beside()
  {
    const auto small = [&] { return std::pow(10, uniform(random_, -17, uniform(random_) < 0.8 ? -9 : -3)); };
    const double a = uniform(random_) < 0.1 ? 0 : small(), b = uniform(random_) < 0.1 ? 0 : small();
    if (uniform(random_) < 0.4)
    {
      const double t = uniform(random_) < 0.3 ? 0.5 : uniform(random_);
      return Face_location(face(), turned(a, t, (std::max)(0., 1 - t - a)));
    }
    return Face_location(face(), turned(a, b, 1 - a - b));
  }

  /// Sources through points beside vertices and edges.
  std::vector<Source> sources_beside(Geodesic& geodesic, Answer_counts& counts)
  {
    std::vector<Source> result;
    const auto location = [&] { return uniform(random_) < 0.6 ? closely_beside() : any_location(0.5); };
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 3); i < n; ++i)
    {
      if (uniform(random_) < 0.5) result.push_back(point_source(location()));
      else
      {
        std::vector<Face_location> through;
        for (std::size_t k = 0, m = 2 + uniform_index(random_, 3); k < m; ++k) through.push_back(location());
        const double shortest = uniform(random_) < 0.5 ? 1 : std::pow(10, uniform(random_, -10, -0.5));
        result.push_back(joined(geodesic, through, uniform(random_) < 0.3, shortest, counts));
      }
    }
    return result;
  }

  /// A point of the face beyond the edge that is nearest to a location, above its place on the edge or up to 1e-2 of the edge
  /// beside that. Bounding rays of segments along the edge lead there.
  Face_location beyond_edge(const Face_location& l)
  {
    const std::size_t k = std::size_t(std::min_element(l.second.begin(), l.second.end()) - l.second.begin());
    const auto corners = checker_->locations().corners(l.first);
    const Vertex_index p = corners[(k + 1) % 3], q = corners[(k + 2) % 3];
    const Halfedge_index h = mesh_->opposite(mesh_->halfedge(p, q));
    if (mesh_->is_border(h)) return l;
    const Vertex_index apex = mesh_->target(mesh_->next(h));
    const Vector_3 edge = mesh_->point(q) - mesh_->point(p), to_apex = mesh_->point(apex) - mesh_->point(p);
    const double foot = edge * to_apex / edge.squared_length(), height = std::pow(10, uniform(random_, -6, 0));
    const double aside = uniform(random_) < 0.3 ? 0 : std::pow(10, uniform(random_, -16, -2)) * uniform(random_, -1, 1);
    const double place = l.second[(k + 2) % 3] / (l.second[(k + 1) % 3] + l.second[(k + 2) % 3]) + aside;
    const double of_q = place - height * foot, of_p = 1 - height - of_q;
    if (of_p < 0 || of_q < 0) return l;
    Face_location result(mesh_->face(h), {0, 0, 0});
    const auto there = checker_->locations().corners(result.first);
    for (std::size_t i = 0; i < 3; ++i) result.second[i] = there[i] == p ? of_p : there[i] == q ? of_q : height;
    return result;
  }

  /// Polylines that stay in a face, with vertices beside its edges, but not so near that they are put on them.
  std::vector<Source> sources_in_faces()
  {
    std::vector<Source> result;
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 2); i < n; ++i)
    {
      Source source = polyline_source({});
      const auto f = face();
      for (std::size_t k = 0, m = 2 + uniform_index(random_, 3); k < m; ++k)
      {
        const double a = std::pow(10, uniform(random_, -12.6, -6)), t = uniform(random_);
        source.locations.push_back(uniform(random_) < 0.7 ? Face_location(f, turned(a, t * (1 - a), 1 - a - t * (1 - a)))
                                                          : anywhere());
        source.locations.back().first = f;
      }
      if (source.locations.size() > 2 && uniform(random_) < 0.4) source.kind = Source_kind::CLOSED_POLYLINE;
      if (uniform(random_) < 0.15)
        source.locations.insert(source.locations.end(), source.locations.rbegin() + 1, source.locations.rend());
      result.push_back(source);
    }
    if (uniform(random_) < 0.3) result.push_back(point_source(any_location(0.5)));
    return result;
  }

  Face_location any_location(double lattice) { return uniform(random_) < lattice ? on_lattice() : anywhere(); }

  /// Beside a vertex or an edge by 1e-16 to 1e-6.
  Face_location beside_boundary()
  {
    const double size = std::pow(10, uniform(random_, -16, -6));
    if (uniform(random_) < 0.3)
    {
      const double t = uniform(random_, 0.05, 0.95);
      return Face_location(face(), turned(size, t, 1 - t - size));
    }
    const double b = uniform(random_) < 0.2 ? 0 : size * uniform(random_);
    return Face_location(face(), turned(size, b, 1 - size - b));
  }

  /// The part t of the way from one point of a segment to the other.
  bool between(const Face_location& a, const Face_location& b, double t, Face_location& result) const
  {
    const Face_index f = checker_->locations().common_face(a, b);
    Geodesic::Barycentric_coordinates u, v;
    if (f == Surface_mesh::null_face() || !checker_->locations().express(a, f, u) || !checker_->locations().express(b, f, v))
      return false;
    result = Face_location(f, {0, 0, 0});
    for (std::size_t k = 0; k < 3; ++k) result.second[k] = (1 - t) * u[k] + t * v[k];
    return true;
  }

  /// A polyline through the given locations, by shortest paths; `shortest`: segments are divided down to this part of them.
  Source joined(Geodesic& geodesic, const std::vector<Face_location>& through, bool is_closed, double shortest,
                Answer_counts& counts)
  {
    const Geodesic::Polyline polyline = geodesic.join_polyline(through, CGAL::parameters::is_closed(is_closed));
    if (checker_->repeats_points(polyline.locations, polyline.is_closed) || !checker_->is_connected(polyline.locations))
    {
      ++counts.wrong_polylines;
      print("join_polyline repeats a point, or is not connected");
    }
    Source result = polyline_source({}, polyline.is_closed);
    const auto& l = polyline.locations;
    for (std::size_t i = 0; i < l.size(); ++i)
    {
      result.locations.push_back(l[i]);
      Face_location inside;
      if (shortest < 1 && i + 1 < l.size() && uniform(random_) < 0.5 &&
          between(l[i], l[i + 1], uniform(random_) < 0.5 ? shortest : 1 - shortest, inside))
        result.locations.push_back(inside);
    }
    return result;
  }

  std::vector<Surface_mesh::Edge_index> some_edges(std::size_t number)
  {
    std::vector<Surface_mesh::Edge_index> result;
    for (std::size_t i = 0; i < number; ++i)
      result.push_back(Surface_mesh::Edge_index(std::uint32_t(uniform_index(random_, num_edges(*mesh_)))));
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }

  std::vector<Source> spread_sources(Geodesic& geodesic, Answer_counts& counts)
  {
    std::vector<Source> result;
    const double lattice = uniform(random_) < 0.5 ? 0.8 : 0;
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 3); i < n; ++i)
    {
      const double choice = uniform(random_);
      if (choice < 0.35) result.push_back(point_source(any_location(lattice)));
      else if (choice < 0.45) result.push_back(edge_source(some_edges(1 + uniform_index(random_, 4))));
      else
      {
        std::vector<Face_location> through;
        for (std::size_t k = 0, m = 2 + uniform_index(random_, 3); k < m; ++k) through.push_back(any_location(lattice));
        const double shortest = choice < 0.7 ? 1 : std::pow(10, uniform(random_, -10, -0.5));
        result.push_back(joined(geodesic, through, uniform(random_) < 0.3, shortest, counts));
      }
    }
    return result;
  }

  /// A polyline, and sources that have parts in common with it.
  std::vector<Source> coinciding_sources(Geodesic& geodesic, Answer_counts& counts)
  {
    std::vector<Face_location> through;
    const double lattice = uniform(random_) < 0.7 ? 1 : 0;
    for (std::size_t k = 0, m = 2 + uniform_index(random_, 3); k < m; ++k) through.push_back(any_location(lattice));
    std::vector<Source> result;
    result.push_back(joined(geodesic, through, uniform(random_) < 0.3, 1, counts));
    for (std::size_t i = 0, n = 1 + uniform_index(random_, 4); i < n; ++i)
    {
      const Source known = result[uniform_index(random_, result.size())];
      const auto& l = known.locations;
      if (known.kind == Source_kind::EDGES) continue;
      const std::size_t first = uniform_index(random_, l.size()), number = 1 + uniform_index(random_, l.size() - first);
      Source other = polyline_source({});
      switch (uniform_index(random_, 8))
      {
      case 0: // again
        other = known;
        break;
      case 1: // backwards
        other = known;
        std::reverse(other.locations.begin(), other.locations.end());
        break;
      case 2: // a part
        other.locations.assign(l.begin() + std::ptrdiff_t(first), l.begin() + std::ptrdiff_t(first + number));
        break;
      case 3: // there and back
        other.locations = l;
        other.locations.insert(other.locations.end(), l.rbegin(), l.rend());
        break;
      case 4: // one of its points
        other = point_source(l[first]);
        break;
      case 5: // another way from one of its points on
        through = {l[first], any_location(lattice)};
        other = joined(geodesic, through, false, 1, counts);
        break;
      case 6: // edges, some with both ends on it
        other = edge_source(edges_at(known));
        if (other.edges.empty()) other.edges = some_edges(2);
        break;
      default: // a part from inside a segment to inside a segment
        other.locations.assign(l.begin() + std::ptrdiff_t(first), l.begin() + std::ptrdiff_t(first + number));
        Face_location inside;
        if (number > 1 && between(other.locations[0], other.locations[1], uniform(random_, 0.1, 0.9), inside))
          other.locations[0] = inside;
        break;
      }
      result.push_back(other);
    }
    std::shuffle(result.begin(), result.end(), random_);
    return result;
  }

  std::vector<Surface_mesh::Edge_index> edges_at(const Source& source) const
  {
    std::vector<Surface_mesh::Edge_index> result;
    for (std::size_t i = 0; i + 1 < source.locations.size(); ++i)
    {
      const auto a = checker_->locations().support(source.locations[i]),
                 b = checker_->locations().support(source.locations[i + 1]);
      if (a.size() != 1 || b.size() != 1) continue;
      const Halfedge_index h = mesh_->halfedge(a[0].first, b[0].first);
      if (h != Surface_mesh::null_halfedge()) result.push_back(mesh_->edge(h));
    }
    return result;
  }

  const Source& any_of(const Sources_by_id& sources)
  {
    return std::next(sources.begin(), std::ptrdiff_t(uniform_index(random_, sources.size())))->second;
  }

  Face_location vertex_of(const Sources_by_id& sources)
  {
    const Source& s = any_of(sources);
    return s.locations[uniform_index(random_, s.locations.size())];
  }

  /// A point of a source, or beside it.
  Face_location at_source(const Sources_by_id& sources)
  {
    const Source& s = any_of(sources);
    if (s.locations.empty()) return on_lattice();
    const std::size_t i = uniform_index(random_, s.locations.size());
    Face_location result = s.locations[i];
    if (i + 1 < s.locations.size() && uniform(random_) < 0.5)
      between(s.locations[i], s.locations[i + 1], double(uniform_index(random_, 5)) / 4, result);
    if (uniform(random_) < 0.5) return result;
    const std::size_t k = uniform_index(random_, 3);
    const double step = std::pow(10, uniform(random_, -16, -4)) * uniform(random_);
    if (result.second[k] <= step) return result;
    result.second[k] -= step;
    result.second[(k + 1) % 3] += step;
    return result;
  }

  void run(Answer_counts& counts)
  {
    Geodesic geodesic(*mesh_);
    const std::vector<Source> list =
      kind_of_sources_ == SPREAD       ? spread_sources(geodesic, counts)
      : kind_of_sources_ == COINCIDING ? coinciding_sources(geodesic, counts)
      : kind_of_sources_ == IN_FACES
        ? sources_in_faces()
        : sources_beside(geodesic, counts);
    geodesic.add_sources(source_set(list));
    const Sources_by_id& sources = geodesic.sources().sources();
    geodesic.build(CGAL::parameters::keep_windows(true));
    std::map<Vertex_index, std::size_t> labels;
    geodesic.source_labels(boost::make_assoc_property_map(labels));
    for (std::size_t i = 0; i < queries_; ++i)
    {
      const double choice = uniform(random_);
      const bool is_vertex = choice < 0.15;
      const Vertex_index v(std::uint32_t(uniform_index(random_, num_vertices(*mesh_))));
      const Face_location query =
        choice < 0.35                                         ? on_lattice()
        : choice < (kind_of_sources_ == SPREAD ? 0.45 : 0.65) ? at_source(sources)
        : kind_of_sources_ == BESIDE                          ? closely_beside()
        : kind_of_sources_ == IN_FACES                        ? beyond_edge(vertex_of(sources))
        : choice < 0.75                                       ? beside_boundary()
                                                              : anywhere();
      if (is_vertex && mesh_->is_isolated(v)) continue;
      const unsigned faults = is_vertex ? checker_->check_vertex(geodesic, v, labels[v]) : checker_->check(geodesic, query);
      ++counts.queries;
      if (faults == 0) continue;
      ++counts.wrong;
      for (int k = 0; k < NUMBER_OF_ANSWER_FAULTS; ++k)
        if (faults & 1u << k) ++counts.faults[k];
      print("query " + std::to_string(i) + ": " + checker_->detail());
      if (describes_) describe(geodesic, is_vertex ? checker_->locations().at_vertex(v, 1) : query);
    }
  }

  void describe(const Geodesic& geodesic, const Face_location& query)
  {
    log_.precision(17);
    const auto write = [&](const Face_location& l) {
      log_ << "    face " << std::size_t(l.first) << " of vertices";
      for (Vertex_index v : checker_->locations().corners(l.first)) log_ << ' ' << std::size_t(v);
      log_ << ": " << l.second[0] << ' ' << l.second[1] << ' ' << l.second[2] << "   at " << checker_->locations().point(l)
           << '\n';
    };
    for (const auto& s : geodesic.sources().sources())
    {
      static const char* const names[] = {"vertex", "point", "polyline", "closed polyline", "edges"};
      log_ << "  source " << s.first << ": " << names[std::size_t(s.second.kind)] << '\n';
      for (const Face_location& l : s.second.locations) write(l);
      for (auto e : s.second.edges)
        log_ << "    " << mesh_->point(mesh_->vertex(e, 0)) << " to " << mesh_->point(mesh_->vertex(e, 1)) << '\n';
    }
    log_ << "  query\n";
    write(query);
    if (const auto n = geodesic.nearest_source(query))
    {
      log_ << "  distance " << n->distance << ", source " << n->source << (n->is_segment ? ", segment " : ", point ") << n->part
           << ", side " << int(n->side) << ", gradient " << geodesic.gradient(query).value_or(CGAL::NULL_VECTOR) << ", path\n";
      std::vector<Face_location> path;
      geodesic.shortest_path_to_sources(query, std::back_inserter(path));
      for (const Face_location& l : path) write(l);
    }
    log_ << std::flush;
  }

  void print(const std::string& what)
  {
    if (printed_ == 0) return;
    --printed_;
    log_ << context_ << ": " << what << std::endl;
  }

  std::ostream& log_;
  std::size_t printed_, queries_;
  const Sources kind_of_sources_;
  const bool describes_;
  Random random_;
  const Surface_mesh* mesh_ = nullptr;
  Answer_checker* checker_ = nullptr;
  std::string context_;
  std::map<std::string, Answer_counts> counts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_ANSWER_SEARCH_H
