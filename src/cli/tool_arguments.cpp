#include "cli/tool_arguments.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "base/shown_text.hpp"
#include "classify/method_options.hpp"
#include "io/part_formats.hpp"

namespace moldlight::cli {

namespace {

/// Along a side: what an answer has room for.
constexpr int k_most_served_px = 4096;
constexpr std::size_t k_shown_key_bytes = 80;

glm::ivec2 served_size(std::string_view text) {
  const glm::ivec2 size = parse_picture_size(text, "size");
  if (std::max(size.x, size.y) > k_most_served_px)
    throw UsageError(fmt::format("size: more than {} pixels along a side", k_most_served_px));
  return size;
}

}  // namespace

Argument path_argument(std::string key, const std::string& what, std::string ToolQuestion::*path) {
  const std::string help = fmt::format("Path of {}, from the folder that is served. Formats: {}.", what,
                                       part_format_names(" and "));
  return {std::move(key),
          {{"type", "string"}, {"description", help}},
          [path](ToolQuestion& question, const Json& value) { question.*path = value.get<std::string>(); },
          true};
}

Argument direction_argument(const std::string& help, const Words& words, bool required) {
  Json schema = detail::vector_schema();
  schema["type"] = {"string", "array"};
  schema["description"] = help;
  if (!required) schema["default"] = words.front();
  return {"direction", std::move(schema),
          [words](ToolQuestion& question, const Json& value) {
            const std::string text = detail::json_text(value);
            const bool is_word = std::ranges::count(words, text) > 0;
            question.direction_word = is_word ? text : "";
            if (!is_word) question.direction = parse_direction({text, "direction"});
          },
          required};
}

Argument side_actions_argument() {
  return {"actions",
          {{"type", "boolean"},
           {"default", false},
           {"description", "Find the side actions, and make solids of the slides."}},
          [](ToolQuestion& question, const Json& value) { question.with_actions = value.get<bool>(); }};
}

Arguments picture_arguments() {
  static const auto k_shown = choice<&ToolQuestion::shown>({"regions", "side_actions", "mold"});
  const glm::ivec2 usual = StillSettings().size;
  return {{"of",
           {{"type", "string"},
            {"enum", k_shown.words},
            {"default", k_shown.words.front()},
            {"description",
             "The part in the colours of its regions, with its side actions pulled out, or with the opened "
             "mold halves."}},
           [](ToolQuestion& question, const Json& value) {
             k_shown.parse(question, {value.get_ref<const std::string&>(), "of"});
           }},
          {"size",
           {{"type", "string"},
            {"pattern", "^[0-9]+x[0-9]+$"},
            {"default", fmt::format("{}x{}", usual.x, usual.y)},
            {"description", fmt::format("Width and height in pixels, {} to {} each.", k_least_picture_px,
                                        k_most_served_px)}},
           [](ToolQuestion& question, const Json& value) {
             question.still.size = served_size(value.get_ref<const std::string&>());
           }}};
}

Arguments joined(std::initializer_list<Arguments> groups) {
  Arguments all;
  for (const Arguments& group : groups) all.insert(all.end(), group.begin(), group.end());
  return all;
}

Json schema_of(const Arguments& arguments) {
  Json properties = Json::object(), required = Json::array();
  for (const Argument& argument : arguments) {
    properties[argument.key] = argument.schema;
    if (argument.required) required.push_back(argument.key);
  }
  return {{"type", "object"},
          {"properties", std::move(properties)},
          {"required", std::move(required)},
          {"additionalProperties", false}};
}

ToolQuestion question_of(const Arguments& arguments, const serve::Message& given) {
  ToolQuestion question;
  for (const auto& item : given.items()) {
    const auto argument = std::ranges::find(arguments, item.key(), &Argument::key);
    if (argument == arguments.end())
      throw UsageError(fmt::format("there is no argument {}", shown_text(item.key(), k_shown_key_bytes)));
    if (!fits_type(argument->schema, item.value()))
      throw UsageError(
          fmt::format("{}: the value is not of type {}", item.key(), argument->schema["type"].dump()));
    argument->set(question, Json(item.value()));
  }
  for (const Argument& argument : arguments)
    if (argument.required && !given.contains(argument.key))
      throw UsageError(fmt::format("{} is missing", argument.key));
  validate(question.method);
  return question;
}

}  // namespace moldlight::cli
