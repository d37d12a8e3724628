#include "render/map_batch.hpp"

#include <algorithm>

#include "base/check.hpp"

namespace moldlight {

namespace {

constexpr std::size_t k_most_directions = 64;
/// Facets drawn for a batch: enough to keep a GL at work, few enough that it ends soon when it is cancelled.
constexpr std::size_t k_most_facets = 4'000'000;

int layer_of(int place, bool plus) { return 2 * place + (plus ? 0 : 1); }

/// Of the texels that `query` has counted, unit frame squared. Waits for the GL.
double covered_area(const gl::Functions& gl, const gl::Query& query, int resolution) {
  GLuint covered = 0;
  gl.GetQueryObjectuiv(query.name(), GL_QUERY_RESULT, &covered);
  const double texel = 1.0 / resolution;
  return static_cast<double>(covered) * texel * texel;
}

}  // namespace

int MapBatch::fitting_capacity(const MapSettings& settings, std::size_t facets, std::size_t bytes) {
  const auto texels =
      static_cast<std::size_t>(settings.resolution) * static_cast<std::size_t>(settings.resolution);
  const std::size_t map = 4 * texels;
  const std::size_t by_bytes = (bytes - std::min(bytes, map)) / (2 * map + facets);
  const std::size_t by_facets = k_most_facets / std::max<std::size_t>(facets, 1);
  return static_cast<int>(std::clamp<std::size_t>(std::min(by_bytes, by_facets), 1, k_most_directions));
}

MapBatch::MapBatch(const gl::Functions& gl, const PartBuffers& part, const MapSettings& settings,
                   int capacity)
    : gl_(&gl),
      part_(&part),
      settings_(settings),
      painter_(gl),
      maps_(gl::make_texture_array(gl, GL_R32UI, settings.resolution, 2 * capacity)),
      depth_(gl::make_texture_2d(gl, GL_DEPTH_COMPONENT32F, settings.resolution, settings.resolution)),
      places_(static_cast<std::size_t>(capacity)) {
  CHECK(capacity >= 1 && !settings.symmetric_kernel);
  const std::vector<std::uint8_t> classes(part.facet_count());
  for (int i = 0; i < capacity; ++i) {
    Place& place = places_[static_cast<std::size_t>(i)];
    for (const bool plus : {true, false}) {
      Side& side = plus ? place.plus : place.minus;
      side.framebuffer = gl::make_layer_framebuffer(gl, maps_, layer_of(i, plus), depth_);
      side.covered = gl::make_query(gl);
    }
    place.class_buffer = gl::make_buffer(gl, GL_TEXTURE_BUFFER, std::span<const std::uint8_t>(classes));
    place.classes = gl::make_buffer_texture(gl, GL_R8UI, place.class_buffer);
  }
}

void MapBatch::draw(int index, const MapFrame& frame, std::span<const std::uint8_t> classes) {
  CHECK(classes.size() == part_->facet_count());
  Place& place = places_.at(static_cast<std::size_t>(index));
  place.frame = frame;
  gl_->BindBuffer(GL_TEXTURE_BUFFER, place.class_buffer.name());
  gl_->BufferSubData(GL_TEXTURE_BUFFER, 0, static_cast<GLsizeiptr>(classes.size_bytes()), classes.data());
  const MapSubject subject{*part_, place.classes, place.frame, settings_};
  for (const bool plus : {true, false}) {
    const Side& side = plus ? place.plus : place.minus;
    gl_->BindFramebuffer(GL_FRAMEBUFFER, side.framebuffer.name());
    painter_.draw_facets(subject, plus);
    painter_.count_covered(side.covered);
    painter_.draw_edges(subject, plus);
  }
  gl::check_errors(*gl_, "drawing shadow maps");
}

double MapBatch::shadow(int index) const {
  const Place& place = places_.at(static_cast<std::size_t>(index));
  return std::max(covered_area(*gl_, place.plus.covered, settings_.resolution),
                  covered_area(*gl_, place.minus.covered, settings_.resolution));
}

void MapBatch::bind(const gl::Program& program, int index, int first_unit) const {
  const Place& place = places_.at(static_cast<std::size_t>(index));
  set_map_frame(program, place.frame, settings_.resolution);
  program.set_texture("t_facet_class", first_unit, GL_TEXTURE_BUFFER, place.classes);
  program.set_texture("t_maps", first_unit + 1, GL_TEXTURE_2D_ARRAY, maps_);
  program.set("u_map_pair", index);
  program.set("u_lateral", static_cast<float>(settings_.lateral));
  program.set_texture("t_planes", first_unit + 2, GL_TEXTURE_BUFFER, part_->planes());
}

}  // namespace moldlight
