#include "bench/speed/sweep_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <span>
#include <thread>

#include "bench/speed/contest.hpp"
#include "bench/speed/paper_sweep.hpp"
#include "mold/exact/exact_regions.hpp"

namespace moldlight::bench {

namespace {

/// Software GL takes long: so many directions of the contest, the third of which is an axis.
constexpr std::size_t k_gl_directions = 4;
constexpr int k_samples = 10'000;  // the default of a sweep

struct Row {
  const char* engine;
  std::size_t contestant;
  double error;
};

void print_row(const Contest& contest, const Row& row, const char* note, const Row& first) {
  const double wall = contest.ms(row.contestant, Contest::k_wall);
  std::printf("  %-22s %9.3f %9.3f %9.1f %7.4f %% %8.2f %8.2f   %s\n", row.engine, wall,
              contest.ms(row.contestant, Contest::k_cores), 1000.0 / wall, 100.0 * row.error,
              contest.ratio(row.contestant, first.contestant, Contest::k_wall),
              contest.ratio(row.contestant, first.contestant, Contest::k_cores), note);
}

}  // namespace

SweepFigures print_sweep_rows(const std::string& name, Contenders& contenders, const gl::Context& context,
                              const BenchSettings& settings) {
  const Truth& truth = contenders.truth();
  const std::span<const glm::dvec3> directions = truth.directions;
  const auto count = static_cast<double>(directions.size());
  const std::span<const glm::dvec3> few =
      directions.subspan(std::min<std::size_t>(2, directions.size() - k_gl_directions), k_gl_directions);

  const auto rays = contenders.ray_pool(k_samples, 0), rays_alone = contenders.ray_pool(k_samples, 1);
  const double ray_error = truth.error(score_all(*rays, directions));
  const auto gl = contenders.gl_pool(settings.resolution, k_samples, 0);
  const double gl_error = truth.error(score_all(*gl, directions));
  PaperSweep paper(context, contenders.model(), settings.resolution, Contenders::k_tau_deg);
  std::vector<double> paper_undercuts;
  for (const glm::dvec3& direction : directions) paper_undercuts.push_back(paper.undercut(direction));

  Contest contest;
  const Row ray_row{"rays", contest.add(count, [&] { score_all(*rays, directions); }), ray_error};
  const Row alone_row{"rays, one thread", contest.add(count, [&] { score_all(*rays_alone, directions); }),
                      ray_error};
  const Row gl_row{"gl", contest.add(count, [&] { score_all(*gl, directions); }), gl_error};
  const Row exact_row{"exact regions",
                      contest.add(count,
                                  [&] {
                                    for (const glm::dvec3& direction : directions)
                                      static_cast<void>(contenders.exact_undercut(direction));
                                  }),
                      0.0};
  const Row paper_row{"paper on GL (a)",
                      contest.add(static_cast<double>(few.size()),
                                  [&] {
                                    for (const glm::dvec3& direction : few)
                                      paper_undercuts[0] = paper.undercut(direction);
                                  }),
                      truth.error(paper_undercuts)};
  contest.run(settings.rounds, settings.seconds);

  std::printf("\nsweep  %s, %zu facets, %zu directions, maps %d x %d, %zu rounds\n", name.c_str(),
              contenders.facets(), directions.size(), settings.resolution, settings.resolution,
              contest.rounds());
  std::printf("  %-22s %9s %9s %9s %9s %8s %8s\n", "engine", "ms/dir", "core ms", "dirs/s", "error", "x rays",
              "x cores");
  print_row(contest, ray_row, "as a sweep screens", ray_row);
  print_row(contest, alone_row, "", ray_row);
  print_row(contest, gl_row, "", ray_row);
  print_row(contest, exact_row, "as a sweep compares the best", ray_row);
  print_row(contest, paper_row, "two depth passes and facet readback", ray_row);
  std::fflush(stdout);

  const auto cores = [&](const Row& slower, const Row& faster) {
    return contest.ratio(slower.contestant, faster.contestant, Contest::k_cores);
  };
  const double threads = std::max(1U, std::thread::hardware_concurrency());
  SweepFigures figures;
  figures.part = name;
  figures.facets = contenders.facets();
  figures.ms = contest.ms(ray_row.contestant, Contest::k_wall);
  figures.core_ms = contest.ms(ray_row.contestant, Contest::k_cores);
  figures.error = ray_error;
  figures.over_paper = cores(paper_row, ray_row);
  figures.over_exact = cores(exact_row, ray_row);
  figures.threads_gain = contest.ratio(alone_row.contestant, ray_row.contestant, Contest::k_wall);
  figures.threads_gain_undisturbed = threads * cores(alone_row, ray_row);
  return figures;
}

}  // namespace moldlight::bench
