#include "python/arrays.hpp"

#include <algorithm>
#include <cstring>
#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "io/read_context.hpp"

namespace moldlight::python {

namespace py = pybind11;

namespace {

std::string shape_text(const py::array& array) {
  std::string text;
  for (py::ssize_t axis = 0; axis < array.ndim(); ++axis)
    text += fmt::format("{}{}", axis == 0 ? "" : " x ", array.shape(axis));
  return array.ndim() == 0 ? "a single number" : text;
}

/// n x 3 of one of these kinds of numbers ("f" real, "i" and "u" whole), of whatever layout.
py::array three_columns(const py::object& given, std::string_view name, std::string_view kinds,
                        std::string_view what) {
  py::array array = py::array::ensure(given);
  if (!array) throw UsageError(fmt::format("{}: not an array of n x 3 {}", name, what));
  if (array.ndim() != 2 || array.shape(1) != 3) {
    throw UsageError(fmt::format("{}: the array is {}, not n x 3", name, shape_text(array)));
  }
  // What an empty list becomes says nothing of its numbers.
  if (array.shape(0) == 0) throw UsageError(fmt::format("{}: the array is empty", name));
  if (kinds.find(array.dtype().kind()) == std::string_view::npos) {
    throw UsageError(
        fmt::format("{}: an array of {}, not of {}", name, std::string(py::str(array.dtype())), what));
  }
  return array;
}

/// The numbers as T in rows; the array may be a view that repeats a few numbers without end.
template <typename T>
py::array_t<T, py::array::c_style> in_rows(const py::array& array, std::string_view name) {
  check_memory(std::string(name), 2 * sizeof(T) * static_cast<std::uint64_t>(array.size()));
  auto rows = py::array_t<T, py::array::c_style | py::array::forcecast>::ensure(array);
  if (!rows) throw UsageError(fmt::format("{}: cannot be read as numbers", name));
  return rows;
}

std::vector<glm::dvec3> points_of(const py::object& given) {
  const py::array array = three_columns(given, "vertices", "fiu", "numbers");
  const auto count = static_cast<std::size_t>(array.shape(0));
  if (count > k_max_vertices)
    throw UsageError(fmt::format("vertices: more than {}; split the part", k_max_vertices));
  const auto rows = in_rows<double>(array, "vertices");
  std::vector<glm::dvec3> points(count);
  std::memcpy(points.data(), rows.data(), count * sizeof(glm::dvec3));
  const auto unusable = std::ranges::find_if_not(points, is_usable_point);
  if (unusable != points.end()) {
    throw UsageError(fmt::format("vertices: row {} is ({}, {}, {}); coordinates must be finite, {:g} at most",
                                 unusable - points.begin(), unusable->x, unusable->y, unusable->z,
                                 k_max_coordinate));
  }
  return points;
}

template <typename T>
std::vector<std::array<VertexIndex, 3>> corners_of(const py::array& array, std::size_t vertices) {
  const auto rows = in_rows<T>(array, "faces");
  std::vector<std::array<VertexIndex, 3>> facets(static_cast<std::size_t>(array.shape(0)));
  const T* number = rows.data();
  for (std::size_t facet = 0; facet < facets.size(); ++facet) {
    for (VertexIndex& corner : facets[facet]) {
      const T given = *number++;
      // As unsigned, a negative number is greater than any.
      if (static_cast<std::uint64_t>(given) >= vertices) {
        throw UsageError(fmt::format("faces: row {} names vertex {}, but vertices are numbered from 0 to {}",
                                     facet, given, vertices - 1));
      }
      corner = static_cast<VertexIndex>(given);
    }
  }
  return facets;
}

}  // namespace

TriangleMesh mesh_of(const py::object& vertices, const py::object& faces) {
  TriangleMesh mesh;
  mesh.vertices = points_of(vertices);
  const py::array array = three_columns(faces, "faces", "iu", "whole numbers");
  const int most = ReadOptions{}.max_facets;
  if (array.shape(0) > most) throw UsageError(fmt::format("faces: more than {}; split the part", most));
  const bool needs_unsigned = array.dtype().kind() == 'u' && array.itemsize() == sizeof(std::uint64_t);
  mesh.facets = needs_unsigned ? corners_of<std::uint64_t>(array, mesh.vertices.size())
                               : corners_of<std::int64_t>(array, mesh.vertices.size());
  return mesh;
}

py::array copy_of(const std::vector<glm::dvec3>& points) {
  static_assert(sizeof(glm::dvec3) == 3 * sizeof(double));
  py::array_t<double> array({static_cast<py::ssize_t>(points.size()), py::ssize_t{3}});
  std::memcpy(array.mutable_data(), points.data(), points.size() * sizeof(glm::dvec3));
  return array;
}

py::tuple mesh_arrays(const TriangleMesh& mesh) {
  py::array_t<std::uint32_t> faces({static_cast<py::ssize_t>(mesh.facets.size()), py::ssize_t{3}});
  std::memcpy(faces.mutable_data(), mesh.facets.data(), mesh.facets.size() * sizeof(mesh.facets[0]));
  return py::make_tuple(copy_of(mesh.vertices), faces);
}

py::array image_array(const Image& image) {
  py::array_t<std::uint8_t> array({py::ssize_t{image.height}, py::ssize_t{image.width}, py::ssize_t{4}});
  std::memcpy(array.mutable_data(), image.rgba.data(), image.rgba.size());
  return array;
}

}  // namespace moldlight::python
