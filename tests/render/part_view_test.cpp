// What the pictures show, beyond their looks: the right facet and region at every pixel, the same bits on
// every backend, refinement that ends, marks that change nothing below them.
#include "render/part_view.hpp"

#include <algorithm>
#include <cmath>
#include <iostream>

#include <gtest/gtest.h>

#include "gl/headless_context.hpp"
#include "mesh/faces.hpp"
#include "mold/exact_rays.hpp"
#include "support/boxes.hpp"
#include "support/classify_mesh.hpp"
#include "support/golden.hpp"
#include "support/shape_picture.hpp"
#include "support/sight_line.hpp"

namespace moldlight {
namespace {

using test::Shape;
using test::ShapePicture;
using test::ShapeSettings;

ViewSettings one_sample() {
  ViewSettings settings;
  settings.samples = 1;
  settings.ambient_occlusion = settings.arrows = false;
  return settings;
}

/// Of the pixels that show the shape: shares whose facet and whose region are not what exact rays find.
struct PixelErrors {
  std::size_t pixels = 0;
  double facet = 0.0, region = 0.0;
};

PixelErrors pixel_errors(ShapePicture& picture, const Camera& camera, RegionsBy by) {
  ViewSettings settings = one_sample();
  settings.regions_by = by;
  static_cast<void>(picture.draw(camera, settings));
  const PartModel& model = *picture.model;
  const glm::ivec2 size = picture.target().size;
  const auto facets = picture.view.read_facets();
  const auto regions = picture.view.read_regions();
  const glm::dvec3 direction = picture.maps.maps().frame().z;
  const AccessibilityQuery query{direction, picture.maps.maps().settings().lateral};
  PixelErrors errors;
  for (int row = 0; row < size.y; ++row) {
    for (int x = 0; x < size.x; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) + static_cast<std::size_t>(x);
      const test::SightLine line = test::sight_line(camera, size, {x + 0.5, size.y - row - 0.5});
      const auto hit = model.rays().first_hit(glm::vec3(line.origin), glm::vec3(line.direction), true);
      if (facets[pixel] == 0) {
        errors.facet += hit ? 1.0 : 0.0;
        continue;
      }
      ++errors.pixels;
      const FacetIndex facet = facets[pixel] - 1;
      errors.facet += hit && hit->facet == facet ? 0.0 : 1.0;
      const glm::dvec3& normal = model.geometry.normals[facet];
      const glm::dvec3 corner(model.frame.to_unit(model.part.mesh.corner(facet, 0)));
      const glm::dvec3 point = line.origin + line.direction * (glm::dot(normal, corner - line.origin) /
                                                               glm::dot(normal, line.direction));
      const FacetClass own = facet_class(normal, direction, picture.query.method.tau_deg);
      const auto accessible = [&](bool plus) {
        const glm::vec3 along(plus ? direction : -direction), from(point);
        if (own == FacetClass::near_vertical)
          return !model.rays().first_hit(lateral_point(from, normal, query), along, false);
        return plus == (own == FacetClass::up) &&
               !model.rays().surface_point_blocked(from, glm::vec3(normal), along);
      };
      const unsigned bits = (accessible(true) ? 1U : 0U) | (accessible(false) ? 2U : 0U);
      errors.region += bits == regions[pixel] ? 0.0 : 1.0;
    }
  }
  errors.facet /= static_cast<double>(errors.pixels);
  errors.region /= static_cast<double>(errors.pixels);
  return errors;
}

TEST(PartView, ShowsTheFacetAndTheRegionThatRaysFind) {
  for (const Shape& shape :
       {cup_with_side_hole(ShapeSettings{}), spool(ShapeSettings{}), t_slot(ShapeSettings{}),
        oblique_l_bracket(ShapeSettings{}), hollow_sphere(ShapeSettings{})}) {
    for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
      ShapePicture picture(test::shared_context(), shape);
      Camera camera = picture.camera();
      camera.projection = projection;
      const PixelErrors exact = pixel_errors(picture, camera, RegionsBy::exact);
      EXPECT_GT(exact.pixels, 5000U) << shape.name;
      EXPECT_LT(exact.facet, 0.002) << shape.name;
      EXPECT_LT(exact.region, 0.0002) << shape.name;
      const PixelErrors maps = pixel_errors(picture, camera, RegionsBy::maps);
      EXPECT_LT(maps.facet, 0.002) << shape.name;
      EXPECT_LT(maps.region, 0.006) << shape.name;
    }
  }
}

