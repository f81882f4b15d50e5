// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Python module geodesic_offset: offset curves, Voronoi diagrams, split meshes and certificates.

#include "documentation.h"
#include "input.h"

#include <CGAL/Surface_mesh_geodesic_offset/Surface_mesh_geodesic_enclosure.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_geodesic_voronoi_diagram.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_offset_curves.h>
#include <CGAL/Surface_mesh_geodesic_offset/split_along_polylines.h>

#include <algorithm>
#include <iterator>
#include <map>

namespace geodesic_offset_python {

// Rows of structured arrays.
struct Element_row
{
  double start[3], end[3], center[3], normal[3], radius, sweep, length;
  std::int64_t source, side;
};
struct Point_row
{
  double point[3], tangent[3], normal[3];
  std::int64_t face;
};

namespace {

using Diagram = Field::Voronoi_diagram;
using Bisector = Diagram::Curve;
using Enclosure = CGAL::Surface_mesh_geodesic_enclosure<Traits>;
using Sides = std::map<std::size_t, CGAL::Offset_side>;

struct Shared_diagram
{
  Mesh_ptr mesh;
  Diagram diagram;
};

struct Shared_bisector
{
  Mesh_ptr mesh;
  Bisector curve;
};

struct Certificate
{
  CGAL::Geodesic_offset_certificate<Face_location> certificate;
};

template <class Vector_or_point>
void write(const Vector_or_point& v, double* x)
{
  for(int k = 0; k < 3; ++k) x[k] = v[k];
}

Levels read_levels(const py::object& argument)
{
  if(py::isinstance<Levels>(argument)) return argument.cast<Levels>();
  const std::optional<py::array> array = numbers(argument);
  if(!array) throw py::type_error("geodesic_offset: levels are a number, an array of numbers, or Levels");
  const Doubles values(*array);
  return Levels(std::vector<double>(values.data(), values.data() + values.size()));
}

// The sides of the sources 0, 1, 2, ..., `number` - 1.
Sides read_sides(const py::object& argument, std::size_t number)
{
  if(py::isinstance<py::dict>(argument)) return argument.cast<Sides>();
  Sides sides;
  for(std::size_t i = 0; i < number; ++i) sides[i] = argument.cast<CGAL::Offset_side>();
  return sides;
}

py::list exported_curves(const Mesh_ptr& mesh, std::vector<Offset_curve>&& curves)
{
  py::list result;
  for(Offset_curve& c : curves) result.append(Shared_curve{mesh, std::move(c)});
  return result;
}

// f(np), with the style in the named parameters if there is one
template <class NamedParameters, class Function>
void with_style(const NamedParameters& np, const std::optional<CGAL::Offset_end>& style, const Function& f)
{
  if(style)
    f(np.end_style(*style));
  else
    f(np);
}

py::list offsets(const Mesh_ptr& mesh, const py::object& sources, const py::object& levels_argument, const py::object& side,
                 const std::optional<CGAL::Offset_end>& end_style, double distance_limit, double relative_tolerance,
                 double merging_tolerance, const py::object& function, bool parallel)
{
  const Levels levels = read_levels(levels_argument);
  const Source_set set = read_sources(*mesh, sources);
  const Sides sides = read_sides(side, set.size());
  if(!levels.is_unlimited() && levels.size() > 0) distance_limit = std::min(distance_limit, levels[levels.size() - 1]);
  std::vector<Offset_curve> curves;
  Visitor visitor(function);
  without_gil(parallel, [&](auto tag) {
    Geodesic geodesic(*mesh->prepared);
    geodesic.add_sources(set);
    const auto np =
      CGAL::parameters::offset_side(sides)
        .distance_limit(distance_limit)
        .relative_tolerance(relative_tolerance)
        .merging_tolerance(merging_tolerance)
        .visitor(std::ref(visitor))
        .concurrency_tag(tag);
    with_style(np, end_style,
               [&](const auto& all) { geodesic.build_with_offset_curves(levels, std::back_inserter(curves), all); });
  });
  return exported_curves(mesh, std::move(curves));
}

py::list offset_curves(const Shared_field& self, const py::object& levels_argument, const py::object& side,
                       const std::optional<CGAL::Offset_end>& end_style, bool parallel)
{
  const Levels levels = read_levels(levels_argument);
  const Sides sides = read_sides(side, self.number_of_sources);
  std::vector<Offset_curve> curves;
  without_gil(parallel, [&](auto tag) {
    const auto np = CGAL::parameters::offset_side(sides).concurrency_tag(tag);
    with_style(np, end_style, [&](const auto& all) { self.field.offset_curves(levels, std::back_inserter(curves), all); });
  });
  return exported_curves(self.mesh, std::move(curves));
}

py::array curve_points(const Shared_curve& self, double chord_tolerance)
{
  std::vector<Point> points;
  without_gil([&] { self.curve.points(chord_tolerance, std::back_inserter(points)); });
  return moved<double>(std::move(points), 3);
}

py::tuple curve_locations(const Shared_curve& self, double chord_tolerance)
{
  std::vector<Face_location> locations;
  without_gil([&] { self.curve.face_locations(chord_tolerance, std::back_inserter(locations)); });
  return exported(locations);
}

py::array curve_elements(const Shared_curve& self, double tolerance)
{
  std::vector<Element_row> rows;
  without_gil([&] {
    for(const Offset_curve::Element& e : self.curve.elements(tolerance))
    {
      Element_row row{{}, {}, {nan, nan, nan}, {}, nan, e.sweep(), e.length(), -1, -1};
      write(e.start(), row.start);
      write(e.end(), row.end);
      write(e.normal(), row.normal);
      if(e.is_arc())
      {
        write(e.center(), row.center);
        row.radius = e.radius();
      }
      if(e.source()) row.source = static_cast<std::int64_t>(*e.source());
      if(e.side()) row.side = static_cast<std::int64_t>(*e.side());
      rows.push_back(row);
    }
  });
  return moved<Element_row>(std::move(rows));
}

py::array points_at_spacing(const Shared_curve& self, double spacing)
{
  std::vector<Point_row> rows;
  without_gil([&] {
    std::vector<Offset_curve::Oriented_point> points;
    self.curve.points_at_spacing(spacing, std::back_inserter(points));
    for(const auto& p : points)
    {
      Point_row row{{}, {}, {}, static_cast<std::int64_t>(p.location.first.idx())};
      write(p.point, row.point);
      write(p.tangent, row.tangent);
      write(p.normal, row.normal);
      rows.push_back(row);
    }
  });
  return moved<Point_row>(std::move(rows));
}

Shared_diagram diagram_of(const Shared_field& field)
{
  return {field.mesh, without_gil([&] { return field.field.voronoi_diagram(); })};
}

py::array diagram_vertices(const Shared_diagram& self)
{
  std::vector<Point> points;
  for(std::size_t i = 0; i < self.diagram.number_of_vertices(); ++i) points.push_back(self.diagram.vertex_point(i));
  return moved<double>(std::move(points), 3);
}

py::object source_at(const Shared_diagram& self, const py::object& argument)
{
  const Locations given = read_locations(*self.mesh, argument);
  std::vector<std::int64_t> sources;
  for(const Face_location& l : in_faces(*self.mesh, given))
    sources.push_back(static_cast<std::int64_t>(self.diagram.source_at(l)));
  return given.shaped(moved<std::int64_t>(std::move(sources)));
}

py::array source_at_face(const Shared_diagram& self)
{
  std::vector<std::int64_t> sources;
  for(const Face f : self.mesh->tm.faces()) sources.push_back(static_cast<std::int64_t>(self.diagram.source_at_face(f)));
  return moved<std::int64_t>(std::move(sources));
}

// A mesh that is split, and what the split writes.
class Splitting
{
  Mesh m_tm;
  Mesh::Property_map<Edge, bool> m_is_constrained;
  Mesh::Property_map<Face, std::size_t> m_label;

public:
  explicit Splitting(const Mesh& tm)
    : m_tm(tm), m_is_constrained(m_tm.add_property_map<Edge, bool>("e:is_on_curve", false).first),
      m_label(m_tm.add_property_map<Face, std::size_t>("f:label", 0).first)
  {
  }

