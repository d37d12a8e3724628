#include "bench/speed/sweep_rows.hpp"

#include <algorithm>
#include <cstdio>
#include <memory>
#include <span>
#include <thread>

#include "bench/speed/contest.hpp"
#include "bench/speed/machine_limit.hpp"
#include "bench/speed/paper_sweep.hpp"
#include "mold/map_frame.hpp"
#include "mold/scan/scan_maps.hpp"
#include "mold/sweep/engine_choice.hpp"
#include "mold/sweep/scan_scorer.hpp"

namespace moldlight::bench {

namespace {

/// Software GL takes long: so many directions of the contest, the third of which is an axis.
constexpr std::size_t k_gl_directions = 4;
constexpr int k_gl_samples = 10'000;
constexpr std::size_t k_passes_of_limit = 20;

/// Runs `work(job)` on as many threads as there are cores.
template <typename Work>
void on_all_cores(const Work& work) {
  std::vector<std::jthread> threads;
  for (unsigned job = 0; job < std::max(1U, std::thread::hardware_concurrency()); ++job)
    threads.emplace_back([&work, job] { work(job); });
}

/// Maps or bounds of one thread each, for all cores.
template <typename Make>
auto for_each_core(const Make& make) {
  std::vector<decltype(make())> made;
  for (unsigned job = 0; job < std::max(1U, std::thread::hardware_concurrency()); ++job)
    made.push_back(make());
  return made;
}

struct Row {
  const char* engine;
  std::size_t contestant;
  double error;  // negative: none
};

void print_row(const Contest& contest, const Row& row, const char* note, const Row& scan) {
  const double wall = contest.ms(row.contestant, Contest::k_wall);
  std::printf("  %-22s %9.3f %9.3f %9.1f ", row.engine, wall, contest.ms(row.contestant, Contest::k_cores),
              1000.0 / wall);
  if (row.error < 0.0) {
    std::printf("%9s ", "-");
  } else {
    std::printf("%7.4f %% ", 100.0 * row.error);
  }
  std::printf("%8.2f %8.2f   %s\n", contest.ratio(row.contestant, scan.contestant, Contest::k_wall),
              contest.ratio(row.contestant, scan.contestant, Contest::k_cores), note);
}

}  // namespace

SweepFigures print_sweep_rows(const std::string& name, Contenders& contenders, const gl::Context& context,
                              const BenchSettings& settings) {
  const Truth& truth = contenders.truth();
  const std::span<const glm::dvec3> directions = truth.directions;
  const auto count = static_cast<double>(directions.size());
  const std::span<const glm::dvec3> few =
      directions.subspan(std::min<std::size_t>(2, directions.size() - k_gl_directions), k_gl_directions);

  const double samples = ScanScorerSettings{}.samples;
  const auto scan = contenders.scan_pool(settings.resolution, samples, 0);
  const auto scan_alone = contenders.scan_pool(settings.resolution, samples, 1);
  const double scan_error = truth.error(score_all(*scan, directions));
  const std::uint64_t ray_count = contenders.ray_samples_for(scan_error);
  const auto rays = contenders.ray_pool(ray_count, 0);
  const double ray_error = truth.error(score_all(*rays, directions));
  const auto gl = contenders.gl_pool(settings.resolution, k_gl_samples, 0);
  const double gl_error = truth.error(score_all(*gl, directions));
  const auto gl_single = contenders.gl_classifier_pool(settings.resolution, k_gl_samples, 0);
  const double gl_single_error = truth.error(score_all(*gl_single, directions));
  PaperSweep paper(context, contenders.model(), settings.resolution, Contenders::k_tau_deg);
  std::vector<double> paper_undercuts;
  for (const glm::dvec3& direction : directions) paper_undercuts.push_back(paper.undercut(direction));
  const double paper_error = truth.error(paper_undercuts);
  auto maps = for_each_core([&] { return std::make_unique<ScanMaps>(settings.resolution); });
  auto limits = for_each_core(
      [&] { return std::make_unique<MachineLimit>(contenders.scan_part(), settings.resolution); });

  Contest contest;
  const Row scan_row{"cpu", contest.add(count, [&] { score_all(*scan, directions); }), scan_error};
  const Row alone_row{"cpu, one thread", contest.add(count, [&] { score_all(*scan_alone, directions); }),
                      scan_error};
  const Row maps_row{"cpu, map pair alone",
                     contest.add(count * static_cast<double>(maps.size()),
                                 [&] {
                                   on_all_cores([&](unsigned job) {
                                     for (const glm::dvec3& direction : directions)
                                       maps[job]->draw(contenders.scan_part(), map_frame(direction), {});
                                   });
                                 }),
                     -1.0};
  const Row ray_row{"rays (b)", contest.add(count, [&] { score_all(*rays, directions); }), ray_error};
  const Row gl_row{"gl", contest.add(count, [&] { score_all(*gl, directions); }), gl_error};
  const Row gl_single_row{"gl, one at a time",
                          contest.add(static_cast<double>(few.size()), [&] { score_all(*gl_single, few); }),
                          gl_single_error};
  const Row paper_row{"paper on GL (a)",
                      contest.add(static_cast<double>(few.size()),
                                  [&] {
                                    for (const glm::dvec3& direction : few)
                                      paper_undercuts[0] = paper.undercut(direction);
                                  }),
                      paper_error};
  std::uint64_t folded = 0;
  const Row limit_row{"limit (d)",
                      contest.add(static_cast<double>(limits.size() * k_passes_of_limit),
                                  [&] {
                                    std::vector<std::uint64_t> results(limits.size());
                                    on_all_cores([&](unsigned job) {
                                      for (std::size_t i = 0; i < k_passes_of_limit; ++i)
                                        results[job] ^= limits[job]->pass();
                                    });
                                    folded ^= results[0];
                                  }),
                      -1.0};
  contest.run(settings.rounds, settings.seconds);

  std::printf("\nsweep  %s, %zu facets, %zu directions, maps %d x %d, %zu rounds (fold %llx)\n", name.c_str(),
              contenders.facets(), directions.size(), settings.resolution, settings.resolution,
              contest.rounds(), static_cast<unsigned long long>(folded & 0xF));
  std::printf("  %-22s %9s %9s %9s %9s %8s %8s\n", "engine", "ms/dir", "core ms", "dirs/s", "error", "x cpu",
              "x cores");
  char rays_note[64];
  std::snprintf(rays_note, sizeof rays_note, "%llu samples, for the error of cpu",
                static_cast<unsigned long long>(ray_count));
  print_row(contest, scan_row, "", scan_row);
  print_row(contest, alone_row, "", scan_row);
  print_row(contest, maps_row, "", scan_row);
  print_row(contest, ray_row, rays_note, scan_row);
  print_row(contest, gl_row, "", scan_row);
  print_row(contest, gl_single_row, "classify's passes, all doubts settled", scan_row);
  print_row(contest, paper_row, "two depth passes and facet readback", scan_row);
  print_row(contest, limit_row, "vertices and facets read, both maps written once", scan_row);
  std::fflush(stdout);

  const auto cores = [&](const Row& slower, const Row& faster) {
    return contest.ratio(slower.contestant, faster.contestant, Contest::k_cores);
  };
  SweepFigures figures;
  figures.part = name;
  figures.facets = contenders.facets();
  figures.ms = contest.ms(scan_row.contestant, Contest::k_wall);
  figures.core_ms = contest.ms(scan_row.contestant, Contest::k_cores);
  figures.error = scan_error;
  figures.over_paper = cores(paper_row, scan_row);
  figures.over_rays = cores(ray_row, scan_row);
  figures.of_limit = cores(scan_row, limit_row);
  figures.map_pair_of_limit = cores(maps_row, limit_row);
  figures.threads_gain = contest.ratio(alone_row.contestant, scan_row.contestant, Contest::k_wall);
  figures.threads_gain_undisturbed = static_cast<double>(maps.size()) * cores(alone_row, scan_row);
  return figures;
}

void print_choice_rows(const std::string& name, Contenders& contenders, const BenchSettings& settings) {
  const Truth& truth = contenders.truth();
  const std::span<const glm::dvec3> directions = truth.directions;
  const auto count = static_cast<double>(directions.size());
  std::printf("\nchoice  %s, %zu facets: maps or rays for an error wanted\n", name.c_str(),
              contenders.facets());
  std::printf("  %9s | %7s %9s %9s | %9s %9s %9s | %6s %6s\n", "wanted", "texels", "ms/dir", "error",
              "samples", "ms/dir", "error", "auto", "cost");
  for (const double wanted : settings.wanted_errors) {
    const ScoringPlan plan = choose_engine(contenders.facets(), wanted, true);
    const auto scan = contenders.scan_pool(plan.resolution, plan.scan_samples, 0);
    const auto rays = contenders.ray_pool(static_cast<std::uint64_t>(plan.ray_samples), 0);
    const double scan_error = truth.error(score_all(*scan, directions));
    const double ray_error = truth.error(score_all(*rays, directions));
    Contest contest;
    const std::size_t by_scan = contest.add(count, [&] { score_all(*scan, directions); });
    const std::size_t by_rays = contest.add(count, [&] { score_all(*rays, directions); });
    contest.run(std::max(3, settings.rounds - 2), 0.0);
    const bool takes_scan = plan.method == ScoringMethod::scan;
    const double cost = std::max(1.0, takes_scan ? contest.ratio(by_scan, by_rays, Contest::k_cores)
                                                 : contest.ratio(by_rays, by_scan, Contest::k_cores));
    std::printf("  %7.2f %% | %7d %9.3f %7.4f %% | %9.0f %9.3f %7.4f %% | %6s %6.2f\n", 100.0 * wanted,
                plan.resolution, contest.ms(by_scan, Contest::k_cores), 100.0 * scan_error, plan.ray_samples,
                contest.ms(by_rays, Contest::k_cores), 100.0 * ray_error, takes_scan ? "cpu" : "rays", cost);
    std::fflush(stdout);
  }
}

}  // namespace moldlight::bench
