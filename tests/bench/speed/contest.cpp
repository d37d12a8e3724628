#include "bench/speed/contest.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

#include "base/check.hpp"
#include "base/numbers.hpp"

namespace moldlight::bench {

namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

double core_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}  // namespace

std::size_t Contest::add(double count, std::function<void()> work) {
  CHECK(count > 0.0);
  contestants_.push_back({count, std::move(work), {}});
  return contestants_.size() - 1;
}

void Contest::run(int least, double seconds) {
  for (Contestant& contestant : contestants_) contestant.work();
  const auto start = Clock::now();
  for (int round = 0; round < least || ms_since(start) < 1000.0 * seconds; ++round) {
    for (Contestant& contestant : contestants_) {
      const auto began = Clock::now();
      const double cores_began = core_ms();
      contestant.work();
      contestant.ms[k_cores].push_back((core_ms() - cores_began) / contestant.count);
      contestant.ms[k_wall].push_back(ms_since(began) / contestant.count);
    }
  }
}

double Contest::ms(std::size_t contestant, Time time) const {
  return median(contestants_[contestant].ms[time]);
}

double Contest::ratio(std::size_t slower, std::size_t faster, Time time) const {
  std::vector<double> ratios;
  for (std::size_t round = 0; round < rounds(); ++round) {
    ratios.push_back(contestants_[slower].ms[time][round] / contestants_[faster].ms[time][round]);
  }
  return median(ratios);
}

}  // namespace moldlight::bench
