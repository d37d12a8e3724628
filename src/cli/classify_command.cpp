// moldlight classify: the mold-piece regions of a part for one parting direction.
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/classifier.hpp"
#include "classify/classify_report.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/option_json.hpp"
#include "classify/still_picture.hpp"
#include "cli/report_flags.hpp"
#include "cli/step_output.hpp"
#include "io/file_contents.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "parting/draft/draft_check.hpp"
#include "study/study.hpp"

namespace moldlight::cli {

namespace {

struct ClassifyFlags : StudyFlags {
  OutputPaths files;  // JSON is among the part's flags
  bool compare_maps = false;
  DraftSettings draft_settings;
  std::string finish;  // CSV
  FinishSettings finish_settings;
  std::string draft;  // CSV

  /// Exact regions need no GL, the maps do.
  [[nodiscard]] bool looks_at_maps() const { return query.method.readout != Readout::exact || compare_maps; }
};

void check_files(const ClassifyFlags& flags) {
  if (!flags.draft.empty() && flags.draft_settings.required_deg <= 0.0 && flags.finish.empty())
    throw UsageError("--draft needs --required-draft or --finish");
  const OutputPaths& files = flags.files;
  check_outputs(flags,
                {{"--facets", files.facets},
                 {"--faces", files.faces},
                 {"--draft", flags.draft},
                 {"--mesh", files.mesh},
                 {"--mesh (its colours)", material_library_path(files.mesh)},
                 {"--borders", files.borders}},
                {"--split-dir", files.split_folder});
}

void log_result(const Classification& result, Console& console) {
  if (!result.backend.empty()) console.log(fmt::format("{} ({})", result.backend, result.renderer));
  console.log(fmt::format("load {:.0f} ms, regions {:.0f} ms, readout {:.0f} ms", result.timings.load_ms,
                          result.timings.regions_ms, result.timings.readout_ms));
}

int run(const ClassifyFlags& flags, Console& console, const Progress& progress) {
  validate(flags.query.method);
  check_files(flags);
  Baseline baseline(flags.baseline, flags.command, flags.part.part);
  // Before long work, which would be for nothing where there is none.
  std::unique_ptr<gl::Context> context;
  if (flags.looks_at_maps() || flags.drawn()) context = create_context(flags.query.method.backend);
  Study study =
      asked_study(flags, {.required_draft_deg = flags.draft_settings.required_deg}, console, progress);
  const auto& model = study.shared_model();
  if (!flags.finish.empty()) {
    Questions questions = study.questions();
    questions.finishes = read_finishes(flags.finish, *model, flags.finish_settings.texture_rule, progress);
    study.ask(std::move(questions));
  }
  const bool asks_draft = study.questions().draft().any();
  const bool with_split =
      asks_draft || flags.drawn() || !flags.step.empty() || flags.files.need_split() || flags.compare_maps;
  if (flags.looks_at_maps()) {
    Classifier classifier(*context, model);
    Classification by_maps = classifier.classify(study.questions().query, progress, with_split);
    if (flags.compare_maps) classifier.compare_maps(by_maps, progress);
    study.keep(std::make_shared<const Classification>(std::move(by_maps)));
  }
  const Classification& result =
      with_split ? study.find<SplitRegions>(progress).result : study.find<Classification>(progress);
  for (const std::string& warning : result.warnings) console.warning(warning);
  log_result(result, console);
  const DraftCheck* draft = asks_draft ? &study.find<DraftCheck>(progress) : nullptr;

  progress.report("writing", 0.0);
  write_outputs(flags.files, *model, result, flags.still.look.palette);
  if (!flags.draft.empty()) write_draft_csv(flags.draft, *draft);
  Json step;
  if (!flags.step.empty()) {
    StepContent content{*result.split, region_groups(flags.still.look.palette), {}};
    for (const SplitPiece& piece : result.split->pieces)
      content.of_piece.push_back(static_cast<std::uint32_t>(piece.region));
    step = write_step(flags, study, std::move(content), console, progress);
  }
  if (!flags.image.empty()) {
    const Image picture = StillPainter(*context, model).draw(result, flags.still, progress);
    write_png(flags.image,
              draft != nullptr ? with_draft_histogram(picture, *model, *draft, flags.still) : picture);
  }
  return put_report(flags, study, {classify_json, report::classify_report, {}, std::move(step)},
                    context.get(), baseline, console, progress);
}

Json settings(const ClassifyFlags& flags) {
  Json json = study_settings(flags);
  json["compare_maps"] = flags.compare_maps;
  json.update(options_json(draft_options(), flags.draft_settings));
  if (!flags.finish.empty()) {
    // What it says counts, not where it is.
    json["finish"] = std::string(FileContents(flags.finish, Progress()).bytes());
    json.update(options_json(finish_options(), flags.finish_settings));
  }
  return json;
}

void add_classify_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "classify", "Find the surface that each mold half forms along a parting direction, and the undercuts");
  const auto flags = std::make_shared<ClassifyFlags>();
  add_study_flags(*command, *flags, request);
  add_option_flags(*command, method_options(), flags->query.method);
  OutputPaths& files = flags->files;
  add_file_flag(*command, files.facets,
                {"--facets", "FILE.csv", "Write a table of facets with the area and share of each region"});
  add_file_flag(*command, files.faces,
                {"--faces", "FILE.csv",
                 "Write the same table of faces: the CAD faces of a STEP file, else planes, round walls and "
                 "fillets that the facets form"});
  add_file_flag(
      *command, files.mesh,
      {"--mesh", "FILE.(" + extensions_text(mesh_formats()) + ")",
       "Write the part, split at the borders of its exact regions, each facet in the colour of its "
       "region. In OBJ and GLB, each region is a material. VTP has region, draft, height, face and body of "
       "each facet"});
  add_step_flag(
      *command, *flags,
      "Write the part of a STEP file as STEP: its exact faces, split at the borders of the regions, "
      "each with the name, colour and layer of its region");
  add_file_flag(*command, files.split_folder,
                {"--split-dir", "DIR",
                 "Write the split part to this folder, one STL per region. They share their vertices"});
  add_file_flag(
      *command, files.borders,
      {"--borders", "FILE.(" + extensions_text(border_formats()) + ")",
       "Write the borders between exact regions: OBJ with polylines, or CSV with one point per line"});
  command->add_flag(
      "--compare-maps", flags->compare_maps,
      "Measure the difference between the shadow maps and the exact regions, by --samples surface samples");
  add_option_flag(*command, draft_options().front(), flags->draft_settings);
  CLI::Option* finish =
      add_file_flag(*command, flags->finish,
                    {"--finish", "FILE.csv",
                     "Required draft by finish: a line \"FACE,FINISH\" for each face, by the number that "
                     "--faces writes, or by the colour of faces in a STEP file, as #FF0000. Finishes: "
                     "polished, shut-off, texture DEPTH, draft ANGLE, none"});
  add_option_flag(*command, finish_options().front(), flags->finish_settings)->needs(finish);
  add_file_flag(*command, flags->draft,
                {"--draft", "FILE.csv",
                 "Write a table of the walls with too little draft: the turn that each needs, and the "
                 "thickness that it costs"});
  CLI::Option* image = add_study_outputs(
      *command, *flags, request, "Write a picture of the part in the colours of its regions, with a legend");
  add_live_flag(*command, flags->report);
  add_still_flags(*command, flags->still, image);
  set_work(*command, request, flags, run, settings);
}

const RegisteredCommand k_classify_command({20, "classify", add_classify_command, 1});

}  // namespace

}  // namespace moldlight::cli
