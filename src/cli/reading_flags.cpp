#include "cli/reading_flags.hpp"

#include <string>

#include <fmt/format.h>

#include "base/error.hpp"
#include "session/option.hpp"

namespace moldlight::cli {

namespace {

constexpr std::uint64_t k_most_facets = 1'400'000'000;
constexpr double k_widest_deflection_deg = 90.0;

/// A flag whose text is parsed when the command line is; its errors name the flag.
template <typename Parse>
void add_flag(CLI::App& command, const std::string& flag, const std::string& value, const std::string& help,
              const Parse& parse) {
  command
      .add_option_function<std::string>(
          flag, [flag, parse](const std::string& text) { parse(text, flag); }, help)
      ->option_text(value);
}

double parse_positive(const std::string& text, const std::string& flag) {
  const double value = parse_real(text, flag);
  if (value <= 0.0) throw UsageError(fmt::format("{}: {} must be greater than 0", flag, text));
  return value;
}

RepairLevel parse_repair_level(const std::string& text, const std::string& flag) {
  if (text == "none") return RepairLevel::none;
  if (text == "weld") return RepairLevel::weld;
  if (text == "full") return RepairLevel::full;
  throw UsageError(fmt::format("{}: '{}' is none of none, weld, full", flag, text));
}

}  // namespace

void add_reading_flags(CLI::App& command, ReadOptions& options) {
  add_flag(command, "--unit", "UNIT",
           "Unit of the part, such as mm or in: named where the file names none, converted to otherwise",
           [&options](const std::string& text, const std::string&) { options.unit = text; });
  add_flag(
      command, "--body", "N|NAME|all",
      "Only this body of the file, by its number in the list that info prints, or by its name [default all]",
      [&options](const std::string& text, const std::string&) { options.body = text; });
  add_flag(command, "--repair", "none|weld|full",
           "Mend the mesh and say what was done: weld joins vertices that nearly coincide; full also drops "
           "duplicate and empty facets, makes the winding consistent and fills small holes [default none]",
           [&options](const std::string& text, const std::string& flag) {
             options.repair.level = parse_repair_level(text, flag);
           });
  add_flag(
      command, "--weld-tolerance", "LENGTH",
      fmt::format("How near vertices are that --repair joins [default {} of the diagonal]", k_weld_share),
      [&options](const std::string& text, const std::string& flag) {
        options.repair.weld_tolerance = parse_positive(text, flag);
      });
  add_flag(
      command, "--linear-deflection", "LENGTH",
      "STEP: how far facets may be from the CAD surface, in the file's unit [default 0.0005 of the diagonal]",
      [&options](const std::string& text, const std::string& flag) {
        options.linear_deflection = parse_positive(text, flag);
      });
  add_flag(command, "--angular-deflection", "DEG",
           fmt::format("STEP: largest angle between neighbouring chords [up to {}; default {}]",
                       k_widest_deflection_deg, options.angular_deflection_deg),
           [&options](const std::string& text, const std::string& flag) {
             const double value = parse_positive(text, flag);
             if (value > k_widest_deflection_deg) {
               throw UsageError(
                   fmt::format("{}: {} is out of range, up to {}", flag, text, k_widest_deflection_deg));
             }
             options.angular_deflection_deg = value;
           });
  command
      .add_option("--max-facets", options.max_facets,
                  fmt::format("Refuse files with more facets than this [default {}]", options.max_facets))
      ->option_text("N")
      ->check(CLI::Range(std::uint64_t{1}, k_most_facets));
}

}  // namespace moldlight::cli
