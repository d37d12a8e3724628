#include "gui/draw/ui.hpp"

#include <algorithm>

#include <glm/common.hpp>

namespace moldlight::gui {

glm::vec2 text_size(const SizedFont& font, std::string_view text) {
  if (text.empty()) return {0.0F, font.size};  // ImGui would look for the end of a null pointer's string
  const ImVec2 size = font.font->CalcTextSizeA(font.size, std::numeric_limits<float>::max(), 0.0F,
                                               text.data(), text.data() + text.size());
  return {std::ceil(size.x), size.y};
}

void note_text(const ImDrawList& list, ImU32 colour, const ScreenBox& box, std::string_view text) {
  auto& memory = *static_cast<UiMemory*>(ImGui::GetIO().UserData);
  const char* const window = list._OwnerName;
  memory.texts.push_back({.text = std::string(text),
                          .window = window != nullptr ? window : "",
                          .box = box,
                          .clip = {glm::vec2(list.GetClipRectMin()), glm::vec2(list.GetClipRectMax())},
                          .colour = colour});
}

void draw_text(ImDrawList& list, const Lettering& lettering, const glm::vec2& at, std::string_view text) {
  if (text.empty()) return;
  const glm::vec2 corner = glm::round(at);
  list.AddText(lettering.font.font, lettering.font.size, corner, lettering.colour, text.data(),
               text.data() + text.size());
  note_text(list, lettering.colour, {corner, corner + text_size(lettering.font, text)}, text);
}

void draw_item_text(ImU32 colour, std::string_view text) {
  ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::TextUnformatted(text.data(), text.data() + text.size());
  ImGui::PopStyleColor();
  note_text(window_list(), colour, item_box(), text);
}

void draw_text_to(const Lettering& lettering, float right, float top, std::string_view text) {
  draw_text(lettering, {right - text_size(lettering.font, text).x, top}, text);
}

std::string fitted(const SizedFont& font, std::string_view text, float width) {
  if (text_size(font, text).x <= width) return std::string(text);
  for (std::size_t end = text.size(); end > 0;) {
    const std::size_t sentence = text.rfind(". ", end - 1), part = text.rfind(" · ", end - 1);
    const std::size_t none = std::string_view::npos;
    if (sentence == none && part == none) break;
    end = sentence == none || (part != none && part > sentence) ? part : sentence;
    const std::string shorter = std::string(text.substr(0, end + (end == sentence ? 1 : 0))) + " …";
    if (end > 0 && text_size(font, shorter).x <= width) return shorter;
  }
  // Bytes of UTF-8 that continue a character may not be cut off from it.
  const auto boundary = [&](std::size_t at) {
    while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0) == 0x80) ++at;
    return std::min(at, text.size());
  };
  for (std::size_t kept = text.size(); kept > 1; --kept) {
    const std::string shorter = std::string(text.substr(0, boundary(kept / 2))) + "…" +
                                std::string(text.substr(boundary(text.size() - kept / 2)));
    if (text_size(font, shorter).x <= width) return shorter;
  }
  return "…";
}

void place_window(const glm::vec2& at, const glm::vec2& pivot) {
  ImGui::SetNextWindowPos(at, ImGuiCond_Always, pivot);
}

void heading(const Ui& ui, std::string_view text) {
  const FontScope strong(ui.fonts.strong);
  draw_item_text(ui.colours->text, text);
}

}  // namespace moldlight::gui
