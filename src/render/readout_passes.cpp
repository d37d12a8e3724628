#include "render/readout_passes.hpp"

#include <algorithm>
#include <cmath>

#include <glm/trigonometric.hpp>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr int k_block_width = 1024, k_block_height = 1024;  // a block of 16 MiB of samples
constexpr int k_rows_read_at_once = 256;
constexpr int k_least_block = 16;    // samples that one fragment looks up
constexpr int k_summed = 32;         // counts that one fragment sums up
constexpr int k_most_blocks = 8192;  // as wide as any texture can be
constexpr int k_row = 1024;          // samples
constexpr std::size_t k_most_samples = 10'000'000;

int quotient_up(int a, int b) { return (a + b - 1) / b; }

}  // namespace

SamplePass::SamplePass(const gl::Functions& gl)
    : tools_(gl),
      samples_(gl::make_texture_2d(gl, GL_RGBA32UI, k_block_width, k_block_height)),
      verdicts_(gl::make_texture_2d(gl, GL_R8UI, k_block_width, k_block_height)),
      framebuffer_(gl::make_framebuffer(gl, verdicts_)) {}

std::vector<std::uint8_t> SamplePass::run(std::span<const SurfaceSample> samples, const ShadowMaps& maps,
                                          Doubt doubt) {
  std::vector<std::uint8_t> verdicts(samples.size());
  const gl::Program& program =
      tools_.programs.use("common/fullscreen.vert", "measure/samples.frag",
                          {maps.settings().symmetric_kernel ? "SYMMETRIC_KERNEL" : "",
                           doubt == Doubt::marked ? "WITH_DOUBT" : ""});
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

SampleCounting::SampleCounting(const gl::Functions& gl, std::span<const SurfaceSample> samples,
                               int directions)
    : tools_(gl), sample_count_(static_cast<int>(samples.size())) {
  CHECK(samples.size() <= k_most_samples && directions >= 1);
  const int rows = std::max(1, quotient_up(sample_count_, k_row));
  samples_ = gl::make_texture_2d(gl, GL_RGBA32UI, k_row, rows);
  tools_.gl.BindTexture(GL_TEXTURE_2D, samples_.name());
  tools_.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  const auto upload = [&](int row, int width, int height) {
    if (width == 0 || height == 0) return;
    tools_.gl.TexSubImage2D(GL_TEXTURE_2D, 0, 0, row, width, height, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                            &samples[static_cast<std::size_t>(row) * k_row]);
  };
  upload(0, k_row, sample_count_ / k_row);
  upload(sample_count_ / k_row, sample_count_ % k_row, 1);

  block_ = std::max(k_least_block, quotient_up(sample_count_, k_most_blocks));
  blocks_ = std::max(1, quotient_up(sample_count_, block_));
  counts_[0] = make_counts(blocks_, directions);
  counts_[1] = make_counts(quotient_up(blocks_, k_summed), directions);
  gl::check_errors(gl, "uploading samples");
}

SampleCounting::Counts SampleCounting::make_counts(int width, int height) const {
  Counts counts;
  counts.regions = gl::make_texture_2d(tools_.gl, GL_RGBA32UI, width, height);
  counts.framebuffer = gl::make_framebuffer(tools_.gl, counts.regions);
  return counts;
}

std::vector<SampleCounts> SampleCounting::run(const ShadowMaps& maps, int directions) {
  const gl::Program& counting = tools_.programs.use("common/fullscreen.vert", "measure/sample_counts.frag");
  counting.set_texture("t_samples", 0, GL_TEXTURE_2D, samples_);
  counting.set("u_samples", sample_count_);
  counting.set("u_block", block_);
  for (int place = 0; place < directions; ++place) {
    maps.bind(counting, 1, place);
    gl::begin(tools_.gl,
              {.framebuffer = counts_[0].framebuffer.name(), .size = {blocks_, 1}, .corner = {0, place}});
    tools_.corners.draw();
  }

  const gl::Program& summing = tools_.programs.use("common/fullscreen.vert", "measure/sum_counts.frag");
  summing.set("u_summed", k_summed);
  const Counts* from = &counts_[0];
  const Counts* to = &counts_[1];
  for (int width = blocks_; width > 1; width = quotient_up(width, k_summed)) {
    gl::begin(tools_.gl,
              {.framebuffer = to->framebuffer.name(), .size = {quotient_up(width, k_summed), directions}});
    summing.set_texture("t_counts", 0, GL_TEXTURE_2D, from->regions);
    summing.set("u_width", width);
    tools_.corners.draw();
    std::swap(from, to);
  }

  tools_.gl.BindFramebuffer(GL_FRAMEBUFFER, from->framebuffer.name());
  tools_.gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  std::vector<std::array<std::uint32_t, 4>> by_bits(static_cast<std::size_t>(directions));
  tools_.gl.ReadPixels(0, 0, 1, directions, GL_RGBA_INTEGER, GL_UNSIGNED_INT, by_bits.data());
  gl::check_errors(tools_.gl, "counting samples");
  std::vector<SampleCounts> counts(by_bits.size());
  for (std::size_t place = 0; place < counts.size(); ++place) {
    for (std::uint8_t bits = 0; bits < 4; ++bits)
      counts[place].regions[static_cast<std::size_t>(verdict_region(bits))] += by_bits[place][bits];
  }
  return counts;
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
      for (std::size_t i = 0; i < pixels; ++i)
        if (rows[i] != 0) bits[rows[i] - 1] = static_cast<std::uint8_t>(bits[rows[i] - 1] | bit);
    }
  }
  gl::check_errors(*gl_, "reading facet numbers back");
  return bits;
}

}  // namespace moldlight
