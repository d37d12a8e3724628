#include "render/sample_counting.hpp"

#include <algorithm>
#include <cstdint>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr int k_least_block = 16;    // samples that one fragment looks up
constexpr int k_summed = 32;         // counts that one fragment sums up
constexpr int k_most_blocks = 8192;  // as wide as any texture can be
constexpr int k_row = 1024;          // samples
constexpr std::size_t k_most_samples = 10'000'000;

int quotient_up(int a, int b) { return (a + b - 1) / b; }

}  // namespace

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

}  // namespace moldlight
