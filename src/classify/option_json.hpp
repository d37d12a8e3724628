// The settings of a table of options as JSON.
#pragma once

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/json.hpp"
#include "classify/option.hpp"

namespace moldlight {

namespace detail {

inline Json value_json(const glm::dvec3& d) { return {d.x, d.y, d.z}; }
inline Json value_json(const std::vector<glm::dvec3>& directions) {
  Json list = Json::array();
  for (const glm::dvec3& d : directions) list.push_back(value_json(d));
  return list;
}
template <typename T>
Json value_json(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}
template <typename T>
Json value_json(const T& value) {
  return value;
}

/// As the command line takes it.
inline std::string json_text(const Json& value) {
  if (value.is_null()) return {};
  if (value.is_string()) return value.get<std::string>();
  if (value.is_boolean()) return value_text(value.get<bool>());
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : item.is_array() ? "\n" : ",") + json_text(item);
  return text;
}

/// A key in quotes, as JSON has it: on one line whatever is in it.
inline std::string key_text(const std::string& key) {
  return Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace detail

/// A JSON object with every option under its key; null for an unset one.
template <typename S>
[[nodiscard]] Json options_json(std::span<const Option<S>> options, const S& settings) {
  Json json = Json::object();
  for (const Option<S>& option : options) {
    json[std::string(option.key)] =
        std::visit([&](const auto& kind) { return detail::value_json(kind.value(settings)); }, option.kind);
  }
  return json;
}

/// Sets every option that the object holds; keys that no option has are refused. Throws UsageError.
template <typename S>
void set_options(std::span<const Option<S>> options, S& settings, const Json& json) {
  if (!json.is_object()) throw UsageError("settings: not a JSON object");
  for (const auto& item : json.items()) {
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.key == item.key(); });
    if (option == options.end())
      throw UsageError(fmt::format("settings: there is no setting {}", detail::key_text(item.key())));
    set_option(*option, settings, detail::json_text(item.value()));
  }
}

}  // namespace moldlight
