// Values that Python hands over, as the option tables take them, and JSON as Python's own values.
#pragma once

#include <string>
#include <string_view>

#include <glm/vec3.hpp>
#include <nlohmann/json_fwd.hpp>
#include <pybind11/pybind11.h>

#include "mold/direction.hpp"

namespace moldlight::python {

// What is no such value is a UsageError that begins with `key`.

/// A number, a bool or text, as the command line takes it.
[[nodiscard]] std::string value_text(const pybind11::handle& value, std::string_view key);
/// Words, one or several, separated by commas.
[[nodiscard]] std::string words_text(const pybind11::handle& value, std::string_view key);
/// One direction or several, a line each.
[[nodiscard]] std::string directions_text(const pybind11::handle& value, std::string_view key);
/// Three numbers or an axis such as "-y".
[[nodiscard]] glm::dvec3 direction_of(const pybind11::handle& value, std::string_view key);
/// A file's name: text, bytes or os.PathLike.
[[nodiscard]] std::string path_of(const pybind11::handle& value, std::string_view key);

/// Whether the direction that a sweep finds is asked for.
[[nodiscard]] bool is_best(const pybind11::handle& direction);

[[nodiscard]] pybind11::object to_python(const nlohmann::ordered_json& json);
[[nodiscard]] inline pybind11::tuple to_python(const glm::dvec3& point) {
  return pybind11::make_tuple(point.x, point.y, point.z);
}

}  // namespace moldlight::python
