#include "render/shadow_maps.hpp"

#include <atomic>

#include "base/check.hpp"

namespace moldlight {

ShadowMaps::ShadowMaps(const gl::Functions& gl) : gl_(&gl), painter_(gl) {}

void ShadowMaps::begin(const MapFrame& frame, const MapSettings& settings) {
  frame_ = frame;
  settings_ = settings;
  // Views tell drawings apart by it, also those of several pairs of maps.
  static std::atomic<std::uint64_t> drawings = 0;
  revision_ = ++drawings;
  if (settings.resolution == allocated_) return;
  allocated_ = 0;
  for (Side* side : {&plus_, &minus_}) {
    *side = {};
    side->facets = gl::make_texture_2d(*gl_, GL_R32UI, settings.resolution, settings.resolution);
    side->depth = gl::make_texture_2d(*gl_, GL_DEPTH_COMPONENT32F, settings.resolution, settings.resolution);
    side->framebuffer = gl::make_framebuffer(*gl_, side->facets, &side->depth);
  }
  allocated_ = settings.resolution;
}

void ShadowMaps::draw(const PartBuffers& part, const MapFrame& frame, const MapSettings& settings) {
  begin(frame, settings);
  const MapSubject subject{part, part.facet_classes(), frame_, settings_};
  for (const bool plus : {true, false}) {
    gl_->BindFramebuffer(GL_FRAMEBUFFER, side(plus).framebuffer.name());
    painter_.draw_facets(subject, plus);
    painter_.draw_edges(subject, plus);
  }
  gl::check_errors(*gl_, "drawing the shadow maps");
}

void ShadowMaps::load(const MapFrame& frame, const MapSettings& settings, std::span<const std::uint32_t> plus,
                      std::span<const std::uint32_t> minus) {
  const auto size = static_cast<std::size_t>(settings.resolution);
  CHECK(!settings.symmetric_kernel && plus.size() == size * size && minus.size() == size * size);
  begin(frame, settings);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->ActiveTexture(GL_TEXTURE0);
  for (const bool of_plus : {true, false}) {
    gl_->BindTexture(GL_TEXTURE_2D, side(of_plus).facets.name());
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, settings.resolution, settings.resolution, GL_RED_INTEGER,
                       GL_UNSIGNED_INT, (of_plus ? plus : minus).data());
  }
  gl::check_errors(*gl_, "uploading the shadow maps");
}

void ShadowMaps::load_depths(std::span<const float> plus, std::span<const float> minus) {
  const auto size = static_cast<std::size_t>(settings_.resolution);
  CHECK(plus.size() == size * size && minus.size() == size * size);
  gl_->PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  gl_->ActiveTexture(GL_TEXTURE0);
  for (const bool of_plus : {true, false}) {
    gl_->BindTexture(GL_TEXTURE_2D, side(of_plus).depth.name());
    gl_->TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, settings_.resolution, settings_.resolution, GL_DEPTH_COMPONENT,
                       GL_FLOAT, (of_plus ? plus : minus).data());
  }
  gl::check_errors(*gl_, "uploading depths of the shadow maps");
}

void ShadowMaps::bind(const gl::Program& program, const PartBuffers& part, int first_unit) const {
  set_map_frame(program, frame_, settings_.resolution);
  program.set_texture("t_facet_class", first_unit, GL_TEXTURE_BUFFER, part.facet_classes());
  if (settings_.symmetric_kernel) {
    program.set_texture("t_depth_plus", first_unit + 1, GL_TEXTURE_2D, plus_.depth);
    program.set_texture("t_depth_minus", first_unit + 2, GL_TEXTURE_2D, minus_.depth);
    program.set("u_kernel_radius", settings_.kernel_radius);
  } else {
    program.set_texture("t_map_plus", first_unit + 1, GL_TEXTURE_2D, plus_.facets);
    program.set_texture("t_map_minus", first_unit + 2, GL_TEXTURE_2D, minus_.facets);
    program.set("u_lateral", static_cast<float>(settings_.lateral));
  }
  if (program.has("t_planes"))
    program.set_texture("t_planes", first_unit + 3, GL_TEXTURE_BUFFER, part.planes());
}

}  // namespace moldlight
