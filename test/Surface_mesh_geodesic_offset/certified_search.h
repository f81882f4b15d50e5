// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Comparison of certified bounds with the reference of reference_distances.h: violations, and widths by kind.

#ifndef GEODESIC_OFFSET_TEST_CERTIFIED_SEARCH_H
#define GEODESIC_OFFSET_TEST_CERTIFIED_SEARCH_H

#include "certified_cases.h"
#include "geodesic_types.h"
#include "reference_distances.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <map>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace test {

/// Results for the cases of one kind.
struct Certified_counts
{
  std::size_t meshes = 0;
  std::size_t bounds = 0;     // compared pairs of bounds
  std::size_t violations = 0; // bounds that exclude the distance
  std::size_t violated_meshes = 0;
  std::size_t invalid = 0;    // meshes that are not triangle meshes, or have faces without area
  std::size_t refused = 0;    // builds that threw std::runtime_error, as documented for needles
  std::vector<double> widths; // relative to the upper bound

  /// Quantile of the widths.
  double width(double part)
  {
    if (widths.empty()) return 0;
    const std::size_t i = std::min(widths.size() - 1, std::size_t(part * double(widths.size())));
    std::nth_element(widths.begin(), widths.begin() + std::ptrdiff_t(i), widths.end());
    return widths[i];
  }

  void add(const Certified_counts& o)
  {
    meshes += o.meshes;
    bounds += o.bounds;
    violations += o.violations;
    violated_meshes += o.violated_meshes;
    invalid += o.invalid;
    refused += o.refused;
    widths.insert(widths.end(), o.widths.begin(), o.widths.end());
  }
};

class Certified_search
{
public:
  typedef CGAL::Surface_mesh_geodesic_enclosure<CGAL::Surface_mesh_geodesic_offset_traits<Kernel, Surface_mesh>> Enclosure;
  typedef Reference_distances::Number Number;

  /// Writes up to `printed` violations to `log`.
  Certified_search(std::ostream& log, std::size_t printed) : log_(log), printed_(printed) {}

  /// Compares the bounds of all vertices and queries of a case, with and without kept windows.
  void run(const Certified_case& c, const std::string& name)
  {
    Certified_counts& counts = counts_[c.kind];
    ++counts.meshes;
    const std::size_t before = counts.violations;
    try
    {
      const Generated_mesh<Surface_mesh> data(soup_of(c));
      Enclosure enclosure(data.mesh);
      for (std::size_t v : c.source_vertices) enclosure.add_source_point(data.vertices[v]);
      for (const auto& s : c.sources) enclosure.add_source_point(location(data, c, s));
      for (const auto& s : c.segments)
      {
        const std::size_t t = s.place.triangle;
        const std::vector<Enclosure::Face_location> ends = {location(data, c, {t, s.place.first}),
                                                            location(data, c, {t, s.place.second})};
        enclosure.add_source_polyline(ends, CGAL::parameters::start_value(s.start_value));
      }
      const std::vector<Number> distances = distances_of(c);
      for (const bool keeps : {false, true})
      {
        enclosure.build(CGAL::parameters::keep_windows(keeps));
        for (std::size_t v = 0; v < c.points.size(); ++v)
          compare(enclosure.distance_bounds(data.vertices[v]), distances[v], counts,
                  [&] { return name + ", vertex " + std::to_string(v); });
        for (std::size_t q = 0; keeps && q < c.queries.size(); ++q)
          compare(enclosure.distance_bounds(location(data, c, c.queries[q])), distances[c.points.size() + q], counts,
                  [&] { return name + ", query " + std::to_string(q); });
      }
    }
    catch (const std::invalid_argument&)
    { // a face without area
      ++counts.invalid;
    }
    catch (const std::runtime_error&)
    {
      ++counts.refused;
    }
    counts.violated_meshes += counts.violations > before;
  }

  std::map<std::string, Certified_counts>& counts() { return counts_; }

