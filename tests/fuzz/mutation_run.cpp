// mutation_run COUNT [PART…]: reads COUNT mutations of sound files (our own, and the given parts) and counts
// how each ends. The seeds are fixed: mutation k is the same in every run. Exit code 1 for a crash or a file
// that takes too long.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>

#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "base/error.hpp"
#include "fuzz/check_part.hpp"
#include "fuzz/mutate.hpp"
#include "fuzz/seed_files.hpp"
#include "io/part_formats.hpp"
#include "support/zip_bytes.hpp"

namespace fs = std::filesystem;
using namespace moldlight;

namespace {

constexpr double k_longest_s = 5.0;

/// Shared with the child process that does the work, so that its figures outlive it.
struct Figures {
  std::uint64_t next = 0;  // mutation to be read
  std::uint64_t read = 0, read_with_warnings = 0, clean_errors = 0, broken_step_reader = 0, too_long = 0;
  double longest_s = 0.0;
};

std::string file_bytes(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

void read_mutation(const fuzz::SeedFile& seed, std::uint64_t number, const fs::path& folder,
                   Figures& figures) {
  const fs::path path = folder / ("mutation" + fs::path(seed.name).extension().string());
  std::string bytes = fuzz::mutate(seed.bytes, number);
  if (seed.is_model) bytes = test::threemf_bytes(bytes);
  std::ofstream(path, std::ios::binary).write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  const auto start = std::chrono::steady_clock::now();
  try {
    Part part = read_part(path.string(), {}, Progress());
    ++(part.warnings.empty() ? figures.read : figures.read_with_warnings);
    fuzz::check_part(std::move(part));
  } catch (const Error& error) {
    const bool by_step =
        std::string_view(error.what()).find("breaks the STEP reader") != std::string_view::npos;
    ++(by_step ? figures.broken_step_reader : figures.clean_errors);
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (seconds > k_longest_s) {
    ++figures.too_long;
    std::cerr << "mutation " << number << " of " << seed.name << " took " << seconds << " s\n";
  }
  figures.longest_s = std::max(figures.longest_s, seconds);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: mutation_run COUNT [PART...]\n";
    return 2;
  }
  const std::uint64_t count = std::strtoull(argv[1], nullptr, 10);
  std::vector<fuzz::SeedFile> seeds = fuzz::seed_files();
  for (const fuzz::SeedFile& model : fuzz::threemf_model_seeds()) seeds.push_back(model);
  for (int i = 2; i < argc; ++i)
    seeds.push_back({fs::path(argv[i]).filename().string(), file_bytes(argv[i])});
  std::string folder_name = (fs::temp_directory_path() / "moldlight_mutations_XXXXXX").string();
  if (::mkdtemp(folder_name.data()) == nullptr) return 1;

  auto* figures = static_cast<Figures*>(
      ::mmap(nullptr, sizeof(Figures), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  if (figures == MAP_FAILED) return 1;
  new (figures) Figures;
  std::uint64_t crashes = 0;
  while (figures->next < count) {
    const pid_t child = ::fork();
    if (child < 0) return 1;
    if (child == 0) {
      while (figures->next < count) {
        const std::uint64_t number = figures->next;
        read_mutation(seeds[number % seeds.size()], number, folder_name, *figures);
        figures->next = number + 1;
      }
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
    std::cerr << "mutation " << figures->next << " of " << seeds[figures->next % seeds.size()].name
              << " crashed\n";
    ++crashes;
    ++figures->next;
  }
  fs::remove_all(folder_name);
  rusage usage = {};
  ::getrusage(RUSAGE_CHILDREN, &usage);
  std::cout << count << " mutations of " << seeds.size() << " files: " << figures->clean_errors
            << " clean errors, " << figures->broken_step_reader
            << " files that OpenCASCADE could not survive, " << figures->read_with_warnings
            << " read with warnings, " << figures->read << " read without, " << crashes << " crashes, "
            << figures->too_long << " over " << k_longest_s << " s; longest " << figures->longest_s
            << " s, most memory " << usage.ru_maxrss / 1024 << " MiB\n";
  return crashes + figures->too_long == 0 ? 0 : 1;
}
