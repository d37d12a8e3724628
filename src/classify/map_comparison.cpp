#include "classify/map_comparison.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "base/check.hpp"
#include "mold/measure.hpp"

namespace moldlight {

namespace {

constexpr double k_least_samples = 4.0;  // of a region that is there

}  // namespace

double MapComparison::total() const {
  double sum = 0.0;
  for (const RegionValues& row : areas) sum += row.total();
  return sum;
}

double MapComparison::differing() const {
  double sum = 0.0;
  for (const Region exact : k_regions) {
    for (const Region shown : k_regions) {
      if (shown != exact) sum += areas[static_cast<std::size_t>(exact)][shown];
    }
  }
  return sum;
}

double MapComparison::excess(Region region) const {
  double sum = -areas[static_cast<std::size_t>(region)].total();
  for (const RegionValues& row : areas) sum += row[region];
  return sum;
}

double piece_area(const SplitMesh& split, const SplitPiece& piece) {
  const glm::dvec3& first = split.vertices[piece.corners[0]];
  return 0.5 * glm::length(glm::cross(split.vertices[piece.corners[1]] - first,
                                      split.vertices[piece.corners[2]] - first));
}

glm::dvec3 piece_point(const SplitMesh& split, const SplitPiece& piece, const TrianglePlace& place) {
  const auto& [a, b, c] = piece.corners;
  return place.in(split.vertices[a], split.vertices[b], split.vertices[c]);
}

PieceSamples sample_pieces(const SplitMesh& split, const UnitFrame& frame, std::size_t wanted) {
  PieceSamples set;
  for (const SplitPiece& piece : split.pieces) set.areas[piece.region] += piece_area(split, piece);
  const double total = set.areas.total();
  for (const Region region : k_regions) {
    const double area = set.areas[region];
    const double count =
        area > 0.0 ? std::max(k_least_samples, std::ceil(static_cast<double>(wanted) * area / total)) : 0.0;
    double next = 0.5,
           covered = 0.0;  // of the region, in samples: the next one's place, and the pieces so far
    for (const SplitPiece& piece : split.pieces) {
      if (piece.region != region || count == 0.0) continue;
      covered += count * (piece_area(split, piece) / area);
      for (; next < covered; next += 1.0) {
        const glm::dvec3 point = piece_point(split, piece, triangle_place(set.samples.size()));
        set.samples.push_back({frame.to_unit(point), piece.facet});
      }
    }
    set.first[static_cast<std::size_t>(region) + 1] = set.samples.size();
  }
  return set;
}

MapComparison compare_maps(const PieceSamples& samples, std::span<const std::uint8_t> verdicts) {
  CHECK(verdicts.size() == samples.samples.size());
  MapComparison comparison{.areas = {}, .error = 0.0, .samples = verdicts.size()};
  double variance = 0.0;
  for (const Region region : k_regions) {
    const auto exact = static_cast<std::size_t>(region);
    const auto seen = verdicts.subspan(samples.first[exact], samples.first[exact + 1] - samples.first[exact]);
    if (seen.empty()) continue;
    RegionValues shares;
    for (const std::uint8_t verdict : seen) shares[verdict_region(verdict)] += 1.0;
    const double area = samples.areas[region], count = shares.total();
    for (const Region shown : k_regions) comparison.areas[exact][shown] = area * shares[shown] / count;
    const double same = shares[region] / count;
    variance += area * area * same * (1.0 - same) / (count - 1.0);
  }
  comparison.error = 2.0 * std::sqrt(variance);
  return comparison;
}

std::string comparison_text(const MapComparison& comparison) {
  const double percent = comparison.total() > 0.0 ? 100.0 / comparison.total() : 0.0;
  const double excess = percent * comparison.excess(Region::undercut);
  const std::string size = fmt::format("{:.2f} %", std::abs(excess));
  return fmt::format("shadow maps: {:.2f} % of the area differs, undercut {}",
                     percent * comparison.differing(),
                     size == "0.00 %" ? "as large" : size + (excess > 0.0 ? " too large" : " too small"));
}

}  // namespace moldlight
