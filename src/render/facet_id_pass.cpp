#include "render/facet_id_pass.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "mold/measure.hpp"

namespace moldlight {

namespace {
constexpr int k_rows_read_at_once = 256;
}

FacetIdPass::FacetIdPass(const gl::Functions& gl)
    : gl_(&gl), program_(gl, {.vertex = "measure/facet_id.vert", .fragment = "measure/facet_id.frag"}) {}

std::vector<std::uint8_t> FacetIdPass::run(const MapSubject& subject, const float top[2],
                                           const FacetIdSettings& settings) {
  const PartBuffers& part = subject.part;
  const int size = settings.resolution;
  const gl::Texture facets = gl::make_texture_2d(*gl_, GL_R32UI, size, size);
  const gl::Texture depth = gl::make_texture_2d(*gl_, GL_DEPTH_COMPONENT32F, size, size);
  const gl::Framebuffer framebuffer = gl::make_framebuffer(*gl_, facets, &depth);
  gl::begin(*gl_, {.framebuffer = framebuffer.name(),
                   .size = glm::ivec2(size),
                   .depth = gl::DepthTest::less,
                   .writes_depth = true});
  classes_.set(*gl_, subject.classes);
  program_.use();
  set_map_frame(program_, subject.frame, size);
  program_.set("u_tangent", std::tan(glm::radians(settings.draft_perturbation_deg)));
  program_.set_texture("t_planes", 0, GL_TEXTURE_BUFFER, part.planes());
  program_.set_texture("t_facet_class", 1, GL_TEXTURE_BUFFER, classes_.texels());
  program_.set_texture("t_positions", 2, GL_TEXTURE_BUFFER, part.positions());
  program_.set_texture("t_corners", 3, GL_TEXTURE_BUFFER, part.corners());

  std::vector<std::uint8_t> bits(part.facet_count(), 0);
  std::vector<std::uint32_t> rows(static_cast<std::size_t>(size) * k_rows_read_at_once);
  for (const bool plus : {true, false}) {
    gl::clear_numbers(*gl_);
    program_.set("u_side", plus ? 1.0F : -1.0F);
    program_.set("u_top", top[plus ? 0 : 1]);
    part.draw_corners();
    gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
    const std::uint8_t bit = plus ? verdict::k_accessible_plus : verdict::k_accessible_minus;
    for (int row = 0; row < size; row += k_rows_read_at_once) {
      const int count = std::min(k_rows_read_at_once, size - row);
      gl_->ReadPixels(0, row, size, count, GL_RED_INTEGER, GL_UNSIGNED_INT, rows.data());
      const std::size_t pixels = static_cast<std::size_t>(size) * static_cast<std::size_t>(count);
      for (std::size_t i = 0; i < pixels; ++i) {
        if (rows[i] != 0) bits[rows[i] - 1] = static_cast<std::uint8_t>(bits[rows[i] - 1] | bit);
      }
    }
  }
  gl::check_errors(*gl_, "reading facet numbers back");
  return bits;
}

}  // namespace moldlight
