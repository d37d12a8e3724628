// The mold as the scene has it: the loop that is looked at, the handle of the parting height, faces that go
// from one half to the other.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "gui/app_state.hpp"
#include "gui/draw/panel_layout.hpp"
#include "gui/draw/ui.hpp"

namespace moldlight::gui {

/// The loop of another line that is this one of the former line; nothing where there is none near it.
[[nodiscard]] std::optional<std::size_t> nearest_loop(const MoldLine& line, const MoldLine& former,
                                                      std::size_t loop);
/// What a picture of a loop is to show, unit frame.
[[nodiscard]] std::vector<glm::vec3> surroundings(const MoldLine& line, std::size_t loop);

/// A place in the picture, and the surface that is seen there, in the unit frame; none beside the part.
struct LinePick {
  glm::ivec2 size{0};
  glm::dvec2 at{0.0};  // pixels
  double reach_px = 0.0;
  std::optional<glm::dvec3> surface;
};
/// The loop whose tube is there and not hidden, the nearest to the place; none where there is none.
[[nodiscard]] std::optional<std::size_t> loop_under(const MoldLine& line, const Camera& camera,
                                                    const LinePick& pick);
/// What is said of a loop at the cursor: "Loop 3: shut-off", and its figures.
[[nodiscard]] std::array<std::string, 2> loop_lines(const AppState& state, std::size_t loop);

/// The corners of the block of steel around the part, unit frame.
[[nodiscard]] std::vector<glm::vec3> block_corners(const AppState& state);

/// By which the height at which the halves meet is held: beside the part, with an outline around it there.
/// Unit frame.
struct HeightHandle {
  glm::dvec3 at{0.0};
  std::array<glm::dvec3, 4> outline{};
};
/// While the panel of the mold is open, and the mold closed. `free`: what no panel covers.
[[nodiscard]] std::optional<HeightHandle> height_handle(const AppState& state, const FreeArea& free);
/// The height that is given, or the one that was found, along the direction in the part's coordinates.
[[nodiscard]] double parting_height(const AppState& state);
/// The least and the greatest height of the part.
struct HeightRange {
  double low = 0.0, high = 0.0;
};
[[nodiscard]] HeightRange height_range(const AppState& state);
/// `lively`: under the cursor or dragged.
void draw_height_handle(const Ui& ui, const AppState& state, const FreeArea& free, bool lively);

/// What forms a face now, of its area that may go to either half.
struct FaceHalves {
  double core = 0.0, cavity = 0.0;                            // that may
  double fixed_core = 0.0, fixed_cavity = 0.0, action = 0.0;  // the rest
};
/// Of the line that is shown, which must be there.
[[nodiscard]] FaceHalves halves_of_face(const AppState& state, std::uint32_t face);

}  // namespace moldlight::gui
