// How far the areas that a live page counts are off, where its maps differ from the program's, and how fast
// it follows the direction, in a browser without graphics hardware: bench_live_pages PART… writes a page of
// each part and prints a row.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <regex>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec3.hpp>
#include <nlohmann/json.hpp>

#include "classify/classifier.hpp"
#include "classify/part_model.hpp"
#include "mold/surface_samples.hpp"
#include "render/readout_passes.hpp"
#include "report/describe/parts.hpp"
#include "report/live_view.hpp"
#include "support/browser.hpp"
#include "support/classify_mesh.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"
#include "support/shared_parts.hpp"

namespace moldlight {
namespace {

using Json = test::Browser::Json;

/// Axes, directions along which walls have the default tau or little more, and oblique ones.
std::vector<glm::dvec3> directions() {
  const double tau = std::tan(glm::radians(1.0));
  const glm::dvec2 leans[] = {{tau, 0.0}, {0.0, tau}, {1.8 * tau, 0.6 * tau}};
  std::vector<glm::dvec3> list;
  for (int axis = 0; axis < 3; ++axis) {
    glm::dvec3 direction(0.0);
    direction[axis] = 1.0;
    list.push_back(direction);
    for (const glm::dvec2& lean : leans) {
      list.push_back(direction);
      list.back()[(axis + 1) % 3] = lean.x;
      list.back()[(axis + 2) % 3] = lean.y;
    }
  }
  for (const glm::dvec3& oblique : {glm::dvec3{1, 1, 0},
                                    {0, 1, 1},
                                    {-0.78, 0.62, 0.09},
                                    {-0.43, 0.63, 0.64},
                                    {0.18, 0.79, 0.58},
                                    {0.4, -0.07, 0.91},
                                    {-0.32, -0.42, 0.85},
                                    {0.13, 0.51, 0.85}})
    list.push_back(oblique);
  for (glm::dvec3& direction : list) direction = glm::normalize(direction);
  return list;
}

/// Areas by maps of a direction that the page has left at rest, or else moves to, and what the page says.
constexpr const char* k_areas = R"js(((direction, rest) => {
  const live = globalThis.view.director;
  live.shownAt = 0;
  live.go(unit(direction), rest);
  view.draw();
  clearTimeout(live.resting);
  return {areas: live.areas, said: byId("standing").textContent,
    verdicts: live.maps.verdicts.filter((_, k) => k % 4 === 0).slice(0, live.live.samples).join("")};
}))js";

double stated(const std::string& said) {
  std::smatch match;
  return std::regex_search(said, match, std::regex("± ([0-9.]+) %")) ? std::stod(match[1]) : NAN;
}

void measure(test::Browser& browser, const std::string& part) {
  const test::ScratchFolder folder;
  const std::string page = folder.file("live.html"), json = folder.file("exact.json");
  test::ProcessSettings slow;
  slow.time_limit_s = 600.0;
  // Along an oblique direction, so that areas of the axes are not in the page.
  if (test::run_moldlight({"classify", part, "--direction=0.3,0.5,-0.7", "--html", page, "--live"}, slow)
          .exit_code != 0) {
    fmt::print("{}: no page\n", part);
    return;
  }
  browser.load(page);
  const double began_ms =
      browser.value("begun.then((made) => { globalThis.view = made; return performance.now(); })");
  const auto model = load_part(part, {}, Progress{});
  PartMaps maps(test::shared_context(), model);
  const SurfaceSamples samples =
      sample_surface_evenly(model->part.mesh, model->geometry, model->frame, report::k_live_samples);
  SamplePass pass(test::shared_context().functions());
  double most_differ = 0.0;
  struct Row {
    double off = 0.0, stated = 0.0;
    int beyond = 0;
  } rows[2];
  for (const glm::dvec3& direction : directions()) {
    const std::string numbers = fmt::format("{:.17g},{:.17g},{:.17g}", direction.x, direction.y, direction.z);
    static_cast<void>(test::run_moldlight({"classify", part, "--direction=" + numbers, "--json", json}));
    const Json exact = Json::parse(test::file_bytes(json))["areas"];
    for (const int rest : {0, 1}) {
      const Json found = browser.value(fmt::format("{}([{}], {})", k_areas, numbers, rest == 1));
      double off = 0.0;
      for (std::size_t k = 0; k < 4; ++k) {
        const double area = exact[std::vector{"core", "cavity", "both", "undercut"}[k]];
        off = std::max(
            off, 100.0 * std::abs(found["areas"][k].get<double>() - area) / exact["total"].get<double>());
      }
      Row& row = rows[rest];
      row.off = std::max(row.off, off);
      row.stated = stated(found["said"]);
      row.beyond += off > row.stated ? 1 : 0;
      if (rest == 0) continue;
      // By sample, but for those beside a border.
      maps.draw_maps(report::page_query(*model, {direction, {}}, 2048));
      const std::vector<std::uint8_t> verdicts = pass.run(samples.samples, maps.maps());
      const std::string page_verdicts = found["verdicts"];
      int differ = 0;
      for (std::size_t k = 0; k < verdicts.size(); ++k)
        differ += page_verdicts[k] < '4' && page_verdicts[k] - '0' != verdicts[k] ? 1 : 0;
      most_differ = std::max(most_differ, 100.0 * differ / static_cast<double>(verdicts.size()));
    }
  }
  const Json frames =
      browser.value("(" + test::file_bytes((test::data_folder() / "live_frames.js").string()) + ")(view)");
  const double plain = frames[0], live = frames[1];
  fmt::print(
      "{:32} | at rest {:.3f} ± {:.2f}, {} beyond | moving {:.2f} ± {:.2f}, {} beyond | "
      "plain {:.1f} ms, by maps {:.1f} ms, ratio {:.2f} | begun {:.1f} s | maps differ {:.3f} %\n",
      std::filesystem::path(part).filename().string(), rows[1].off, rows[1].stated, rows[1].beyond,
      rows[0].off, rows[0].stated, rows[0].beyond, plain, live, plain / live, 1e-3 * began_ms, most_differ);
  std::fflush(stdout);
}

}  // namespace
}  // namespace moldlight

int main(int argc, char** argv) {
  if (argc < 2 || !moldlight::test::has_browser()) {
    std::fputs("bench_live_pages PART…: chromium is needed\n", stderr);
    return 2;
  }
  moldlight::test::Browser browser;
  for (int k = 1; k < argc; ++k) moldlight::measure(browser, argv[k]);
  return 0;
}
