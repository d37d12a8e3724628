// NumPy arrays: the mesh that a caller hands over, tested, and what is shown of a result without a copy.
#pragma once

#include <vector>

#include <glm/vec3.hpp>
#include <pybind11/numpy.h>

#include "base/image.hpp"
#include "mesh/triangle_mesh.hpp"

namespace moldlight::python {

/// The mesh of arrays of any layout: `vertices` of n x 3 real or whole numbers, `faces` of m x 3 whole
/// numbers below n. Throws UsageError that names the first row at fault, FileError where memory is short;
/// equal vertices are not welded yet.
[[nodiscard]] TriangleMesh mesh_of(const pybind11::object& vertices, const pybind11::object& faces);

/// What an array looks at: rows of `columns` numbers that lie `stride` bytes apart.
template <typename T>
struct Rows {
  const T* data = nullptr;
  std::size_t rows = 0, columns = 1;  // one column: an array of one dimension
  std::size_t stride = sizeof(T) * columns;
};

/// An array that cannot be written to; `owner` is a Python object that keeps the numbers.
template <typename T>
[[nodiscard]] pybind11::array view(const Rows<T>& rows, const pybind11::handle& owner) {
  std::vector<pybind11::ssize_t> shape = {static_cast<pybind11::ssize_t>(rows.rows)};
  std::vector<pybind11::ssize_t> strides = {static_cast<pybind11::ssize_t>(rows.stride)};
  if (rows.columns != 1) {
    shape.push_back(static_cast<pybind11::ssize_t>(rows.columns));
    strides.push_back(sizeof(T));
  }
  pybind11::array array(pybind11::dtype::of<T>(), shape, strides, rows.data, owner);
  array.attr("flags").attr("writeable") = false;
  return array;
}

[[nodiscard]] inline pybind11::array view(const std::vector<glm::dvec3>& points,
                                          const pybind11::handle& owner) {
  return view(
      Rows<double>{.data = points.empty() ? nullptr : &points.front().x, .rows = points.size(), .columns = 3},
      owner);
}
template <typename T>
[[nodiscard]] pybind11::array view(const std::vector<T>& numbers, const pybind11::handle& owner) {
  return view(Rows<T>{.data = numbers.data(), .rows = numbers.size()}, owner);
}
template <typename T, std::size_t N>
[[nodiscard]] pybind11::array view(const std::vector<std::array<T, N>>& rows, const pybind11::handle& owner) {
  return view(
      Rows<T>{.data = rows.empty() ? nullptr : rows.front().data(), .rows = rows.size(), .columns = N},
      owner);
}

/// An array of its own, which may be written to.
[[nodiscard]] pybind11::array copy_of(const std::vector<glm::dvec3>& points);
/// (vertices, faces) as arrays of their own.
[[nodiscard]] pybind11::tuple mesh_arrays(const TriangleMesh& mesh);
/// Height x width x 4 bytes, red, green, blue, alpha, rows from above.
[[nodiscard]] pybind11::array image_array(const Image& image);

}  // namespace moldlight::python
