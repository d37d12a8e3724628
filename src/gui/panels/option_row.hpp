// One row for one option of a table: the right control for its kind, its tooltip and its reset.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>

#include <fmt/format.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "classify/option.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

/// What the part's lengths are, all in its unit.
struct PartLengths {
  double diagonal = 1.0;
  double texel = 1.0;  // of the shadow maps
  std::string unit;    // as it is written behind a number

  explicit PartLengths(const AppState& state);
  /// "0.15 mm"
  [[nodiscard]] std::string text(double length) const;
};

/// "1.0°", "40 %", "3 texel · 0.15 mm": a value with its unit as the window writes it; what is given by the
/// part's lengths only where they are known.
struct ShownValue {
  double value;
  int decimals;
  std::string_view unit;
};
[[nodiscard]] std::string value_text(const ShownValue& shown, const PartLengths* lengths = nullptr);
/// Tooltip and right-click menu of the row just drawn; true when its reset was chosen.
struct OptionTexts {
  std::string_view label, help;
  const std::string &value, &default_value;
};
bool option_menu(const Ui& ui, const OptionTexts& option);

/// The nearest of 1, 1.5, 2, 3, 4, 6, 8 …: what map resolutions are.
[[nodiscard]] double near_power_of_two(double value);
/// The nearest of 1, 2, 5, 10, 20 …
[[nodiscard]] double near_round_number(double value);

[[nodiscard]] inline int decimals_of(double step) {
  return step >= 1.0 || step <= 0.0 ? 0 : static_cast<int>(std::ceil(-std::log10(step) - 1e-9));
}

/// Whether the option is one of these.
template <typename S>
[[nodiscard]] bool is_among(std::span<const std::string_view> keys, const Option<S>& option) {
  return std::ranges::find(keys, option.key) != keys.end();
}

/// What a row may be given beside its option.
struct RowOptions {
  std::function<void(const std::string& why)> refused = {};  // numbers are typed in place of being slid;
                                                             // given of a value out of range
  const PartLengths* lengths = nullptr;                      // lengths are written beside texels
  std::string unset = {};                                    // stands for a number that is not set
  std::function<std::string(double)> text = {};              // what a slider says of its value
};

/// "Clearance, mm": what a field for a number is called.
[[nodiscard]] std::string number_label(std::string_view label, std::string_view unit);

/// Whether the window has a control for it.
template <typename S>
[[nodiscard]] bool has_control(const Option<S>& option) {
  const auto* text = std::get_if<TextKind<S>>(&option.kind);
  return !std::holds_alternative<DirectionsKind<S>>(option.kind) && (text == nullptr || !text->words.empty());
}
/// Whether its control takes the panel's width.
template <typename S>
[[nodiscard]] bool is_wide(const Option<S>& option) {
  return std::holds_alternative<SetKind<S>>(option.kind) || std::holds_alternative<TextKind<S>>(option.kind);
}

/// Edits one option in place; values out of its range cannot be entered. Returns true if it changed.
template <typename S>
bool option_row(const Ui& ui, const Option<S>& option, S& settings, const RowOptions& row = {}) {
  const std::string before = option_text(option, settings), standard = option_text(option, S{});
  const bool modified = before != standard;
  std::optional<std::string> after;  // what was entered
  const auto number_row = [&](double number, int decimals, SliderSpec spec) {
    spec.text = [&](double v) {
      return row.text ? row.text(v) : value_text({v, decimals, option.unit}, row.lengths);
    };
    const float width = room_left();
    if (row.refused ? number_field(ui, option.key.data(), number,
                                   {number_label(option.label, option.unit), decimals, width})
                    : slider(ui, {option.label, modified}, number, spec))
      after = real_text(number);
  };
  const auto words_row = [&](const Words& words) {
    const auto word = std::find(words.begin(), words.end(), before);
    int index = word == words.end() ? -1 : static_cast<int>(word - words.begin());
    if (choice(ui, {option.label, modified}, words, index)) after = words[static_cast<std::size_t>(index)];
  };
  std::visit(moldlight::detail::Overloaded{
                 [&](const RealKind<S>& kind) {
                   number_row(kind.value(settings), decimals_of(kind.step),
                              {.min = kind.min, .max = kind.max, .step = kind.step});
                 },
                 [&](const PositiveKind<S>& kind) {
                   double number = kind.value(settings).value_or(0.0);
                   const float width = room_left();
                   const std::string label = row.lengths && option.unit == "part's unit"
                                                 ? fmt::format("{}, {}", option.label, row.lengths->unit)
                                                 : std::string(option.label);
                   if (number_field(ui, option.key.data(), number, {label, 3, width, row.unset}))
                     after = number > 0.0 ? real_text(number) : std::string();  // none
                 },
                 [&](const IntegerKind<S>& kind) {
                   const bool wide = kind.max > 100 * kind.min;
                   number_row(kind.value(settings).value_or(kind.standard), 0,
                              {.min = static_cast<double>(kind.min),
                               .max = static_cast<double>(kind.max),
                               .step = 1.0,
                               .logarithmic = wide,
                               .snap = !wide                            ? std::function<double(double)>()
                                       : option.unit == k_texels_across ? near_power_of_two
                                                                        : near_round_number});
                   if (!after || row.refused) return;
                   int whole = static_cast<int>(std::lround(*number_from<double>(*after)));
                   if (kind.odd && whole % 2 == 0) whole += whole < kind.max ? 1 : -1;
                   after = fmt::format("{}", whole);
                 },
                 [&](const SwitchKind<S>& kind) {
                   bool on = kind.value(settings);
                   if (toggle(ui, {option.label, modified}, on)) after = on ? "on" : "off";
                 },
                 [&](const ChoiceKind<S>& kind) { words_row(kind.words); },
                 [&](const SetKind<S>& kind) {
                   Words chosen = kind.value(settings);
                   if (chips(ui, kind.words, chosen)) after = moldlight::detail::value_text(chosen);
                 },
                 [&](const TextKind<S>& kind) { words_row(kind.words); }, [](const auto&) {},  // directions
             },
             option.kind);
  if (option_menu(ui, {option.label, option.help, before, standard})) after = standard;
  if (!after) return false;
  try {
    set_option(option, settings, *after);
  } catch (const UsageError& error) {
    if (row.refused) row.refused(error.what());
    return false;  // a value typed out of range
  }
  return option_text(option, settings) != before;
}

/// Rows of the options that have a narrow control, in as many columns as there is room for; `first` draws a
/// row before them.
template <typename S>
void option_table(const Ui& ui, std::span<const Option<S>> options, S& settings, const RowOptions& row,
                  const std::function<void()>& first = {}) {
  constexpr float k_column = 190.0F;  // layout units, at least
  const int columns = std::max(1, static_cast<int>(room_left() / ui.px(k_column)));
  if (!ImGui::BeginTable("options", columns,
                         ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings))
    return;
  if (first) {
    ImGui::TableNextColumn();
    first();
  }
  for (const Option<S>& option : options) {
    if (!has_control(option) || is_wide(option)) continue;
    ImGui::TableNextColumn();
    option_row(ui, option, settings, row);
  }
  ImGui::EndTable();
}

}  // namespace moldlight::gui
