#include "render/shadow_maps.hpp"

#include <algorithm>
#include <atomic>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_places = 64;
/// Facets drawn for a batch: enough to keep a GL at work, few enough that it ends soon when it is cancelled.
constexpr std::size_t k_most_facets = 4'000'000;

float sign_of(bool plus) { return plus ? 1.0F : -1.0F; }
int layer_of(std::size_t place, bool plus) { return 2 * static_cast<int>(place) + (plus ? 0 : 1); }

gl::Pass pass_to(GLuint framebuffer, int resolution) {
  return {.framebuffer = framebuffer,
          .size = glm::ivec2(resolution),
          .depth = gl::DepthTest::less,
          .writes_depth = true};
}

}  // namespace

void set_map_frame(const gl::Program& program, const MapFrame& frame, int resolution) {
  program.set("u_direction", glm::vec3(frame.z));
  program.set("u_map_x", glm::vec3(frame.x));
  program.set("u_map_y", glm::vec3(frame.y));
  program.set("u_map_size", static_cast<float>(resolution));
  program.set("u_map_scale", 1.0F);
}

int fitting_places(const MapSettings& settings, std::size_t facets, std::size_t bytes) {
  const auto side = static_cast<std::size_t>(settings.resolution);
  const std::size_t map = 4 * side * side;
  const std::size_t by_bytes = (bytes - std::min(bytes, map)) / (2 * map + facets);
  const std::size_t by_facets = k_most_facets / std::max<std::size_t>(facets, 1);
  return static_cast<int>(std::clamp<std::size_t>(std::min(by_bytes, by_facets), 1, k_most_places));
}

ShadowMaps::ShadowMaps(const gl::Functions& gl, int places)
    : tools_(gl), places_(static_cast<std::size_t>(places)), batch_(true) {
  CHECK(places >= 1);
}

void ShadowMaps::allocate(int resolution) {
  allocated_ = 0;
  const int count = places(), depth_layers = batch_ ? 1 : 2;
  for (Place& place : places_) {
    place.plus = {};
    place.minus = {};
  }
  facets_ = gl::make_texture_array(tools_.gl, GL_R32UI, resolution, 2 * count);
  depths_ = gl::make_texture_array(tools_.gl, GL_DEPTH_COMPONENT32F, resolution, depth_layers);
  for (std::size_t k = 0; k < places_.size(); ++k) {
    for (const bool plus : {true, false}) {
      Side& side = plus ? places_[k].plus : places_[k].minus;
      const int layer = layer_of(k, plus);
      side.framebuffer =
          gl::make_layer_framebuffer(tools_.gl, {facets_, layer}, {depths_, layer % depth_layers});
      if (batch_) side.covered = gl::make_query(tools_.gl);
    }
  }
  allocated_ = resolution;
}

ShadowMaps::Place& ShadowMaps::begin(const MapSubject& subject, const MapSettings& settings, int place) {
  CHECK(subject.classes.size() == subject.part.facet_count());
  CHECK(!batch_ || !settings.symmetric_kernel);
  settings_ = settings;
  part_ = &subject.part;
  // Views distinguish drawings by it, also those of several pairs of maps.
  static std::atomic<std::uint64_t> drawings = 0;
  revision_ = ++drawings;
  if (settings.resolution != allocated_) allocate(settings.resolution);
  Place& drawn = places_.at(static_cast<std::size_t>(place));
  drawn.frame = subject.frame;
  drawn.classes.set(tools_.gl, subject.classes);
  return drawn;
}

void ShadowMaps::draw(const MapSubject& subject, const MapSettings& settings, int place) {
  const Place& drawn = begin(subject, settings, place);
  for (const bool plus : {true, false}) {
    draw_facets(subject, drawn.side(plus), plus);
    if (drawn.side(plus).covered) count_covered(drawn.side(plus));
    if (settings.edge_thickness > 0.0) draw_edges(subject, drawn, plus);
  }
  gl::check_errors(tools_.gl, "drawing the shadow maps");
}

void ShadowMaps::draw_facets(const MapSubject& subject, const Side& side, bool plus) {
  // Both maps share their axes, so in both a facet that faces +d runs counter-clockwise. Each keeps the
  // facets that face away from its light.
  gl::Pass pass = pass_to(side.framebuffer.name(), settings_.resolution);
  pass.cull = plus ? gl::Cull::front : gl::Cull::back;
  gl::begin(tools_.gl, pass);
  gl::clear_numbers(tools_.gl);
  const gl::Program& program = tools_.programs.use("maps/second_depth.vert", "maps/second_depth.frag");
  set_map_frame(program, subject.frame, settings_.resolution);
  program.set("u_side", sign_of(plus));
  subject.part.draw_facets();
}

