// The panels, one file each. Each reads the state and writes what its user wants into the edits.
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "gui/app_state.hpp"
#include "gui/edits.hpp"
#include "gui/panel_layout.hpp"
#include "gui/ui.hpp"

namespace moldlight::gui {

/// What a panel draws with and into.
struct PanelContext {
  const Ui& ui;
  const AppState& state;
  Edits& edits;
  PanelLayout& layout;
};

/// What the ball remembers while it is dragged.
struct BallDrag {
  bool active = false;
  bool gripped = false;  // by its marker
  bool back = false;     // on the side away from the viewer
  glm::vec2 grip{0.0F};  // from the cursor to the marker, pixels
};

/// Textures for ImGui; 0 for none.
struct MapTextures {
  unsigned plus = 0, minus = 0;
};

/// Options that the panel of the shadow maps shows, and those under the method's Accuracy; other panels show
/// the rest of their tables.
inline constexpr std::array<std::string_view, 4> k_map_options = {"kernel", "kernel_shape", "edge_thickness",
                                                                  "resolution"};
inline constexpr std::array<std::string_view, 2> k_map_look_options = {"regions", "mark_difference"};
inline constexpr std::array<std::string_view, 4> k_accuracy_options = {"tolerance", "readout", "samples",
                                                                       "backend"};

void draw_top_bar(const PanelContext& context);
void draw_direction_panel(const PanelContext& context, BallDrag& drag);
/// The ball with all that is on it, as an item of the window that is open; `size` in pixels.
void draw_ball(const PanelContext& context, BallDrag& drag, float size);
void draw_method_panel(const PanelContext& context);
void draw_look_panel(const PanelContext& context);
void draw_maps_panel(const PanelContext& context, const MapTextures& textures);
/// How far the shadow maps are from exact regions, while they tell the regions; two lines of small text.
void draw_map_comparison(const PanelContext& context);
void draw_regions_panel(const PanelContext& context);
void draw_status(const PanelContext& context);
void draw_view_cube(const PanelContext& context);
void draw_loading(const PanelContext& context);
void draw_toasts(const PanelContext& context);
void draw_help(const PanelContext& context);
void draw_settings(const PanelContext& context);
void draw_large_map(const PanelContext& context, const MapTextures& textures);

}  // namespace moldlight::gui
