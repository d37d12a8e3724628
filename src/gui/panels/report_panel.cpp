// The report: what is written of the part, from here and by the command line.
#include <fmt/format.h>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

/// For a shell: what makes the report of this part and direction.
std::string report_command(const AppState& state) {
  std::string path;
  for (const char letter : state.path) path += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  const std::string& unit = state.model->part.unit;
  const glm::dvec3& d = state.settings.direction.given();
  return fmt::format("moldlight mold '{}'{} --direction={},{},{} --html report.html --pdf report.pdf", path,
                     unit.empty() ? "" : " --unit " + unit, d.x, d.y, d.z);
}

}  // namespace

void draw_report_controls(const PanelContext& context) {
  const Ui& ui = context.ui;
  const float width = ImGui::GetContentRegionAvail().x;
  hint(ui, verdict_card(context.state).sentence);
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  if (button(ui, "Picture with legend (F12)", {.width = width})) context.edits.ask(&Commands::take_picture);
  name_item(ui, "picture");
  if (button(ui, "Regions and figures… (Ctrl+E)", {.width = width})) context.edits.dialogs.exporting = true;
  name_item(ui, "export");
  if (button(ui, "Mold and parting line…", {.width = width})) context.edits.dialogs.exporting_mold = true;
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  hint(ui, "The report for a browser (HTML) and for paper (PDF) is made by this command, in a terminal:");
  const std::string command = report_command(context.state);
  hint(ui, command);
  if (button(ui, "Copy the command", {.width = width})) {
    ImGui::SetClipboardText(command.c_str());
    context.edits.ask(&Commands::say, std::string("The command is in the clipboard"), false);
  }
}

}  // namespace moldlight::gui
