#include "session/still_layout.hpp"

#include <algorithm>
#include <vector>

#include <glm/common.hpp>

#include "gl/colour_target.hpp"

namespace moldlight {

namespace {

/// A picture of this size has everything at scale 1; one of another shape at least by its smaller side.
constexpr glm::dvec2 k_full_scale_px(1280.0, 800.0);
constexpr double k_full_scale_side_px = 1150.0;
constexpr double k_least_scale = 0.72;  // below this text is not read
constexpr double k_most_share = 0.2;    // of the picture's area, that a legend may take
constexpr double k_margin = 28.0;       // around it at scale 1
constexpr double k_fill = 0.86;
constexpr int k_reduction = 8;  // of the pictures that tell what the part covers

/// A camera that fits the points into a box of the picture.
Camera framed(Camera camera, std::span<const glm::vec3> points, const Box& box, const glm::ivec2& size) {
  const glm::ivec2 room = glm::max(glm::ivec2(box.size), glm::ivec2(1));
  camera = fitted(camera, points, room, k_fill);
  camera.height *= static_cast<double>(size.y) / room.y;
  return panned(camera, box.corner + 0.5 * box.size - 0.5 * glm::dvec2(size), size);
}

/// Boxes for the part, from the whole picture to what the legend leaves free for certain.
std::vector<Box> scene_boxes(const Composition& composition) {
  const glm::dvec2 room(composition.size);
  std::vector<Box> boxes = {{glm::dvec2(0.0), room}};
  if (!composition.legend) return boxes;
  const bool beside = room.x > 1.15 * room.y;
  const double left = composition.legend->far_corner().x, below = room.y - composition.legend->corner.y;
  for (const double share : {0.2, 0.4, 0.6, 0.8, 1.0}) {
    boxes.push_back(beside ? Box{{share * left, 0.0}, {room.x - share * left, room.y}}
                           : Box{{0.0, 0.0}, {room.x, room.y - share * below}});
  }
  return boxes;
}

/// The legend with some air around it.
Box forbidden_box(const Box& legend) {
  const double air = legend.corner.x;
  return {legend.corner - air, legend.size + 2.0 * air};
}

bool holds(const Box& box, const glm::dvec2& point) {
  return glm::all(glm::greaterThanEqual(point, box.corner)) &&
         glm::all(glm::lessThanEqual(point, box.far_corner()));
}

/// True if the part runs into a box of the picture, of which `view` has drawn a small one.
bool part_covers(const PartView& view, const glm::ivec2& small_size, const Box& box) {
  const std::vector<std::uint32_t> facets = view.read_facets();
  for (int y = 0; y < small_size.y; ++y) {
    for (int x = 0; x < small_size.x; ++x) {
      const auto row = static_cast<std::size_t>(small_size.y - 1 - y);
      if (facets[row * static_cast<std::size_t>(small_size.x) + static_cast<std::size_t>(x)] == 0) continue;
      if (holds(box, static_cast<double>(k_reduction) * (glm::dvec2(x, y) + 0.5))) return true;
    }
  }
  return false;
}

}  // namespace

StillLayout still_layout(const glm::ivec2& size, const LegendContent* content) {
  const glm::dvec2 room(size);
  StillLayout layout;
  layout.scale = std::max(std::min(room.x / k_full_scale_px.x, room.y / k_full_scale_px.y),
                          std::min(room.x, room.y) / k_full_scale_side_px);
  if (content == nullptr) return layout;
  layout.scale = std::max(layout.scale, k_least_scale);
  const glm::dvec2 legend = legend_size(*content, {.scale = layout.scale});
  const double margin = k_margin * layout.scale;
  if (legend.x + 2.0 * margin <= room.x && legend.x * legend.y <= k_most_share * room.x * room.y) {
    layout.legend = Box{{margin, room.y - margin - legend.y}, legend};
  }
  return layout;
}

Camera composed(const gl::Functions& gl, PartView& view, const PartBuffers& part, const Camera& camera,
                const Composition& composition) {
  std::vector<glm::vec3> points(composition.extremes.begin(), composition.extremes.end());
  points.insert(points.end(), composition.beyond.begin(), composition.beyond.end());
  const std::vector<Box> boxes = scene_boxes(composition);
  const glm::ivec2 small_size = glm::max(composition.size / k_reduction, glm::ivec2(1));
  const gl::ColourTarget small(gl, small_size);
  ViewSettings plain;
  plain.colour_mode = ColourMode::plain;
  plain.ambient_occlusion = plain.feature_edges = false;
  plain.samples = 1;
  for (const Box& box : boxes) {
    const Camera candidate = framed(camera, points, box, composition.size);
    if (&box == &boxes.back()) return candidate;
    const Box forbidden = forbidden_box(*composition.legend);
    bool collides = false;
    for (const glm::vec3& point : composition.beyond) {
      const auto pixel = project(candidate, composition.size, glm::dvec3(point));
      collides = collides || (pixel && holds(forbidden, *pixel));
    }
    if (collides) continue;
    view.draw_final({small.framebuffer(), small_size}, {.part = part}, candidate, plain);
    if (!part_covers(view, small_size, forbidden)) return candidate;
  }
  return camera;
}

}  // namespace moldlight
