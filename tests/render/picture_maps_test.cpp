// Maps of a moving direction, whoever draws them, show the regions of the GL's own.
#include "session/picture_maps.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "gl/colour_target.hpp"
#include "render/part_view.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

constexpr glm::ivec2 k_size(320, 240);
constexpr double k_most_differing =
    2e-3;  // of the part's pixels: along region borders, by roundings of a texel

constexpr float k_depth_rounding =
    1.0F / 1024;  // unit frame: corners are snapped, which moves steep facets up or down

class Moving : public testing::TestWithParam<KernelShape> {};

TEST_P(Moving, ShowsTheRegionsOfMapsDrawnByTheGl) {
  const gl::Context& context = test::shared_context();
  const gl::ColourTarget picture(context.functions(), k_size);
  for (const test::Shape& shape : {test::cup_with_side_hole({}), test::snap_hook({}), test::t_slot({})}) {
    Part part;
    part.mesh = test::subdivided(shape.mesh, 20'000);
    const auto model = prepare_part(std::move(part), {});
    PictureMaps moving(context, model), drawn(context, model);
    PartView view(context.functions(),
                  view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame));
    Camera camera;
    camera.orientation = standard_orientation(StandardView::isometric);
    camera = fitted(camera, unit_positions(model->part.mesh, model->frame), k_size);
    std::size_t pixels = 0, differing = 0;
    for (const glm::dvec3& direction : {shape.direction, glm::dvec3(0.3, -0.5, 0.8)}) {
      MethodSettings method;
      method.direction = direction;
      method.kernel_shape = GetParam();
      moving.draw_moving(method);
      drawn.draw_resting(moving_method(method, model->frame.diagonal));
      const auto regions = [&](const PictureMaps& maps) {
        view.draw({picture.framebuffer(), k_size}, maps.buffers(), maps.maps(), camera, {.samples = 1});
        return view.read_regions();
      };
      const auto facets = (static_cast<void>(regions(drawn)), view.read_facets());
      const auto expected = regions(drawn), found = regions(moving);
      for (std::size_t i = 0; i < facets.size(); ++i) {
        if (facets[i] == 0) continue;
        ++pixels;
        differing += expected[i] != found[i] ? 1 : 0;
      }
    }
    EXPECT_GT(pixels, 10'000U) << shape.name;
    EXPECT_LE(static_cast<double>(differing), k_most_differing * static_cast<double>(pixels)) << shape.name;
  }
}

std::vector<float> depths(const gl::Functions& gl, const gl::Texture& texture, int size) {
  std::vector<float> values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  const gl::Framebuffer framebuffer = gl::make_framebuffer(gl, {.colours = {}, .depth = texture.name()});
  gl.ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
  return values;
}

TEST_P(Moving, HasTheDepthsOfMapsDrawnByTheGl) {
  const gl::Context& context = test::shared_context();
  Part part;
  part.mesh = test::snap_hook({}).mesh;
  const auto model = prepare_part(std::move(part), {});
  PictureMaps moving(context, model), drawn(context, model);
  MethodSettings method;
  method.resolution = 256;
  method.kernel_shape = GetParam();
  for (const glm::dvec3& direction : {glm::dvec3(0.1, 0.2, 1.0), glm::dvec3(0.3, -0.5, 0.8)}) {
    method.direction = direction;
    moving.draw_moving(method);
    moving.complete_depths();
    drawn.draw_resting(method);
    for (const bool plus : {true, false}) {
      const auto expected = depths(context.functions(), drawn.maps().depth(plus), method.resolution);
      const auto found = depths(context.functions(), moving.maps().depth(plus), method.resolution);
      std::size_t covered = 0, differing = 0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        covered += expected[i] < 1.0F ? 1 : 0;
        differing += std::abs(found[i] - expected[i]) > k_depth_rounding ? 1 : 0;
      }
      EXPECT_GT(covered, 1000U);
      EXPECT_LE(differing, covered / 50) << "edges of facets round to either side of a texel's centre";
    }
  }
}

INSTANTIATE_TEST_SUITE_P(PictureMaps, Moving,
                         testing::Values(KernelShape::one_sided, KernelShape::symmetric));

}  // namespace
}  // namespace moldlight
