// Command-line flags from a table of options: name, help, unit, range and default come from the table alone.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "session/method_options.hpp"
#include "session/option_table.hpp"

namespace moldlight::cli {

/// What stands for the value in the help: "DEG", "TEXELS", "on|off", …
template <typename S>
[[nodiscard]] std::string value_text(const Option<S>& option) {
  if (const auto* choice = std::get_if<ChoiceKind<S>>(&option.kind)) {
    return fmt::format("{}", fmt::join(choice->words, "|"));
  }
  if (std::holds_alternative<SwitchKind<S>>(option.kind)) return "on|off";
  if (std::holds_alternative<DirectionKind<S>>(option.kind)) return "X,Y,Z";
  if (option.unit == "deg") return "DEG";
  if (option.unit == "texel") return "TEXELS";
  if (option.unit == "s") return "SECONDS";
  if (option.unit.starts_with('%')) return "PCT";
  if (std::holds_alternative<OptionalRealKind<S>>(option.kind)) return "LENGTH";
  return "N";
}

/// The option's help with range and default.
template <typename S>
[[nodiscard]] std::string flag_help(const Option<S>& option, const S& defaults) {
  std::string range;
  if (const auto* real = std::get_if<RealKind<S>>(&option.kind)) {
    range = fmt::format("{:g} to {:g}", real->min, real->max);
  }
  const auto integer_range = [&](const auto* integer) {
    if (integer != nullptr)
      range = fmt::format("{} to {}{}", integer->min, integer->max, integer->odd ? ", odd" : "");
  };
  integer_range(std::get_if<IntegerKind<S>>(&option.kind));
  integer_range(std::get_if<OptionalIntegerKind<S>>(&option.kind));
  const std::string value = option_text(option, defaults);
  const std::string standard = value.empty() ? "" : "default " + value;
  if (range.empty() && standard.empty()) return std::string(option.help);
  return fmt::format("{} [{}{}{}]", option.help, range, range.empty() || standard.empty() ? "" : "; ",
                     standard);
}

/// Adds the option's flag; the value goes into `settings`, which outlives the command and holds the default.
/// A value that the option refuses is a UsageError while parsing. A switch that is off by default is a flag
/// without a value. `option` outlives the command, too.
template <typename S>
CLI::Option* add_option_flag(CLI::App& command, const Option<S>& option, S& settings) {
  const auto* is_switch = std::get_if<SwitchKind<S>>(&option.kind);
  if (is_switch != nullptr && !(settings.*is_switch->member)) {
    return command.add_flag(std::string(option.flag), settings.*is_switch->member, std::string(option.help));
  }
  return command
      .add_option_function<std::string>(
          std::string(option.flag),
          [&option, &settings](const std::string& text) { set_option(option, settings, text); },
          flag_help(option, settings))
      ->option_text(value_text(option));
}

/// The same for every option of a table.
template <typename S>
void add_option_flags(CLI::App& command, std::span<const Option<S>> options, S& settings) {
  for (const Option<S>& option : options) add_option_flag(command, option, settings);
}

/// How a command takes the parting direction.
enum class DirectionFlag : std::uint8_t { required, optional, left_out };

/// The flags of method_options(). Kernel width and lateral tolerance replace each other: giving both is
/// refused.
void add_method_flags(CLI::App& command, MethodSettings& settings,
                      DirectionFlag direction = DirectionFlag::optional);

}  // namespace moldlight::cli
