// Frame times of the live view: the same camera path with plain shading, with regions for a fixed direction
// and with a direction that changes every frame. Prints one row a part and the ratios to plain shading.
#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "gl/context.hpp"
#include "render/part_view.hpp"
#include "session/classifier.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr glm::ivec2 k_size(1280, 720);
constexpr int k_frames = 24, k_rounds = 3;

struct FrameTimes {
  double plain_ms = 0.0, fixed_ms = 0.0, changing_ms = 0.0;
};

class Bench {
 public:
  explicit Bench(const gl::Context& context)
      : gl_(context.functions()),
        context_(context),
        picture_(gl::make_texture_2d(gl_, GL_RGBA8, k_size.x, k_size.y)) {
    const GLuint name = picture_.name();
    framebuffer_ = gl::make_framebuffer(gl_, {.colours = {&name, 1}});
  }

  FrameTimes run(const std::shared_ptr<const PartModel>& model) {
    Classifier classifier(context_, model);
    PartView view(gl_, view_geometry(model->part.mesh, model->geometry, model->adjacency, model->frame));
    const std::vector<glm::vec3> points = unit_positions(model->part.mesh, model->frame);
    Camera start;
    start.orientation = standard_orientation(StandardView::isometric);
    start = fitted(start, points, k_size);
    MethodSettings method;
    ViewSettings settings;
    const auto path = [&](bool changing) {
      std::vector<double> times;
      for (int frame = 0; frame < k_frames; ++frame) {
        const Camera camera = orbited(start, 0.05 * frame, 0.01 * frame, {0, 0, 1}, glm::dvec3(0.0));
        const auto begin = std::chrono::steady_clock::now();
        if (changing) {
          method.direction = {0.02 * frame, 0.1, 1.0};
          classifier.draw_maps(method);
        }
        view.draw({framebuffer_.name(), k_size}, classifier.buffers(), classifier.maps(), camera, settings);
        gl_.Finish();
        times.push_back(
            std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
      }
      std::sort(times.begin(), times.end());
      return times[times.size() / 2];
    };
    classifier.draw_maps(method);
    FrameTimes best{1e9, 1e9, 1e9};
    for (int round = 0; round < k_rounds; ++round) {
      settings.colour_mode = ColourMode::plain;
      best.plain_ms = std::min(best.plain_ms, path(false));
      settings.colour_mode = ColourMode::regions;
      best.fixed_ms = std::min(best.fixed_ms, path(false));
      best.changing_ms = std::min(best.changing_ms, path(true));
    }
    return best;
  }

 private:
  const gl::Functions& gl_;
  const gl::Context& context_;
  gl::Texture picture_;
  gl::Framebuffer framebuffer_;
};

void run(const std::vector<std::string>& files) {
  const auto context = gl::create_headless_context(gl::HeadlessBackend::automatic);
  std::printf("%s, %s, %d x %d\n", context->backend().c_str(), context->renderer().c_str(), k_size.x,
              k_size.y);
  std::printf("%-34s %9s %9s %9s %9s   %s\n", "part", "facets", "plain ms", "fixed ms", "moving ms",
              "ratio of frame rates to plain: fixed, moving");
  Bench bench(*context);
  const auto show = [&](const std::string& name, const std::shared_ptr<const PartModel>& model) {
    const FrameTimes times = bench.run(model);
    std::printf("%-34s %9zu %9.2f %9.2f %9.2f   %.2f %.2f\n", name.c_str(), model->part.mesh.facets.size(),
                times.plain_ms, times.fixed_ms, times.changing_ms, times.plain_ms / times.fixed_ms,
                times.plain_ms / times.changing_ms);
    std::fflush(stdout);
  };
  for (const std::string& file : files) show(file, load_part(file, {}, {}));
  if (!files.empty()) return;
  const std::string folder = (test::asset_folder() / "parts").string();
  show("cable_clip", load_part(folder + "/cable_clip.stl", {}, {}));
  for (const std::size_t facets : {std::size_t{50'000}, std::size_t{500'000}}) {
    Part part = read_part(folder + "/enclosure_lid.stl", {}, {});
    part.mesh = test::subdivided(std::move(part.mesh), facets);
    show("enclosure_lid, subdivided", prepare_part(std::move(part), {}));
  }
}

}  // namespace
}  // namespace moldlight

int main(int count, char** arguments) { moldlight::run({arguments + 1, arguments + count}); }
