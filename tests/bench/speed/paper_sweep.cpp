#include "bench/speed/paper_sweep.hpp"

#include <algorithm>
#include <limits>

#include <glm/geometric.hpp>

#include "classify/classifier.hpp"
#include "mold/map_frame.hpp"
#include "mold/measure.hpp"

namespace moldlight::bench {

namespace {
/// Paper, section 2.4: 0.5 degrees at 512 pixels.
constexpr double k_perturbation_deg_at_512 = 0.5;
}  // namespace

PaperSweep::PaperSweep(const gl::Context& context, std::shared_ptr<const PartModel> model, int resolution,
                       double tau_deg)
    : gl_(&context.functions()),
      model_(std::move(model)),
      resolution_(resolution),
      tau_deg_(tau_deg),
      buffers_(part_buffers(context, *model_)),
      depth_program_(*gl_, {.vertex = "maps/second_depth.vert", .fragment = "maps/second_depth.frag"}),
      facet_id_pass_(*gl_),
      positions_(unit_positions(model_->part.mesh, model_->frame)) {
  for (int side = 0; side < 2; ++side) {
    depths_[side] = gl::make_texture_2d(*gl_, GL_DEPTH_COMPONENT32F, resolution, resolution);
    framebuffers_[side] = gl::make_framebuffer(*gl_, {.colours = {}, .depth = depths_[side].name()});
  }
}

double PaperSweep::undercut(const glm::dvec3& direction) {
  const MapFrame frame = map_frame(direction);
  depth_program_.use();
  set_map_frame(depth_program_, frame, resolution_);
  for (const bool plus : {true, false}) {
    gl::begin(*gl_, {.framebuffer = framebuffers_[plus ? 0 : 1].name(),
                     .size = glm::ivec2(resolution_),
                     .depth = gl::DepthTest::less,
                     .writes_depth = true,
                     .cull = plus ? gl::Cull::front : gl::Cull::back});
    const GLfloat furthest = 1.0F;
    gl_->ClearBufferfv(GL_DEPTH, 0, &furthest);
    depth_program_.set("u_side", plus ? 1.0F : -1.0F);
    buffers_.draw_facets();
  }

  float top[2] = {-std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};
  const glm::vec3 along(frame.z);
  for (const glm::vec3& position : positions_) {
    const float height = glm::dot(position, along);
    top[0] = std::max(top[0], height);
    top[1] = std::max(top[1], -height);
  }
  const std::vector<FacetClass> classes = facet_classes(model_->geometry, frame.z, tau_deg_);
  const std::vector<std::uint8_t> bits = facet_id_pass_.run(
      {buffers_, frame, classes}, top,
      {.resolution = resolution_, .draft_perturbation_deg = k_perturbation_deg_at_512 * 512.0 / resolution_});
  double area = 0.0;
  for (FacetIndex facet = 0; facet < bits.size(); ++facet) {
    if (verdict_region(bits[facet]) == Region::undercut) area += model_->geometry.areas[facet];
  }
  return area;
}

}  // namespace moldlight::bench
