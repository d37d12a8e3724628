#include "python/values.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/option.hpp"
#include "io/readers.hpp"

namespace moldlight::python {

namespace {

/// Longer lists of directions are a mistake, and are not to be copied.
constexpr py::ssize_t k_most_directions = 1'000'000;

std::string type_name(const py::handle& value) { return Py_TYPE(value.ptr())->tp_name; }

std::string utf8_of(const py::handle& text, std::string_view key) {
  Py_ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes == nullptr) {
    PyErr_Clear();
    throw UsageError(fmt::format("{}: the text is not valid Unicode", key));
  }
  return {bytes, static_cast<std::size_t>(size)};
}

bool is_switch(const py::handle& value) {
  return PyBool_Check(value.ptr()) || type_name(value).starts_with("numpy.bool");
}

/// Only what is a list or an array of three numbers.
std::optional<glm::dvec3> three_numbers(const py::handle& value) {
  if (PyUnicode_Check(value.ptr()) || PySequence_Check(value.ptr()) == 0) return std::nullopt;
  const Py_ssize_t length = PySequence_Size(value.ptr());
  if (length != 3) {
    PyErr_Clear();
    return std::nullopt;
  }
  glm::dvec3 numbers(0.0);
  for (int axis = 0; axis < 3; ++axis) {
    const auto item = py::reinterpret_steal<py::object>(PySequence_GetItem(value.ptr(), axis));
    // An array of one number is one, too; a list is a direction of its own.
    const bool number = item && !PyUnicode_Check(item.ptr()) && !PyList_Check(item.ptr()) &&
                        !PyTuple_Check(item.ptr()) && !is_switch(item);
    numbers[axis] = number ? PyFloat_AsDouble(item.ptr()) : 0.0;
    if (number && PyErr_Occurred() == nullptr) continue;
    PyErr_Clear();
    return std::nullopt;
  }
  return numbers;
}

/// What `value` holds, one after another; UsageError for what holds nothing.
template <typename Visit>
void each(const py::handle& value, std::string_view key, const Visit& visit) {
  const auto items = py::reinterpret_steal<py::object>(PyObject_GetIter(value.ptr()));
  if (!items) {
    PyErr_Clear();
    throw UsageError(fmt::format("{}: not a list of them, but of type '{}'", key, type_name(value)));
  }
  for (py::ssize_t count = 0;; ++count) {
    const auto item = py::reinterpret_steal<py::object>(PyIter_Next(items.ptr()));
    if (!item) {
      if (PyErr_Occurred() != nullptr) throw py::error_already_set();
      return;
    }
    if (count == k_most_directions) throw UsageError(fmt::format("{}: the list has no end", key));
    visit(item);
  }
}

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
  if (array.ndim() != 2 || array.shape(1) != 3)
    throw UsageError(fmt::format("{}: the array is {}, not n x 3", name, shape_text(array)));
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

std::string value_text(const py::handle& value, std::string_view key) {
  if (is_switch(value)) return PyObject_IsTrue(value.ptr()) == 1 ? "on" : "off";
  if (PyUnicode_Check(value.ptr())) return utf8_of(value, key);
  if (py::hasattr(value, "__fspath__")) return path_of(value, key);
  if (PyIndex_Check(value.ptr()) != 0) {
    const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(value.ptr()));
    const auto text = py::reinterpret_steal<py::object>(number ? PyObject_Str(number.ptr()) : nullptr);
    if (text) return utf8_of(text, key);
  } else if (PyNumber_Check(value.ptr()) != 0) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() == nullptr) return real_text(number);
  }
  PyErr_Clear();
  throw UsageError(fmt::format("{}: not a value of it, but of type '{}'", key, type_name(value)));
}

std::string words_text(const py::handle& value, std::string_view key) {
  if (PyUnicode_Check(value.ptr())) return utf8_of(value, key);
  std::string text;
  each(value, key,
       [&](const py::handle& item) { text += (text.empty() ? "" : ",") + value_text(item, key); });
  return text.empty() ? "none" : text;
}

std::string direction_text(const py::handle& value, std::string_view key) {
  if (PyUnicode_Check(value.ptr())) return utf8_of(value, key);
  const auto numbers = three_numbers(value);
  if (!numbers)
    throw UsageError(fmt::format("{}: not a direction; give three numbers, or an axis such as '-y'", key));
  return fmt::format("{},{},{}", numbers->x, numbers->y, numbers->z);
}

std::string directions_text(const py::handle& value, std::string_view key) {
  if (PyUnicode_Check(value.ptr()) || three_numbers(value)) return direction_text(value, key);
  std::string text;
  each(value, key,
       [&](const py::handle& item) { text += (text.empty() ? "" : "\n") + direction_text(item, key); });
  return text;
}

glm::dvec3 direction_of(const py::handle& value, std::string_view key) {
  return parse_direction({direction_text(value, key), key});
}

std::string path_of(const py::handle& value, std::string_view key) {
  const auto path = py::reinterpret_steal<py::object>(PyOS_FSPath(value.ptr()));
  PyObject* bytes = nullptr;
  if (!path || PyUnicode_FSConverter(path.ptr(), &bytes) == 0) {
    PyErr_Clear();
    throw UsageError(fmt::format("{}: not a file's name, but of type '{}'", key, type_name(value)));
  }
  const auto owner = py::reinterpret_steal<py::bytes>(bytes);
  std::string name(owner);
  if (name.empty()) throw UsageError(fmt::format("{}: the name is empty", key));
  return name;
}

bool is_best(const py::handle& direction) {
  return PyUnicode_Check(direction.ptr()) && utf8_of(direction, "direction") == "best";
}

py::object to_python(const Json& json) {
  switch (json.type()) {
    case Json::value_t::boolean:
      return py::bool_(json.get<bool>());
    case Json::value_t::number_integer:
      return py::int_(json.get<std::int64_t>());
    case Json::value_t::number_unsigned:
      return py::int_(json.get<std::uint64_t>());
    // What is not finite is null in JSON text.
    case Json::value_t::number_float: {
      const double number = json.get<double>();
      return std::isfinite(number) ? py::object(py::float_(number)) : py::object(py::none());
    }
    case Json::value_t::string: {
      const auto& text = json.get_ref<const std::string&>();
      return py::reinterpret_steal<py::object>(
          PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
    }
    case Json::value_t::array: {
      py::list list;
      for (const Json& item : json) list.append(to_python(item));
      return list;
    }
    case Json::value_t::object: {
      py::dict dict;
      for (const auto& item : json.items()) dict[py::str(item.key())] = to_python(item.value());
      return dict;
    }
    default:
      return py::none();
  }
}

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
