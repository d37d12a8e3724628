// Molds of several pieces (Priyadarshi & Gupta 2004): the fewest directions that release a part, that fewer
// cannot, and which of them forms what.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "classify/part_model.hpp"
#include "classify/settings.hpp"
#include "pieces/cover_proof.hpp"
#include "pieces/formed_surface.hpp"
#include "pieces/left_surface.hpp"
#include "pieces/pieces_settings.hpp"
#include "pieces/stretch.hpp"

namespace moldlight {

/// Lengths, areas and volumes are in the part's unit.
struct PieceDirection {
  glm::dvec3 direction{0, 0, 1};  // unit; the piece moves along it
  std::string name;               // why it was tried: "z", "axis of round walls, 12 % of the surface"
  double area = 0.0;              // that it forms
  std::size_t components = 0;     // patches of it that do not touch
};

struct PiecesResult {
  PiecesSettings settings;
  ExactQuery query;                              // of which the direction does not count
  std::vector<PieceDirection> directions;        // in the order in which the pieces are removed
  bool enough = false;                           // all but eps of what any candidate releases is released
  bool releases_all = false;                     // all but eps of the surface
  bool optimal = false;                          // no fewer of the candidates do
  double left_area = 0.0;                        // exact
  double unreachable_area = 0.0;                 // of it, what no candidate releases; by samples
  std::vector<LeftPlace> places;                 // of what is left, the largest first
  std::vector<StretchedUndercut> stretches;      // of a flexible mold, but for shallow ones
  std::optional<std::vector<std::size_t>> cuts;  // of each piece of it, see locked_loops()
  std::size_t lower_bound = 0;    // fewer directions do not do, whatever they are; for the samples
  std::size_t proof_samples = 0;  // for which that holds
  CoverProof proof;
  FormedSurface formed;
  std::optional<double>
      enclosed_air;             // volume that no piece takes along and that stays; none of an open part
  double enclosed_error = 0.0;  // twice its standard deviation
  double elapsed_s = 0.0;

  [[nodiscard]] bool flexible() const { return settings.elongation_pct > 0.0; }
  [[nodiscard]] std::size_t count() const { return directions.size(); }
  [[nodiscard]] bool proved() const { return enough && lower_bound == count(); }
};

/// Of the method only tau and the lateral tolerance count. Stages: "candidates", "asking rays", "choosing
/// directions", "measuring undercuts", "proving", "assigning". Uses all cores of the calling thread's TBB
/// arena; the same to the bit for any number of threads, but for the time. Throws UsageError for settings
/// that make no sense and for a part without area, Cancelled.
[[nodiscard]] PiecesResult find_pieces(const PartModel& model, const MethodSettings& method,
                                       const PiecesSettings& settings, const Progress& progress);

}  // namespace moldlight