TEST(PartView, PicksWhatIsSeen) {
  const Shape shape = cup_with_side_hole(ShapeSettings{});
  ShapePicture picture(test::shared_context(), shape);
  const Camera camera = picture.camera();
  const PartModel& model = *picture.model;
  for (const double opened : {0.0, 0.2}) {
    ViewSettings settings = one_sample();
    settings.open_mold = opened / k_mold_travel;
    static_cast<void>(picture.draw(camera, settings));
    EXPECT_FALSE(picture.view.pick({0, 0}));
    EXPECT_FALSE(picture.view.pick({-1, 20}));
    EXPECT_FALSE(picture.view.pick(picture.target().size));
    int found = 0;
    for (int x = 5; x < 200; x += 10) {
      for (int y = 5; y < 150; y += 10) {
        const auto point = picture.view.pick({x, y});
        if (!point) continue;
        ++found;
        const glm::dvec3 corner(model.frame.to_unit(model.part.mesh.corner(point->facet, 0)));
        EXPECT_NEAR(glm::dot(model.geometry.normals[point->facet], glm::dvec3(point->position) - corner), 0.0,
                    1e-5);
        if (opened > 0.0) continue;
        const auto seen = project(camera, picture.target().size, glm::dvec3(point->position));
        EXPECT_LT(glm::distance(*seen, glm::dvec2(x + 0.5, y + 0.5)), 0.01);
      }
    }
    EXPECT_GT(found, 50);
  }
}

struct Drawn {
  std::vector<std::uint32_t> facets;
  std::vector<std::uint8_t> regions;
  Image picture;
};

Drawn draw_on(gl::HeadlessBackend backend, const Shape& shape, std::string& renderer) {
  const auto context = gl::create_headless_context(backend);
  renderer = context->renderer();
  ShapePicture picture(*context, shape);
  Drawn drawn;
  ViewSettings settings;
  settings.samples = 4;
  settings.arrows = settings.mark_difference = true;
  drawn.picture = picture.draw(picture.camera(), settings);
  static_cast<void>(picture.draw(picture.camera(), one_sample()));
  drawn.facets = picture.view.read_facets();
  drawn.regions = picture.view.read_regions();
  return drawn;
}

TEST(PartView, BackendsAgreeToTheBit) {
  const Shape shape =
      test::turned(block_with_crossing_hole(ShapeSettings{}), glm::dquat(0.8, 0.2, -0.3, 0.1));
  std::string egl_renderer, osmesa_renderer;
  const Drawn egl = draw_on(gl::HeadlessBackend::egl, shape, egl_renderer);
  const Drawn osmesa = draw_on(gl::HeadlessBackend::osmesa, shape, osmesa_renderer);
  if (egl_renderer.find("llvmpipe") == std::string::npos) GTEST_SKIP() << "EGL draws with " << egl_renderer;
  EXPECT_EQ(egl.facets, osmesa.facets);
  EXPECT_EQ(egl.regions, osmesa.regions);
  EXPECT_EQ(egl.picture.rgba, osmesa.picture.rgba);
}

TEST(PartView, RefinesUntilItIsDoneAndStartsAgainOnChange) {
  ShapePicture picture(test::shared_context(), spool(ShapeSettings{}));
  ViewSettings settings;
  settings.samples = 5;
  settings.arrows = false;
  const ViewTarget target = picture.target();
  const auto draw = [&](const Camera& camera) {
    return picture.view.draw(target, picture.maps.subject(), {camera, settings});
  };
  const Camera camera = picture.camera();
  for (int sample = 1; sample < settings.samples; ++sample) EXPECT_TRUE(draw(camera)) << sample;
  EXPECT_FALSE(draw(camera));
  const Image done = picture.read();
  EXPECT_FALSE(draw(camera));
  EXPECT_EQ(picture.read().rgba, done.rgba) << "a finished picture stays as it is";

  const Camera other = panned(camera, {3.0, 0.0}, target.size);
  EXPECT_TRUE(draw(other));
  EXPECT_TRUE(draw(camera));
  picture.find_regions();
  for (int sample = 1; sample < settings.samples; ++sample) EXPECT_TRUE(draw(camera)) << "after new maps";
  EXPECT_FALSE(draw(camera));
  EXPECT_EQ(picture.read().rgba, done.rgba) << "the same picture again, to the bit";
}

/// Of every pixel: whether the pictures differ there.
std::size_t differing_pixels(const Image& a, const Image& b) {
  std::size_t pixels = 0;
  for (std::size_t k = 0; k < a.rgba.size(); k += 4)
    pixels += std::equal(a.rgba.begin() + k, a.rgba.begin() + k + 4, b.rgba.begin() + k) ? 0 : 1;
  return pixels;
}

