// The shadow maps of several parting directions at once, in the layers of one array texture, so that no
// direction waits for another's figures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "render/shadow_maps.hpp"

namespace moldlight {

/// Owns the maps, for one-sided look-ups. Needs its context current; `part` must outlive it.
class MapBatch {
 public:
  /// So many directions fit in, from place 0 on; at least 1.
  MapBatch(const gl::Functions& gl, const PartBuffers& part, const MapSettings& settings, int capacity);

  /// How many directions to take at once: 64 at most, fewer if their maps and classes would take more than
  /// `bytes` or if a part of many facets keeps the GL at work anyway; at least 1.
  [[nodiscard]] static int fitting_capacity(const MapSettings& settings, std::size_t facets,
                                            std::size_t bytes);

  /// Added to the class of a facet whose samples are not to be counted.
  static constexpr std::uint8_t k_left_out = 4;

  /// Draws both maps of a direction; `classes` are those for `frame.z`, a FacetClass a facet, maybe with
  /// k_left_out. Does not wait for the GL.
  void draw(int place, const MapFrame& frame, std::span<const std::uint8_t> classes);

  /// Area of the part's shadow along the direction at `place`, unit frame squared, from the texels that
  /// facets alone cover, without the thick edges: the larger of the two maps' areas, which are equal for a
  /// closed part. Waits for the GL.
  [[nodiscard]] double shadow(int place) const;

  /// Binds everything that shaders/common/region.glsl asks for with MAP_BATCH defined to `program`, which
  /// must be in use, for the direction at `place`; takes three texture units from `first_unit` on.
  void bind(const gl::Program& program, int place, int first_unit) const;

  [[nodiscard]] int capacity() const { return static_cast<int>(places_.size()); }

 private:
  struct Side {
    gl::Framebuffer framebuffer;
    gl::Query covered;  // texels
  };
  struct Place {
    Side plus, minus;
    gl::Buffer class_buffer;
    gl::Texture classes;
    MapFrame frame;
  };
  const gl::Functions* gl_;
  const PartBuffers* part_;
  MapSettings settings_;
  MapPainter painter_;
  gl::Texture maps_, depth_;  // one depth buffer for all layers, one after the other
  std::vector<Place> places_;
};

}  // namespace moldlight
