#include "bench/speed/process_rows.hpp"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <fcntl.h>
#include <nlohmann/json.hpp>
#include <unistd.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/stopwatch.hpp"
#include "bench/speed/contest.hpp"
#include "classify/part_model.hpp"
#include "support/process.hpp"

namespace moldlight::bench {

namespace {

constexpr double k_gib = 1024.0 * 1024.0 * 1024.0;
constexpr double k_time_limit_s = 300.0;

/// The most memory that was resident at once, of this process alone.
double peak_gib() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmHWM:")) return std::stod(line.substr(6)) * 1024.0 / k_gib;
  }
  return 0.0;
}

test::ProcessResult run_and_check(const std::vector<std::string>& arguments) {
  test::ProcessSettings settings;
  settings.time_limit_s = k_time_limit_s;
  test::ProcessResult result = test::Process(arguments, settings).finish();
  if (result.exit_code != 0) throw Error(arguments[0] + " " + arguments[1] + " failed: " + result.err);
  return result;
}

std::string program() { return std::filesystem::read_symlink("/proc/self/exe").string(); }

/// Reads a file once and forgets it: no reader can be faster.
void stream_file(const std::string& path) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw Error(path + " cannot be opened");
  std::vector<char> bytes(std::size_t{1} << 20);
  while (::read(file, bytes.data(), bytes.size()) > 0) {
  }
  ::close(file);
}

}  // namespace

void load_and_report(const std::string& path) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [start] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  Part part = read_part(path, {}, Progress{});
  const double read_s = seconds();
  const auto model = prepare_part(std::move(part), Progress{});
  const double checked_s = seconds();
  static_cast<void>(model->rays());
  const double all_s = seconds();
  std::printf("%zu %.4f %.4f %.4f %.4f\n", model->part.mesh.facets.size(), read_s, checked_s, all_s,
              peak_gib());
}

std::vector<LoadFigures> print_load_rows(const std::vector<PartFile>& parts, const BenchSettings& settings) {
  std::printf("\nload  read and weld; then adjacency and health; then the ray tree\n");
  std::printf("  %-26s %9s %9s %9s %9s %9s %9s %12s\n", "part", "facets", "read s", "+ health", "s so far",
              "+ tree", "peak GiB", "x file read");
  std::vector<LoadFigures> all;
  for (const PartFile& part : parts) {
    LoadFigures figures;
    std::vector<double> reads, checks, wholes, ratios;
    for (int round = 0; round < (settings.quick ? 1 : 3); ++round) {
      const auto start = std::chrono::steady_clock::now();
      stream_file(part.path);
      const double streamed_s =
          std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
      std::istringstream words(run_and_check({program(), k_load_argument, part.path}).out);
      double read_s = 0.0, checked_s = 0.0, all_s = 0.0, peak = 0.0;
      if (!(words >> figures.facets >> read_s >> checked_s >> all_s >> peak))
        throw Error("no figures of loading");
      reads.push_back(read_s);
      checks.push_back(checked_s);
      wholes.push_back(all_s);
      ratios.push_back(checked_s / streamed_s);
      figures.peak_gib = std::max(figures.peak_gib, peak);
    }
    figures.seconds = median(checks);
    std::printf("  %-26s %9zu %9.3f %9.3f %9.3f %9.3f %9.3f %12.1f\n", part.name.c_str(), figures.facets,
                median(reads), figures.seconds - median(reads), figures.seconds,
                median(wholes) - figures.seconds, figures.peak_gib, median(ratios));
    std::fflush(stdout);
    all.push_back(figures);
  }
  return all;
}

void print_classify_rows(const std::vector<PartFile>& parts, const BenchSettings& settings) {
  std::printf("\nclassify  moldlight classify, default settings, one direction\n");
  std::printf("  %-26s %9s %9s %9s %9s %9s\n", "part", "load s", "regions s", "readout s", "all s",
              "peak GiB");
  for (const PartFile& part : parts) {
    std::vector<std::string> arguments = {MOLDLIGHT_BINARY, "classify", part.path, "--direction",
                                          "0,0,1",          "--json",   "-"};
    if (settings.quick) arguments.insert(arguments.end(), {"--resolution", "256", "--samples", "20000"});
    const Stopwatch stopwatch;
    const test::ProcessResult run = run_and_check(arguments);
    const double whole_s = 1e-3 * stopwatch.elapsed_ms();
    const auto timings = nlohmann::json::parse(run.out)["timings_ms"];
    const auto seconds = [&](const char* key) { return timings[key].get<double>() / 1000.0; };
    std::printf("  %-26s %9.3f %9.3f %9.3f %9.3f %9.3f\n", part.name.c_str(), seconds("load"),
                seconds("regions"), seconds("readout"), whole_s,
                static_cast<double>(run.peak_memory) / k_gib);
    std::fflush(stdout);
  }
}

void print_whole_sweep_row(const PartFile& part) {
  const Stopwatch stopwatch;
  const test::ProcessResult run = run_and_check({MOLDLIGHT_BINARY, "sweep", part.path});
  std::printf(
      "\nwhole sweep  moldlight sweep %s, default settings, final figures included: %.2f s, peak %.3f GiB\n",
      part.name.c_str(), 1e-3 * stopwatch.elapsed_ms(), static_cast<double>(run.peak_memory) / k_gib);
  std::fflush(stdout);
}

bool print_view_rows(const std::vector<PartFile>& parts) {
  const std::filesystem::path frames = std::filesystem::path(program()).parent_path() / "bench_view_frames";
  if (!std::filesystem::exists(frames)) return false;
  std::vector<std::string> arguments = {frames.string()};
  for (const PartFile& part : parts) arguments.push_back(part.path);
  std::printf("\nlive view  against (c), plain shading\n%s", run_and_check(arguments).out.c_str());
  std::fflush(stdout);
  return true;
}

}  // namespace moldlight::bench
