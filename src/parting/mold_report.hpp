// The report on a mold: JSON for programs, and sentences for people.
#pragma once

#include <string>
#include <vector>

#include "classify/json.hpp"
#include "parting/loops.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_pieces.hpp"

namespace moldlight {

/// What a report is about.
struct MoldReport {
  const PartModel& model;
  const Query& query;
  const MoldSettings& settings;
  const Assignment& assignment;
  const PartingLine& line;
  const MoldHalves& halves;
  const WrittenMold& written;          // bodies that were not asked for have no file
  const ActionPlan* plan = nullptr;    // side actions, where they were asked for
  const MoldPieces* pieces = nullptr;  // then, too
};

/// "shut-off 3": the loop of a part's parting line that runs nearest to a place, numbered as the report lists
/// them; empty where there is none.
[[nodiscard]] std::string loop_near(const PartingLine& line, const glm::dvec3& place);

/// "no halves: …, near 1, 2, 3, at shut-off 3; …": why, where, at which loop, and what to change; empty where
/// there are halves.
[[nodiscard]] std::string refusal_text(const PartModel& model, const MoldHalves& halves,
                                       const WrittenMold& written, std::string_view loop = {});

/// "117 × 89 × 62 mm": the size of the mold's block.
[[nodiscard]] std::string block_text(const PartModel& model, const MoldHalves& halves);

/// Undercuts that the halves cannot form and that are not left to inserts, with their places; empty where
/// there are none.
[[nodiscard]] std::string unfilled_text(const PartModel& model, const MoldSettings& settings,
                                        const MoldHalves& halves);

/// Why halves that were made are not certified, a clause each; nothing where they are.
[[nodiscard]] std::vector<std::string> half_faults(const PartModel& model, const MoldHalves& halves);

/// Faces given by hand that the halves form otherwise: how much, where, why.
[[nodiscard]] std::vector<std::string> missed_lines(const PartModel& model, const MoldHalves& halves);

/// Schema `moldlight.mold/2`, without its verdict. Lengths and areas are in the part's unit, angles in
/// degrees.
[[nodiscard]] Json mold_json(const MoldReport& report);
/// What of it stands under "settings".
[[nodiscard]] Json mold_settings_json(const MoldReport& report);

/// A body's file and figures; and rows of 4 x 4 numbers, from the coordinates of the files to the part's.
[[nodiscard]] Json written_body_json(const WrittenBody& body);
[[nodiscard]] Json mold_transform_json(const MoldHalves& halves);

/// What a toolmaker wants to know of the halves beside their figures, with its place: a sentence each.
[[nodiscard]] std::vector<std::string> halves_remarks(const MoldReport& report);

/// How many facets of the halves are too thin for a milling machine's file, and where; empty where none is.
[[nodiscard]] std::string needles_text(const PartModel& model, const MoldHalves& halves);

/// What accounts for loops that are fewer or more than the part's handles ask for; empty where they are as
/// many.
[[nodiscard]] std::string difference_text(const EulerCheck& euler);

}  // namespace moldlight
