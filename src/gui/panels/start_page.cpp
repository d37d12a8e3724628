// The window without a part: where to drop one, recent files, the shipped parts.
#include <algorithm>
#include <filesystem>

#include "gui/draw/widgets.hpp"
#include "gui/panels/panels.hpp"
#include "io/part_formats.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

constexpr float k_start_width = 520.0F, k_drop_height = 148.0F;  // layout units
constexpr std::size_t k_recent_shown = 6;

void draw_drop_zone(const PanelContext& context) {
  const Ui& ui = context.ui;
  const glm::vec2 size(ui.px(k_start_width), ui.px(k_drop_height));
  const Pressable zone = pressable(ui, "drop", size);
  const glm::vec2 min = zone.box.min;
  ImDrawList& list = window_list();
  fill(list, {min, min + size}, field_colour(ui, {.hovered = zone.hovered}), ui.px(10));
  list.AddRect(min, min + size, ui.colours->line, ui.px(10), 0, 1.5F * ui.scale);
  const auto centred = [&](const SizedFont& font, float top, ImU32 colour, std::string_view text) {
    draw_text(list, {font, colour}, {min.x + 0.5F * (size.x - text_size(font, text).x), min.y + ui.px(top)},
              text);
  };
  draw_icon(list, Icon::open, min + glm::vec2(0.5F * size.x, ui.px(38)), ui.px(30), ui.colours->muted);
  centred(ui.fonts.title, 62, ui.colours->text, "Drop a part here");
  centred(ui.fonts.body, 102, ui.colours->muted, "or click to choose one: " + part_format_names(", "));
  if (zone.clicked) context.edits.dialogs.browser = true;
}

void draw_recent_parts(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.state.recent.empty()) return;
  hint(ui, "RECENT");
  const std::size_t count = std::min(context.state.recent.size(), k_recent_shown);
  for (std::size_t k = 0; k < count; ++k) {
    const fs::path path = context.state.recent[k];
    ImGui::PushID(static_cast<int>(k));
    const Pressable row = pressable(ui, "recent", {ui.px(k_start_width), ui.px(k_row_height)});
    const auto& [min, max] = row.box;
    ImDrawList& list = window_list();
    if (row.hovered) fill(list, {min, max}, ui.colours->field, ui.px(6));
    const float top = 0.5F * (min.y + max.y - ui.fonts.body.size);
    const std::string name = fitted(ui.fonts.body, path.filename().string(), ui.px(220));
    draw_icon(list, Icon::file, {min.x + ui.px(14), 0.5F * (min.y + max.y)}, ui.px(13), ui.colours->muted);
    draw_text(list, ui.text(), {min.x + ui.px(30), top}, name);
    const std::string folder = fitted(ui.fonts.small, path.parent_path().string(), ui.px(240));
    draw_text_to(ui.note(), max.x - ui.px(8), 0.5F * (min.y + max.y - ui.fonts.small.size), folder);
    if (row.clicked) context.edits.ask(&Commands::open_part, path.string());
    ImGui::PopID();
  }
  ImGui::Dummy(ImVec2(1, ui.px(10)));
}

void draw_shipped(const PanelContext& context, std::span<const unsigned> thumbnails) {
  const Ui& ui = context.ui;
  const auto& shipped = context.state.shipped;
  if (shipped.empty()) return;
  hint(ui, "TRY ONE OF THESE");
  const float gap = ui.px(8);
  const float width = ui.px(k_start_picture_size);
  for (std::size_t k = 0; k < std::min<std::size_t>(shipped.size(), 4); ++k) {
    if (k > 0) ImGui::SameLine(0.0F, gap);
    ImGui::PushID(static_cast<int>(k));
    const Pressable card = pressable(ui, "shipped", {width, width});
    const auto& [min, max] = card.box;
    ImDrawList& list = window_list();
    fill(list, card.box, field_colour(ui, {.hovered = card.hovered}), ui.px(8));
    if (k < thumbnails.size()) draw_picture(list, thumbnails[k], {min, {max.x, max.y - ui.px(10)}}, ui.px(8));
    std::string name = fs::path(shipped[k]).stem().string();
    std::replace(name.begin(), name.end(), '_', ' ');
    const glm::vec2 text = text_size(ui.fonts.small, name);
    draw_text(list, ui.note(), {0.5F * (min.x + max.x - text.x), max.y - ui.px(6) - text.y}, name);
    if (card.clicked) context.edits.ask(&Commands::open_part, shipped[k]);
    ImGui::PopID();
  }
}

}  // namespace

void draw_start_page(const PanelContext& context, std::span<const unsigned> thumbnails) {
  if (context.state.model || context.state.dialogs.browser || context.state.dialogs.batch) return;
  place_window(0.5F * screen_size(), glm::vec2(0.5F));
  ImGui::Begin("Start", nullptr,
               k_fixed_window | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_AlwaysAutoResize |
                   ImGuiWindowFlags_NoBringToFrontOnFocus);
  draw_drop_zone(context);
  ImGui::Dummy(ImVec2(1, context.ui.px(12)));
  draw_recent_parts(context);
  draw_shipped(context, thumbnails);
  ImGui::End();
}

}  // namespace moldlight::gui
