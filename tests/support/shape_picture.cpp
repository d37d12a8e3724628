#include "support/shape_picture.hpp"

#include "support/classify_mesh.hpp"

namespace moldlight::test {

namespace {

ViewGeometry geometry_of(const PartModel& model) {
  return view_geometry(model.part.mesh, model.geometry, model.adjacency, model.frame);
}

MethodSettings method_of(const Shape& shape) {
  MethodSettings method;
  method.direction = shape.direction;
  method.tau_deg = shape.settings.tau_deg;
  method.resolution = 1024;
  return method;
}

}  // namespace

ShapePicture::ShapePicture(const gl::Context& context, const Shape& shape, const glm::ivec2& size)
    : classifier(context, model_of(shape.mesh)),
      method(method_of(shape)),
      view(context.functions(), geometry_of(classifier.model())),
      picture(context.functions(), size),
      geometry_(geometry_of(classifier.model())) {
  classifier.draw_maps(method);
}

Camera ShapePicture::camera() const {
  Camera camera;
  camera.orientation = looking_along({-0.55, 0.75, -0.6}, {0, 0, 1});
  return fitted(camera, geometry_.extremes, picture.target().size, 0.85);
}

Image ShapePicture::draw(const Camera& camera, const ViewSettings& settings, const ViewMarks& marks) {
  view.draw_final(picture.target(), classifier.buffers(), classifier.maps(), camera, settings, marks);
  return picture.read();
}

}  // namespace moldlight::test
