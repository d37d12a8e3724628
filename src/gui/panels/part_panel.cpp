// Settings of the part: its draft, its unit, and the body of the file that is molded.
#include <algorithm>
#include <filesystem>

#include <fmt/format.h>

#include "classify/method_options.hpp"
#include "gui/draw/widgets.hpp"
#include "gui/panels/option_row.hpp"
#include "gui/panels/panels.hpp"
#include "io/part_formats.hpp"

namespace moldlight::gui {

namespace fs = std::filesystem;

namespace {

/// The bodies of the file, and which of them is shown.
struct Bodies {
  std::vector<std::string> names;
  std::size_t chosen = 0;  // from 1; 0: all as one part
};

Bodies bodies_of(const Part& part) {
  if (part.chosen_body > 0) return {part.file_bodies, part.chosen_body};
  Bodies all;
  for (const Body& body : part.bodies) all.names.push_back(body.name);
  return all;
}

std::string body_text(const Bodies& bodies, std::size_t number) {
  if (number == 0) return fmt::format("all {}", bodies.names.size());
  const std::string& name = bodies.names[number - 1];
  return name.empty() ? fmt::format("{}", number) : fmt::format("{}  {}", number, name);
}

void list_bodies(const Ui& ui, const Bodies& bodies, std::size_t& wanted) {
  if (!begin_popup(ui, "bodies", ui.px(280))) return;
  for (std::size_t number = 0; number <= bodies.names.size(); ++number) {
    const std::string text =
        fmt::format("{}##{}", fitted(ui.fonts.body, body_text(bodies, number), ui.px(240)), number);
    if (menu_item(ui, text, {.chosen = number == bodies.chosen})) wanted = number;
    name_item(ui, fmt::format("body {}", number));
  }
  end_popup(ui);
}

/// The unit that the part has; choosing one names or converts it, a reset leaves it to the file.
void draw_unit(const PanelContext& context) {
  const Option<ReadOptions>& option = option_named(reading_options(), "unit");
  const Words& words = std::get<TextKind<ReadOptions>>(option.kind).words;
  std::string& wanted = context.edits.reading.unit;
  const std::string chosen = wanted, as_in_the_file;
  int index = static_cast<int>(std::ranges::find(words, context.state.model->part.unit) - words.begin());
  if (choice(context.ui, {option.label, !chosen.empty()}, words, index))
    wanted = words[static_cast<std::size_t>(index)];
  if (option_menu(context.ui, {option.label, option.help, chosen, as_in_the_file})) wanted.clear();
}

/// Goes through the bodies one by one, or opens the list of them.
void draw_body(const PanelContext& context) {
  const Ui& ui = context.ui;
  const Bodies bodies = bodies_of(context.state.model->part);
  const std::size_t count = bodies.names.size();
  if (count < 2) return;
  std::size_t wanted = bodies.chosen;
  const float gap = ui.px(4), arrow = ui.px(k_row_height);
  ImGui::SetCursorPosX(ImGui::GetCursorPosX() + ui.px(8));
  row_text(ui, {ui.fonts.body, ui.colours->muted}, ui.px(64), "Body");
  ImGui::SameLine(0.0F, 0.0F);
  const float width = ImGui::GetContentRegionAvail().x - 2.0F * (arrow + gap);
  if (icon_button(ui, {"previous body", Icon::chevron_left, "The body before"}))
    wanted = (wanted + count) % (count + 1);
  ImGui::SameLine(0.0F, gap);
  const std::string shown = fitted(ui.fonts.body, body_text(bodies, bodies.chosen), width - ui.px(16));
  if (button(ui, fmt::format("{}##body", shown), {.width = width})) open_popup_below_item(ui, "bodies");
  name_item(ui, "body");
  list_bodies(ui, bodies, wanted);
  ImGui::SameLine(0.0F, gap);
  if (icon_button(ui, {"next body", Icon::chevron_right, "The next body"}))
    wanted = (wanted + 1) % (count + 1);
  if (wanted != bodies.chosen) context.edits.reading.body = wanted == 0 ? "all" : fmt::format("{}", wanted);
  if (bodies.chosen == 0) hint(ui, "All bodies as one part. Choose the body that is molded.");
}

constexpr float k_start_width = 520.0F, k_drop_height = 148.0F;  // layout units
constexpr std::size_t k_recent_shown = 6;

void draw_drop_zone(const PanelContext& context) {
  const Ui& ui = context.ui;
  const glm::vec2 size(ui.px(k_start_width), ui.px(k_drop_height));
  const Pressable zone = pressable(ui, "drop", size);
  const glm::vec2 min = zone.box.min;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  fill(list, {min, min + size}, field_colour(ui, {.hovered = zone.hovered}), ui.px(10));
  list.AddRect(im(min), im(min + size), ui.colours->line, ui.px(10), 0, 1.5F * ui.scale);
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
    ImDrawList& list = *ImGui::GetWindowDrawList();
    if (row.hovered) list.AddRectFilled(im(min), im(max), ui.colours->field, ui.px(6));
    const float top = 0.5F * (min.y + max.y - ui.fonts.body.size);
    const std::string name = fitted(ui.fonts.body, path.filename().string(), ui.px(220));
    draw_icon(list, Icon::file, {min.x + ui.px(14), 0.5F * (min.y + max.y)}, ui.px(13), ui.colours->muted);
    draw_text(list, {ui.fonts.body, ui.colours->text}, {min.x + ui.px(30), top}, name);
    const std::string folder = fitted(ui.fonts.small, path.parent_path().string(), ui.px(240));
    draw_text_to({ui.fonts.small, ui.colours->muted}, max.x - ui.px(8),
                 0.5F * (min.y + max.y - ui.fonts.small.size), folder);
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
    ImDrawList& list = *ImGui::GetWindowDrawList();
    fill(list, card.box, field_colour(ui, {.hovered = card.hovered}), ui.px(8));
    if (k < thumbnails.size()) draw_picture(list, thumbnails[k], {min, {max.x, max.y - ui.px(10)}}, ui.px(8));
    std::string name = fs::path(shipped[k]).stem().string();
    std::replace(name.begin(), name.end(), '_', ' ');
    const glm::vec2 text = text_size(ui.fonts.small, name);
    draw_text(list, {ui.fonts.small, ui.colours->muted},
              {0.5F * (min.x + max.x - text.x), max.y - ui.px(6) - text.y}, name);
    if (card.clicked) context.edits.ask(&Commands::open_part, shipped[k]);
    ImGui::PopID();
  }
}

}  // namespace

void draw_part_panel(const PanelContext& context) {
  const Ui& ui = context.ui;
  if (context.layout.begin(ui, "Part")) {
    option_row(ui, option_named(method_options(), "tau_deg"), context.edits.settings.method);
    draw_unit(context);
    draw_body(context);
  }
  context.layout.end();
}

void draw_start_page(const PanelContext& context, std::span<const unsigned> thumbnails) {
  if (context.state.model || context.state.dialogs.browser) return;
  const ImVec2 window = ImGui::GetIO().DisplaySize;
  place_window(0.5F * from_im(window), glm::vec2(0.5F));
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
