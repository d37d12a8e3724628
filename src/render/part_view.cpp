#include "render/part_view.hpp"

#include <algorithm>
#include <array>
#include <vector>

#include "render/view_passes.hpp"

namespace moldlight {

namespace {

constexpr std::uint32_t k_facet_mask = 0x1FFFFFFFU;  // of a surface's first word, see surface_bits.glsl
constexpr int k_taps_at_rest = 6;                    // of ambient occlusion, a sample
constexpr int k_taps_moving = 12;

}  // namespace

/// What the picture in the targets shows, to tell whether the next one is the same.
struct PartView::Shown {
  Camera camera;
  ViewSettings settings;
  glm::dvec3 direction{0, 0, 1};
  std::uint64_t maps = 0, split = 0;  // revisions; 0: none
  int samples = 0;                    // drawn so far
};

PartView::PartView(const gl::Functions& gl, const ViewGeometry& geometry)
    : gl_(&gl),
      passes_(std::make_unique<ViewPasses>(gl, geometry)),
      targets_(std::make_unique<ViewTargets>()),
      shown_(std::make_unique<Shown>()) {}

PartView::~PartView() = default;

bool PartView::draw(const ViewTarget& target, const ViewSubject& of, const Camera& camera,
                    const ViewSettings& settings, const ViewMarks& marks) {
  const ViewSubject subject = asked_for(of, settings);
  Shown& shown = *shown_;
  if (targets_->size != target.size) {
    *targets_ = {};
    *targets_ = ViewTargets(*gl_, target.size);
    shown.samples = 0;
  }
  const std::uint64_t maps = subject.maps != nullptr ? subject.maps->revision() : 0;
  const std::uint64_t split = subject.split != nullptr ? subject.split->revision() : 0;
  if (shown.camera != camera || shown.settings != settings || shown.direction != subject.direction ||
      shown.maps != maps || shown.split != split) {
    shown = {.camera = camera,
             .settings = settings,
             .direction = subject.direction,
             .maps = maps,
             .split = split,
             .samples = 0};
  }
  gl_->Viewport(0, 0, target.size.x, target.size.y);
  gl_->Disable(GL_BLEND);
  gl_->Disable(GL_SCISSOR_TEST);
  gl_->Disable(GL_CULL_FACE);
  if (shown.samples == 0) {
    draw_sample(subject);
  } else if (shown.samples < settings.samples) {
    targets_->make_sum(*gl_);
    if (shown.samples == 1) passes_->accumulate(*targets_, true);
    draw_sample(subject);
    passes_->accumulate(*targets_, false);
  }
  passes_->present(*targets_, shown.samples, target.framebuffer);
  passes_->draw_marks(*targets_, marks, target.framebuffer);
  gl_->Enable(GL_DEPTH_TEST);
  gl_->DepthMask(GL_TRUE);
  gl_->DepthFunc(GL_LESS);
  gl::check_errors(*gl_, "drawing the picture");
  return shown.samples < settings.samples;
}

void PartView::draw_final(const ViewTarget& target, const ViewSubject& subject, const Camera& camera,
                          const ViewSettings& settings, const ViewMarks& marks) {
  while (draw(target, subject, camera, settings, marks)) {
  }
}

void PartView::draw_sample(const ViewSubject& subject) {
  const ViewFrame frame(shown_->camera, targets_->size, shown_->settings, subject.direction, shown_->samples);
  const ViewSettings& settings = frame.settings;
  ViewPasses& passes = *passes_;
  const bool moving = shown_->samples == 0;
  const int taps = !settings.ambient_occlusion ? 0 : moving ? k_taps_moving : k_taps_at_rest;
  const auto layer = [&](Layer which) {
    passes.draw_surface(frame, *targets_, which, subject);
    passes.draw_openness(frame, *targets_, taps);
    if (which == Layer::undercuts_alone || settings.others_opacity >= 1.0) {
      passes.draw_background(frame, *targets_);
    }
    passes.shade(frame, *targets_, which, subject);
  };
  if (settings.others_opacity < 1.0) layer(Layer::undercuts_alone);
  layer(Layer::whole);
  passes.draw_lines(frame, *targets_, subject.part);
  if (settings.parting_arrows) passes.draw_arrows(frame, *targets_);
  ++shown_->samples;
}

void PartView::choose_facets(std::span<const FacetIndex> facets) { passes_->choose_facets(facets); }

void PartView::set_outline(std::span<const ViewSegment> segments) {
  passes_->set_outline(segments);
  shown_->samples = 0;
}

void PartView::set_contour_edges(std::span<const ViewSegment> convex, std::span<const ViewSegment> concave) {
  passes_->set_contour_edges(convex, concave);
  shown_->samples = 0;
}

std::optional<PickedPoint> PartView::pick(const glm::ivec2& pixel) const {
  const glm::ivec2& size = targets_->size;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
  const int row = size.y - 1 - pixel.y;
  std::array<std::uint32_t, 2> surface{};
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets_->to_surface.name());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(pixel.x, row, 1, 1, GL_RG_INTEGER, GL_UNSIGNED_INT, surface.data());
  const std::uint32_t number = surface[0] & k_facet_mask;
  if (number == 0) return std::nullopt;
  float depth = 0.0F;
  gl_->ReadPixels(pixel.x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  std::array<std::uint8_t, 4> bits{};
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets_->to_accessible.name());
  gl_->ReadPixels(pixel.x, row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_BYTE, bits.data());
  gl::check_errors(*gl_, "reading what is under the cursor");

  const ViewFrame frame(shown_->camera, size, shown_->settings, shown_->direction,
                        std::max(0, shown_->samples - 1));
  const glm::dvec4 clip(2.0 * (pixel.x + 0.5) / size.x - 1.0, 2.0 * (row + 0.5) / size.y - 1.0,
                        2.0 * depth - 1.0, 1.0);
  const glm::dvec4 seen = glm::inverse(frame.clip_from_eye * frame.eye_from_unit) * clip;
  const double opened = bits[0] == 1   ? frame.settings.open_mold
                        : bits[0] == 2 ? -frame.settings.open_mold
                                       : 0.0;
  return PickedPoint{.facet = number - 1,
                     .position = glm::vec3(glm::dvec3(seen) / seen.w - opened * frame.direction),
                     .region = region_of((bits[0] & 1U) != 0, (bits[0] & 2U) != 0)};
}

std::vector<std::uint32_t> PartView::read_facets() const {
  const glm::ivec2& size = targets_->size;
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<std::array<std::uint32_t, 2>> surface(pixels);
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets_->to_surface.name());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl_->ReadPixels(0, 0, size.x, size.y, GL_RG_INTEGER, GL_UNSIGNED_INT, surface.data());
  std::vector<std::uint32_t> facets;
  facets.reserve(pixels);
  for (const auto& words : surface) facets.push_back(words[0] & k_facet_mask);
  return facets;
}

std::vector<std::uint8_t> PartView::read_regions() const {
  const glm::ivec2& size = targets_->size;
  std::vector<std::uint8_t> regions(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  gl_->BindFramebuffer(GL_FRAMEBUFFER, targets_->to_accessible.name());
  gl_->PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl_->ReadPixels(0, 0, size.x, size.y, GL_RED_INTEGER, GL_UNSIGNED_BYTE, regions.data());
  return regions;
}

}  // namespace moldlight