TEST(PartView, ShowsAMovingDirectionAsAViewDoesThatHasDrawnNothingBefore) {
  const gl::Context& context = test::shared_context();
  const Shape shape = test::snap_hook({});
  ViewSettings all[5];
  all[1].cut = CutPlane{.normal = {1, 0, 0}, .offset = 0.0};
  all[2].open_mold = 0.5;
  all[3].transparency = 0.6;
  all[4].samples = 3;
  for (ViewSettings& settings : all) {
    if (&settings != &all[4]) settings.samples = 1;
    ShapePicture moving(context, shape);
    Camera camera = moving.camera();
    for (int turn = 0; turn < 6; ++turn) {
      const auto drawn = [&](ShapePicture& picture) {
        picture.query.direction = glm::dvec3(0.2 * turn, 0.1, 1.0);
        picture.maps.drop_split();
        picture.maps.draw_moving(picture.query);
        return picture.draw(camera, settings).rgba;
      };
      ShapePicture fresh(context, shape);
      EXPECT_TRUE(drawn(moving) == drawn(fresh)) << "settings " << &settings - all << ", turn " << turn;
      const auto facets = moving.view.read_facets();
      EXPECT_TRUE(facets == fresh.view.read_facets());
      const auto regions = moving.view.read_regions(), expected = fresh.view.read_regions();
      for (std::size_t pixel = 0; pixel < facets.size(); ++pixel) {
        if (facets[pixel] == 0) continue;
        ASSERT_EQ(regions[pixel], expected[pixel]);
      }
      if (turn == 3) camera = orbited(camera, {0.2, 0.1}, {0, 0, 1}, glm::dvec3(0.0));
      if (turn == 4) moving.view.set_geometry(moving.geometry);
    }
  }
}

TEST(PartView, MarksLieOnTop) {
  ShapePicture picture(test::shared_context(), cup_with_side_hole(ShapeSettings{}));
  const Camera camera = picture.camera();
  const ViewSettings settings = one_sample();
  const Image bare = picture.draw(camera, settings);
  const auto point = picture.view.pick({100, 75});
  ASSERT_TRUE(point);
  EXPECT_EQ(picture.draw(camera, settings, {.hovered = 0}).rgba, bare.rgba) << "no face is known";
  const PartModel& model = *picture.model;
  const Faces faces = smooth_faces(model.part.mesh, model.geometry, model.adjacency);
  picture.view.set_faces(faces.of_facet);
  const std::uint32_t face = faces.of_facet[point->facet];
  const std::vector<std::uint32_t> facets = picture.view.read_facets();
  const auto of_face = std::ranges::count_if(
      facets, [&](std::uint32_t number) { return number != 0 && faces.of_facet[number - 1] == face; });
  for (const ViewMarks& marks :
       {ViewMarks{.hovered = face}, ViewMarks{.blocking = face}, ViewMarks{.chosen = face}}) {
    const Image marked = picture.draw(camera, settings, marks);
    EXPECT_GT(marked.at(100, 75)[0], bare.at(100, 75)[0]);
    EXPECT_EQ(differing_pixels(marked, bare), static_cast<std::size_t>(of_face))
        << "the whole face and no more";
  }
  EXPECT_EQ(picture.draw(camera, settings).rgba, bare.rgba);
}

TEST(PartView, MarkedLinesShowThroughAndRefineNothingAnew) {
  ShapePicture picture(test::shared_context(), box_shape(ShapeSettings{}));
  const Camera camera = picture.camera();
  ViewSettings settings = one_sample();
  settings.samples = 4;
  const Image bare = picture.draw(camera, settings);
  const auto drawn_over = [&](MarkedLines which, const ViewSegment& segment) {
    picture.view.set_marked_lines(which, {&segment, 1});
    EXPECT_FALSE(picture.view.draw(picture.target(), picture.maps.subject(), {camera, settings}));
    const Image marked = picture.read();
    picture.view.set_marked_lines(which, {});
    EXPECT_FALSE(picture.view.draw(picture.target(), picture.maps.subject(), {camera, settings}));
    EXPECT_EQ(picture.read().rgba, bare.rgba);
    return differing_pixels(marked, bare);
  };
  const glm::vec3 aside(0.2 * camera.right());
  const ViewSegment behind{-aside - glm::vec3(camera.toward_viewer()),
                           aside - glm::vec3(camera.toward_viewer())};
  const ViewSegment before{-aside + glm::vec3(camera.toward_viewer()),
                           aside + glm::vec3(camera.toward_viewer())};
  EXPECT_EQ(drawn_over(MarkedLines::chosen, behind), 0U);
  EXPECT_GT(drawn_over(MarkedLines::blocking, behind), 50U);
  for (const MarkedLines which : {MarkedLines::chosen, MarkedLines::blocking, MarkedLines::ways})
    EXPECT_GT(drawn_over(which, before), 50U);
}

