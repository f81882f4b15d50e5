// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// Fig. 14 of the paper: geodesics are orthogonal to offsets.
//
//   figure_14_geodesics FOLDER_FOR_PICTURES MODEL...
//
// Shortest paths from 300 vertices to a plane section cross the offsets at 20 distances, and the contours of the exact
// distances of vertices, interpolated linearly in each face. Each crossing is computed in the plane of its face, from the
// segment of the path and the arc or segment of the curve.

#include "experiment.h"
#include "interpolated_offset.h"

namespace {

using namespace paper;

typedef Kernel::Point_2 Point_2;
typedef Kernel::Vector_2 Vector_2;

constexpr std::size_t number_of_levels = 20;
constexpr std::size_t number_of_paths = 300;
constexpr std::size_t paths_in_picture = 60;

// Largest deviation of exact curves, in degrees: the ends of the segments of paths are rounded to 1e-15 of the size of the
// model, and the shortest segments have 1e-7 of this size.
constexpr double deviation_of_exact_offsets = 1e-6;

constexpr double degrees = 180 / 3.14159265358979323846;

// An arc from `start` counterclockwise to `end`, or a segment, in the frame of a face.
struct Curve_piece
{
  Point_2 start, end;
  bool is_arc;
  Point_2 center;
  double radius;
};

typedef std::map<Face, std::vector<Curve_piece>> Pieces;

struct Crossings
{
  std::size_t number = 0, oblique = 0;
  double largest = 0, sum = 0; // of the deviations from a right angle, in degrees

  // Vectors along the path, and at right angles to the curve.
  void add(const Vector_2& path, const Vector_2& normal)
  {
    const double deviation =
      degrees * std::atan2(std::abs(path.x() * normal.y() - path.y() * normal.x()), std::abs(path * normal));
    ++number;
    oblique += deviation > 1 ? 1 : 0;
    sum += deviation;
    largest = (std::max)(largest, deviation);
  }

  void add_crossings(const Point_2& p, const Point_2& q, const Curve_piece& piece)
  {
    const Vector_2 d = q - p;
    if (!piece.is_arc)
    {
      const Vector_2 along = piece.end - piece.start, normal(-along.y(), along.x());
      const double at_p = normal * (p - piece.start), at_q = normal * (q - piece.start);
      if ((at_p < 0) == (at_q < 0)) return;
      const double t = at_p / (at_p - at_q), s = (p + t * d - piece.start) * along / along.squared_length();
      if (s >= 0 && s <= 1) add(d, normal);
      return;
    }
    const Vector_2 a = p - piece.center;
    const double dd = d * d, ad = a * d, root = ad * ad - dd * (a * a - piece.radius * piece.radius);
    if (!(root > 0)) return;
    for (double sign : {-1., 1.})
    {
      const double t = (sign * std::sqrt(root) - ad) / dd;
      const Point_2 x = p + t * d;
      if (t >= 0 && t < 1 && !CGAL::right_turn(piece.center, piece.start, x) && !CGAL::left_turn(piece.center, piece.end, x))
        add(d, x - piece.center);
    }
  }
};

class Experiment
{
public:
  Experiment(const Model& model, const std::string& picture)
    : m_mesh(model.mesh), m_on_mesh(m_mesh), m_geodesic(m_mesh), m_sections(add_section(m_geodesic, middle_plane(model.box())))
  {
    m_geodesic.build();
    const double spacing = m_geodesic.field().largest_vertex_distance().value() / static_cast<double>(number_of_levels + 1);
    std::vector<Offset_curve> curves;
    m_geodesic.build_with_offset_curves(Levels::equally_spaced(spacing, number_of_levels), std::back_inserter(curves),
                                        CGAL::parameters::keep_windows(true));
    Pieces exact, interpolated;
    for (const Offset_curve& c : curves)
      for (const auto& p : c.pieces())
        exact[p.face()].push_back({p.start_2(), p.end_2(), p.is_arc(), p.is_arc() ? p.center() : Point_2(),
                                   p.is_arc() ? p.radius() : 0});
    for (std::size_t i = 1; i <= number_of_levels; ++i)
      for (const Surface_polyline& c : interpolated_offset(
             m_mesh, [&](Vertex v) { return m_geodesic.distance_to_sources(v); }, static_cast<double>(i) * spacing))
        for (std::size_t k = 0; k + (c.is_closed ? 0 : 1) < c.locations.size(); ++k)
        {
          const Segment s(*this, c.locations[k], c.locations[(k + 1) % c.locations.size()]);
          interpolated[s.face].push_back({s.start, s.end, false, Point_2(), 0});
        }

    Drawing drawing;
    Crossings of_exact, of_interpolated;
    for (std::size_t i = 0; i < number_of_paths; ++i)
    {
      const Vertex v(static_cast<Mesh::size_type>(i * m_mesh.number_of_vertices() / number_of_paths));
      std::vector<Face_location> path;
      m_geodesic.shortest_path_to_sources(v, std::back_inserter(path));
      for (std::size_t k = 0; k + 1 < path.size(); ++k)
      {
        const Segment s(*this, path[k], path[k + 1]);
        for (const Curve_piece& piece : exact[s.face]) of_exact.add_crossings(s.start, s.end, piece);
        for (const Curve_piece& piece : interpolated[s.face]) of_interpolated.add_crossings(s.start, s.end, piece);
      }
      if (i % (number_of_paths / paths_in_picture) == 0) drawing.paths.push_back(points_on(m_mesh, {path, false}));
    }
    print(model, "exact offsets", of_exact);
    print(model, "interpolated exact distances of vertices", of_interpolated);

    drawing.add_offsets(curves, model.diagonal());
    drawing.sources = points_on(m_mesh, m_sections);
    std::vector<Point> visible;
    for (const Polyline& p : drawing.paths) visible.insert(visible.end(), p.begin(), p.end());
    const View view = geodesic_offset::choose_view(m_mesh, visible, Vector(0, 1, 0));
    write_indexed_png(picture, panel(m_geodesic, m_mesh, view, geodesic_offset::Extent(m_mesh, view), drawing, 640));
    expect(of_exact.number > 0 && of_exact.largest <= deviation_of_exact_offsets,
           "an offset deviates from a right angle by " + text(of_exact.largest) + " degrees");
  }

private:
  // The frame of a face is that of `Geodesic_offset_piece`.
  struct Segment
  {
    Face face;
    Point_2 start, end;

