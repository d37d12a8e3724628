// The speed suite: prints in one run how long loading, classifying, sweeping and the live view take on parts
// of 5,000 to 2,000,000 facets, and the ratios to rivals that run in turns with them on the same work.
#include <algorithm>
#include <cstdio>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "base/error.hpp"
#include "bench/speed/bench_settings.hpp"
#include "bench/speed/contenders.hpp"
#include "bench/speed/exact_rows.hpp"
#include "bench/speed/parts.hpp"
#include "bench/speed/process_rows.hpp"
#include "bench/speed/sweep_rows.hpp"
#include "classify/headless.hpp"
#include "support/process.hpp"
#include "support/scratch_folder.hpp"

namespace moldlight::bench {
namespace {

constexpr std::size_t k_most_facets_in_view = 500'000;

std::string processor() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown processor";
}

/// Parts are made by a process of their own, so that the suite stays small while it starts others.
std::vector<PartFile> make_parts(const test::ScratchFolder& folder, const BenchSettings& settings) {
  std::vector<PartFile> files;
  for (const std::size_t facets : settings.facets) {
    test::ProcessSettings process;
    process.time_limit_s = 300.0;
    const auto result =
        test::Process({"/proc/self/exe", k_make_argument, folder.path().string(), std::to_string(facets)},
                      process)
            .finish();
    if (result.exit_code != 0) throw Error("no part could be made: " + result.err);
    files.push_back(part_file(folder.path(), facets));
  }
  return files;
}

void print_summary(const std::vector<SweepFigures>& sweeps, const std::vector<LoadFigures>& loads) {
  std::printf("\nsummary  a direction by rays; ratios of core time\n");
  std::printf("  %-22s %8s %8s %8s %9s %7s %7s %8s %8s\n", "part", "facets", "ms/dir", "core ms", "error",
              "x (a)", "x exact", "threads", "on cores");
  for (const SweepFigures& f : sweeps) {
    std::printf("  %-22s %8zu %8.3f %8.3f %7.4f %% %7.1f %7.2f %8.2f %8.2f\n", f.part.c_str(), f.facets, f.ms,
                f.core_ms, 100.0 * f.error, f.over_paper, f.over_exact, f.threads_gain,
                f.threads_gain_undisturbed);
  }
  if (sweeps.size() > 1) {
    const auto by_facets = [](const SweepFigures& a, const SweepFigures& b) { return a.facets < b.facets; };
    const auto [few, many] = std::minmax_element(sweeps.begin(), sweeps.end(), by_facets);
    std::printf("  from %zu to %zu facets, %.0f times as many: %.1f times the time of a direction\n",
                few->facets, many->facets,
                static_cast<double>(many->facets) / static_cast<double>(few->facets),
                many->core_ms / few->core_ms);
  }
  for (const LoadFigures& load : loads) {
    if (load.facets < 1'000'000) continue;
    std::printf("  %zu facets loaded in %.2f s and %.2f GiB\n", load.facets, load.seconds, load.peak_gib);
  }
}

void print_exact_summary(const std::vector<ExactFigures>& all) {
  std::printf("\nexact summary  five directions on all cores\n");
  std::printf("  %-22s %9s %9s %9s %9s %9s\n", "part", "facets", "worst ms", "mean ms", "x samples",
              "on cores");
  for (const ExactFigures& f : all) {
    std::printf("  %-22s %9zu %9.2f %9.2f %9.2f %9.2f\n", f.part.c_str(), f.facets, f.worst_ms, f.mean_ms,
                f.over_samples, f.over_samples_on_cores);
  }
  std::fflush(stdout);
}

void run(const BenchSettings& settings) {
  const test::ScratchFolder folder;
  std::printf("machine: %u cores, %s\n", std::thread::hardware_concurrency(), processor().c_str());
  const std::vector<PartFile> made = make_parts(folder, settings);
  std::vector<PartFile> files = made;
  if (!settings.quick) {
    for (const PartFile& part : real_parts()) files.push_back(part);
  }
  if (settings.exact_alone) {
    const auto context = create_context(Backend::automatic);
    std::vector<ExactFigures> exact;
    for (const PartFile& file : files) exact.push_back(print_exact_rows(file, *context, settings));
    print_exact_summary(exact);
    return;
  }
  const std::vector<LoadFigures> loads = print_load_rows(files, settings);
  print_classify_rows(files, settings);
  if (!settings.quick) {
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (settings.facets[i] == 50'000) print_whole_sweep_row(made[i]);
    }
    std::vector<PartFile> viewed;
    for (std::size_t i = 0; i < made.size(); ++i) {
      if (settings.facets[i] <= k_most_facets_in_view) viewed.push_back(made[i]);
    }
    if (!print_view_rows(viewed)) std::printf("\nlive view  left out: bench_view_frames is not built\n");
  }
  const auto context = create_context(Backend::automatic);
  std::printf("\nGL: %s, %s\n", context->backend().c_str(), context->renderer().c_str());
  std::vector<ExactFigures> exact;
  for (const PartFile& file : files) exact.push_back(print_exact_rows(file, *context, settings));
  print_exact_summary(exact);
  std::vector<SweepFigures> sweeps;
  for (std::size_t i = 0; i < files.size(); ++i) {
    Contenders contenders(files[i].path, settings);
    sweeps.push_back(print_sweep_rows(files[i].name, contenders, *context, settings));
  }
  print_summary(sweeps, loads);
}

BenchSettings settings_of(const std::vector<std::string>& arguments) {
  BenchSettings settings;
  for (const std::string& argument : arguments) {
    if (argument == "--quick") {
      settings.quick = true;
    } else if (argument == "--exact") {
      settings.exact_alone = true;
    } else if (!argument.empty() && argument.find_first_not_of("0123456789") == std::string::npos) {
      settings.facets.push_back(std::stoul(argument));
    } else {
      throw UsageError("usage: bench_speed [--quick] [--exact] [FACETS ...]");
    }
  }
  if (settings.quick) {
    settings.resolution = 128;
    settings.uniform_directions = 2;
    settings.rounds = 1;
    settings.seconds = 0.0;
    if (settings.facets.empty()) settings.facets = {5'000};
  }
  if (settings.facets.empty()) settings.facets.assign(std::begin(k_part_sizes), std::end(k_part_sizes));
  return settings;
}

int main(const std::vector<std::string>& arguments) {
  try {
    if (arguments.size() == 2 && arguments[0] == k_load_argument) {
      load_and_report(arguments[1]);
    } else if (arguments.size() == 3 && arguments[0] == k_make_argument) {
      make_part(arguments[1], std::stoul(arguments[2]));
    } else {
      run(settings_of(arguments));
    }
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_speed: %s\n", error.what());
    return dynamic_cast<const UsageError*>(&error) != nullptr ? 2 : 1;
  }
}

}  // namespace
}  // namespace moldlight::bench

int main(int count, char** arguments) { return moldlight::bench::main({arguments + 1, arguments + count}); }
