// Settings of molds of several pieces, with the table of their options.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "classify/method_options.hpp"
#include "classify/option.hpp"
#include "parting/mold_settings.hpp"

namespace moldlight {

struct PiecesSettings {
  double eps = 0.005;                     // share of the surface that may be left over, [0, 0.2]
  int most = 6;                           // directions at most, [1, 12]
  std::vector<glm::dvec3> fixed = {};     // directions that the mold has anyway, any length but zero
  double elongation_pct = 0.0;            // of what the pieces are cast from; 0: they are rigid, [0, 2000]
  std::string cosmetic = {};              // "3,17/2:4": faces that no seam should cross; piece 2 forms face 4
  std::vector<glm::dvec3> proposed = {};  // further candidates, any length but zero
  bool operator==(const PiecesSettings&) const = default;
};

/// Without `proposed`, which comes from a file.
[[nodiscard]] std::span<const Option<PiecesSettings>> pieces_options();

/// Those of the method that count: tau and the lateral tolerance.
[[nodiscard]] std::span<const Option<MethodSettings>> pieces_method_options();

/// Those of the mold that count for the pieces as solids: block, ramps, shrinkage.
[[nodiscard]] std::span<const Option<MoldSettings>> pieces_solid_options();

/// What `cosmetic` asks for; throws UsageError.
struct CosmeticGroup {
  std::optional<std::uint32_t> piece;  // that forms them, from 0
  std::vector<std::uint32_t> faces;
};
[[nodiscard]] std::vector<CosmeticGroup> cosmetic_groups(std::string_view text);

/// Throws UsageError for more fixed directions than there may be at all.
void validate(const PiecesSettings& settings);

}  // namespace moldlight
