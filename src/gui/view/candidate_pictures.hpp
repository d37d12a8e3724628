// Pictures of the directions that a sweep found: a small one each, and a large one beside the window's own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "base/job.hpp"
#include "gl/objects.hpp"
#include "gui/draw/ui.hpp"
#include "gui/view/scene.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight::gui {

/// What the window shows beside its own picture when two directions are compared.
struct SplitView {
  std::size_t candidate = 0;
  int left = 0;        // where its half begins, pixels
  glm::ivec2 size{0};  // of its half
  Camera camera;       // of its half
};

/// The left half keeps the window's camera. `side`: width of the panels on either side, pixels.
[[nodiscard]] SplitView split_view_of(const Camera& camera, const glm::ivec2& window, std::size_t candidate,
                                      int side);

/// Lays the picture of the other direction over the window's own, behind the panels. `texture` is drawn later
/// in the frame.
void draw_split(const Ui& ui, const SplitView& split, unsigned texture);

/// Needs its context current at every call. Has a scene of its own, so that the window's keeps its maps.
class CandidatePictures {
 public:
  /// `wake` is called from another thread when there is something new to draw.
  CandidatePictures(const gl::Context& context, const LoadedPart& part,
                    std::shared_ptr<const SweepResult> result, std::function<void()> wake);

  /// Draws one of the small pictures that are missing for this look and size; the palette and the theme of
  /// `view` count. Returns true while more are missing.
  bool draw_next(const ViewSettings& view, const glm::ivec2& size_px);
  /// Names of textures, a candidate each; 0 until it is drawn.
  [[nodiscard]] std::vector<unsigned> textures() const;

  /// Draws the large picture; returns true while drawing the same again would refine it. Its split mesh is
  /// found in the background; until it is there, regions are those of the maps.
  bool draw_beside(const SplitView& split, SceneSettings settings);
  /// Size and texture of the large picture.
  [[nodiscard]] unsigned beside(const glm::ivec2& size) {
    if (!beside_ || beside_->size() != size) beside_.emplace(context_->functions(), size);
    return beside_->texture();
  }

  [[nodiscard]] const std::shared_ptr<const SweepResult>& result() const { return result_; }

 private:
  const gl::Context* context_;
  std::shared_ptr<const SweepResult> result_;
  Scene scene_;
  struct Split {
    Query of;
    std::shared_ptr<const SplitMesh> mesh;
  };
  std::vector<std::optional<gl::ColourTarget>> small_;
  std::optional<gl::ColourTarget> beside_;
  Theme theme_ = Theme::dark;
  Palette palette_ = Palette::paper;
  std::optional<Query> wanted_;
  std::optional<Split> split_;
  Job<Split> job_;
};

}  // namespace moldlight::gui
