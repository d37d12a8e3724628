// Maps of a moving direction, whoever draws them, show the regions of the GL's own.
#include "classify/picture_maps.hpp"

#include <cmath>
#include <filesystem>
#include <iostream>

#include <gtest/gtest.h>

#include "gl/objects.hpp"
#include "render/part_view.hpp"
#include "support/classify_mesh.hpp"
#include "support/mesh_edits.hpp"
#include "support/shape_picture.hpp"
#include "support/shapes.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr glm::ivec2 k_size(320, 240);
constexpr double k_most_other_texels =
    2e-3;  // of the part's pixels: along region borders, by roundings of a texel

constexpr float k_map_rounding =
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
      Query query;
      query.direction = direction;
      query.method.kernel_shape = GetParam();
      moving.draw_moving(query);
      drawn.draw_resting({direction, moving_method(query.method, model->frame.diagonal)});
      const auto regions = [&](const PictureMaps& maps) {
        ViewSettings settings;
        settings.samples = 1;
        view.draw({picture.framebuffer(), k_size}, maps.subject(), {camera, settings});
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
    EXPECT_LE(static_cast<double>(differing), k_most_other_texels * static_cast<double>(pixels))
        << shape.name;
  }
}

/// Pixels of the picture last drawn that have another region beside them, and of all that show the part.
struct PixelCounts {
  std::size_t part = 0, border = 0;
};

PixelCounts counted(const PartView& view) {
  const auto facets = view.read_facets();
  const auto regions = view.read_regions();
  PixelCounts counts;
  for (int y = 1; y + 1 < k_size.y; ++y) {
    for (int x = 1; x + 1 < k_size.x; ++x) {
      const int at = y * k_size.x + x;
      const auto region = [&](int pixel) { return regions[static_cast<std::size_t>(pixel)]; };
      if (facets[static_cast<std::size_t>(at)] == 0) continue;
      ++counts.part;
      bool on_border = false;
      for (const int beside : {at - k_size.x, at - 1, at + 1, at + k_size.x})
        on_border = on_border || region(beside) != region(at);
      counts.border += on_border ? 1 : 0;
    }
  }
  return counts;
}

/// That the picture changes from the moving view to that at rest is not to be noticed. Maps put a border into
/// the wrong place by half a texel at most, and a border has a pixel on either side of each pixel of its
/// length: so much of the border pixels may differ, and nothing elsewhere.
TEST(PictureMaps, TheMovingViewDiffersFromThePictureAtRestByHalfATexelAlongBorders) {
  const gl::Context& context = test::shared_context();
  const gl::ColourTarget picture(context.functions(), k_size);
  std::vector<std::shared_ptr<const PartModel>> models;
  for (const test::Shape& shape : {test::cup_with_side_hole({}), test::snap_hook({}), test::t_slot({})})
    models.push_back(test::model_of(shape.mesh));
  std::vector<std::filesystem::path> files = {test::asset_folder() / "parts" / "enclosure_lid.stl",
                                              test::asset_folder() / "parts" / "cable_clip.stl"};
  if (const auto shared = test::shared_folder()) {
    files.push_back(*shared / "parts" / "m5_stamplc_face_shell.stl");
    files.push_back(*shared / "parts" / "odri_hip_cover_64k.stl");
  }
  for (const auto& file : files) models.push_back(load_part(file.string(), {}, {}));
  std::size_t all_pixels = 0, all_differing = 0;
  for (const auto& model : models) {
    const ViewGeometry geometry =
        view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame);
    PictureMaps maps(context, model);
    PartView view(context.functions(), geometry);
    Camera camera;
    camera.orientation = standard_orientation(StandardView::isometric);
    camera = fitted(camera, geometry.extremes, k_size);
    for (const glm::dvec3& direction : {glm::dvec3(0, 0, 1), glm::dvec3(0.3, -0.5, 0.8)}) {
      Query query;
      query.direction = direction;
      const auto regions = [&] {
        ViewSettings settings;
        settings.samples = 1;
        view.draw({picture.framebuffer(), k_size}, maps.subject(), {camera, settings});
        return view.read_regions();
      };
      maps.drop_split();
      maps.draw_moving(query);
      const auto moving = regions();
      const double texel_px = 1.0 / (maps.maps().settings().resolution * pixel_length(camera, k_size));
      maps.take_split(test::exact_regions(*model, query), geometry, query);
      const auto resting = regions();
      const PixelCounts counts = counted(view);
      std::size_t differing = 0;
      for (std::size_t i = 0; i < resting.size(); ++i) differing += moving[i] != resting[i] ? 1 : 0;
      EXPECT_GT(counts.part, 10'000U) << model->part.file;
      EXPECT_LE(static_cast<double>(differing), 0.5 * texel_px * 0.5 * static_cast<double>(counts.border))
          << model->part.file << " along " << direction.x << ", " << direction.y << ", " << direction.z;
      all_pixels += counts.part;
      all_differing += differing;
    }
  }
  std::cout << models.size() << " parts: " << all_differing << " of " << all_pixels << " pixels differ\n";
}

std::vector<float> depths(const gl::Functions& gl, const ShadowMaps& maps, bool plus) {
  const int size = maps.settings().resolution;
  std::vector<float> values(static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  gl.BindFramebuffer(GL_FRAMEBUFFER, maps.framebuffer(plus));
  gl.ReadPixels(0, 0, size, size, GL_DEPTH_COMPONENT, GL_FLOAT, values.data());
  return values;
}

TEST_P(Moving, HasTheDepthsOfMapsDrawnByTheGl) {
  const gl::Context& context = test::shared_context();
  Part part;
  part.mesh = test::snap_hook({}).mesh;
  const auto model = prepare_part(std::move(part), {});
  PictureMaps moving(context, model), drawn(context, model);
  Query query;
  query.method.resolution = 256;
  query.method.kernel_shape = GetParam();
  for (const glm::dvec3& direction : {glm::dvec3(0.1, 0.2, 1.0), glm::dvec3(0.3, -0.5, 0.8)}) {
    query.direction = direction;
    moving.draw_moving(query);
    moving.complete_depths();
    drawn.draw_resting(query);
    for (const bool plus : {true, false}) {
      const auto expected = depths(context.functions(), drawn.maps(), plus);
      const auto found = depths(context.functions(), moving.maps(), plus);
      std::size_t covered = 0, differing = 0;
      for (std::size_t i = 0; i < found.size(); ++i) {
        covered += expected[i] < 1.0F ? 1 : 0;
        differing += std::abs(found[i] - expected[i]) > k_map_rounding ? 1 : 0;
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
