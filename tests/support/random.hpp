// Random numbers that depend on the seed only: the standard's distributions differ by library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

#include <glm/vec3.hpp>

namespace moldlight::test {

class Random {
 public:
  explicit Random(std::uint32_t seed) : engine_(seed) {}

  [[nodiscard]] double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
  }
  /// In [0, count).
  [[nodiscard]] std::size_t below(std::size_t count) { return engine_() % count; }
  [[nodiscard]] bool chance(double share) { return between(0.0, 1.0) < share; }
  /// In the cube of that half-width about the origin.
  [[nodiscard]] glm::dvec3 in_cube(double half) {
    const double x = between(-half, half), y = between(-half, half);
    return {x, y, between(-half, half)};
  }
  template <typename Items>
  void shuffle(Items& items) {
    for (std::size_t i = items.size(); i > 1; --i) std::swap(items[i - 1], items[below(i)]);
  }

 private:
  std::mt19937 engine_;
};

}  // namespace moldlight::test
