#include "actions/stem.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace moldlight {

namespace {

constexpr std::size_t k_most_anchors = 48;                             // samples beside which it may stand
constexpr std::array k_behind = {0.0, 0.25, 0.5, 1.0, 1.5, 2.0, 3.0};  // them, widths
constexpr double k_wall = 0.25;                                        // of steel round it, likewise
constexpr double k_inset = 0.01;  // of the lines that are tested, likewise
constexpr int k_stem_lines = 5;   // each way
constexpr double k_step = 0.5;    // of its travel, widths

class StemPlaces {
 public:
  StemPlaces(const Release& release, const LifterWay& way, const StemSettings& settings)
      : release_(release),
        way_(way),
        width_(settings.width),
        across_(glm::cross(way.side, way.pull)),
        down_(glm::normalize(way.side - std::tan(glm::radians(settings.angle_deg)) * way.pull)) {}

  /// In an order by place: the lowest first, of these those in the middle.
  [[nodiscard]] std::vector<const UndercutSample*> anchors(std::span<const UndercutSample> samples) const {
    constexpr double k_same = 1e-6;
    const std::span<const UndercutSample> few = samples.first(std::min(samples.size(), k_most_anchors));
    double low = k_never, high = -k_never;
    for (const UndercutSample& sample : few) {
      low = std::min(low, glm::dot(glm::dvec3(sample.position), across_));
      high = std::max(high, glm::dot(glm::dvec3(sample.position), across_));
    }
    std::vector<const UndercutSample*> order;
    for (const UndercutSample& sample : few) order.push_back(&sample);
    std::ranges::stable_sort(order, {}, [&](const UndercutSample* sample) {
      const glm::dvec3 at(sample->position);
      return std::pair(-std::round(glm::dot(at, way_.side) / k_same),
                       std::round(std::abs(glm::dot(at, across_) - 0.5 * (low + high)) / k_same));
    });
    return order;
  }

  /// Whether it stands clear so far behind a place, and goes with the lifter.
  [[nodiscard]] bool is_clear(const glm::dvec3& from, double behind) const {
    const double wall = k_wall * width_;
    if (!is_clear_at(from, behind, wall)) return false;
    const int steps = std::max(1, static_cast<int>(std::ceil(way_.length / (k_step * width_))));
    for (int step = 1; step <= steps; ++step)
      if (!is_clear_at(from + way_.length * step / steps * way_.pull, behind, 0.0)) return false;
    return true;
  }

  [[nodiscard]] Stem stem(const glm::dvec3& from, double behind, double lowest) const {
    const glm::dvec3 middle = from + (behind + 0.5 * width_) * way_.pull;
    const double fall = (lowest - glm::dot(middle, way_.side)) / glm::dot(down_, way_.side);
    return {.top = middle + fall * down_,
            .way = down_,
            .travel = way_.pull,
            .across = across_,
            .width = width_,
            .behind = behind + 0.5 * width_};
  }

 private:
  [[nodiscard]] bool is_clear_at(const glm::dvec3& from, double behind, double wall) const {
    const double inset = k_inset * width_;
    for (int i = 0; i < k_stem_lines; ++i) {
      for (int j = 0; j < k_stem_lines; ++j) {
        const double u = static_cast<double>(i) / (k_stem_lines - 1),
                     v = static_cast<double>(j) / (k_stem_lines - 1);
        const glm::dvec3 at = from + (behind + inset + u * (width_ + wall - 2.0 * inset)) * way_.pull +
                              (v - 0.5) * (width_ + 2.0 * wall - 2.0 * inset) * across_;
        if (!release_.leaves(at, down_)) return false;
      }
    }
    return true;
  }

  const Release& release_;
  LifterWay way_;
  double width_;
  glm::dvec3 across_, down_;
};

}  // namespace

std::optional<Stem> find_stem(const Release& release, FreeLengths& lengths, const LifterWay& way,
                              const StemSettings& settings) {
  const StemPlaces places(release, way, settings);
  double lowest = -k_never;
  for (const UndercutSample& sample : lengths.samples())
    lowest = std::max(lowest, glm::dot(glm::dvec3(sample.position), way.side));
  const std::vector<const UndercutSample*> anchors = places.anchors(lengths.samples());
  for (const double widths : k_behind) {
    const double behind = widths * settings.width;
    for (const UndercutSample* anchor : anchors) {
      const glm::dvec3 from(release.start(*anchor, way.pull));
      if (!places.is_clear(from, behind) || lengths.of(*anchor) < way.length + behind + settings.width)
        continue;
      return places.stem(from, behind, lowest);
    }
  }
  return std::nullopt;
}

TriangleMesh stem_solid(const Stem& stem, double length) {
  TriangleMesh solid;
  for (const double down : {0.0, length})
    for (const auto& [u, v] :
         {std::pair(-0.5, -0.5), std::pair(0.5, -0.5), std::pair(0.5, 0.5), std::pair(-0.5, 0.5)})
      solid.vertices.push_back(stem.top + down * stem.way + stem.width * (u * stem.travel + v * stem.across));
  solid.facets = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}};
  for (VertexIndex k = 0; k < 4; ++k) {
    const VertexIndex next = (k + 1) % 4;
    solid.facets.push_back({k, next, next + 4});
    solid.facets.push_back({k, next + 4, k + 4});
  }
  return solid;
}

}  // namespace moldlight
