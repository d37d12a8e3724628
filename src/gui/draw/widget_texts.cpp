// What controls and panels write, and what is written on the scene: texts in lines, tags, bars of progress.
#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>

#include "gui/draw/widgets.hpp"

namespace moldlight::gui {

constexpr float k_least_wrap = 80.0F;  // layout units; narrower text is not wrapped

void row_text(const Ui& ui, const Lettering& lettering, float width, std::string_view text) {
  const glm::vec2 at = cursor_at();
  ImGui::Dummy(ImVec2(width, ui.px(k_row_height)));
  draw_text(lettering, {at.x, at.y + 0.5F * (ui.px(k_row_height) - lettering.font.size)}, text);
}

void draw_tagged_text(const Ui& ui, ImDrawList& list, const TaggedText& tagged) {
  const glm::vec2 room(ui.px(5), ui.px(1)), size = text_size(tagged.lettering.font, tagged.text);
  list.AddRectFilled(tagged.at - room, tagged.at + size + room, ui.colours->popup, ui.px(6));
  draw_text(list, tagged.lettering, tagged.at, tagged.text);
}

void draw_picture(ImDrawList& list, unsigned texture, const ScreenBox& box, float rounding) {
  if (texture == 0) return;
  list.AddImageRounded(texture_id(texture), box.min, box.max, ImVec2(0, 1), ImVec2(1, 0), IM_COL32_WHITE,
                       rounding);
}

std::vector<std::string> lines_within(const SizedFont& font, std::string_view text, float width,
                                      std::size_t most) {
  std::vector<std::string> lines;
  while (!text.empty() && lines.size() < most) {
    std::size_t end = text.size();
    const auto line = [&] {
      return std::string(text.substr(0, end)) + (end < text.size() && lines.size() + 1 == most ? " …" : "");
    };
    while (end != std::string_view::npos && end > 0 && text_size(font, line()).x > width)
      end = text.rfind(' ', end - 1);
    const bool fits = end != std::string_view::npos && end > 0;
    lines.push_back(fits ? line() : fitted(font, text, width));
    text.remove_prefix(fits ? std::min(text.size(), end + 1) : text.size());
  }
  return lines;
}

void hint(const Ui& ui, std::string_view text) {
  const FontScope small(ui.fonts.small);
  ImGui::Indent(ui.px(8));
  // A window that fits its contents has no width in its first frame: wrapped at that, it would grow tall.
  const bool wraps = room_left() > ui.px(k_least_wrap);
  if (wraps) ImGui::PushTextWrapPos(0.0F);
  draw_item_text(ui.colours->muted, text);
  if (wraps) ImGui::PopTextWrapPos();
  ImGui::Unindent(ui.px(8));
}

void warning(const Ui& ui, std::string_view text) {
  draw_icon(window_list(), Icon::alert, cursor_at() + glm::vec2(ui.px(14), ui.px(8)), ui.px(12),
            ui.colours->warning);
  ImGui::Indent(ui.px(18));
  hint(ui, text);
  ImGui::Unindent(ui.px(18));
}

glm::vec2 beyond_tip(const Ui& ui, const glm::vec2& tail, const glm::vec2& tip, std::string_view text) {
  const glm::vec2 along = tip - tail;
  const float length = glm::length(along);
  const glm::vec2 forward = length > 1.0F ? along / length : glm::vec2(0.0F, -1.0F);
  return tip + forward * (ui.px(8) + glm::dot(glm::abs(forward), 0.5F * tag_size(ui, text)));
}

glm::vec2 tag_size(const Ui& ui, std::string_view text) {
  return text_size(ui.fonts.small, text) + 2.0F * glm::vec2(ui.px(8), ui.px(3));
}

void draw_tag(const Ui& ui, const glm::vec2& middle, std::string_view text, ImU32 colour) {
  ImDrawList& list = scene_list();
  const glm::vec2 half = 0.5F * tag_size(ui, text);
  list.AddRectFilled(middle - half, middle + half, ui.colours->panel, half.y);
  draw_text(list, {ui.fonts.small, colour}, middle - 0.5F * text_size(ui.fonts.small, text), text);
}

void draw_whole_tag(const Ui& ui, const glm::vec2& middle, std::string_view text, ImU32 colour) {
  const glm::vec2 room = 0.5F * tag_size(ui, text), window = screen_size();
  if (glm::all(glm::greaterThan(middle - room, glm::vec2(0.0F))) &&
      glm::all(glm::lessThan(middle + room, window)))
    draw_tag(ui, middle, text, colour);
}

void progress_bar(const Ui& ui, double fraction, float width) {
  const glm::vec2 min = cursor_at();
  const float height = ui.px(4);
  ImGui::Dummy(ImVec2(width, height));
  ImDrawList& list = window_list();
  list.AddRectFilled(min, ImVec2(min.x + width, min.y + height), ui.colours->field_hovered, 0.5F * height);
  if (fraction < 0.0) return;
  const float done = std::max(height, width * static_cast<float>(std::min(fraction, 1.0)));
  list.AddRectFilled(min, ImVec2(min.x + done, min.y + height), ui.colours->accent, 0.5F * height);
}

}  // namespace moldlight::gui
