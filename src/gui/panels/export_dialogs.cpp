// What is written from the window: the dialogs for what `classify` and `mold` write, and for a picture, and
// the panel of the report.
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include <fmt/format.h>

#include "base/numbers.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/workspace.hpp"
#include "io/film.hpp"
#include "io/mesh_writer.hpp"
#include "parting/line_files.hpp"
#include "parting/mold_report.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

std::string beside_part(const AppState& state, const char* ending) {
  const fs::path part(state.path);
  return (part.parent_path() / (part.stem().string() + ending)).string();
}

bool PathDialog::draw(const Ui& ui, const Form& form, const std::function<Ready()>& draw_rows, bool& open) {
  bool confirmed = false, left = false;
  if (proposed_ != form.proposed) {
    proposed_ = form.proposed;
    std::snprintf(path_.data(), path_.size(), "%s", proposed_.c_str());
  }
  if (begin_dialog(ui, form.name, {ui.px(480), 0.0F})) {
    heading(ui, form.title != nullptr ? form.title : form.name);
    hint(ui, form.prompt);
    text_field(ui, fmt::format("##{} path", form.name).c_str(), path_);
    const Ready ready = draw_rows();
    ImGui::Dummy(ImVec2(1, ui.px(4)));
    if (!ready.wait.empty()) hint(ui, ready.wait);
    ImGui::BeginDisabled(!ready.now || path_[0] == 0);
    confirmed = button(ui, form.action, {.width = ui.px(112), .strong = true});
    ImGui::EndDisabled();
    ImGui::SameLine();
    left = button(ui, "Cancel", {.width = ui.px(96)});
  }
  left = end_dialog(ui) || left;
  if (confirmed || left) open = false;
  return confirmed;
}

void ExportDialog::draw(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.dialogs.exporting || !state.model) return;
  const Ui& ui = context.ui;
  const auto rows = [&]() -> PathDialog::Ready {
    toggle(ui, {"Result as JSON"}, json_);
    toggle(ui, {"Table of facets (CSV)"}, facets_);
    if (!state.model->part.facet_source.empty()) toggle(ui, {"Table of the file's faces (CSV)"}, faces_);
    toggle(ui, {"Mesh with coloured regions"}, mesh_);
    std::vector<std::string_view> extensions;
    for (const auto& format : mesh_formats()) extensions.push_back(format.extension);
    if (mesh_) choice(ui, {"Format of the mesh"}, extensions, mesh_format_);
    toggle(ui, {"One STL a region, in a folder"}, split_);
    toggle(ui, {"Lines between regions (OBJ)"}, borders_);
    toggle(ui, {"Picture with legend"}, picture_);
    const bool measuring = state.figures.measuring;
    return {.now = !measuring && state.figures.shown.has_value(),
            .wait = measuring ? "Measuring. The files can be written when it is done." : ""};
  };
  const PathDialog::Form form{.name = "Export",
                              .prompt = "Files are named after this path:",
                              .action = "Export",
                              .proposed = beside_part(state, "-regions")};
  if (!dialog_.draw(ui, form, rows, context.edits.dialogs.exporting)) return;
  const std::string base = dialog_.path();
  OutputPaths files;
  if (json_) files.json = base + ".json";
  if (facets_) files.facets = base + ".csv";
  if (faces_) files.faces = base + "-faces.csv";
  if (mesh_)
    files.mesh = base + "." + std::string(mesh_formats()[static_cast<std::size_t>(mesh_format_)].extension);
  if (split_) files.split_folder = base;
  if (borders_) files.borders = base + "-borders.obj";
  context.edits.ask(&Commands::export_files, files, picture_ ? base + ".png" : std::string());
}

void MoldExportDialog::draw(const PanelContext& context) {
  const AppState& state = context.state;
  if (!state.dialogs.exporting_mold || !state.model) return;
  const Ui& ui = context.ui;
  bool solids = false;
  const auto rows = [&]() -> PathDialog::Ready {
    const bool ready = is_settled(state.mold);
    const std::string refusal = ready ? halves_refusal(state) : std::string();
    ImGui::BeginDisabled(!refusal.empty());
    toggle(ui, {"Halves and inserts (STL each)"}, solids_);
    toggle(ui, {"All of them in one 3MF"}, together_.as_3mf);
    toggle(ui, {"All of them in one STEP"}, together_.as_step);
    ImGui::EndDisabled();
    if (!refusal.empty()) hint(ui, refusal);
    hint(ui, "Parting line:");
    std::vector<std::string_view> extensions;
    for (const auto& format : line_formats()) extensions.push_back(format.extension);
    if (first_) lines_ = {extensions.front()};
    first_ = false;
    chips(ui, extensions, lines_);
    toggle(ui, {"Report as JSON"}, json_);
    solids = solids_ && refusal.empty();
    const std::string& error = state.mold.error;
    return {.now = ready && (solids || json_ || !lines_.empty()),
            .wait = ready           ? ""
                    : error.empty() ? "The halves are being made. They can be written when they are done."
                                    : error};
  };
  const PathDialog::Form form{.name = "Export the mold",
                              .prompt = "Into this folder:",
                              .action = "Export",
                              .proposed = beside_part(state, "-mold")};
  if (!dialog_.draw(ui, form, rows, context.edits.dialogs.exporting_mold)) return;
  const fs::path folder = dialog_.path();
  MoldPaths paths{.folder = solids ? folder.string() : std::string(),
                  .solids = together_,
                  .json = json_ ? (folder / "mold.json").string() : std::string(),
                  .lines = {}};
  for (const std::string_view extension : lines_)
    paths.lines.push_back((folder / ("parting-line." + std::string(extension))).string());
  context.edits.ask(&Commands::export_mold, paths);
}

