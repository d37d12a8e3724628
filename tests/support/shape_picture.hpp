// Small pictures of meshes through the whole path: maps, regions, light, lines.
#pragma once

#include <memory>

#include "render/offscreen_picture.hpp"
#include "render/part_view.hpp"
#include "session/classifier.hpp"
#include "support/shapes.hpp"

namespace moldlight::test {

/// A shape with everything that draws it, on one context, which must be current.
class ShapePicture {
 public:
  ShapePicture(const gl::Context& context, const Shape& shape, const glm::ivec2& size = {200, 150});

  /// A camera from the front, the right and above that has the whole shape in view.
  [[nodiscard]] Camera camera() const;
  [[nodiscard]] Image draw(const Camera& camera, const ViewSettings& settings, const ViewMarks& marks = {});

  Classifier classifier;
  MethodSettings method;
  PartView view;
  OffscreenPicture picture;

 private:
  ViewGeometry geometry_;
};

}  // namespace moldlight::test
