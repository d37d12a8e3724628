// Small pictures of meshes through the whole path: regions, light, lines.
#pragma once

#include <memory>

#include "base/image.hpp"
#include "classify/picture_maps.hpp"
#include "gl/objects.hpp"
#include "render/part_view.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

/// A shape with everything that draws it, on one context, which must be current.
class ShapePicture {
 public:
  ShapePicture(const gl::Context& context, const Shape& shape, const glm::ivec2& size = {200, 150});

  /// A camera from the front, the right and above that has the whole shape in view.
  [[nodiscard]] Camera camera() const;
  /// The regions of `query`, maps and split mesh; the constructor finds them once.
  void find_regions();
  [[nodiscard]] ViewTarget target() const { return {picture.framebuffer(), picture.size()}; }
  /// What was drawn last. Waits for the GL.
  [[nodiscard]] Image read() const { return {picture.size().x, picture.size().y, picture.read()}; }
  [[nodiscard]] Image draw(const Camera& camera, const ViewSettings& settings, const ViewMarks& marks = {});

  std::shared_ptr<const PartModel> model;
  Query query;
  ViewGeometry geometry;
  PictureMaps maps;
  PartView view;
  gl::ColourTarget picture;
};

[[nodiscard]] SplitMesh exact_regions(const PartModel& model, const Query& query);

}  // namespace moldlight::test
