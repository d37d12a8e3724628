// A picture of two revisions side by side, seen from one side, with what differs lit.
#pragma once

#include <cstdint>
#include <vector>

#include "base/image.hpp"
#include "classify/still_picture.hpp"
#include "compare/comparison.hpp"
#include "mold/region.hpp"

namespace moldlight {

enum class Lit : std::uint8_t { gone, added, other_region };
[[nodiscard]] Colour lit_colour(Lit what);

/// A bit of a part's surface. It points into the comparison that it is of.
struct LitPolygon {
  const ConvexPolygon* polygon = nullptr;  // in A's unit
  PieceIndex piece = 0;                    // of the part's split mesh, on which it lies
  Lit what = Lit::gone;
  std::uint32_t number = 0;  // among the places of the change, or for another region its regions
};
/// Of A where `of_a`, else of B.
[[nodiscard]] std::vector<LitPolygon> lit_surface(const Comparison& comparison, bool of_a);

/// The part's split mesh in which the pieces with `lit` surface alone are undercut, as views are chosen by.
[[nodiscard]] std::shared_ptr<const SplitMesh> marked_split(const ComparedPart& part,
                                                            std::span<const LitPolygon> lit);

enum class Revision : std::uint8_t { a, b };

/// What is lit on one of the parts, a thin plate on each bit of surface: what is gone of A or new on
/// the new part, and what is of another region; named so by their labels. None where nothing differs.
[[nodiscard]] std::vector<StillBody> lit_bodies(const Comparison& comparison, Revision revision);
/// Orientation of a camera from where most of what is lit is seen.
[[nodiscard]] glm::dquat lit_seen_from(const Comparison& comparison);

/// A on the left with what is gone, B on the right with what is new, both with surface that is of another
/// region; from where most of that is seen unless the settings say otherwise. Throws as StillPainter does.
[[nodiscard]] Image comparison_picture(const gl::Context& context, const Comparison& comparison,
                                       StillSettings settings, const Progress& progress);

}  // namespace moldlight
