// wide_mesh_run COUNT [FIRST [KINDS]]: asks for split mesh, side actions, mold halves and comparison of COUNT
// wide parts of random bytes, and counts how many were refused. Run k is the same every time. A child runs
// them, so that a crash is reported with its number. Exit code 1 for a crash or for one that takes more than
// a minute of the processor.
#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <vector>

#include <sys/mman.h>
#include <sys/time.h>
#include <sys/wait.h>
#include <tbb/global_control.h>
#include <unistd.h>

#include "fuzz/wide_mesh.hpp"
#include "support/random.hpp"

using namespace moldlight;

namespace {

constexpr time_t k_longest_s = 60;  // of the processor, whatever else the machine does
constexpr std::size_t k_most_bytes = 160;
constexpr const char* k_names[] = {"split mesh", "side actions", "mold halves", "comparison"};

/// Shared with the child, so that its figures outlive it.
struct Figures {
  std::uint32_t next = 0;
  std::size_t asked[4] = {}, refused[4] = {};
};

std::vector<std::uint8_t> bytes_of(std::uint32_t number) {
  test::Random random(number);
  std::vector<std::uint8_t> bytes(8 + random.below(k_most_bytes));
  for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
  return bytes;
}

/// Ends this process by a signal after so many seconds of the processor; 0: no more.
void limit_processor(time_t seconds) {
  const itimerval limit = {.it_interval = {}, .it_value = {.tv_sec = seconds, .tv_usec = 0}};
  ::setitimer(ITIMER_PROF, &limit, nullptr);
}

void run(std::uint32_t number, std::size_t kinds, Figures& figures) {
  const std::vector<std::uint8_t> bytes = bytes_of(number);
  const fuzz::WidePart wide = fuzz::wide_part(bytes);
  const std::size_t kind = number % kinds;
  limit_processor(k_longest_s);
  const bool answered = kind == 0   ? fuzz::try_split_mesh(wide)
                        : kind == 1 ? fuzz::try_actions(wide)
                        : kind == 2 ? fuzz::try_mold(wide)
                                    : fuzz::try_compare(bytes);
  limit_processor(0);
  ++figures.asked[kind];
  figures.refused[kind] += answered ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  const auto first = static_cast<std::uint32_t>(argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 0);
  // Only the first so many kinds.
  const std::size_t kinds = argc > 3 ? std::clamp<std::size_t>(std::strtoul(argv[3], nullptr, 10), 1, 4) : 4;
  const auto end = first + static_cast<std::uint32_t>(std::strtoul(argv[1], nullptr, 10));
  auto& figures = *static_cast<Figures*>(
      ::mmap(nullptr, sizeof(Figures), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0));
  figures.next = first;
  int faults = 0;
  while (figures.next < end) {
    const pid_t child = ::fork();
    if (child == 0) {
      const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
      for (; figures.next < end; ++figures.next) run(figures.next, kinds, figures);
      ::_exit(0);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) continue;
    std::cout << "run " << figures.next << " (" << k_names[figures.next % kinds] << ") ended by signal "
              << (WIFSIGNALED(status) ? WTERMSIG(status) : 0) << '\n';
    ++faults;
    ++figures.next;
  }
  for (std::size_t kind = 0; kind < 4; ++kind)
    std::cout << k_names[kind] << ": " << figures.asked[kind] << " asked for, " << figures.refused[kind]
              << " refused\n";
  return faults == 0 ? 0 : 1;
}
