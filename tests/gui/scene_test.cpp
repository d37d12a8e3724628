// The scene draws its maps anew for every setting on which they depend.
#include "gui/view/scene.hpp"

#include <gtest/gtest.h>

#include "classify/method_options.hpp"
#include "classify/option.hpp"
#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight::gui::test {
namespace {

constexpr glm::ivec2 k_size(320, 240);

Query base_query() {
  Query query;
  query.direction = glm::dvec3(0.03, 0.0, 1.0);  // walls along x are vertical, those along y lean
  query.method.resolution = 80;                  // coarse, so that every control of the maps shows
  return query;
}

/// Another value, far from the present one.
void change(const Option<MethodSettings>& option, MethodSettings& settings) {
  using S = MethodSettings;
  std::visit(moldlight::detail::Overloaded{
                 [&](const RealKind<S>& kind) { settings.*kind.member = kind.max; },
                 [&](const PositiveKind<S>& kind) { kind.member(settings) = 2.0; },
                 [&](const IntegerKind<S>& kind) {
                   settings.*kind.member = option.key == "resolution" ? 100 : kind.max;
                 },
                 [&](const SwitchKind<S>& kind) { settings.*kind.member = !(settings.*kind.member); },
                 [&](const ChoiceKind<S>& kind) { kind.set(settings, kind.get(settings) == 0 ? 1 : 0); },
                 [](const auto&) { FAIL() << "no option of the method"; },
             },
             option.kind);
}

class SceneMaps : public ::testing::Test {
 protected:
  SceneMaps() : context_(&moldlight::test::shared_context()), target_(context_->functions(), k_size) {
    loaded_.model = moldlight::test::model_of(moldlight::test::plate_with_side_pocket({}).mesh);
    const PartModel& model = *loaded_.model;
    loaded_.geometry = std::make_shared<const ViewGeometry>(
        view_geometry(model.part.mesh, model.geometry, model.adjacency, model.frame));
    loaded_.faces = std::make_shared<const Faces>(part_faces(model.part, model.geometry, model.adjacency));
  }

  std::vector<std::uint8_t> picture(Scene& scene, const Query& query) const {
    SceneSettings settings;
    settings.query = query;
    settings.maps_looked_at = true;
    settings.view.settings.samples = 1;
    settings.view.settings.arrows = false;
    settings.view.camera.orientation = standard_orientation(StandardView::isometric);
    settings.view.camera =
        fitted(settings.view.camera, unit_positions(loaded_.model->part.mesh, loaded_.model->frame), k_size);
    scene.draw({.framebuffer = target_.framebuffer(), .size = k_size}, settings);
    return target_.read();
  }

  const gl::Context* context_;
  gl::ColourTarget target_;
  LoadedPart loaded_;
};

TEST_F(SceneMaps, AreThoseOfTheSettingsWhateverWasDrawnBefore) {
  Scene scene(*context_, loaded_);
  const auto seen_in_picture = [&](const Query& changed, std::string_view what) {
    const std::vector<std::uint8_t> before = picture(scene, base_query());
    const std::vector<std::uint8_t> after = picture(scene, changed);
    Scene fresh(*context_, loaded_);
    EXPECT_TRUE(after == picture(fresh, changed)) << what << ": the maps are stale";
    return after != before;
  };
  EXPECT_TRUE(seen_in_picture({glm::dvec3(0.3, 0.1, 1.0), base_query().method}, "direction"));
  std::vector<std::string_view> seen;
  for (const Option<MethodSettings>& option : method_options()) {
    Query query = base_query();
    change(option, query.method);
    ASSERT_NE(option_text(option, query.method), option_text(option, base_query().method)) << option.key;
    if (seen_in_picture(query, option.key)) seen.push_back(option.key);
  }
  const std::vector<std::string_view> expected = {"tau_deg",      "kernel",         "tolerance",
                                                  "kernel_shape", "edge_thickness", "resolution"};
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace moldlight::gui::test
