// Caps of directions around the cells that a proof left open.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "mesh/union_find.hpp"
#include "mold/direction.hpp"
#include "proof/direction_proof.hpp"

namespace moldlight {

namespace {

/// A cap that is no wider, or no larger than its cells by more than this, is not divided.
constexpr double k_small_deg = 10.0, k_loose = 3.0;
constexpr double k_wider_deg = 1e-6;

struct OpenCell {
  const ProofCell* cell;
  glm::dvec3 centre;  // turned to the side of its neighbours
};

/// Cells touch where their caps do.
bool touch(const SphereCell& a, const SphereCell& b) {
  constexpr double k_slack_rad = 1e-6;
  const double reach = a.radius_rad() + b.radius_rad() + k_slack_rad;
  return std::abs(glm::dot(a.centre(), b.centre())) >= std::cos(std::min(reach, 1.5));
}

double cap_share(double radius_deg) { return 1.0 - std::cos(glm::radians(radius_deg)); }

DirectionCap cap_around(std::span<const OpenCell> cells) {
  DirectionCap cap;
  cap.bound = std::numeric_limits<double>::infinity();
  glm::dvec3 sum(0.0);
  for (const OpenCell& open : cells) {
    const double share = open.cell->cell.share();
    cap.share += share;
    cap.bound = std::min(cap.bound, open.cell->bound);
    sum += share * open.centre;
  }
  if (glm::length(sum) > 1e-9 * cap.share) cap.direction = half_sphere(glm::normalize(sum));
  for (const OpenCell& open : cells) {
    for (const glm::dvec3& corner : open.cell->cell.corners())
      cap.radius_deg = std::max(cap.radius_deg, line_angle_deg(cap.direction, corner) + k_wider_deg);
  }
  // So wide a cap and its opposite meet all but.
  if (cap.radius_deg > 80.0) cap.radius_deg = 90.0;
  return cap;
}

/// Groups of cells that hang together.
std::vector<std::vector<OpenCell>> groups(std::span<const ProofCell> cells) {
  std::vector<const ProofCell*> open;
  for (const ProofCell& cell : cells) {
    if (!cell.proved) open.push_back(&cell);
  }
  // Along z, so that only few pairs are looked at: what touches differs in |z| by little.
  std::ranges::stable_sort(open, {}, [](const ProofCell* c) { return c->cell.centre().z; });
  double widest = 0.0;
  for (const ProofCell* cell : open) widest = std::max(widest, cell->cell.radius_rad());
  UnionFind sets(open.size());
  for (std::uint32_t a = 0; a < open.size(); ++a) {
    for (std::uint32_t b = a + 1; b < open.size(); ++b) {
      if (open[b]->cell.centre().z - open[a]->cell.centre().z > 2.0 * widest + 1e-6) break;
      if (sets.find(a) != sets.find(b) && touch(open[a]->cell, open[b]->cell)) sets.join(a, b);
    }
  }
  std::map<std::uint32_t, std::vector<OpenCell>> by_set;
  for (std::uint32_t k = 0; k < open.size(); ++k) {
    std::vector<OpenCell>& group = by_set[sets.find(k)];
    glm::dvec3 centre = open[k]->cell.centre();
    if (!group.empty() && glm::dot(group.front().centre, centre) < 0.0) centre = -centre;
    group.push_back({open[k], centre});
  }
  std::vector<std::vector<OpenCell>> all;
  for (auto& [set, group] : by_set) all.push_back(std::move(group));
  return all;
}

/// Divides a group between the two of its cells that are about farthest from each other.
void add_caps(std::vector<OpenCell> group, std::vector<DirectionCap>& caps) {
  const DirectionCap cap = cap_around(group);
  if (cap.radius_deg <= k_small_deg || cap_share(cap.radius_deg) <= k_loose * cap.share || group.size() < 2) {
    caps.push_back(cap);
    return;
  }
  const auto farthest_from = [&](const glm::dvec3& direction) {
    return std::ranges::max_element(
               group, {}, [&](const OpenCell& open) { return line_angle_deg(open.centre, direction); })
        ->centre;
  };
  const glm::dvec3 one = farthest_from(cap.direction), other = farthest_from(one);
  std::array<std::vector<OpenCell>, 2> parts;
  for (OpenCell& open : group) {
    const double to_one = glm::dot(open.centre, one), to_other = glm::dot(open.centre, other);
    const std::size_t nearer = std::abs(to_other) > std::abs(to_one) ? 1 : 0;
    if ((nearer == 1 ? to_other : to_one) < 0.0) open.centre = -open.centre;
    parts[nearer].push_back(open);
  }
  if (parts[0].empty() || parts[1].empty()) {
    caps.push_back(cap);
    return;
  }
  for (std::vector<OpenCell>& each : parts) add_caps(std::move(each), caps);
}

}  // namespace

std::vector<DirectionCap> open_caps(std::span<const ProofCell> cells) {
  std::vector<DirectionCap> caps;
  for (std::vector<OpenCell>& group : groups(cells)) add_caps(std::move(group), caps);
  std::ranges::stable_sort(caps, std::greater(), &DirectionCap::share);
  return caps;
}

}  // namespace moldlight
