// Values that Python hands over, as the option tables take them, and JSON as Python's own values.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include "base/image.hpp"
#include "classify/json.hpp"
#include "mesh/part.hpp"
#include "mesh/place_order.hpp"
#include "mesh/triangle_mesh.hpp"
#include "mold/direction.hpp"

namespace moldlight::python {

namespace py = pybind11;

// What is no such value is a UsageError that begins with `key`.

/// A number, a bool or text, as the command line takes it.
[[nodiscard]] std::string value_text(const py::handle& value, std::string_view key);
/// Words, one or several, separated by commas.
[[nodiscard]] std::string words_text(const py::handle& value, std::string_view key);
/// One direction or several, a line each.
[[nodiscard]] std::string directions_text(const py::handle& value, std::string_view key);
/// A direction as it is given: "X,Y,Z", an axis, a word.
[[nodiscard]] std::string direction_text(const py::handle& value, std::string_view key);
/// Three numbers or an axis such as "-y".
[[nodiscard]] glm::dvec3 direction_of(const py::handle& value, std::string_view key);
/// A file's name: text, bytes or os.PathLike.
[[nodiscard]] std::string path_of(const py::handle& value, std::string_view key);

/// Whether the direction that a sweep finds is asked for.
[[nodiscard]] bool is_best(const py::handle& direction);

[[nodiscard]] py::object to_python(const Json& json);
[[nodiscard]] inline py::tuple to_python(const glm::dvec3& point) {
  return py::make_tuple(point.x, point.y, point.z);
}

/// The mesh of arrays of any layout: `vertices` of n x 3 real or whole numbers, `faces` of m x 3 whole
/// numbers below n. Throws UsageError that names the first row at fault, FileError where memory is short;
/// equal vertices are not welded yet.
[[nodiscard]] TriangleMesh mesh_of(const py::object& vertices, const py::object& faces);

/// What an array looks at: rows of `columns` numbers that lie `stride` bytes apart.
template <typename T>
struct Rows {
  const T* data = nullptr;
  std::size_t rows = 0, columns = 1;  // one column: an array of one dimension
  std::size_t stride = sizeof(T) * columns;
};

/// An array that cannot be written to; `owner` is a Python object that keeps the numbers.
template <typename T>
[[nodiscard]] py::array view(const Rows<T>& rows, const py::handle& owner) {
  std::vector<py::ssize_t> shape = {static_cast<py::ssize_t>(rows.rows)};
  std::vector<py::ssize_t> strides = {static_cast<py::ssize_t>(rows.stride)};
  if (rows.columns != 1) {
    shape.push_back(static_cast<py::ssize_t>(rows.columns));
    strides.push_back(sizeof(T));
  }
  py::array array(py::dtype::of<T>(), shape, strides, rows.data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

[[nodiscard]] inline py::array view(const std::vector<glm::dvec3>& points, const py::handle& owner) {
  return view(
      Rows<double>{.data = points.empty() ? nullptr : &points.front().x, .rows = points.size(), .columns = 3},
      owner);
}
template <typename T>
[[nodiscard]] py::array view(const std::vector<T>& numbers, const py::handle& owner) {
  return view(Rows<T>{.data = numbers.data(), .rows = numbers.size()}, owner);
}
template <typename T, std::size_t N>
[[nodiscard]] py::array view(const std::vector<std::array<T, N>>& rows, const py::handle& owner) {
  return view(
      Rows<T>{.data = rows.empty() ? nullptr : rows.front().data(), .rows = rows.size(), .columns = N},
      owner);
}

/// Values of the part's facets, in the order in which its file lists them: an array of its own that cannot be
/// written to.
template <typename T>
[[nodiscard]] py::array listed(const std::vector<T>& values, const Part& part) {
  const std::vector<FacetIndex> facets = listed_facets(part);
  auto in_order = std::make_unique<std::vector<T>>();
  in_order->reserve(values.size());
  for (const FacetIndex facet : facets) in_order->push_back(values[facet]);
  const py::capsule owner(in_order.get(), [](void* kept) { delete static_cast<std::vector<T>*>(kept); });
  return view(*in_order.release(), owner);
}

/// An array of its own, which may be written to.
[[nodiscard]] py::array copy_of(const std::vector<glm::dvec3>& points);
/// (vertices, faces) as arrays of their own.
[[nodiscard]] py::tuple mesh_arrays(const TriangleMesh& mesh);
/// Height x width x 4 bytes, red, green, blue, alpha, rows from above.
[[nodiscard]] py::array image_array(const Image& image);

}  // namespace moldlight::python
