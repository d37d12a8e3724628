// The sweep in the window, without a display: what it shows is what the sweep and classify give.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <thread>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "classify/headless.hpp"
#include "gui/quick_options.hpp"
#include "gui/store/files.hpp"
#include "gui/view/direction.hpp"
#include "io/mesh_writer.hpp"
#include "support/read_png.hpp"
#include "support/scratch_folder.hpp"
#include "support/shapes.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep.hpp"

namespace moldlight::gui {
namespace {

namespace fs = std::filesystem;

constexpr glm::ivec2 k_size(1280, 720);
constexpr int k_many = 4000;

MethodSettings quick_method() {
  MethodSettings method;
  method.resolution = 256;
  method.samples = 20'000;
  return method;
}

SweepSettings quick_sweep() {
  SweepSettings sweep;
  sweep.directions = 24;
  sweep.refine = 1;
  sweep.top = 3;
  sweep.scoring_samples = 1000;
  sweep.engine = SweepEngine::rays;
  return sweep;
}

/// Takes minutes.
SweepSettings long_sweep() {
  SweepSettings sweep = quick_sweep();
  sweep.directions = k_many;
  sweep.scoring_samples = 200'000;
  sweep.thorough = true;
  sweep.rank = SweepRank::objective;  // which measures nothing before all is scored
  return sweep;
}

class SweepWindow : public testing::Test {
 protected:
  explicit SweepWindow(const SweepSettings& sweep = quick_sweep()) : window_(options(sweep)) {
    window_.app().set_notes({.settings = {{{}, quick_method()}, {}}, .bookmarks = {}});
    open(moldlight::test::snap_hook({}).mesh, "hook.stl");
  }

  static OffscreenOptions options(const SweepSettings& sweep) {
    OffscreenOptions options = test::quick_options();
    options.size = k_size;
    options.user.sweep = sweep;
    options.user.window.quick_sweep = false;
    return options;
  }

  void open(const TriangleMesh& mesh, const std::string& name) {
    const std::vector<Region> regions(mesh.facets.size(), Region::both);
    const std::string path = folder_.file(name);
    write_coloured_mesh(path, {.mesh = mesh, .regions = regions});
    window_.app().open(path);
    window_.wait_until_loaded();
  }
  void press(int key) {
    window_.press_key({.key = key, .ctrl = false, .shift = false, .alt = false});
    window_.frames(2);
  }
  void sweep() {
    press(GLFW_KEY_W);
    window_.wait_until_swept();
  }
  [[nodiscard]] const SweepState& state() const { return window_.state().sweep; }
  [[nodiscard]] const SweepCandidate& candidate(std::size_t index) const {
    return state().result->candidates[index];
  }

  /// Different colours in a square about a place, each channel in steps of 16.
  [[nodiscard]] std::size_t colours_about(const glm::ivec2& middle, int half) const {
    const std::vector<std::uint8_t> pixels = window_.pixels();
    std::vector<unsigned> seen;
    for (int y = middle.y - half; y < middle.y + half; ++y) {
      for (int x = middle.x - half; x < middle.x + half; ++x) {
        const std::uint8_t* pixel = &pixels[4 * static_cast<std::size_t>(y * k_size.x + x)];
        seen.push_back(pixel[0] / 16U * 256U + pixel[1] / 16U * 16U + pixel[2] / 16U);
      }
    }
    std::sort(seen.begin(), seen.end());
    return static_cast<std::size_t>(std::unique(seen.begin(), seen.end()) - seen.begin());
  }

