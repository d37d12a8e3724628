// Frame times of the live view on parts of about 5 k, 50 k and 500 k facets, or on those given: see
// classify/frame_benchmark.hpp. `moldlight view PART --benchmark` prints the same for one part.
#include <cstdio>
#include <string>
#include <vector>

#include "classify/frame_benchmark.hpp"
#include "gl/headless_context.hpp"
#include "support/mesh_edits.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

constexpr glm::ivec2 k_size(1280, 720);

void run(const std::vector<std::string>& files) {
  const auto context = gl::create_headless_context(gl::HeadlessBackend::automatic);
  std::printf("# %s, %s, %dx%d\n", context->backend().c_str(), context->renderer().c_str(), k_size.x,
              k_size.y);
  const auto show = [&](const std::shared_ptr<const PartModel>& model) {
    std::fputs(frame_times_text(measure_frames(*context, model, {}, k_size, {})).c_str(), stdout);
    std::fflush(stdout);
  };
  for (const std::string& file : files) show(load_part(file, {}, {}));
  if (!files.empty()) return;
  const std::string folder = (test::asset_folder() / "parts").string();
  show(load_part(folder + "/cable_clip.stl", {}, {}));
  for (const std::size_t facets : {std::size_t{50'000}, std::size_t{500'000}}) {
    Part part = read_part(folder + "/enclosure_lid.stl", {}, {});
    part.mesh = test::subdivided(std::move(part.mesh), facets);
    show(prepare_part(std::move(part), {}));
  }
}

}  // namespace
}  // namespace moldlight

int main(int count, char** arguments) { moldlight::run({arguments + 1, arguments + count}); }
