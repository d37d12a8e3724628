// One description of a setting, from which command line, JSON and window are all made; a setting as text.
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "base/check.hpp"
#include "base/error.hpp"

namespace moldlight {

using Words = std::vector<std::string_view>;

/// A setting as text, as the command line takes it, and what a UsageError calls it.
struct GivenText {
  std::string_view text, what;
};
/// Parsers that the option tables share. They throw UsageError for what they refuse. Ranges are inclusive;
/// values out of range are refused, never clamped.
[[nodiscard]] double parse_real(const GivenText& given);
[[nodiscard]] double parse_real(const GivenText& given, double min, double max);
[[nodiscard]] double parse_positive(const GivenText& given, double max);
[[nodiscard]] int parse_integer(const GivenText& given, int min, int max, bool odd);
[[nodiscard]] bool parse_switch(const GivenText& given);
/// Three finite numbers, not all zero, "X,Y,Z"; or an axis, "z" or "-y".
[[nodiscard]] glm::dvec3 parse_direction(const GivenText& given);
[[nodiscard]] std::vector<glm::dvec3> parse_directions(const GivenText& given);
[[nodiscard]] int parse_word(const GivenText& given, const Words& words);
/// Of "a,b", "all" or "none".
[[nodiscard]] Words parse_words(const GivenText& given, const Words& words);
/// Shortest text that reads back as the same number.
[[nodiscard]] std::string real_text(double value);

/// Kinds of settings of a struct S. Each gives the setting's value, unset ones as none, and sets it from
/// text.
template <typename S>
struct RealKind {
  double S::*member;
  double min, max, step;  // step: of a slider or an arrow key

  double value(const S& s) const { return s.*member; }
  void parse(S& s, const GivenText& given) const { s.*member = parse_real(given, min, max); }
};
/// A number greater than 0; 0 while it is unset.
template <typename S>
struct PositiveKind {
  double& (*member)(S&);
  double max = std::numeric_limits<double>::infinity();

  std::optional<double> value(S s) const { return member(s) > 0.0 ? std::optional(member(s)) : std::nullopt; }
  void parse(S& s, const GivenText& given) const {
    member(s) = given.text.empty() ? 0.0 : parse_positive(given, max);
  }
};
template <typename S>
struct IntegerKind {
  int S::*member;
  int min, max;
  bool odd = false;  // only odd values
  int standard = 0;  // where not 0: the setting may be left unset, which is 0; a slider then stands here

  std::optional<int> value(const S& s) const {
    return standard != 0 && s.*member == 0 ? std::nullopt : std::optional(s.*member);
  }
  void parse(S& s, const GivenText& given) const {
    s.*member = standard != 0 && given.text.empty() ? 0 : parse_integer(given, min, max, odd);
  }
};
template <typename S>
struct SwitchKind {
  bool S::*member;

  bool value(const S& s) const { return s.*member; }
  void parse(S& s, const GivenText& given) const { s.*member = parse_switch(given); }
};
/// One of a few words; index k of `words` is enumerator k.
template <typename S>
struct ChoiceKind {
  Words words;
  int (*get)(const S&);
  void (*set)(S&, int);

  std::string_view value(const S& s) const { return words[static_cast<std::size_t>(get(s))]; }
  void parse(S& s, const GivenText& given) const { set(s, parse_word(given, words)); }
};

namespace detail {
template <typename>
struct MemberPointer;
template <typename S, typename T>
struct MemberPointer<T S::*> {
  using Struct = S;
  using Type = T;
};
}  // namespace detail

/// The choice of an enumeration member, choice<&S::member>({"word of enumerator 0", …}).
template <auto k_member>
[[nodiscard]] auto choice(Words words) {
  using Struct = typename detail::MemberPointer<decltype(k_member)>::Struct;
  using Enum = typename detail::MemberPointer<decltype(k_member)>::Type;
  return ChoiceKind<Struct>{
      .words = std::move(words),
      .get = [](const Struct& settings) { return static_cast<int>(settings.*k_member); },
      .set = [](Struct& settings, int index) { settings.*k_member = static_cast<Enum>(index); }};
}

/// Any number of directions, a line each; the window has no control for it.
template <typename S>
struct DirectionsKind {
  std::vector<glm::dvec3> S::*member;

