// Pictures of known shapes against golden ones; support/golden.hpp says how to replace these.
#include <gtest/gtest.h>

#include "support/classify_mesh.hpp"
#include "support/golden.hpp"
#include "support/shape_picture.hpp"

namespace moldlight {
namespace {

using test::matches_golden;
using test::Shape;
using test::ShapePicture;
using test::ShapeSettings;

ViewSettings flat_backdrop() {
  ViewSettings settings;
  settings.backdrop = Backdrop::flat;
  settings.arrows = false;
  settings.samples = 8;
  return settings;
}

Image drawn(const Shape& shape, const ViewSettings& settings) {
  ShapePicture picture(test::shared_context(), shape);
  return picture.draw(picture.camera(), settings);
}

TEST(GoldenPictures, CupWithSideHole) {
  EXPECT_TRUE(
      matches_golden(drawn(cup_with_side_hole(ShapeSettings{}), flat_backdrop()), "cup_with_side_hole"));
}

TEST(GoldenPictures, SpoolHidesPartOfItsLowerFlange) {
  ViewSettings settings = flat_backdrop();
  settings.theme = Theme::light;
  settings.palette = Palette::colour_blind_safe;
  EXPECT_TRUE(matches_golden(drawn(spool(ShapeSettings{}), settings), "spool_light_safe"));
}

TEST(GoldenPictures, ObliqueBracketCastsAShadow) {
  EXPECT_TRUE(
      matches_golden(drawn(oblique_l_bracket(ShapeSettings{}), flat_backdrop()), "oblique_l_bracket"));
}

TEST(GoldenPictures, DraftColoursOfARing) {
  ViewSettings settings = flat_backdrop();
  settings.colour_mode = ColourMode::draft_angle;
  EXPECT_TRUE(matches_golden(drawn(ring(ShapeSettings{}), settings), "ring_draft"));
}

TEST(GoldenPictures, OpenedMold) {
  ViewSettings settings = flat_backdrop();
  settings.open_mold = 0.3 / k_mold_travel;
  settings.arrows = true;
  ShapePicture picture(test::shared_context(), snap_hook(ShapeSettings{}));
  Camera camera = picture.camera();
  camera.height *= 1.9;
  EXPECT_TRUE(matches_golden(picture.draw(camera, settings), "snap_hook_opened"));
}

TEST(GoldenPictures, SectionThroughAHollowSphere) {
  ViewSettings settings = flat_backdrop();
  settings.cut_at = 0.05;
  EXPECT_TRUE(matches_golden(drawn(hollow_sphere(ShapeSettings{}), settings), "hollow_sphere_section"));
}

TEST(GoldenPictures, UndercutsThroughTheRest) {
  ViewSettings settings = flat_backdrop();
  settings.transparency = 0.75;
  EXPECT_TRUE(matches_golden(drawn(dovetail_slot(ShapeSettings{}), settings), "dovetail_slot_ghost"));
}

TEST(GoldenPictures, FacetEdgesLevelLinesAndContourEdges) {
  ViewSettings settings = flat_backdrop();
  settings.facet_edges = settings.near_vertical = settings.contour_edges = true;
  settings.colour_mode = ColourMode::plain;
  const Shape shape = cup(ShapeSettings{});
  ShapePicture picture(test::shared_context(), shape);
  const PartModel& model = *picture.model;
  const auto classes = facet_classes(model.geometry, shape.direction, picture.query.method.tau_deg);
  picture.view.set_contour_edges(contour_edges(model.part.mesh, model.edges.convex, classes, model.frame),
                                 contour_edges(model.part.mesh, model.edges.concave, classes, model.frame));
  EXPECT_TRUE(matches_golden(picture.draw(picture.camera(), settings), "cup_edges"));
}

TEST(GoldenPictures, PerspectiveAndSymmetricKernel) {
  ShapePicture picture(test::shared_context(), plate_with_side_pocket(ShapeSettings{}));
  picture.query.method.kernel_shape = KernelShape::symmetric;
  picture.find_regions();
  Camera camera = picture.camera();
  camera.projection = Projection::perspective;
  camera.fov_deg = 45.0;
  camera.height *= 1.3;
  ViewSettings settings = flat_backdrop();
  settings.regions_by = RegionsBy::maps;
  EXPECT_TRUE(matches_golden(picture.draw(camera, settings), "side_pocket_symmetric"));
}

TEST(GoldenPictures, DifferenceOfCoarseMapsFromExactRegions) {
  ViewSettings settings = flat_backdrop();
  settings.mark_difference = true;
  ShapePicture picture(test::shared_context(), oblique_l_bracket(ShapeSettings{}));
  picture.query.method.resolution = 64;
  picture.query.method.kernel = 3;
  picture.find_regions();
  Camera camera = panned(picture.camera(), {0.0, -30.0}, picture.target().size);
  camera.height *= 0.25;
  EXPECT_TRUE(matches_golden(picture.draw(camera, settings), "difference_exact"));
  settings.regions_by = RegionsBy::maps;
  settings.theme = Theme::light;
  settings.palette = Palette::colour_blind_safe;
  EXPECT_TRUE(matches_golden(picture.draw(camera, settings), "difference_maps_light_safe"));
}

TEST(GoldenPictures, TheComparisonSeesADifference) {
  const Image one = drawn(cup_with_side_hole(ShapeSettings{}), flat_backdrop());
  ViewSettings plain = flat_backdrop();
  plain.colour_mode = ColourMode::plain;
  const test::PictureDifference apart =
      test::picture_difference(one, drawn(cup_with_side_hole(ShapeSettings{}), plain));
  EXPECT_GT(apart.off_share, 0.004);
  const test::PictureDifference none = test::picture_difference(one, one);
  EXPECT_EQ(none.mean + none.off_share, 0.0);
}

}  // namespace
}  // namespace moldlight
