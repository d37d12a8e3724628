#include "cli/serve_tools.hpp"

#include <memory>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "actions/actions_files.hpp"
#include "classify/classifier.hpp"
#include "classify/headless.hpp"
#include "classify/method_options.hpp"
#include "classify/still_picture.hpp"
#include "cli/console.hpp"
#include "cli/served_parts.hpp"
#include "cli/tool_arguments.hpp"
#include "io/png.hpp"
#include "page/page.hpp"
#include "parting/mold_picture.hpp"
#include "report/describe/describe.hpp"
#include "report/writers.hpp"
#include "sweep/direction_figures.hpp"

namespace moldlight::cli {

namespace {

constexpr const char* k_direction_help =
    "Parting direction +d, along which the core moves: an axis such as z or -y, three numbers of any "
    "length, or best for the one that recommend_direction finds.";
constexpr const char* k_compared_direction_help =
    "Parting direction +d of both parts: an axis such as z or -y, three numbers of any length, or best for "
    "the best of A. With each, every part has its own best.";

/// How a part is read and its regions are found.
Arguments reading_and_method() {
  return joined({from_table(reading_options(), &ToolQuestion::reading),
                 from_table(method_options(), &ToolQuestion::method)});
}
Arguments of_actions() { return from_table(action_options(), &ToolQuestion::actions); }
Argument part_path() { return path_argument("part", "a part file", &ToolQuestion::part); }
Arguments part_and_direction() { return {part_path(), direction_argument(k_direction_help, {"best"}, true)}; }

Json content_of(Json one) { return {{"content", Json::array({std::move(one)})}}; }

Json text_answer(const std::string& text, Json structured) {
  Json answer = content_of({{"type", "text"}, {"text", text}});
  answer["structuredContent"] = std::move(structured);
  return answer;
}

/// The part with its questions asked; the best direction is found where it is asked for.
ServedPart asked_part(const ToolQuestion& question, ServedParts& parts, const Progress& progress) {
  ServedPart part = parts.part(question.part, question.reading, progress);
  validate(question.method, part.study.model().frame.diagonal);
  Questions questions{.query = {question.direction, question.method},
                      .actions = question.actions,
                      .mold = question.mold,
                      .required_draft_deg = question.draft.required_deg,
                      .sweep = question.sweep};
  if (!question.direction_word.empty()) {
    if (!part.best || !(part.best->first == question.method))
      part.best = {question.method, best_direction(part.study.shared_model(), question.method, progress)};
    questions.best = part.best->second;
    questions.query.direction = questions.best->direction;
  }
  questions.with_actions = question.with_actions;
  part.study.ask(std::move(questions));
  return part;
}

using StudyJson = Json (*)(Study&, const Progress&);
using StudyText = report::Report (*)(const report::ReportContext&, Study&);

/// What a command says of the part; it is known from then on.
template <StudyJson k_json, StudyText k_text>
Json study_answer(const ToolQuestion& question, ServedParts& parts, const Progress& progress) {
  ServedPart part = asked_part(question, parts, progress);
  Study& study = part.study;
  if (k_text == report::classify_report && question.method.readout != Readout::exact) {
    const auto context = create_context(question.method.backend);
    study.keep(std::make_shared<const Classification>(
        Classifier(*context, study.shared_model()).classify(study.questions().query, progress)));
  }
  Json json = k_json(study, progress);
  const std::string text = to_text(k_text({study.shared_model(), progress}, study), {});
  // A sweep ends early with what it has by then.
  if (progress.cancelled()) throw Cancelled();
  parts.keep(std::move(part));
  return text_answer(text, std::move(json));
}

Json recommend(const ToolQuestion& given, ServedParts& parts, const Progress& progress) {
  ToolQuestion question = given;
  question.sweep.method = given.method;
  question.sweep.action_settings = given.actions;
  if (question.sweep.kinds.empty() && question.sweep.user_directions.empty())
    throw UsageError("candidates: none; give user_directions");
  if (!(given.actions == ActionSettings()) && !seeks_actions(question.sweep))
    throw UsageError("settings of side actions: give actions, too, or an objective of side actions");
  return study_answer<sweep_json, report::sweep_report>(question, parts, progress);
}

Json side_actions(const ToolQuestion& given, ServedParts& parts, const Progress& progress) {
  ToolQuestion question = given;
  question.with_actions = true;
  return study_answer<actions_json, report::actions_report>(question, parts, progress);
}

Json compare(const ToolQuestion& question, ServedParts& parts, const Progress& progress) {
  ServedPart old_part = parts.part(question.part, question.reading, progress);
  ServedPart new_part = parts.part(question.revision, question.reading, progress);
  validate(question.method, old_part.study.model().frame.diagonal);
  CompareQuestion asked{.choice = question.direction_word.empty()     ? CompareDirection::given
                                  : question.direction_word == "each" ? CompareDirection::each
                                                                      : CompareDirection::best,
                        .direction = question.direction,
                        .method = question.method,
                        .settings = question.compare};
  asked.settings.actions = question.actions;
  const Comparison comparison =
      compare_revisions(old_part.study.shared_model(), new_part.study.shared_model(), asked, progress);
  const std::string text =
      to_text(report::compare_report({comparison.b.model, progress}, comparison, {}), {});
  parts.keep(std::move(old_part));
  parts.keep(std::move(new_part));
  return text_answer(text, compare_json(comparison));
}

Image drawn(const ToolQuestion& question, Study& study, const gl::Context& context,
            const Progress& progress) {
  if (question.shown == Shown::mold) {
    const auto& [assignment, parting_line] = study.find<MoldLine>(progress);
    return mold_picture(context, {study.model(), assignment, parting_line, mold_halves(study, progress)},
                        question.still, progress);
  }
  const Classification& result = study.find<SplitRegions>(progress).result;
  const auto bodies = question.shown == Shown::side_actions ? pulled_bodies(actions_report(study, progress))
                                                            : std::vector<StillBody>();
  return StillPainter(context, study.shared_model()).draw(result, question.still, progress, bodies);
}

Json picture(const ToolQuestion& given, ServedParts& parts, const Progress& progress) {
  ToolQuestion question = given;
  question.with_actions = given.shown == Shown::side_actions;
  const auto context = create_context(question.method.backend);
  ServedPart part = asked_part(question, parts, progress);
  const std::string png = png_bytes(drawn(question, part.study, *context, progress));
  parts.keep(std::move(part));
  return content_of({{"type", "image"}, {"data", page::base64(png)}, {"mimeType", "image/png"}});
}

using ToolRun = Json (*)(const ToolQuestion&, ServedParts&, const Progress&);

/// What the command line would print and end with.
Json answer_of(ToolRun run, const ToolQuestion& question, ServedParts& parts, const Progress& progress) {
  try {
    return run(question, parts, progress);
  } catch (const Cancelled&) {
    throw;
  } catch (const std::exception& error) {
    Json answer = content_of({{"type", "text"}, {"text", one_line(failure_text(error))}});
    answer["isError"] = true;
    return answer;
  }
}

/// The rows of serve_tools().
struct ToolRow {
  const char *name, *title, *help;
  Arguments arguments;
  ToolRun run;
};

std::vector<ToolRow> tool_rows() {
  const auto look = [](ToolQuestion& question) -> LookSettings& { return question.still.look; };
  return {
      {"classify", "Regions and undercuts",
       "Find the surface that each mold half forms along a parting direction, and the undercuts. Areas are "
       "in "
       "the part's unit squared.",
       joined({part_and_direction(), from_table(draft_options().first(1), &ToolQuestion::draft),
               reading_and_method()}),
       study_answer<classify_json, report::classify_report>},
      {"recommend_direction", "Best parting directions",
       "Find the best parting directions of a part, and which side of the first is the core. This takes "
       "seconds to minutes.",
       joined({{part_path()},
               from_table(sweep_options(), &ToolQuestion::sweep),
               of_actions(),
               reading_and_method()}),
       recommend},
      {"side_actions", "Slides and lifters",
       "Find the slides, lifters and other side actions that release the undercuts of a parting direction.",
       joined({part_and_direction(), of_actions(), reading_and_method()}), side_actions},
      {"mold", "Parting line and mold halves",
       "Find the parting line and shut-offs of a direction, and whether the two mold halves can be made. No "
       "files are written.",
       joined({part_and_direction(),
               {side_actions_argument()},
               from_table(mold_options(), &ToolQuestion::mold),
               reading_and_method()}),
       study_answer<mold_json, report::mold_report>},
      {"compare", "Two revisions of a part",
       "Compare two revisions of a part: surface, regions, undercuts, side actions, and whether the mold of "
       "the old one survives.",
       joined({{path_argument("a", "the old revision", &ToolQuestion::part),
                path_argument("b", "the new revision", &ToolQuestion::revision),
                direction_argument(k_compared_direction_help, {"best", "each"}, false)},
               from_table(compare_options(), &ToolQuestion::compare),
               of_actions(),
               reading_and_method()}),
       compare},
      {"picture", "Picture of a part",
       "Draw a part for a parting direction: core blue, cavity green, both grey, undercut red.",
       joined({part_and_direction(), picture_arguments(), from_table(still_options(), &ToolQuestion::still),
               from_table(look_options(), look), of_actions(), reading_and_method()}),
       picture}};
}

}  // namespace

std::vector<serve::Tool> serve_tools(const std::string& folder) {
  const auto parts = std::make_shared<ServedParts>(folder);
  std::vector<serve::Tool> tools;
  for (const ToolRow& row : tool_rows())
    tools.push_back({row.name, row.title, row.help, schema_of(row.arguments),
                     [parts, run = row.run, arguments = row.arguments](const serve::Message& given) {
                       return
                           [parts, run, question = question_of(arguments, given)](const Progress& progress) {
                             return answer_of(run, question, *parts, progress);
                           };
                     }});
  return tools;
}

}  // namespace moldlight::cli
