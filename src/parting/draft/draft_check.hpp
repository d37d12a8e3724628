// The draft of what each half forms: how much of it there is, where it is less than asked for or leans the
// wrong way, and what turning a wall would cost.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "base/image.hpp"
#include "classify/json.hpp"
#include "classify/option.hpp"
#include "classify/part_model.hpp"
#include "classify/still_picture.hpp"
#include "mold/measure.hpp"
#include "parting/assignment.hpp"
#include "parting/draft/finish.hpp"

namespace moldlight {

struct DraftSettings {
  double required_deg = 0.0;  // up to k_most_required_deg; 0: draft is not looked at
};
[[nodiscard]] std::span<const Option<DraftSettings>> draft_options();

/// How much draft is asked for.
struct DraftDemand {
  double required_deg = 0.0;              // of faces without a finish, [0, 45]; 0: of none
  std::vector<FaceFinish> finishes = {};  // rising

  /// Whether draft is looked at.
  [[nodiscard]] bool any() const { return required_deg > 0.0 || !finishes.empty(); }
  bool operator==(const DraftDemand&) const = default;
};

/// Areas of what core and cavity form with a draft from `from_deg` up to `to_deg`, each seen from the half
/// that forms it: negative where the surface leans against it.
struct DraftBin {
  double from_deg = 0.0, to_deg = 0.0;
  std::array<double, 2> area{};  // of core, of cavity

  [[nodiscard]] bool within(double from, double to) const { return from_deg >= from && to_deg <= to; }
};

/// What one half forms of a face with too little draft, and the least that gives it enough: a turn about the
/// line of its foot, from which the wall recedes into the part along the half's way out.
struct WallDraft {
  std::uint32_t face = 0;  // of part_faces()
  MoldSide side = MoldSide::core;
  double required_deg = 0.0;
  std::string finish;      // empty where it has none
  double area = 0.0;       // with too little draft
  double least_deg = 0.0;  // negative where it leans back
  double height = 0.0;     // of that surface along the direction
  double foot = 0.0;       // height of the foot, in the part's coordinates along the direction
  std::optional<std::array<glm::dvec3, 2>> foot_line = {};  // its ends; none where the wall is bent
  double turn_deg = 0.0;                                    // for all but slivers of 1 % of the area
  double thickness = 0.0;  // that the turn takes at the end away from the foot
};

/// What the halves form of all faces of one finish.
struct FinishDraft {
  Finish finish;
  std::size_t faces = 0, faces_below = 0;
  double area = 0.0, below = 0.0;
  std::optional<double> least_deg = {};  // none where side actions form all of it
};

/// Areas and lengths are in the part's unit. Surface of side actions is not looked at: its draft is that
/// along their own directions.
struct DraftCheck {
  double required_deg = 0.0;                 // of faces without a finish; 0: it is not looked at
  std::array<double, 2> below{};             // area with less draft than required, by half
  std::array<std::size_t, 2> faces_below{};  // faces that have some of it
  ReverseDraft reverse;
  double reverse_undercut = 0.0;    // area of the same faces that leans back and is an undercut: neither half
                                    // reaches beyond what the lateral tolerance lets pass
  std::vector<DraftBin> histogram;  // all that the halves form, from -90 to 90 degrees
  std::vector<WallDraft> walls;     // those that cost most thickness first, slivers last
  std::vector<FinishDraft> finishes;  // the one that asks for most first
};

/// The greatest area of both halves in a bin between these; 0 for none.
[[nodiscard]] double tallest_bin(const DraftCheck& check, double from_deg, double to_deg);

/// `reverse` is the classification's of the assignment's direction.
[[nodiscard]] DraftCheck check_draft(const PartModel& model, const Assignment& assignment,
                                     const ReverseDraft& reverse, const DraftDemand& demand);

/// The member `draft` of a classification's report. Areas and lengths are in the part's unit.
[[nodiscard]] Json draft_json(const PartModel& model, const DraftCheck& check);

/// How much has too little draft in each half, and what leans back, in a sentence.
[[nodiscard]] std::string draft_sentence(const PartModel& model, const DraftCheck& check);

/// A wall's suggestion: "turn by 1.2° about its foot: 0.42 mm".
[[nodiscard]] std::string suggestion(const PartModel& model, const WallDraft& wall);

/// A line a wall, those that cost most thickness first. Throws FileError.
void write_draft_csv(const std::string& path, const DraftCheck& check);

/// Draws the card with the histogram, -5 to 10 degrees, into the lower right corner of a still picture; a
/// picture that is too small for it, or that has no legend, stays as it is.
[[nodiscard]] Image with_draft_histogram(const Image& picture, const PartModel& model,
                                         const DraftCheck& check, const StillSettings& settings);

}  // namespace moldlight
