// One part and what is asked of it. An answer is found when it is first asked for, and kept while what it
// depends on stays: whoever shows something of a part asks here, so that all show the same.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "actions/actions_report.hpp"
#include "actions/design_change.hpp"
#include "actions/side_action.hpp"
#include "classify/classification.hpp"
#include "classify/json.hpp"
#include "parting/draft/draft_check.hpp"
#include "parting/loops.hpp"
#include "parting/mold_files.hpp"
#include "parting/mold_halves.hpp"
#include "parting/mold_pieces.hpp"
#include "parting/mold_report.hpp"
#include "parting/planar_line.hpp"
#include "pieces/find_pieces.hpp"
#include "pieces/piece_solids.hpp"
#include "study/verdict.hpp"
#include "sweep/sweep.hpp"
#include "sweep/sweep_report.hpp"

namespace moldlight {

/// What is asked, and how it is answered.
struct Questions {
  Query query = {};
  std::optional<BestDirection> best = {};  // where its direction is the one that a sweep recommends
  bool with_actions = false;  // side actions belong to the question, so the verdict knows of them
  ActionSettings actions = {};
  MoldSettings mold = {};
  double required_draft_deg = 0.0;
  std::vector<FaceFinish> finishes = {};  // faces that ask for a draft of their own
  SweepSettings sweep = {};               // with the method of its own
  SweepListener sweep_shows = {};         // while it runs; the answer does not depend on it
  PiecesSettings pieces = {};             // with the query's method

  [[nodiscard]] DraftDemand draft() const { return {required_draft_deg, finishes}; }
};

// Answers that the domain has no type for.

/// Regions with their split mesh.
struct SplitRegions {
  Classification result;
};
/// What to change of each undercut of the plan so that it needs no side action.
struct Changes {
  std::vector<DesignChange> of_undercuts;
};
class Study;

/// What an answer depends on (`Inputs`, comparable), and how it is found. Declared here once for each.
template <typename Answer>
struct Asked;

template <>
struct Asked<Classification> {
  using Inputs = Query;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const Classification> find(Study& study, const Progress& progress);
};
template <>
struct Asked<SplitRegions> : Asked<Classification> {
  static std::shared_ptr<const SplitRegions> find(Study& study, const Progress& progress);
};
template <>
struct Asked<UndercutTotals> {
  using Inputs = std::pair<ExactQuery, double>;  // the least travel
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const UndercutTotals> find(Study& study, const Progress& progress);
};
template <>
struct Asked<ActionPlan> {
  using Inputs = std::pair<ExactQuery, ActionSettings>;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const ActionPlan> find(Study& study, const Progress& progress);
};
template <>
struct Asked<Changes> : Asked<ActionPlan> {
  static std::shared_ptr<const Changes> find(Study& study, const Progress& progress);
};
template <>
struct Asked<MoldLine> {
  using Inputs = std::pair<ExactQuery, MoldSettings>;  // without what concerns the halves alone
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const MoldLine> find(Study& study, const Progress& progress);
};
template <>
struct Asked<MoldHalves> {
  using Inputs = std::pair<ExactQuery, MoldSettings>;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const MoldHalves> find(Study& study, const Progress& progress);
};
template <>
struct Asked<MoldPieces> {
  using Inputs = std::pair<Asked<MoldHalves>::Inputs, Asked<ActionPlan>::Inputs>;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const MoldPieces> find(Study& study, const Progress& progress);
};
template <>
struct Asked<SweepResult> {
  using Inputs = SweepSettings;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const SweepResult> find(Study& study, const Progress& progress);
};
template <>
struct Asked<PiecesResult> {
  using Inputs = std::pair<ExactQuery, PiecesSettings>;  // along no direction of its own
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const PiecesResult> find(Study& study, const Progress& progress);
};
template <>
struct Asked<PieceSolids> {
  using Inputs = std::pair<Asked<PiecesResult>::Inputs, MoldSettings>;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const PieceSolids> find(Study& study, const Progress& progress);
};
template <>
struct Asked<DraftCheck> {
  using Inputs = std::pair<Asked<MoldLine>::Inputs, DraftDemand>;
  static Inputs inputs(const Study& study);
  static std::shared_ptr<const DraftCheck> find(Study& study, const Progress& progress);
};

/// A value: copies share the answers. One thread at a time; work in the background has a copy, whose answers
/// are taken over when it is done.
class Study {
 public:
  explicit Study(std::shared_ptr<const PartModel> model = nullptr, Questions questions = {})
      : model_(std::move(model)), questions_(std::move(questions)) {}

  [[nodiscard]] const PartModel& model() const { return *model_; }
  [[nodiscard]] const std::shared_ptr<const PartModel>& shared_model() const { return model_; }
  [[nodiscard]] const Questions& questions() const { return questions_; }
  /// Answers whose inputs stay are kept.
  void ask(Questions questions) { questions_ = std::move(questions); }

  /// Null where it is not known.
  template <typename Answer>
  [[nodiscard]] std::shared_ptr<const Answer> known() const {
    const Kept<Answer>& kept = std::get<Kept<Answer>>(kept_);
    return kept.answer && kept.inputs == Asked<Answer>::inputs(*this) ? kept.answer : nullptr;
  }
  /// Found where it is not known. The reference holds until another question is asked. Throws what finding it
  /// throws, Cancelled among it.
  template <typename Answer>
  const Answer& find(const Progress& progress) {
    if (!known<Answer>()) keep(Asked<Answer>::find(*this, progress));
    return *std::get<Kept<Answer>>(kept_).answer;
  }
  /// An answer to the present questions that was found elsewhere.
  template <typename Answer>
  void keep(std::shared_ptr<const Answer> answer) {
    std::get<Kept<Answer>>(kept_) = {Asked<Answer>::inputs(*this), std::move(answer)};
  }
  /// With the side actions, where they belong to the question.
  [[nodiscard]] Verdict verdict(const Progress& progress);

 private:
  template <typename Answer>
  struct Kept {
    typename Asked<Answer>::Inputs inputs = {};
    std::shared_ptr<const Answer> answer = {};
  };

  std::shared_ptr<const PartModel> model_;
  Questions questions_;
  std::tuple<Kept<Classification>, Kept<SplitRegions>, Kept<UndercutTotals>, Kept<ActionPlan>, Kept<Changes>,
             Kept<MoldLine>, Kept<MoldHalves>, Kept<MoldPieces>, Kept<SweepResult>, Kept<PiecesResult>,
             Kept<PieceSolids>, Kept<DraftCheck>>
      kept_;
};

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
[[nodiscard]] Json classify_json(Study& study, const Progress& progress);
/// Schema `moldlight.actions/2`.
[[nodiscard]] Json actions_json(Study& study, const Progress& progress);
/// Schema `moldlight.mold/2`.
[[nodiscard]] Json mold_json(Study& study, const Progress& progress);
/// Writes the solids and keeps where they are. Throws FileError.
void write_pieces(Study& study, const std::string& folder, const MoldFileSettings& settings,
                  const Progress& progress);

/// Schema `moldlight.pieces/1`; with the solids where they are known.
[[nodiscard]] Json pieces_json(Study& study, const Progress& progress);
/// Schema `moldlight.sweep/3`: each direction's verdict, and that of the first.
[[nodiscard]] Json sweep_json(Study& study, const Progress& progress);

}  // namespace moldlight
