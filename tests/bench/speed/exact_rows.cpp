#include "bench/speed/exact_rows.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "bench/speed/contest.hpp"
#include "classify/classifier.hpp"
#include "mold/exact/exact_regions.hpp"
#include "support/exact_model.hpp"

namespace moldlight::bench {

namespace {

constexpr double k_lateral = 1.0 / 2048.0;  // unit frame
constexpr int k_exact_samples = 1'000'000, k_quick_samples = 20'000;
constexpr std::size_t k_facets_of_many_rounds = 600'000;

}  // namespace

ExactFigures print_exact_rows(const PartFile& file, const gl::Context& context,
                              const BenchSettings& settings) {
  const auto model = load_part(file.path, {}, {});
  ExactFigures figures{.part = file.name, .facets = model->part.mesh.facets.size()};
  const auto began = std::chrono::steady_clock::now();
  const ExactPart part(model->part.mesh, model->geometry, model->frame, {});
  const double part_ms =
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - began).count();
  Classifier classifier(context, model);
  Query query;
  query.method.readout = Readout::samples;
  query.method.samples = settings.quick ? k_quick_samples : k_exact_samples;
  query.method.tolerance = k_lateral * model->frame.diagonal;

  std::printf("\nexact  %s, %zu facets: once a part %.1f ms; ms a direction\n", file.name.c_str(),
              figures.facets, part_ms);
  std::printf("  %-22s %9s %9s %9s %9s %9s %9s %9s\n", "direction", "areas", "on cores", "split", "pieces",
              "samples", "x samples", "on cores");
  const bool many = figures.facets <= k_facets_of_many_rounds;
  double areas_ms = 0.0, samples_ms = 0.0, areas_core_ms = 0.0, samples_core_ms = 0.0;
  const std::vector<glm::dvec3> directions = test::five_directions();
  for (const glm::dvec3& direction : directions) {
    const ExactQuery asked{.direction = direction, .tau_deg = 1.0, .lateral = k_lateral};
    query.direction = direction;
    std::size_t pieces = 0;
    Contest contest;
    const std::size_t areas = contest.add(1.0, [&] { (void)exact_areas(part, asked, {}); });
    const std::size_t split =
        contest.add(1.0, [&] { pieces = exact_split(part, asked, {}).mesh.pieces.size(); });
    const std::size_t samples = contest.add(1.0, [&] { (void)classifier.classify(query, {}); });
    contest.run(many ? settings.rounds : 1, 0.0);
    std::printf("  %6.3f %6.3f %6.3f   %9.2f %9.2f %9.2f %9zu %9.1f %9.2f %9.2f\n", direction.x, direction.y,
                direction.z, contest.ms(areas, Contest::k_wall), contest.ms(areas, Contest::k_cores),
                contest.ms(split, Contest::k_wall), pieces, contest.ms(samples, Contest::k_wall),
                contest.ratio(samples, areas, Contest::k_wall),
                contest.ratio(samples, areas, Contest::k_cores));
    std::fflush(stdout);
    areas_core_ms += contest.ms(areas, Contest::k_cores);
    samples_core_ms += contest.ms(samples, Contest::k_cores);
    figures.worst_ms = std::max(figures.worst_ms, contest.ms(areas, Contest::k_wall));
    areas_ms += contest.ms(areas, Contest::k_wall);
    samples_ms += contest.ms(samples, Contest::k_wall);
  }
  figures.mean_ms = areas_ms / static_cast<double>(directions.size());
  figures.over_samples = samples_ms / areas_ms;
  figures.over_samples_on_cores = samples_core_ms / areas_core_ms;
  return figures;
}

}  // namespace moldlight::bench
