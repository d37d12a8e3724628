#include "classify/frame_benchmark.hpp"

#include <array>
#include <atomic>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/job.hpp"
#include "base/numbers.hpp"
#include "base/stopwatch.hpp"
#include "classify/classifier.hpp"
#include "classify/picture_maps.hpp"
#include "gl/objects.hpp"
#include "mold/exact/exact_regions.hpp"
#include "render/part_view.hpp"

namespace moldlight {

namespace {

constexpr int k_rounds = 5, k_turns = 8, k_warm_up = 2;
constexpr double k_figures_ms =
    400.0;  // a round while the direction moves, at least, so that figures are found

}  // namespace

FrameTimes measure_frames(const gl::Context& context, const std::shared_ptr<const PartModel>& model,
                          const Query& asked, const glm::ivec2& size, const Progress& progress) {
  const gl::Functions& gl = context.functions();
  const gl::ColourTarget picture(gl, size);
  const ViewGeometry geometry =
      view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame);
  PictureMaps resting(context, model), changing(context, model);
  PartView view(gl, geometry);
  Camera start;
  start.orientation = standard_orientation(StandardView::isometric);
  start = fitted(start, geometry.extremes, size);
  const ExactPart part(model->part.mesh, model->geometry, model->frame, progress);
  const ExactQuery query = exact_query(*model, asked);
  resting.take_split(exact_split(part, query, progress).mesh, geometry, asked);

  const auto frame_ms = [&](const auto& draw) {
    const Stopwatch stopwatch;
    draw();
    static_cast<void>(view.pick(size / 2));  // waits for the GL, as a cursor on the part does
    return stopwatch.elapsed_ms();
  };
  std::vector<double> plain_ms, rest_ms, rest_ratio;
  struct Changing {
    std::vector<double> ms, ratio;
    double s = 0.0;
    int figures = 0;
  };
  std::array<Changing, 2> all_changing;  // the camera moves, and rests
  std::atomic<int> figures = 0;
  const auto measure = [&](const glm::dvec3& direction, const Progress& measuring) {
    ExactQuery moved = query;
    moved.direction = direction;
    ExactAreas areas = exact_areas(part, moved, measuring);
    ++figures;
    return areas;
  };
  for (int round = 0; round < k_rounds; ++round) {
    progress.report("drawing frames", static_cast<double>(round) / k_rounds);
    std::vector<double> plain_of_round;
    const auto draw = [&](const PictureMaps& maps, int turn, ColourMode mode) {
      const Camera camera =
          orbited(start, {0.05 * (k_turns * round + turn), 0.01 * turn}, {0, 0, 1}, glm::dvec3(0.0));
      ViewSettings settings;
      settings.colour_mode = mode;
      settings.arrows = false;
      view.draw({picture.framebuffer(), size}, maps.subject(), {camera, settings});
    };
    for (int turn = -k_warm_up; turn < k_turns; ++turn) {
      const double plain = frame_ms([&] { draw(resting, turn, ColourMode::plain); });
      const double rest = frame_ms([&] { draw(resting, turn, ColourMode::regions); });
      if (turn < 0) continue;
      plain_of_round.push_back(plain);
      rest_ms.push_back(rest);
      rest_ratio.push_back(plain / rest);
    }
    for (const bool rests : {false, true}) {
      Changing& frames = all_changing[rests ? 1 : 0];
      figures = 0;
      Job<ExactAreas> beside({.pause_s = figure_pause_s});
      const Stopwatch stopwatch;
      for (int turn = -k_warm_up; turn < k_turns || stopwatch.elapsed_ms() < k_figures_ms; ++turn) {
        Query moved = asked;
        moved.direction = glm::dvec3(0.02 * (k_turns * round + turn % k_turns), 0.1, 1.0);
        beside.follow([&measure, direction = moved.direction.unit()](const Progress& measuring) {
          return measure(direction, measuring);
        });
        const double change = frame_ms([&] {
          changing.draw_moving(moved);
          draw(changing, rests ? 0 : turn % k_turns, ColourMode::regions);
        });
        if (turn < 0) continue;
        frames.ms.push_back(change);
        frames.ratio.push_back(median(plain_of_round) / change);
      }
      frames.s += stopwatch.elapsed_ms() / 1000.0;
      frames.figures += figures;
    }
    plain_ms.insert(plain_ms.end(), plain_of_round.begin(), plain_of_round.end());
  }
  const auto found = [](const Changing& frames) {
    return FrameTimes::Changing{median(frames.ms), median(frames.ratio), frames.figures / frames.s};
  };
  return {.facets = model->part.mesh.facets.size(),
          .plain_ms = median(plain_ms),
          .rest_ms = median(rest_ms),
          .rest_ratio = median(rest_ratio),
          .changing = found(all_changing[0]),
          .dragged = found(all_changing[1])};
}

std::string frame_times_text(const FrameTimes& times) {
  std::string text = fmt::format(
      "live_plain facets={0} ms={1:.2f}\n"
      "live_rest facets={0} ms={2:.2f} ratio={3:.3f}\n",
      times.facets, times.plain_ms, times.rest_ms, times.rest_ratio);
  for (const auto& [name, frames] : {std::pair("changing", times.changing), {"dragged", times.dragged}})
    text += fmt::format("live_{} facets={} ms={:.2f} ratio={:.3f} figures_per_s={:.1f}\n", name, times.facets,
                        frames.ms, frames.ratio, frames.figures_per_s);
  return text;
}

}  // namespace moldlight
