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

bool option_menu(const Ui& ui, std::string_view label, std::string_view help, const std::string& value,
                 const std::string& default_value, bool modified) {
  tooltip(ui, label,
          fmt::format("{}\nDefault: {}. Right click for more.", help,
                      default_value.empty() ? "none" : default_value));
  const std::string id = fmt::format("menu {}", label);
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) ImGui::OpenPopup(id.c_str());
  if (!ImGui::BeginPopup(id.c_str())) return false;
  const std::string reset_text =
      fmt::format("Reset to {}", default_value.empty() ? std::string("none") : default_value);
  const bool reset = ImGui::MenuItem(reset_text.c_str(), nullptr, false, modified);
  if (ImGui::MenuItem("Copy the value")) ImGui::SetClipboardText(value.c_str());
  ImGui::EndPopup();
  return reset;
}

}  // namespace moldlight::gui
