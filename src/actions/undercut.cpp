#include "actions/undercut.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <unordered_map>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "mesh/union_find.hpp"
#include "mold/map_frame.hpp"
#include "mold/surface_samples.hpp"

namespace moldlight {

namespace {

using PieceIndex = std::uint32_t;

glm::dvec3 corner(const SplitMesh& split, PieceIndex piece, std::size_t k) {
  return split.vertices[split.pieces[piece].corners[k]];
}

double area_of(const SplitMesh& split, PieceIndex piece) {
  const glm::dvec3 a = corner(split, piece, 0);
  return 0.5 * glm::length(glm::cross(corner(split, piece, 1) - a, corner(split, piece, 2) - a));
}

/// Joins pieces whose corners are within `reach` (model units) of each other and face the same way. Cells of
/// the grid are as large as the reach, so that neighbours of a corner lie in the 27 cells around it.
void join_near(const PartModel& model, const SplitMesh& split, std::span<const PieceIndex> pieces,
               double reach, UnionFind& joined) {
  if (reach <= 0.0) return;
  struct Corner {
    glm::dvec3 at;
    std::uint32_t place;  // in `pieces`
  };
  std::map<std::array<std::int64_t, 3>, std::vector<Corner>> grid;
  const auto cell_of = [&](const glm::dvec3& at) {
    const glm::dvec3 cell = glm::floor((at - model.frame.center) / reach);
    return std::array<std::int64_t, 3>{static_cast<std::int64_t>(cell.x), static_cast<std::int64_t>(cell.y),
                                       static_cast<std::int64_t>(cell.z)};
  };
  for (std::uint32_t place = 0; place < pieces.size(); ++place) {
    const glm::dvec3& normal = model.geometry.normals[split.pieces[pieces[place]].facet];
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 at = corner(split, pieces[place], k);
      const auto [x, y, z] = cell_of(at);
      for (int around = 0; around < 27; ++around) {
        const auto found = grid.find({x + around % 3 - 1, y + around / 3 % 3 - 1, z + around / 9 - 1});
        if (found == grid.end()) continue;
        for (const Corner& other : found->second) {
          const glm::dvec3& facing = model.geometry.normals[split.pieces[pieces[other.place]].facet];
          if (glm::distance(other.at, at) <= reach && glm::dot(facing, normal) > 0.0)
            joined.join(place, other.place);
        }
      }
      std::vector<Corner>& here = grid[{x, y, z}];
      // One of a patch in a place is enough.
      const bool known = std::ranges::any_of(here, [&](const Corner& other) {
        return joined.find(other.place) == joined.find(place) && glm::distance(other.at, at) <= 0.1 * reach;
      });
      if (!known) here.push_back({at, place});
    }
  }
}

void measure(const SplitMesh& split, const glm::dvec3& direction, Undercut& patch) {
  glm::dvec3 sum(0.0);
  for (const PieceIndex piece : patch.pieces) {
    const double area = area_of(split, piece);
    patch.area += area;
    sum += area * (corner(split, piece, 0) + corner(split, piece, 1) + corner(split, piece, 2)) / 3.0;
  }
  const glm::dvec3 any = corner(split, patch.pieces.front(), 0);
  patch.centre = patch.area > 0.0 ? sum / patch.area : any;
  const MapFrame frame = map_frame(direction);
  const auto extent = [&](const glm::dvec3& along) {
    double least = std::numeric_limits<double>::infinity(), greatest = -least;
    for (const PieceIndex piece : patch.pieces) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double at = glm::dot(corner(split, piece, k) - patch.centre, along);
        least = std::min(least, at);
        greatest = std::max(greatest, at);
      }
    }
    return greatest - least;
  };
  patch.size_along = extent(direction);
  constexpr int k_turns = 36;
  for (int k = 0; k < k_turns; ++k) {
    const double angle = std::numbers::pi * k / k_turns;
    patch.size_across =
        std::max(patch.size_across, extent(std::cos(angle) * frame.x + std::sin(angle) * frame.y));
  }
}

/// Whether all of it is within `radius` of its centre.
bool fits(const SplitMesh& split, const Undercut& patch, double radius) {
  return std::ranges::all_of(patch.pieces, [&](PieceIndex piece) {
    bool within = true;
    for (std::size_t k = 0; k < 3; ++k)
      within = within && glm::distance(corner(split, piece, k), patch.centre) <= radius;
    return within;
  });
}

}  // namespace

