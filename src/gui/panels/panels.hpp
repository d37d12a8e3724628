// The panels, one file each. Each reads the state and writes what its user wants into the edits. Those that
// remember something are in workspace.hpp.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "classify/number_format.hpp"
#include "gui/app_state.hpp"
#include "gui/commands.hpp"
#include "gui/draw/bottom_panel.hpp"
#include "gui/draw/panel_layout.hpp"
#include "gui/view/direction.hpp"
#include "parting/halves_words.hpp"

namespace moldlight::gui {

/// What a panel draws with and into.
struct PanelContext {
  const Ui& ui;
  const AppState& state;
  Edits& edits;
  PanelLayout& layout;

  /// What the panels leave free.
  [[nodiscard]] FreeArea free_area() const { return layout.free_area(state.dialogs.panels_hidden); }
};

/// The texture of a picture by its place; 0 where there is none yet.
using PictureOf = std::function<unsigned(std::size_t)>;

/// What the ball remembers while it is dragged.
struct BallDrag {
  bool active = false;
  bool gripped = false;  // by its marker
  bool back = false;     // on the side away from the viewer
  glm::vec2 grip{0.0F};  // from the cursor to the marker, pixels
};

/// Options that the panel of the shadow maps shows, and those under its Accuracy; other panels show the rest
/// of their tables.
inline constexpr std::array<std::string_view, 4> k_map_options = {"kernel", "kernel_shape", "edge_thickness",
                                                                  "resolution"};
inline constexpr std::array<std::string_view, 2> k_map_look_options = {"regions", "mark_difference"};
inline constexpr std::array<std::string_view, 3> k_accuracy_options = {"readout", "samples", "backend"};

void draw_top_bar(const PanelContext& context);
/// The steps, as items of the window that is open, from the cursor on; and how wide that is, pixels.
void draw_strip(const PanelContext& context);
[[nodiscard]] float strip_width(const PanelContext& context);
/// Ball, axes, fields: into the panel that is open.
void draw_direction_controls(const PanelContext& context, BallDrag& drag);
/// The numbers alone.
void draw_direction_fields(const PanelContext& context);
/// The ball with all that is on it, as an item of the window that is open; `size` in pixels.
void draw_ball(const PanelContext& context, BallDrag& drag, float size);
/// What the file has, and what is asked of its facets: into the panel that is open.
class BodiesPanel;
void draw_part_controls(const PanelContext& context, BodiesPanel& bodies, const PictureOf& pictures);
void draw_look_panel(const PanelContext& context);
/// The colours of the draft angles with their limits.
void draw_draft_key(const PanelContext& context);
/// How far the mold is open.
void draw_opening(const PanelContext& context);
/// The shadow maps with the controls of their method, along the bottom.
void draw_maps_drawer(const PanelContext& context, const std::function<MapTextures(int)>& textures);
/// How far the shadow maps are from exact regions, while the regions come from them; two lines of small text.
void draw_map_comparison(const PanelContext& context);
/// A path beside the part, named after it.
[[nodiscard]] std::string beside_part(const AppState& state, const char* ending);
void draw_regions_panel(const PanelContext& context);
void draw_chosen_face(const PanelContext& context);
void draw_cursor_readout(const PanelContext& context);
/// What the readout says of what is under the cursor; nothing beside the part.
[[nodiscard]] std::vector<std::string> readout_lines(const AppState& state);
/// With a degree sign; what prints as nothing has no sign.
[[nodiscard]] std::string draft_text(double draft_deg);
/// The line between the places that were clicked, or from the first to the cursor, with what was measured.
void draw_measuring(const PanelContext& context);
void draw_view_cube(const PanelContext& context);
void draw_loading(const PanelContext& context);
void draw_toasts(const PanelContext& context);
/// The caption of a presentation.
void draw_presented(const PanelContext& context);
void draw_hints(const PanelContext& context);
void draw_settings(const PanelContext& context);
/// Asks what a part dropped beside another one is to be.
void draw_dropped(const PanelContext& context);
void draw_large_map(const PanelContext& context, const std::function<MapTextures(int)>& textures);
/// Cards of recommended directions, one below the other, as items of the window that is open; a click turns
/// to one. `pictures`: a texture a candidate of the sweep's result; 0, or too few of them, where there is
/// none yet.
void draw_direction_cards(const PanelContext& context, std::span<const unsigned> pictures);

/// What the table takes of the window's upper part, layout units.
inline constexpr float k_comparison_height = 164.0F;

/// The figures of two directions that are seen side by side, and their difference.
void draw_comparison(const PanelContext& context);

/// Side of the shipped parts' pictures, layout units.
inline constexpr float k_start_picture_size = 124.0F;

/// What the window shows before there is a part. `thumbnails`: textures of the shipped parts, in their order;
/// 0 where there is none yet.
void draw_start_page(const PanelContext& context, std::span<const unsigned> thumbnails);

/// A ball of directions on the screen, pixels, as a camera sees it.
struct Ball {
  ImDrawList& list;
  const Camera& camera;
  glm::vec2 centre{0.0F};
  float radius = 1.0F;

