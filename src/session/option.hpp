// One description of a setting, from which command line, JSON and window are all made.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include <glm/vec3.hpp>

#include "base/check.hpp"

namespace moldlight {

/// Kinds of settings of a struct S. Ranges are inclusive; values out of range are refused, never clamped.
template <typename S>
struct RealKind {
  double S::*member;
  double min, max, step;  // step: of a slider or an arrow key
};
/// A positive length that may be left unset.
template <typename S>
struct OptionalRealKind {
  std::optional<double> S::*member;
};
template <typename S>
struct IntegerKind {
  int S::*member;
  int min, max;
  bool odd = false;  // only odd values
};
/// The same, which may be left unset; a slider then stands at `standard`.
template <typename S>
struct OptionalIntegerKind {
  std::optional<int> S::*member;
  int min, max;
  bool odd;
  int standard;
};
template <typename S>
struct SwitchKind {
  bool S::*member;
};
/// One of a few words; index k of `words` is enumerator k.
template <typename S>
struct ChoiceKind {
  std::vector<std::string_view> words;
  int (*get)(const S&);
  void (*set)(S&, int);
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
[[nodiscard]] auto choice(std::vector<std::string_view> words) {
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
};

template <typename S>
struct Option {
  std::string_view key;    // in JSON, and with - for _ the command line's --flag unless `flag` says otherwise
  std::string_view flag;   // "--tau"
  std::string_view label;  // in the window
  std::string_view unit;   // "deg", "texel", "part's unit"; empty where there is none
  std::string_view help;   // one or two sentences
  std::variant<RealKind<S>, OptionalRealKind<S>, IntegerKind<S>, OptionalIntegerKind<S>, SwitchKind<S>,
               ChoiceKind<S>, DirectionKind<S>>
      kind;
};

/// The option of this key, which the table must hold.
template <typename S>
[[nodiscard]] const Option<S>& option_named(std::span<const Option<S>> options, std::string_view key) {
  const auto found = std::ranges::find(options, key, &Option<S>::key);
  CHECK(found != options.end());
  return *found;
}

/// Parsers that the option tables share; `what` names the option in the UsageError that they throw.
[[nodiscard]] double parse_real(std::string_view text, std::string_view what);
[[nodiscard]] int parse_integer(std::string_view text, std::string_view what);
[[nodiscard]] glm::dvec3 parse_direction(std::string_view text, std::string_view what);
/// Shortest text that reads back as the same number.
[[nodiscard]] std::string real_text(double value);

}  // namespace moldlight
