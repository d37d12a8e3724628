// The picture of the part: one path for the window's viewport, still pictures and contact sheets.
//
// Deferred: the facet and the normal of each visible fragment are drawn first; then one pass shades each
// fragment once. Regions come with the pieces of a split surface, or from look-ups in the shadow maps
// (shaders/common/region.glsl), once a fragment. A picture at rest is refined: later calls average it with
// copies shifted by parts of a pixel.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "mold/region.hpp"
#include "render/view_frame.hpp"
#include "render/view_geometry.hpp"
#include "render/view_tools.hpp"

namespace moldlight {

/// From where a part is seen, and how it is shown.
struct View {
  Camera camera = {};
  ViewSettings settings = {};
  ViewMarks marks = {};
  std::span<const glm::dmat4> body_motions =
      {};  // of the bodies that are set; like marks, refine nothing anew
};

/// What is seen at a pixel.
struct PickedPoint {
  FacetIndex facet = 0;      // k_no_facet: the cut of a section
  glm::vec3 position{0.0F};  // on the part, unit frame; not moved by an opened mold
  Region region = Region::both;
};

/// Needs its context current at every call. Keeps targets of the size last drawn.
class PartView {
 public:
  PartView(const gl::Functions& gl, const ViewGeometry& geometry) : tools_(gl, geometry) {}

  /// Draws the part. Returns true while drawing the same again would refine the picture; false once it is
  /// final.
  bool draw(const ViewTarget& target, const ViewSubject& subject, const View& view);

  /// The same until the picture is final.
  void draw_final(const ViewTarget& target, const ViewSubject& subject, const View& view) {
    while (draw(target, subject, view)) {
    }
  }

  /// Draws these facets from now on, numbered as before; see shown_part().
  void set_geometry(const ViewGeometry& geometry);
  /// The number of the face that each facet belongs to: marks name faces. Without it nothing is marked.
  void set_faces(std::span<const std::uint32_t> of_facet);
  /// Lines over the finished picture from the next call of draw() on; like marks they refine nothing anew.
  void set_marked_lines(MarkedLines which, std::span<const ViewSegment> segments);
  /// Surface that shows through whatever hides it, as a veil over the finished picture; none for no
  /// triangles.
  void set_veiled_surface(std::span<const ViewVertex> vertices,
                          std::span<const std::array<VertexIndex, 3>> triangles);
  /// Solids beside the part, to be shown as View::body_motions says.
  void set_bodies(std::span<const ViewBody> bodies);
  /// The steel of a mold, to be shown as ViewSettings::steel says, which must name another one then.
  void set_steel(std::span<const ViewSolid> solids);
  /// The parting line as a tube over the finished picture, and of it the loop that is looked at.
  void set_tube(std::span<const ViewSegment> line, std::span<const ViewSegment> chosen);
  /// What ViewSettings::parting_line shows (see parting_line()).
  void set_parting_line(std::span<const ViewSegment> segments);

  /// What the picture last drawn shows at a pixel, counted from its upper left corner; nothing for the
  /// background. Waits for the GL.
  [[nodiscard]] std::optional<PickedPoint> pick(const glm::ivec2& pixel) const;

  /// Of the picture last drawn, rows from below, for tests: facet + 1 a pixel (0: background), and the
  /// region's accessibility bits.
  [[nodiscard]] std::vector<std::uint32_t> read_facets() const;
  [[nodiscard]] std::vector<std::uint8_t> read_regions() const;

 private:
  void draw_sample(const ViewSubject& subject);

  ViewTools tools_;
  // What the targets show, to know whether the next picture is the same.
  ViewInputs shown_;
  int samples_ = 0;  // drawn so far
  // Of what they have facets, depths and openness, if these are the same for any direction and maps.
  std::optional<ViewInputs> surface_;
  glm::dmat4 unit_from_clip_{1.0};  // of the first of them
};

}  // namespace moldlight
