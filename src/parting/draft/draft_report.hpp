// Draft in reports: a sentence for people, JSON for programs, a table of walls.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "parting/draft/draft_check.hpp"

namespace moldlight {

/// The member `draft` of a classification's report. Areas and lengths are in the part's unit.
[[nodiscard]] nlohmann::ordered_json draft_json(const PartModel& model, const DraftCheck& check);

/// How much has too little draft in each half, and what leans back, in a sentence.
[[nodiscard]] std::string draft_sentence(const PartModel& model, const DraftCheck& check);

/// A wall's suggestion: "turn by 1.2° about its foot: 0.42 mm".
[[nodiscard]] std::string suggestion(const PartModel& model, const WallDraft& wall);

/// A line a wall, those that cost most thickness first. Throws FileError.
void write_draft_csv(const std::string& path, const DraftCheck& check);

}  // namespace moldlight
