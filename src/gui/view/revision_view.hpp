// Another revision of the part beside it: its picture under the tied camera, what is lit on both, what is
// said at the cursor, and from where a change is seen.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gl/objects.hpp"
#include "gui/app_state.hpp"
#include "gui/draw/ui.hpp"
#include "gui/view/candidate_pictures.hpp"
#include "gui/view/scene.hpp"

namespace moldlight::gui {

/// Takes what is in the unit frame of the one part to that of the other: both are seen at one scale, where
/// they lie.
struct FrameTie {
  UnitFrame from, to;

  [[nodiscard]] glm::dvec3 point(const glm::dvec3& unit) const {
    return (from.center + from.diagonal * unit - to.center) / to.diagonal;
  }
  [[nodiscard]] Camera camera(Camera camera) const;
  [[nodiscard]] CutPlane plane(CutPlane plane) const;
};
/// From the window's part to the other revision.
[[nodiscard]] FrameTie tie_of(const AppState& state, const PreparedRevision& revision);

/// Of a split window, how far the right half's picture stands beside the left one's, pixels.
[[nodiscard]] float picture_shift(const SplitView& split, const glm::ivec2& window, int side);

/// Brings what lies on the part's surface nearer to the eye in a way that moves nothing on the screen.
[[nodiscard]] glm::dmat4 nearer(const Camera& camera);
/// Whether what is lit is known and of the part that is seen.
[[nodiscard]] bool is_lit(const AppState& state);

/// A surface of the part as a body to be drawn over the picture, with both its sides: what faces away shines
/// through the part.
[[nodiscard]] ViewBody lit_body(const PartModel& model, const SplitMesh& surface, Colour colour,
                                const std::optional<CutPlane>& cut);

/// What is under the cursor there.
[[nodiscard]] RevisionHover revision_hover(const AppState& state, bool second, const PickedPoint& point);
/// What is said of it; nothing where nothing changed.
[[nodiscard]] std::vector<std::string> revision_lines(const AppState& state);

/// What a picture of a change is to show, in the unit frame of the window's part; and from where most of it
/// is seen.
[[nodiscard]] std::vector<glm::vec3> surroundings(const AppState& state, const RevisionChange& change);
[[nodiscard]] glm::dquat seen_from(const AppState& state, std::size_t change);

/// The names of both above their pictures.
void draw_revision_names(const Ui& ui, const AppState& state, const SplitView& split, int side);

/// Keeps the bodies of what is lit on one of both parts up to date.
class LitBodies {
 public:
  /// None where nothing is lit.
  [[nodiscard]] const std::shared_ptr<const std::vector<ViewBody>>& of(const AppState& state, bool second,
                                                                       const std::optional<CutPlane>& cut);

 private:
  std::shared_ptr<const Revisions> result_;
  std::optional<std::size_t> chosen_;
  std::optional<CutPlane> cut_;
  std::shared_ptr<const std::vector<ViewBody>> bodies_;
};
/// Where such bodies are drawn over a picture; out of sight that of other regions, while they are those of
/// another direction.
[[nodiscard]] std::vector<glm::dmat4> lit_places(const AppState& state, const Camera& camera);

/// The other revision on the GL. Needs its context current at every call.
class RevisionPicture {
 public:
  RevisionPicture(const gl::Context& context, std::shared_ptr<const PreparedRevision> revision);

  /// Draws as the window's part is drawn with these settings; returns true while drawing the same again would
  /// refine it.
  bool draw(const AppState& state, const SplitView& split, SceneSettings settings);
  /// The texture that it is drawn into.
  [[nodiscard]] unsigned beside(const glm::ivec2& size) { return sized(target_, *context_, size).texture(); }
  /// What it shows at a pixel of its half.
  [[nodiscard]] std::optional<PickedPoint> pick(const glm::ivec2& pixel) const { return scene_.pick(pixel); }
  [[nodiscard]] const std::shared_ptr<const PreparedRevision>& of() const { return revision_; }

 private:
  const gl::Context* context_;
  std::shared_ptr<const PreparedRevision> revision_;
  Scene scene_;
  LitBodies lit_;
  std::optional<gl::ColourTarget> target_;
};

}  // namespace moldlight::gui
