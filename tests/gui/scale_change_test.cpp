// The window goes from one monitor to a finer one.
#include <gtest/gtest.h>

#include "gui/offscreen.hpp"
#include "io/mesh_writer.hpp"
#include "support/boxes.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::gui {
namespace {

TEST(ScaleChange, LeavesTheRendererInOrder) {
  const test::ScratchFolder folder;
  const TriangleMesh mesh = test::box_mesh({0, 0, 0}, {3, 2, 1});
  const std::vector<Region> regions(mesh.facets.size(), Region::both);
  write_coloured_mesh(folder.file("box.stl"), {.mesh = mesh, .regions = regions});
  OffscreenWindow window(
      {.size = {640, 480}, .content_scale = 1.0F, .user = {}, .reading = {}, .shipped_parts = {}});
  window.app().open(folder.file("box.stl"));
  window.wait_until_loaded();
  const std::vector<std::uint8_t> coarse = window.pixels();
  window.set_content_scale(2.0F);
  window.settle();  // an error of the GL would throw
  EXPECT_NE(window.pixels(), coarse);
  window.set_content_scale(1.0F);
  window.settle();
}

}  // namespace
}  // namespace moldlight::gui
