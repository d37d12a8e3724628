// Which direction forms what of the surface: by expansion moves over labels (Boykov, Veksler & Zabih 2001),
// each a minimum cut, so that the seams between the mold's pieces are short and run along creases.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include <glm/vec3.hpp>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "mold/exact/exact_regions.hpp"
#include "mold/exact/split_mesh.hpp"

namespace moldlight {

/// What one direction forms that hangs together. Lengths are the part's.
struct FormedPatch {
  std::uint32_t direction = 0;  // number of it
  double area = 0.0;
  glm::dvec3 centre{0.0};  // of the area
};

/// Where two directions meet.
struct PieceSeam {
  std::uint32_t a = 0, b = 0;      // numbers of the directions, a < b
  std::vector<glm::dvec3> points;  // the first is the last of a closed one, too
  bool closed = false;
  double length = 0.0;
  double crease_share = 0.0;  // of the length, along edges that bend by more than 30 degrees; [0, 1]
};

struct FormedSurface {
  SplitMesh mesh;  // of the regions of all directions together; its own regions say nothing
  std::vector<std::uint32_t> formed_by;  // number of the direction of each piece; their count: left over
  std::vector<FormedPatch> patches;      // by direction, the largest first
  std::vector<PieceSeam> seams;          // by directions, the longest first
};

/// What is wished of single facets; of each an entry, or none at all.
struct SurfaceWishes {
  static constexpr std::uint32_t k_none = ~0U;
  std::vector<std::uint32_t> formed_by;     // number of the direction that is to form it
  std::vector<std::uint32_t> stretched_by;  // likewise, though no direction releases it
  std::vector<std::uint32_t> cosmetic;      // number of the face, which no seam should cross

  [[nodiscard]] static std::uint32_t of(const std::vector<std::uint32_t>& wishes, FacetIndex facet) {
    return wishes.empty() ? k_none : wishes[facet];
  }
};

/// The first two of the directions that are opposite to each other, the earlier one first.
[[nodiscard]] std::optional<std::pair<std::size_t, std::size_t>> opposite_pair(
    std::span<const glm::dvec3> directions);

/// Directions are unit; at most 31 of them. Of the query the direction does not count. Surface that several
/// release goes where the seams cost least: half their length along creases, up to twice as much where they
/// climb along the difference of both directions, and more across cosmetic faces; walls that lean against a
/// direction by less than tau cost extra, as does what a direction forms beside an opposite pair, and
/// slightly the later one of directions. Throws UsageError where a direction does not release what it is to
/// form, Cancelled.
[[nodiscard]] FormedSurface form_surface(const PartModel& model, const ExactQuery& query,
                                         std::span<const glm::dvec3> directions, const Progress& progress,
                                         const SurfaceWishes& wishes = {});

}  // namespace moldlight
