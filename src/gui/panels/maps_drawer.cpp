// The drawer of the shadow maps: the maps, small and large, the controls of their method, and how far they
// are from exact.
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

constexpr float k_picture = 84.0F, k_column = 236.0F;  // layout units: a map; a column of controls, at least
constexpr float k_room_for_pictures = 640.0F;

constexpr const char* caption(bool plus) { return plus ? "+d" : "−d"; }

void draw_thumbnails(const PanelContext& context, const MapTextures& textures) {
  const Ui& ui = context.ui;
  const float gap = ui.px(8), size = ui.px(k_picture);
  for (const bool plus : {true, false}) {
    const Pressable map = pressable(ui, caption(plus), {size, size});
    const auto& [min, max] = map.box;
    ImDrawList& list = *ImGui::GetWindowDrawList();
    fill(list, map.box, field_colour(ui, {.hovered = map.hovered}), ui.px(6));
    draw_picture(list, plus ? textures.plus : textures.minus, map.box, ui.px(6));
    draw_tagged_text(ui, list,
                     {.lettering = {ui.fonts.small, ui.colours->text},
                      .at = {min.x + ui.px(8), max.y - ui.px(4) - ui.fonts.small.size},
                      .text = caption(plus)});
    tooltip(ui, plus ? "The map from +d" : "The map from −d",
            "Second depth: the surface that faces away from this side. Click to enlarge.");
    if (map.clicked) context.edits.dialogs.large_map = plus;
    ImGui::SameLine(0.0F, gap);
  }
}

/// What seldom needs a change stands in a list of its own.
void draw_accuracy(const PanelContext& context, const PartLengths& lengths) {
  const Ui& ui = context.ui;
  MethodSettings& method = context.edits.settings.method;
  if (disclosure(ui, "Accuracy", false)) open_popup_below_item(ui, "accuracy");
  if (!begin_popup(ui, "accuracy", ui.px(k_panel_width))) return;
  for (const std::string_view key : k_accuracy_options)
    option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths});
  end_popup(ui);
}

}  // namespace

void draw_map_comparison(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Figures& figures = context.state.figures;
  if (context.state.settings.look.regions_by != RegionsBy::maps) return;
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

namespace {

/// Whether the lateral tolerance of exact regions follows the kernel of the maps.
bool is_coupled(const MethodSettings& method) { return method.kernel > 0 && method.tolerance <= 0.0; }

void draw_direction_sliders(const PanelContext& context) {
  const Ui& ui = context.ui;
  Angles angles = angles_of(context.edits.settings.direction.unit());
  const auto text = [](double value) { return with_minus(fmt::format("{:.1f}°", value)); };
  ImGui::TableNextColumn();
  bool turned =
      slider(ui, {"Azimuth"}, angles.azimuth_deg, {.min = -180.0, .max = 180.0, .step = 0.5, .text = text});
  bool held = ImGui::IsItemActive();
  ImGui::TableNextColumn();
  turned = slider(ui, {"Elevation"}, angles.elevation_deg,
                  {.min = -90.0, .max = 90.0, .step = 0.5, .text = text}) ||
           turned;
  held = held || ImGui::IsItemActive();
  if (turned) context.edits.settings.direction = direction_of(angles);
  if (held) context.edits.dragging = true;
}

/// The kernel, and the maps' resolution, do nothing to the lateral tolerance unless they are coupled.
void draw_tolerance(const PanelContext& context, const PartLengths& lengths, const MethodSettings& before) {
  const Ui& ui = context.ui;
  MethodSettings& method = context.edits.settings.method;
  const double former = lateral_tolerance(before, lengths.diagonal);
  const double standard = lateral_tolerance({}, lengths.diagonal);
  bool coupled = is_coupled(before);
  ImGui::TableNextColumn();
  ImGui::BeginDisabled(coupled);
  option_row(ui, option_named(method_options(), "tolerance"), method,
             {.lengths = &lengths, .unset = fmt::format("{:.3g}", former)});
  ImGui::EndDisabled();
  if (!coupled && is_coupled(method)) method.tolerance = before.tolerance > 0.0 ? standard : former;
  ImGui::TableNextColumn();
  if (toggle(ui, {"Couple δ to the kernel"}, coupled)) {
    if (method.kernel == 0) method.kernel = 3;
    method.tolerance = coupled ? 0.0 : former;
  }
  tooltip(ui, "Couple δ to the kernel",
          "Off: kernel and resolution change the shadow maps alone. On: the kernel's radius is the lateral "
          "tolerance of the exact regions, too.");
}

void draw_map_controls(const PanelContext& context) {
  const Ui& ui = context.ui;
  LookSettings& look = context.edits.settings.look;
  MethodSettings& method = context.edits.settings.method;
  const MethodSettings before = method;
  const PartLengths lengths(context.state);
  const int columns = std::max(1, static_cast<int>(ImGui::GetContentRegionAvail().x / ui.px(k_column)));
  if (!ImGui::BeginTable("map controls", columns,
                         ImGuiTableFlags_SizingStretchSame | ImGuiTableFlags_NoSavedSettings))
    return;
  bool touched = false;
  draw_direction_sliders(context);
  ImGui::TableNextColumn();
  option_row(ui, option_named(method_options(), "tau_deg"), method);
  for (const std::string_view key : k_map_options) {
    ImGui::TableNextColumn();
    touched = option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths}) || touched;
  }
  // What a control of the maps does is to be seen.
  if (touched) look.regions_by = RegionsBy::maps;
  draw_tolerance(context, lengths, before);
  for (const std::string_view key : k_map_look_options) {
    ImGui::TableNextColumn();
    option_row(ui, option_named(look_options(), key), look);
  }
  ImGui::TableNextColumn();
  draw_accuracy(context, lengths);
  ImGui::EndTable();
}

}  // namespace

void draw_maps_drawer(const PanelContext& context, const MapTextures& textures) {
  const Ui& ui = context.ui;
  context.layout.begin_bottom(ui, "Shadow maps");
  BottomHeader header(ui, "Shadow maps");
  if (header.button({"close drawer", Icon::close, "Close (Esc)"})) context.edits.drawer = Drawer::none;
  header.end("", ui.colours->muted);
  if (ImGui::GetContentRegionAvail().x > ui.px(k_room_for_pictures)) draw_thumbnails(context, textures);
  ImGui::BeginGroup();
  draw_map_controls(context);
  draw_map_comparison(context);
  ImGui::EndGroup();
  context.layout.end();
}

void draw_large_map(const PanelContext& context, const MapTextures& textures) {
  if (!context.state.dialogs.large_map) return;
  const Ui& ui = context.ui;
  const bool plus = *context.state.dialogs.large_map;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  const float side = std::floor(0.82F * std::min(window.x, window.y));
  if (begin_dialog(ui, "Large map", {side + ui.px(32), side + ui.px(72)})) {
    heading(ui, fmt::format("Shadow map from {}", caption(plus)));
    ImGui::SameLine();
    hint(ui, "Bright: near the light. Dark: far from it. Click or press Esc to close.");
    const glm::vec2 min = from_im(ImGui::GetCursorScreenPos());
    draw_picture(*ImGui::GetWindowDrawList(), plus ? textures.plus : textures.minus, {min, min + side},
                 ui.px(6));
    if (pressable(ui, "close", {side, side}).clicked) context.edits.dialogs.large_map.reset();
  }
  if (end_dialog(ui)) context.edits.dialogs.large_map.reset();
}

}  // namespace moldlight::gui