  std::vector<glm::dvec3> value(const S& s) const { return s.*member; }
  void parse(S& s, const GivenText& given) const { s.*member = parse_directions(given); }
};
/// Some of a few words, "a,b", in the order given; "all" or "none".
template <typename S>
struct SetKind {
  Words words;
  Words (*get)(const S&);
  void (*set)(S&, const Words& chosen);

  Words value(const S& s) const { return get(s); }
  void parse(S& s, const GivenText& given) const { set(s, parse_words(given, words)); }
};
/// Text that the setting's own parser reads. The window offers the words.
template <typename S>
struct TextKind {
  std::string_view name;  // stands for it in the help
  std::string (*get)(const S&);
  void (*set)(S&, std::string_view text);  // throws UsageError
  Words words = {};
  std::string_view bare = {};  // where not empty: what the flag means without a value

  std::string value(const S& s) const { return get(s); }
  void parse(S& s, const GivenText& given) const { set(s, given.text); }
};

/// Units of options that the window writes in words of its own, where it can as lengths.
inline constexpr std::string_view k_texels_across = "texels across", k_half_diagonal = "half diagonal",
                                  k_share = "share";

template <typename S>
struct Option {
  std::string_view key;    // in JSON, and with - for _ the command line's --flag unless `flag` says otherwise
  std::string_view flag;   // "--tau"
  std::string_view label;  // in the window
  std::string_view unit;   // "deg", "texel", "part's unit"; empty where there is none
  std::string_view help;   // one or two sentences
  std::variant<RealKind<S>, PositiveKind<S>, IntegerKind<S>, SwitchKind<S>, ChoiceKind<S>, DirectionsKind<S>,
               SetKind<S>, TextKind<S>>
      kind;
};

/// The option of this key, which the table must hold.
template <typename S>
[[nodiscard]] const Option<S>& option_named(std::span<const Option<S>> options, std::string_view key) {
  const auto found = std::ranges::find(options, key, &Option<S>::key);
  CHECK(found != options.end());
  return *found;
}

namespace detail {

template <typename... Visitors>
struct Overloaded : Visitors... {
  using Visitors::operator()...;
};
template <typename... Visitors>
Overloaded(Visitors...) -> Overloaded<Visitors...>;

inline std::string value_text(double value) { return real_text(value); }
inline std::string value_text(int value) { return fmt::format("{}", value); }
inline std::string value_text(bool value) { return value ? "on" : "off"; }
inline std::string value_text(std::string_view text) { return std::string(text); }
inline std::string value_text(const glm::dvec3& d) { return fmt::format("{},{},{}", d.x, d.y, d.z); }
inline std::string value_text(const std::vector<glm::dvec3>& directions) {
  std::string text;
  for (const glm::dvec3& d : directions) text += (text.empty() ? "" : "\n") + value_text(d);
  return text;
}
inline std::string value_text(const Words& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ","));
}
template <typename T>
std::string value_text(const std::optional<T>& value) {
  return value ? value_text(*value) : std::string();
}

}  // namespace detail

/// The setting's value as the command line takes it; empty for an unset one.
template <typename S>
[[nodiscard]] std::string option_text(const Option<S>& option, const S& settings) {
  return std::visit([&](const auto& kind) { return detail::value_text(kind.value(settings)); }, option.kind);
}

/// Sets from text as the command line takes it, or unsets by an empty one; throws UsageError that names the
/// option, the value and the range.
template <typename S>
void set_option(const Option<S>& option, S& settings, std::string_view text) {
  std::visit([&](const auto& kind) { kind.parse(settings, {text, option.flag}); }, option.kind);
}

}  // namespace moldlight
