// Which control has the keyboard, and which popups are open.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec2.hpp>
#include <imgui.h>

namespace moldlight::gui {

struct Ui;

/// Where something is drawn, pixels.
struct ScreenBox {
  glm::vec2 min{0.0F}, max{0.0F};
  [[nodiscard]] glm::vec2 centre() const { return 0.5F * (min + max); }
  [[nodiscard]] bool contains(const glm::vec2& at) const {
    return at.x >= min.x && at.x < max.x && at.y >= min.y && at.y < max.y;
  }
};

/// What a key asks of controls and lists.
enum class ControlKey : std::uint8_t {
  none,
  next,    // control: Tab
  former,  // Shift + Tab
  press,   // Space, Enter
  left,
  right,
  up,
  down,
  page_up,
  page_down,
  home,
  end,
  erase,  // Backspace
};

/// Tab walks through the controls in the order in which they are drawn: through those of the topmost dialog
/// or popup alone, where one is open.
class Keyboard {
 public:
  /// Moves the focus by the key of this frame, or keeps the key for the control that takes it. `clicked`: the
  /// mouse takes over.
  void begin_frame(ControlKey key, bool clicked);

  /// To be called for each control that is drawn; true for the one that has the keyboard.
  bool visit(ImGuiID control);
  /// Whether this key was pressed for whom asks first.
  bool takes(ControlKey key);
  /// The same for Enter where no control has the keyboard: the button of a dialog that it stands for.
  bool takes_enter() { return layer_ > 0 && focus_ == 0 && takes(ControlKey::press); }
  /// As if Enter had been pressed where no control has the keyboard.
  void enter() {
    focus_ = 0;
    key_ = ControlKey::press;
  }
  /// The rows that a list's selection moves by: up and down by one, pages by `page`, home and end by `count`.
  [[nodiscard]] int takes_steps(int page, int count);
  void give_to(ImGuiID control) { focus_ = control; }

  /// Whether any control has the keyboard.
  [[nodiscard]] bool focused() const { return focus_ != 0; }
  [[nodiscard]] bool focused(ImGuiID control) const { return focus_ == control; }
  /// Whether Tab has moved it in this frame.
  [[nodiscard]] bool arrived() const { return arrived_; }

  /// Around the controls of a dialog or popup.
  void enter_layer() { ++layer_; }
  void leave_layer() { --layer_; }

 private:
  void step(int by);

  ImGuiID focus_ = 0;
  ControlKey key_ = ControlKey::none;
  bool arrived_ = false;
  std::vector<ImGuiID> order_, drawn_;  // of the last frame, and of this one so far
  int layer_ = 0, top_ = 0;
};

/// The popups that are open, each opened from the one before.
class Popups {
 public:
  /// Closes those in which a press was not made.
  void begin_frame();
  /// Below a box in pixels, or above it where there is no room; not if this very click has just closed it.
  void open(ImGuiID popup, const ScreenBox& beside);
  void close_all() { open_.clear(); }
  /// The innermost one; false where none is open.
  bool close_one();
  [[nodiscard]] bool any() const { return !open_.empty(); }

 private:
  friend bool begin_popup(const Ui& ui, const char* id, float width);
  friend void end_popup(const Ui& ui);
  struct Open {
    ImGuiID id = 0;
    ScreenBox beside;
    ScreenBox box = {};  // where it was drawn last
  };
  std::vector<Open> open_;
  std::size_t depth_ = 0;  // of the one that is being drawn
  ImGuiID just_closed_ = 0;
};

}  // namespace moldlight::gui