  [[nodiscard]] BallPoint point(const glm::dvec3& direction) const { return ball_point(camera, direction); }
  [[nodiscard]] glm::vec2 screen(const BallPoint& point) const {
    return centre + radius * glm::vec2(point.at.x, -point.at.y);
  }
  [[nodiscard]] glm::dvec2 disc(const glm::vec2& pixel) const {
    return {(pixel.x - centre.x) / radius, (centre.y - pixel.y) / radius};
  }
};

/// The ball's surface in the colours of the map; where nothing is known yet (or there is no map) in those of
/// its lit and its dark side.
struct BareBall {
  ImU32 light = 0, dark = 0;
};
void draw_sphere(const Ball& ball, const SweepMap* map, const BareBall& bare);
/// The circle of directions `angle_deg` away from the unit direction `axis`, as far as it is on the viewer's
/// side.
struct Stroke {
  ImU32 colour;
  float thickness;
};
void draw_circle(const Ball& ball, const glm::dvec3& axis, double angle_deg, const Stroke& stroke);
/// Rings around the best directions, dots on those that tie with them, circles of the tilt margins.
void draw_sweep_marks(const Ui& ui, const Ball& ball, const SweepState& sweep);
/// A tooltip with what is known of the direction under the mouse.
void describe_direction(const PanelContext& context, const glm::dvec3& direction);
/// The scale of the colours with its ends, `width` pixels wide; returns its height.
float draw_colour_bar(const PanelContext& context, const glm::vec2& at, float width);

/// The ball on its own, large, beside the part.
void draw_large_ball(const PanelContext& context, BallDrag& drag);

/// The light of the verdict's card: green for a two-plate mold, amber for side actions or marks that are
/// ignored, red where nothing releases an undercut, gray where that is not known.
enum class VerdictLight : std::uint8_t { gray, green, amber, red };

/// The study's verdict as the window shows it.
struct VerdictCard {
  std::optional<Verdict> verdict;  // none while nothing is measured, or the direction moves
  std::string sentence;            // its sentence, or what is known meanwhile
  bool red = false;                // the picture shows undercut, be it ignored or of the maps alone

  /// Shown with a tick.
  [[nodiscard]] bool good() const { return verdict && verdict->good() && !red; }
  /// Green no more than a tick while there is red in the picture.
  [[nodiscard]] VerdictLight light() const;
};
[[nodiscard]] VerdictCard verdict_card(const AppState& state);
/// Of a verdict where nothing else is seen of its part.
[[nodiscard]] VerdictLight light_of(VerdictState state);
[[nodiscard]] ImU32 light_colour(VerdictLight light);

/// "1 slide, 2 lifters · 49.2 mm² unreleased"; what comes of the plan of side actions.
[[nodiscard]] std::string actions_summary(const AppState& state);

/// At the top of the legend.
void draw_verdict(const PanelContext& context);

/// Why there are no halves, where, and what to change; empty where there are. The solids must be there.
[[nodiscard]] std::string halves_refusal(const AppState& state);

/// What is said of the halves; nothing while they are not there.
[[nodiscard]] std::vector<HalvesLine> halves_lines(const AppState& state);

/// What is said of a face with too little draft; none where it has enough, or while that is not known.
/// `side`: the half that forms it, where that matters.
[[nodiscard]] const WallDraft* wall_of_face(const AppState& state, std::uint32_t face,
                                            std::optional<MoldSide> side = {});

/// In the scene of the draft's step: the foot line of the wall under the cursor or chosen, and what a click
/// gives.
void draw_draft_marks(const PanelContext& context);

}  // namespace moldlight::gui
