// Which triangles of a plane mesh lie inside of its outline, and the regions outside.
#include <algorithm>
#include <deque>
#include <utility>
#include <vector>

#include "parting/halves/plane_mesh.hpp"

namespace moldlight {

void PlaneMesh::find_inside() {
  std::vector<std::uint8_t> depth(triangles_.size(), 2);
  std::deque<std::uint32_t> queue;
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    for (std::size_t side = 0; side < 3; ++side) {
      if (triangles_[k].across[side] != k_none) continue;
      depth[k] = triangles_[k].fixed[side] == k_outline ? 1 : 0;
      queue.push_back(k);
    }
  }
  while (!queue.empty()) {
    const std::uint32_t here = queue.front();
    queue.pop_front();
    for (std::uint32_t side = 0; side < 3; ++side) {
      const std::uint32_t there = triangles_[here].across[side];
      if (there == k_none || depth[there] != 2) continue;
      depth[there] = triangles_[here].fixed[side] == k_outline ? 1 - depth[here] : depth[here];
      queue.push_back(there);
    }
  }
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) triangles_[k].inside = depth[k] == 1;
  number_regions();
}

void PlaneMesh::number_regions() {
  std::vector<std::uint8_t> done(triangles_.size(), 0);
  regions_ = 0;
  const auto flood = [&](std::vector<std::uint32_t> waiting) {
    for (const std::uint32_t start : waiting) done[start] = 1;
    while (!waiting.empty()) {
      const std::uint32_t here = waiting.back();
      waiting.pop_back();
      triangles_[here].region = static_cast<std::uint32_t>(regions_);
      for (std::uint32_t side = 0; side < 3; ++side) {
        const std::uint32_t there = triangles_[here].across[side];
        if (there == k_none || done[there] != 0 || triangles_[here].fixed[side] == k_outline) continue;
        done[there] = 1;
        waiting.push_back(there);
      }
    }
    ++regions_;
  };
  // Where the outline reaches the rectangle's sides, what is around it lies in several pieces.
  std::vector<std::uint32_t> around;
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    if (!triangles_[k].inside &&
        std::ranges::find(triangles_[k].across, k_none) != triangles_[k].across.end())
      around.push_back(k);
  }
  flood(std::move(around));
  for (std::uint32_t k = 0; k < triangles_.size(); ++k) {
    if (done[k] == 0 && !triangles_[k].inside) flood({k});
  }
}

}  // namespace moldlight
