// What users wait for: loading, classifying and a whole sweep, each in a process of its own, with the memory
// that it takes.
#pragma once

#include <string>
#include <vector>

#include "bench/speed/bench_settings.hpp"
#include "bench/speed/parts.hpp"

namespace moldlight::bench {

/// Arguments by which the suite runs itself.
inline constexpr const char* k_load_argument = "--load-only";
inline constexpr const char* k_make_argument = "--make-only";

/// Loads a part and prints what took how long and the memory in use at most, for load_rows to read.
void load_and_report(const std::string& path);

struct LoadFigures {
  std::size_t facets = 0;
  double seconds = 0.0;  // to read, weld, orient, find neighbours and check health
  double peak_gib = 0.0;
};

/// Prints a row a part. Run before the suite itself takes memory: a process starts with its parent's peak.
[[nodiscard]] std::vector<LoadFigures> print_load_rows(const std::vector<PartFile>& parts,
                                                       const BenchSettings& settings);
void print_classify_rows(const std::vector<PartFile>& parts, const BenchSettings& settings);
void print_whole_sweep_row(const PartFile& part);
/// Frame times of the live view, by the program bench_view_frames; false where that was not built.
bool print_view_rows(const std::vector<PartFile>& parts);

}  // namespace moldlight::bench
