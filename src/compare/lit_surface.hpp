// The surface of two compared parts that pictures light: what is gone, new, or of another region.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "compare/comparison.hpp"
#include "mold/region.hpp"

namespace moldlight {

enum class Lit : std::uint8_t { gone, fresh, other_region };
[[nodiscard]] Colour lit_colour(Lit what);
[[nodiscard]] std::string_view lit_name(Lit what);

/// A bit of a part's surface. It points into the comparison that it is of.
struct LitPolygon {
  const ConvexPolygon* polygon = nullptr;  // in A's unit
  PieceIndex piece = 0;                    // of the part's split mesh, on which it lies
  Lit what = Lit::gone;
  std::uint32_t number = 0;  // among the places of the change, or for another region its regions
};
/// Of A where `former`, else of B.
[[nodiscard]] std::vector<LitPolygon> lit_surface(const Comparison& comparison, bool former);

/// The part's split mesh in which the pieces with `lit` surface alone are undercut, as views are chosen by.
[[nodiscard]] std::shared_ptr<const SplitMesh> marked_split(const ComparedPart& part,
                                                            std::span<const LitPolygon> lit);

}  // namespace moldlight