TEST(PartView, MarksTheDifferenceBetweenMapsAndExactRegionsAndNothingElse) {
  ShapePicture picture(test::shared_context(), oblique_l_bracket(ShapeSettings{}));
  picture.query.method.resolution = 64;
  picture.find_regions();
  const Camera camera = picture.camera();
  ViewSettings settings = one_sample();
  settings.hatching = settings.feature_edges = false;
  for (const double opened : {0.0, 0.2}) {
    for (const double transparency : {0.0, 0.6}) {
      settings.open_mold = opened / k_mold_travel;
      settings.transparency = transparency;
      for (const RegionsBy by : {RegionsBy::exact, RegionsBy::maps}) {
        settings.regions_by = by;
        settings.mark_difference = false;
        const Image bare = picture.draw(camera, settings);
        const auto shown = picture.view.read_regions();
        settings.mark_difference = true;
        const Image marked = picture.draw(camera, settings);
        EXPECT_EQ(picture.view.read_regions(), shown) << "marks change no region";
        EXPECT_NE(marked.rgba, bare.rgba);
        if (opened > 0.0 || transparency > 0.0) continue;
        settings.mark_difference = false;
        settings.regions_by = by == RegionsBy::exact ? RegionsBy::maps : RegionsBy::exact;
        static_cast<void>(picture.draw(camera, settings));
        const auto other = picture.view.read_regions();
        std::size_t differing = 0, seen = 0;
        for (std::size_t i = 0; i < shown.size(); ++i) {
          const std::size_t x = i % 200, y = 149 - i / 200, at = 4 * (y * 200 + x);
          const bool changed = !std::equal(&bare.rgba[at], &bare.rgba[at] + 4, &marked.rgba[at]);
          EXPECT_TRUE(!changed || shown[i] != other[i]) << x << ", " << y;
          differing += shown[i] != other[i] ? 1 : 0;
          seen += changed ? 1 : 0;
        }
        EXPECT_GT(differing, 20U);
        EXPECT_GT(seen, differing / 2) << "a hatch leaves gaps";
      }
    }
  }
}

TEST(PartView, ASplitSurfaceHasTheLightOfAWholeOne) {
  for (const Shape& shape : {spool(ShapeSettings{}), hollow_sphere(ShapeSettings{}),
                             test::turned(ring(ShapeSettings{}), glm::dquat(0.8, 0.2, -0.3, 0.1))}) {
    ShapePicture picture(test::shared_context(), shape);
    picture.query.direction = glm::dvec3(0.4, 0.3, 0.8);
    picture.find_regions();
    ViewSettings settings = one_sample();
    settings.colour_mode = ColourMode::draft_angle;
    const Image split = picture.draw(picture.camera(), settings);
    settings.regions_by = RegionsBy::maps;
    const Image whole = picture.draw(picture.camera(), settings);
    int worst = 0;
    for (std::size_t i = 0; i < split.rgba.size(); ++i)
      worst = std::max(worst, std::abs(int{split.rgba[i]} - int{whole.rgba[i]}));
    EXPECT_LE(worst, 4) << shape.name;
  }
}

TEST(PartView, OpeningTheMoldLeavesTheUndercutsWhereTheyAre) {
  ShapePicture picture(test::shared_context(), t_slot(ShapeSettings{}));
  const Camera camera = picture.camera();
  const auto counted = [&](double opened) {
    ViewSettings settings = one_sample();
    settings.open_mold = opened / k_mold_travel;
    static_cast<void>(picture.draw(camera, settings));
    const auto facets = picture.view.read_facets();
    const auto regions = picture.view.read_regions();
    std::vector<bool> undercut(facets.size());
    for (std::size_t i = 0; i < facets.size(); ++i) undercut[i] = facets[i] != 0 && regions[i] == 0;
    return undercut;
  };
  const std::vector<bool> closed = counted(0.0), opened = counted(0.6);
  std::size_t before = 0, kept = 0;
  for (std::size_t i = 0; i < closed.size(); ++i) {
    before += closed[i] ? 1 : 0;
    kept += closed[i] && opened[i] ? 1 : 0;
  }
  EXPECT_GT(before, 50U);
  EXPECT_GT(kept, before * 9 / 10) << "what moved away must not hide them more than a little";
}

