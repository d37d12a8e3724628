// Draws second-depth shadow maps, thick concave contour edges included (paper, section 2.3), into whatever
// framebuffer is bound.
#pragma once

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

/// Needs its context current. The framebuffers have an R32UI colour and a depth buffer, both square with the
/// resolution as side; `plus` is the map of the light at +d.
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

}  // namespace moldlight
