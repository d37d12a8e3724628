// Opening parts: from files good and bad, dropped, changed on the disk, given up half-way; what they look
// like.
#include <chrono>
#include <filesystem>
#include <thread>

#include "gui/window_with_part.hpp"
#include "io/mesh_writer.hpp"
#include "support/boxes.hpp"
#include "support/mesh_edits.hpp"

namespace moldlight::gui::test {
namespace {

using moldlight::test::box_mesh;

void write_mesh(const std::string& path, const TriangleMesh& mesh) {
  const std::vector<Region> regions(mesh.facets.size(), Region::core);
  write_coloured_mesh(path, {mesh, regions});
}

TEST_F(WindowWithPart, ABadFileLeavesThePart) {
  const auto model = state().model;
  const std::string bad = part.folder().write("bad.stl", "solid nothing\nfacet normal 0 0 1\n outer lo");
  window.app().open(bad);
  window.wait_until_loaded();
  EXPECT_EQ(state().model, model);
  EXPECT_EQ(state().path, part.file());
  ASSERT_EQ(state().toasts.size(), 1U);
  EXPECT_TRUE(state().toasts[0].failure);
  EXPECT_NE(state().toasts[0].text.find("bad.stl"), std::string::npos) << state().toasts[0].text;
  EXPECT_EQ(state().toasts[0].text.find('\n'), std::string::npos);
  key({.key = k_escape});
  EXPECT_TRUE(state().toasts.empty());
}

TEST_F(WindowWithPart, ADroppedFileIsOpened) {
  const std::string box = part.output("box.stl");
  write_mesh(box, box_mesh({0, 0, 0}, {3, 2, 1}));
  window.drop(box);
  window.frame();
  window.settle();
  EXPECT_NE(state().path, box) << "it may be meant for a comparison";
  click("Open");
  window.wait_until_loaded();
  EXPECT_EQ(state().path, box);
  EXPECT_EQ(state().model->part.mesh.facets.size(), 12U);
  ASSERT_EQ(state().recent.size(), 2U);
  EXPECT_EQ(state().recent[0], box);
  EXPECT_FALSE(state().can_undo);
}

TEST_F(WindowWithPart, AChangedFileIsReadAgain) {
  window.wait_until_measured();
  enter(Step::part);
  slide("Near-vertical below", 0.5F);
  const double tau = method().tau_deg;
  const Camera camera = state().camera;
  write_mesh(part.file(), box_mesh({0, 0, 0}, {30, 20, 10}));
  const auto start = std::chrono::steady_clock::now();
  while (state().model->part.mesh.facets.size() != 12) {
    window.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    ASSERT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(60));
  }
  EXPECT_EQ(method().tau_deg, tau) << "settings stay";
  EXPECT_EQ(state().camera, camera) << "the camera stays";
}

TEST_F(WindowWithPart, OpeningTheMoldMovesTheHalves) {
  enter(Step::mold);
  window.wait_until_measured();
  window.settle();
  const std::vector<std::uint8_t> closed = window.pixels();
  slide("Opened", 0.8F);
  window.settle();
  EXPECT_GT(state().settings.look.open_mold, 0.7);
  EXPECT_NE(window.pixels(), closed);
  undo();
  window.settle();
  EXPECT_EQ(state().settings.look.open_mold, 0.0);
}

TEST_F(WindowWithPart, SameInputSamePicture) {
  const auto play = [&] {
    OffscreenWindow other(options());
    other.app().open(part.file());
    other.wait_until_loaded();
    other.wait_until_measured();
    other.move_mouse({640, 360});
    other.settle();
    other.press_key({.key = 'O'});
    other.wait_until_measured();  // halves and slides are made meanwhile
    other.settle();
    return other.pixels();
  };
  EXPECT_EQ(play(), play());
}

TEST_F(WindowWithPart, AnIdleWindowWantsNoFrames) {
  window.wait_until_measured();
  window.move_mouse({-1e6F, -1e6F});
  window.settle();
  EXPECT_TRUE(std::isinf(window.app().next_frame_s()));
}

}  // namespace
}  // namespace moldlight::gui::test