  moldlight::test::ScratchFolder folder_;
  OffscreenWindow window_;
};

class LongSweepWindow : public SweepWindow {
 protected:
  LongSweepWindow() : SweepWindow(long_sweep()) {}
};

TEST_F(SweepWindow, ShowsWhatTheSweepAndClassifyGive) {
  sweep();
  ASSERT_TRUE(state().result) << state().error;
  const SweepResult& shown = *state().result;
  EXPECT_TRUE(shown.complete);
  EXPECT_FALSE(state().stale);

  SweepSettings settings = quick_sweep();
  settings.method = window_.state().settings.method;
  const SweepResult expected = run_sweep(window_.state().model, settings, Progress{}, {});
  ASSERT_EQ(shown.candidates.size(), expected.candidates.size());
  ASSERT_GE(shown.candidates.size(), 2U);
  EXPECT_EQ(shown.evaluated.size(), expected.evaluated.size());
  for (std::size_t k = 0; k < shown.candidates.size(); ++k) {
    const SweepCandidate &a = shown.candidates[k], &b = expected.candidates[k];
    EXPECT_EQ(a.candidate.direction, b.candidate.direction);
    EXPECT_EQ(a.tie_group, b.tie_group);
    EXPECT_EQ(a.figures, b.figures);
    const Classification classified =
        classify_exact(*window_.state().model, {a.candidate.direction, settings.method}, Progress{});
    for (const Region region : k_regions) {
      EXPECT_EQ(a.classification.areas[region], b.classification.areas[region]);
      EXPECT_EQ(a.classification.areas[region], classified.areas[region]);
    }
    EXPECT_EQ(a.classification.uncertainty.total(), classified.uncertainty.total());
  }
}

/// The pictures of the first sweep are on the screen when the second one begins.
TEST_F(SweepWindow, SweepsAgain) {
  for (int k = 0; k < 2; ++k) {
    sweep();
    ASSERT_TRUE(state().result) << state().error;
    press(GLFW_KEY_C);
    window_.frames(4);
  }
}

TEST_F(SweepWindow, ColoursTheBallByTheScoredDirections) {
  const glm::ivec2 ball(78, 138);
  const std::size_t bare = colours_about(ball, 40);
  sweep();
  window_.settle();
  ASSERT_TRUE(state().map);
  EXPECT_GE(state().map->evaluated.size(), 24U);
  EXPECT_GT(state().map->worst, 0.0);
  EXPECT_GT(colours_about(ball, 40), bare);
  for (const EvaluatedDirection& each : state().map->evaluated) {
    EXPECT_NEAR(state().map->field.at(each.direction).cover, 1.0, 1e-6);
  }
  const EvaluatedDirection& first = state().map->evaluated.front();
  const EvaluatedDirection* found = state().map->nearest(-first.direction, 0.01);
  ASSERT_NE(found, nullptr);
  EXPECT_EQ(found->undercut, first.undercut);
}

class ProvedSweepWindow : public SweepWindow {
 protected:
  static SweepSettings proved() {
    SweepSettings sweep = quick_sweep();
    sweep.all_free_pct = 1.0;
    return sweep;
  }
  ProvedSweepWindow() : SweepWindow(proved()) {}
  [[nodiscard]] bool noted(const std::string& text) const {
    return std::ranges::any_of(window_.app().texts(), [&](const DrawnText& each) {
      return each.text.find(text) != std::string::npos;
    });
  }
};

TEST_F(ProvedSweepWindow, TellsTheBoundUnderTheMouseAndWhatIsOpen) {
  sweep();
  ASSERT_TRUE(state().result && state().result->all_free);
  const SweepProof& proof = *state().result->all_free;
  ASSERT_FALSE(proof.open.empty()) << "the hook has a direction without undercut";
  press(GLFW_KEY_M);
  window_.settle();
  EXPECT_TRUE(noted("Proved outside of the rings: at least "));
  const ScreenBox ball = window_.control("ball");
  const float half = 0.5F * (ball.max.x - ball.min.x) - 3.0F;
  const Camera& camera = window_.state().camera;
  const auto told_at = [&](const glm::dvec2& disc) {
    window_.move_mouse(ball.centre() + half * glm::vec2(disc.x, -disc.y));
    window_.frames(2);
    const auto bound = proof.bound_at(ball_direction(camera, {disc, true}));
    EXPECT_TRUE(noted(bound ? "proved: at least " : "open: not proved")) << disc.x << " " << disc.y;
    return bound.has_value();
  };
  std::size_t bounded = 0;
  for (double up = -0.9; up < 0.95; up += 0.1) bounded += told_at({0.3, up}) ? 1 : 0;
  const glm::dvec3& middle = proof.open.front().cap.direction;
  const BallPoint point = ball_point(camera, middle), opposite = ball_point(camera, -middle);
  EXPECT_FALSE(told_at(point.front ? point.at : opposite.at)) << "within a ring";
  EXPECT_GT(bounded, 10U);
}

TEST_F(SweepWindow, TurnsToTheRowThatIsClicked) {
  sweep();
  ASSERT_GE(state().result->candidates.size(), 3U);
  const auto direction = [&] { return window_.state().settings.direction.given(); };
  const auto click = [&](const std::string& control) {
    window_.move_mouse(window_.control(control).centre());
    window_.frames(2);
    window_.set_button(0, true);
    window_.frame();
    window_.set_button(0, false);
    window_.frames(2);
    window_.settle();
  };
  click("sort by undercut");
  click("sort by undercut");
  EXPECT_LT(window_.control("direction 3").centre().y, window_.control("direction 1").centre().y);
  for (std::size_t k = 0; k < state().result->candidates.size(); ++k) {
    click(fmt::format("direction {}", k + 1));
    EXPECT_EQ(direction(), candidate(k).candidate.direction) << k;
  }
  window_.wait_until_measured();
  // The legend's figures are the table's.
  for (const Region region : k_regions) {
    EXPECT_EQ(window_.state().figures.shown->areas[region],
              state().result->candidates.back().classification.areas[region]);
  }
}

TEST_F(LongSweepWindow, EndsWhenItIsCancelled) {
  press(GLFW_KEY_W);
  for (int k = 0; k < 10'000 && state().map->evaluated.size() < 5; ++k) {
    window_.frame();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  ASSERT_TRUE(state().running);
  EXPECT_GE(state().map->evaluated.size(), 5U) << "the map fills while the sweep runs";
  EXPECT_FALSE(state().running->stage.empty());
  EXPECT_GT(state().running->share, 0.0);
  press(GLFW_KEY_W);
  window_.wait_until_swept();
  ASSERT_TRUE(state().result);
  EXPECT_FALSE(state().result->complete);
  EXPECT_LT(state().result->evaluated.size(), static_cast<std::size_t>(k_many));
  ASSERT_FALSE(state().result->candidates.empty());
  EXPECT_FALSE(candidate(0).measured);
  EXPECT_TRUE(
      figure_text(direction_figure("undercut"), *window_.state().model, candidate(0)).starts_with("≈"));
}

TEST_F(LongSweepWindow, IsGivenUpWhenThePartGoes) {
  press(GLFW_KEY_W);
  window_.frames(3);
  ASSERT_TRUE(state().running);
  open(moldlight::test::l_bracket({}).mesh, "bracket.stl");
  window_.frames(2);
  EXPECT_FALSE(state().running);
  EXPECT_FALSE(state().map);
  EXPECT_FALSE(state().result);
}

TEST_F(SweepWindow, SaysWhenTheMethodHasChanged) {
  sweep();
  MethodSettings method = quick_method();
  method.tau_deg = 2.0;
  window_.app().set_notes({.settings = {{{}, method}, {}}, .bookmarks = {}});
  window_.frames(2);
  EXPECT_TRUE(state().stale);
  window_.app().set_notes({.settings = {{glm::dvec3(1, 0, 0), quick_method()}, {}}, .bookmarks = {}});
  window_.frames(2);
  EXPECT_FALSE(state().stale) << "the direction is what is searched for";
}

TEST_F(SweepWindow, ShowsTwoDirectionsSideBySide) {
  sweep();
  window_.wait_until_measured();
  const std::vector<std::uint8_t> alone = window_.pixels();
  press(GLFW_KEY_C);
  ASSERT_EQ(window_.state().sweep_choices.compared, std::optional<std::size_t>(0));
  window_.settle();
  EXPECT_NE(window_.pixels(), alone);
  press(GLFW_KEY_C);
  EXPECT_EQ(window_.state().sweep_choices.compared, std::optional<std::size_t>(1));
  press(GLFW_KEY_ESCAPE);
  EXPECT_EQ(window_.state().sweep_choices.compared, std::nullopt);
  window_.settle();
}

/// Pictures to look at stay in the build folder, wherever the test was started.
TEST_F(SweepWindow, LeavesItsPictures) {
  const fs::path folder = fs::path(MOLDLIGHT_BINARY).parent_path().parent_path() / "pictures";
  fs::create_directories(folder);
  sweep();
  window_.wait_until_measured();
  write_picture((folder / "sweep.png").string(), window_.size(), window_.pixels());
  press(GLFW_KEY_C);
  press(GLFW_KEY_M);
  window_.settle();
  write_picture((folder / "sweep_compared.png").string(), window_.size(), window_.pixels());
  // Both show the part with its undercut, and the second one another direction beside it.
  const auto red = [&](const char* name) {
    const Image picture = moldlight::test::read_png((folder / name).string());
    std::size_t count = 0;
    for (std::size_t i = 0; i + 3 < picture.rgba.size(); i += 4)
      count += picture.rgba[i] > 150 && picture.rgba[i + 1] < 80 && picture.rgba[i + 2] < 80 ? 1 : 0;
    return count;
  };
  EXPECT_GT(red("sweep.png"), 500U);
  EXPECT_GT(red("sweep_compared.png"), red("sweep.png"));
}

}  // namespace
}  // namespace moldlight::gui
