// The two second-depth shadow maps of a parting direction, thick concave contour edges included (paper,
// section 2.3).
#pragma once

#include <cstdint>
#include <span>

#include "gl/program.hpp"
#include "mold/map_frame.hpp"
#include "render/part_buffers.hpp"

namespace moldlight {

/// How the maps are drawn and looked up.
struct MapSettings {
  int resolution = 2048;        // texels along a side; the side is the part's diagonal
  double edge_thickness = 2.0;  // texels
  bool symmetric_kernel =
      false;              // the paper's kernel and strips; otherwise one-sided look-ups and extended facets
  int kernel_radius = 1;  // texels, for the symmetric kernel
  double lateral = 0.0;   // lateral tolerance in the unit frame, for the one-sided look-up
};

/// Owns the maps and draws them. Needs its context current.
class ShadowMaps {
 public:
  explicit ShadowMaps(const gl::Functions& gl);

  /// Draws both maps; the facet classes of `part` must be those for `frame.z`. Allocates only when the
  /// resolution changes.
  void draw(const PartBuffers& part, const MapFrame& frame, const MapSettings& settings);

  /// The same; gives the area of the part's shadow along the direction, unit frame squared, from the texels
  /// that facets alone cover, without the thick edges: the larger of the two maps' areas, which are equal for
  /// a closed part. Waits for the GL.
  [[nodiscard]] double draw_and_measure_shadow(const PartBuffers& part, const MapFrame& frame,
                                               const MapSettings& settings);

  /// Takes maps that were drawn elsewhere, for a one-sided kernel: facet + 1 (0: none) a texel, rows from
  /// below.
  void load(const MapFrame& frame, const MapSettings& settings, std::span<const std::uint32_t> plus,
            std::span<const std::uint32_t> minus);

  /// Binds everything that shaders/common/region.glsl asks for to `program`, which must be in use and
  /// compiled with SYMMETRIC_KERNEL defined exactly if the settings say so; takes texture units from
  /// `first_unit` on, four at most.
  void bind(const gl::Program& program, const PartBuffers& part, int first_unit) const;

  [[nodiscard]] const MapSettings& settings() const { return settings_; }
  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  /// Changes whenever the maps are drawn again; 0 before they are.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  [[nodiscard]] const gl::Texture& facets(bool plus) const { return side(plus).facets; }  // R32UI, facet + 1
  [[nodiscard]] const gl::Texture& depth(bool plus) const { return side(plus).depth; }

 private:
  struct Side {
    gl::Texture facets, depth;
    gl::Framebuffer framebuffer;
  };
  [[nodiscard]] const Side& side(bool plus) const { return plus ? plus_ : minus_; }
  void begin(const MapFrame& frame, const MapSettings& settings);
  void draw_facets(bool plus, const PartBuffers& part) const;
  void draw_edges(bool plus, const PartBuffers& part) const;
  [[nodiscard]] double covered_area(bool plus) const;
  void set_frame(const gl::Program& program) const;

  const gl::Functions* gl_;
  gl::Program facet_program_, edge_program_, symmetric_edge_program_, coverage_program_;
  gl::VertexArray fullscreen_;
  Side plus_, minus_;
  gl::Texture counts_;
  gl::Framebuffer count_framebuffer_;
  MapFrame frame_;
  MapSettings settings_;
  int allocated_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace moldlight
