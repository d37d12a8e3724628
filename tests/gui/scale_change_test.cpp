// The window goes from one monitor to a finer one.
#include <map>

#include <gtest/gtest.h>

#include "io/mesh_writer.hpp"
#include "replay/offscreen.hpp"
#include "support/boxes.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::gui {
namespace {

TEST(ScaleChange, LeavesTheRendererInOrder) {
  const moldlight::test::ScratchFolder folder;
  const TriangleMesh mesh = moldlight::test::box_mesh({0, 0, 0}, {3, 2, 1});
  const std::vector<Region> regions(mesh.facets.size(), Region::both);
  write_coloured_mesh(folder.file("box.stl"), {.mesh = mesh, .regions = regions});
  OffscreenOptions options;
  options.size = {1600, 1000};
  OffscreenWindow window(options);
  window.app().open(folder.file("box.stl"));
  window.wait_until_loaded();
  const std::vector<std::uint8_t> coarse = window.pixels();
  window.set_content_scale(2.0F);
  window.settle();  // an error of the GL would throw
  EXPECT_NE(window.pixels(), coarse);
  window.set_content_scale(1.0F);
  window.settle();
}

/// Where the panels are, by name.
std::map<std::string, ScreenBox> panels(OffscreenWindow& window) {
  std::map<std::string, ScreenBox> found;
  for (const auto& [name, box] : window.app().controls()) {
    if (name.starts_with("panel ")) found[name] = box;
  }
  return found;
}

TEST(ScaleChange, PanelsMakeRoomForEachOtherAndComeBackToTheirPlaces) {
  const moldlight::test::ScratchFolder folder;
  const TriangleMesh mesh = moldlight::test::box_mesh({0, 0, 0}, {3, 2, 1});
  const std::vector<Region> regions(mesh.facets.size(), Region::both);
  write_coloured_mesh(folder.file("box.stl"), {.mesh = mesh, .regions = regions});
  OffscreenOptions options;
  options.user.window.quick_sweep = false;
  OffscreenWindow window(options);
  window.app().open(folder.file("box.stl"));
  window.wait_until_loaded();
  window.wait_until_measured();
  const auto first = panels(window);
  ASSERT_EQ(first.size(), 4U) << "step, verdict, look, maps";
  const glm::ivec2 sizes[] = {{800, 600}, {1280, 800}, {1024, 640}, {2560, 1440}};
  const float scales[] = {1.0F, 2.0F, 1.0F, 2.0F};
  for (std::size_t k = 0; k < std::size(sizes); ++k) {
    window.resize(sizes[k]);
    window.set_content_scale(scales[k]);
    window.settle();
    const auto now = panels(window);
    EXPECT_EQ(now.size(), first.size());
    for (const auto& [name, box] : now) {
      EXPECT_LE(box.max.y, static_cast<float>(sizes[k].y)) << name << " at " << sizes[k].x;
      for (const auto& [other, beside] : now) {
        const bool apart = name == other || box.max.x <= beside.min.x || beside.max.x <= box.min.x ||
                           box.max.y <= beside.min.y || beside.max.y <= box.min.y;
        EXPECT_TRUE(apart) << name << " covers " << other << " at " << sizes[k].x;
      }
    }
  }
  window.resize(options.size);
  window.set_content_scale(1.0F);
  window.settle();
  const auto last = panels(window);
  for (const auto& [name, box] : first) {
    EXPECT_EQ(last.at(name).min, box.min) << name;
    EXPECT_EQ(last.at(name).max, box.max) << name;
  }
}

}  // namespace
}  // namespace moldlight::gui
