#include "python/keywords.hpp"

#include <array>
#include <cctype>
#include <deque>
#include <functional>
#include <map>

#include "actions/action_settings.hpp"
#include "classify/look_options.hpp"
#include "classify/option_json.hpp"
#include "classify/still_picture.hpp"
#include "parting/draft/draft_check.hpp"
#include "parting/mold_settings.hpp"
#include "sweep/sweep_settings.hpp"

namespace moldlight::python {

namespace py = pybind11;

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t k_help_width = 92;

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

template <typename S>
void add(std::vector<Keyword>& keywords, std::span<const Option<S>> options, const S& defaults = {}) {
  for (const Option<S>& option : options) keywords.push_back(keyword_of(option, defaults));
}

std::vector<Keyword> picture_keywords() {
  std::vector<Keyword> keywords;
  add(keywords, still_options(), StillSettings{});
  for (const std::string_view key : picture_looks())
    keywords.push_back(keyword_of(option_named(look_options(), key), LookSettings{}));
  return keywords;
}

std::map<std::string, std::vector<Keyword>, std::less<>> all_keywords() {
  std::map<std::string, std::vector<Keyword>, std::less<>> calls;
  add(calls["Part"], array_options());
  add(calls["read"], reading_options());
  add(calls["classify"], method_options());
  add(calls["classify"], draft_options());
  add(calls["sweep"], sweep_options());
  add(calls["sweep"], action_options());
  add(calls["sweep"], method_options());
  add(calls["actions"], action_options());
  add(calls["actions"], method_options());
  add(calls["mold"], mold_options());
  add(calls["mold"], method_options());
  calls["picture"] = picture_keywords();
  return calls;
}

template <typename S>
void add_flags(std::map<std::string_view, std::string_view>& keys, std::span<const Option<S>> options) {
  for (const Option<S>& option : options) keys.emplace(option.flag, option.key);
}

/// As Python writes the value.
std::string literal(const Json& value) {
  if (value.is_null()) return "None";
  if (value.is_boolean()) return value.get<bool>() ? "True" : "False";
  if (value.is_string()) return "'" + value.get<std::string>() + "'";
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Json& item : value) text += (text.empty() ? "" : ", ") + literal(item);
  return "[" + text + "]";
}

/// Lines of at most k_help_width columns, all but the first indented by `indent`.
std::string wrapped(std::string_view text, std::size_t indent) {
  std::string lines;
  std::size_t column = 0;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (column > indent && column + 1 + word.size() > k_help_width) {
      lines += "\n" + std::string(indent, ' ');
      column = indent;
    } else if (column > 0) {
      lines += ' ';
      ++column;
    }
    lines += word;
    column += word.size();
  }
  return lines;
}

std::string keyword_help(const Keyword& keyword) {
  std::string facts = std::string(keyword.unit);
  const auto add_fact = [&](const std::string& fact) { facts += (facts.empty() ? "" : ", ") + fact; };
  if (!keyword.words.empty())
    add_fact(fmt::format("'{}'", fmt::join(keyword.words, "', '")));
  else if (keyword.least && keyword.greatest)
    add_fact(fmt::format("{:g} to {:g}", *keyword.least, *keyword.greatest));
  else if (keyword.greatest)
    add_fact(fmt::format("up to {:g}", *keyword.greatest));
  return fmt::format("{}{}: {}", keyword.key, facts.empty() ? "" : " (" + facts + ")", keyword.help);
}

bool is_flag_letter(char c) {
  return std::islower(static_cast<unsigned char>(c)) != 0 ||
         std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '-';
}

}  // namespace

void Given::take(MethodSettings& method) {
  const auto given = [this](const char* key) { return keywords_.contains(key) && !keywords_[key].is_none(); };
  if (given("kernel") && given("tolerance"))
    throw UsageError("kernel, tolerance: they replace each other; give one");
  take(method_options(), method);
}

py::object Given::take(std::string_view key) {
  taken_.emplace_back(key);
  const py::str name(key.data(), key.size());
  return keywords_.contains(name) ? py::object(keywords_[name]) : py::object(py::none());
}

bool Given::take_switch(std::string_view key) {
  const py::object value = take(key);
  return !value.is_none() && parse_switch({value_text(value, key), key});
}

