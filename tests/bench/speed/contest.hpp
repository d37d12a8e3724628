// Timing of several ways to do the same work, in turns, so that what else the machine does hits all of them.
#pragma once

#include <cstddef>
#include <functional>
#include <vector>

namespace moldlight::bench {

class Contest {
 public:
  /// `work` handles `count` items (directions, files) at once. Gives the contestant's number.
  std::size_t add(double count, std::function<void()> work);

  /// Each contestant once to warm up, then rounds of all in turn: `least` rounds, and more of them until
  /// `seconds` are over.
  void run(int least, double seconds);

  /// Wall: by the clock. Cores: time that all cores together spent in the program, which says the same on a
  /// machine that others use too.
  enum Time { k_wall, k_cores };
  /// Median time of an item in milliseconds.
  [[nodiscard]] double ms(std::size_t contestant, Time time) const;
  /// How many times as long an item takes `slower` as `faster`: median over the rounds of the ratio within
  /// the round.
  [[nodiscard]] double ratio(std::size_t slower, std::size_t faster, Time time) const;
  [[nodiscard]] std::size_t rounds() const {
    return contestants_.empty() ? 0 : contestants_[0].ms[k_wall].size();
  }

 private:
  struct Contestant {
    double count;
    std::function<void()> work;
    std::vector<double> ms[2];  // of an item, one a round; by Time
  };
  std::vector<Contestant> contestants_;
};

}  // namespace moldlight::bench
