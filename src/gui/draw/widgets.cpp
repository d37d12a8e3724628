#include "gui/draw/widgets.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "base/error.hpp"
#include "classify/option.hpp"

namespace moldlight::gui {

namespace {

Pressable begin_row(const Ui& ui, std::string_view label, float width = 0.0F) {
  if (width <= 0.0F) width = room_left();
  return pressable(ui, std::string(label).c_str(), {width, ui.px(k_row_height)});
}

/// Around a control that has the keyboard.
void draw_focus_ring(const Ui& ui, const ScreenBox& box) {
  const glm::vec2 gap(1.5F * ui.scale);
  window_list().AddRect(box.min - gap, box.max + gap, ui.colours->accent, ui.px(7), 0, 2.0F * ui.scale);
  if (!ui.memory->keyboard.arrived()) return;
  const ImGuiStyle& style = ImGui::GetStyle();
  const float top = ImGui::GetWindowPos().y + style.WindowPadding.y,
              bottom = ImGui::GetWindowPos().y + ImGui::GetWindowHeight() - style.WindowPadding.y;
  if (box.min.y < top || box.max.y > bottom) ImGui::SetScrollHereY(0.5F);
}

/// By how many steps the arrow keys move a value; with PageUp and PageDown by ten.
int value_steps(Keyboard& keyboard) {
  if (keyboard.takes(ControlKey::left)) return -1;
  if (keyboard.takes(ControlKey::right)) return 1;
  if (keyboard.takes(ControlKey::page_down)) return -10;
  return keyboard.takes(ControlKey::page_up) ? 10 : 0;
}

void draw_row_text(const Lettering& lettering, float left, const Pressable& row, std::string_view text) {
  draw_text(lettering, {left, row.box.centre().y - 0.5F * lettering.font.size}, text);
}

void draw_label(const Ui& ui, const Pressable& row, const RowLabel& label) {
  const std::string_view shown = label.text.substr(0, label.text.find("##"));
  float left = row.box.min.x + ui.px(8);
  if (label.modified) {
    window_list().AddCircleFilled(ImVec2(left + ui.px(2), row.box.centre().y), 2.5F * ui.scale,
                                  ui.colours->text);
    left += ui.px(9);
  }
  draw_row_text({ui.fonts.body, label.modified ? ui.colours->text : ui.colours->muted}, left, row, shown);
}

void draw_value(const Ui& ui, const Pressable& row, std::string_view text) {
  draw_row_text(ui.text(), row.box.max.x - ui.px(8) - text_size(ui.fonts.body, text).x, row, text);
}

double snapped(double value, const SliderSpec& spec) {
  if (spec.snap) {
    value = spec.snap(value);
  } else if (spec.step > 0.0)
    value = std::round(value / spec.step) * spec.step;
  return std::clamp(value, spec.min, spec.max);
}

double share_of(double value, const SliderSpec& spec) {
  const double share = spec.logarithmic ? std::log(value / spec.min) / std::log(spec.max / spec.min)
                                        : (value - spec.min) / (spec.max - spec.min);
  return std::clamp(share, 0.0, 1.0);
}

double value_at(double share, const SliderSpec& spec) {
  share = std::clamp(share, 0.0, 1.0);
  return spec.logarithmic ? spec.min * std::pow(spec.max / spec.min, share)
                          : spec.min + share * (spec.max - spec.min);
}

/// A value so many steps on, and by one at least that makes a difference.
double stepped(double value, int steps, const SliderSpec& spec) {
  if (!spec.snap) {
    const double step = spec.step > 0.0 ? spec.step : 0.01 * (spec.max - spec.min);
    return snapped(value + steps * step, spec);
  }
  const double before = value;
  for (int k = 1; k <= 64 && value == before; ++k)
    value = snapped(value_at(share_of(before, spec) + 0.004 * k * steps, spec), spec);
  return value;
}

void start_typing(UiMemory& memory, ImGuiID id, const std::string& text) {
  memory.keyboard.give_to(id);
  memory.typing_id = id;
  memory.typing_starts = true;
  std::snprintf(memory.typed.data(), memory.typed.size(), "%s", text.c_str());
}

/// The typed field in place of a row; gives the number once it was entered.
std::optional<double> typed_row(const Ui& ui, ImGuiID id, float width) {
  UiMemory& memory = *ui.memory;
  ImGui::SetNextItemWidth(width);
  if (memory.typing_starts) ImGui::SetKeyboardFocusHere();
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(ui.px(8), 0.5F * (ui.px(k_row_height) - ui.fonts.body.size)));
  ImGui::PushID(static_cast<int>(id));
  const bool entered =
      ImGui::InputText("##typed", memory.typed.data(), memory.typed.size(),
                       ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  memory.keyboard.visit(id);
  const bool tabbed = !memory.keyboard.focused(id);
  const bool left = tabbed || ImGui::IsItemDeactivated(), edited = ImGui::IsItemDeactivatedAfterEdit();
  ImGui::PopID();
  ImGui::PopStyleVar();
  memory.typing_starts = false;
  if (!entered && !left) return std::nullopt;
  memory.typing_id = 0;
  const bool given_up =
      !entered && !tabbed && (!edited || ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Escape)));
  if (given_up) return std::nullopt;
  try {
    return parse_real({memory.typed.data(), "value"});
  } catch (const UsageError&) {
    return std::nullopt;
  }
}

