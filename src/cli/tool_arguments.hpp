// The arguments of the tools of `moldlight serve`: made from the option tables of the commands, and what they
// set.
#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "classify/json.hpp"
#include "classify/option_schema.hpp"
#include "classify/still_picture.hpp"
#include "compare/comparison.hpp"
#include "parting/draft/draft_check.hpp"
#include "parting/mold_settings.hpp"
#include "serve/session.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight::cli {

enum class Shown : std::uint8_t { regions, side_actions, mold };

/// All that any tool takes, with the defaults of the commands.
struct ToolQuestion {
  std::string part, revision;
  ReadOptions reading;
  Direction direction;
  std::string direction_word;  // "best", "each"; empty: the direction counts
  MethodSettings method;
  DraftSettings draft;
  ActionSettings actions;
  SweepSettings sweep;
  MoldSettings mold;
  bool with_actions = false;
  CompareSettings compare;
  StillSettings still;
  Shown shown = Shown::regions;
};

/// How an argument is described, and how it is set.
struct Argument {
  std::string key;
  Json schema;
  std::function<void(ToolQuestion&, const Json&)> set;
  bool required = false;
};
using Arguments = std::vector<Argument>;

/// Those of a table, whose settings `settings` finds in the question.
template <typename S, typename Settings>
[[nodiscard]] Arguments from_table(std::span<const Option<S>> options, Settings settings) {
  Arguments arguments;
  ToolQuestion defaults;
  for (const Option<S>& option : options)
    arguments.push_back({std::string(option.key), option_schema<S>(option, std::invoke(settings, defaults)),
                         [&option, settings](ToolQuestion& question, const Json& value) {
                           set_from_form<S>(option, std::invoke(settings, question), value);
                         }});
  return arguments;
}

// Those that no table has.

[[nodiscard]] Argument path_argument(std::string key, const std::string& what,
                                     std::string ToolQuestion::*path);
/// `words` stand for a direction, too; the first is the default of one that may be left out.
[[nodiscard]] Argument direction_argument(const std::string& help, const Words& words, bool required);
[[nodiscard]] Argument side_actions_argument();
/// What a picture is of, and its size.
[[nodiscard]] Arguments picture_arguments();

[[nodiscard]] Arguments joined(std::initializer_list<Arguments> groups);

/// Of all of them, as an object.
[[nodiscard]] Json schema_of(const Arguments& arguments);
/// Throws UsageError for what is not as the schema says.
[[nodiscard]] ToolQuestion question_of(const Arguments& arguments, const serve::Message& given);

}  // namespace moldlight::cli