  Mesh& mesh() { return m_tm; }
  auto parameters() const { return CGAL::parameters::edge_is_constrained_map(m_is_constrained); }
  const auto& labels() const { return m_label; }

  // The tuple of Python; `is_band`: whether labels are bands, or sources; or neither.
  py::object result(const std::optional<bool>& is_band)
  {
    m_tm.collect_garbage();
    std::vector<Point> points;
    std::vector<std::int64_t> faces, labels, edges;
    for(const Vertex v : m_tm.vertices()) points.push_back(m_tm.point(v));
    for(const Face f : m_tm.faces())
    {
      for(const Vertex v : m_tm.vertices_around_face(m_tm.halfedge(f))) faces.push_back(v.idx());
      labels.push_back(static_cast<std::int64_t>(m_label[f]));
    }
    for(const Edge e : m_tm.edges())
      if(m_is_constrained[e])
        for(unsigned k = 0; k < 2; ++k) edges.push_back(m_tm.vertex(e, k).idx());
    const py::object label_array = is_band ? py::object(moved<std::int64_t>(std::move(labels))) : py::none();
    const bool are_bands = is_band.value_or(false);
    return py::module_::import("geodesic_offset")
      .attr("Split")(moved<double>(std::move(points), 3), moved<std::int64_t>(std::move(faces), 3),
                     are_bands ? label_array : py::none(), are_bands ? py::none() : label_array,
                     moved<std::int64_t>(std::move(edges), 2));
  }
};

// f(np), with the chord tolerance in the named parameters if there is one
template <class NamedParameters, class Function>
void with_tolerance(const NamedParameters& np, const std::optional<double>& tolerance, const Function& f)
{
  const py::gil_scoped_release release;
  if(tolerance)
    f(np.chord_tolerance(*tolerance));
  else
    f(np);
}

// The curves of a list as objects of C++.
template <class Shared, class Curve>
std::vector<Curve> read_curves(const Mesh_ptr& mesh, const py::list& list, Curve Shared::*curve)
{
  std::vector<Curve> result;
  for(const py::handle item : list)
  {
    const Shared& shared = item.cast<const Shared&>();
    if(shared.mesh != mesh) throw py::value_error("geodesic_offset: a curve of another mesh");
    result.push_back(shared.*curve);
  }
  return result;
}

py::object split(const Mesh_ptr& mesh, const py::object& argument, const std::optional<double>& chord_tolerance)
{
  Splitting splitting(mesh->tm);
  if(py::isinstance<Shared_diagram>(argument))
  {
    const Shared_diagram& d = argument.cast<const Shared_diagram&>();
    if(d.mesh != mesh) throw py::value_error("geodesic_offset: a diagram of another mesh");
    with_tolerance(splitting.parameters().face_source_map(splitting.labels()), chord_tolerance,
                   [&](const auto& np) { CGAL::split_along_geodesic_voronoi_diagram(splitting.mesh(), d.diagram, np); });
    return splitting.result(false);
  }
  const py::list list = argument.cast<py::list>();
  if(list.size() > 0 && py::isinstance<Shared_polyline>(list[0]))
  {
    const std::vector<Polyline> polylines = read_curves(mesh, list, &Shared_polyline::polyline);
    without_gil([&] { CGAL::split_along_polylines(splitting.mesh(), polylines, splitting.parameters()); });
    return splitting.result(std::nullopt);
  }
  const std::vector<Offset_curve> curves = read_curves(mesh, list, &Shared_curve::curve);
  with_tolerance(splitting.parameters().face_band_map(splitting.labels()), chord_tolerance,
                 [&](const auto& np) { CGAL::split_along_offset_curves(splitting.mesh(), curves, np); });
  return splitting.result(true);
}

// Bounds of the distances, with windows for certificates.
Enclosure enclosure_of(const Shared_mesh& mesh, const py::object& sources, bool keep_windows)
{
  const Source_set set = read_sources(mesh, sources);
  const py::gil_scoped_release release;
  Enclosure enclosure(*mesh.prepared);
  enclosure.add_sources(set);
  enclosure.build(CGAL::parameters::keep_windows(keep_windows));
  return enclosure;
}

Certificate certify(const Mesh_ptr& mesh, const py::object& sources, double distance, const py::list& list)
{
  if(list.size() > 0 && py::isinstance<Shared_curve>(list[0]))
  {
    const std::vector<Offset_curve> curves = read_curves(mesh, list, &Shared_curve::curve);
    const Enclosure enclosure = enclosure_of(*mesh, sources, true);
    return {without_gil([&] { return enclosure.certify_offset(distance, curves); })};
  }
  std::vector<Polyline> polylines;
  for(const py::handle item : list)
    if(py::isinstance<Shared_polyline>(item))
      polylines.push_back(item.cast<const Shared_polyline&>().polyline);
    else
      polylines.push_back(read_polyline(*mesh, py::reinterpret_borrow<py::object>(item), std::nullopt, std::nullopt));
  const Enclosure enclosure = enclosure_of(*mesh, sources, true);
  return {without_gil([&] { return enclosure.certify_offset(distance, polylines); })};
}

py::array distance_bounds(const Shared_mesh& mesh, const py::object& sources)
{
  const Enclosure enclosure = enclosure_of(mesh, sources, false);
  std::vector<double> bounds;
  for(const Vertex v : mesh.tm.vertices())
  {
    const std::pair<double, double> b = enclosure.distance_bounds(v);
    bounds.insert(bounds.end(), {b.first, b.second});
  }
  return moved<double>(std::move(bounds), 2);
}

py::object certificate_location(const Certificate& c)
{
  if(!c.certificate.location) return py::none();
  const py::tuple l = exported({*c.certificate.location});
  return py::make_tuple(l[0][py::int_(0)], l[1][py::int_(0)]);
}

void define_enums(py::module_& module)
{
  py::enum_<CGAL::Offset_side>(module, "Offset_side", "The side of polylines on which offset curves are requested.")
    .value("BOTH", CGAL::Offset_side::BOTH)
    .value("LEFT", CGAL::Offset_side::LEFT)
    .value("RIGHT", CGAL::Offset_side::RIGHT)
    .value("INSIDE", CGAL::Offset_side::INSIDE)
    .value("OUTSIDE", CGAL::Offset_side::OUTSIDE);
  py::enum_<CGAL::Offset_end>(module, "Offset_end", "The cap style at the ends of open polylines.")
    .value("ROUND", CGAL::Offset_end::ROUND)
    .value("BUTT", CGAL::Offset_end::BUTT);
  py::enum_<CGAL::Source_side>(module, "Source_side", "The side of a source at which the shortest path starts.")
    .value("NONE", CGAL::Source_side::NONE)
    .value("LEFT", CGAL::Source_side::LEFT)
    .value("RIGHT", CGAL::Source_side::RIGHT)
    .value("CAP", CGAL::Source_side::CAP);
  using Limit = CGAL::Offset_certificate_limit;
  py::enum_<Limit>(module, "Offset_certificate_limit",
                   "What the tolerance of a Certificate is needed for, or why there is no region.")
    .value("NONE", Limit::NONE)
    .value("CURVE_TOO_NEAR", Limit::CURVE_TOO_NEAR)
    .value("CURVE_TOO_FAR", Limit::CURVE_TOO_FAR)
    .value("REGION_TOO_FAR", Limit::REGION_TOO_FAR)
    .value("SOURCE_OUTSIDE", Limit::SOURCE_OUTSIDE)
    .value("OPEN_END", Limit::OPEN_END)
    .value("NOT_JOINED", Limit::NOT_JOINED)
    .value("NO_REGION", Limit::NO_REGION);
}

void define_offset_curve(py::module_& module)
{
  PYBIND11_NUMPY_DTYPE(Element_row, start, end, center, normal, radius, sweep, length, source, side);
  PYBIND11_NUMPY_DTYPE(Point_row, point, tangent, normal, face);
  py::class_<Levels>(module, "Levels", "Distances of offset curves.")
    .def_static(
      "equally_spaced",
      [](double spacing, const std::optional<std::size_t>& count, const std::optional<double>& start) {
        return Levels::equally_spaced(spacing, count.value_or(Levels::unlimited), start.value_or(spacing));
      },
      py::arg("spacing"), py::arg("count") = py::none(), py::arg("start") = py::none(), docs::levels);
  py::class_<Shared_curve>(module, "Offset_curve", docs::offset_curve)
    .def_property_readonly(
      "distance", [](const Shared_curve& c) { return c.curve.distance(); }, "The requested distance.")
    .def_property_readonly(
      "tolerance", [](const Shared_curve& c) { return c.curve.tolerance(); },
      "Bound of the error of the distance: 0 if the build had no tolerance.")
    .def_property_readonly(
      "is_closed", [](const Shared_curve& c) { return c.curve.is_closed(); }, "Whether the curve is closed.")
    .def_property_readonly(
      "number_of_pieces", [](const Shared_curve& c) { return c.curve.number_of_pieces(); },
      "Number of arcs and segments, each in one face.")
    .def_property_readonly(
      "length", [](const Shared_curve& c) { return c.curve.length(); }, "Length, with arcs as arcs.")
    .def_property_readonly(
      "side", [](const Shared_curve& c) { return c.curve.side(); },
      "Source_side on which the whole curve lies, or None for several.")
    .def("points", &curve_points, py::arg("chord_tolerance"), docs::curve_points)
    .def("face_locations", &curve_locations, py::arg("chord_tolerance"), docs::curve_locations)
    .def("elements", &curve_elements, py::arg("tolerance") = 0., docs::curve_elements)
    .def("points_at_spacing", &points_at_spacing, py::arg("spacing"), docs::points_at_spacing);
}

void define_diagram(py::module_& module)
{
  py::class_<Shared_bisector>(module, "Bisector", docs::bisector)
    .def_property_readonly(
      "source_on_left", [](const Shared_bisector& b) { return b.curve.source_on_left(); }, "int")
    .def_property_readonly(
      "source_on_right", [](const Shared_bisector& b) { return b.curve.source_on_right(); }, "int")
    .def_property_readonly(
      "is_closed", [](const Shared_bisector& b) { return b.curve.is_closed(); }, "bool")
    .def_property_readonly(
      "start_vertex", [](const Shared_bisector& b) { return b.curve.start_vertex(); },
      "Number of the vertex of the diagram; None on the border, and for closed curves.")
    .def_property_readonly(
      "end_vertex", [](const Shared_bisector& b) { return b.curve.end_vertex(); }, "As start_vertex.")
    .def(
      "points",
      [](const Shared_bisector& b, double chord_tolerance) {
        std::vector<Point> points;
        without_gil([&] { b.curve.points(chord_tolerance, std::back_inserter(points)); });
        return moved<double>(std::move(points), 3);
      },
      py::arg("chord_tolerance"), docs::curve_points);
  py::class_<Shared_diagram>(module, "Voronoi_diagram", docs::diagram_class)
    .def_property_readonly(
      "curves",
      [](const Shared_diagram& d) {
        py::list result;
        for(std::size_t i = 0; i < d.diagram.number_of_curves(); ++i)
          result.append(Shared_bisector{d.mesh, d.diagram.curve(i)});
        return result;
      },
      "List of Bisector.")
    .def_property_readonly("vertices", &diagram_vertices, "Points where three or more curves end: float64 (n, 3).")
    .def("source_at_face", &source_at_face, "Number of the source at the center of each face: int64 (number_of_faces,).")
    .def("source_at", &source_at, py::arg("locations"), docs::source_at);
}

void define_certificate(py::module_& module)
{
  py::class_<Certificate>(module, "Certificate", docs::certificate)
    .def_property_readonly("bounds_region", [](const Certificate& c) { return c.certificate.bounds_region; })
    .def_property_readonly("tolerance", [](const Certificate& c) { return c.certificate.tolerance; })
    .def_property_readonly("limit", [](const Certificate& c) { return c.certificate.limit; })
    .def_property_readonly("location", &certificate_location)
    .def_property_readonly("distance_bounds", [](const Certificate& c) { return c.certificate.distance_bounds; })
    .def_property_readonly("curve", [](const Certificate& c) { return c.certificate.curve; })
    .def_property_readonly("number_of_reversed_curves", [](const Certificate& c) {
      return c.certificate.number_of_reversed_curves;
    });
}

} // namespace

void define_curves(py::module_& module, py::class_<Shared_mesh, Mesh_ptr>& mesh, py::class_<Shared_field>& field)
{
  define_enums(module);
  define_offset_curve(module);
  define_diagram(module);
  define_certificate(module);
  mesh
    .def("offsets", &offsets, py::arg("sources"), py::arg("levels"), py::arg("offset_side") = CGAL::Offset_side::BOTH,
         py::arg("end_style") = py::none(), py::arg("distance_limit") = infinity, py::arg("relative_tolerance") = 0.,
         py::arg("merging_tolerance") = 0., py::arg("visitor") = py::none(), py::arg("parallel") = false, docs::offsets)
    .def(
      "voronoi",
      [](const py::object& self, const py::object& sources, const py::object& visitor, bool parallel) {
        return self
          .attr("field")(sources, py::arg("keep_windows") = true, py::arg("visitor") = visitor, py::arg("parallel") = parallel)
          .attr("voronoi_diagram")();
      },
      py::arg("sources"), py::arg("visitor") = py::none(), py::arg("parallel") = false, docs::voronoi)
    .def("split", &split, py::arg("curves"), py::arg("chord_tolerance") = py::none(), docs::split)
    .def("certify", &certify, py::arg("sources"), py::arg("distance"), py::arg("curves"), docs::certify)
    .def("distance_bounds", &distance_bounds, py::arg("sources"), docs::distance_bounds);
  field
    .def("offset_curves", &offset_curves, py::arg("levels"), py::arg("offset_side") = CGAL::Offset_side::BOTH,
         py::arg("end_style") = py::none(), py::arg("parallel") = false, docs::offset_curves)
    .def("voronoi_diagram", &diagram_of, docs::voronoi_diagram);
}

} // namespace geodesic_offset_python
