// Copyright (c) 2026 The Surface_mesh_geodesic_offset developers.
// SPDX-License-Identifier: GPL-3.0-or-later

// What the parts of the Python module share: the objects of Python, arrays, and calls without the GIL.

#ifndef GEODESIC_OFFSET_PYTHON_BINDINGS_H
#define GEODESIC_OFFSET_PYTHON_BINDINGS_H

#include "common/common.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace geodesic_offset_python {

namespace py = pybind11;
using namespace geodesic_offset;

using Field = Geodesic::Field;
using Source_set = Geodesic::Source_set;
using Polyline = Geodesic::Polyline;
using Levels = CGAL::Offset_levels<double>;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Indices = py::array_t<std::int64_t, py::array::c_style | py::array::forcecast>;

// Points, and what the C++ objects refer to. Every object of Python shares the mesh that it refers to.
struct Shared_mesh
{
  Mesh tm;
  std::optional<Geodesic_mesh> prepared;
};
using Mesh_ptr = std::shared_ptr<Shared_mesh>;

struct Shared_field
{
  Mesh_ptr mesh;
  std::size_t number_of_sources;
  Field field;
};

struct Shared_curve
{
  Mesh_ptr mesh;
  Offset_curve curve;
};

struct Shared_polyline
{
  Mesh_ptr mesh;
  Polyline polyline;
};

struct Shared_sources
{
  Mesh_ptr mesh;
  Source_set set;
};

// A property map of vertices or faces that writes to an array.
template <class Key, class Value>
struct Array_map
{
  using key_type = Key;
  using value_type = Value;
  using reference = Value&;
  using category = boost::lvalue_property_map_tag;
  Value* data;
  friend void put(const Array_map& map, Key key, const Value& value) { map.data[key.idx()] = value; }
  friend Value& get(const Array_map& map, Key key) { return map.data[key.idx()]; }
};

// An array that owns the memory of a vector of plain values, without a copy. With `columns`, it has two dimensions.
template <class T, class Element>
py::array_t<T> moved(std::vector<Element>&& values, py::ssize_t columns = 0)
{
  static_assert(sizeof(Element) % sizeof(T) == 0);
  auto* const memory = new std::vector<Element>(std::move(values));
  const py::capsule owner(memory, [](void* p) { delete static_cast<std::vector<Element>*>(p); });
  const auto size = static_cast<py::ssize_t>(memory->size() * (sizeof(Element) / sizeof(T)));
  const auto* const data = reinterpret_cast<const T*>(memory->data());
  if(columns == 0) return py::array_t<T>({size}, data, owner);
  return py::array_t<T>({size / columns, columns}, data, owner);
}
static_assert(sizeof(Point) == 3 * sizeof(double), "arrays of points are read as arrays of numbers");

// The visitor of a build. It calls a function of Python if there is one, and throws the exception of a signal, such as
// KeyboardInterrupt, some time after the signal has come.
class Visitor
{
  // Between two looks for signals: far below the time in which a user expects an answer, and far above that of taking the GIL.
  // Binding test: test_python, interrupt.
  static constexpr std::chrono::milliseconds period{50};

  py::object m_function;
  std::chrono::steady_clock::time_point m_next = std::chrono::steady_clock::now() + period;

public:
  explicit Visitor(py::object function) : m_function(std::move(function)) {}

  bool operator()(double fraction)
  {
    const auto now = std::chrono::steady_clock::now();
    if(m_function.is_none() && now < m_next) return true;
    m_next = now + period;
    const py::gil_scoped_acquire gil;
    if(PyErr_CheckSignals() != 0) throw py::error_already_set();
    if(m_function.is_none()) return true;
    const py::object answer = m_function(fraction);
    return answer.is_none() || answer.cast<bool>();
  }
};

// f(tag) without the GIL, with the tag of several threads or of one.
template <class Function>
auto without_gil(bool parallel, const Function& f)
{
  const py::gil_scoped_release release;
  return parallel ? f(CGAL::Parallel_if_available_tag()) : f(CGAL::Sequential_tag());
}

template <class Function>
auto without_gil(const Function& f)
{
  const py::gil_scoped_release release;
  return f();
}

// Adds the classes of curves to the module.
void define_curves(py::module_& module, py::class_<Shared_mesh, Mesh_ptr>& mesh, py::class_<Shared_field>& field);

} // namespace geodesic_offset_python

#endif // GEODESIC_OFFSET_PYTHON_BINDINGS_H
