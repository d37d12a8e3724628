#include "render/part_view.hpp"

#include <utility>

#include "base/check.hpp"
#include "render/view_passes.hpp"

namespace moldlight {

namespace {

constexpr int k_taps_at_rest = 6;  // of ambient occlusion, a sample
constexpr int k_taps_moving = 12;

bool shows_regions(const ViewSettings& settings) {
  return settings.colour_mode != ColourMode::plain || needs_detail(settings) || settings.transparency > 0.0 ||
         settings.mark_difference || settings.maps_left_of_px || settings.steel.shown;
}

/// The subject without what pictures of these settings do not ask for: maps and a split surface are both left
/// where their difference is marked, neither in a plain picture.
ViewSubject asked_for(const ViewSubject& subject, const ViewSettings& settings) {
  ViewSubject asked = subject;
  if (!shows_regions(settings)) {
    asked.maps = nullptr;
    asked.split = nullptr;
    return asked;
  }
  CHECK(subject.maps != nullptr || subject.split != nullptr);
  const bool both = settings.mark_difference || settings.maps_left_of_px;
  if (subject.maps == nullptr || subject.split == nullptr || both) return asked;
  if (settings.regions_by == RegionsBy::exact) {
    asked.maps = nullptr;
  } else {
    asked.split = nullptr;
  }
  return asked;
}

}  // namespace

bool PartView::draw(const ViewTarget& target, const ViewSubject& of, const View& view) {
  const ViewSettings& settings = view.settings;
  const ViewSubject subject = asked_for(of, settings);
  if (tools_.targets.size != target.size) {
    tools_.targets = {};
    tools_.targets = ViewTargets(tools_.gl, target.size);
    samples_ = 0;
    surface_.reset();
  }
  const ViewInputs inputs{.camera = view.camera,
                          .settings = settings,
                          .direction = subject.direction,
                          .maps = subject.maps != nullptr ? subject.maps->revision() : 0,
                          .split = subject.split != nullptr ? subject.split->revision() : 0};
  if (shown_ != inputs) samples_ = 0;
  shown_ = inputs;
  if (samples_ == 0) {
    draw_sample(subject);
  } else if (samples_ < settings.samples) {
    tools_.targets.make_sum(tools_.gl);
    if (samples_ == 1) {
      tools_.targets.keep_first(tools_.gl);
      accumulate(tools_, true);
    }
    draw_sample(subject);
    accumulate(tools_, false);
  }
  present(tools_, samples_, target.framebuffer);
  const ViewFrame frame(shown_, subject, target.size, 0);
  draw_marks(tools_, view.marks, target.framebuffer);
  draw_bodies(tools_, frame, view.body_motions, target.framebuffer);
  draw_veil(tools_, frame, target.framebuffer);
  draw_tube(tools_, frame, target.framebuffer);
  draw_marked_lines(tools_, frame, target.framebuffer);
  gl::check_errors(tools_.gl, "drawing the picture");
  return samples_ < settings.samples;
}

void PartView::draw_sample(const ViewSubject& subject) {
  ViewFrame frame(shown_, subject, tools_.targets.size, samples_);
  const ViewSettings& settings = frame.settings;
  const int taps = !settings.ambient_occlusion ? 0 : frame.sample == 0 ? k_taps_moving : k_taps_at_rest;
  const bool ghost = settings.transparency > 0.0, clear = settings.steel.shown && settings.steel.clear;
  ViewInputs surface = shown_;
  surface.direction = glm::dvec3(0.0);
  surface.maps = 0;
  const bool of_any_direction =
      samples_ == 0 && shown_.split == 0 && !ghost && !frame.opened() && !settings.steel.shown;
  const bool is_there = of_any_direction && surface_ == surface;
  if (!is_there) surface_.reset();
  bool first = true;
  for (const Layer layer : {Layer::undercuts_alone, Layer::whole, Layer::steel}) {
    if ((layer == Layer::undercuts_alone && !ghost) || (layer == Layer::steel && !clear)) continue;
    frame.layer = layer;
    if (!is_there) {
      draw_surface(tools_, frame);
      draw_openness(tools_, frame, taps);
    }
    if (std::exchange(first, false)) draw_background(tools_, frame);
    shade(tools_, frame);
    if (layer == Layer::whole) draw_lines(tools_, frame);
  }
  draw_steel_edges(tools_, frame);
  draw_arrows(tools_, frame);
  if (of_any_direction) surface_ = surface;
  if (samples_ == 0) unit_from_clip_ = glm::inverse(frame.clip_from_eye * frame.eye_from_unit);
  ++samples_;
}

void PartView::set_geometry(const ViewGeometry& geometry) {
  tools_.mesh.take(tools_.gl, geometry);
  samples_ = 0;
  surface_.reset();
}

void PartView::set_faces(std::span<const std::uint32_t> of_facet) {
  tools_.mesh.faces = FaceNumbers(tools_.gl, of_facet);
}

void PartView::set_marked_lines(MarkedLines which, std::span<const ViewSegment> segments) {
  tools_.mesh.marked[static_cast<std::size_t>(which)] = SegmentBuffer(tools_.gl, segments);
}

void PartView::set_veiled_surface(std::span<const ViewVertex> vertices,
                                  std::span<const std::array<VertexIndex, 3>> triangles) {
  tools_.mesh.veiled.reset();
  if (!triangles.empty()) tools_.mesh.veiled.emplace(tools_.gl, vertices, triangles);
}

void PartView::set_bodies(std::span<const ViewBody> bodies) {
  tools_.mesh.bodies.clear();
  for (const ViewBody& body : bodies)
    tools_.mesh.bodies.push_back({{tools_.gl, body.vertices, body.facets}, body.colour});
}

void PartView::set_steel(std::span<const ViewSolid> solids) {
  std::vector<Colour>& colours = tools_.mesh.moved_colours;
  tools_.mesh.solids_around.clear();
  colours.clear();
  for (const ViewSolid& solid : solids) {
    auto colour = static_cast<std::size_t>(solid.steel);
    if (solid.steel == Steel::moved) {
      if (colours.size() < k_moved_colours) colours.push_back(solid.body.colour);
      colour = k_steels + colours.size() - 1;
    }
    tools_.mesh.solids_around.push_back({{tools_.gl, solid.body.vertices, solid.body.facets},
                                         SegmentBuffer(tools_.gl, solid.edges),
                                         colour,
                                         solid.motion});
  }
}

void PartView::set_tube(std::span<const ViewSegment> line, std::span<const ViewSegment> chosen) {
  tools_.mesh.tube = SegmentBuffer(tools_.gl, line);
  tools_.mesh.chosen_tube = SegmentBuffer(tools_.gl, chosen);
}

void PartView::set_parting_line(std::span<const ViewSegment> segments) {
  tools_.mesh.parting_line = SegmentBuffer(tools_.gl, segments);
  samples_ = 0;
}

std::optional<PickedPoint> PartView::pick(const glm::ivec2& pixel) const {
  const gl::Functions& gl = tools_.gl;
  const glm::ivec2& size = tools_.targets.size;
  if (pixel.x < 0 || pixel.y < 0 || pixel.x >= size.x || pixel.y >= size.y) return std::nullopt;
  const int row = size.y - 1 - pixel.y;
  const bool kept = samples_ > 1;
  std::array<std::uint32_t, 2> surface{};
  gl.BindFramebuffer(GL_FRAMEBUFFER,
                     (kept ? tools_.targets.to_first_surface : tools_.targets.to_surface).name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(pixel.x, row, 1, 1, GL_RG_INTEGER, GL_UNSIGNED_INT, surface.data());
  const std::uint32_t number = surface[0] & k_surface_number_mask;
  if (number == 0) return std::nullopt;
  const bool cut = (surface[0] & k_surface_cut_bit) != 0;
  float depth = 0.0F;
  gl.ReadPixels(pixel.x, row, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, &depth);
  std::array<std::uint8_t, 4> bits{};
  gl.BindFramebuffer(GL_FRAMEBUFFER,
                     (kept ? tools_.targets.to_first_accessible : tools_.targets.to_accessible).name());
  gl.ReadPixels(pixel.x, row, 1, 1, GL_RED_INTEGER, GL_UNSIGNED_BYTE, bits.data());
  gl::check_errors(gl, "reading what is under the cursor");

  const glm::dvec4 clip(2.0 * (pixel.x + 0.5) / size.x - 1.0, 2.0 * (row + 0.5) / size.y - 1.0,
                        2.0 * depth - 1.0, 1.0);
  const glm::dvec4 seen = unit_from_clip_ * clip;
  const double travel = shown_.settings.travel();
  const double opened = cut ? 0.0 : bits[0] == 1 ? travel : bits[0] == 2 ? -travel : 0.0;
  return PickedPoint{.facet = cut ? k_no_facet : number - 1,
                     .position = glm::vec3(glm::dvec3(seen) / seen.w - opened * shown_.direction),
                     .region = region_of((bits[0] & 1U) != 0, (bits[0] & 2U) != 0)};
}

std::vector<std::uint32_t> PartView::read_facets() const {
  const gl::Functions& gl = tools_.gl;
  const glm::ivec2& size = tools_.targets.size;
  const std::size_t pixels = static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y);
  std::vector<std::array<std::uint32_t, 2>> surface(pixels);
  gl.BindFramebuffer(GL_FRAMEBUFFER, tools_.targets.to_surface.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RG_INTEGER, GL_UNSIGNED_INT, surface.data());
  std::vector<std::uint32_t> facets;
  facets.reserve(pixels);
  for (const auto& words : surface) facets.push_back(words[0] & k_surface_number_mask);
  return facets;
}

std::vector<std::uint8_t> PartView::read_regions() const {
  const gl::Functions& gl = tools_.gl;
  const glm::ivec2& size = tools_.targets.size;
  std::vector<std::uint8_t> regions(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
  gl.BindFramebuffer(GL_FRAMEBUFFER, tools_.targets.to_accessible.name());
  gl.PixelStorei(GL_PACK_ALIGNMENT, 1);
  gl.ReadPixels(0, 0, size.x, size.y, GL_RED_INTEGER, GL_UNSIGNED_BYTE, regions.data());
  return regions;
}

}  // namespace moldlight
