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
    if (disclosure(ui, "Accuracy", false)) open_popup_below_item(ui, "accuracy");
    if (begin_popup(ui, "accuracy", ui.px(k_panel_width))) {
      for (const std::string_view key : k_accuracy_options)
        option_row(ui, option_named(method_options(), key), method);
      end_popup(ui);
    }
  }
  context.layout.end();
}

}  // namespace moldlight::gui
