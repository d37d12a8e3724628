// The two shadow maps, small and large, the controls of their method, and how far they are from exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "classify/method_options.hpp"
#include "classify/number_format.hpp"
#include "gui/draw/bottom_panel.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "gui/view/side_actions.hpp"
#include "render/view_settings.hpp"

namespace moldlight::gui {

namespace {

/// Switches that only add or remove something in the picture are chips.
void draw_chips(const Ui& ui, LookSettings& look) {
  bool first = true;
  for (const Option<LookSettings>& option : look_options()) {
    const auto* kind = std::get_if<SwitchKind<LookSettings>>(&option.kind);
    if (kind == nullptr || is_among(k_map_look_options, option)) continue;
    bool& on = look.*(kind->member);
    if (chip(ui, option.label, on, std::exchange(first, false))) on = !on;
    tooltip(ui, option.label, option.help);
  }
}

/// The colours of the draft angles, each between two of the limits that stand below.
void draw_draft_key(const PanelContext& context) {
  const Ui& ui = context.ui;
  const DraftScale scale =
      draft_scale(context.state.settings.required_draft.deg, context.state.settings.look.palette);
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos()) + glm::vec2(ui.px(8), ui.px(3));
  const float step =
      (ImGui::GetContentRegionAvail().x - ui.px(16)) / static_cast<float>(scale.colours.size());
  const float height = ui.px(8);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  for (std::size_t k = 0; k < scale.colours.size(); ++k) {
    const glm::vec2 min = start + glm::vec2(static_cast<float>(k) * step, 0.0F);
    list.AddRectFilled(im(min), im(min + glm::vec2(step - ui.px(1), height)), packed(scale.colours[k]),
                       ui.px(2));
  }
  for (std::size_t k = 0; k < scale.limits_deg.size(); ++k) {
    const double limit = scale.limits_deg[k];
    const std::string text = fmt::format("{}{:.3g}°", limit < 0.0 ? "−" : "", std::abs(limit));
    draw_text(list, {ui.fonts.small, ui.colours->muted},
              start + glm::vec2(static_cast<float>(k + 1) * step - 0.5F * text_size(ui.fonts.small, text).x,
                                height + ui.px(3)),
              text);
  }
  ImGui::Dummy(ImVec2(1.0F, height + ui.px(6) + ui.fonts.small.size));
}

constexpr float k_picture = 60.0F;  // layout units

constexpr const char* caption(bool plus) { return plus ? "+d" : "−d"; }

/// The maps, and beside them in words what they are worth.
void draw_thumbnails(const PanelContext& context, const MapTextures& textures) {
  const Ui& ui = context.ui;
  const float gap = ui.px(8), size = ui.px(k_picture);
  ImGui::Dummy(ImVec2(1.0F, ui.px(2)));
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
  ImGui::BeginGroup();
  draw_map_comparison(context);
  ImGui::EndGroup();
}

/// What seldom needs a change stands in a list of its own.
void draw_accuracy(const PanelContext& context, const PartLengths& lengths) {
  const Ui& ui = context.ui;
  MethodSettings& method = context.edits.settings.method;
  if (disclosure(ui, "Accuracy", false)) open_popup_below_item(ui, "accuracy");
  if (!begin_popup(ui, "accuracy", ui.px(k_panel_width))) return;
  const std::string standard = fmt::format("{:.3g}", lateral_tolerance(method, lengths.diagonal));
  for (const std::string_view key : k_accuracy_options)
    option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths, .unset = standard});
  end_popup(ui);
}

constexpr float k_comparison_width = 344.0F, k_figure_row = 20.0F;  // layout units
constexpr std::array<ListColumn, 4> k_comparison_columns = {
    {{"", "", 18.0F, false}, {"", "", 168.0F, true}, {"", "", 256.0F, true}, {"", "", 344.0F, true}}};

}  // namespace