Undercuts find_undercuts(const PartModel& model, const SplitMesh& split, const ExactQuery& query) {
  std::vector<PieceIndex> pieces;
  for (PieceIndex piece = 0; piece < split.pieces.size(); ++piece) {
    if (split.pieces[piece].region == Region::undercut) pieces.push_back(piece);
  }
  UnionFind joined(pieces.size());
  std::unordered_map<VertexIndex, std::uint32_t> at_vertex;
  for (std::uint32_t place = 0; place < pieces.size(); ++place) {
    for (const VertexIndex vertex : split.pieces[pieces[place]].corners)
      joined.join(place, at_vertex.try_emplace(vertex, place).first->second);
  }
  const double lateral = query.lateral * model.frame.diagonal;
  join_near(model, split, pieces, 2.0 * lateral, joined);

  std::map<std::uint32_t, Undercut> patches;
  for (std::uint32_t place = 0; place < pieces.size(); ++place)
    patches[static_cast<std::uint32_t>(joined.find(place))].pieces.push_back(pieces[place]);
  Undercuts found;
  for (auto& [root, patch] : patches) {
    measure(split, query.direction, patch);
    if (patch.area <= std::numbers::pi * lateral * lateral || fits(split, patch, lateral)) {
      ++found.dropped;
      found.dropped_area += patch.area;
    } else {
      found.patches.push_back(std::move(patch));
    }
  }
  std::ranges::stable_sort(found.patches, std::greater(), &Undercut::area);
  return found;
}

std::vector<UndercutSample> sample_undercut(const PartModel& model, const SplitMesh& split,
                                            const Undercut& undercut, std::size_t count) {
  std::vector<UndercutSample> samples;
  const double step = undercut.area / static_cast<double>(count);
  double sum = 0.0, next = 0.5 * step;
  for (const PieceIndex piece : undercut.pieces) {
    sum += area_of(split, piece);
    for (; next < sum && samples.size() < count; next += step) {
      const glm::dvec3 at =
          triangle_place(samples.size())
              .in(corner(split, piece, 0), corner(split, piece, 1), corner(split, piece, 2));
      samples.push_back({model.frame.to_unit(at), model.geometry.normals[split.pieces[piece].facet], step});
    }
  }
  // By the fractional parts of multiples of the golden ratio, which fill every interval evenly.
  std::vector<UndercutSample> spread;
  std::vector<std::size_t> order(samples.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  const auto place = [](std::size_t k) {
    return std::fmod(0.6180339887498949 * static_cast<double>(k), 1.0);
  };
  std::ranges::stable_sort(order, {}, place);
  std::vector<std::size_t> rank(order.size());
  for (std::size_t k = 0; k < order.size(); ++k) rank[order[k]] = k;
  for (const std::size_t k : rank) spread.push_back(samples[k]);
  return spread;
}

std::vector<UndercutSample> deepest_corners(const PartModel& model, const SplitMesh& split,
                                            const Undercut& undercut, const glm::dvec3& direction,
                                            std::size_t count) {
  struct Corner {
    double height;
    PieceIndex piece;
    std::size_t k;
  };
  std::vector<Corner> corners;
  for (const PieceIndex piece : undercut.pieces) {
    if (area_of(split, piece) <= 0.0) continue;
    for (std::size_t k = 0; k < 3; ++k)
      corners.push_back({glm::dot(corner(split, piece, k), direction), piece, k});
  }
  count = std::min(count, corners.size());
  std::ranges::stable_sort(corners, {}, &Corner::height);
  constexpr double k_inward = 1e-4;
  std::vector<UndercutSample> samples;
  for (std::size_t k = 0; k < count; ++k) {
    const auto& [height, piece, which] = corners[k];
    const glm::dvec3 middle =
        (corner(split, piece, 0) + corner(split, piece, 1) + corner(split, piece, 2)) / 3.0;
    const glm::dvec3 at = glm::mix(corner(split, piece, which), middle, k_inward);
    samples.push_back({model.frame.to_unit(at), model.geometry.normals[split.pieces[piece].facet], 0.0});
  }
  return samples;
}

}  // namespace moldlight
