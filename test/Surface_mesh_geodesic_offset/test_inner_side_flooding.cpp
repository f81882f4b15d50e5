// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Inner sides of random closed polylines against flooding. Each face of a mesh is divided into small triangles. The polylines are
// the cycles around random sets of small triangles: they run through faces, along edges and borders and through vertices, touch and
// cross each other, and go around handles and holes. The oracle floods the small triangles up to the edges of one polyline.

#include "generated_meshes.h"
#include "geodesic_types.h"
#include "locations.h"
#include "test_check.h"
#include "test_registry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace test_inner_side_flooding {

using namespace test;
using CGAL::Source_side;

typedef Geodesic::Face_location Face_location;
typedef test::Surface_mesh::Vertex_index Vertex_index;
typedef test::Surface_mesh::Face_index Face_index;
typedef std::vector<std::size_t> Cycle; // fine vertices

// A soup and its division.
class Fine_mesh
{
public:
  Generated_mesh<test::Surface_mesh> data;
  std::vector<std::array<std::size_t, 3>> triangles;
  std::vector<double> areas;
  std::map<std::pair<std::size_t, std::size_t>, std::size_t> triangle_of; // left of a directed edge

  // n: parts of an edge
  Fine_mesh(const Soup& soup, std::size_t n, Random& random) : data(soup), m_n(n), m_random(random)
  {
    const Locations<test::Surface_mesh> on_mesh(data.mesh);
    for (const auto f : data.mesh.faces())
    {
      const auto corners = on_mesh.corners(f);
      m_inside.clear();
      const auto at = [&](std::size_t i, std::size_t j) { return vertex(f, corners, {n - i - j, i, j}); };
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; i + j < n; ++j)
        {
          add({at(i, j), at(i + 1, j), at(i, j + 1)}, corners);
          if (i + j + 1 < n) add({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, corners);
        }
    }
  }

  const Face_location& location(std::size_t v) const { return m_locations[v]; }

  bool has_left(std::size_t a, std::size_t b) const { return triangle_of.count({a, b}) > 0; }

  double length(std::size_t a, std::size_t b) const
  {
    const Locations<test::Surface_mesh> on_mesh(data.mesh);
    return std::sqrt(CGAL::squared_distance(on_mesh.point(m_locations[a]), on_mesh.point(m_locations[b])));
  }

  // The cycles around a set of small triangles, which lie on their left.
  std::vector<Cycle> cycles_around(const std::set<std::size_t>& region) const
  {
    std::set<std::pair<std::size_t, std::size_t>> edges;
    std::map<std::size_t, std::vector<std::size_t>> next;
    for (const std::size_t t : region)
      for (std::size_t k = 0; k < 3; ++k)
      {
        const std::size_t a = triangles[t][k], b = triangles[t][(k + 1) % 3];
        if (has_left(b, a) && region.count(triangle_of.at({b, a}))) continue;
        edges.insert({a, b});
        next[a].push_back(b);
      }
    std::vector<Cycle> result;
    while (!edges.empty())
    {
      Cycle cycle;
      std::size_t a = edges.begin()->first, b = edges.begin()->second;
      while (edges.erase({a, b}))
      {
        cycle.push_back(a);
        // where several cycles meet, the one around the same triangles goes on: the region is left, so turn around b clockwise
        // from the edge within it
        std::size_t turn = a, following = no_vertex;
        for (std::size_t steps = 0; following == no_vertex && has_left(turn, b) && steps < 1000; ++steps)
        {
          const auto& t = triangles[triangle_of.at({turn, b})];
          const std::size_t beyond = t[(std::size_t(std::find(t.begin(), t.end(), b) - t.begin()) + 1) % 3];
          if (edges.count({b, beyond})) following = beyond;
          turn = beyond;
        }
        if (following == no_vertex) break;
        a = b;
        b = following;
      }
      result.push_back(cycle);
    }
    return result;
  }

  // Grows from a random triangle.
  std::set<std::size_t> random_region(std::size_t size)
  {
    std::set<std::size_t> region{uniform_index(m_random, triangles.size())};
    std::vector<std::size_t> edge(region.begin(), region.end());
    const bool ragged = uniform(m_random) < 0.5;
    while (region.size() < size && !edge.empty())
    {
      const std::size_t i = ragged ? uniform_index(m_random, edge.size()) : 0, t = edge[i];
      bool grows = false;
      for (std::size_t k = 0; k < 3 && !(ragged && grows); ++k)
      {
        const auto beyond = triangle_of.find({triangles[t][(k + 1) % 3], triangles[t][k]});
        if (beyond == triangle_of.end() || !region.insert(beyond->second).second) continue;
        edge.push_back(beyond->second);
        grows = true;
      }
      if (!grows || !ragged) edge.erase(edge.begin() + std::ptrdiff_t(i));
    }
    return region;
  }

private:
  static constexpr std::size_t no_vertex = std::size_t(-1);
  typedef std::array<Vertex_index, 3> Corners;

