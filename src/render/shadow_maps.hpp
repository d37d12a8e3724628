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

  bool operator==(const MapSettings&) const = default;
};

/// What is drawn; `facet_classes` (R8UI, one a facet) must be those for `frame.z`.
struct MapSubject {
  const PartBuffers& part;
  const gl::Texture& facet_classes;
  const MapFrame& frame;
  const MapSettings& settings;
};

/// Draws maps into whatever framebuffer is bound. Needs its context current. The framebuffers have an R32UI
/// colour and a depth buffer, both square with the resolution as side; `plus` is the map of the light at +d.
class MapPainter {
 public:
  explicit MapPainter(const gl::Functions& gl);

  /// Clears and draws the facets that face away from the light.
  void draw_facets(const MapSubject& subject, bool plus) const;
  /// Adds the thick edges to the facets.
  void draw_edges(const MapSubject& subject, bool plus) const;
  /// Has `query` count the texels that are covered so far.
  void count_covered(const gl::Query& query) const;

 private:
  const gl::Functions* gl_;
  gl::Program facets_, edges_, symmetric_edges_, far_plane_;
  gl::VertexArray fullscreen_;
};

/// Sets what shaders/common/map_frame.glsl asks for on `program`, which must be in use.
void set_map_frame(const gl::Program& program, const MapFrame& frame, int resolution);

/// Owns the maps and draws them. Needs its context current.
class ShadowMaps {
 public:
  explicit ShadowMaps(const gl::Functions& gl);

  /// Draws both maps; the facet classes of `part` must be those for `frame.z`. Allocates only when the
  /// resolution changes.
  void draw(const PartBuffers& part, const MapFrame& frame, const MapSettings& settings);

  /// Takes maps that were drawn elsewhere, for a one-sided kernel: facet + 1 (0: none) a texel, rows from
  /// below.
  void load(const MapFrame& frame, const MapSettings& settings, std::span<const std::uint32_t> plus,
            std::span<const std::uint32_t> minus);
  /// Adds depths to such maps, for who looks at depth().
  void load_depths(std::span<const float> plus, std::span<const float> minus);

  /// Binds everything that shaders/common/region.glsl asks for to `program`, which must be in use and
  /// compiled with SYMMETRIC_KERNEL defined exactly if the settings say so; takes texture units from
  /// `first_unit` on, four at most.
  void bind(const gl::Program& program, const PartBuffers& part, int first_unit) const;

  [[nodiscard]] const MapSettings& settings() const { return settings_; }
  [[nodiscard]] const MapFrame& frame() const { return frame_; }
  /// Another for every drawing of any maps; 0 before they are drawn.
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

  const gl::Functions* gl_;
  MapPainter painter_;
  Side plus_, minus_;
  MapFrame frame_;
  MapSettings settings_;
  int allocated_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace moldlight