void draw_picture_dialog(const PanelContext& context, PathDialog& dialog) {
  const auto& asked = context.state.dialogs.picture;
  if (!asked) return dialog.forget();
  const auto rows = [&]() -> PathDialog::Ready {
    std::error_code ignored;
    const bool taken = fs::exists(dialog.path(), ignored);
    if (taken) hint(context.ui, "There is a file of this name.");
    return {.now = !taken, .wait = {}};
  };
  const PathDialog::Form form{.name = "Picture",
                              .title = "Save a picture",
                              .prompt = "Later pictures of this session are numbered.",
                              .action = "Save",
                              .proposed = *asked};
  bool open = true;
  if (dialog.draw(context.ui, form, rows, open)) context.edits.ask(&Commands::save_picture, dialog.path());
  if (!open) context.edits.dialogs.picture.reset();
}

void draw_finishes_dialog(const PanelContext& context, PathDialog& dialog) {
  const auto& saves = context.state.dialogs.finishes;
  if (!saves || !context.state.model) return;
  const PathDialog::Form form{.name = "Finishes",
                              .title = *saves ? "Save the finishes" : "Load the finishes",
                              .prompt = *saves ? "A file of this name is replaced." : "From this file:",
                              .action = *saves ? "Save" : "Load",
                              .proposed = beside_part(context.state, "-finishes.csv")};
  bool open = true;
  const auto ready = [] { return PathDialog::Ready{}; };
  if (dialog.draw(context.ui, form, ready, open))
    context.edits.ask(*saves ? &Commands::save_finishes : &Commands::load_finishes, dialog.path());
  if (!open) context.edits.dialogs.finishes.reset();
}

void draw_film_dialog(const PanelContext& context, PathDialog& dialog) {
  auto& format = context.edits.dialogs.film;
  if (!format || !context.state.model) return dialog.forget();
  constexpr std::array<std::string_view, 2> k_formats = {"gif", "mp4"};
  const auto rows = [&]() -> PathDialog::Ready {
    if (has_ffmpeg())
      choice(context.ui, {"Format"}, k_formats, *format);
    else
      hint(context.ui, "With ffmpeg installed an MP4 can be made, too.");
    return {};
  };
  const PathDialog::Form form{.name = "Film",
                              .title = "Film of the presentation",
                              .prompt = "It is shown while it is made. A file of this name is replaced.",
                              .action = "Make it",
                              .proposed = beside_part(context.state, *format == 1 ? ".mp4" : ".gif")};
  bool open = true;
  if (dialog.draw(context.ui, form, rows, open)) context.edits.ask(&Commands::film, dialog.path());
  if (!open) format.reset();
}

void ReportPanel::draw(const PanelContext& context) {
  const Ui& ui = context.ui;
  const float width = ImGui::GetContentRegionAvail().x;
  draw_report(context, width);
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  heading(ui, "Files");
  if (button(ui, "Picture with legend… (F12)", {.width = width})) context.edits.ask(&Commands::take_picture);
  name_item(ui, "picture");
  if (button(ui, "Regions and figures… (Ctrl+E)", {.width = width})) context.edits.dialogs.exporting = true;
  name_item(ui, "export");
  if (button(ui, "Mold and parting line…", {.width = width})) context.edits.dialogs.exporting_mold = true;
  ImGui::Dummy(ImVec2(1.0F, ui.px(4)));
  heading(ui, "Presentation");
  const float half = std::floor(0.5F * (width - ui.px(4)));
  if (button(ui, "Present (F5)", {.width = half})) context.edits.ask(&Commands::present);
  name_item(ui, "present");
  ImGui::SameLine(0.0F, ui.px(4));
  if (button(ui, "Film…", {.width = half})) context.edits.dialogs.film = 0;
  name_item(ui, "film");
}

void ReportPanel::draw_report(const PanelContext& context, float width) {
  const Ui& ui = context.ui;
  const AppState& state = context.state;
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
  const std::size_t views = state.views.size();
  if (chip(ui, "Add this view", false)) context.edits.ask(&Commands::keep_view);
  tooltip(ui, "Add this view", "The report begins with the views that you add, as the part is seen now.");
  if (views > 0 && chip(ui, fmt::format("{}  ×", plural(views, "view")), true, false))
    context.edits.ask(&Commands::forget_views);
  if (views > 0) name_item(ui, "views");
  hint(ui, "Beside the part, or a path:");
  const std::string beside = fs::path(beside_part(state, "-report")).filename().string();
  if (proposed_ != beside) std::snprintf(path_.data(), path_.size(), "%s", beside.c_str());
  proposed_ = beside;
  text_field(ui, "##Report path", path_);
  if (state.exporting) {
    hint(ui, state.exporting->stage);
    progress_bar(ui, state.exporting->fraction, width);
    if (button(ui, "Cancel", {.width = width})) context.edits.ask(&Commands::cancel_export);
    return;
  }
  const bool lacks_sweep = chosen.command == "sweep" && !state.sweep.result;
  if (lacks_sweep) hint(ui, "No directions were searched. Do this in the step Direction.");
  ImGui::BeginDisabled(lacks_sweep || path_[0] == 0 || !(order_.html || order_.pdf) || !state.figures.split);
  if (button(ui, "Write the report", {.width = width, .strong = true})) {
    order_.path = (fs::path(state.path).parent_path() / path_.data()).string();
    order_.views = state.views;
    context.edits.ask(&Commands::export_report, order_);
  }
  ImGui::EndDisabled();
}

}  // namespace moldlight::gui