  // The fine vertex of a face with these lattice coordinates; inside edges and faces off the lattice.
  std::size_t vertex(Face_index f, const Corners& corners, const std::array<std::size_t, 3>& lattice)
  {
    std::array<double, 3> w;
    std::vector<std::pair<std::size_t, std::size_t>> support; // vertex and coordinate
    for (std::size_t k = 0; k < 3; ++k)
    {
      w[k] = double(lattice[k]) / double(m_n);
      if (lattice[k] > 0) support.push_back({std::size_t(corners[k]), lattice[k]});
    }
    std::sort(support.begin(), support.end());
    auto& known = support.size() == 3 ? m_inside : m_shared;
    const auto [it, is_new] = known.emplace(support, m_locations.size());
    if (!is_new) return it->second;
    const double move = 0.25 / double(m_n);
    std::size_t first = 3;
    for (std::size_t k = 0; k < 3; ++k)
      if (lattice[k] > 0)
      {
        if (first == 3) first = k;
        else
        {
          const double d = uniform(m_random, -move, move);
          w[k] += d;
          w[first] -= d;
        }
      }
    m_locations.push_back(Face_location(f, w));
    return it->second;
  }

  // Barycentric coordinates of a fine vertex in any of its faces.
  std::array<double, 3> weights(std::size_t v, const Corners& corners) const
  {
    std::array<double, 3> w{{0, 0, 0}};
    const Locations<test::Surface_mesh> on_mesh(data.mesh);
    for (const auto& [vertex, weight] : on_mesh.support(m_locations[v]))
      w[std::size_t(std::find(corners.begin(), corners.end(), vertex) - corners.begin())] = weight;
    return w;
  }

  void add(const std::array<std::size_t, 3>& t, const Corners& corners)
  {
    const auto p = weights(t[0], corners), q = weights(t[1], corners), r = weights(t[2], corners);
    const double part =
      p[0] * (q[1] * r[2] - q[2] * r[1]) - p[1] * (q[0] * r[2] - q[2] * r[0]) + p[2] * (q[0] * r[1] - q[1] * r[0]);
    const auto& point = data.mesh.points();
    areas.push_back(part * std::sqrt(CGAL::squared_area(point[corners[0]], point[corners[1]], point[corners[2]])));
    CHECK(part > 0);
    for (std::size_t k = 0; k < 3; ++k) triangle_of[{t[k], t[(k + 1) % 3]}] = triangles.size();
    triangles.push_back(t);
  }

  std::size_t m_n;
  Random& m_random;
  std::vector<Face_location> m_locations;
  typedef std::map<std::vector<std::pair<std::size_t, std::size_t>>, std::size_t> Known;
  Known m_shared, m_inside;
};

struct Expected
{
  bool divides = true;
  std::array<double, 2> area{{0, 0}}; // left, right
  Source_side side = Source_side::NONE;
  bool is_by_area = false;
};

// Floods the triangles beside a cycle.
Expected flooded(const Fine_mesh& fine, const Cycle& cycle)
{
  std::set<std::pair<std::size_t, std::size_t>> walls;
  for (std::size_t i = 0; i < cycle.size(); ++i)
    for (const bool back : {false, true})
      walls.insert({cycle[back ? (i + 1) % cycle.size() : i], cycle[back ? i : (i + 1) % cycle.size()]});
  Expected result;
  std::vector<int> mark(fine.triangles.size(), -1);
  std::array<double, 2> border{{0, 0}};
  for (const int side : {0, 1})
    for (std::size_t i = 0; i < cycle.size(); ++i)
    {
      std::size_t a = cycle[i], b = cycle[(i + 1) % cycle.size()];
      if (side == 1) std::swap(a, b);
      if (!fine.has_left(a, b)) continue;
      std::vector<std::size_t> stack{fine.triangle_of.at({a, b})};
      while (!stack.empty())
      {
        const std::size_t t = stack.back();
        stack.pop_back();
        if (mark[t] == 1 - side) result.divides = false;
        if (mark[t] >= 0) continue;
        mark[t] = side;
        result.area[std::size_t(side)] += fine.areas[t];
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::size_t p = fine.triangles[t][k], q = fine.triangles[t][(k + 1) % 3];
          if (walls.count({p, q})) continue;
          if (fine.has_left(q, p)) stack.push_back(fine.triangle_of.at({q, p}));
          else border[std::size_t(side)] += fine.length(p, q);
        }
      }
    }
  if (!result.divides) return result;
  const auto choose = [&](bool left) { result.side = left ? Source_side::LEFT : Source_side::RIGHT; };
  if ((result.area[0] == 0) != (result.area[1] == 0)) choose(result.area[0] > 0);
  else if ((border[0] == 0) != (border[1] == 0)) choose(border[0] == 0);
  else
  {
    result.is_by_area = true;
    choose(result.area[0] < result.area[1]);
  }
  return result;
}