void draw_look_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Look")) {
    LookSettings& look = context.edits.settings.look;
    const PartLengths lengths(context.state);
    for (const Option<LookSettings>& option : look_options()) {
      const bool is_switch = std::holds_alternative<SwitchKind<LookSettings>>(option.kind);
      if (is_switch || is_among(k_map_look_options, option)) continue;
      if (option.key == "section_at" && look.section == Section::off) continue;
      if (option.key == "section_turn" && look.section != Section::along) continue;
      RowOptions row{.lengths = &lengths};
      if (option.key == "open_mold")
        row.text = [&](double open) { return opening_text(context.state, open); };
      option_row(ui, option, look, row);
      if (option.key == "colouring" && look.colour_mode == ColourMode::draft_angle) {
        option_row(ui, required_draft_options().front(), context.edits.settings.required_draft);
        draw_draft_key(context);
      }
      if (option.key == "open_mold" && ImGui::IsItemActive()) context.edits.dragging = true;
    }
    ImGui::Dummy(ImVec2(0.0F, ui.px(2)));
    draw_chips(ui, look);
  }
  context.layout.end();
}

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

void draw_maps_panel(const PanelContext& context, const MapTextures& textures) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Shadow maps")) {
    LookSettings& look = context.edits.settings.look;
    MethodSettings& method = context.edits.settings.method;
    const PartLengths lengths(context.state);
    bool touched = false;
    for (const std::string_view key : k_map_options)
      touched = option_row(ui, option_named(method_options(), key), method, {.lengths = &lengths}) || touched;
    // What a control of the maps does is to be seen.
    if (touched) look.regions_by = RegionsBy::maps;
    option_row(ui, option_named(look_options(), "mark_difference"), look);
    draw_thumbnails(context, textures);
    draw_accuracy(context, lengths);
  }
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

std::string with_sign(const FigureColumn& column, double value) {
  std::string text = column.text(std::abs(value));
  const bool none = text.find_first_not_of("0.") == std::string::npos;
  return none ? "0" : (value < 0.0 ? "−" : "+") + grouped(text);
}

void draw_comparison(const PanelContext& context) {
  const AppState& state = context.state;
  const auto& compared = state.sweep_choices.compared;
  if (!compared || !state.sweep.result || *compared >= state.sweep.result->candidates.size()) return;
  const Ui& ui = context.ui;
  const SweepCandidate& other = state.sweep.result->candidates[*compared];
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  place_window({0.5F * window.x, ui.px(k_bar_height + 8)}, {0.5F, 0.0F});
  ImGui::Begin("##Comparison", nullptr, k_card_window);
  const glm::vec2 start = from_im(ImGui::GetCursorScreenPos());
  const auto add = [&](const std::array<std::string, 4>& texts, ImU32 colour, ImU32 swatch = 0) {
    const glm::vec2 at = from_im(ImGui::GetCursorScreenPos());
    ImGui::Dummy(ImVec2(ui.px(k_comparison_width), ui.px(k_figure_row)));
    const glm::vec2 min(at.x, at.y + ui.px(5));
    fill(*ImGui::GetWindowDrawList(), {min, min + glm::vec2(ui.px(10))}, swatch, ui.px(3));
    for (std::size_t k = 0; k < texts.size(); ++k)
      draw_cell(ui, item_box(), k_comparison_columns[k],
                {k == 3 ? ui.fonts.strong : ui.fonts.body, k == 3 ? ui.colours->text : colour}, texts[k]);
  };
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0.0F, 0.0F));
  const bool known = state.figures.shown && !state.figures.pale;
  const FigureColumn column(state.model->geometry.total_area);
  add({"", "left", fmt::format("right, {}", other.rank), "left − right"}, ui.colours->muted);
  for (const Region region : k_regions) {
    const double right = other.classification.areas[region];
    const double left = known ? state.figures.shown->areas[region] : 0.0;
    add({std::string(facts(region).title), known ? grouped(column.text(left)) : "…",
         grouped(column.text(right)), known ? with_sign(column, left - right) : "…"},
        ui.colours->text, packed(region_colour(region, state.settings.look.palette)));
  }
  add({"Undercut ±", known ? error_text(state.figures.shown->uncertainty.total()) : "…",
       error_text(other.classification.uncertainty.total()),
       known ? error_text(std::hypot(state.figures.shown->uncertainty.total(),
                                     other.classification.uncertainty.total()))
             : "…"},
      ui.colours->muted);
  ImGui::PopStyleVar();
  ImGui::SetCursorScreenPos(ImVec2(start.x - ui.px(6), start.y - ui.px(3)));
  if (icon_button(ui, {"close comparison", Icon::close, "Back to one picture (Esc)"})) {
    context.edits.sweep_choices.compared.reset();
  }
  ImGui::End();
}

}  // namespace moldlight::gui
