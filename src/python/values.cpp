#include "python/values.hpp"

#include <cmath>
#include <cstring>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <pybind11/numpy.h>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight::python {

namespace py = pybind11;

namespace {

/// Longer lists of directions are a mistake, and are not to be copied.
constexpr py::ssize_t k_most_directions = 1'000'000;

std::string type_name(const py::handle& value) { return Py_TYPE(value.ptr())->tp_name; }

std::string utf8_of(const py::handle& text, std::string_view key) {
  Py_ssize_t size = 0;
  const char* bytes = PyUnicode_AsUTF8AndSize(text.ptr(), &size);
  if (bytes == nullptr) {
    PyErr_Clear();
    throw UsageError(fmt::format("{}: the text is no valid Unicode", key));
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

std::string direction_text(const py::handle& value, std::string_view key) {
  if (PyUnicode_Check(value.ptr())) return utf8_of(value, key);
  const auto numbers = three_numbers(value);
  if (!numbers)
    throw UsageError(fmt::format("{}: not a direction; give three numbers, or an axis such as '-y'", key));
  return fmt::format("{},{},{}", numbers->x, numbers->y, numbers->z);
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

}  // namespace

std::string value_text(const py::handle& value, std::string_view key) {
  if (is_switch(value)) return PyObject_IsTrue(value.ptr()) == 1 ? "on" : "off";
  if (PyUnicode_Check(value.ptr())) return utf8_of(value, key);
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

py::object to_python(const nlohmann::ordered_json& json) {
  using Json = nlohmann::ordered_json;
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

}  // namespace moldlight::python