// Without some triangles that share no vertices, so that most fans stay whole.
Soup with_holes(const Soup& soup, Random& random, std::size_t holes)
{
  std::set<std::size_t> gone, corners;
  for (std::size_t tries = 0; gone.size() < holes && tries < 100; ++tries)
  {
    const std::size_t i = uniform_index(random, soup.triangles.size());
    const auto& t = soup.triangles[i];
    if (std::any_of(t.begin(), t.end(), [&](std::size_t v) { return corners.count(v) > 0; })) continue;
    gone.insert(i);
    corners.insert(t.begin(), t.end());
  }
  Soup result;
  result.points = soup.points;
  for (std::size_t i = 0; i < soup.triangles.size(); ++i)
    if (!gone.count(i)) result.add_triangle(soup.triangles[i], 0, soup.uv[i]);
  return result;
}

struct Totals
{
  std::size_t curves = 0, undivided = 0, by_border = 0, one_sided = 0;
};

void run(const std::string& name, const Soup& soup, std::size_t n, unsigned seed, Totals& totals)
{
  Random random(seed);
  Fine_mesh fine(soup, n, random);
  const double all = std::accumulate(fine.areas.begin(), fine.areas.end(), 0.);
  const CGAL::Geodesic_mesh<Geodesic::Traits> mesh(fine.data.mesh);
  for (std::size_t round = 0; round < 6; ++round)
  {
    Geodesic::Source_set sources;
    std::vector<Cycle> cycles;
    for (std::size_t k = 0; k < 4; ++k)
      for (Cycle& cycle :
           fine.cycles_around(fine.random_region(1 + std::size_t(std::pow(uniform(random), 2) * double(fine.triangles.size())))))
      {
        if (uniform(random) < 0.5) std::reverse(cycle.begin(), cycle.end());
        std::vector<Face_location> locations;
        for (const std::size_t v : cycle) locations.push_back(fine.location(v));
        sources.add_polyline(locations, CGAL::parameters::is_closed(true));
        cycles.push_back(std::move(cycle));
      }
    const auto sides = mesh.inner_sides(sources);
    CHECK(sides.size() == cycles.size());
    for (const auto& [id, found] : sides)
    {
      Report::instance().set_context(name + ", seed " + std::to_string(seed) + ", round " + std::to_string(round) + ", curve " +
                                     std::to_string(id));
      const Expected expected = flooded(fine, cycles[id]);
      ++totals.curves;
      if (!expected.divides)
      {
        ++totals.undivided;
        CHECK(found.side == Source_side::NONE);
        continue;
      }
      totals.by_border += expected.is_by_area ? 0 : 1;
      totals.one_sided += expected.area[0] == 0 || expected.area[1] == 0 ? 1 : 0;
      CHECK_DETAIL(found.side == expected.side && found.is_by_area == expected.is_by_area,
                   values(expected.area[0], expected.area[1]));
      const bool left = found.side == Source_side::LEFT;
      const double inner = expected.area[left ? 0 : 1], outer = expected.area[left ? 1 : 0];
      CHECK_DETAIL(std::abs(found.inner_area - inner) <= 1e-12 * all, values(found.inner_area, inner));
      CHECK_DETAIL(std::abs(found.outer_area - outer) <= 1e-12 * all, values(found.outer_area, outer));
    }
  }
}

} // namespace test_inner_side_flooding

GEODESIC_OFFSET_TEST(test_inner_side_flooding)
{
  Totals totals;
  for (unsigned seed = 1; seed <= 8; ++seed)
  {
    Random random(seed);
    const std::pair<const char*, Soup> soups[] = {
      {"torus", torus(8, 5)},
      {"icosphere", icosphere(1)},
      {"tetrahedron", tetrahedron_sides().triangulated(0, 0, 1)},
      {"genus 5", marching_genus_5(7)},
      {"grid", jittered_grid(6, 5, seed)},
      {"two triangles", random_rectangle(4, 4, 0, 0, 1)}};
    for (const auto& [name, soup] : soups)
    {
      const std::size_t n = soup.triangles.size() < 10 ? 9 : soup.triangles.size() < 100 ? 4 : 2;
      run(name, soup, n, seed, totals);
      if (soup.triangles.size() > 10) run(name + std::string(", with holes"), with_holes(soup, random, 5), n, seed, totals);
    }
  }
  Report::instance().set_context("");
  CHECK_DETAIL(totals.curves >= 2000 && totals.undivided >= 50 && totals.by_border >= 200 && totals.one_sided >= 10,
               std::to_string(totals.curves));
  std::cout << totals.curves << " curves, " << totals.undivided << " do not divide, " << totals.by_border
            << " with an inside without border, " << totals.one_sided << " along the whole border" << std::endl;
  return Report::instance().finish("test_inner_side_flooding");
}
