// moldlight classify: the mold-piece regions of a part for one parting direction.
#include <algorithm>
#include <iterator>
#include <memory>

#include <nlohmann/json.hpp>

#include "classify/classifier.hpp"
#include "classify/headless.hpp"
#include "classify/option_json.hpp"
#include "classify/still_picture.hpp"
#include "classify/write_outputs.hpp"
#include "cli/baseline.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/mesh_writer.hpp"
#include "io/png.hpp"
#include "parting/draft/draft_picture.hpp"
#include "parting/draft/draft_report.hpp"
#include "study/study_reports.hpp"

namespace moldlight::cli {

namespace {

struct ClassifyFlags {
  PartFlags part;
  Query query;
  bool best_direction = false;
  OutputPaths files;  // JSON is among the part's flags
  std::string image;
  bool compare_maps = false;
  DraftSettings draft_settings;
  std::string draft;  // CSV
  BaselineFlags baseline;
  ReportFlags report;
  StillSettings still;
};

void check_files(const ClassifyFlags& flags) {
  const OutputPaths& files = flags.files;
  if (!files.mesh.empty()) check_mesh_extension(files.mesh);
  if (!files.borders.empty()) check_border_extension(files.borders);
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()},
                                    {"--facets", files.facets},
                                    {"--faces", files.faces},
                                    {"--draft", flags.draft},
                                    {"--mesh", files.mesh},
                                    {"--mesh (its colours)", material_library_path(files.mesh)},
                                    {"--borders", files.borders},
                                    {"--image", flags.image}};
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  check_outputs({.inputs = {{"PART", flags.part.part}, {"--baseline", flags.baseline.file}},
                 .files = written,
                 .folder = {"--split-dir", files.split_folder}});
}

void log_result(const Classification& result, Console& console) {
  if (!result.backend.empty()) console.log(fmt::format("{} ({})", result.backend, result.renderer));
  console.log(fmt::format("load {:.0f} ms, regions {:.0f} ms, readout {:.0f} ms", result.timings.load_ms,
                          result.timings.regions_ms, result.timings.readout_ms));
}

int run(const ClassifyFlags& flags, Console& console, const Progress& progress) {
  Query query = flags.query;
  validate(query.method);
  check_files(flags);
  Baseline baseline(flags.baseline, "classify");
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  validate(query.method, model->frame.diagonal);
  std::optional<BestDirection> best;
  if (flags.best_direction) {
    best = found_direction(model, query.method, console, progress);
    query.direction = best->direction;
  }
  // Exact regions need no GL, the maps and pictures do.
  const bool looks_at_maps = query.method.readout != Readout::exact || flags.compare_maps;
  std::unique_ptr<gl::Context> context;
  const bool drawn = !flags.image.empty() || flags.report.any();
  if (looks_at_maps || drawn) context = create_context(query.method.backend);
  const double required_deg = flags.draft_settings.required_deg;
  const bool with_split = required_deg > 0.0 || drawn || flags.files.need_split() || flags.compare_maps;
  Study study(model, {.query = query, .best = best, .required_draft_deg = required_deg});
  if (looks_at_maps) {
    Classifier classifier(*context, model);
    Classification by_maps = classifier.classify(query, progress, with_split);
    if (flags.compare_maps) classifier.compare_maps(by_maps, progress);
    study.keep(std::make_shared<const Classification>(std::move(by_maps)));
  }
  const Classification& result =
      with_split ? study.find<SplitRegions>(progress).result : study.find<Classification>(progress);
  for (const std::string& warning : result.warnings) console.warning(warning);
  log_result(result, console);
  const DraftCheck* draft = required_deg > 0.0 ? &study.find<DraftCheck>(progress) : nullptr;

  progress.report("writing", 0.0);
  write_outputs(flags.files, *model, result, flags.still.look.palette);
  if (!flags.draft.empty()) write_draft_csv(flags.draft, *draft);
  if (!flags.image.empty()) {
    const Image picture = StillPainter(*context, model).draw(result, flags.still, progress);
    write_png(flags.image,
              draft != nullptr ? with_draft_histogram(picture, *model, *draft, flags.still) : picture);
  }
  const auto json_report = [&] { return classify_json(study, progress); };
  baseline.compare(json_report);
  if (flags.report.any()) {
    const auto for_report = report_context(flags.report, *context, model, flags.still.look.palette, progress);
    write_reports(flags.report, report::classify_report(for_report, study));
  }
  baseline.put_report(console, flags.part.json, json_report, [&] {
    return to_text(report::classify_report({model, progress}, study), {.colour = console.colour()});
  });
  return baseline.exit_code(console);
}

nlohmann::ordered_json settings(const ClassifyFlags& flags) {
  nlohmann::ordered_json json = query_json(flags.query, flags.best_direction);
  json.update(options_json(reading_options(), flags.part.reading));
  json["compare_maps"] = flags.compare_maps;
  json.update(options_json(draft_options(), flags.draft_settings));
  return json;
}

}  // namespace

void add_classify_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "classify",
      "Find out for a parting direction which surface each mold half forms and what is an undercut");
  const auto flags = std::make_shared<ClassifyFlags>();
  add_part_flags(*command, flags->part, request);
  add_direction_flag(*command, {flags->query.direction, flags->best_direction}, "required")->required();
  add_baseline_flags(*command, flags->baseline, "classify");
  add_method_flags(*command, flags->query.method);
  OutputPaths& files = flags->files;
  add_file_flag(*command, files.facets,
                {"--facets", "FILE.csv", "Write a table of facets: area and share of each region"});
  add_file_flag(*command, files.faces,
                {"--faces", "FILE.csv",
                 "Write a table of the CAD faces of a STEP file, or of a file's polygons, in the same way"});
  add_file_flag(*command, files.mesh,
                {"--mesh", "FILE.(" + extensions_text(mesh_formats()) + ")",
                 "Write the part, split at the borders of its exact regions (whatever the readout), each "
                 "facet in the colour of its region; in OBJ each region is a material"});
  add_file_flag(*command, files.split_folder,
                {"--split-dir", "DIR",
                 "Write the split part to this folder, one STL a region; they meet at equal vertices"});
  add_file_flag(
      *command, files.borders,
      {"--borders", "FILE.(" + extensions_text(border_formats()) + ")",
       "Write the lines between exact regions: in OBJ polylines, a group a pair of regions; in CSV a "
       "line a point"});
  command->add_flag("--compare-maps", flags->compare_maps,
                    "Measure where the regions that the shadow maps show differ from the exact ones, by "
                    "--samples surface samples");
  CLI::Option* required = add_option_flag(*command, draft_options().front(), flags->draft_settings);
  add_file_flag(*command, flags->draft,
                {"--draft", "FILE.csv",
                 "Write a table of the walls with too little draft: how far to turn each about which line of "
                 "its foot, and the thickness that it takes"})
      ->needs(required);
  add_report_flags(*command, flags->report, request);
  CLI::Option* image = add_file_flag(
      *command, flags->image,
      {"--image", "FILE.png",
       "Draw the part in the colours of its regions, with a legend, and write the picture to this file"});
  add_size_flag(*command, flags->still.size, "Width and height of the picture in pixels")->needs(image);
  add_still_flags(*command, flags->still, image);
  set_work(*command, request, flags, run, settings);
}

}  // namespace moldlight::cli
