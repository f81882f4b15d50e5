// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fig. 10 of the paper: offsets on one surface with other resolutions and triangulations.
//
//   figure_10_resolutions FOLDER_FOR_PICTURES MODEL...
//
// The sources are the sections by one plane. The offsets of a model at 20 distances are compared with those on the same surface,
// triangulated again with additional vertices at random places, and with those on simplified models. Contours by fast marching
// are compared in the same way.

#include "../Performance/fast_marching.h"
#include "experiment.h"
#include "interpolated_offset.h"

#include <CGAL/Surface_mesh_simplification/edge_collapse.h>
#include <CGAL/boost/graph/Euler_operations.h>

#include <optional>
#include <random>

namespace {

using namespace paper;

constexpr std::size_t number_of_levels = 20;
constexpr double chord_tolerance = 1e-6; // of the polylines that are compared, in diagonals

// Largest difference of distances on the same surface, in diagonals: points of curves are 2^-42 of their distance nearer than
// the level, which is at most some diagonals, and the new vertices are rounded.
constexpr double error_on_same_surface = 1e-11;

std::mt19937 fresh_random() { return std::mt19937(10); }

double uniform(std::mt19937& random) { return (static_cast<double>(random()) + 0.5) / 4294967296.; }

// New vertices on a tenth of the edges and in a third of the faces: the same surface.
void triangulate_again(Mesh& mesh)
{
  std::mt19937 random = fresh_random();
  const std::vector<Edge> edges(mesh.edges().begin(), mesh.edges().end());
  const std::vector<Face> faces(mesh.faces().begin(), mesh.faces().end());
  for (Edge e : edges)
  {
    if (uniform(random) > 0.1) continue;
    const double t = 0.1 + 0.8 * uniform(random);
    const Halfedge h = mesh.halfedge(e);
    const Point p = CGAL::barycenter(mesh.point(mesh.source(h)), 1 - t, mesh.point(mesh.target(h)), t);
    const Halfedge first = CGAL::Euler::split_edge(h, mesh), second = mesh.opposite(mesh.next(first));
    mesh.point(mesh.target(first)) = p;
    for (Halfedge g : {first, second})
      if (!mesh.is_border(g)) CGAL::Euler::split_face(g, mesh.next(mesh.next(g)), mesh);
  }
  for (Face f : faces)
  {
    if (uniform(random) > 1 / 3.) continue;
    const Halfedge h = mesh.halfedge(f);
    double w[3] = {0.2 + uniform(random), 0.2 + uniform(random), 0.2 + uniform(random)};
    const Point p = CGAL::barycenter(mesh.point(mesh.source(h)), w[0], mesh.point(mesh.target(h)), w[1],
                                     mesh.point(mesh.target(mesh.next(h))), w[2]);
    mesh.point(mesh.target(CGAL::Euler::add_center_vertex(h, mesh))) = p;
  }
}

// Stops an edge collapse.
struct Is_simple_enough
{
  std::size_t edges;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t now) const
  {
    return now <= edges;
  }
};

// By the method of Lindstrom and Turk.
void simplify(Mesh& mesh, double part)
{
  const Is_simple_enough stop{static_cast<std::size_t>(part * static_cast<double>(mesh.number_of_edges()))};
  CGAL::Surface_mesh_simplification::edge_collapse(mesh, stop);
  mesh.collect_garbage();
}

typedef std::map<std::size_t, std::vector<Polyline>> Polylines; // by the number of the level

struct Offsets
{
  std::vector<Offset_curve> exact;
  Polylines curves, contours; // exact, by fast marching
};

class Experiment
{
public:
  Experiment(const Model& model, const std::string& picture)
    : m_model(model), m_diagonal(model.diagonal()), m_plane(middle_plane(model.box())), m_geodesic(model.mesh)
  {
    m_sections = add_section(m_geodesic, m_plane);
    m_geodesic.build(CGAL::parameters::keep_windows(true));
    m_spacing = m_geodesic.field().largest_vertex_distance().value() / static_cast<double>(number_of_levels + 1);
    m_offsets = offsets_of(m_geodesic, model.mesh, m_sections);
    std::vector<Point> points;
    for (const Polyline& p : points_on(model.mesh, m_sections)) points.insert(points.end(), p.begin(), p.end());
    m_view = geodesic_offset::choose_view(model.mesh, points, Vector(0, 1, 0));
    draw(m_geodesic, model.mesh, m_sections, m_offsets);

    Mesh same = model.mesh;
    triangulate_again(same);
    const double error = compare("same surface", same);
    for (const auto& part : {std::make_pair("3/11", 3 / 11.), std::make_pair("1/11", 1 / 11.)})
    {
      Mesh simplified = model.mesh;
      simplify(simplified, part.second);
      compare(std::string("simplified to ") + part.first, simplified);
    }
    write_indexed_png(picture, joined_panels(m_panels));
    expect(error <= error_on_same_surface, "distances on the same surface differ by " + text(error) + " diagonals");
  }

private:
  Offsets offsets_of(Geodesic& geodesic, const Mesh& mesh, const std::vector<Surface_polyline>& sections) const
  {
    Offsets result;
    geodesic.build_with_offset_curves(Levels::equally_spaced(m_spacing, number_of_levels), std::back_inserter(result.exact),
                                      CGAL::parameters::keep_windows(true));
    for (const Offset_curve& c : result.exact)
    {
      Polyline points;
      c.points(chord_tolerance * m_diagonal, std::back_inserter(points));
      result.curves[static_cast<std::size_t>(std::lround(c.distance() / m_spacing))].push_back(std::move(points));
    }
    const std::vector<double> values = benchmark::Fast_marching<Mesh>(mesh)(distances_at(geodesic, mesh, sections));
    for (std::size_t i = 1; i <= number_of_levels; ++i)
      for (const Surface_polyline& c : interpolated_offset(
             mesh, [&](Vertex v) { return values[v]; }, static_cast<double>(i) * m_spacing))
        result.contours[i].push_back(points_on(mesh, c));
    return result;
  }