void Given::end() const {
  for (const auto& [name, value] : keywords_) {
    const std::string key = py::str(name);
    if (std::ranges::find(taken_, key) == taken_.end())
      throw py::type_error(fmt::format("{}() got an unexpected keyword argument '{}'; it takes {}", call_,
                                       key, fmt::join(taken_, ", ")));
  }
}

std::span<const Option<ReadOptions>> array_options() {
  static const std::vector<Option<ReadOptions>> k_options = [] {
    std::vector<Option<ReadOptions>> options;
    for (const std::string_view key : {"unit", "repair", "weld_tolerance"})
      options.push_back(option_named(reading_options(), key));
    return options;
  }();
  return k_options;
}

std::span<const std::string_view> picture_looks() {
  static constexpr std::array<std::string_view, 3> k_looks = {"palette", "regions", "mark_difference"};
  return k_looks;
}

const std::vector<Keyword>& keywords_of(std::string_view call) {
  static const auto k_calls = all_keywords();
  const auto found = k_calls.find(call);
  if (found == k_calls.end())
    throw UsageError(fmt::format("settings: '{}' is none of {}", call, [] {
      std::string names;
      for (const auto& [name, keywords] : k_calls) names += (names.empty() ? "" : ", ") + name;
      return names;
    }()));
  return found->second;
}

std::string_view keyword_of_flag(std::string_view flag) {
  static const auto k_keys = [] {
    std::map<std::string_view, std::string_view> keys;
    add_flags(keys, method_options());
    add_flags(keys, reading_options());
    add_flags(keys, draft_options());
    add_flags(keys, sweep_options());
    add_flags(keys, action_options());
    add_flags(keys, mold_options());
    add_flags(keys, still_options());
    add_flags(keys, look_options());
    // Of a sweep its given directions, elsewhere the direction itself.
    keys.erase("--direction");
    keys.emplace("--compare-maps", "compare_maps");
    return keys;
  }();
  const auto found = k_keys.find(flag);
  return found == k_keys.end() ? std::string_view() : found->second;
}

std::string with_keywords(std::string_view text) {
  std::string with;
  while (!text.empty()) {
    const std::size_t begin = text.find("--");
    with += text.substr(0, begin);
    if (begin == std::string_view::npos) break;
    const bool apart = begin == 0 || text[begin - 1] == ' ' || text[begin - 1] == '(';
    text.remove_prefix(begin);
    std::size_t end = 2;
    while (end < text.size() && is_flag_letter(text[end])) ++end;
    const std::string_view keyword = apart ? keyword_of_flag(text.substr(0, end)) : std::string_view();
    with += keyword.empty() ? text.substr(0, end) : keyword;
    text.remove_prefix(end);
  }
  return with;
}

const char* call_doc(const CallText& call) {
  static std::deque<std::string> texts;
  std::string keywords(call.more), help;
  if (!call.settings.empty()) {
    help = "\n\nSettings; None leaves the default:\n";
    for (const Keyword& keyword : keywords_of(call.settings)) {
      keywords +=
          fmt::format("{}{}={}", keywords.empty() ? "" : ", ", keyword.key, literal(keyword.standard));
      help += "    " + wrapped(keyword_help(keyword), 8) + "\n";
    }
  }
  const std::string_view comma = call.arguments.empty() || keywords.empty() ? "" : ", ";
  texts.push_back(fmt::format("{}({}{}{}{})\n--\n\n{}{}", call.name, call.arguments, comma,
                              keywords.empty() ? "" : "*, ", keywords, call.text, help));
  return texts.back().c_str();
}

py::list settings_list(std::string_view call) {
  py::list list;
  for (const Keyword& keyword : keywords_of(call)) {
    py::dict entry;
    entry["key"] = std::string(keyword.key);
    entry["label"] = std::string(keyword.label);
    entry["unit"] = std::string(keyword.unit);
    entry["help"] = keyword.help;
    entry["type"] = keyword.type;
    entry["default"] = to_python(keyword.standard);
    py::list words;
    for (const std::string& word : keyword.words) words.append(word);
    entry["words"] = words;
    entry["least"] = keyword.least ? py::object(py::float_(*keyword.least)) : py::object(py::none());
    entry["greatest"] = keyword.greatest ? py::object(py::float_(*keyword.greatest)) : py::object(py::none());
    list.append(entry);
  }
  return list;
}

}  // namespace moldlight::python
