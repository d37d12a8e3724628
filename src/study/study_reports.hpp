// Reports of a study: JSON for programs, with the verdict.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "actions/actions_report.hpp"
#include "parting/mold_report.hpp"
#include "study/study.hpp"
#include "sweep/sweep_report.hpp"

namespace moldlight {

// What a report needs is found where it is not known. All throw Cancelled.

/// The answers that a report of side actions shows; they hold until the study is asked something else.
[[nodiscard]] ActionsReport actions_report(Study& study, const Progress& progress);
/// The halves, with slides where the side actions belong to the question.
[[nodiscard]] const MoldHalves& mold_halves(Study& study, const Progress& progress);
/// Keeps what was written of them.
void keep_written(Study& study, WrittenMold written, const Progress& progress);
/// The same of a mold; its side actions, where they belong to the question.
[[nodiscard]] MoldReport mold_report(Study& study, const Progress& progress);
/// The study's verdict, with why there are no halves where there are none.
[[nodiscard]] Verdict mold_verdict(Study& study, const Progress& progress);
/// Why the halves cannot be written, or cannot be used as they are; empty where they can.
[[nodiscard]] std::string mold_refusal(Study& study, const Progress& progress);
/// Of part and assignment.
[[nodiscard]] std::vector<std::string> mold_warnings(Study& study, const Progress& progress);

/// Schema `moldlight.classify/2`; with `draft` where a draft is required.
[[nodiscard]] nlohmann::ordered_json classify_json(Study& study, const Progress& progress);
/// Schema `moldlight.actions/1`.
[[nodiscard]] nlohmann::ordered_json actions_json(Study& study, const Progress& progress);
/// Schema `moldlight.mold/2`.
[[nodiscard]] nlohmann::ordered_json mold_json(Study& study, const Progress& progress);
/// Schema `moldlight.sweep/3`: each direction's verdict, and that of the first.
[[nodiscard]] nlohmann::ordered_json sweep_json_with_verdicts(const PartModel& model,
                                                              const SweepResult& result);

}  // namespace moldlight
