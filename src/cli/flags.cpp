#include "cli/flags.hpp"

#include <algorithm>

#include "base/error.hpp"
#include "io/part_formats.hpp"
#include "session/still_picture.hpp"

namespace moldlight::cli {

namespace {

constexpr std::size_t k_help_width = 104;
constexpr std::uint64_t k_most_facets = 1'400'000'000;
constexpr double k_widest_deflection_deg = 90.0;

double parse_positive(const std::string& text, const std::string& flag) {
  const double value = parse_real(text, flag);
  if (value <= 0.0) throw UsageError(fmt::format("{}: {} must be greater than 0", flag, text));
  return value;
}

/// A flag for a number greater than 0; its errors name the flag.
void add_positive_flag(CLI::App& command, const std::string& flag, const std::string& value,
                       const std::string& help, double& number) {
  add_text_flag(command, flag, value, help,
                [flag, &number](const std::string& text) { number = parse_positive(text, flag); });
}

RepairLevel parse_repair_level(const std::string& text) {
  if (text == "none") return RepairLevel::none;
  if (text == "weld") return RepairLevel::weld;
  if (text == "full") return RepairLevel::full;
  throw UsageError(fmt::format("--repair: '{}' is none of none, weld, full", text));
}

}  // namespace

CLI::Option* add_text_flag(CLI::App& command, const std::string& flag, const std::string& value,
                           const std::string& help, std::function<void(const std::string&)> parse) {
  return command.add_option_function<std::string>(flag, std::move(parse), help)->option_text(value);
}

CLI::Validator named() {
  return {[](std::string& name) { return name.empty() ? "the name is empty" : std::string(); }, ""};
}

CLI::Option* add_file_flag(CLI::App& command, const std::string& flag, std::string& path,
                           const std::string& value, const std::string& help) {
  return command.add_option(flag, path, help)->option_text(value)->check(named());
}

CLI::Option* add_size_flag(CLI::App& command, glm::ivec2& size, const std::string& help,
                           const glm::ivec2& least) {
  return add_text_flag(
      command, "--size", "WxH", fmt::format("{} [default {}x{}]", help, size.x, size.y),
      [&size, least](const std::string& text) { size = parse_picture_size(text, "--size", least); });
}

void add_reading_flags(CLI::App& command, ReadOptions& options) {
  add_text_flag(command, "--unit", "UNIT",
                "Unit of the part, such as mm or in: named where the file names none, converted to otherwise",
                [&options](const std::string& text) { options.unit = text; });
  add_text_flag(
      command, "--body", "N|NAME|all",
      "Only this body of the file, by its number in the list that info prints, or by its name [default all]",
      [&options](const std::string& text) { options.body = text; });
  add_text_flag(
      command, "--repair", "none|weld|full",
      "Mend the mesh and say what was done: weld joins vertices that nearly coincide; full also drops "
      "duplicate and empty facets, makes the winding consistent and fills small holes [default none]",
      [&options](const std::string& text) { options.repair.level = parse_repair_level(text); });
  add_positive_flag(
      command, "--weld-tolerance", "LENGTH",
      fmt::format("How near vertices are that --repair joins [default {} of the diagonal]", k_weld_share),
      options.repair.weld_tolerance);
  add_positive_flag(
      command, "--linear-deflection", "LENGTH",
      "STEP: how far facets may be from the CAD surface, in the file's unit [default 0.0005 of the diagonal]",
      options.linear_deflection);
  add_text_flag(command, "--angular-deflection", "DEG",
                fmt::format("STEP: largest angle between neighbouring chords [up to {}; default {}]",
                            k_widest_deflection_deg, options.angular_deflection_deg),
                [&options](const std::string& text) {
                  const double value = parse_positive(text, "--angular-deflection");
                  if (value > k_widest_deflection_deg) {
                    throw UsageError(fmt::format("--angular-deflection: {} is out of range, up to {}", text,
                                                 k_widest_deflection_deg));
                  }
                  options.angular_deflection_deg = value;
                });
  command
      .add_option("--max-facets", options.max_facets,
                  fmt::format("Refuse files with more facets than this [default {}]", options.max_facets))
      ->option_text("N")
      ->check(CLI::Range(std::uint64_t{1}, k_most_facets));
}

void add_part_flags(CLI::App& command, PartFlags& flags, Request& request) {
  command
      .add_option("PART", flags.part,
                  fmt::format("Part file: {}, known by its content", part_format_names(" or ")))
      ->required();
  add_file_flag(command, "--json", flags.json, "FILE|-",
                "Write the report as JSON; - for stdout, in place of the table");
  add_reading_flags(command, flags.reading);
  CLI::Option* quiet = command.add_flag("-q,--quiet", request.quiet, "No warnings and no progress on stderr");
  command.add_flag("-v,--verbose", request.verbose, "Say on stderr what is being done")->excludes(quiet);
}

void add_method_flags(CLI::App& command, MethodSettings& settings, DirectionFlag direction) {
  for (const Option<MethodSettings>& option : method_options()) {
    const bool is_direction = option.key == "direction";
    if (is_direction && direction == DirectionFlag::left_out) continue;
    CLI::Option* flag = add_option_flag(command, option, settings);
    if (is_direction && direction == DirectionFlag::required) {
      flag->required()->description(std::string(option.help) + " [required]");
    }
  }
  command.get_option("--kernel")->excludes(command.get_option("--tolerance"));
}

std::vector<CLI::Option*> add_still_flags(CLI::App& command, StillSettings& settings) {
  std::vector<CLI::Option*> flags;
  for (const Option<StillSettings>& option : still_options())
    flags.push_back(add_option_flag(command, option, settings));
  for (const std::string_view key : {"palette", "regions", "mark_difference"})
    flags.push_back(add_option_flag(command, option_named(look_options(), key), settings.look));
  return flags;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  const std::string text = option->get_description();
  const std::size_t width = k_help_width - get_column_width();
  std::string wrapped;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    if (column > 0 && column + 1 + end - begin > width) {
      wrapped += '\n';
      column = 0;
    } else if (column > 0) {
      wrapped += ' ';
      ++column;
    }
    wrapped += text.substr(begin, end - begin);
    column += end - begin;
    begin = end + 1;
  }
  return wrapped;
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  return option->get_option_text().empty() ? "" : " " + option->get_option_text();
}

}  // namespace moldlight::cli
