// What a table of options can do: read and write a setting as text, and all of them as JSON.
#pragma once

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "session/option.hpp"

namespace moldlight {

namespace detail {
template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
/// Throws UsageError for what `kind` refuses.
template <typename Kind>
[[nodiscard]] int integer_in_range(const Kind& kind, std::string_view text, std::string_view what) {
  const int value = parse_integer(text, what);
  if (value < kind.min || value > kind.max || (kind.odd && value % 2 == 0)) {
    throw UsageError(fmt::format("{}: {} is out of range, {} to {}{}", what, text, kind.min, kind.max,
                                 kind.odd ? ", odd" : ""));
  }
  return value;
}

}  // namespace detail

/// The setting's value as the command line takes it; empty for an unset one.
template <typename S>
[[nodiscard]] std::string option_text(const Option<S>& option, const S& settings) {
  return std::visit(
      detail::Overloaded{
          [&](const RealKind<S>& kind) { return real_text(settings.*kind.member); },
          [&](const OptionalRealKind<S>& kind) {
            return settings.*kind.member ? real_text(*(settings.*kind.member)) : std::string();
          },
          [&](const IntegerKind<S>& kind) { return fmt::format("{}", settings.*kind.member); },
          [&](const OptionalIntegerKind<S>& kind) {
            return settings.*kind.member ? fmt::format("{}", *(settings.*kind.member)) : std::string();
          },
          [&](const SwitchKind<S>& kind) { return std::string(settings.*kind.member ? "on" : "off"); },
          [&](const ChoiceKind<S>& kind) {
            return std::string(kind.words[static_cast<std::size_t>(kind.get(settings))]);
          },
          [&](const DirectionKind<S>& kind) {
            const glm::dvec3& d = settings.*kind.member;
            return fmt::format("{},{},{}", d.x, d.y, d.z);
          },
      },
      option.kind);
}

/// Sets from text as the command line takes it; throws UsageError that names the option, the value and the
/// range.
template <typename S>
void set_option(const Option<S>& option, S& settings, std::string_view text) {
  const std::string_view what = option.flag;
  std::visit(detail::Overloaded{
                 [&](const RealKind<S>& kind) {
                   const double value = parse_real(text, what);
                   if (value < kind.min || value > kind.max) {
                     throw UsageError(
                         fmt::format("{}: {} is out of range, {} to {}", what, text, kind.min, kind.max));
                   }
                   settings.*kind.member = value;
                 },
                 [&](const OptionalRealKind<S>& kind) {
                   if (text.empty()) {
                     settings.*kind.member = std::nullopt;
                     return;
                   }
                   const double value = parse_real(text, what);
                   if (value <= 0.0)
                     throw UsageError(fmt::format("{}: {} must be greater than 0", what, text));
                   settings.*kind.member = value;
                 },
                 [&](const IntegerKind<S>& kind) {
                   settings.*kind.member = detail::integer_in_range(kind, text, what);
                 },
                 [&](const OptionalIntegerKind<S>& kind) {
                   settings.*kind.member = text.empty()
                                               ? std::nullopt
                                               : std::optional(detail::integer_in_range(kind, text, what));
                 },
                 [&](const SwitchKind<S>& kind) {
                   if (text != "on" && text != "off") {
                     throw UsageError(fmt::format("{}: '{}' is neither on nor off", what, text));
                   }
                   settings.*kind.member = text == "on";
                 },
                 [&](const ChoiceKind<S>& kind) {
                   const auto word = std::find(kind.words.begin(), kind.words.end(), text);
                   if (word == kind.words.end()) {
                     throw UsageError(
                         fmt::format("{}: '{}' is none of {}", what, text, fmt::join(kind.words, ", ")));
                   }
                   kind.set(settings, static_cast<int>(word - kind.words.begin()));
                 },
                 [&](const DirectionKind<S>& kind) { settings.*kind.member = parse_direction(text, what); },
             },
             option.kind);
}

/// A JSON object with every option under its key; null for an unset one.
template <typename S>
[[nodiscard]] nlohmann::ordered_json options_json(std::span<const Option<S>> options, const S& settings) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  for (const Option<S>& option : options) {
    auto& value = json[std::string(option.key)];
    std::visit(detail::Overloaded{
                   [&](const RealKind<S>& kind) { value = settings.*kind.member; },
                   [&](const OptionalRealKind<S>& kind) {
                     if (settings.*kind.member) value = *(settings.*kind.member);
                   },
                   [&](const IntegerKind<S>& kind) { value = settings.*kind.member; },
                   [&](const OptionalIntegerKind<S>& kind) {
                     if (settings.*kind.member) value = *(settings.*kind.member);
                   },
                   [&](const SwitchKind<S>& kind) { value = settings.*kind.member; },
                   [&](const ChoiceKind<S>&) { value = option_text(option, settings); },
                   [&](const DirectionKind<S>& kind) {
                     const glm::dvec3& d = settings.*kind.member;
                     value = {d.x, d.y, d.z};
                   },
               },
               option.kind);
  }
  return json;
}

/// Sets every option that the object holds; keys that no option has are refused. Throws UsageError.
template <typename S>
void set_options(std::span<const Option<S>> options, S& settings, const nlohmann::ordered_json& json) {
  if (!json.is_object()) throw UsageError("settings: not a JSON object");
  for (const auto& [key, value] : json.items()) {
    const auto option =
        std::find_if(options.begin(), options.end(), [&](const auto& o) { return o.key == key; });
    if (option == options.end()) throw UsageError(fmt::format("settings: there is no setting '{}'", key));
    std::string text;
    if (value.is_string()) {
      text = value.template get<std::string>();
    } else if (value.is_boolean()) {
      text = value.template get<bool>() ? "on" : "off";
    } else if (value.is_array()) {
      for (const auto& item : value) text += (text.empty() ? "" : ",") + item.dump();
    } else if (!value.is_null()) {
      text = value.dump();
    }
    set_option(*option, settings, text);
  }
}

}  // namespace moldlight
