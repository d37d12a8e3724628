// Every option of the method, by its flag and by JSON: a walk over the one table.
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "classify/method_options.hpp"
#include "classify/option_json.hpp"
#include "cli/small_part.hpp"

namespace moldlight {
namespace {

using S = MethodSettings;

/// A value that the option takes and that is not its default.
std::string other_value(const Option<S>& option) {
  const S defaults;
  const auto differs = [&](const std::string& text) { return text != option_text(option, defaults); };
  if (const auto* real = std::get_if<RealKind<S>>(&option.kind)) {
    return differs(real_text(real->min)) ? real_text(real->min) : real_text(real->max);
  }
  if (const auto* integer = std::get_if<IntegerKind<S>>(&option.kind)) {
    return real_text(differs(real_text(integer->min)) ? integer->min : integer->max);
  }
  if (const auto* choice = std::get_if<ChoiceKind<S>>(&option.kind)) return std::string(choice->words.back());
  if (std::holds_alternative<SwitchKind<S>>(option.kind)) return differs("on") ? "on" : "off";
  return "0.125";
}

TEST(OptionTable, KeysAndFlagsAreUniqueAndExplained) {
  std::set<std::string_view> keys, flags;
  for (const Option<S>& option : method_options()) {
    EXPECT_TRUE(keys.insert(option.key).second) << option.key;
    EXPECT_TRUE(flags.insert(option.flag).second) << option.flag;
    EXPECT_TRUE(option.flag.starts_with("--")) << option.flag;
    EXPECT_GT(option.help.size(), 20u) << option.flag;
    EXPECT_FALSE(option.label.empty()) << option.flag;
  }
}

TEST(OptionTable, EveryOptionGoesThroughTextAndJsonAndBack) {
  for (const Option<S>& option : method_options()) {
    S settings;
    const std::string text = other_value(option);
    set_option(option, settings, text);
    EXPECT_EQ(option_text(option, settings), text) << option.flag;
    const auto json = options_json(method_options(), settings);
    EXPECT_NE(json, options_json(method_options(), S())) << option.flag;
    S back;
    set_options(method_options(), back, nlohmann::ordered_json::parse(json.dump()));
    EXPECT_EQ(options_json(method_options(), back), json) << option.flag;
    EXPECT_EQ(option_text(option, back), text) << option.flag;
  }
}

TEST(OptionTable, UnknownKeysAndBadValuesInJsonAreRefused) {
  S settings;
  EXPECT_THROW(set_options(method_options(), settings, {{"tau", 1}}), UsageError);
  EXPECT_THROW(set_options(method_options(), settings, {{"tau_deg", 11}}), UsageError);
  EXPECT_THROW(set_options(method_options(), settings, {{"tau_deg", {{"deg", 1}}}}), UsageError);
  EXPECT_THROW(set_options(method_options(), settings, nlohmann::ordered_json::array()), UsageError);
}

TEST(OptionTable, EveryOptionHasItsFlag) {
  const test::SmallPart part;
  const std::string help = test::run_moldlight({"classify", "--help"}).out;
  for (const Option<S>& option : method_options()) {
    EXPECT_NE(help.find("  " + std::string(option.flag) + " "), std::string::npos) << option.flag;
    S expected;
    std::vector<std::string> arguments = {"classify", part.file(), "--direction", "0,0,1", "--json", "-"};
    const auto add = [&](const std::string& flag, const std::string& value) {
      arguments.insert(arguments.end(), {flag, value});
    };
    if (std::holds_alternative<SwitchKind<S>>(option.kind)) {
      arguments.emplace_back(option.flag);
    } else {
      add(std::string(option.flag), other_value(option));
    }
    set_option(option, expected, other_value(option));
    if (option.key != "samples") add("--samples", "1000");
    if (option.key != "resolution") add("--resolution", "128");
    if (option.key == "backend") add("--readout", "samples");
    const auto run = test::run_moldlight(arguments);
    ASSERT_EQ(run.exit_code, 0) << option.flag << ": " << run.err;
    const auto json = test::json_of(run.out);
    const auto key = std::string(option.key);
    if (key == "backend") {
      EXPECT_EQ(json["settings"][key], "OSMesa");
    } else {
      EXPECT_EQ(json["settings"][key], options_json(method_options(), expected)[key]) << option.flag;
    }
  }
}

}  // namespace
}  // namespace moldlight
