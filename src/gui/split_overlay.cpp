#include "gui/split_overlay.hpp"

namespace moldlight::gui {

void draw_split(const Ui& ui, const SplitView& split, unsigned texture) {
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  const auto left = static_cast<float>(split.left), right = left + static_cast<float>(split.size.x);
  const auto bottom = static_cast<float>(split.size.y);
  list.AddImage(texture_id(texture), ImVec2(left, 0.0F), ImVec2(right, bottom), ImVec2(0, 1), ImVec2(1, 0));
  list.AddRectFilled(ImVec2(left - 0.5F * ui.px(2), 0.0F), ImVec2(left + 0.5F * ui.px(2), bottom),
                     ui.colours->line);
}

}  // namespace moldlight::gui