    Segment(const Experiment& e, const Face_location& a, const Face_location& b) : face(e.m_on_mesh.common_face(a, b))
    {
      const auto c = e.m_on_mesh.corners(face);
      const Vector x = e.m_mesh.point(c[1]) - e.m_mesh.point(c[0]), y = e.m_mesh.point(c[2]) - e.m_mesh.point(c[0]);
      const double length = std::sqrt(x.squared_length());
      const Vector_2 second(length, 0), third(x * y / length, std::sqrt(CGAL::cross_product(x, y).squared_length()) / length);
      const auto place = [&](const Face_location& l) {
        std::array<double, 3> w;
        e.m_on_mesh.express(l, face, w);
        return Point_2(0, 0) + w[1] * second + w[2] * third;
      };
      start = place(a);
      end = place(b);
    }
  };

  void print(const Model& model, const std::string& curves, const Crossings& c) const
  {
    print_row({model.name, text(model.number_of_vertices()), curves, text(c.number), text(c.largest, 2),
               text(c.sum / static_cast<double>(c.number), 2), text(c.oblique)});
  }

  const Mesh& m_mesh;
  const test::Locations<Mesh> m_on_mesh;
  Geodesic m_geodesic;
  const std::vector<Surface_polyline> m_sections;
};

} // namespace

int main(int argc, char* argv[])
{
  std::vector<std::string> pictures;
  const int result =
    paper::run_on_models(argc, argv, "figure_14_geodesics",
                         R"(
## Fig. 14: Geodesics Are Orthogonal to Offsets

*The paper* shows geodesics on "Laurana", a model of 10K vertices that is not at hand: they are orthogonal to the offset curves
everywhere, as far as the picture shows.

*Here*, shortest paths from 300 vertices to a section by a plane cross the offsets at 20 distances. The angle at each crossing is
computed in the plane of its face, from the segment of the path and the arc or segment of the offset, which were computed apart.
The contours of the exact distances of vertices, interpolated linearly in each face, are crossed by the same paths.

| model | vertices | curves | crossings | largest deviation from 90 degrees | mean deviation | off by more than 1 degree |
|---|---|---|---|---|---|---|
)",
                         [&](const paper::Model& model, const std::string& prefix) {
                           pictures.push_back(prefix + ".png");
                           Experiment(model, pictures.back());
                         });
  for (const std::string& p : pictures) paper::print_picture(p, "Offsets, and geodesics to their source");
  return result;
}
