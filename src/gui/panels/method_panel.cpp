// The method's settings, straight from the option table.
#include <algorithm>
#include <array>

#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "session/method_options.hpp"

namespace moldlight::gui {

namespace {

// The rows under "More"; the direction has a panel of its own.
constexpr std::array<std::string_view, 4> k_rare = {"tolerance", "readout", "samples", "backend"};

bool is_rare(const Option<MethodSettings>& option) {
  return std::find(k_rare.begin(), k_rare.end(), option.key) != k_rare.end();
}

}  // namespace

void draw_method_panel(const PanelContext& context, bool& more) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Method")) {
    const auto draw_rows = [&](bool rare) {
      for (const Option<MethodSettings>& option : method_options()) {
        if (option.key == "direction" || is_rare(option) != rare) continue;
        option_row(ui, option, context.edits.settings.method);
      }
    };
    draw_rows(false);
    if (more) draw_rows(true);
    if (disclosure(ui, more ? "Less" : "More", more)) more = !more;
  }
  context.layout.end();
}

}  // namespace moldlight::gui
