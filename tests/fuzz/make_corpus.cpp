// make_corpus FOLDER [PART…]: writes the seeds of the fuzz targets, FOLDER/<target>/…: small files of our own
// in every spelling, and those given parts that are small and of the target's format.
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <string>

#include "base/error.hpp"
#include "fuzz/seed_files.hpp"
#include "io/part_formats.hpp"
#include "io/step_result.hpp"

namespace fs = std::filesystem;
using namespace moldlight;

namespace {

constexpr std::uintmax_t k_max_seed_bytes = 60'000;

void write_seed(const fs::path& folder, const std::string& target, const std::string& name,
                const std::string& bytes) {
  fs::create_directories(folder / target);
  std::ofstream(folder / target / name, std::ios::binary)
      .write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
}

std::string target_of(const PartFormat& format) {
  static const std::map<std::string_view, std::string> k_targets = {{"STL binary", "fuzz_binary_stl"},
                                                                    {"STL ASCII", "fuzz_ascii_stl"},
                                                                    {"OBJ", "fuzz_obj"},
                                                                    {"PLY", "fuzz_ply"},
                                                                    {"OFF", "fuzz_off"},
                                                                    {"3MF", "fuzz_threemf"}};
  const auto found = k_targets.find(format.name);
  return found != k_targets.end() ? found->second : "";
}

void add_part(const fs::path& folder, const fs::path& path) {
  std::error_code error;
  if (fs::file_size(path, error) > k_max_seed_bytes || error) return;
  std::ifstream stream(path, std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  try {
    const std::string target = target_of(detect_format(path.string(), bytes));
    if (!target.empty()) write_seed(folder, target, path.filename().string(), bytes);
  } catch (const FileError&) {
    // No part file by content or name: no seed either.
  }
}

std::string step_result_seed() {
  StepResult result;
  result.unit = "mm";
  result.warnings = {"1 entity is faulty"};
  result.bodies = {{"pin", 1}, {"", 1}};
  result.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  result.facets = {{0, 1, 2}, {1, 2, 3}};
  result.faces = {0, 1};
  return result.to_bytes();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const fs::path folder = argv[1];
  for (const fuzz::SeedFile& seed : fuzz::seed_files()) {
    const std::string target = target_of(detect_format(seed.name, seed.bytes));
    write_seed(folder, target, seed.name, seed.bytes);
  }
  for (const fuzz::SeedFile& seed : fuzz::threemf_model_seeds()) {
    write_seed(folder, "fuzz_threemf_model", seed.name, seed.bytes);
  }
  write_seed(folder, "fuzz_step_result", "two_bodies", step_result_seed());
  for (int i = 2; i < argc; ++i) add_part(folder, argv[i]);
}