  Certified_counts total() const
  {
    Certified_counts sum;
    for (const auto& c : counts_) sum.add(c.second);
    return sum;
  }

  /// Prints a Markdown table.
  void print_table(std::FILE* out)
  {
    std::fprintf(out, "| kind | meshes | without area | refused | bounds | violations | in meshes | median width | 99 %% | "
                      "largest |\n|---|---|---|---|---|---|---|---|---|---|\n");
    const auto print = [&](const std::string& kind, Certified_counts c) {
      std::fprintf(out, "| %s | %zu | %zu | %zu | %zu | %zu | %zu | %.1e | %.1e | %.1e |\n", kind.c_str(), c.meshes, c.invalid,
                   c.refused, c.bounds, c.violations, c.violated_meshes, c.width(0.5), c.width(0.99), c.width(1));
    };
    for (const auto& c : counts_) print(c.first, c.second);
    print("all", total());
  }

  /// Location of the reference; weights are in the order of the face's halfedges.
  static Enclosure::Face_location location(const Generated_mesh<Surface_mesh>& data, const Certified_case& c,
                                           const Certified_case::Location& l)
  {
    const auto& t = c.triangles[l.triangle];
    const auto f = data.faces[l.triangle];
    std::size_t first = 0;
    while (data.vertices[t[first]] != data.mesh.source(data.mesh.halfedge(f))) ++first;
    return {f, {{l.weights[first], l.weights[(first + 1) % 3], l.weights[(first + 2) % 3]}}};
  }

private:
  // Distances of the vertices and queries.
  static std::vector<Number> distances_of(const Certified_case& c)
  {
    Reference_distances reference(c.points, c.triangles);
    std::vector<Number> result(c.points.size() + c.queries.size(), Reference_distances::infinity());
    const auto solve = [&](const std::vector<std::size_t>& vertices, const std::vector<Certified_case::Location>& locations,
                           const std::vector<Reference_distances::Segment>& segments, double start_value) {
      reference.solve(vertices, locations, c.queries, segments);
      for (std::size_t i = 0; i < result.size(); ++i)
      {
        const Number& d = i < c.points.size() ? reference.of_vertex(i) : reference.of_query(i - c.points.size());
        if (d < Reference_distances::infinity()) result[i] = (std::min)(result[i], Number(d + Number(start_value)));
      }
    };
    if (!c.source_vertices.empty() || !c.sources.empty()) solve(c.source_vertices, c.sources, {}, 0);
    for (const auto& s : c.segments)
      solve({}, {{s.place.triangle, s.place.first}, {s.place.triangle, s.place.second}}, {s.place}, s.start_value);
    return result;
  }

  template <class Name>
  void compare(const std::pair<double, double>& bounds, const Number& distance, Certified_counts& counts, const Name& name)
  {
    ++counts.bounds;
    const bool is_reached = distance < Reference_distances::infinity();
    const Number error = Number(1e-24) * distance; // of the reference
    const bool is_right = is_reached ? Number(bounds.first) <= distance + error && distance - error <= Number(bounds.second)
                                     : std::isinf(bounds.first) && std::isinf(bounds.second);
    if (is_right)
    {
      if (is_reached && bounds.second > 0) counts.widths.push_back((bounds.second - bounds.first) / bounds.second);
      return;
    }
    ++counts.violations;
    if (printed_ == 0) return;
    --printed_;
    char text[200];
    std::snprintf(text, sizeof(text), ": [%.17g, %.17g] excludes %.17g, lower bound off by %.2g, upper by %.2g", bounds.first,
                  bounds.second, double(distance), double(Number(bounds.first) - distance),
                  double(distance - Number(bounds.second)));
    log_ << name() << text << std::endl;
  }

  std::ostream& log_;
  std::size_t printed_;
  std::map<std::string, Certified_counts> counts_;
};

} // namespace test

#endif // GEODESIC_OFFSET_TEST_CERTIFIED_SEARCH_H
