// The report: what is written of the part.
#include <cstdio>

#include "gui/draw/widgets.hpp"
#include "gui/panels/step_panels.hpp"

namespace moldlight::gui {

void ReportPanel::draw(const PanelContext& context) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
  const float width = ImGui::GetContentRegionAvail().x;
  hint(ui, verdict_card(state).sentence);
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  if (button(ui, "Picture with legend (F12)", {.width = width})) context.edits.ask(&Commands::take_picture);
  name_item(ui, "picture");
  if (button(ui, "Regions and figures… (Ctrl+E)", {.width = width})) context.edits.dialogs.exporting = true;
  name_item(ui, "export");
  if (button(ui, "Mold and parting line…", {.width = width})) context.edits.dialogs.exporting_mold = true;
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  heading(ui, "Report");
  if (state.exporting) {
    hint(ui, state.exporting->stage);
    progress_bar(ui, state.exporting->fraction, width);
    if (button(ui, "Cancel", {.width = width})) context.edits.ask(&Commands::cancel_export);
    return;
  }
  std::vector<std::string_view> subjects;
  for (const report::PartReport& each : report::part_reports()) subjects.push_back(each.subject);
  choice(ui, {"Report of"}, subjects, order_.of);
  const report::PartReport& chosen = report::part_reports()[static_cast<std::size_t>(order_.of)];
  toggle(ui, {"Page for a browser (HTML)"}, order_.html);
  ImGui::BeginDisabled(!order_.html || !chosen.lives);
  toggle(ui, {"Live page"}, order_.live);
  tooltip(ui, "Live page", "The reader can turn the direction; the regions follow.");
  ImGui::EndDisabled();
  toggle(ui, {"Pages of paper (PDF)"}, order_.pdf);
  hint(ui, "Files are named after this path:");
  const std::string beside = beside_part(state, "-report");
  if (proposed_ != beside) std::snprintf(path_.data(), path_.size(), "%s", beside.c_str());
  proposed_ = beside;
  text_field(ui, "##Report path", path_);
  const bool lacks_sweep = chosen.command == "sweep" && !state.sweep.result;
  if (lacks_sweep) hint(ui, "No directions were searched. Do this in the step Direction.");
  ImGui::BeginDisabled(lacks_sweep || path_[0] == 0 || !(order_.html || order_.pdf) || !state.figures.split);
  if (button(ui, "Write the report", {.width = width, .strong = true})) {
    order_.path = path_.data();
    context.edits.ask(&Commands::export_report, order_);
  }
  ImGui::EndDisabled();
}

}  // namespace moldlight::gui
