// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// The Python module geodesic_offset: meshes, sources, and distances; curves are in curves.cpp.

#include "common/polygon_links.h"
#include "documentation.h"
#include "input.h"

#include <CGAL/Surface_mesh_geodesic_offset/geodesic_distance_matrix.h>
#include <CGAL/Surface_mesh_geodesic_offset/geodesic_farthest_points.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace geodesic_offset_python {
namespace {

// Faces with three different vertices of the mesh.
// \throws std::invalid_argument if there are others
std::vector<Polygon> read_faces(const py::array& given, std::size_t number_of_vertices)
{
  if(given.size() != 0 && (given.ndim() != 2 || given.shape(1) != 3))
    throw std::invalid_argument("geodesic_offset: faces are an array with three columns");
  if(given.size() != 0 && given.dtype().kind() != 'i' && given.dtype().kind() != 'u')
    throw py::type_error("geodesic_offset: faces are an array of integers");
  const Indices indices(given);
  std::vector<Polygon> faces(static_cast<std::size_t>(indices.size() / 3));
  for(std::size_t f = 0; f < faces.size(); ++f)
    for(std::size_t k = 0; k < 3; ++k)
    {
      const std::int64_t v = indices.data()[3 * f + k];
      if(v < 0 || static_cast<std::uint64_t>(v) >= number_of_vertices)
        throw std::invalid_argument("geodesic_offset: face " + std::to_string(f) + " has vertex " + std::to_string(v) +
                                    ", but there are " + std::to_string(number_of_vertices) + " vertices");
      if(std::count(faces[f].begin(), faces[f].end(), v) != 0)
        throw std::invalid_argument("geodesic_offset: face " + std::to_string(f) + " has vertex " + std::to_string(v) +
                                    " twice");
      faces[f].push_back(static_cast<std::uint32_t>(v));
    }
  return faces;
}

void add_faces(Mesh& tm, const std::vector<Polygon>& faces)
{
  const Polygon_links links(faces, tm.number_of_vertices());
  if(!links.is_manifold())
  {
    std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
    for(std::size_t f = 0; f < faces.size(); ++f)
      for(std::size_t k = 0; k < 3; ++k)
        if(const std::uint32_t a = faces[f][k], b = faces[f][(k + 1) % 3]; !sides.emplace(a, b).second)
          throw std::invalid_argument("geodesic_offset: face " + std::to_string(f) +
                                      " and one before it both pass from vertex " + std::to_string(a) + " to vertex " +
                                      std::to_string(b) + ": their orientations differ, or more than two faces share the edge");
  }
  const std::vector<Vertex> at(tm.vertices().begin(), tm.vertices().end());
  links.link(tm, faces, at);
}

// Lengths of the edges, from those of the sides of faces.
std::vector<double> read_lengths(const Mesh& tm, const Doubles& lengths)
{
  if(lengths.ndim() != 2 || lengths.shape(1) != 3 || static_cast<std::size_t>(lengths.shape(0)) != tm.number_of_faces())
    throw std::invalid_argument("geodesic_offset: edge lengths are an array with a row per face and three columns");
  std::vector<double> result(tm.number_of_edges(), -1);
  for(const Face f : tm.faces())
  {
    Halfedge h = tm.next(tm.halfedge(f)); // from the first corner to the second
    for(std::size_t k = 0; k < 3; ++k, h = tm.next(h))
    {
      const double l = lengths.data()[3 * f.idx() + k];
      double& known = result[tm.edge(h).idx()];
      if(known >= 0 && known != l)
        throw std::invalid_argument("geodesic_offset: side " + std::to_string(k) + " of face " + std::to_string(f.idx()) +
                                    " has the length " + std::to_string(l) + ", but " + std::to_string(known) +
                                    " in the other face of the edge");
      known = l;
    }
  }
  return result;
}

struct Length_map
{
  using key_type = Edge;
  using value_type = double;
  using reference = double;
  using category = boost::readable_property_map_tag;
  const std::vector<double>* lengths;
  friend double get(const Length_map& map, Edge e) { return (*map.lengths)[e.idx()]; }
};

Mesh_ptr make_mesh(const std::optional<Doubles>& points, const py::object& faces_argument,
                   const std::optional<Doubles>& edge_lengths, bool parallel)
{
  if(faces_argument.is_none() || points.has_value() == edge_lengths.has_value())
    throw py::type_error("geodesic_offset: a mesh has faces, and either points or edge lengths");
  const std::optional<py::array> faces = numbers(faces_argument);
  if(!faces) throw py::type_error("geodesic_offset: faces are an array of integers");
  const auto mesh = std::make_shared<Shared_mesh>();
  if(points)
  {
    if(points->size() != 0 && (points->ndim() != 2 || points->shape(1) != 3))
      throw std::invalid_argument("geodesic_offset: points are an array with three columns");
    for(const Point& p : points_of(*points)) mesh->tm.add_vertex(p);
  }
  else if(faces->size() != 0)
  {
    const Indices indices(*faces);
    const std::int64_t last = *std::max_element(indices.data(), indices.data() + indices.size());
    for(std::int64_t v = 0; v <= last; ++v) mesh->tm.add_vertex(Point(0, 0, 0));
  }
  add_faces(mesh->tm, read_faces(*faces, mesh->tm.number_of_vertices()));
  const std::vector<double> lengths = edge_lengths ? read_lengths(mesh->tm, *edge_lengths) : std::vector<double>();
  without_gil(parallel, [&](auto tag) {
    const auto np = CGAL::parameters::concurrency_tag(tag);
    if(edge_lengths)
      mesh->prepared.emplace(mesh->tm, np.edge_length_map(Length_map{&lengths}));
    else
      mesh->prepared.emplace(mesh->tm, np);
  });
  return mesh;
}

// Points of the mesh, as a view that Python must not change.
py::array points_view(const py::object& self)
{
  const Mesh& tm = self.cast<const Shared_mesh&>().tm;
  const auto n = static_cast<py::ssize_t>(tm.number_of_vertices());
  const auto* const data = n == 0 ? nullptr : reinterpret_cast<const double*>(&tm.points()[Vertex(0)]);
  py::array_t<double> view({n, py::ssize_t(3)}, data, self);
  view.attr("setflags")(py::arg("write") = false);
  return std::move(view);
}

// The options of a build.
struct Options
{
  double distance_limit = infinity;
  bool keep_windows = false, compute_largest_distance = false;
  std::vector<Face_location> targets;
  double relative_tolerance = 0, merging_tolerance = 0;
  bool parallel = false;
};

Options read_options(const Shared_mesh& mesh, double distance_limit, const py::object& targets, double relative_tolerance,
                     double merging_tolerance, bool parallel)
{
  Options options;
  options.distance_limit = distance_limit;
  if(!targets.is_none()) options.targets = in_faces(mesh, read_locations(mesh, targets));
  options.relative_tolerance = relative_tolerance;
  options.merging_tolerance = merging_tolerance;
  options.parallel = parallel;
  return options;
}

Field build(const Shared_mesh& mesh, const Source_set& sources, const Options& options, const py::object& function)
{
  Visitor visitor(function);
  return without_gil(options.parallel, [&](auto tag) {
    Geodesic geodesic(*mesh.prepared);
    geodesic.add_sources(sources);
    return geodesic.build(CGAL::parameters::distance_limit(options.distance_limit)
                            .keep_windows(options.keep_windows)
                            .compute_largest_distance(options.compute_largest_distance)
                            .targets(std::cref(options.targets))
                            .relative_tolerance(options.relative_tolerance)
                            .merging_tolerance(options.merging_tolerance)
                            .visitor(std::ref(visitor))
                            .concurrency_tag(tag));
  });
}

py::array vertex_distances(const Shared_mesh& mesh, const Field& field)
{
  py::array_t<double> result(static_cast<py::ssize_t>(mesh.tm.number_of_vertices()));
  field.vertex_distances(Array_map<Vertex, double>{result.mutable_data()});
  return std::move(result);
}

py::array source_labels(const Shared_field& self)
{
  static_assert(Field::no_source() == std::numeric_limits<std::size_t>::max(), "which is -1 in Python");
  py::array_t<std::int64_t> result(static_cast<py::ssize_t>(self.mesh->tm.number_of_vertices()));
  self.field.source_labels(Array_map<Vertex, std::size_t>{reinterpret_cast<std::size_t*>(result.mutable_data())});
  return std::move(result);
}

// A result of `columns` numbers per location, which f(location, numbers) writes.
template <class Function>
py::object query(const Shared_field& self, const py::object& argument, py::ssize_t columns, const Function& f)
{
  const Locations locations = read_locations(*self.mesh, argument);
  const auto n = static_cast<py::ssize_t>(locations.size());
  py::array_t<double> result(columns == 1 ? std::vector<py::ssize_t>{n} : std::vector<py::ssize_t>{n, columns});
  double* const data = result.mutable_data();
  without_gil([&] {
    locations.for_each([&](std::size_t i, const auto& l) { f(l, data + i * static_cast<std::size_t>(columns)); });
  });
  return locations.shaped(result);
}

py::tuple nearest_source(const Shared_field& self, const py::object& argument)
{
  const Locations given = read_locations(*self.mesh, argument);
  std::vector<std::int64_t> sources(given.size(), -1);
  std::vector<Face_location> locations(given.size(), Face_location(Mesh::null_face(), {0, 0, 0}));
  without_gil([&] {
    given.for_each([&](std::size_t i, const auto& l) {
      if(const auto nearest = self.field.nearest_source(l))
      {
        sources[i] = static_cast<std::int64_t>(nearest->source);
        locations[i] = nearest->location;
      }
    });
  });
  const py::tuple exported_locations = exported(locations);
  return py::make_tuple(given.shaped(moved<std::int64_t>(std::move(sources))),
                        py::make_tuple(given.shaped(exported_locations[0]), given.shaped(exported_locations[1])));
}

// The only location of an argument: f(location)
template <class Function>
auto at_one(const Shared_field& self, const py::object& argument, const Function& f)
{
  const Locations given = read_locations(*self.mesh, argument);
  if(given.size() != 1) throw py::value_error("geodesic_offset: a path starts at one location");
  return without_gil([&] { return given.vertices.empty() ? f(given.locations.front()) : f(given.vertices.front()); });
}

py::array path_points(const Shared_field& self, const py::object& argument)
{
  std::vector<Point> points;
  at_one(self, argument, [&](const auto& l) { self.field.shortest_path_points_to_sources(l, std::back_inserter(points)); });
  return moved<double>(std::move(points), 3);
}

py::tuple path_locations(const Shared_field& self, const py::object& argument)
{
  std::vector<Face_location> path;
  at_one(self, argument, [&](const auto& l) { self.field.shortest_path_to_sources(l, std::back_inserter(path)); });
  return exported(path);
}

py::object farthest_point(const Shared_field& self)
{
  const auto farthest = without_gil([&] { return self.field.farthest_point(); });
  if(!farthest) return py::none();
  const py::tuple l = exported({farthest->first});
  return py::make_tuple(py::make_tuple(l[0][py::int_(0)], l[1][py::int_(0)]), farthest->second);
}

py::dict statistics(const Shared_field& self)
{
  const auto& s = self.field.statistics();
  py::dict d;
  d["windows_created"] = s.windows_created;
  d["windows_propagated"] = s.windows_propagated;
  d["windows_peak"] = s.windows_peak;
  d["windows_merged"] = s.windows_merged;
  d["kept_bytes"] = s.kept_bytes;
  d["error_bound"] = s.error_bound;
  d["relative_error_bound"] = s.relative_error_bound;
  d["propagation_seconds"] = s.propagation_seconds;
  return d;
}

// The array that receives a matrix: a given one, or a new one, whose rows are not numbers until they are computed.
py::array_t<double> matrix_array(const std::optional<py::array>& out, std::size_t rows, std::size_t columns)
{
  const auto n = static_cast<py::ssize_t>(rows), m = static_cast<py::ssize_t>(columns);
  if(!out)
  {
    py::array_t<double> result({n, m});
    std::fill_n(result.mutable_data(), rows * columns, nan);
    return result;
  }
  if(!py::isinstance<py::array_t<double, py::array::c_style>>(*out) || !out->writeable() || out->ndim() != 2 ||
     out->shape(0) != n || out->shape(1) != m)
    throw py::value_error("geodesic_offset: `out` is no writable contiguous array of float64 with " + std::to_string(rows) +
                          " rows and " + std::to_string(columns) + " columns");
  return py::reinterpret_borrow<py::array_t<double>>(*out);
}

py::array distance_matrix(const Shared_mesh& mesh, const py::object& sources, const py::object& targets, double distance_limit,
                          bool upper_half, const std::optional<py::array>& out, const py::object& function, bool parallel)
{
  const std::vector<Source_set> rows = read_rows(mesh, sources);
  Locations columns;
  if(targets.is_none())
    columns.vertices.assign(mesh.tm.vertices().begin(), mesh.tm.vertices().end());
  else
    columns = read_locations(mesh, targets);
  py::array_t<double> result = matrix_array(out, rows.size(), columns.size());
  double* const data = result.mutable_data();
  Visitor visitor(function);
  without_gil(parallel, [&](auto tag) {
    const auto np =
      CGAL::parameters::distance_limit(distance_limit)
        .upper_half(upper_half)
        .rows_in_order(false)
        .visitor(std::ref(visitor))
        .concurrency_tag(tag);
    const auto write = [&](std::size_t i, const std::vector<double>& row) {
      if(!row.empty()) std::memcpy(data + i * row.size(), row.data(), row.size() * sizeof(double));
    };
    if(columns.locations.empty())
      CGAL::geodesic_distance_matrix(*mesh.prepared, rows, columns.vertices, write, np);
    else
      CGAL::geodesic_distance_matrix(*mesh.prepared, rows, columns.locations, write, np);
  });
  return std::move(result);
}

double distance(const Shared_mesh& mesh, const py::object& from, const py::object& to, double distance_limit)
{
  const std::vector<Face_location> a = in_faces(mesh, read_locations(mesh, from)), b = in_faces(mesh, read_locations(mesh, to));
  if(a.size() != 1 || b.size() != 1) throw py::value_error("geodesic_offset: a distance is between two locations");
  return without_gil([&] {
    return CGAL::geodesic_distance(*mesh.prepared, a.front(), b.front(), CGAL::parameters::distance_limit(distance_limit));
  });
}

py::tuple farthest_points(const Shared_mesh& mesh, std::size_t n, const py::object& start_set, double covering_radius,
                          const py::object& function)
{
  const Source_set start = read_sources(mesh, start_set);
  std::vector<std::uint32_t> selected;
  const auto size = static_cast<py::ssize_t>(mesh.tm.number_of_vertices());
  py::array_t<double> distances(size);
  py::array_t<std::int64_t> labels(size);
  const Array_map<Vertex, double> distance_map{distances.mutable_data()};
  const Array_map<Vertex, std::size_t> label_map{reinterpret_cast<std::size_t*>(labels.mutable_data())};
  Visitor visitor(function);
  const double radius = without_gil([&] {
    const auto write = boost::make_function_output_iterator([&](Vertex v) { selected.push_back(v.idx()); });
    return CGAL::geodesic_farthest_points(
      *mesh.prepared, n, write,
      CGAL::parameters::start_set(std::cref(start))
        .covering_radius(covering_radius)
        .vertex_distance_map(distance_map)
        .vertex_source_map(label_map)
        .visitor(std::ref(visitor)));
  });
  const py::object type = py::module_::import("geodesic_offset").attr("Farthest_points");
  return type(moved<std::uint32_t>(std::move(selected)), radius, distances, labels);
}

void define_mesh(py::class_<Shared_mesh, Mesh_ptr>& mesh)
{
  mesh
    .def(py::init(&make_mesh), py::arg("points") = py::none(), py::arg("faces") = py::none(),
         py::arg("edge_lengths") = py::none(), py::arg("parallel") = false, docs::mesh_init)
    .def_property_readonly("points", &points_view, docs::mesh_points)
    .def_property_readonly(
      "number_of_vertices", [](const Shared_mesh& m) { return m.tm.number_of_vertices(); }, "int")
    .def_property_readonly(
      "number_of_faces", [](const Shared_mesh& m) { return m.tm.number_of_faces(); }, "int")
    .def_property_readonly(
      "mean_edge_length", [](const Shared_mesh& m) { return m.prepared->mean_edge_length(); }, "Mean length of the edges.")
    .def(
      "locate",
      [](const Shared_mesh& m, const Doubles& points) {
        const Locations l = read_locations(m, points);
        const py::tuple arrays = exported(in_faces(m, l));
        return py::make_tuple(l.shaped(arrays[0]), l.shaped(arrays[1]));
      },
      py::arg("points"), docs::locate)
    .def(
      "locate_polyline",
      [](const Mesh_ptr& m, const py::object& points, const std::optional<bool>& is_closed,
         const std::optional<std::vector<double>>& start_values) {
        return Shared_polyline{m, read_polyline(*m, points, is_closed, start_values)};
      },
      py::arg("points"), py::arg("is_closed") = py::none(), py::arg("start_values") = py::none(), docs::locate_polyline)
    .def(
      "distances",
      [](const Shared_mesh& m, const py::object& sources, double limit, const py::object& targets, double relative,
         double merging, const py::object& visitor, bool parallel) {
        const Options options = read_options(m, limit, targets, relative, merging, parallel);
        return vertex_distances(m, build(m, read_sources(m, sources), options, visitor));
      },
      py::arg("sources"), py::arg("distance_limit") = infinity, py::arg("targets") = py::none(),
      py::arg("relative_tolerance") = 0., py::arg("merging_tolerance") = 0., py::arg("visitor") = py::none(),
      py::arg("parallel") = false, docs::distances)
    .def(
      "field",
      [](const Mesh_ptr& m, const py::object& sources, double limit, bool keep_windows, bool largest, const py::object& targets,
         double relative, double merging, const py::object& visitor, bool parallel) {
        Options options = read_options(*m, limit, targets, relative, merging, parallel);
        options.keep_windows = keep_windows;
        options.compute_largest_distance = largest;
        const Source_set set = read_sources(*m, sources);
        return Shared_field{m, set.size(), build(*m, set, options, visitor)};
      },
      py::arg("sources"), py::arg("distance_limit") = infinity, py::arg("keep_windows") = false,
      py::arg("compute_largest_distance") = false, py::arg("targets") = py::none(), py::arg("relative_tolerance") = 0.,
      py::arg("merging_tolerance") = 0., py::arg("visitor") = py::none(), py::arg("parallel") = false, docs::field)
    .def("distance", &distance, py::arg("from_"), py::arg("to"), py::arg("distance_limit") = infinity, docs::distance)
    .def("distance_matrix", &distance_matrix, py::arg("sources"), py::arg("targets") = py::none(),
         py::arg("distance_limit") = infinity, py::arg("upper_half") = false, py::arg("out") = py::none(),
         py::arg("visitor") = py::none(), py::arg("parallel") = false, docs::distance_matrix)
    .def("farthest_points", &farthest_points, py::arg("n"), py::arg("start_set") = py::none(), py::arg("covering_radius") = 0.,
         py::arg("visitor") = py::none(), docs::farthest_points);
}

void define_field(py::class_<Shared_field>& field)
{
  field
    .def(
      "distances", [](const Shared_field& self) { return vertex_distances(*self.mesh, self.field); }, docs::field_distances)
    .def("source_labels", &source_labels, docs::source_labels)
    .def(
      "distance_to_sources",
      [](const Shared_field& self, const py::object& locations) {
        return query(self, locations, 1, [&](const auto& l, double* x) { *x = self.field.distance_to_sources(l); });
      },
      py::arg("locations"), docs::distance_to_sources)
    .def(
      "signed_distance_to_sources",
      [](const Shared_field& self, const py::object& locations) {
        return query(self, locations, 1,
                     [&](const auto& l, double* x) { *x = self.field.signed_distance_to_sources(l).value_or(nan); });
      },
      py::arg("locations"), docs::signed_distance_to_sources)
    .def(
      "gradient",
      [](const Shared_field& self, const py::object& locations) {
        return query(self, locations, 3, [&](const auto& l, double* x) {
          const auto g = self.field.gradient(l);
          for(int k = 0; k < 3; ++k) x[k] = g ? (*g)[k] : nan;
        });
      },
      py::arg("locations"), docs::gradient)
    .def("nearest_source", &nearest_source, py::arg("locations"), docs::nearest_source)
    .def("shortest_path_points_to_sources", &path_points, py::arg("location"), docs::path_points)
    .def("shortest_path_to_sources", &path_locations, py::arg("location"), docs::path_locations)
    .def(
      "largest_vertex_distance", [](const Shared_field& self) { return self.field.largest_vertex_distance(); },
      "Largest distance of the vertices that have a distance: a float, or None if there are none.")
    .def(
      "largest_distance", [](const Shared_field& self) { return self.field.largest_distance(); }, docs::largest_distance)
    .def("farthest_point", &farthest_point, docs::farthest_point)
    .def_property_readonly(
      "covered_distance", [](const Shared_field& self) { return self.field.covered_distance(); },
      "Distance up to which the distances were computed; inf if all were.")
    .def_property_readonly(
      "is_cancelled", [](const Shared_field& self) { return self.field.is_cancelled(); },
      "Whether the visitor has cancelled the build.")
    .def_property_readonly("statistics", &statistics, "Counts and times of the build: a dict.");
}

// The number of the source that has just been added.
std::size_t last_id(const Source_set& set) { return set.sources().rbegin()->first; }

void define_sources(py::module_& module)
{
  py::class_<Shared_polyline>(module, "Polyline", docs::polyline)
    .def_property_readonly(
      "locations", [](const Shared_polyline& p) { return exported(p.polyline.locations); },
      "Tuple of faces, int64 (n,), and weights of their corners, float64 (n, 3).")
    .def_property_readonly(
      "is_closed", [](const Shared_polyline& p) { return p.polyline.is_closed; },
      "Whether the last point is joined to the first one.");
  py::class_<Shared_sources>(module, "Source_set", docs::source_set)
    .def(py::init([](const Mesh_ptr& m) {
           return Shared_sources{m, {}};
         }),
         py::arg("mesh"))
    .def(
      "add",
      [](Shared_sources& s, const py::object& sources) {
        const std::size_t before = s.set.size();
        Source_set more = read_sources(*s.mesh, sources);
        for(const auto& source : more.sources()) s.set.add(source.second);
        return py::module_::import("builtins").attr("range")(before, s.set.size());
      },
      py::arg("sources"), docs::add)
    .def(
      "add_points",
      [](Shared_sources& s, const py::object& locations, double start_value) {
        const std::size_t before = s.set.size();
        add_locations(s.set, read_locations(*s.mesh, locations), start_value);
        return py::module_::import("builtins").attr("range")(before, s.set.size());
      },
      py::arg("locations"), py::arg("start_value") = 0., docs::add_points)
    .def(
      "add_polyline",
      [](Shared_sources& s, const py::object& points, const std::optional<bool>& is_closed, double start_value,
         const std::optional<std::vector<double>>& start_values) {
        const Polyline p = py::isinstance<Shared_polyline>(points) ? points.cast<const Shared_polyline&>().polyline
                                                                   : read_polyline(*s.mesh, points, is_closed, start_values);
        const auto kind = p.is_closed ? Source_set::Kind::CLOSED_POLYLINE : Source_set::Kind::OPEN_POLYLINE;
        return s.set.add({kind, Mesh::null_vertex(), p.locations, {}, start_value, p.start_values});
      },
      py::arg("points"), py::arg("is_closed") = py::none(), py::arg("start_value") = 0., py::arg("start_values") = py::none(),
      docs::add_polyline)
    .def(
      "add_edges",
      [](Shared_sources& s, const Indices& edges, double start_value) {
        add(s.set, Source_set::Kind::EDGES, Mesh::null_vertex(), {}, edges_of(*s.mesh, edges), start_value);
        return last_id(s.set);
      },
      py::arg("edges"), py::arg("start_value") = 0., docs::add_edges)
    .def("__len__", [](const Shared_sources& s) { return s.set.size(); });
}

} // namespace
} // namespace geodesic_offset_python

PYBIND11_MODULE(geodesic_offset, module)
{
  using namespace geodesic_offset_python;
  module.doc() = docs::module;
  const py::object named_tuple = py::module_::import("collections").attr("namedtuple");
  const auto add_tuple = [&](const char* name, const char* fields, const char* text) {
    module.attr(name) = named_tuple(name, fields, py::arg("module") = "geodesic_offset");
    module.attr(name).attr("__doc__") = text;
  };
  add_tuple("Farthest_points", "vertices covering_radius distances labels", docs::farthest_points_tuple);
  add_tuple("Split", "points faces face_band face_source constrained_edges", docs::split_tuple);
  py::class_<Shared_mesh, Mesh_ptr> mesh(module, "Mesh", docs::mesh);
  py::class_<Shared_field> field(module, "Field", docs::field_class);
  define_sources(module);
  define_mesh(mesh);
  define_field(field);
  define_curves(module, mesh, field);
}
