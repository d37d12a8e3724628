// The method's settings, straight from the option table; those of the shadow maps have a panel of their own.
#include "classify/method_options.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

void draw_method_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Method")) {
    MethodSettings& method = context.edits.settings.method;
    for (const Option<MethodSettings>& option : method_options()) {
      if (is_among(k_map_options, option) || is_among(k_accuracy_options, option)) continue;
      option_row(ui, option, method);
    }
    if (disclosure(ui, "Accuracy", false)) ImGui::OpenPopup("accuracy");
    const ImVec2 corner(ImGui::GetItemRectMin().x, ImGui::GetItemRectMax().y + ui.px(4));
    const float width = ui.px(k_panel_width);
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSizeConstraints(ImVec2(width, 0.0F), ImVec2(width, 4.0F * width));
    if (ImGui::BeginPopup("accuracy")) {
      for (const std::string_view key : k_accuracy_options)
        option_row(ui, option_named(method_options(), key), method);
      ImGui::EndPopup();
    }
  }
  context.layout.end();
}

}  // namespace moldlight::gui
