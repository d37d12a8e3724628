// Reports of what each command finds.
#pragma once

#include <memory>
#include <span>
#include <string>

#include "base/progress.hpp"
#include "classify/still_picture.hpp"
#include "compare/comparison.hpp"
#include "compare/criteria.hpp"
#include "report/report.hpp"
#include "study/study.hpp"

namespace moldlight::report {

/// What a report is made with.
struct ReportContext {
  std::shared_ptr<const PartModel> model;
  const Progress& progress;
  const gl::Context* gl = nullptr;  // current; none for a text, which has no pictures
  Palette palette = Palette::paper;
  bool live = false;  // the page is to find the regions of any direction, where the report has that
  std::size_t most_live_facets = k_most_live_facets;  // a page of more draws a coarser mesh
  std::string version = {}, command = {};             // to repeat it: the program's, and its command line
  TitleFacts title = {};

  /// For pages, with all sections.
  [[nodiscard]] bool drawn() const { return gl != nullptr; }
};

// Of the study's answers, which are found where they are not known. All throw Cancelled.

[[nodiscard]] Report classify_report(const ReportContext& context, Study& study);
[[nodiscard]] Report actions_report(const ReportContext& context, Study& study);
[[nodiscard]] Report mold_report(const ReportContext& context, Study& study);
[[nodiscard]] Report sweep_report(const ReportContext& context, Study& study);
/// With the solids where they are known.
[[nodiscard]] Report pieces_report(const ReportContext& context, Study& study);

/// What was asked of the figures of a comparison.
struct CriteriaShown {
  std::span<const Criterion> criteria;
  std::span<const ComparedFigure> figures;  // of all that the criteria name
};
/// `context.model` is that of the new part, B, as it is compared. Throws Cancelled.
[[nodiscard]] Report compare_report(const ReportContext& context, const Comparison& comparison,
                                    const CriteriaShown& asked);

}  // namespace moldlight::report
