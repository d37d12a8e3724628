// Flexible molds: how far a piece of silicone or latex has to give so that an undercut comes off.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "pieces/left_surface.hpp"

namespace moldlight {

/// Of an undercut that goes all the way round: the outline of a section across the pull that the piece is
/// cast around, or that it fills, and the one that it has to pass. Lengths are the part's.
struct Neck {
  double perimeter = 0.0;  // of the narrower one
  double widest = 0.0;     // of the wider one, as a band around it has it

  [[nodiscard]] double strain() const { return widest / perimeter - 1.0; }
};

/// An undercut that the directions leave, and the piece that gives least to release it.
struct StretchedUndercut {
  std::size_t place = 0;             // number of it among the places
  std::uint32_t direction = 0;       // number of it
  std::optional<double> depth = {};  // behind its lip, across the pull; none where nothing leads past it
  std::optional<Neck> neck = {};     // none of what does not go all the way round
};

/// Undercuts behind lips no deeper are the tessellation's, or make nobody stretch anything; in diagonals.
inline constexpr double k_shallow = 2e-3;

/// For each of the places, at most so many as `left_places` has, what the best of the directions asks for.
/// Depths are those of 64 samples; sections lie beside 96 of the heights of the part's vertices at most, all
/// of them where there are no more. Throws Cancelled.
[[nodiscard]] std::vector<StretchedUndercut> stretches(const PartModel& model,
                                                       std::span<const glm::dvec3> directions,
                                                       std::span<const LeftPolygon> left,
                                                       std::span<const LeftPlace> places,
                                                       const Progress& progress);

}  // namespace moldlight
