// Every flag of the subcommands: those of a table of options, whose name, help, unit, range and default come
// from the table alone; how a part is read; files, sizes, help.
#pragma once

#include <cmath>
#include <functional>
#include <span>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/option.hpp"
#include "classify/still_picture.hpp"
#include "cli/command.hpp"
#include "parting/mold_files.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::cli {

// Values go into variables that outlive the command and hold the defaults.

struct FlagTexts {
  std::string name;
  std::string value;  // what stands for it in the help
  std::string help;
};
/// A flag whose text is parsed when the command line is.
CLI::Option* add_text_flag(CLI::App& command, const FlagTexts& flag,
                           std::function<void(const std::string&)> parse);
/// Refuses an empty name of a file or folder, such as a script's unset variable gives.
[[nodiscard]] CLI::Validator named();
/// Refuses a file whose extension is none of those of `value`, "FILE.png" or "FILE.(ply|obj|stl)".
[[nodiscard]] CLI::Validator named_as(const std::string& value);
/// A file or folder, named(), and named_as() where its format follows from the name.
CLI::Option* add_file_flag(CLI::App& command, std::string& path, const FlagTexts& flag);
/// Adds --size; `least` is in pixels.
CLI::Option* add_size_flag(CLI::App& command, glm::ivec2& size, const std::string& help,
                           const glm::ivec2& least = glm::ivec2(k_least_picture_px));

/// Part file and the flags of every command that reports on it.
struct PartFlags {
  std::string part;
  ReadOptions reading;
  std::string json;  // file, "-" for stdout, or empty

  /// The file that --json names; empty where it names stdout.
  [[nodiscard]] std::string json_file() const { return json == "-" ? std::string() : json; }
};
/// Adds --json, --quiet, --verbose and how the part is read.
void add_reading_flags(CLI::App& command, PartFlags& flags, Request& request);
/// The same and PART.
void add_part_flags(CLI::App& command, PartFlags& flags, Request& request);

/// What stands for the value in the help: "DEG", "TEXELS", "on|off", …
template <typename S>
[[nodiscard]] std::string value_text(const Option<S>& option) {
  if (const auto* choice = std::get_if<ChoiceKind<S>>(&option.kind))
    return fmt::format("{}", fmt::join(choice->words, "|"));
  if (std::holds_alternative<SwitchKind<S>>(option.kind)) return "on|off";
  if (std::holds_alternative<DirectionsKind<S>>(option.kind)) return "X,Y,Z ...";
  if (std::holds_alternative<SetKind<S>>(option.kind)) return "LIST";
  if (const auto* text = std::get_if<TextKind<S>>(&option.kind)) return std::string(text->name);
  if (option.unit == "deg") return "DEG";
  if (option.unit == "texel") return "TEXELS";
  if (option.unit == "mm") return "MM";
  if (option.unit == "s") return "SECONDS";
  if (option.unit == "MB") return "MB";
  if (option.unit == "force per area") return "FORCE/AREA";
  if (option.unit.starts_with('%')) return "PCT";
  if (std::holds_alternative<PositiveKind<S>>(option.kind)) return "LENGTH";
  return "N";
}

/// A greatest value from here on stands for none.
inline constexpr double k_no_limit = 1e6;

/// The option's help with range and default.
template <typename S>
[[nodiscard]] std::string flag_help(const Option<S>& option, const S& defaults) {
  const std::string range =
      std::visit(moldlight::detail::Overloaded{
                     [](const RealKind<S>& kind) {
                       return kind.max < k_no_limit ? fmt::format("{:g} to {:g}", kind.min, kind.max)
                                                    : fmt::format("{:g} or more", kind.min);
                     },
                     [](const PositiveKind<S>& kind) {
                       return std::isfinite(kind.max) ? fmt::format("up to {:g}", kind.max) : std::string();
                     },
                     [](const IntegerKind<S>& kind) {
                       return fmt::format("{} to {}{}", kind.min, kind.max, kind.odd ? ", odd" : "");
                     },
                     [](const TextKind<S>& kind) { return fmt::format("{}", fmt::join(kind.words, ", ")); },
                     [](const auto&) { return std::string(); }},
                 option.kind);
  const std::string value = option_text(option, defaults);
  const std::string standard = value.empty() ? "" : "default " + value;
  if (range.empty() && standard.empty()) return std::string(option.help);
  return fmt::format("{} [{}{}{}]", option.help, range, range.empty() || standard.empty() ? "" : "; ",
                     standard);
}

/// The flag's name, with the letter that is short for it where there is one: "-u,--unit".
[[nodiscard]] std::string names_of(std::string_view flag);

/// Adds the option's flag; the value goes into `settings`, which outlives the command and holds the default.
/// A value that the option refuses is a UsageError while parsing. A switch that is off by default is a flag
/// without a value. `option` outlives the command, too.
template <typename S>
CLI::Option* add_option_flag(CLI::App& command, const Option<S>& option, S& settings) {
  const auto* is_switch = std::get_if<SwitchKind<S>>(&option.kind);
  if (is_switch != nullptr && !(settings.*is_switch->member))
    return command.add_flag(std::string(option.flag), settings.*is_switch->member, std::string(option.help));
  CLI::Option* flag =
      add_text_flag(command, {names_of(option.flag), value_text(option), flag_help(option, settings)},
                    [&option, &settings](const std::string& text) {
                      if (text.empty()) throw UsageError(fmt::format("{}: the value is empty", option.flag));
                      set_option(option, settings, text);
                    });
  if (const auto* kind = std::get_if<TextKind<S>>(&option.kind); kind != nullptr && !kind->bare.empty())
    flag->expected(0, 1)->default_str(std::string(kind->bare));
  // Given several times, it is joined by line ends.
  if (std::holds_alternative<DirectionsKind<S>>(option.kind))
    flag->multi_option_policy(CLI::MultiOptionPolicy::Join);
  return flag;
}

/// The same for every option of a table.
template <typename S>
void add_option_flags(CLI::App& command, std::span<const Option<S>> options, S& settings) {
  for (const Option<S>& option : options) add_option_flag(command, option, settings);
}

/// The flags of still pictures but for their size. All need `picture` but --palette, which is that of other
/// files, too.
void add_still_flags(CLI::App& command, StillSettings& settings, CLI::Option* picture);

/// The files with all bodies of a mold, in the folder that `folder` names.
void add_mold_file_flags(CLI::App& command, MoldFileSettings& settings, CLI::Option* folder);

/// A parting direction as a command takes it.
struct DirectionFlag {
  Direction& given;
  bool& best;  // the one that a sweep finds is asked for
};
/// --direction, with `note` behind its help.
CLI::Option* add_direction_flag(CLI::App& command, const DirectionFlag& flag, std::string_view note);

/// What a sweep recommends; says so on stderr where it is no axis of the file.
[[nodiscard]] BestDirection found_direction(const std::shared_ptr<const PartModel>& model,
                                            const MethodSettings& method, Console& console,
                                            const Progress& progress);

/// Direction and method as Request::settings gives them.
[[nodiscard]] Json query_json(const Query& query, bool best_direction);

}  // namespace moldlight::cli