bool wants_typing() {
  return ImGui::IsItemHovered() &&
         (ImGui::IsMouseDoubleClicked(0) || (ImGui::IsMouseClicked(0) && ImGui::GetIO().KeyCtrl));
}

}  // namespace

ImU32 field_colour(const Ui& ui, const Pressable& item) {
  return item.active    ? ui.colours->field_active
         : item.hovered ? ui.colours->field_hovered
                        : ui.colours->field;
}

void fill(ImDrawList& list, const ScreenBox& box, ImU32 colour, float rounding) {
  list.AddRectFilled(box.min, box.max, colour, rounding);
}

void name_item(const Ui& ui, const std::string& name) { ui.memory->controls[name] = item_box(); }

bool has_keyboard(const Ui& ui, std::string_view id, const ScreenBox& box) {
  if (!ui.memory->keyboard.visit(ImGui::GetID(id.data(), id.data() + id.size()))) return false;
  ui.memory->focused = id;
  draw_focus_ring(ui, box);
  return true;
}

Pressable pressable(const Ui& ui, const char* id, const glm::vec2& size) {
  Pressable item;
  item.clicked = ImGui::InvisibleButton(id, glm::max(size, glm::vec2(1.0F)));
  item.box = item_box();
  item.hovered = ImGui::IsItemHovered();
  item.active = ImGui::IsItemActive();
  ui.memory->controls[id] = item.box;
  const bool enabled = ImGui::GetStyle().Alpha >= 1.0F;  // else inside BeginDisabled()
  item.focused = enabled && has_keyboard(ui, id, item.box);
  item.pressed = item.focused && ui.memory->keyboard.takes(ControlKey::press);
  item.clicked = item.clicked || item.pressed;
  return item;
}

bool text_field(const Ui& ui, const char* id, std::span<char> text, const TextSpec& spec) {
  Keyboard& keyboard = ui.memory->keyboard;
  const ImGuiID control = ImGui::GetID(id);
  const bool focused = keyboard.visit(control);
  if (spec.starts || (focused && keyboard.arrived())) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(spec.width > 0.0F ? spec.width : room_left());
  const bool changed = ImGui::InputTextWithHint(id, spec.hint, text.data(), text.size());
  if (ImGui::IsItemActivated()) keyboard.give_to(control);
  if (ImGui::IsItemDeactivated() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter))) keyboard.enter();
  const ScreenBox box = item_box();
  const std::string_view shown(id);
  const std::string name(shown.substr(shown.starts_with("##") ? 2 : 0));
  ui.memory->controls[name] = box;
  if (focused) {
    ui.memory->focused = name;
    draw_focus_ring(ui, box);
  }
  return changed;
}

