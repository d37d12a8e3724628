// What is asked of a page or a paper beside its report: the title block and the paper's size, as options.
#pragma once

#include <span>

#include "classify/option.hpp"
#include "report/report.hpp"
#include "report/writers.hpp"

namespace moldlight::report {

[[nodiscard]] std::span<const Option<TitleFacts>> title_options();
/// With the day that the environment asks for (SOURCE_DATE_EPOCH, in seconds), if it does.
[[nodiscard]] TitleFacts usual_title();

struct PaperSettings {
  Paper paper = Paper::a4;
};
[[nodiscard]] std::span<const Option<PaperSettings>> paper_options();

}  // namespace moldlight::report