  // Returns the largest difference of distances, in diagonals.
  double compare(const std::string& name, Mesh& mesh)
  {
    Geodesic geodesic(mesh);
    const std::vector<Surface_polyline> sections = add_section(geodesic, m_plane);
    const Offsets offsets = offsets_of(geodesic, mesh, sections);
    double surface = 0, difference = 0;
    for (Vertex v : m_model.mesh.vertices())
      surface = (std::max)(surface, geodesic.mesh().locate_with_distance(m_model.mesh.point(v)).second);
    for (const Offset_curve& c : offsets.exact)
      for (const auto& piece : c.pieces())
        difference =
          (std::max)(difference,
                     std::abs(m_geodesic.distance_to_sources(m_geodesic.mesh().locate(piece.point(0))) - c.distance()));
    print(name, mesh, "exact", surface, m_offsets.curves, offsets.curves, text(difference / m_diagonal, 2));
    print(name, mesh, "fast marching", surface, m_offsets.contours, offsets.contours, "");
    draw(geodesic, mesh, sections, offsets);
    return difference / m_diagonal;
  }

  void print(const std::string& name, const Mesh& mesh, const std::string& method, double surface, const Polylines& a,
             const Polylines& b, const std::string& difference) const
  {
    std::size_t same = 0;
    double largest = 0, sum = 0;
    std::size_t points = 0;
    for (std::size_t i = 1; i <= number_of_levels; ++i)
    {
      const auto of_a = a.find(i), of_b = b.find(i);
      const bool is_in_a = of_a != a.end(), is_in_b = of_b != b.end();
      same += (is_in_a ? of_a->second.size() : 0) == (is_in_b ? of_b->second.size() : 0) ? 1 : 0;
      if (!is_in_a || !is_in_b) continue;
      for (const auto* pair : {&*of_a, &*of_b})
        for (const Polyline& p : pair->second)
          for (const Point& x : p)
          {
            const double d = distance(x, (pair == &*of_a ? of_b : of_a)->second);
            largest = (std::max)(largest, d);
            sum += d;
            ++points;
          }
    }
    print_row({m_model.name, text(m_model.number_of_vertices()), name, text(std::size_t(mesh.number_of_vertices())),
               text(surface / m_diagonal, 2), method, text(same) + " of " + text(number_of_levels),
               text(largest / m_spacing, 2), text(sum / static_cast<double>(points) / m_spacing, 2), difference});
  }

  static double distance(const Point& x, const std::vector<Polyline>& polylines)
  {
    double least = geodesic_offset::infinity;
    for (const Polyline& p : polylines)
      for (std::size_t i = 0; i + 1 < p.size(); ++i)
      {
        const Vector a = x - p[i], d = p[i + 1] - p[i];
        const double dd = d * d, t = dd > 0 ? (std::min)((std::max)(a * d / dd, 0.), 1.) : 0;
        least = (std::min)(least, (a - t * d).squared_length());
      }
    return std::sqrt(least);
  }

  void draw(const Geodesic& geodesic, const Mesh& mesh, const std::vector<Surface_polyline>& sections, const Offsets& offsets)
  {
    Drawing drawing;
    for (const auto& level : offsets.curves)
      drawing.offsets.insert(drawing.offsets.end(), level.second.begin(), level.second.end());
    drawing.sources = points_on(mesh, sections);
    m_panels.push_back(panel(geodesic, mesh, *m_view, geodesic_offset::Extent(m_model.mesh, *m_view), drawing, 360));
  }

  const Model& m_model;
  const double m_diagonal;
  const Kernel::Plane_3 m_plane;
  Geodesic m_geodesic;
  std::vector<Surface_polyline> m_sections;
  double m_spacing = 0;
  Offsets m_offsets;
  std::optional<View> m_view;
  std::vector<Image> m_panels;
};

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> pictures;
  const int result =
    paper::run_on_models(argc, argv, "figure_10_resolutions",
                         R"(
## Fig. 10: Resolutions and Triangulations

*The paper* shows "Moai" with 11K and with 3K vertices, which is not at hand, and the offsets of a section by one plane. They are
consistent, as far as the pictures show.

*Here*, the offsets at 20 distances of a section by one plane are compared on the model, on the same surface with additional
vertices at random places in faces and on edges, and on models simplified to 3/11 of the edges, the ratio in the paper, and to
1/11. On the same surface the offsets are the same up to the chord tolerance of the polylines that are compared, 1e-6 of the
diagonal, and their points have the same distances up to rounding. Contours by fast marching change with the triangulation alone.
On simplified models, another surface, distances change by a few times the change of the surface.

The columns: the largest distance of a vertex of the model from the other surface, in diagonals of the bounding box; the levels
with the same number of curves; the distance between the curves of a level, in spacings of the levels, where a curve that one of
the surfaces alone has counts with its distance from the next; and the largest difference between the level of an offset and the
distance of its points on the model, in diagonals.

| model | vertices | compared with | vertices | surface | method | same number of curves | largest distance | mean distance | difference of distances |
|---|---|---|---|---|---|---|---|---|---|
)",
                         [&](const paper::Model& model, const std::string& prefix) {
                           pictures.push_back(prefix + ".png");
                           Experiment(model, pictures.back());
                         });
  for (const std::string& p : pictures)
    paper::print_picture(p, "Offsets on the model, on the same surface triangulated again, and on simplified models");
  return result;
}
