#include "step/memory.hpp"

#include <algorithm>
#include <fstream>
#include <new>
#include <string>

#include <sys/resource.h>

namespace moldlight::step {

namespace {

// More than what OpenCASCADE asks for at a time.
constexpr std::uint64_t k_margin_bytes = std::uint64_t{32} << 20;
constexpr std::uint64_t k_margin_divisor = 16;  // and that part of the limit

std::uint64_t peak_address_space() {
  std::ifstream lines("/proc/self/status");
  for (std::string word; lines >> word;) {
    std::uint64_t kib = 0;
    if (word == "VmPeak:" && lines >> kib) return kib * 1024;
  }
  return 0;
}

}  // namespace

void limit_memory([[maybe_unused]] std::uint64_t bytes, void (*refused)()) {
  std::set_new_handler(refused);
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
  rlimit limit = {};
  // The superuser could raise what the caller has set.
  if (::getrlimit(RLIMIT_AS, &limit) == 0) bytes = std::min({bytes, limit.rlim_cur, limit.rlim_max});
  limit = {bytes, bytes};
  static_cast<void>(::setrlimit(RLIMIT_AS, &limit));
#endif
}

bool memory_ran_short() {
  rlimit limit = {};
  if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY) return false;
  return peak_address_space() + k_margin_bytes + limit.rlim_cur / k_margin_divisor > limit.rlim_cur;
}

}  // namespace moldlight::step
