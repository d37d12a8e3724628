#include <algorithm>

#include "render/view_passes.hpp"
#include "render/view_settings.hpp"

namespace moldlight {

constexpr float k_veil = 0.22F, k_others_gray = 0.72F;  // opacity
constexpr glm::vec2 k_body_opacity(0.72F, 0.2F);

void accumulate(ViewTools& tools, bool first) {
  gl::begin(tools.gl, {.framebuffer = tools.targets.to_sum.name(),
                       .size = tools.targets.size,
                       .blend = first ? gl::Blend::replace : gl::Blend::add});
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/accumulate.frag");
  program.set_texture("t_colour", 0, GL_TEXTURE_2D, tools.targets.colour);
  tools.corners.draw();
}

void present(ViewTools& tools, int samples, GLuint framebuffer) {
  const glm::ivec2& size = tools.targets.size;
  gl::begin(tools.gl, {.framebuffer = framebuffer, .size = size});
  if (samples == 1) {
    tools.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, tools.targets.to_colour.name());
    tools.gl.BlitFramebuffer(0, 0, size.x, size.y, 0, 0, size.x, size.y, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    tools.gl.BindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    return;
  }
  const gl::Program& program = tools.programs.use("common/fullscreen.vert", "view/resolve.frag");
  program.set_texture("t_sum", 0, GL_TEXTURE_2D, tools.targets.sum);
  program.set("u_weight", 1.0F / static_cast<float>(samples));
  tools.corners.draw();
}

void draw_marks(ViewTools& tools, const ViewMarks& marks, GLuint framebuffer) {
  const gl::Texture& faces = tools.mesh.faces.texels();
  const bool any_face = faces && (marks.hovered || marks.blocking || marks.chosen);
  if (!any_face && marks.undercut_glow <= 0.0 && !marks.others_gray) return;
  gl::begin(tools.gl,
            {.framebuffer = framebuffer, .size = tools.targets.size, .blend = gl::Blend::over_keeping_alpha});
  const gl::Program& program =
      tools.programs.use("common/fullscreen.vert", "view/marks.frag", {any_face ? "FACES" : ""});
  program.set_texture("t_surface", 0, GL_TEXTURE_2D, tools.targets.surface);
  program.set_texture("t_accessible", 1, GL_TEXTURE_2D, tools.targets.accessible);
  program.set("u_glow", marks.undercut_glow);
  program.set("u_gray", marks.others_gray ? k_others_gray : 0.0F);
  program.set("u_lit", marks.lit ? facts(*marks.lit).accessible : ~0U);
  if (any_face) {
    const auto number = [](const std::optional<std::uint32_t>& face) { return face.value_or(~0U); };
    program.set_texture("t_faces", 2, GL_TEXTURE_BUFFER, faces);
    program.set("u_hovered", number(marks.hovered));
    program.set("u_blocking", number(marks.blocking));
    program.set("u_chosen", number(marks.chosen));
    program.set("u_hover_colour", screen_value(k_hover_mark));
    program.set("u_block_colour", screen_value(k_block_mark));
  }
  tools.corners.draw();
}

void draw_bodies(ViewTools& tools, const ViewFrame& frame, std::span<const glm::dmat4> motions,
                 GLuint framebuffer) {
  const std::size_t count = std::min(motions.size(), tools.mesh.bodies.size());
  if (count == 0) return;
  for (const gl::Blend blend : {gl::Blend::under, gl::Blend::over_keeping_alpha}) {
    // Beside the part a picture without a backdrop has nothing that they could be drawn over.
    if (blend == gl::Blend::under && frame.settings.backdrop != Backdrop::none) continue;
    gl::begin(
        tools.gl,
        {.framebuffer = framebuffer, .size = tools.targets.size, .cull = gl::Cull::back, .blend = blend});
    const gl::Program& program = tools.programs.use("view/geometry.vert", "view/body.frag");
    program.set_texture("t_depth", 0, GL_TEXTURE_2D, tools.targets.depth);
    program.set("u_opacity", k_body_opacity);
    for (std::size_t k = 0; k < count; ++k) {
      const ViewMesh::Body& body = tools.mesh.bodies[k];
      program.set("u_clip_from_unit", glm::mat4(glm::dmat4(frame.clip_from_unit) * motions[k]));
      program.set("u_colour", screen_value(body.colour));
      const glm::dvec3 toward = glm::transpose(glm::dmat3(motions[k])) * frame.camera.toward_viewer();
      program.set("u_toward_viewer", glm::vec3(toward));
      body.triangles.draw(tools.gl);
    }
  }
}

void draw_veil(ViewTools& tools, const ViewFrame& frame, GLuint framebuffer) {
  if (!tools.mesh.veiled || frame.opened()) return;
  const bool cut = frame.settings.cut.has_value();
  gl::begin(tools.gl, {.framebuffer = framebuffer,
                       .size = tools.targets.size,
                       .blend = gl::Blend::over_keeping_alpha,
                       .clipped = cut});
  const gl::Program& program =
      tools.programs.use("view/geometry.vert", "view/veil.frag", {cut ? "SECTION" : ""});
  program.set("u_clip_from_unit", frame.clip_from_unit);
  if (cut) frame.set_section(program);
  program.set_texture("t_depth", 0, GL_TEXTURE_2D, tools.targets.depth);
  program.set("u_colour", glm::vec4(screen_value(k_block_mark), k_veil));
  tools.mesh.veiled->draw(tools.gl);
}

}  // namespace moldlight
