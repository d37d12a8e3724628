#include "io/memory_check.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <string_view>

#include <fmt/format.h>
#include <sys/resource.h>
#include <unistd.h>

#include "base/error.hpp"

namespace moldlight {

namespace {

constexpr std::uint64_t k_unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t k_unchecked_bytes = std::uint64_t{64} << 20;
constexpr double k_gib = 1024.0 * 1024.0 * 1024.0;

std::uint64_t difference(std::uint64_t limit, std::uint64_t used) { return limit > used ? limit - used : 0; }

std::uint64_t free_by_machine() {
  std::ifstream lines("/proc/meminfo");
  for (std::string word; lines >> word;) {
    std::uint64_t kib = 0;
    if (word == "MemAvailable:" && lines >> kib) return kib * 1024;
  }
  return k_unlimited;
}

std::uint64_t free_by_control_group() {
  std::ifstream limit_file("/sys/fs/cgroup/memory.max"), used_file("/sys/fs/cgroup/memory.current");
  std::uint64_t limit = 0, used = 0;
  return limit_file >> limit && used_file >> used ? difference(limit, used) : k_unlimited;
}

std::uint64_t free_by_own_limit() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return k_unlimited;
  std::ifstream pages_file("/proc/self/statm");
  std::uint64_t pages = 0;
  if (!(pages_file >> pages)) return k_unlimited;
  return difference(limit.rlim_cur, pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)));
}

}  // namespace

std::uint64_t available_memory_bytes() {
  return std::min({free_by_machine(), free_by_control_group(), free_by_own_limit()});
}

void check_memory(const std::string& path, std::uint64_t bytes) {
  if (bytes < k_unchecked_bytes) return;
  const std::uint64_t available = available_memory_bytes();
  if (bytes <= available) return;
  throw FileError(path, "",
                  fmt::format("needs {:.1f} GiB of memory at least, but {:.1f} GiB are free; close other "
                              "programs or coarsen the part",
                              static_cast<double>(bytes) / k_gib, static_cast<double>(available) / k_gib));
}

}  // namespace moldlight
