// The part in the window: its buffers, maps and picture on the window's context, drawn anew only as far as
// something changed. And where the camera goes.
#pragma once

#include <memory>
#include <optional>
#include <set>
#include <span>
#include <vector>

#include "classify/map_comparison.hpp"
#include "classify/picture_maps.hpp"
#include "gl/context.hpp"
#include "gl/objects.hpp"
#include "gui/app_state.hpp"
#include "gui/draw/panel_layout.hpp"
#include "render/readout_passes.hpp"
#include "render/view_geometry.hpp"
#include "render/view_passes.hpp"

namespace moldlight::gui {

/// What the picture shows, beside the part.
struct SceneSettings {
  Query query;
  View view;
  bool direction_moves = false;                 // maps may be coarser than the method's
  bool maps_looked_at = false;                  // they are to be the method's own once the direction rests
  std::shared_ptr<const SplitMesh> split;       // for the query; none where it is not known yet
  std::vector<glm::dmat4> bodies;               // where those that the scene has taken are drawn
  std::shared_ptr<const PieceSamples> samples;  // of it, where maps looked at are to be compared with it
};

/// Needs its context current at every call.
class Scene {
 public:
  Scene(const gl::Context& context, const LoadedPart& part);

  /// Draws over the whole target, which is bound afterwards. Returns true while drawing the same again would
  /// refine the picture.
  bool draw(const ViewTarget& target, const SceneSettings& settings);
  /// Leaves these bodies out of the picture, and no others; regions stay as they are.
  void hide(const std::set<std::size_t>& bodies);
  /// Marks these faces alone.
  void mark_faces(std::span<const std::uint32_t> faces);
  /// Draws these lines over the picture, in place of those around what is in a point's way.
  void mark_edges(std::span<const ViewSegment> edges) {
    view_.set_marked_lines(MarkedLines::blocking, edges);
  }
  /// Marks what is in a point's way, and the way there; and the span in a section.
  void explain(const std::optional<Blocker>& blocker, const std::optional<CutSpan>& span);
  /// What settings may place, drawn over the picture.
  using Bodies = std::shared_ptr<const std::vector<ViewBody>>;
  void take_bodies(const Bodies& bodies);
  /// The parting line with the loop that is looked at, and the halves that settings may show; none of what is
  /// null.
  struct ShownMold {
    std::shared_ptr<const MoldLine> line;
    std::optional<std::size_t> loop;
    std::shared_ptr<const MoldSolids> solids;
    bool operator==(const ShownMold&) const = default;
  };
  void take_mold(const ShownMold& mold);
  /// Of the solids that were taken; another for every one.
  [[nodiscard]] std::uint64_t steel() const { return steel_; }
  /// The plane that cuts the part; nothing where no section is chosen.
  [[nodiscard]] std::optional<CutPlane> section(const LookSettings& look, const glm::dvec3& direction) {
    return sections_.plane(look, direction);
  }
  /// What the picture last drawn shows at a pixel.
  [[nodiscard]] std::optional<PickedPoint> pick(const glm::ivec2& pixel) const {
    return drawn_ ? view_.pick(pixel) : std::nullopt;
  }
  /// Of the maps last compared.
  [[nodiscard]] const std::shared_ptr<const MapComparison>& comparison() const { return comparison_; }
  /// Pictures of the maps as they are, square, RGBA8; the names of textures that live as long as the scene.
  [[nodiscard]] MapTextures map_pictures(int size_px);

  [[nodiscard]] const LoadedPart& part() const { return part_; }

 private:
  /// All that maps depend on; other settings are about measuring.
  struct MapInputs {
    glm::dvec3 direction{0.0};
    double tau_deg = 0.0;
    MapSettings settings;
    bool operator==(const MapInputs&) const = default;
  };
  void compare_with(const std::shared_ptr<const PieceSamples>& samples);
  void find_parting_line();
  void mark_blocking(const std::optional<std::uint32_t>& face);

  const gl::Context* context_;
  LoadedPart part_;
  PictureMaps maps_;
  PartView view_;
  std::shared_ptr<const ViewGeometry> shown_;  // of the part, without what is hidden
  gl::Tools tools_;
  SectionPlanes sections_;
  std::shared_ptr<const SplitMesh> split_;  // the one that was given to the maps
  std::optional<MapInputs> maps_of_;        // from which the maps were drawn
  bool maps_are_coarse_ = false;            // they are those of a moving direction
  std::optional<SamplePass> sample_pass_;
  std::shared_ptr<const MapComparison> comparison_;
  std::shared_ptr<const PieceSamples> compared_samples_;
  std::uint64_t compared_maps_ = 0;                   // revision
  std::shared_ptr<const SplitMesh> parting_line_of_;  // of which the line was found
  std::optional<gl::ColourTarget> plus_, minus_;
  Bodies bodies_;
  ShownMold mold_;
  std::uint64_t steel_ = 0;
  std::optional<Blocker> blocker_;  // that are shown
  std::optional<CutSpan> span_;
  bool thumbnails_stale_ = true;
  bool drawn_ = false;
};

/// The camera with its orientation and projection, so that the points fill the free area.
[[nodiscard]] Camera fitted_to(const Camera& camera, std::span<const glm::vec3> points, const FreeArea& area);

}  // namespace moldlight::gui
