// The two shadow maps, small and large, the controls of their method, and how far they are from exact.
#include <algorithm>
#include <string>

#include <fmt/format.h>

#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/bottom_panel.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"

namespace moldlight::gui {

namespace {

constexpr float k_picture = 60.0F;  // layout units
constexpr int k_large_px = 1024;

constexpr const char* caption(bool plus) { return plus ? "+d" : "−d"; }

/// The maps, and beside them in words what they are worth.
void draw_thumbnails(const PanelContext& context, const MapTextures& textures) {
  const Ui& ui = context.ui;
  const float gap = ui.px(8), size = ui.px(k_picture);
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
  for (const bool plus : {true, false}) {
    const Pressable map = pressable(ui, caption(plus), {size, size});
    const auto& [min, max] = map.box;
    ImDrawList& list = window_list();
    fill(list, map.box, field_colour(ui, {.hovered = map.hovered}), ui.px(6));
    draw_picture(list, plus ? textures.plus : textures.minus, map.box, ui.px(6));
    draw_tagged_text(ui, list,
                     {.lettering = ui.small(),
                      .at = {min.x + ui.px(8), max.y - ui.px(4) - ui.fonts.small.size},
                      .text = caption(plus)});
    tooltip(ui, plus ? "The map from +d" : "The map from −d",
            "Second depth: the surface that faces away from this side. Click to enlarge.");
    if (map.clicked) context.edits.dialogs.large_map = plus;
    ImGui::SameLine(0.0F, gap);
  }
  ImGui::BeginGroup();
  draw_map_comparison(context);
  ImGui::EndGroup();
}

/// What seldom needs a change stands in a list of its own.
void draw_accuracy(const PanelContext& context, const PartLengths& lengths) {
  const Ui& ui = context.ui;
  MethodSettings& method = context.edits.settings.method;
  if (disclosure(ui, "Accuracy", false)) open_popup_below_item(ui, "accuracy");
  name_item(ui, "Accuracy");
  if (!begin_popup(ui, "accuracy", ui.px(k_panel_width))) return;
  for (const std::string_view key : k_accuracy_options)
    option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths});
  end_popup(ui);
}

}  // namespace

void draw_map_comparison(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Figures& figures = context.state.figures;
  if (!maps_shown(context.state)) return;
  if (!figures.maps) {
    hint(ui, "shadow maps: compared with exact regions when the direction rests");
    return;
  }
  const MapComparison& maps = *figures.maps;
  hint(ui, comparison_text(maps));
  name_item(ui, "map comparison");
  const double error = 100.0 * share(maps.error, maps.total());
  tooltip(ui, "Shadow maps and exact regions",
          fmt::format("Share of the area that the shadow maps show in a wrong region, with this kernel, edge "
                      "thickness and resolution. {} samples: ± {:.2g} % of the area.",
                      grouped(std::to_string(maps.samples)), error));
}

void draw_maps_drawer(const PanelContext& context, const std::function<MapTextures(int)>& textures) {
  constexpr const char* k_name = "Shadow maps";
  constexpr float k_button = 72.0F, k_column = 250.0F;  // layout units
  const Ui& ui = context.ui;
  const float tab = text_size(ui.fonts.strong, k_name).x + ui.px(k_button);
  const bool open = context.layout.begin_bottom(ui, k_name, tab);
  BottomHeader header(ui, k_name);
  if (header.button({"fold maps", open ? Icon::chevron_down : Icon::chevron_up,
                     open ? "Close" : "Direction, tolerance, kernel and resolution of the shadow maps"}))
    context.layout.fold_bottom(k_name, open);
  const bool coupled = context.state.settings.method.couple_kernel;
  header.end(!open     ? ""
             : coupled ? "The lateral tolerance of the exact regions follows the kernel."
                       : "Kernel, edges and resolution change the maps alone, not the exact regions.",
             ui.colours->muted);
  const int columns = std::max(1, static_cast<int>(room_left() / ui.px(k_column)));
  if (open && ImGui::BeginTable("maps", columns,
                                ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings)) {
    LookSettings& look = context.edits.settings.look;
    MethodSettings& method = context.edits.settings.method;
    const PartLengths lengths(context.state);
    bool touched = false;
    const auto row = [&](std::string_view key) {
      ImGui::TableNextColumn();
      return option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths});
    };
    for (const std::string_view key : k_map_options) touched = row(key) || touched;
    // What a control of the maps does is to be seen.
    auto& divider = context.edits.divider;
    if (touched && !divider) look.regions_by = RegionsBy::maps;
    row("couple_kernel");
    // What the step's panel shows stands there alone.
    if (context.state.step != Step::part) row("tau_deg");
    ImGui::TableNextColumn();
    const Option<LookSettings>& mark = option_named(look_options(), "mark_difference");
    if (chip(ui, mark.label, look.mark_difference)) look.mark_difference = !look.mark_difference;
    tooltip(ui, mark.label, mark.help);
    if (chip(ui, "Split view", divider.has_value(), false)) {
      divider = divider ? std::nullopt : std::optional(0.5);
      look.mark_difference = divider.has_value();
      look.regions_by = RegionsBy::exact;
    }
    tooltip(
        ui, "Split view",
        "Regions of the shadow maps on the left, exact regions on the right. Drag the line between them.");
    if (context.state.step != Step::direction) {
      ImGui::TableNextColumn();
      draw_direction_fields(context);
    }
    ImGui::TableNextColumn();
    draw_thumbnails(context,
                    textures(context.state.dialogs.large_map ? k_large_px : static_cast<int>(ui.px(112))));
    draw_accuracy(context, lengths);
    ImGui::EndTable();
  }
  context.layout.end();
}

void draw_large_map(const PanelContext& context, const std::function<MapTextures(int)>& textures) {
  if (!context.state.dialogs.large_map) return;
  const Ui& ui = context.ui;
  const bool plus = *context.state.dialogs.large_map;
  const float side = std::floor(0.82F * std::min(screen_size().x, screen_size().y));
  if (begin_dialog(ui, "Large map", {side + ui.px(32), side + ui.px(72)})) {
    heading(ui, fmt::format("Shadow map from {}", caption(plus)));
    ImGui::SameLine();
    hint(ui, "Bright: near the light. Dark: far from it. Click or press Esc to close.");
    const glm::vec2 min = cursor_at();
    const MapTextures maps = textures(k_large_px);
    draw_picture(window_list(), plus ? maps.plus : maps.minus, {min, min + side}, ui.px(6));
    if (pressable(ui, "close", {side, side}).clicked) context.edits.dialogs.large_map.reset();
  }
  if (end_dialog(ui)) context.edits.dialogs.large_map.reset();
}

}  // namespace moldlight::gui
