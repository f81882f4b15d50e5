// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Compares offset curves with exact arrangements, face by face: are the same gates connected, are there the same loops, and
// how far are the curves from each other?

#ifndef GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H
#define GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H

#include "face_oracle.h"
#include "field_features.h"
#include "locations.h"
#include "offset_tools.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>
#include <vector>

namespace test {

/// Lengths are in levels plus diagonals of the bounding box.
struct Oracle_options
{
  double widening = 1e-13; // of cones
  double margin = 1e-12;   // e: between the level and the inner and outer region
  double snapping = 1e-14; // of images
  double apart = 1e-6;     // the largest distance between curves of the same topology
  std::size_t windows = 60; // faces with more are left out: exact unions take long
};

struct Oracle_counts
{
  std::size_t faces = 0;      // compared
  std::size_t chains = 0, loops = 0, arcs = 0, windows = 0; // in them; arcs are those of the curves
  std::size_t most_arcs = 0;  // in one face
  std::size_t undecided = 0;  // faces where rounding decides the topology
  std::size_t left_out = 0;   // faces with too many windows
  std::size_t topology = 0;   // faces where other gates are connected, or loops are missing
  std::size_t apart = 0;      // faces where curves are too far from each other
  std::size_t thrown = 0;     // exceptions of the oracle
  double worst_distance = 0;  // between curves

  void add(const Oracle_counts& o)
  {
    faces += o.faces;
    chains += o.chains;
    loops += o.loops;
    arcs += o.arcs;
    windows += o.windows;
    most_arcs = (std::max)(most_arcs, o.most_arcs);
    undecided += o.undecided;
    left_out += o.left_out;
    topology += o.topology;
    apart += o.apart;
    thrown += o.thrown;
    worst_distance = (std::max)(worst_distance, o.worst_distance);
  }
  std::size_t differences() const { return topology + apart; }
};

/// Compares the curves of a geodesic object that was built with kept windows.
class Offset_oracle
{
public:
  typedef CGAL::Geodesic_offset::internal::Index Index;
  typedef Judged_surface::Face Face;

  Offset_oracle(const Open_geodesic& geodesic, const Surface_mesh& mesh, const Oracle_options& options = Oracle_options())
    : geodesic_(geodesic), mesh_(mesh), options_(options), surface_(geodesic, mesh), chains_(surface_.number_of_faces())
  {}

  /// Compares `faces` random faces, at most, that the level passes through. `report(text)` is called for differences.
  template <class Function>
  Oracle_counts operator()(double level, std::size_t faces, Random& random, const Function& report)
  {
    const double cut = cut_of(level), scale = cut + surface_.diagonal();
    for (auto& c : chains_) c.clear();
    for (const Offset_curve& curve : offsets(geodesic_, level)) add(curve);

    std::vector<Surface_mesh::Face_index> crossed;
    for (const auto f : mesh_.faces())
    {
      double low, high;
      surface_.range_of(surface_.face_at(surface_.index_of(f)), low, high);
      if (low < cut && cut <= high && std::isfinite(low)) crossed.push_back(f);
    }
    Oracle_counts counts;
    Face_field field = geodesic_.face_field();
    for (std::size_t i = 0; i < crossed.size() && counts.faces < faces; ++i)
    {
      std::swap(crossed[i], crossed[i + uniform_index(random, crossed.size() - i)]);
      field.set_face(geodesic_.field_index(crossed[i]));
      // bounds by corners are wide: most of these faces have no chain
      const Index f = surface_.index_of(crossed[i]);
      if (chains_[f].empty() && !may_pass(surface_.face_at(f), field, cut)) continue;
      try
      {
        compare(f, field, cut, scale, counts, [&](const std::string& text) {
          char buffer[64];
          std::snprintf(buffer, sizeof(buffer), "level %.17g, face %u: ", level, f);
          report(buffer + text);
        });
      }
      catch (const std::exception& e)
      {
        ++counts.thrown;
        report(e.what());
      }
    }
    return counts;
  }

private:
  /// A chain of pieces of an offset curve within a face.
  void add(const Offset_curve& curve)
  {
    const std::size_t n = curve.number_of_pieces();
    // begins where it enters a face
    std::size_t first = n;
    for (std::size_t i = 0; i < n && first == n; ++i)
      if (!curve.is_closed() || curve.piece((i + n - 1) % n).face() != curve.piece(i).face()) first = i;
    const bool is_loop = first == n;
    if (is_loop) first = 0;
    for (std::size_t i = 0; i < n;)
    {
      const Offset_piece start = curve.piece((first + i) % n);
      Level_chain chain{is_loop, gate(start.start()), 0, {}};
      for (; i < n && curve.piece((first + i) % n).face() == start.face(); ++i)
      {
        const Offset_piece p = curve.piece((first + i) % n);
        if (p.is_segment()) chain.arcs.emplace_back(plain(p.start_2()), plain(p.end_2()));
        else chain.arcs.emplace_back(plain(p.start_2()), plain(p.end_2()), plain(p.center()), p.radius());
        chain.to = gate(p.end());
      }
      chains_[surface_.index_of(start.face())].push_back(std::move(chain));
    }
  }

  // The position on the boundary of the face, as in Level_chain.
  static double gate(const Face_location& l)
  {
    for (std::size_t k = 0; k < 3; ++k)
      if (l.second[(k + 2) % 3] == 0) return double(k) + l.second[(k + 1) % 3];
    return 0;
  }

