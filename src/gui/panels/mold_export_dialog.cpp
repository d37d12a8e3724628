// The dialog that writes what `mold` writes.
#include <cstdio>
#include <filesystem>

#include "gui/draw/widgets.hpp"
#include "gui/panels/mold_panel.hpp"
#include "gui/panels/workspace.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_report.hpp"

namespace moldlight::gui {

namespace {

/// Why the halves are not written; empty where they are.
std::string refusal_of(const AppState& state) {
  if (std::string refusal = halves_refusal(state); !refusal.empty()) return refusal;
  const std::string unfilled = unfilled_text(*state.model, state.settings.mold, state.mold.solids->halves);
  return unfilled.empty() ? unfilled : "No halves: " + unfilled + "; Fill undercuts leaves them to inserts.";
}

}  // namespace

void MoldExportDialog::draw(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.dialogs.exporting_mold || !state.model) return;
  if (of_ != state.path) {
    of_ = state.path;
    const std::filesystem::path part(of_);
    std::snprintf(folder_.data(), folder_.size(), "%s",
                  (part.parent_path() / (part.stem().string() + "-mold")).string().c_str());
  }
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Export the mold", {ui.px(480), 0.0F})) {
    heading(ui, "Export the mold");
    hint(ui, "Into this folder:");
    text_field(ui, "##Mold folder", folder_);
    const bool ready = is_settled(state.mold);
    const std::string refusal = ready ? refusal_of(state) : std::string();
    ImGui::BeginDisabled(!refusal.empty());
    toggle(ui, {"Halves and inserts (STL each)"}, solids_);
    toggle(ui, {"All of them in one 3MF"}, as_3mf_);
    ImGui::EndDisabled();
    if (!refusal.empty()) hint(ui, refusal);
    bool& fill = context.edits.settings.mold.fill_undercut;
    if (!refusal.empty() && state.mold.solids->halves.made()) toggle(ui, {"Fill undercuts"}, fill);
    hint(ui, "Parting line:");
    std::vector<std::string_view> extensions;
    for (const auto& format : line_formats()) extensions.push_back(format.extension);
    if (first_) lines_ = {extensions.front()};
    first_ = false;
    chips(ui, extensions, lines_);
    toggle(ui, {"Report as JSON"}, json_);
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (!ready)
      hint(ui, state.mold.error.empty() ? "Being made; they can be written then." : state.mold.error);
    const bool solids = solids_ && refusal.empty();
    ImGui::BeginDisabled(!ready || folder_[0] == 0 || !(solids || json_ || !lines_.empty()));
    if (button(ui, "Export", {.width = ui.px(112), .strong = true})) {
      const std::filesystem::path folder(folder_.data());
      MoldPaths paths{.folder = solids ? folder.string() : std::string(),
                      .as_3mf = as_3mf_,
                      .json = json_ ? (folder / "mold.json").string() : std::string(),
                      .lines = {}};
      for (const std::string_view extension : lines_)
        paths.lines.push_back((folder / ("parting-line." + std::string(extension))).string());
      context.edits.ask(&Commands::export_mold, paths);
      context.edits.dialogs.exporting_mold = false;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(ui, "Cancel", {.width = ui.px(96)})) context.edits.dialogs.exporting_mold = false;
  }
  if (end_dialog(ui)) context.edits.dialogs.exporting_mold = false;
}

}  // namespace moldlight::gui
