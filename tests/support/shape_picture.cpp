#include "support/shape_picture.hpp"

#include "classify/classifier.hpp"
#include "mold/exact/exact_regions.hpp"
#include "support/classify_mesh.hpp"

namespace moldlight::test {

namespace {

Query query_of(const Shape& shape) {
  Query query;
  query.direction = shape.direction;
  query.method.tau_deg = shape.settings.tau_deg;
  query.method.resolution = 1024;
  query.method.kernel = 3;
  return query;
}

}  // namespace

ShapePicture::ShapePicture(const gl::Context& context, const Shape& shape, const glm::ivec2& size)
    : model(model_of(shape.mesh)),
      query(query_of(shape)),
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
  maps.draw_resting(query);
  maps.take_split(exact_regions(*model, query), geometry, query);
}

Image ShapePicture::draw(const Camera& camera, const ViewSettings& settings, const ViewMarks& marks) {
  view.draw_final(target(), maps.subject(), {camera, settings, marks});
  return read();
}

SplitMesh exact_regions(const PartModel& model, const Query& query) {
  const ExactPart part(model.part.mesh, model.geometry, model.frame, Progress{});
  return exact_split(part, exact_query(model, query), Progress{}).mesh;
}

}  // namespace moldlight::test
