#include "mold/patches.hpp"

#include <algorithm>
#include <numeric>

namespace moldlight {

namespace {
constexpr double k_least_share = 1e-5;  // of the part's area
constexpr double k_large_share = 1e-3;  // of the part's area
constexpr auto k_undercut = static_cast<std::size_t>(Region::undercut);
}  // namespace

UndercutPatches undercut_patches(const FacetFractions& facet_fractions, const FacetGeometry& geometry,
                                 const Adjacency& adjacency) {
  const auto belongs = [&](FacetIndex facet) {
    const double share = facet_fractions[facet][k_undercut];
    return share >= 0.5 || share * geometry.areas[facet] >= k_large_share * geometry.total_area;
  };
  UndercutPatches patches;
  patches.of_facet.assign(facet_fractions.size(), k_no_facet);
  std::vector<FacetIndex> queue;
  for (FacetIndex seed = 0; seed < facet_fractions.size(); ++seed) {
    if (patches.of_facet[seed] != k_no_facet || !belongs(seed)) continue;
    const auto patch = static_cast<FacetIndex>(patches.areas.size());
    double area = 0.0;
    queue.assign(1, seed);
    patches.of_facet[seed] = patch;
    while (!queue.empty()) {
      const FacetIndex facet = queue.back();
      queue.pop_back();
      area += geometry.areas[facet] * facet_fractions[facet][k_undercut];
      for (const FacetIndex next : adjacency.across[facet]) {
        if (next == k_no_facet || patches.of_facet[next] != k_no_facet || !belongs(next)) continue;
        patches.of_facet[next] = patch;
        queue.push_back(next);
      }
    }
    patches.areas.push_back(area);
  }

  std::vector<FacetIndex> order(patches.areas.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(),
                   [&](FacetIndex a, FacetIndex b) { return patches.areas[a] > patches.areas[b]; });
  std::vector<FacetIndex> number(order.size(), k_no_facet);
  std::vector<double> areas;
  for (const FacetIndex patch : order) {
    if (patches.areas[patch] < k_least_share * geometry.total_area) break;
    number[patch] = static_cast<FacetIndex>(areas.size());
    areas.push_back(patches.areas[patch]);
  }
  for (FacetIndex& patch : patches.of_facet) {
    if (patch != k_no_facet) patch = number[patch];
  }
  patches.areas = std::move(areas);
  patches.count = patches.areas.size();
  return patches;
}

}  // namespace moldlight