  // Whether samples do not tell that the face is all near or all far.
  static bool may_pass(const Face& face, const Face_field& field, double cut)
  {
    double low = std::numeric_limits<double>::infinity(), high = 0;
    const int n = 3;
    for (int i = 0; i <= n; ++i)
      for (int j = 0; i + j <= n; ++j)
      {
        std::size_t nearest;
        const double d = field.distance(face.point({{double(i) / n, double(j) / n, double(n - i - j) / n}}), nearest);
        low = (std::min)(low, d);
        high = (std::max)(high, d);
      }
    const double reach = face.longest_edge() / n; // of a sample
    return low - reach / 4 < cut && cut < high + reach / 4;
  }

  template <class Function>
  void compare(Index f, const Face_field& field, double cut, double scale, Oracle_counts& counts, const Function& report)
  {
    if (field.windows().size() > options_.windows)
    {
      ++counts.left_out;
      return;
    }
    const std::vector<Level_chain>& actual = chains_[f];
    const Face_oracle oracle(field, options_.widening * scale, options_.snapping * scale);
    const std::vector<Level_chain> inner = oracle.chains(oracle.nearer_than(cut - options_.margin * scale)),
                                   outer = oracle.chains(oracle.nearer_than(cut + options_.margin * scale));
    ++counts.faces;
    counts.windows += oracle.number_of_windows();
    const Chain_topology of_inner(inner), of_outer(outer), of_actual(actual);
    if (!(of_inner == of_outer))
    {
      ++counts.undecided;
      return;
    }
    counts.chains += of_inner.number_of_open_chains();
    counts.loops += of_inner.number_of_loops();
    std::size_t arcs = 0;
    for (const Level_chain& c : actual) arcs += c.arcs.size();
    counts.arcs += arcs;
    counts.most_arcs = (std::max)(counts.most_arcs, arcs);
    if (!(of_actual == of_inner))
    {
      ++counts.topology;
      return report(text_of(actual) + " instead of " + text_of(inner));
    }
    double apart = 0;
    for (const auto* region : {&inner, &outer})
      apart = (std::max)({apart, farthest(*region, actual), farthest(actual, *region)});
    counts.worst_distance = (std::max)(counts.worst_distance, apart / scale);
    if (apart <= options_.apart * scale) return;
    ++counts.apart;
    char buffer[64];
    std::snprintf(buffer, sizeof(buffer), "curves are %.3g apart", apart);
    report(buffer);
  }

  // How far points of some chains are from others.
  static double farthest(const std::vector<Level_chain>& from, const std::vector<Level_chain>& to)
  {
    double worst = 0;
    for (const Level_chain& chain : from)
      for (const Chain_arc& arc : chain.arcs)
        for (const double t : {0., 0.25, 0.5, 0.75, 1.})
        {
          const Point_in_face p = arc.at(t);
          double nearest = std::numeric_limits<double>::infinity();
          for (const Level_chain& other : to) nearest = (std::min)(nearest, other.distance(p));
          worst = (std::max)(worst, nearest);
        }
    return worst;
  }

  static std::string text_of(const std::vector<Level_chain>& chains)
  {
    std::string text;
    for (const Level_chain& c : chains)
    {
      char buffer[80];
      std::snprintf(buffer, sizeof(buffer), "%.12g-%.12g", c.from, c.to);
      text += (text.empty() ? "" : ", ") + (c.is_closed ? std::string("a loop") : std::string(buffer));
    }
    return text.empty() ? "nothing" : text;
  }

  const Open_geodesic& geodesic_;
  const Surface_mesh& mesh_;
  const Oracle_options options_;
  Judged_surface surface_;
  std::vector<std::vector<Level_chain>> chains_; // by face
};

/// Random windows: a few faces, and many sources in them.
inline Soup oracle_faces(Random& random)
{
  const std::size_t kind = uniform_index(random, 4);
  if (kind == 0) return random_rectangle(1, 1, 1 + uniform_index(random, 5), 0, unsigned(random() % 100000));
  if (kind == 1) return planar_grid(2, 2, Diagonals::random, 1, 0.2, unsigned(random() % 100000));
  Soup soup;
  if (kind == 2) soup = random_rectangle(1, 1, 2 + uniform_index(random, 8), 1, unsigned(random() % 100000));
  else return tetrahedron_sides().triangulated(uniform_index(random, 3), 0, unsigned(random() % 100000));
  for (Point_3& p : soup.points) p = Point_3(p.x(), p.y(), 0.5 * uniform(random));
  return soup;
}

inline void add_oracle_sources(Geodesic& geodesic, const Surface_mesh& mesh, Random& random)
{
  const auto anywhere = [&] {
    return Face_location(Surface_mesh::Face_index(static_cast<Surface_mesh::size_type>(
                           uniform_index(random, mesh.number_of_faces()))),
                         random_barycentric(random));
  };
  const std::size_t points = uniform_index(random, 12), lines = uniform_index(random, points < 3 ? 4 : 3) + (points == 0);
  for (std::size_t i = 0; i < points; ++i) geodesic.add_source_point(anywhere());
  for (std::size_t i = 0; i < lines; ++i)
  {
    const Face_location a = anywhere();
    geodesic.add_source_polyline(
      std::vector<Face_location>{a, Face_location(a.first, random_barycentric(random)),
                                 Face_location(a.first, random_barycentric(random))});
  }
}

} // namespace test

#endif // GEODESIC_OFFSET_TEST_OFFSET_ORACLE_H
