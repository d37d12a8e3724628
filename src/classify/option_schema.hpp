// Options as JSON Schema, for programs that ask by a form: types, ranges and defaults of the tables, and
// settings from such a form.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/json.hpp"
#include "classify/option.hpp"
#include "classify/option_json.hpp"

namespace moldlight {

namespace detail {

inline Json array_of(Json items) { return Json::object({{"type", "array"}, {"items", std::move(items)}}); }
inline Json vector_schema() {
  Json schema = array_of(Json::object({{"type", "number"}}));
  schema["minItems"] = schema["maxItems"] = 3;
  return schema;
}

template <typename S>
Json kind_schema(const RealKind<S>& kind) {
  return {{"type", "number"}, {"minimum", kind.min}, {"maximum", kind.max}};
}
template <typename S>
Json kind_schema(const PositiveKind<S>& kind) {
  Json schema = {{"type", "number"}, {"exclusiveMinimum", 0}};
  if (std::isfinite(kind.max)) schema["maximum"] = kind.max;
  return schema;
}
template <typename S>
Json kind_schema(const IntegerKind<S>& kind) {
  Json schema = {{"type", "integer"}, {"minimum", kind.min}, {"maximum", kind.max}};
  if (kind.odd) schema["not"]["multipleOf"] = 2;
  return schema;
}
template <typename S>
Json kind_schema(const SwitchKind<S>&) {
  return Json::object({{"type", "boolean"}});
}
template <typename S>
Json kind_schema(const ChoiceKind<S>& kind) {
  return {{"type", "string"}, {"enum", kind.words}};
}
template <typename S>
Json kind_schema(const DirectionsKind<S>&) {
  return array_of(vector_schema());
}
template <typename S>
Json kind_schema(const SetKind<S>& kind) {
  return array_of(Json{{"type", "string"}, {"enum", kind.words}});
}
template <typename S>
Json kind_schema(const TextKind<S>&) {
  return Json::object({{"type", "string"}});
}

}  // namespace detail

/// The schema of the option's value; without a default for one that is unset.
template <typename S>
[[nodiscard]] Json option_schema(const Option<S>& option, const S& defaults) {
  Json schema = std::visit([](const auto& kind) { return detail::kind_schema(kind); }, option.kind);
  schema["description"] =
      option.unit.empty() ? std::string(option.help) : fmt::format("{} Unit: {}.", option.help, option.unit);
  Json standard =
      std::visit([&](const auto& kind) { return detail::value_json(kind.value(defaults)); }, option.kind);
  if (!standard.is_null() && standard != "") schema["default"] = std::move(standard);
  return schema;
}

/// Whether a value is of the type that the schema names, or one of them; its range is not looked at.
template <typename Value>
[[nodiscard]] bool fits_type(const Json& schema, const Value& value) {
  const auto is = [&](std::string_view type) {
    return (type == "number" && value.is_number()) || (type == "string" && value.is_string()) ||
           (type == "integer" && value.is_number() && std::floor(value.template get<double>()) == value) ||
           (type == "boolean" && value.is_boolean()) ||
           (type == "array" && value.is_array() &&
            std::ranges::all_of(value, [&](const auto& one) { return fits_type(schema["items"], one); }));
  };
  const Json& types = schema["type"];
  return types.is_string() ? is(types.get_ref<const std::string&>())
                           : std::ranges::any_of(types, [&](const Json& one) {
                               return is(one.template get_ref<const std::string&>());
                             });
}

/// Sets the option from a value that fits its schema's type. Throws UsageError that names the key, as
/// set_option() does, and for text that names a file: a form reads none.
template <typename S>
void set_from_form(const Option<S>& option, S& settings, const Json& value) {
  const bool whole = std::holds_alternative<IntegerKind<S>>(option.kind) && value.is_number_float();
  const std::string text = whole ? fmt::format("{:.0f}", value.get<double>()) : detail::json_text(value);
  const auto* kind = std::get_if<TextKind<S>>(&option.kind);
  if (kind != nullptr && text.empty()) throw UsageError(fmt::format("{}: the value is empty", option.key));
  if (kind != nullptr && kind->name.starts_with("FILE") && text.ends_with(kind->name.substr(4)))
    throw UsageError(fmt::format("{}: give the values themselves, not a file", option.key));
  std::visit([&](const auto& one) { one.parse(settings, {text, option.key}); }, option.kind);
}

}  // namespace moldlight
