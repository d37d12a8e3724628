#include "gui/panels/option_row.hpp"

namespace moldlight::gui {

std::string value_text(double value, int decimals, std::string_view unit) {
  const std::string number = grouped(fmt::format("{:.{}f}", value, decimals));
  if (unit == "deg") return number + "°";
  if (unit.empty()) return number;
  return fmt::format("{} {}", number, unit);
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
      menu_item(ui, fmt::format("Reset to {}", standard), option.value != option.default_value);
  if (menu_item(ui, "Copy the value")) ImGui::SetClipboardText(option.value.c_str());
  end_popup(ui);
  return reset;
}

}  // namespace moldlight::gui
