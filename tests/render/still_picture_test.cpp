// Still pictures: the undercuts are in view, the legend is there, and the same input gives the same picture.
#include "classify/still_picture.hpp"

#include <cstdint>

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "classify/still_picture.hpp"
#include "render/camera.hpp"
#include "support/classify_mesh.hpp"
#include "support/golden.hpp"
#include "support/shape_picture.hpp"
#include "support/shapes.hpp"

namespace moldlight {
namespace {

using test::Shape;
using test::ShapeSettings;

struct Classified {
  explicit Classified(const Shape& shape) : model(test::model_of(shape.mesh)) {
    Classifier classifier(test::shared_context(), model);
    Query query;
    query.direction = shape.direction;
    query.method.samples = 20'000;
    query.method.resolution = 512;
    result = classifier.classify(query, Progress{});
  }
  [[nodiscard]] Image picture(const StillSettings& settings) {
    return StillPainter(test::shared_context(), model).draw(result, settings, {});
  }
  std::shared_ptr<const PartModel> model;
  Classification result;
};

/// Pixels that are red, as undercuts are in any light.
std::size_t red_pixels(const Image& image) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < image.rgba.size(); i += 4) {
    count +=
        image.rgba[i] > 90 && image.rgba[i] > 3 * image.rgba[i + 1] && image.rgba[i] > 3 * image.rgba[i + 2]
            ? 1
            : 0;
  }
  return count;
}

TEST(StillPicture, LooksWhereTheUndercutsAre) {
  const glm::dquat turn = glm::normalize(glm::dquat(0.6, -0.3, 0.5, 0.2));
  for (const Shape& shape : {cup_with_side_hole(ShapeSettings{}), plate_with_side_pocket(ShapeSettings{}),
                             t_slot(ShapeSettings{}), test::turned(snap_hook(ShapeSettings{}), turn)}) {
    Classified part(shape);
    const Image image = part.picture({.size = {240, 180}, .look = {.arrows = false}, .legend = false});
    EXPECT_EQ(image.width, 240);
    EXPECT_EQ(image.height, 180);
    EXPECT_GT(red_pixels(image), 100U) << shape.name;
  }
}

TEST(StillPicture, KeepsTheDirectionUpwardAndIsTheSameEveryTime) {
  const Shape shape = test::turned(spool(ShapeSettings{}), glm::normalize(glm::dquat(0.6, -0.3, 0.5, 0.2)));
  Classified part(shape);
  const auto split = std::make_shared<const SplitMesh>(test::exact_regions(*part.model, part.result.query()));
  const Camera camera{.orientation =
                          revealing_orientation(*part.model, std::span(&split, 1), part.result.direction)};
  EXPECT_GT(glm::dot(camera.up(), shape.direction), 0.5);
  EXPECT_NEAR(glm::dot(camera.right(), shape.direction), 0.0, 1e-9);
  const StillSettings settings{.size = {300, 200}};
  EXPECT_EQ(part.picture(settings).rgba, part.picture(settings).rgba);
}

/// A body far to the side, on a slant: of its box two corners say little of the room that it takes.
TEST(StillPicture, HasRoomForBodies) {
  const Classified part(cup_with_side_hole(ShapeSettings{}));
  const double diagonal = part.model->frame.diagonal;
  for (const glm::dvec3 way :
       {glm::dvec3(1, -1, 0), glm::dvec3(-1, -1, 0), glm::dvec3(1, 1, -1), glm::dvec3(-1, 1, -1)}) {
    StillBody body{.mesh = part.model->part.mesh, .colour = {255, 0, 255}, .label = {}};
    body.motion = glm::translate(glm::dmat4(1.0), diagonal * way);
    const Image image =
        StillPainter(test::shared_context(), part.model)
            .draw(part.result, {.size = {600, 400}, .look = {.arrows = false}}, {}, std::span(&body, 1));
    std::size_t seen = 0, at_the_edge = 0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const std::uint8_t* pixel = &image.rgba[4 * static_cast<std::size_t>(y * image.width + x)];
        if (pixel[0] < pixel[1] + 40 || pixel[2] < pixel[1] + 40) continue;
        ++seen;
        at_the_edge += x == 0 || y == 0 || x + 1 == image.width || y + 1 == image.height ? 1 : 0;
      }
    }
    EXPECT_GT(seen, 1000U);
    EXPECT_EQ(at_the_edge, 0U);
  }
}

