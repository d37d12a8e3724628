// ImGui's context with its renderer, in the window's style and fonts.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "gui/draw/ui.hpp"
#include "render/view_settings.hpp"

struct ImGuiContext;

namespace moldlight::gui {

/// A GL context must be current at every call. ImGui's own files are off: places of panels are the app's
/// matter.
class ImguiSession {
 public:
  ImguiSession();
  ~ImguiSession();
  ImguiSession(const ImguiSession&) = delete;
  ImguiSession& operator=(const ImguiSession&) = delete;

  /// Renders fonts anew if the scale changed; call it before NewFrame of the platform.
  void prepare(Theme theme, float scale);
  /// Starts ImGui's frame; `ui` is valid until the next one. `key`: what was pressed for the controls.
  const Ui& begin_frame(double now_s, ControlKey key);
  /// Ends the frame and draws it into the framebuffer that is bound.
  void draw();
  /// What the controls of the last frame have left.
  [[nodiscard]] const UiMemory& memory() const { return memory_; }
  [[nodiscard]] UiMemory& memory() { return memory_; }
  /// When the controls want the next frame at the latest; infinity for not at all.
  [[nodiscard]] double wake_s() const { return memory_.wake_s; }

 private:
  ImGuiContext* context_;
  std::optional<Theme> theme_;
  std::vector<std::string> font_bytes_;
  UiMemory memory_;
  Ui ui_;
};

}  // namespace moldlight::gui
