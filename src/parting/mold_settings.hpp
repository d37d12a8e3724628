// Settings of the parting line and of the two halves, with the table of their options.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "classify/option.hpp"
#include "classify/part_model.hpp"

namespace moldlight {

struct Faces;

/// Lengths are in the part's unit; 0 stands for unset where a default follows from the part.
struct MoldSettings {
  double soft_deg = 2.0;                 // walls with less draft may go to either half, [0, 10]
  std::optional<double> parting_height;  // along d, of the part's coordinates; none: found
  std::string cosmetic;                  // "core:1,2/cavity:3": faces that each half must form
  double planar_worth_pct = 50.0;        // of the diagonal, that a planar line may cost more, [0, 1000]
  double margin = 0.0;                   // of the block around the part; unset: 15 % of the part's diagonal
  double shrink_pct = 0.0;               // of the molded part against the mold, [0, 20]
  double ramp_deg = 30.0;                // of the parting surface beside its shelf, [15, 80]
  double land = 0.0;                     // level outward from the line; unset: 2 % of the part's diagonal
  double slope_deg = 60.0;               // the parting surface is at most so steep, [15, 85]
  bool fill_undercut = false;
  bool registration = false;

  bool operator==(const MoldSettings&) const = default;
};

[[nodiscard]] std::span<const Option<MoldSettings>> mold_options();

/// "1,2", as --cosmetic has them; throws UsageError, as does the next for a face that the part has not.
[[nodiscard]] std::vector<std::uint32_t> parse_faces(std::string_view text);
void check_face(std::uint32_t face, const Faces& faces);

/// What `cosmetic` asks for: faces of the half that forms them.
struct CosmeticFaces {
  bool core = false;
  std::vector<std::uint32_t> faces;
};
/// None for an empty text; throws UsageError.
[[nodiscard]] std::vector<CosmeticFaces> parse_cosmetic(std::string_view text);
/// A half's faces, rising.
[[nodiscard]] std::vector<std::uint32_t> cosmetic_faces(std::string_view text, bool core);
/// The text with this face at that half alone, or at none.
[[nodiscard]] std::string cosmetic_with(std::string_view text, std::uint32_t face, std::optional<bool> core);

/// Throws UsageError for a margin of more than a hundred diagonals of the part, in its unit.
void validate(const MoldSettings& settings, double diagonal);

/// By how much a planar line may be dearer for a part of this diagonal, both in the same unit.
[[nodiscard]] inline double planar_worth(const MoldSettings& settings, double diagonal) {
  return 0.01 * settings.planar_worth_pct * diagonal;
}

/// Land beside the line of a part of this diagonal, both in the same unit.
[[nodiscard]] double land_width(const MoldSettings& settings, double diagonal);

/// Margin of a block around a part of this diagonal, both in the same unit.
[[nodiscard]] double block_margin(const MoldSettings& settings, double diagonal);

enum class FacetWish : std::uint8_t { none, core, cavity };

/// One a facet, from the settings' cosmetic faces. Throws UsageError for faces that the part has not.
[[nodiscard]] std::vector<FacetWish> assigned_facets(const PartModel& model, const MoldSettings& settings);

}  // namespace moldlight
