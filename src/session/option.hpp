// One description of a setting, from which command line, JSON and window are all made.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

namespace moldlight {

/// Parsers that the option tables share; `what` names the option in the UsageError that they throw. Ranges
/// are inclusive; values out of range are refused, never clamped.
[[nodiscard]] double parse_real(std::string_view text, std::string_view what);
[[nodiscard]] double parse_real(std::string_view text, std::string_view what, double min, double max);
[[nodiscard]] double parse_positive(std::string_view text, std::string_view what, double max);
[[nodiscard]] int parse_integer(std::string_view text, std::string_view what, int min, int max, bool odd);
[[nodiscard]] bool parse_switch(std::string_view text, std::string_view what);
[[nodiscard]] glm::dvec3 parse_direction(std::string_view text, std::string_view what);
[[nodiscard]] std::vector<glm::dvec3> parse_directions(std::string_view text, std::string_view what);
using Words = std::vector<std::string_view>;
[[nodiscard]] int parse_word(std::string_view text, std::string_view what, const Words& words);
/// Of "a,b", "all" or "none".
[[nodiscard]] Words parse_words(std::string_view text, std::string_view what, const Words& words);
/// Shortest text that reads back as the same number.
[[nodiscard]] std::string real_text(double value);

/// Kinds of settings of a struct S. Each gives the setting's value, unset ones as none, and sets it from text
/// as the command line takes it; `what` names the option in the UsageError for what it refuses.
template <typename S>
struct RealKind {
  double S::*member;
  double min, max, step;  // step: of a slider or an arrow key

  double value(const S& s) const { return s.*member; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    s.*member = parse_real(text, what, min, max);
  }
};
/// A number greater than 0; 0 while it is unset.
template <typename S>
struct PositiveKind {
  double& (*member)(S&);
  double max = std::numeric_limits<double>::infinity();

  std::optional<double> value(S s) const { return member(s) > 0.0 ? std::optional(member(s)) : std::nullopt; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    member(s) = text.empty() ? 0.0 : parse_positive(text, what, max);
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
  void parse(S& s, std::string_view text, std::string_view what) const {
    s.*member = standard != 0 && text.empty() ? 0 : parse_integer(text, what, min, max, odd);
  }
};
template <typename S>
struct SwitchKind {
  bool S::*member;

  bool value(const S& s) const { return s.*member; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    s.*member = parse_switch(text, what);
  }
};
/// One of a few words; index k of `words` is enumerator k.
template <typename S>
struct ChoiceKind {
  Words words;
  int (*get)(const S&);
  void (*set)(S&, int);

  std::string_view value(const S& s) const { return words[static_cast<std::size_t>(get(s))]; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    set(s, parse_word(text, what, words));
  }
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

/// Three finite numbers, not all zero, "X,Y,Z".
template <typename S>
struct DirectionKind {
  glm::dvec3 S::*member;

  glm::dvec3 value(const S& s) const { return s.*member; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    s.*member = parse_direction(text, what);
  }
};
/// Any number of them, a line each; the window has no control for it.
template <typename S>
struct DirectionsKind {
  std::vector<glm::dvec3> S::*member;

  std::vector<glm::dvec3> value(const S& s) const { return s.*member; }
  void parse(S& s, std::string_view text, std::string_view what) const {
    s.*member = parse_directions(text, what);
  }
};
/// Some of a few words, "a,b", in the order given; "all" or "none".
template <typename S>
struct SetKind {
  Words words;
  Words (*get)(const S&);
  void (*set)(S&, const Words& chosen);

  Words value(const S& s) const { return get(s); }
  void parse(S& s, std::string_view text, std::string_view what) const {
    set(s, parse_words(text, what, words));
  }
};
/// Text that the setting's own parser reads. The window offers the words.
template <typename S>
struct TextKind {
  std::string_view name;  // stands for it in the help
  std::string (*get)(const S&);
  void (*set)(S&, std::string_view text);  // throws UsageError
  Words words = {};

  std::string value(const S& s) const { return get(s); }
  void parse(S& s, std::string_view text, std::string_view) const { set(s, text); }
};

template <typename S>
struct Option {
  std::string_view key;    // in JSON, and with - for _ the command line's --flag unless `flag` says otherwise
  std::string_view flag;   // "--tau"
  std::string_view label;  // in the window
  std::string_view unit;   // "deg", "texel", "part's unit"; empty where there is none
  std::string_view help;   // one or two sentences
  std::variant<RealKind<S>, PositiveKind<S>, IntegerKind<S>, SwitchKind<S>, ChoiceKind<S>, DirectionKind<S>,
               DirectionsKind<S>, SetKind<S>, TextKind<S>>
      kind;
};

}  // namespace moldlight
