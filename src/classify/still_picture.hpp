// Still pictures of a classified part: what the window's viewport shows, with a legend.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/gtc/quaternion.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "base/image.hpp"
#include "base/progress.hpp"
#include "classify/classification.hpp"
#include "classify/method_options.hpp"
#include "classify/option.hpp"
#include "classify/picture_maps.hpp"
#include "gl/context.hpp"
#include "render/part_view.hpp"

namespace moldlight {

/// Automatic: with the parting direction upward, from where the undercuts are seen best. The others are the
/// views of the part's own axes, z up.
enum class PictureView : std::uint8_t { automatic, isometric, front, back, left, right, top, bottom };

inline constexpr int k_least_picture_px = 16, k_most_picture_px = 16384;  // along a side

/// A number that names a place of the part: the first of `places` (in its unit, one at least) that is seen.
struct StillCallout {
  std::string text;
  std::vector<glm::dvec3> places;
  glm::dvec3 normal{0.0};  // of the surface at the first place; zero at an edge
};

struct StillSettings {
  glm::ivec2 size{1600, 1000};  // pixels, in that range each
  PictureView view = PictureView::automatic;
  Theme theme = Theme::light;
  LookSettings look = {};
  bool legend = true;                        // left out where a picture is too small for it
  std::optional<glm::dquat> seen_from = {};  // orientation of the camera of an automatic view
  Backdrop backdrop = Backdrop::gradient;
  std::vector<glm::vec3> focus = {};  // unit frame: what the picture is to hold; empty: all of the part
  std::vector<StillCallout> callouts = {};
  bool scale_bar = false;  // of the plane through what the camera looks at
  /// Lines over the part, unit frame, and what of them is lit.
  std::vector<ViewSegment> line = {}, lit_line = {};
};

/// For help and command line: view and theme.
[[nodiscard]] std::span<const Option<StillSettings>> still_options();

/// A size from "WxH" in pixels, `least` to k_most_picture_px a side; throws UsageError that names `what`.
[[nodiscard]] glm::ivec2 parse_picture_size(std::string_view text, std::string_view what,
                                            const glm::ivec2& least = glm::ivec2(k_least_picture_px));

/// Throws UsageError for a size out of range.
void validate(const StillSettings& settings);

/// A solid that is shown beside the part, translucent; what names it stands on it.
struct StillBody {
  TriangleMesh mesh;
  glm::dmat4 motion{1.0};  // to where it is shown, in the part's unit
  Colour colour;
  std::string label;
};

/// Draws still pictures of one part. `context` must be current at every call and outlive it.
class StillPainter {
 public:
  StillPainter(const gl::Context& context, std::shared_ptr<const PartModel> model);

  /// From where the undercuts of all these classifications, which must have their split mesh, are seen best,
  /// with the direction of the first upward.
  [[nodiscard]] glm::dquat seen_best(std::span<const Classification> results) const;
  /// The part's exact regions for the classification's settings, or those of the shadow maps. Throws
  /// UsageError, Error, Cancelled.
  [[nodiscard]] Image draw(const Classification& result, const StillSettings& settings,
                           const Progress& progress, std::span<const StillBody> bodies = {});

 private:
  const gl::Context* context_;
  std::shared_ptr<const PartModel> model_;
  ViewGeometry geometry_;
  PictureMaps maps_;
  PartView view_;
};

/// Orientation of a camera (render/camera.hpp) with `up` (unit) upward, from the side on which most undercut
/// surface is seen, each bit of it counted by how frontal it is; without undercuts, on which most surface of
/// any kind is. `splits` are the part's mesh split for one parting direction or several, each of which counts
/// the same. The same for the same input, whatever the number of threads.
[[nodiscard]] glm::dquat revealing_orientation(const PartModel& model,
                                               std::span<const std::shared_ptr<const SplitMesh>> splits,
                                               const glm::dvec3& up);

}  // namespace moldlight
