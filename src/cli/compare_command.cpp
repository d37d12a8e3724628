// moldlight compare: what a revision of a part changes for the mold.
#include <algorithm>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/headless.hpp"
#include "classify/number_format.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "compare/compare_figures.hpp"
#include "compare/compare_picture.hpp"
#include "compare/comparison.hpp"
#include "io/png.hpp"

namespace moldlight::cli {

namespace {

struct CompareFlags {
  PartFlags a;
  std::string b;
  CompareQuestion question;
  Gate gate;
  std::string image;
  ReportFlags report;
  StillSettings still;
};

void check_files(const CompareFlags& flags) {
  std::vector<NamedPath> written = {{"--json", flags.a.json_file()}, {"--image", flags.image}};
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  written.push_back({"--junit", flags.gate.junit});
  check_outputs({.inputs = {{"A", flags.a.part}, {"B", flags.b}}, .files = written});
}

int run(const CompareFlags& flags, Console& console, const Progress& progress) {
  validate(flags.question.method);
  check_files(flags);
  // Before long work, which would be for nothing where there is none.
  std::unique_ptr<gl::Context> context;
  if (!flags.image.empty() || flags.report.any()) context = create_context(flags.question.method.backend);
  const auto a = load_part(flags.a.part, flags.a.reading, progress);
  const auto b = load_part(flags.b, flags.a.reading, progress);
  validate(flags.question.method, a->frame.diagonal);
  const Comparison comparison = compare_revisions(a, b, flags.question, progress);
  for (const auto& [name, part] : {std::pair("A", &comparison.a), std::pair("B", &comparison.b)})
    for (const std::string& warning : part->result.warnings)
      console.warning(fmt::format("{}: {}", name, warning));
  // Before anything is put out: a criterion may ask for what these parts do not have.
  const std::vector<ComparedFigure> figures = comparison_figures(comparison);
  const std::vector<GateCase> cases = gate_cases(part_name(b->part), flags.gate.criteria, figures);
  if (!flags.image.empty())
    write_png(flags.image, comparison_picture(*context, comparison, flags.still, progress));
  if (flags.report.any()) {
    const auto for_report =
        report_context(flags.report, *context, comparison.b.model, flags.still.look.palette, progress);
    write_reports(flags.report,
                  report::compare_report(for_report, comparison, {flags.gate.criteria, figures}), console);
  }
  put_report(
      console, flags.a.json, [&] { return compare_json(comparison); },
      [&] {
        const report::ReportContext for_text{comparison.b.model, progress};
        return to_text(report::compare_report(for_text, comparison, {flags.gate.criteria, figures}),
                       {.colour = console.colour()});
      });
  return gate_outcome(flags.gate, cases, console);
}

void add_compare_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "compare", "Compare two revisions of a part: surface, regions, undercuts and side actions");
  const auto flags = std::make_shared<CompareFlags>();
  command->add_option("A", flags->a.part, "Part file: the old revision")->required();
  command->add_option("B", flags->b, "Part file: the new revision")->required();
  add_reading_flags(*command, flags->a, request);
  add_text_flag(*command,
                {"-d,--direction", "X,Y,Z|AXIS|best|each",
                 "Parting direction +d of both parts: three numbers, an axis such as z or -y, or best for "
                 "the best of A. With each, every part has its own best. [default best]"},
                [flags = flags.get()](const std::string& text) {
                  flags->question.choice = text == "best"   ? CompareDirection::best
                                           : text == "each" ? CompareDirection::each
                                                            : CompareDirection::given;
                  if (flags->question.choice == CompareDirection::given)
                    flags->question.direction = parse_direction({text, "--direction"});
                });
  add_option_flags(*command, compare_options(), flags->question.settings);
  add_gate_flags(*command, flags->gate, comparison_figure_names());
  add_option_flags(*command, action_options(), flags->question.settings.actions);
  add_report_flags(*command, flags->report, request);
  CLI::Option* image =
      add_file_flag(*command, flags->image,
                    {"--image", "FILE.png",
                     "Write a picture of both parts side by side, with the differences highlighted"});
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  add_still_flags(*command, flags->still, image);
  add_option_flags(*command, method_options(), flags->question.method);
  set_work(*command, request, flags, run);
}

const RegisteredCommand k_compare_command({60, "compare", add_compare_command});

}  // namespace

}  // namespace moldlight::cli
