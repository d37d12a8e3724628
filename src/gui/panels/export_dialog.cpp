// The dialogs that write what `classify` writes, and a picture.
#include <cstdio>
#include <filesystem>

#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"
#include "io/mesh_writer.hpp"

namespace moldlight::gui {

void ExportDialog::ask_for_files(Edits& edits) const {
  const std::string base(base_.data());
  OutputPaths files;
  if (json_) files.json = base + ".json";
  if (facets_) files.facets = base + ".csv";
  if (faces_) files.faces = base + "-faces.csv";
  if (mesh_)
    files.mesh = base + "." + std::string(mesh_formats()[static_cast<std::size_t>(mesh_format_)].extension);
  if (split_) files.split_folder = base;
  if (borders_) files.borders = base + "-borders.obj";
  edits.ask(&Commands::export_files, files, picture_ ? base + ".png" : std::string());
}

void ExportDialog::draw(const PanelContext& context) {
  if (!context.state.dialogs.exporting || !context.state.model) return;
  if (of_ != context.state.path) {
    of_ = context.state.path;
    const std::filesystem::path part(of_);
    std::snprintf(base_.data(), base_.size(), "%s",
                  (part.parent_path() / (part.stem().string() + "-regions")).string().c_str());
  }
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Export", {ui.px(480), 0.0F})) {
    heading(ui, "Export");
    hint(ui, "Files are named after this path:");
    text_field(ui, "##Export path", base_);
    toggle(ui, {"Result as JSON"}, json_);
    toggle(ui, {"Table of facets (CSV)"}, facets_);
    if (!context.state.model->part.facet_source.empty()) {
      toggle(ui, {"Table of the file's faces (CSV)"}, faces_);
    }
    toggle(ui, {"Mesh with coloured regions"}, mesh_);
    std::vector<std::string_view> extensions;
    for (const auto& format : mesh_formats()) extensions.push_back(format.extension);
    if (mesh_) choice(ui, {"Format of the mesh"}, extensions, mesh_format_);
    toggle(ui, {"One STL a region, in a folder"}, split_);
    toggle(ui, {"Lines between regions (OBJ)"}, borders_);
    toggle(ui, {"Picture with legend"}, picture_);
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (context.state.figures.measuring) hint(ui, "Measuring; the files can be written when it is done.");
    ImGui::BeginDisabled(context.state.figures.measuring || !context.state.figures.shown || base_[0] == 0);
    if (button(ui, "Export", {.width = ui.px(112), .strong = true})) {
      ask_for_files(context.edits);
      context.edits.dialogs.exporting = false;
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(ui, "Cancel", {.width = ui.px(96)})) context.edits.dialogs.exporting = false;
  }
  if (end_dialog(ui)) context.edits.dialogs.exporting = false;
}

void PictureDialog::draw(const PanelContext& context) {
  const auto& asked = context.state.dialogs.picture;
  if (!asked) return proposed_.clear();
  if (proposed_ != *asked) {
    proposed_ = *asked;
    std::snprintf(path_.data(), path_.size(), "%s", proposed_.c_str());
  }
  const Ui& ui = context.ui;
  if (begin_dialog(ui, "Picture", {ui.px(480), 0.0F})) {
    heading(ui, "Save a picture");
    hint(ui, "Later ones of this session go beside it, numbered.");
    text_field(ui, "##Picture path", path_);
    std::error_code ignored;
    const bool taken = std::filesystem::exists(path_.data(), ignored);
    if (taken) hint(ui, "There is a file of this name.");
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    ImGui::BeginDisabled(taken || path_[0] == 0);
    if (button(ui, "Save", {.width = ui.px(112), .strong = true})) {
      context.edits.ask(&Commands::save_picture, std::string(path_.data()));
      context.edits.dialogs.picture.reset();
    }
    ImGui::EndDisabled();
    ImGui::SameLine();
    if (button(ui, "Cancel", {.width = ui.px(96)})) context.edits.dialogs.picture.reset();
  }
  if (end_dialog(ui)) context.edits.dialogs.picture.reset();
}

}  // namespace moldlight::gui
