#include "gui/panels/option_row.hpp"

#include "classify/number_format.hpp"

namespace moldlight::gui {

PartLengths::PartLengths(const AppState& state)
    : diagonal(state.model->frame.diagonal),
      texel(diagonal / state.settings.method.resolution),
      unit(length_unit(state.model->part)) {}

std::string PartLengths::text(double length) const {
  return fmt::format("{} {}", grouped(fmt::format("{:.2g}", length)), unit);
}

std::string value_text(const ShownValue& shown, const PartLengths* lengths) {
  const std::string number = grouped(fmt::format("{:.{}f}", shown.value, shown.decimals));
  if (shown.unit == "deg") return number + "°";
  if (shown.unit.empty()) return number;
  if (shown.unit == k_share) return fmt::format("{:.0f} %", 100.0 * shown.value);
  if (lengths == nullptr) return fmt::format("{} {}", number, shown.unit);
  if (shown.unit == k_half_diagonal)
    return fmt::format("{} {}", grouped(fmt::format("{:.1f}", 0.5 * lengths->diagonal * shown.value)),
                       lengths->unit);
  if (shown.unit == k_texels_across)
    return fmt::format("{} × {}", number, lengths->text(lengths->diagonal / shown.value));
  return fmt::format("{} {} · {}", number, shown.unit, lengths->text(shown.value * lengths->texel));
}

std::string number_label(std::string_view label, std::string_view unit) {
  if (unit.empty()) return std::string(label);
  return fmt::format("{}{} {}", label, unit == "deg" ? "" : ",", unit == "deg" ? "°" : unit);
}

namespace {

double nearest_on_log_scale(double value, double base, std::initializer_list<double> mantissas) {
  const double scale = std::pow(base, std::floor(std::log(value) / std::log(base)));
  double best = scale;
  for (const double mantissa : mantissas) {
    if (std::abs(std::log(mantissa * scale / value)) < std::abs(std::log(best / value)))
      best = mantissa * scale;
  }
  return best;
}

}  // namespace

double near_power_of_two(double value) {
  return std::round(nearest_on_log_scale(value, 2.0, {1.0, 1.5, 2.0}));
}

double near_round_number(double value) {
  return std::round(nearest_on_log_scale(value, 10.0, {1.0, 2.0, 5.0, 10.0}));
}

bool option_menu(const Ui& ui, const OptionTexts& option) {
  const std::string standard = option.default_value.empty() ? "none" : option.default_value;
  tooltip(ui, option.label, fmt::format("{}\nDefault: {}. Right click for more.", option.help, standard));
  const std::string id = fmt::format("menu {}", option.label);
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) open_popup_at_mouse(ui, id.c_str());
  if (!begin_popup(ui, id.c_str())) return false;
  const bool reset =
      menu_item(ui, fmt::format("Reset to {}", standard), {.enabled = option.value != option.default_value});
  if (menu_item(ui, "Copy the value")) ImGui::SetClipboardText(option.value.c_str());
  end_popup(ui);
  return reset;
}

}  // namespace moldlight::gui