bool menu_item(const Ui& ui, std::string_view label, const MenuItemSpec& spec) {
  const std::string_view shown = label.substr(0, label.find("##"));
  ImGui::BeginDisabled(!spec.enabled);
  const float width = std::max(text_size(ui.fonts.body, shown).x + ui.px(16), room_left());
  const Pressable row = begin_row(ui, label, width);
  ImGui::EndDisabled();
  if (row.hovered || row.focused) fill(window_list(), row.box, ui.colours->field_hovered, ui.px(6));
  draw_row_text({ui.fonts.body, spec.enabled ? ui.colours->text : ui.colours->muted},
                row.box.min.x + ui.px(8), row, shown);
  if (spec.chosen)
    draw_icon(window_list(), Icon::check, {row.box.max.x - ui.px(14), row.box.centre().y}, ui.px(12),
              ui.colours->text);
  if (row.clicked) ui.memory->popups.close_all();
  return row.clicked;
}

bool slider(const Ui& ui, const RowLabel& label, double& value, const SliderSpec& spec) {
  const std::string id_text(label.text);
  const ImGuiID id = ImGui::GetID(id_text.c_str());
  const double before = value;
  if (ui.memory->typing_id == id) {
    const auto typed = typed_row(ui, id, room_left());
    if (typed) value = std::clamp(*typed, spec.min, spec.max);
    return value != before;
  }
  const Pressable row = begin_row(ui, label.text);
  Keyboard& keyboard = ui.memory->keyboard;
  if (wants_typing() || row.pressed) {
    start_typing(*ui.memory, id, real_text(value));
  } else if (const int steps = row.focused ? value_steps(keyboard) : 0; steps != 0) {
    value = stepped(value, steps, spec);
  } else if (row.active) {
    const float mouse = ImGui::GetIO().MousePos.x;
    // A press alone changes nothing: the first of two clicks that start typing would.
    if (std::abs(ImGui::GetMouseDragDelta(0, 0.0F).x) >= 2.0F * ui.scale)
      value = snapped(value_at((mouse - row.box.min.x) / (row.box.max.x - row.box.min.x), spec), spec);
  }
  ImDrawList& list = window_list();
  const float rounding = ui.px(6);
  fill(list, row.box, field_colour(ui, row), rounding);
  const float end =
      row.box.min.x + static_cast<float>(share_of(value, spec)) * (row.box.max.x - row.box.min.x);
  list.PushClipRect(row.box.min, ImVec2(std::round(end), row.box.max.y), true);
  fill(list, row.box, ui.colours->fill, rounding);
  list.PopClipRect();
  if (row.hovered || row.active) {
    const float x = std::clamp(std::round(end), row.box.min.x + ui.px(4), row.box.max.x - ui.px(4));
    list.AddRectFilled(ImVec2(x - ui.px(1), row.box.min.y + ui.px(6)),
                       ImVec2(x + ui.px(1), row.box.max.y - ui.px(6)), ui.colours->accent, ui.px(1));
  }
  // Where both have no room, the value is what one wants to read.
  const std::string shown = spec.text(value);
  const float room =
      row.box.max.x - row.box.min.x - text_size(ui.fonts.body, shown).x - ui.px(label.modified ? 28 : 19);
  const std::string name = fitted(ui.fonts.body, label.text.substr(0, label.text.find("##")), room);
  draw_label(ui, row, {name, label.modified});
  draw_value(ui, row, shown);
  if (row.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  return value != before;
}

bool number_field(const Ui& ui, const char* id_text, double& value, const NumberSpec& spec) {
  const ImGuiID id = ImGui::GetID(id_text);
  UiMemory& memory = *ui.memory;
  if (memory.typing_id == id) {
    const auto typed = typed_row(ui, id, spec.width);
    return typed && std::exchange(value, *typed) != *typed;
  }
  const Pressable row = begin_row(ui, id_text, spec.width);
  if (row.clicked || (row.focused && memory.keyboard.arrived())) memory.type_in = id;
  // The field that Tab has left has yet to give its number where it is drawn after this one.
  if (memory.type_in == id && memory.typing_id == 0) {
    memory.type_in = 0;
    start_typing(memory, id, real_text(value));
  }
  fill(window_list(), row.box, field_colour(ui, row), ui.px(6));
  const double shown = std::abs(value) < 0.5 * std::pow(10.0, -spec.decimals) ? 0.0 : value;
  const std::string text =
      shown == 0.0 && !spec.unset.empty() ? spec.unset : fmt::format("{:.{}f}", shown, spec.decimals);
  const float room = row.box.max.x - row.box.min.x - text_size(ui.fonts.body, text).x - ui.px(20);
  draw_row_text(ui.muted(), row.box.min.x + ui.px(8), row, fitted(ui.fonts.body, spec.label, room));
  draw_value(ui, row, text);
  if (row.hovered) ImGui::SetMouseCursor(ImGuiMouseCursor_TextInput);
  return false;
}

bool toggle(const Ui& ui, const RowLabel& label, bool& on) {
  const Pressable row = begin_row(ui, label.text);
  if (row.clicked) on = !on;
  ImDrawList& list = window_list();
  if (row.hovered) fill(list, row.box, ui.colours->field, ui.px(6));
  draw_label(ui, row, label);
  const float height = ui.px(14), width = ui.px(24);
  const glm::vec2 min(row.box.max.x - ui.px(8) - width, std::round(row.box.centre().y - 0.5F * height));
  list.AddRectFilled(min, ImVec2(min.x + width, min.y + height),
                     on ? ui.colours->accent : ui.colours->field_active, 0.5F * height);
  const float knob = 0.5F * height - ui.px(2);
  list.AddCircleFilled(
      ImVec2(on ? min.x + width - 0.5F * height : min.x + 0.5F * height, min.y + 0.5F * height), knob,
      on ? ui.colours->on_accent : ui.colours->muted);
  return row.clicked;
}

bool choice(const Ui& ui, const RowLabel& label, std::span<const std::string_view> words, int& index) {
  ImGui::PushID(label.text.data(), label.text.data() + label.text.size());
  const glm::vec2 start = cursor_at();
  const float width = room_left(), height = ui.px(k_row_height);
  const auto width_of = [&](std::string_view word) { return text_size(ui.fonts.body, word).x + ui.px(12); };
  float total = 0.0F;
  for (const std::string_view word : words) total += width_of(word);
  // Words that have no room beside the name and its dot stand below it, in as many lines as they need.
  const bool below = text_size(ui.fonts.body, label.text).x + ui.px(17) + total > width;
  glm::vec2 at = below ? start + glm::vec2(ui.px(2), height) : glm::vec2(start.x + width - total, start.y);
  ImDrawList& list = window_list();
  draw_label(ui, {.box = {start, start + glm::vec2(width, height)}}, label);
  if (!below) list.AddRectFilled(at, start + glm::vec2(width, height), ui.colours->field, ui.px(6));
  const int before = index;
  const bool focused = has_keyboard(ui, label.text, {start, start + glm::vec2(width, height)});
  // None of the words may be chosen.
  if (const int steps = focused ? value_steps(ui.memory->keyboard) : 0; steps != 0)
    index = std::clamp(index + steps, 0, static_cast<int>(words.size()) - 1);
  ImGui::BeginGroup();
  ImGui::Dummy(ImVec2(width, height));
  for (std::size_t k = 0; k < words.size(); ++k) {
    const float word_width = width_of(words[k]);
    if (below && at.x + word_width > start.x + width) at = {start.x + ui.px(2), at.y + height};
    put_cursor(at);
    ImGui::PushID(static_cast<int>(k));
    const bool clicked = ImGui::InvisibleButton("word", ImVec2(word_width, height));
    const bool chosen = static_cast<int>(k) == index;
    const glm::vec2 min = at, max = at + glm::vec2(word_width, height);
    if (chosen || ImGui::IsItemHovered()) {
      const glm::vec2 inset(ui.px(2), ui.px(2));
      list.AddRectFilled(min + inset, max - inset, chosen ? ui.colours->accent : ui.colours->field_hovered,
                         ui.px(4));
    }
    draw_text(list, {ui.fonts.body, chosen ? ui.colours->on_accent : ui.colours->text},
              at + glm::vec2(ui.px(6), 0.5F * (height - ui.fonts.body.size)), words[k]);
    ui.memory->controls[fmt::format("{}={}", label.text, words[k])] = {min, max};
    if (clicked) index = static_cast<int>(k);
    at.x = max.x;
    ImGui::PopID();
  }
  ImGui::EndGroup();
  ImGui::PopID();
  return index != before;
}

bool button(const Ui& ui, std::string_view label, const ButtonSpec& spec) {
  const std::string_view shown = label.substr(0, label.find("##"));
  const float text_width = text_size(ui.fonts.body, shown).x;
  const Pressable row = begin_row(ui, label, spec.width > 0.0F ? spec.width : text_width + ui.px(24));
  const bool filled = spec.strong || spec.chosen;
  const ImU32 back = filled ? faded(ui.colours->accent, row.hovered ? 0.85F : 1.0F) : field_colour(ui, row);
  fill(window_list(), row.box, back, ui.px(6));
  draw_row_text({ui.fonts.body, filled ? ui.colours->on_accent : ui.colours->text},
                0.5F * (row.box.min.x + row.box.max.x - text_width), row, shown);
  const bool enabled = ImGui::GetStyle().Alpha >= 1.0F;
  return row.clicked || (spec.strong && enabled && ui.memory->keyboard.takes_enter());
}

bool icon_button(const Ui& ui, const IconButtonSpec& spec) {
  const Pressable row = begin_row(ui, spec.id, ui.px(k_row_height));
  if (row.hovered || spec.chosen) fill(window_list(), row.box, field_colour(ui, row), ui.px(6));
  draw_icon(window_list(), spec.icon, 0.5F * (row.box.min + row.box.max), ui.px(14),
            faded(row.hovered ? ui.colours->text : ui.colours->muted, ImGui::GetStyle().Alpha));
  tooltip(ui, {}, spec.tip);
  return row.clicked;
}

bool chip(const Ui& ui, std::string_view label, bool on, bool first) {
  const float width = text_size(ui.fonts.body, label).x + ui.px(18);
  if (!first) {
    ImGui::SameLine(0.0F, ui.px(4));
    if (room_left() < width) ImGui::NewLine();
  }
  const Pressable row = begin_row(ui, label, width);
  ImDrawList& list = window_list();
  const float rounding = 0.5F * (row.box.max.y - row.box.min.y);
  if (on || row.hovered) fill(list, row.box, on ? ui.colours->field_active : ui.colours->field, rounding);
  if (!on) list.AddRect(row.box.min, row.box.max, ui.colours->line, rounding);
  draw_row_text({ui.fonts.body, on ? ui.colours->text : ui.colours->muted}, row.box.min.x + ui.px(9), row,
                label);
  return row.clicked;
}

bool chips(const Ui& ui, std::span<const std::string_view> words, std::vector<std::string_view>& chosen) {
  const auto is_chosen = [&](std::string_view word) {
    return std::find(chosen.begin(), chosen.end(), word) != chosen.end();
  };
  std::vector<std::string_view> after;
  ImGui::BeginGroup();
  for (const std::string_view word : words) {
    const bool on = is_chosen(word);
    const bool clicked = chip(ui, word, on, word == words.front());
    if (on != clicked) after.push_back(word);
  }
  ImGui::EndGroup();
  if (after.size() == chosen.size()) return false;
  chosen = std::move(after);
  return true;
}

bool disclosure(const Ui& ui, std::string_view label, bool open) {
  const Pressable row = begin_row(ui, "disclosure");
  const ImU32 colour = row.hovered ? ui.colours->text : ui.colours->muted;
  draw_row_text({ui.fonts.small, colour}, row.box.min.x + ui.px(8), row, label);
  ImDrawList& list = window_list();
  const glm::vec2 at(row.box.min.x + ui.px(16) + text_size(ui.fonts.small, label).x, row.box.centre().y);
  const float half = ui.px(3), lift = (open ? -0.5F : 0.5F) * half;
  const ImVec2 points[3] = {ImVec2(at.x - half, at.y - lift), ImVec2(at.x, at.y + lift),
                            ImVec2(at.x + half, at.y - lift)};
  list.AddPolyline(points, 3, colour, ImDrawFlags_None, 1.25F * ui.scale);
  return row.clicked;
}

void copy_menu(const Ui& ui, const char* id, const std::string& text, bool asked) {
  if (asked) open_popup_below_item(ui, id);
  if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) open_popup_at_mouse(ui, id);
  if (!begin_popup(ui, id)) return;
  if (menu_item(ui, fmt::format("Copy {}", text))) ImGui::SetClipboardText(text.c_str());
  end_popup(ui);
}

}  // namespace moldlight::gui
