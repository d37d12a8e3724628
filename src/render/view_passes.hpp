// The passes of a picture, each a function of the frame; part_view.hpp puts them together.
#pragma once

#include <cstdint>
#include <span>

#include "render/view_frame.hpp"
#include "render/view_mesh.hpp"

namespace moldlight {

/// Which surface a pass draws: a picture that looks through all but the undercuts has two layers.
enum class Layer : std::uint8_t { whole, undercuts_alone };

/// The subject without what pictures of these settings do not ask for: maps and a split surface are both left
/// where their difference is marked, neither in a plain picture.
[[nodiscard]] ViewSubject asked_for(const ViewSubject& subject, const ViewSettings& settings);

/// Subjects are those that are asked for. Needs its context current.
class ViewPasses {
 public:
  ViewPasses(const gl::Functions& gl, const ViewGeometry& geometry);

  /// Facet, normal and depth of each visible fragment.
  void draw_surface(const ViewFrame& frame, const ViewTargets& targets, Layer layer,
                    const ViewSubject& subject);
  void draw_openness(const ViewFrame& frame, const ViewTargets& targets, int taps);
  void draw_background(const ViewFrame& frame, const ViewTargets& targets);
  /// Accessibility bits and colour of each. A plain picture knows no regions.
  void shade(const ViewFrame& frame, const ViewTargets& targets, Layer layer, const ViewSubject& subject);
  void draw_lines(const ViewFrame& frame, const ViewTargets& targets, const PartBuffers& part);
  void draw_arrows(const ViewFrame& frame, const ViewTargets& targets);

  /// Adds the finished sample to the sum.
  void accumulate(const ViewTargets& targets, bool first);
  /// Puts the picture of `samples` samples into `framebuffer`; a single one comes straight from the colours.
  void present(const ViewTargets& targets, int samples, GLuint framebuffer);
  void draw_marks(const ViewTargets& targets, const ViewMarks& marks, GLuint framebuffer);

  void choose_facets(std::span<const FacetIndex> facets);
  void set_outline(std::span<const ViewSegment> segments);
  void set_contour_edges(std::span<const ViewSegment> convex, std::span<const ViewSegment> concave);

 private:
  /// A copy of the surface that the mold's opening moves, and the accessibility bits it is made of.
  struct Piece {
    glm::vec3 shift{0.0F};
    std::uint32_t regions = 0;  // bit k: accessibility bits k
  };
  [[nodiscard]] static std::vector<Piece> pieces(const ViewFrame& frame, Layer layer);
  void begin_section(const gl::Program& program, const ViewFrame& frame) const;
  void draw_cut(const ViewFrame& frame, const ViewTargets& targets);
  struct LineStyle {
    glm::vec4 colour;  // sRGB and opacity
    double width_px;
  };
  void draw_segments(const ViewFrame& frame, const ViewTargets& targets, const PartBuffers& part,
                     const SegmentBuffer& segments, const LineStyle& style);
  void set_detail(const gl::Program& program, const ViewFrame& frame, const PartBuffers& part) const;
  void test_depth(GLenum function, bool writes) const;
  void draw_fullscreen() const;

  const gl::Functions* gl_;
  ViewPrograms programs_;
  ViewMesh mesh_;
  gl::VertexArray fullscreen_;
  gl::Buffer chosen_buffer_;
  gl::Texture chosen_;
  bool any_chosen_ = false;
};

}  // namespace moldlight
