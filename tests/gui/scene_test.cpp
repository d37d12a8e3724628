// The scene draws its maps anew for every setting on which they depend.
#include "gui/view/scene.hpp"

#include <gtest/gtest.h>

#include "classify/method_options.hpp"
#include "classify/option_table.hpp"
#include "support/classify_mesh.hpp"
#include "support/shapes.hpp"

namespace moldlight::gui::test {
namespace {

constexpr glm::ivec2 k_size(320, 240);

MethodSettings base_settings() {
  MethodSettings method;
  method.direction = {0.03, 0.0, 1.0};  // walls along x are vertical, those along y lean
  method.resolution = 80;               // coarse, so that every control of the maps shows
  return method;
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
                 [&](const DirectionKind<S>& kind) {
                   settings.*kind.member = {0.3, 0.1, 1.0};
                 },
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
  }

  std::vector<std::uint8_t> picture(Scene& scene, const MethodSettings& method) const {
    SceneSettings settings;
    settings.method = method;
    settings.maps_looked_at = true;
    settings.view.settings.samples = 1;
    settings.view.settings.arrows = false;
    settings.view.settings.contour_edges = true;
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
  std::vector<std::string_view> seen;
  for (const Option<MethodSettings>& option : method_options()) {
    const std::vector<std::uint8_t> before = picture(scene, base_settings());
    MethodSettings method = base_settings();
    change(option, method);
    ASSERT_NE(option_text(option, method), option_text(option, base_settings())) << option.key;
    const std::vector<std::uint8_t> after = picture(scene, method);
    Scene fresh(*context_, loaded_);
    EXPECT_TRUE(after == picture(fresh, method)) << option.key << ": the maps are stale";
    if (after != before) seen.push_back(option.key);
  }
  const std::vector<std::string_view> expected = {"direction",    "tau_deg",        "kernel",    "tolerance",
                                                  "kernel_shape", "edge_thickness", "resolution"};
  EXPECT_EQ(seen, expected);
}

}  // namespace
}  // namespace moldlight::gui::test
