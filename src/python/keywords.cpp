#include "python/keywords.hpp"

#include <cctype>
#include <deque>
#include <map>

#include "base/shown_text.hpp"

namespace moldlight::python {

namespace {

constexpr std::size_t k_help_width = 92;

/// Those of a table under these keys.
template <typename S>
std::vector<Option<S>> chosen_options(std::span<const Option<S>> options,
                                      std::initializer_list<std::string_view> keys) {
  std::vector<Option<S>> chosen;
  for (const std::string_view key : keys) chosen.push_back(option_named(options, key));
  return chosen;
}

/// What is registered, in the order in which it is.
struct CallTable {
  std::string_view call;
  std::function<void(std::vector<Keyword>&)> add;
};
std::vector<CallTable>& call_tables() {
  static std::vector<CallTable> tables;
  return tables;
}
std::map<std::string_view, std::string_view>& flag_keys() {
  static std::map<std::string_view, std::string_view> keys;
  return keys;
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
  static const auto k_options = chosen_options(reading_options(), {"unit", "repair", "weld_tolerance"});
  return k_options;
}

std::span<const Option<LookSettings>> picture_looks() {
  static const auto k_options = chosen_options(look_options(), {"palette", "regions", "mark_difference"});
  return k_options;
}

void CallSettings::add_table(std::string_view call, std::function<void(std::vector<Keyword>&)> add) {
  call_tables().push_back({call, std::move(add)});
}
void CallSettings::add_flag(std::string_view flag, std::string_view key) { flag_keys().emplace(flag, key); }

const std::vector<Keyword>& keywords_of(std::string_view call) {
  static const auto k_calls = [] {
    std::map<std::string, std::vector<Keyword>, std::less<>> calls;
    for (const CallTable& table : call_tables()) table.add(calls[std::string(table.call)]);
    return calls;
  }();
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
    auto keys = flag_keys();
    for (const Option<LookSettings>& option : look_options()) keys.emplace(option.flag, option.key);
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
      help += "    " + wrapped_text(keyword_help(keyword), k_help_width, 8) + "\n";
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
