#include "render/sample_pass.hpp"

#include <algorithm>

namespace moldlight {

namespace {
constexpr int k_block_width = 1024, k_block_height = 1024;  // a block of 16 MiB of samples
}

SamplePass::SamplePass(const gl::Functions& gl)
    : tools_(gl),
      samples_(gl::make_texture_2d(gl, GL_RGBA32UI, k_block_width, k_block_height)),
      verdicts_(gl::make_texture_2d(gl, GL_R8UI, k_block_width, k_block_height)),
      framebuffer_(gl::make_framebuffer(gl, verdicts_)) {}

std::vector<std::uint8_t> SamplePass::run(std::span<const SurfaceSample> samples, const ShadowMaps& maps) {
  std::vector<std::uint8_t> verdicts(samples.size());
  const gl::Program& program =
      tools_.programs.use("common/fullscreen.vert", "measure/samples.frag",
                          {maps.settings().symmetric_kernel ? "SYMMETRIC_KERNEL" : ""});
  maps.bind(program, 1);
  program.set_texture("t_samples", 0, GL_TEXTURE_2D, samples_);
  tools_.gl.ActiveTexture(GL_TEXTURE0);
  tools_.gl.BindTexture(GL_TEXTURE_2D, samples_.name());
  tools_.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  tools_.gl.PixelStorei(GL_PACK_ALIGNMENT, 1);

  constexpr std::size_t k_width = k_block_width;
  for (std::size_t done = 0; done < samples.size();) {
    const std::size_t left = samples.size() - done;
    // Whole rows first; what remains of the last row is a block of its own.
    const std::size_t rows = std::min<std::size_t>(left / k_width, k_block_height);
    const std::size_t columns = rows == 0 ? left : k_width;
    const auto width = static_cast<GLsizei>(columns),
               height = static_cast<GLsizei>(std::max<std::size_t>(rows, 1));
    tools_.gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                            &samples[done]);
    gl::begin(tools_.gl, {.framebuffer = framebuffer_.name(), .size = {width, height}});
    tools_.corners.draw();
    tools_.gl.ReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_BYTE, &verdicts[done]);
    done += static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  gl::check_errors(tools_.gl, "measuring samples");
  return verdicts;
}

}  // namespace moldlight
