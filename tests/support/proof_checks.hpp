// Whether what is called certain is so: by single rays, and by exact areas of single directions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "support/proof_model.hpp"

namespace moldlight::test {

struct RaysChecked {
  std::size_t certain = 0, wrong = 0;
};

/// Random elements in random cells: where one is certain, `directions` random ones of its cell are asked from
/// random points of it. Ends once so many were checked, or little was certain for long.
[[nodiscard]] RaysChecked check_certain(const ProofModel& model, std::span<const SurfaceElement> elements,
                                        std::size_t wanted, std::size_t directions, std::uint32_t seed);

/// The same of what blocked_along() says of cells of either half of the sphere, one direction each; elements
/// that face away from all of a cell are passed over.
[[nodiscard]] RaysChecked check_blocked_along(const ProofModel& model,
                                              std::span<const SurfaceElement> elements, std::size_t wanted,
                                              std::uint32_t seed);

}  // namespace moldlight::test
