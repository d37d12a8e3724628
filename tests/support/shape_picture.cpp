#include "support/shape_picture.hpp"

#include "classify/classifier.hpp"
#include "mold/exact/exact_regions.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight::test {

namespace {

MethodSettings method_of(const Shape& shape) {
  MethodSettings method;
  method.direction = shape.direction;
  method.tau_deg = shape.settings.tau_deg;
  method.resolution = 1024;
  method.kernel = 3;
  return method;
}

}  // namespace

ShapePicture::ShapePicture(const gl::Context& context, const Shape& shape, const glm::ivec2& size)
    : model(model_of(shape.mesh)),
      method(method_of(shape)),
      geometry(view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame)),
      maps(context, model),
      view(context.functions(), geometry),
      picture(context.functions(), size) {
  find_regions();
}

Camera ShapePicture::camera() const {
  Camera camera;
  camera.orientation = looking_along({-0.55, 0.75, -0.6}, {0, 0, 1});
  return fitted(camera, geometry.extremes, picture.size(), 0.85);
}

void ShapePicture::find_regions() {
  maps.draw_resting(method);
  maps.take_split(exact_regions(*model, method), geometry, method);
}

Image ShapePicture::draw(const Camera& camera, const ViewSettings& settings, const ViewMarks& marks) {
  view.draw_final(target(), maps.subject(), {camera, settings, marks});
  return read();
}

SplitMesh exact_regions(const PartModel& model, const MethodSettings& method) {
  const ExactPart part(model.part.mesh, model.geometry, model.frame, Progress{});
  const ExactQuery query{.direction = unit_direction(method.direction),
                         .tau_deg = method.tau_deg,
                         .lateral = map_settings(method, model.frame.diagonal).lateral};
  return exact_split(part, query, Progress{}).mesh;
}

}  // namespace moldlight::test