void ShadowMaps::draw_edges(const MapSubject& subject, const Place& place, bool plus) {
  gl::begin(tools_.gl, pass_to(place.side(plus).framebuffer.name(), settings_.resolution));
  const gl::Program& program = tools_.programs.use("maps/contour_edge.vert", "maps/contour_edge.frag",
                                                   {settings_.symmetric_kernel ? "SYMMETRIC_KERNEL" : ""});
  set_map_frame(program, subject.frame, settings_.resolution);
  program.set("u_side", sign_of(plus));
  program.set("u_half_width", 0.5 * settings_.edge_thickness / settings_.resolution);
  program.set_texture("t_facet_class", 0, GL_TEXTURE_BUFFER, place.classes.texels());
  if (!settings_.symmetric_kernel)
    program.set_texture("t_planes", 1, GL_TEXTURE_BUFFER, subject.part.planes());
  subject.part.draw_concave_edges();
}

void ShadowMaps::count_covered(const Side& side) {
  // What is nearer than the far plane.
  gl::begin(tools_.gl, {.framebuffer = side.framebuffer.name(),
                        .size = glm::ivec2(settings_.resolution),
                        .depth = gl::DepthTest::unequal,
                        .writes_colour = false});
  tools_.programs.use("common/at_infinity.vert", {});
  tools_.gl.BeginQuery(GL_SAMPLES_PASSED, side.covered.name());
  tools_.corners.draw();
  tools_.gl.EndQuery(GL_SAMPLES_PASSED);
}

double ShadowMaps::shadow(int place) const {
  GLuint most = 0;
  for (const bool plus : {true, false}) {
    GLuint covered = 0;
    const Side& side = places_.at(static_cast<std::size_t>(place)).side(plus);
    tools_.gl.GetQueryObjectuiv(side.covered.name(), GL_QUERY_RESULT, &covered);
    most = std::max(most, covered);
  }
  const double texel = 1.0 / settings_.resolution;
  return static_cast<double>(most) * texel * texel;
}

void ShadowMaps::load(const MapSubject& subject, const MapSettings& settings, const SecondDepthMaps& maps) {
  CHECK(!settings.symmetric_kernel && settings.resolution == maps.resolution());
  begin(subject, settings, 0);
  for (const bool plus : {true, false})
    upload(facets_, plus, {GL_RED_INTEGER, GL_UNSIGNED_INT, maps.facets(plus).data()});
}

void ShadowMaps::load_depths(const SecondDepthMaps& maps) {
  CHECK(settings_.resolution == maps.resolution());
  for (const bool plus : {true, false})
    upload(depths_, plus, {GL_DEPTH_COMPONENT, GL_FLOAT, maps.depths(plus).data()});
}

void ShadowMaps::upload(const gl::Texture& maps, bool plus, const Texels& texels) const {
  tools_.gl.ActiveTexture(GL_TEXTURE0);
  tools_.gl.BindTexture(GL_TEXTURE_2D_ARRAY, maps.name());
  tools_.gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
  tools_.gl.TexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, layer_of(0, plus), settings_.resolution,
                          settings_.resolution, 1, texels.format, texels.type, texels.data);
  gl::check_errors(tools_.gl, "uploading the shadow maps");
}

void ShadowMaps::bind(const gl::Program& program, int first_unit, int place) const {
  const Place& bound = places_.at(static_cast<std::size_t>(place));
  set_map_frame(program, bound.frame, settings_.resolution);
  program.set_texture("t_facet_class", first_unit, GL_TEXTURE_BUFFER, bound.classes.texels());
  if (settings_.symmetric_kernel) {
    program.set_texture("t_depths", first_unit + 1, GL_TEXTURE_2D_ARRAY, depths_);
    program.set("u_kernel_radius", settings_.kernel_radius);
  } else {
    program.set_texture("t_maps", first_unit + 1, GL_TEXTURE_2D_ARRAY, facets_);
    program.set("u_map_pair", place);
    program.set("u_lateral", settings_.lateral);
  }
  if (program.has("t_planes"))
    program.set_texture("t_planes", first_unit + 2, GL_TEXTURE_BUFFER, part_->planes());
}

std::vector<std::uint32_t> ShadowMaps::read(bool plus) const {
  const int size = settings_.resolution;
  std::vector<std::uint32_t> texels(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  tools_.gl.BindFramebuffer(GL_FRAMEBUFFER, framebuffer(plus));
  tools_.gl.PixelStorei(GL_PACK_ALIGNMENT, 4);
  tools_.gl.ReadPixels(0, 0, size, size, GL_RED_INTEGER, GL_UNSIGNED_INT, texels.data());
  return texels;
}

}  // namespace moldlight