TEST(PartView, AVeiledSurfaceShowsThroughWhatHidesItAndNowhereElse) {
  ShapePicture picture(test::shared_context(), box_shape(ShapeSettings{}));
  const Camera camera = picture.camera();
  const Image bare = picture.draw(camera, one_sample());
  const TriangleMesh& mesh = picture.model->part.mesh;
  for (FacetIndex facet = 0; facet < mesh.facets.size(); ++facet) {
    const auto& corners = picture.geometry.facets[facet];
    picture.view.set_veiled_surface(picture.geometry.vertices, {&corners, 1});
    const std::size_t veiled = differing_pixels(picture.draw(camera, one_sample()), bare);
    const double facing = glm::dot(picture.model->geometry.normals[facet], camera.toward_viewer());
    ASSERT_GT(std::abs(facing), 0.1);
    if (facing > 0.0) {
      EXPECT_EQ(veiled, 0U) << "it is in sight";
    } else {
      EXPECT_GT(veiled, 100U);
    }
  }
  picture.view.set_veiled_surface({}, {});
  EXPECT_EQ(picture.draw(camera, one_sample()).rgba, bare.rgba);
}

/// Pixels that show the cut of a section across x through a mesh, and those that show anything.
struct CutPixels {
  int cut = 0, all = 0;
};
CutPixels cut_pixels(const TriangleMesh& mesh) {
  ShapePicture picture(test::shared_context(),
                       {.name = {}, .mesh = mesh, .direction = {0, 0, 1}, .expected = {}, .settings = {}});
  Camera camera = picture.camera();
  camera.orientation = standard_orientation(StandardView::right);
  ViewSettings settings = one_sample();
  settings.cut = CutPlane{.normal = {1, 0, 0}, .offset = 0.0};
  static_cast<void>(picture.draw(camera, settings));
  CutPixels pixels;
  for (int y = 0; y < picture.target().size.y; ++y) {
    for (int x = 0; x < picture.target().size.x; ++x) {
      const auto point = picture.view.pick({x, y});
      if (!point) continue;
      ++pixels.all;
      if (point->facet != k_no_facet) continue;
      ++pixels.cut;
      EXPECT_NEAR(point->position.x, 0.0F, 1e-4F);
    }
  }
  EXPECT_GT(pixels.all, 1000);
  return pixels;
}

TEST(PartView, ASectionShowsWhereSolidsAreCutHoweverManyTheyAre) {
  using test::box_mesh, test::joined;
  const TriangleMesh box = box_mesh({0, 0, 0}, {8, 4, 4});
  const auto whole = [](const CutPixels& pixels) { return pixels.cut == pixels.all; };
  EXPECT_TRUE(whole(cut_pixels(box)));
  EXPECT_TRUE(whole(cut_pixels(joined(box, box_mesh({0, 4, 0}, {8, 6, 4}))))) << "they touch";
  EXPECT_TRUE(whole(cut_pixels(joined(box, box_mesh({1, 2, 1}, {7, 6, 3}))))) << "they overlap";
  EXPECT_TRUE(whole(cut_pixels(joined(box, box_mesh({1, 1, 1}, {5, 3, 3}))))) << "one is in the other";
  TriangleMesh open = box;
  open.facets.pop_back();
  EXPECT_EQ(cut_pixels(open).cut, 0) << "an open part encloses nothing";
  const CutPixels beside = cut_pixels(joined(open, box_mesh({0, 6, 0}, {8, 8, 4})));
  EXPECT_GT(beside.cut, beside.all / 4) << "the closed one of two";
  EXPECT_LT(beside.cut, beside.all / 2);
}

TEST(PartView, APlainPictureNeedsNoRegions) {
  ShapePicture picture(test::shared_context(), spool(ShapeSettings{}));
  ViewSettings settings = one_sample();
  settings.colour_mode = ColourMode::plain;
  const Image known = picture.draw(picture.camera(), settings);
  picture.view.draw_final(picture.target(), {.part = picture.maps.buffers()}, {picture.camera(), settings});
  EXPECT_EQ(picture.read().rgba, known.rgba);
}

TEST(PartView, NoBackdropIsTransparent) {
  ShapePicture picture(test::shared_context(), spool(ShapeSettings{}));
  ViewSettings settings;
  settings.backdrop = Backdrop::none;
  settings.arrows = false;
  settings.samples = 4;
  const Image image = picture.draw(picture.camera(), settings);
  EXPECT_EQ(image.at(0, 0)[3], 0);
  EXPECT_EQ(image.at(100, 75)[3], 255);
}

}  // namespace
}  // namespace moldlight
