#include "parting/insert_actions.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

namespace moldlight {

namespace {

constexpr double k_near = 1e-4;  // of the diagonal: corners of the part and of an insert are one

using Cell = std::array<std::int64_t, 3>;

}  // namespace

std::vector<InsertActions> actions_of_inserts(const MoldHalves& halves, const SplitMesh& split,
                                              const ActionPlan& plan) {
  std::vector<InsertActions> found(halves.inserts.size());
  if (halves.inserts.empty()) return found;
  Bounds box;
  for (const glm::dvec3& vertex : split.vertices) box.add(vertex);
  const double cell = k_near * box.diagonal();
  // Each corner of an insert is in the cell where it lies and in those that it is near to.
  std::map<Cell, std::set<std::size_t>> inserts_at;
  for (std::size_t k = 0; k < halves.inserts.size(); ++k) {
    for (const glm::dvec3& vertex : halves.inserts[k].mesh.vertices) {
      const glm::dvec3 at = vertex / halves.scale / cell;
      for (int around = 0; around < 8; ++around) {
        Cell place{};
        for (std::size_t axis = 0; axis < 3; ++axis) {
          const double offset = (around >> axis & 1) != 0 ? 0.25 : -0.25;
          place[axis] = static_cast<std::int64_t>(std::floor(at[static_cast<int>(axis)] + offset));
        }
        inserts_at[place].insert(k);
      }
    }
  }
  for (std::size_t undercut = 0; undercut < plan.undercuts.size(); ++undercut) {
    std::map<std::size_t, std::size_t> corners;
    for (const std::uint32_t piece : plan.undercuts[undercut].undercut.pieces) {
      for (const VertexIndex vertex : split.pieces[piece].corners) {
        const glm::dvec3 at = halves.frame.to_mold(split.vertices[vertex] - halves.centre) / cell;
        Cell place{};
        for (std::size_t axis = 0; axis < 3; ++axis)
          place[axis] = static_cast<std::int64_t>(std::floor(at[static_cast<int>(axis)]));
        const auto here = inserts_at.find(place);
        if (here == inserts_at.end()) continue;
        for (const std::size_t insert : here->second) ++corners[insert];
      }
    }
    const auto most = std::ranges::max_element(corners, {}, [](const auto& entry) { return entry.second; });
    if (most == corners.end()) continue;
    InsertActions& insert = found[most->first];
    if (std::ranges::find(plan.unreleased, undercut) != plan.unreleased.end()) ++insert.unreleased;
    for (std::size_t action = 0; action < plan.actions.size(); ++action) {
      const auto& undercuts = plan.actions[action].undercuts;
      if (std::ranges::find(undercuts, undercut) != undercuts.end()) insert.actions.push_back(action);
    }
  }
  for (InsertActions& insert : found) {
    std::ranges::sort(insert.actions);
    insert.actions.erase(std::unique(insert.actions.begin(), insert.actions.end()), insert.actions.end());
  }
  return found;
}

}  // namespace moldlight
