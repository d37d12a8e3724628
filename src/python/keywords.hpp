// The settings as keyword arguments: made from the option tables, with their help, ranges and defaults.
#pragma once

#include <cmath>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <pybind11/pybind11.h>

#include "classify/json.hpp"
#include "classify/method_options.hpp"
#include "classify/option.hpp"
#include "classify/option_json.hpp"
#include "classify/settings.hpp"
#include "python/values.hpp"

namespace moldlight::python {

/// A setting as it is described: in docstrings, in the stubs, to programs that make a control of it.
struct Keyword {
  std::string_view key, label, unit;
  std::string help;
  std::string type;                // as an annotation, without None
  Json standard;                   // null: unset
  std::vector<std::string> words;  // that it may be; empty: anything of its type
  std::optional<double> least, greatest;
};

/// The keyword that stands for a flag of the command line; empty where none does.
[[nodiscard]] std::string_view keyword_of_flag(std::string_view flag);

/// A text of the program with the keyword for every flag that is a setting's.
[[nodiscard]] std::string with_keywords(std::string_view text);

template <typename S>
std::string annotation(const Option<S>& option) {
  return std::visit(
      moldlight::detail::Overloaded{
          [](const RealKind<S>&) { return std::string("float"); },
          [](const PositiveKind<S>&) { return std::string("float"); },
          [](const IntegerKind<S>&) { return std::string("int"); },
          [](const SwitchKind<S>&) { return std::string("bool"); },
          [](const ChoiceKind<S>& kind) {
            return fmt::format("Literal['{}']", fmt::join(kind.words, "', '"));
          },
          [](const DirectionsKind<S>&) { return std::string("Union[Direction, Iterable[Direction]]"); },
          [](const SetKind<S>&) { return std::string("Union[str, Iterable[str]]"); },
          [](const TextKind<S>&) { return std::string("Union[str, float]"); },
      },
      option.kind);
}

template <typename S>
Keyword keyword_of(const Option<S>& option, const S& defaults) {
  Keyword keyword{
      .key = option.key,
      .label = option.label,
      .unit = option.unit,
      .help = with_keywords(option.help),
      .type = annotation(option),
      .standard = std::visit(
          [&](const auto& kind) { return moldlight::detail::value_json(kind.value(defaults)); }, option.kind),
      .words = {},
      .least = {},
      .greatest = {}};
  // Unset text is no text.
  if (keyword.standard.is_string() && keyword.standard.get<std::string>().empty()) keyword.standard = Json();
  const auto add_words = [&](const Words& words) { keyword.words.assign(words.begin(), words.end()); };
  std::visit(moldlight::detail::Overloaded{
                 [&](const RealKind<S>& kind) { keyword.least = kind.min, keyword.greatest = kind.max; },
                 [&](const IntegerKind<S>& kind) { keyword.least = kind.min, keyword.greatest = kind.max; },
                 [&](const PositiveKind<S>& kind) {
                   if (std::isfinite(kind.max)) keyword.greatest = kind.max;
                 },
                 [&](const ChoiceKind<S>& kind) { add_words(kind.words); },
                 [&](const SetKind<S>& kind) { add_words(kind.words); }, [](const auto&) {}},
             option.kind);
  return keyword;
}

/// The tables of options that a call takes, registered beside it at namespace scope.
class CallSettings {
 public:
  template <typename... S>
  explicit CallSettings(std::string_view call, std::span<const Option<S>>... tables) {
    (add(call, tables), ...);
  }

 private:
  template <typename S>
  static void add(std::string_view call, std::span<const Option<S>> options) {
    add_table(call, [options](std::vector<Keyword>& keywords) {
      for (const Option<S>& option : options) keywords.push_back(keyword_of(option, S{}));
    });
    for (const Option<S>& option : options) add_flag(option.flag, option.key);
  }
  static void add_table(std::string_view call, std::function<void(std::vector<Keyword>&)> add);
  static void add_flag(std::string_view flag, std::string_view key);
};

/// Reads the settings of a call from its keyword arguments.
class Given {
 public:
  /// `call` names the call in messages.
  Given(std::string_view call, const py::kwargs& keywords) : call_(call), keywords_(keywords) {}

  /// Sets every option that is given; None leaves the default. Throws UsageError as the option does.
  template <typename S>
  void take(std::span<const Option<S>> options, S& settings) {
    for (const Option<S>& option : options) take(option, settings);
  }
  template <typename S>
  void take(const Option<S>& option, S& settings) {
    const py::object value = take(option.key);
    if (value.is_none()) return;
    set_option(option, settings, value);
  }
  /// The argument of this name, once; None where it is not given.
  [[nodiscard]] py::object take(std::string_view key);
  [[nodiscard]] bool take_switch(std::string_view key);
  /// Throws a TypeError for an argument that nothing took.
  void end() const;

 private:
  template <typename S>
  static void set_option(const Option<S>& option, S& settings, const py::object& value) {
    std::string text;
    const std::string_view key = option.key;
    if (std::holds_alternative<DirectionsKind<S>>(option.kind)) {
      text = directions_text(value, key);
    } else if (std::holds_alternative<SetKind<S>>(option.kind)) {
      text = words_text(value, key);
    } else {
      text = value_text(value, key);
      const auto* words = std::get_if<TextKind<S>>(&option.kind);
      if (words != nullptr && !words->bare.empty() && text == "on") text = words->bare;
      if (text.empty()) throw UsageError(fmt::format("{}: the value is empty", key));
    }
    std::visit([&](const auto& kind) { kind.parse(settings, {text, key}); }, option.kind);
  }

  std::string call_;
  const py::kwargs& keywords_;
  std::vector<std::string> taken_;
};

/// The options that a part of arrays has, out of reading_options().
[[nodiscard]] std::span<const Option<ReadOptions>> array_options();
/// What a picture takes of look_options().
[[nodiscard]] std::span<const Option<LookSettings>> picture_looks();

/// The settings of a call, "Part", "read", "classify", "sweep", "actions", "mold", "picture", in order.
/// Throws UsageError for another name.
[[nodiscard]] const std::vector<Keyword>& keywords_of(std::string_view call);

/// A docstring that begins with the signature as Python reads it from there: `name(arguments, *, keywords)`;
/// `more` are keyword arguments that are no settings, with their defaults; `text` comes before the settings'
/// own help. It lives as long as the program.
struct CallText {
  std::string_view name, arguments, more, text;
  std::string_view settings = {};  // as keywords_of() calls them; empty: none
};
[[nodiscard]] const char* call_doc(const CallText& call);

/// Of moldlight.settings(): a list with a dict a setting.
[[nodiscard]] py::list settings_list(std::string_view call);

}  // namespace moldlight::python
