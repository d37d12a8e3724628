#include "classify/frame_benchmark.hpp"

#include <atomic>
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
  std::vector<double> plain_ms, rest_ms, changing_ms, rest_ratio, changing_ratio;
  double figures_s = 0.0;
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
        draw(changing, turn % k_turns, ColourMode::regions);
      });
      if (turn < 0) continue;
      changing_ms.push_back(change);
      changing_ratio.push_back(median(plain_of_round) / change);
    }
    figures_s += stopwatch.elapsed_ms() / 1000.0;
    plain_ms.insert(plain_ms.end(), plain_of_round.begin(), plain_of_round.end());
  }
  return {.facets = model->part.mesh.facets.size(),
          .plain_ms = median(plain_ms),
          .rest_ms = median(rest_ms),
          .changing_ms = median(changing_ms),
          .rest_ratio = median(rest_ratio),
          .changing_ratio = median(changing_ratio),
          .figures_per_s = figures / figures_s};
}

std::string frame_times_text(const FrameTimes& times) {
  return fmt::format(
      "live_plain facets={0} ms={1:.2f}\n"
      "live_rest facets={0} ms={2:.2f} ratio={3:.3f}\n"
      "live_changing facets={0} ms={4:.2f} ratio={5:.3f} figures_per_s={6:.1f}\n",
      times.facets, times.plain_ms, times.rest_ms, times.rest_ratio, times.changing_ms, times.changing_ratio,
      times.figures_per_s);
}

}  // namespace moldlight
