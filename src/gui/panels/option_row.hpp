// One row for one option of a table: the right control for its kind, its tooltip and its reset.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/format.h>

#include "base/check.hpp"
#include "base/error.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "session/option_table.hpp"

namespace moldlight::gui {

/// "1.0°", "3 texel", "2048²": a value with its unit as the window writes it.
[[nodiscard]] std::string value_text(double value, int decimals, std::string_view unit);
/// Tooltip and right-click menu of the row just drawn; true when its reset was chosen.
bool option_menu(const Ui& ui, std::string_view label, std::string_view help, const std::string& value,
                 const std::string& default_value, bool modified);

/// The nearest of 1, 1.5, 2, 3, 4, 6, 8 …: what map resolutions are.
[[nodiscard]] double near_power_of_two(double value);
/// The nearest of 1, 2, 5, 10, 20 …
[[nodiscard]] double near_round_number(double value);

namespace detail {

[[nodiscard]] inline int decimals_of(double step) {
  return step >= 1.0 || step <= 0.0 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
}

}  // namespace detail

/// The option of this key, which the table must hold.
template <typename S>
[[nodiscard]] const Option<S>& option_named(std::span<const Option<S>> options, std::string_view key) {
  const auto found = std::ranges::find(options, key, &Option<S>::key);
  CHECK(found != options.end());
  return *found;
}
/// Whether the option is one of these.
template <typename S>
[[nodiscard]] bool is_among(std::span<const std::string_view> keys, const Option<S>& option) {
  return std::ranges::find(keys, option.key) != keys.end();
}

/// Numbers are typed in place of being slid.
struct TypedNumbers {
  std::function<void(const std::string& why)> refused;  // told of a value out of range
};

/// Whether the window has a control for it.
template <typename S>
[[nodiscard]] bool has_control(const Option<S>& option) {
  return !std::holds_alternative<DirectionsKind<S>>(option.kind);
}
/// Whether its control takes the panel's width.
template <typename S>
[[nodiscard]] bool is_wide(const Option<S>& option) {
  return std::holds_alternative<SetKind<S>>(option.kind) || std::holds_alternative<TextKind<S>>(option.kind);
}

/// Edits one option in place; values out of its range cannot be entered. Returns true if it changed.
template <typename S>
bool option_row(const Ui& ui, const Option<S>& option, S& settings, const TypedNumbers& typed = {}) {
  const S defaults{};
  const std::string before = option_text(option, settings), standard = option_text(option, defaults);
  const bool modified = before != standard;
  S edited = settings;
  std::string after;
  bool as_text = false;  // `after` tells the value, not `edited`
  const auto field = [&](double number, int decimals) {
    if (!number_field(ui, option.key.data(), option.label, number, decimals,
                      ImGui::GetContentRegionAvail().x))
      return false;
    after = real_text(number);
    return as_text = true;
  };
  const auto integer_row = [&](const IntegerKind<S>& kind) {
    double number = kind.value(edited).value_or(kind.standard);
    if (typed.refused) return field(number, 0);
    const bool wide = kind.max > 100 * kind.min;
    const bool moved = slider(ui, option.label, number,
                              {.min = static_cast<double>(kind.min),
                               .max = static_cast<double>(kind.max),
                               .step = 1.0,
                               .logarithmic = wide,
                               .snap = !wide                    ? std::function<double(double)>()
                                       : option.unit == "texel" ? near_power_of_two
                                                                : near_round_number,
                               .text = [&](double v) { return value_text(v, 0, option.unit); }},
                              modified);
    if (!moved) return false;
    int whole = static_cast<int>(std::lround(number));
    if (kind.odd && whole % 2 == 0) whole += whole < kind.max ? 1 : -1;
    edited.*kind.member = whole;
    return true;
  };
  bool changed = std::visit(
      moldlight::detail::Overloaded{
          [&](const RealKind<S>& kind) {
            double& value = edited.*kind.member;
            const int decimals = detail::decimals_of(kind.step);
            if (typed.refused) return field(value, decimals);
            return slider(ui, option.label, value,
                          {.min = kind.min,
                           .max = kind.max,
                           .step = kind.step,
                           .text = [&](double v) { return value_text(v, decimals, option.unit); }},
                          modified);
          },
          [&](const PositiveKind<S>& kind) {
            if (!field(kind.member(edited), 3)) return false;
            if (after == "0" || after.starts_with('-')) after.clear();  // none
            return true;
          },
          [&](const IntegerKind<S>& kind) { return integer_row(kind); },
          [&](const SwitchKind<S>& kind) { return toggle(ui, option.label, edited.*kind.member, modified); },
          [&](const ChoiceKind<S>& kind) {
            int index = kind.get(edited);
            if (!choice(ui, option.label, kind.words, index, modified)) return false;
            kind.set(edited, index);
            return true;
          },
          [&](const SetKind<S>& kind) {
            auto chosen = kind.get(edited);
            if (!chips(ui, kind.words, chosen)) return false;
            kind.set(edited, chosen);
            return true;
          },
          [&](const TextKind<S>& kind) {
            const auto word = std::find(kind.words.begin(), kind.words.end(), before);
            int index = word == kind.words.end() ? -1 : static_cast<int>(word - kind.words.begin());
            if (!choice(ui, option.label, kind.words, index, modified)) return false;
            after = kind.words[static_cast<std::size_t>(index)];
            return as_text = true;
          },
          [](const auto&) { return false; },  // directions
      },
      option.kind);
  if (option_menu(ui, option.label, option.help, before, standard, modified)) {
    after = standard;
    changed = as_text = true;
  }
  if (!changed) return false;
  if (!as_text) after = option_text(option, edited);
  try {
    set_option(option, settings, after);
  } catch (const UsageError& error) {
    if (typed.refused) typed.refused(error.what());
    return false;  // a value typed out of range
  }
  return after != before;
}

}  // namespace moldlight::gui
