// moldlight sweep: the best parting directions of a part.
#include <memory>
#include <utility>

#include "base/error.hpp"
#include "cli/command.hpp"
#include "cli/method_flags.hpp"
#include "cli/outputs.hpp"
#include "cli/still_flags.hpp"
#include "cli/sweep_meter.hpp"
#include "cli/undercut_limit.hpp"
#include "io/atomic_file.hpp"
#include "io/direction_list.hpp"
#include "mold/sweep/ranking.hpp"
#include "session/classify_report.hpp"
#include "session/figures.hpp"
#include "session/headless.hpp"
#include "session/still_picture.hpp"
#include "session/sweep/sweep.hpp"
#include "session/sweep/sweep_pictures.hpp"
#include "session/sweep/sweep_report.hpp"

namespace moldlight::cli {

namespace {

constexpr int k_criterion_failed = 3;
constexpr int k_interrupted = 130;

struct SweepFlags {
  PartFlags part;
  SweepSettings sweep;
  std::string directions_file, csv, image_folder;
  StillSettings still;
  std::optional<UndercutLimit> limit;
};

void check_outputs(const SweepFlags& flags) {
  check_output_files(flags.part.part,
                     {{"--json", flags.part.json == "-" ? "" : flags.part.json}, {"--csv", flags.csv}});
  if (!flags.image_folder.empty()) check_output_folder(flags.image_folder);
}

SweepSettings sweep_settings(const SweepFlags& flags, const Progress& progress) {
  SweepSettings settings = flags.sweep;
  // A map of the directions wants the figures of all of them.
  settings.thorough = settings.thorough || !flags.image_folder.empty();
  if (!flags.directions_file.empty()) {
    const std::vector<glm::dvec3> listed = read_directions(flags.directions_file, progress);
    settings.user_directions.insert(settings.user_directions.end(), listed.begin(), listed.end());
  }
  if (settings.kinds.empty() && settings.user_directions.empty()) {
    throw UsageError("--candidates none: give --direction or --directions-file");
  }
  return settings;
}

void warn(const PartModel& model, const SweepResult& result, const Progress& progress, Console& console) {
  const auto& warnings =
      result.candidates.empty() ? model.warnings : result.candidates.front().classification.warnings;
  for (const std::string& warning : warnings) console.warning(warning);
  if (result.complete) return;
  if (progress.cancelled()) {
    console.warning("interrupted; what was done by then is put out");
  } else {
    console.warning(
        fmt::format("the time limit of {} s ended the sweep early; what was done by then is put out",
                    figure(result.settings.time_limit_s)));
  }
}

void write_outputs(const SweepFlags& flags, const PartModel& model, const SweepResult& result,
                   Console& console) {
  if (!flags.csv.empty()) write_direction_csv(flags.csv, result);
  const bool json_to_stdout = flags.part.json == "-";
  std::string json;
  if (!flags.part.json.empty()) json = json_text(sweep_json(model, result));
  if (!flags.part.json.empty() && !json_to_stdout) write_file(flags.part.json, json);
  console.result(json_to_stdout ? json : sweep_table(model, result));
}

/// Says why not. Nothing found meets no limit.
bool meets(const UndercutLimit& limit, const PartModel& model, const SweepResult& result, Console& console) {
  const double allowed = limit.area(model.geometry.total_area);
  if (result.candidates.empty()) {
    console.warning("criterion failed: no direction was measured");
    return false;
  }
  const Classification& best = result.candidates.front().classification;
  const double undercut = best.areas[Region::undercut];
  if (undercut <= allowed) return true;
  console.warning(fmt::format(
      "criterion failed: the best direction leaves an undercut of {} ± {} {}, more than {}", figure(undercut),
      figure(best.uncertainty.total()), powered_unit(model.part, 2), figure(allowed)));
  return false;
}

int run(const SweepFlags& flags, Console& console, const Progress& progress) {
  check_outputs(flags);
  const SweepSettings settings = sweep_settings(flags, progress);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  // Before the sweep, so that a backend that is not there is told at once.
  const auto context = flags.image_folder.empty() ? nullptr : create_context(settings.method.backend);
  SweepMeter meter;
  console.set_progress_text([&meter](std::string_view stage, double fraction, int columns) {
    return meter.text(stage, fraction, columns);
  });
  const SweepResult result = run_sweep(model, settings, progress,
                                       {.evaluated = [&meter](const EvaluatedDirection&) { meter.count(); }});
  console.set_progress_text({});
  warn(*model, result, progress, console);
  write_outputs(flags, *model, result, console);
  if (!flags.image_folder.empty()) {
    console.progress("drawing pictures", 1.0);
    if (!write_sweep_pictures(flags.image_folder, *context, model, result, flags.still, progress)) {
      console.warning(fmt::format("interrupted; {} was not drawn", k_contact_sheet));
    }
  }
  if (progress.cancelled()) return k_interrupted;
  if (flags.limit && !meets(*flags.limit, *model, result, console)) return k_criterion_failed;
  return 0;
}

}  // namespace

void add_sweep_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand(
      "sweep", "Look for the best parting directions: score many, refine the best, say why and how sure");
  const auto flags = std::make_shared<SweepFlags>();
  SweepSettings& sweep = flags->sweep;
  add_part_flags(*command, flags->part, request);
  add_option_flags(*command, sweep_options(), sweep);
  command
      ->add_option_function<std::string>(
          "--candidates", [&sweep](const std::string& text) { sweep.kinds = parse_candidate_kinds(text); },
          "Where candidate directions come from, separated by commas: axis, revolution, plane, "
          "perpendicular, hull, principal, uniform; all or none [default all]")
      ->option_text("LIST");
  command
      ->add_option_function<std::vector<std::string>>(
          "--direction",
          [&sweep](const std::vector<std::string>& texts) {
            for (const std::string& text : texts)
              sweep.user_directions.push_back(parse_direction(text, "--direction"));
          },
          "A direction to look at and list beside the others; may be given several times")
      ->option_text("X,Y,Z ...")
      ->expected(1)
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  command
      ->add_option("--directions-file", flags->directions_file,
                   "The same from a file, a line a direction: x, y, z")
      ->option_text("FILE.csv")
      ->check(named());
  command
      ->add_option_function<std::string>(
          "--objective",
          [&sweep](const std::string& text) {
            static_cast<void>(parse_objective(text));
            sweep.objective = text;
          },
          "What to rank by, smallest first: undercut, patches, draw-depth, projected-area, undraughted-area, "
          "or a weighted sum of shares of the part, as undercut:1,draw-depth:0.1 [default undercut]")
      ->option_text("LIST");
  command
      ->add_option_function<std::string>(
          "--fail-if-undercut",
          [flags = flags.get()](const std::string& text) { flags->limit = parse_undercut_limit(text); },
          "End with 3 if the best direction's undercut area is more than this, in the part's unit squared or "
          "per cent of its area")
      ->option_text("AREA|PCT%");
  command->add_option("--csv", flags->csv, "Write a table of every direction that was scored")
      ->option_text("FILE.csv")
      ->check(named());
  CLI::Option* pictures =
      command
          ->add_option("--image-dir", flags->image_folder,
                       "Write direction_sphere.png, a map of the undercut area over all directions, and "
                       "contact_sheet.png, the part with the best directions, to this folder; scores every "
                       "direction to the end")
          ->option_text("DIR")
          ->check(named());
  add_size_flag(*command, flags->still.size,
                "Width and height of direction_sphere.png in pixels; contact_sheet.png is scaled alike")
      ->needs(pictures);
  for (const Option<StillSettings>& option : still_options()) {
    add_option_flag(*command, option, flags->still)->needs(pictures);
  }
  add_method_flags(*command, sweep.method, DirectionFlag::left_out);
  command->callback([flags, &request] {
    request.body = [flags](Console& console, const Progress& progress) {
      return run(*flags, console, progress);
    };
  });
}

}  // namespace moldlight::cli
