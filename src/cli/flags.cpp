#include "cli/flags.hpp"

#include <algorithm>

#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "classify/option_json.hpp"
#include "io/part_formats.hpp"

namespace moldlight::cli {

std::string names_of(std::string_view flag) {
  for (const auto& [letter, name] : {std::pair("-u", "--unit"), {"-j", "--jobs"}, {"-d", "--direction"}})
    if (flag == name) return fmt::format("{},{}", letter, name);
  return std::string(flag);
}

CLI::Option* add_text_flag(CLI::App& command, const FlagTexts& flag,
                           std::function<void(const std::string&)> parse) {
  return command.add_option_function<std::string>(flag.name, std::move(parse), flag.help)
      ->option_text(flag.value);
}

CLI::Validator named() {
  return {[](std::string& name) { return name.empty() ? "the name is empty" : std::string(); }, ""};
}

CLI::Validator named_as(const std::string& value) {
  std::vector<std::string> known = CLI::detail::split(value.substr(value.find('.') + 1), '|');
  for (std::string& extension : known) std::erase_if(extension, [](char c) { return c == '(' || c == ')'; });
  return {[known](std::string& name) {
            const std::string extension = lower_extension(name);
            const bool fits =
                std::ranges::count(known, extension) > 0 || (extension.empty() && known.size() == 1);
            std::string names = fmt::format(".{}", fmt::join(known, ", ."));
            if (const std::size_t last = names.rfind(','); last != std::string::npos)
              names.replace(last, 1, " or");
            return fits ? std::string()
                        : fmt::format("{} has another format; name it {}", one_line(name), names);
          },
          ""};
}

CLI::Option* add_file_flag(CLI::App& command, std::string& path, const FlagTexts& flag) {
  CLI::Option* option =
      command.add_option(flag.name, path, flag.help)->option_text(flag.value)->check(named());
  if (flag.value == "FILE.png" || flag.value.starts_with("FILE.(")) option->check(named_as(flag.value));
  return option;
}

CLI::Option* add_size_flag(CLI::App& command, glm::ivec2& size, const std::string& help,
                           const glm::ivec2& least) {
  return add_text_flag(
      command, {"--size", "WxH", fmt::format("{} [default {}x{}]", help, size.x, size.y)},
      [&size, least](const std::string& text) { size = parse_picture_size(text, "--size", least); });
}

void add_part_flags(CLI::App& command, PartFlags& flags, Request& request) {
  command
      .add_option("PART", flags.part,
                  fmt::format("Part file: {}, recognised by its content", part_format_names(" or ")))
      ->required();
  add_reading_flags(command, flags, request);
}

void add_reading_flags(CLI::App& command, PartFlags& flags, Request& request) {
  add_file_flag(command, flags.json,
                {"--json", "FILE|-", "Write the report as JSON. - writes to stdout in place of the table"});
  add_option_flags(command, reading_options(), flags.reading);
  CLI::Option* quiet =
      command.add_flag("-q,--quiet", request.quiet, "Print no warnings and no progress on stderr");
  command.add_flag("-v,--verbose", request.verbose, "Print each step and its time on stderr")
      ->excludes(quiet);
}

CLI::Option* add_direction_flag(CLI::App& command, const DirectionFlag& flag, std::string_view note) {
  return add_text_flag(
      command,
      {"-d,--direction", "X,Y,Z|AXIS|best",
       fmt::format("Parting direction +d, along which the core moves: three numbers of any length, an axis "
                   "such as z or -y, or best for the one that a sweep recommends. [{}]",
                   note)},
      [flag](const std::string& text) {
        flag.best = text == "best";
        if (!flag.best) flag.given = parse_direction({text, "--direction"});
      });
}

BestDirection found_direction(const std::shared_ptr<const PartModel>& model, const MethodSettings& method,
                              Console& console, const Progress& progress) {
  BestDirection best = best_direction(model, method, progress);
  if (!best.off_axis.empty()) console.warning(best.off_axis);
  return best;
}

Json query_json(const Query& query, bool best_direction) {
  const glm::dvec3& d = query.direction.unit();
  Json json = options_json(method_options(), query.method);
  json["direction"] = best_direction ? Json("best") : Json{d.x, d.y, d.z};
  return json;
}

void add_still_flags(CLI::App& command, StillSettings& settings, CLI::Option* picture) {
  for (const Option<StillSettings>& option : still_options())
    add_option_flag(command, option, settings)->needs(picture);
  add_option_flag(command, option_named(look_options(), "palette"), settings.look);
  for (const std::string_view key : {"regions", "mark_difference"})
    add_option_flag(command, option_named(look_options(), key), settings.look)->needs(picture);
}

void add_mold_file_flags(CLI::App& command, MoldFileSettings& settings, CLI::Option* folder) {
  command.add_flag("--3mf", settings.as_3mf, "Write all bodies to mold.3mf in that folder, too")
      ->needs(folder);
  command
      .add_flag("--step-bodies", settings.as_step,
                "Write all bodies to mold.step in that folder, too, for CAD: solids with plane faces, and "
                "the parting surface")
      ->needs(folder);
}

}  // namespace moldlight::cli