/// On nothing a body is its own colour, as opaque as it is elsewhere, and the part stays opaque.
TEST(StillPicture, ShowsBodiesWithoutABackdrop) {
  const Classified part(cup_with_side_hole(ShapeSettings{}));
  StillBody body{.mesh = part.model->part.mesh, .colour = {255, 0, 255}, .label = {}};
  body.motion = glm::translate(glm::dmat4(1.0), part.model->frame.diagonal * glm::dvec3(1, -1, 0));
  const Image image =
      StillPainter(test::shared_context(), part.model)
          .draw(part.result,
                {.size = {300, 200}, .look = {.arrows = false}, .legend = false, .backdrop = Backdrop::none},
                {}, std::span(&body, 1));
  std::size_t of_body = 0, of_part = 0;
  for (std::size_t k = 0; k < image.rgba.size(); k += 4) {
    const std::uint8_t* pixel = &image.rgba[k];
    const bool magenta = pixel[0] >= 140 && pixel[1] <= 20 && pixel[2] >= 140;
    of_body += magenta && pixel[3] >= 180 && pixel[3] <= 188 ? 1 : 0;  // 0.72
    of_part += pixel[3] == 255 ? 1 : 0;
  }
  EXPECT_GT(of_body, 500U);
  EXPECT_GT(of_part, 500U);
}

/// Along z the cup's hole is the undercut, on its side; along the hole it is the inside, seen from above:
/// from one side both are seen.
TEST(StillPicture, OfSeveralDirectionsIsFromOneSideThatShowsTheUndercutsOfAll) {
  const Classified part(cup_with_side_hole(ShapeSettings{}));
  std::vector<Classification> results;
  std::vector<std::shared_ptr<const SplitMesh>> splits;
  for (const glm::dvec3 direction : {glm::dvec3(0, 0, 1), glm::dvec3(1, 0, 0)}) {
    Query query = part.result.query();
    query.direction = direction;
    results.push_back(classify_exact(*part.model, query, Progress(), true));
    splits.push_back(results.back().split);
  }
  StillPainter painter(test::shared_context(), part.model);
  const Camera camera{.orientation = painter.seen_best(results)};
  EXPECT_EQ(camera.orientation, revealing_orientation(*part.model, splits, {0, 0, 1}));
  for (std::size_t k = 0; k < 2; ++k) {
    StillSettings settings{.size = {300, 200}, .legend = false};
    settings.seen_from = camera.orientation;
    EXPECT_GT(red_pixels(painter.draw(results[k], settings, Progress())), 100U) << k;
  }
}

TEST(StillPicture, HasALegendWhereThereIsRoom) {
  Classified part(cup_with_side_hole(ShapeSettings{}));
  for (const glm::ivec2& size : {glm::ivec2(640, 400), glm::ivec2(480, 640)}) {
    StillSettings settings{.size = size, .look = {.arrows = false}};
    const Image with = part.picture(settings);
    settings.legend = false;
    const Image without = part.picture(settings);
    EXPECT_GT(test::picture_difference(with, without).off_share, 0.02);
  }
  StillSettings small{.size = {200, 150}};
  const Image with = part.picture(small);
  small.legend = false;
  EXPECT_EQ(with.rgba, part.picture(small).rgba) << "too small for a legend";
}

TEST(StillPicture, DrawsAPartWithoutUndercutsToo) {
  Classified part(box_shape(ShapeSettings{}));
  for (const PictureView view :
       {PictureView::automatic, PictureView::isometric, PictureView::front, PictureView::back,
        PictureView::left, PictureView::right, PictureView::top, PictureView::bottom}) {
    const Image image = part.picture({.size = {160, 120}, .view = view, .theme = Theme::dark});
    EXPECT_EQ(red_pixels(image), 0U);
    EXPECT_GT(image.at(80, 60)[0] + image.at(80, 60)[1] + image.at(80, 60)[2], 150)
        << "the part is in the middle";
  }
}

TEST(StillOptions, SizesAreReadStrictly) {
  EXPECT_EQ(parse_picture_size("640x480", "--size"), glm::ivec2(640, 480));
  for (const char* text :
       {"", "640", "640x", "x480", "640x480x2", "8x480", "640x99999", "-640x480", "640 480"}) {
    EXPECT_THROW(static_cast<void>(parse_picture_size(text, "--size")), UsageError) << text;
  }
  EXPECT_EQ(parse_picture_size("320x240", "--size", {320, 240}), glm::ivec2(320, 240));
  for (const char* text : {"319x240", "320x239"}) {
    EXPECT_THROW(static_cast<void>(parse_picture_size(text, "--size", {320, 240})), UsageError) << text;
  }
}

}  // namespace
}  // namespace moldlight
