#include <algorithm>
#include <array>
#include <cstdlib>
#include <new>
#include <string_view>

#include <fcntl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "step/limits.hpp"

namespace moldlight::step {

namespace {

// More than what OpenCASCADE asks for at a time.
constexpr std::uint64_t k_margin_bytes = std::uint64_t{32} << 20;
constexpr std::uint64_t k_margin_divisor = 16;  // and that part of the limit

/// /proc/self/status, opened while files still may be.
int open_status = -1;

std::uint64_t peak_address_space() {
  std::array<char, 4096> text{};
  const ssize_t got = ::pread(open_status, text.data(), text.size() - 1, 0);
  const std::string_view lines(text.data(), got > 0 ? static_cast<std::size_t>(got) : 0);
  constexpr std::string_view k_peak = "VmPeak:";
  const std::size_t at = lines.find(k_peak);
  return at == std::string_view::npos ? 0
                                      : 1024 * std::strtoull(lines.data() + at + k_peak.size(), nullptr, 10);
}

}  // namespace

void limit_memory([[maybe_unused]] std::uint64_t bytes, void (*refused)()) {
  std::set_new_handler(refused);
  open_status = ::open("/proc/self/status", O_RDONLY | O_CLOEXEC);
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
