#include "session/frame_benchmark.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include <fmt/format.h>

#include "base/median.hpp"
#include "gl/colour_target.hpp"
#include "render/part_view.hpp"
#include "session/picture_maps.hpp"

namespace moldlight {

namespace {

constexpr int k_turns = 25, k_warm_up = 2;

}  // namespace

FrameTimes measure_frames(const gl::Context& context, const std::shared_ptr<const PartModel>& model,
                          const MethodSettings& method, const glm::ivec2& size, const Progress& progress) {
  const gl::Functions& gl = context.functions();
  const gl::ColourTarget picture(gl, size);
  PictureMaps resting(context, model), changing(context, model);
  PartView view(gl, view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame));
  Camera start;
  start.orientation = standard_orientation(StandardView::isometric);
  start = fitted(start, unit_positions(model->part.mesh, model->frame), size);
  resting.draw_resting(method);

  const auto timed = [&](const auto& draw) {
    const auto begin = std::chrono::steady_clock::now();
    draw();
    static_cast<void>(view.pick(size / 2));  // waits for the GL, as a cursor on the part does
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
  };
  std::vector<double> plain_ms, rest_ms, changing_ms, rest_ratio, changing_ratio;
  for (int turn = -k_warm_up; turn < k_turns; ++turn) {
    progress.report("drawing frames", std::max(0.0, static_cast<double>(turn) / k_turns));
    const Camera camera = orbited(start, 0.05 * turn, 0.01 * turn, {0, 0, 1}, glm::dvec3(0.0));
    ViewSettings settings;
    const auto draw = [&](const PictureMaps& maps) {
      view.draw({picture.framebuffer(), size}, maps.buffers(), maps.maps(), camera, settings);
    };
    settings.colour_mode = ColourMode::plain;
    const double plain = timed([&] { draw(resting); });
    settings.colour_mode = ColourMode::regions;
    const double rest = timed([&] { draw(resting); });
    MethodSettings moved = method;
    moved.direction = glm::dvec3(0.02 * turn, 0.1, 1.0);
    const double change = timed([&] {
      changing.draw_moving(moved);
      draw(changing);
    });
    if (turn < 0) continue;
    plain_ms.push_back(plain);
    rest_ms.push_back(rest);
    changing_ms.push_back(change);
    rest_ratio.push_back(plain / rest);
    changing_ratio.push_back(plain / change);
  }
  return {.facets = model->part.mesh.facets.size(),
          .plain_ms = median(plain_ms),
          .rest_ms = median(rest_ms),
          .changing_ms = median(changing_ms),
          .rest_ratio = median(rest_ratio),
          .changing_ratio = median(changing_ratio)};
}

std::string frame_times_text(const FrameTimes& times) {
  return fmt::format(
      "live_plain facets={0} ms={1:.2f}\nlive_rest facets={0} ms={2:.2f} ratio={3:.3f}\nlive_changing "
      "facets={0} "
      "ms={4:.2f} ratio={5:.3f}\n",
      times.facets, times.plain_ms, times.rest_ms, times.rest_ratio, times.changing_ms, times.changing_ratio);
}

}  // namespace moldlight
