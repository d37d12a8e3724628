// The mouse on the part: turning, shifting, zooming, the direction's arrow, picking.
#pragma once

#include <cstdint>
#include <optional>

#include "gui/app_state.hpp"
#include "gui/commands.hpp"
#include "gui/draw/panel_layout.hpp"
#include "gui/draw/ui.hpp"
#include "gui/view/scene.hpp"

namespace moldlight::gui {

/// What a drag of the mouse does to the camera.
enum class Gesture : std::uint8_t { none, orbit, pan, zoom };

/// What the mouse needs to know of the picture.
struct SceneFrame {
  glm::ivec2 size{0};       // pixels
  FreeArea free;            // of it
  double open_mold = 0.0;   // as it is shown, [0, 1]
  bool line_shown = false;  // the mold's parting line
  // Of another revision's picture in the right half: where it begins, and how far it stands beside the left
  // one's; pixels.
  std::optional<int> second_from = {};
  float second_shift = 0.0F;

  [[nodiscard]] bool in_second(const glm::vec2& at) const {
    return second_from && at.x >= static_cast<float>(*second_from);
  }
  /// The place in the left picture that shows what is seen there.
  [[nodiscard]] glm::vec2 in_first(const glm::vec2& at) const {
    return in_second(at) ? at - glm::vec2(second_shift, 0.0F) : at;
  }
};

/// Where the line between regions of maps and exact ones is, pixels from the window's left.
[[nodiscard]] double divider_place(double divider, const FreeArea& free);

/// An arrow on the screen.
struct ArrowOnScreen {
  glm::vec2 tail{0.0F}, tip{0.0F};  // pixels
  bool toward_viewer = true;
};

class Viewport {
 public:
  /// Reads ImGui's mouse and edits camera and direction; call it before the panels of the frame.
  void handle_mouse(const Ui& ui, const AppState& state, const SceneFrame& frame, Edits& edits);
  /// Writes the arrows' names, and marks the tip that can be grabbed, behind the panels.
  void draw_arrow_names(const Ui& ui, const AppState& state, const SceneFrame& frame) const;

  /// True if the surface under the cursor is to be reported: the mouse is on the scene and drags nothing.
  [[nodiscard]] bool hovers() const { return hovers_; }
  [[nodiscard]] bool dragging() const { return gesture_ != Gesture::none || drag_; }
  void give_up_drag() { drag_.reset(); }

 private:
  enum class Arrow : std::uint8_t { core, cavity, section, side, height, divider };
  struct ArrowDrag {
    Arrow arrow = Arrow::core;
    bool front = true;     // it was grabbed on the viewer's side
    glm::vec2 grip{0.0F};  // from the cursor to the tip, pixels
    double place = 0.0;    // a section's or the parting height, when it was grabbed
  };
  void start(const AppState& state, const SceneFrame& frame, int button);
  void move_camera(const Ui& ui, const SceneFrame& frame, Edits& edits) const;
  void drag_direction(const AppState& state, const SceneFrame& frame, Edits& edits) const;
  void drag_side(const AppState& state, const SceneFrame& frame, Edits& edits) const;
  static void drag_height(const AppState& state, const SceneFrame& frame, const ArrowDrag& held,
                          Edits& edits);
  void drag_section(const AppState& state, const SceneFrame& frame, Edits& edits) const;
  static std::optional<ViewArrow> arrow_in_scene(const AppState& state, const SceneFrame& frame, Arrow which);
  static std::optional<ArrowOnScreen> arrow(const AppState& state, const SceneFrame& frame, Arrow which);

  Gesture gesture_ = Gesture::none;
  int button_ = 0;  // ImGui's, of the gesture
  glm::dvec3 pivot_{0.0};
  struct Press {
    std::optional<PickedPoint> point;   // of the part
    std::optional<std::size_t> change;  // from another revision
    std::optional<std::size_t> loop;    // of the parting line
  };
  void draw_loop(const Ui& ui, const AppState& state) const;
  void draw_divider(const Ui& ui, const AppState& state, const FreeArea& free) const;
  std::optional<Press> press_;  // of the left button on the scene, until the mouse drags
  std::optional<ArrowDrag> drag_;
  std::optional<Arrow> near_tip_;         // whose tip is under the cursor
  std::optional<std::size_t> near_loop_;  // of the parting line, under the cursor
  bool hovers_ = false;
};

}  // namespace moldlight::gui
