// The two second-depth shadow maps of a parting direction, thick concave contour edges included (paper,
// section 2.3); of one direction, or of several at once in the layers of one array texture, so that none
// waits for another's figures.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "gl/pass.hpp"
#include "mold/map_frame.hpp"
#include "mold/second_depth.hpp"
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

/// What is drawn. The part must stay where it is as long as its maps are looked at; the classes are those for
/// `frame.z`, one a facet, maybe with k_left_out.
struct MapSubject {
  const PartBuffers& part;
  const MapFrame& frame;
  std::span<const FacetClass> classes;
};

/// Sets what shaders/common/map_frame.glsl asks for on `program`, which must be in use.
void set_map_frame(const gl::Program& program, const MapFrame& frame, int resolution);

/// How many directions to draw at once: 64 at most, fewer if their maps and classes would take more than
/// `bytes` or if a part of many facets keeps the GL at work anyway; at least 1.
[[nodiscard]] int fitting_places(const MapSettings& settings, std::size_t facets, std::size_t bytes);

/// Owns the maps and draws them. Needs its context current.
class ShadowMaps {
 public:
  /// Of one direction.
  explicit ShadowMaps(const gl::Functions& gl) : tools_(gl), places_(1) {}
  /// Of so many directions, from place 0 on, for one-sided look-ups; shadow() is known, and depths() are
  /// those of the last map drawn.
  ShadowMaps(const gl::Functions& gl, int places);

  /// Draws both maps of a direction, without waiting for the GL. The settings are one for all places;
  /// allocates only when the resolution changes.
  void draw(const MapSubject& subject, const MapSettings& settings, int place = 0);

  /// Takes maps that were drawn elsewhere, for a one-sided kernel.
  void load(const MapSubject& subject, const MapSettings& settings, const SecondDepthMaps& maps);
  /// Adds depths to such maps, for who looks at depths().
  void load_depths(const SecondDepthMaps& maps);

  /// Area of the part's shadow along the direction at `place`, unit frame squared, from the texels that
  /// facets alone cover, without the thick edges: the larger of the two maps' areas, which are equal for a
  /// closed part. Waits for the GL.
  [[nodiscard]] double shadow(int place) const;

  /// Binds everything that shaders/common/region.glsl asks for to `program`, which must be in use and
  /// compiled with SYMMETRIC_KERNEL defined exactly if the settings say so; takes three texture units from
  /// `first_unit` on.
  void bind(const gl::Program& program, int first_unit, int place = 0) const;

  [[nodiscard]] int places() const { return static_cast<int>(places_.size()); }
  [[nodiscard]] const MapSettings& settings() const { return settings_; }
  [[nodiscard]] const MapFrame& frame() const { return places_.front().frame; }
  [[nodiscard]] const gl::Texture& classes() const { return places_.front().classes.texels(); }
  /// Another for every drawing of any maps; 0 before they are drawn.
  [[nodiscard]] std::uint64_t revision() const { return revision_; }
  /// The map of the light at +d or at -d: R32UI, facet + 1, 0 for none.
  [[nodiscard]] GLuint framebuffer(bool plus) const { return places_.front().side(plus).framebuffer.name(); }
  /// What is in there, rows from below. Waits for the GL.
  [[nodiscard]] std::vector<std::uint32_t> read(bool plus) const;
  /// Of the +d map in layer 0, of the -d map in layer 1.
  [[nodiscard]] const gl::Texture& depths() const { return depths_; }

 private:
  struct Side {
    gl::Framebuffer framebuffer;
    gl::Query covered;  // texels
  };
  struct Place {
    Side plus, minus;
    FacetClassBuffer classes;
    MapFrame frame;
    [[nodiscard]] const Side& side(bool of_plus) const { return of_plus ? plus : minus; }
  };
  Place& begin(const MapSubject& subject, const MapSettings& settings, int place);
  void allocate(int resolution);
  void draw_facets(const MapSubject& subject, const Side& side, bool plus);
  void draw_edges(const MapSubject& subject, const Place& place, bool plus);
  void count_covered(const Side& side);
  struct Texels {
    GLenum format, type;
    const void* data;
  };
  void upload(const gl::Texture& maps, bool plus, const Texels& texels) const;

  gl::Tools tools_;
  gl::Texture facets_, depths_;  // arrays; several places share one layer of depths, one after the other
  std::vector<Place> places_;
  bool batch_ = false;
  const PartBuffers* part_ = nullptr;
  MapSettings settings_;
  int allocated_ = 0;
  std::uint64_t revision_ = 0;
};

}  // namespace moldlight
