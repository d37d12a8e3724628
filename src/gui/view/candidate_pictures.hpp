// Pictures of the directions that a sweep found: a small one each, and a large one beside the window's own.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "base/job.hpp"
#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gui/draw/ui.hpp"
#include "gui/jobs/loaded_part.hpp"
#include "gui/view/scene.hpp"
#include "io/file_contents.hpp"
#include "render/view_settings.hpp"
#include "sweep/sweep_result.hpp"

namespace moldlight::gui {

/// Pictures of which some may still be missing.
using PictureTargets = std::vector<std::optional<gl::ColourTarget>>;
/// Names of their textures; 0 for those that are missing.
[[nodiscard]] std::vector<unsigned> textures_of(const PictureTargets& pictures);
/// The picture, which is made anew where it has another size or is missing.
[[nodiscard]] gl::ColourTarget& sized(std::optional<gl::ColourTarget>& picture, const gl::Context& context,
                                      const glm::ivec2& size);

/// Needs its context current at every call.
class PartThumbnails {
 public:
  PartThumbnails(const gl::Context& context, std::vector<std::string> parts, std::function<void()> wake);

  /// Goes on with the work; call it every frame in which the pictures are to be seen.
  void update(int size_px, Theme theme);
  /// One texture a part, in their order; 0 where there is none yet.
  [[nodiscard]] std::vector<unsigned> textures() const { return textures_of(pictures_); }
  [[nodiscard]] bool finished() const { return next_ >= parts_.size(); }

 private:
  const gl::Context* context_;
  std::vector<std::string> parts_;
  PictureTargets pictures_;
  Job<LoadedPart> job_;
  std::size_t next_ = 0;  // the part that is loaded next or now
  int size_px_ = 0;
  Theme theme_ = Theme::dark;
};

/// Needs its context current at every call.
class BatchPictures {
 public:
  BatchPictures(const gl::Context& context, std::string batch_folder);

  /// A few pictures are read in a frame; call it at the frame's beginning.
  void begin_frame() { read_ = 0; }
  /// 0 while it is not there yet, and for a picture that cannot be read.
  [[nodiscard]] unsigned texture(const Digest& key);
  /// True if one was asked for in this frame that another frame is to read.
  [[nodiscard]] bool unfinished() const { return read_ > k_a_frame; }

 private:
  static constexpr int k_a_frame = 6;

  const gl::Context* context_;
  std::string folder_;
  std::unordered_map<Digest, gl::Texture, DigestHash> textures_;
  int read_ = 0;  // asked for in this frame
};

/// Small pictures of the bodies of a file. Needs its context current at every call.
class BodyPictures {
 public:
  BodyPictures(const gl::Context& context, std::shared_ptr<const LoadedPart> whole);

  /// One picture is drawn in a frame; call it at the frame's beginning.
  void begin_frame() { asked_ = 0; }
  /// 0 while it is not there yet. `scale`: pixels per layout unit.
  [[nodiscard]] unsigned texture(std::size_t body, Theme theme, float scale);
  /// True if one was asked for in this frame that another frame is to draw.
  [[nodiscard]] bool unfinished() const { return asked_ > 1; }
  [[nodiscard]] const std::shared_ptr<const LoadedPart>& of() const { return whole_; }

  /// Layout units.
  static constexpr glm::vec2 k_size{48.0F, 36.0F};

 private:
  const gl::Context* context_;
  std::shared_ptr<const LoadedPart> whole_;
  PartBuffers buffers_;
  PartView view_;
  PictureTargets pictures_;
  Theme theme_ = Theme::dark;
  glm::ivec2 size_{0};
  int asked_ = 0;  // in this frame, and not there
};

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
  [[nodiscard]] std::vector<unsigned> textures() const { return textures_of(small_); }

  /// Draws the large picture; returns true while drawing the same again would refine it. Its split mesh is
  /// found in the background; until it is there, regions are those of the maps.
  bool draw_beside(const SplitView& split, SceneSettings settings);
  /// Texture of the large picture, which gets this size.
  [[nodiscard]] unsigned beside(const glm::ivec2& size) { return sized(beside_, *context_, size).texture(); }

  [[nodiscard]] const std::shared_ptr<const SweepResult>& result() const { return result_; }

 private:
  const gl::Context* context_;
  std::shared_ptr<const SweepResult> result_;
  Scene scene_;
  struct Split {
    Query of;
    std::shared_ptr<const SplitMesh> mesh;
  };
  PictureTargets small_;
  std::optional<gl::ColourTarget> beside_;
  Theme theme_ = Theme::dark;
  Palette palette_ = Palette::paper;
  std::optional<Query> wanted_;
  std::optional<Split> split_;
  Job<Split> job_;
};

}  // namespace moldlight::gui
