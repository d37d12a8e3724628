// moldlight sweep: the best parting directions of a part.
#include <algorithm>
#include <atomic>
#include <chrono>
#include <iterator>
#include <memory>
#include <optional>
#include <tuple>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "classify/headless.hpp"
#include "classify/json.hpp"
#include "classify/number_format.hpp"
#include "classify/option_json.hpp"
#include "classify/still_picture.hpp"
#include "cli/console.hpp"
#include "cli/flags.hpp"
#include "cli/report_flags.hpp"
#include "io/csv_tables.hpp"
#include "study/study.hpp"
#include "sweep/direction_figures.hpp"
#include "sweep/sweep_clock.hpp"
#include "sweep/sweep_pictures.hpp"

namespace moldlight::cli {

namespace {

/// How far a sweep is: share done, directions, rate, time left.
class SweepMeter {
 public:
  explicit SweepMeter(bool with_actions) : with_actions_(with_actions) {}

  /// Counts a scored direction; from any thread.
  void count() { ++scored_; }

  /// One line; with a bar where there are columns for it. One call at a time.
  [[nodiscard]] std::string text(std::string_view stage, double fraction, int columns) {
    const double share = done_ = std::max(done_, sweep_share_done(stage, fraction, with_actions_));
    const double elapsed_s = std::chrono::duration<double>(Clock::now() - start_).count();
    const std::size_t scored = scored_;
    std::string text = columns >= k_least_columns_for_bar ? bar(share) + " " : "";
    text += fmt::format("{:3.0f} %  {}", 100.0 * share, stage);
    if (scored > 0) text += fmt::format(", {} directions", scored);
    if (scored > 0 && (stage == sweep_stage::k_scoring || stage == sweep_stage::k_refining))
      text += fmt::format(", {:.0f}/s", static_cast<double>(scored) / elapsed_s);
    if (stage == sweep_stage::k_proving) {
      text += fmt::format(", {:.2f} % of the half-sphere open", 100.0 * (1.0 - fraction));
      return text;
    }
    // Before that it would be a guess about guesses.
    if (elapsed_s > 1.0 && share > 0.03)
      text += fmt::format(", about {} left", time_text(elapsed_s * (1.0 - share) / share));
    return text;
  }

 private:
  using Clock = std::chrono::steady_clock;

  bool with_actions_;
  std::atomic<std::size_t> scored_ = 0;
  Clock::time_point start_ = Clock::now();
  double done_ = 0.0;  // share, never less than before
};

/// The greatest undercut area that --fail-if-undercut lets pass.
struct UndercutLimit {
  double value = 0.0;  // at least 0; per cent of the part's area or model units squared
  bool per_cent = false;

  [[nodiscard]] double area(double total_area) const { return per_cent ? 0.01 * value * total_area : value; }
};

/// Of "12.5" or "2.5%"; throws UsageError.
UndercutLimit parse_undercut_limit(std::string_view text) {
  UndercutLimit limit;
  limit.per_cent = text.ends_with('%');
  if (limit.per_cent) text.remove_suffix(1);
  limit.value = parse_real({text, "--fail-if-undercut"});
  if (limit.value < 0.0) throw UsageError("--fail-if-undercut: the limit is negative");
  return limit;
}

struct SweepFlags {
  PartFlags part;
  SweepSettings sweep;
  std::string directions_file, csv, image_folder;
  StillSettings still;
  std::optional<UndercutLimit> limit;
  BaselineFlags baseline;
  bool wide = false, must_be_proved = false;
  std::vector<const CLI::Option*> of_actions;
  ReportFlags report;

  [[nodiscard]] bool drawn() const { return !image_folder.empty() || report.any(); }
};

SweepSettings sweep_settings(const SweepFlags& flags, const Progress& progress) {
  SweepSettings settings = flags.sweep;
  // A map of the directions wants the figures of all of them.
  settings.thorough = settings.thorough || flags.drawn();
  if (!flags.directions_file.empty()) {
    const std::vector<glm::dvec3> listed = read_directions(flags.directions_file, progress);
    settings.user_directions.insert(settings.user_directions.end(), listed.begin(), listed.end());
  }
  if (settings.kinds.empty() && settings.user_directions.empty())
    throw UsageError("--candidates none: give --direction or --directions-file");
  if (flags.must_be_proved && !settings.prove_pct && !settings.all_free_pct)
    throw UsageError("--fail-unless-proved: give --prove or --all-free, too");
  for (const CLI::Option* flag : flags.of_actions) {
    if (flag->count() > 0 && !seeks_actions(settings))
      throw UsageError(
          fmt::format("{}: give --actions, too, or an objective of side actions", flag->get_name()));
  }
  return settings;
}

void warn(const PartModel& model, const SweepResult& result, const Progress& progress, Console& console) {
  const auto& warnings =
      result.candidates.empty() ? model.warnings : result.candidates.front().classification.warnings;
  for (const std::string& warning : warnings) console.warning(warning);
  if (result.complete) return;
  if (progress.cancelled()) {
    console.warning("interrupted; the results so far follow");
  } else {
    console.warning(fmt::format("the time limit of {} s ended the sweep early; the results so far follow",
                                figure(result.settings.time_limit_s)));
  }
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

/// Says why not.
bool is_proved(const SweepResult& result, Console& console) {
  for (const auto& [asked, proof, flag] :
       {std::tuple(result.settings.prove_pct.has_value(), &result.proof, "--prove"),
        std::tuple(result.settings.all_free_pct.has_value(), &result.all_free, "--all-free")}) {
    if (!asked || (*proof && (*proof)->holds)) continue;
    console.warning(*proof ? fmt::format("{}: not proved; {:.3g} % of the directions are open", flag,
                                         100.0 * (1.0 - (*proof)->proved_share))
                           : fmt::format("{}: not proved; the sweep ended first", flag));
    return false;
  }
  return true;
}

int run(const SweepFlags& flags, Console& console, const Progress& progress) {
  std::vector<NamedPath> written = {{"--json", flags.part.json_file()}, {"--csv", flags.csv}};
  std::ranges::copy(flags.report.files(), std::back_inserter(written));
  written.push_back({"--junit", flags.baseline.gate.junit});
  check_outputs({.inputs = {{"PART", flags.part.part},
                            {"--directions-file", flags.directions_file},
                            {"--baseline", flags.baseline.file}},
                 .files = written,
                 .folder = {"--image-dir", flags.image_folder}});
  const SweepSettings settings = sweep_settings(flags, progress);
  Baseline baseline(flags.baseline, "sweep", flags.part.part);
  const auto model = load_part(flags.part.part, flags.part.reading, progress);
  // Before the sweep, so that a backend that is not there is reported at once.
  const auto context = flags.drawn() ? create_context(settings.method.backend) : nullptr;
  SweepMeter meter(seeks_actions(settings));
  console.set_progress_text([&meter](std::string_view stage, double fraction, int columns) {
    return meter.text(stage, fraction, columns);
  });
  Study study(model, {.sweep = settings,
                      .sweep_shows = {.evaluated = [&meter](const EvaluatedDirection&) { meter.count(); }}});
  const SweepResult& result = study.find<SweepResult>(progress);
  console.set_progress_text({});
  warn(*model, result, progress, console);
  if (!flags.csv.empty()) write_direction_csv(flags.csv, result);
  const auto json_report = [&] { return sweep_json(study, progress); };
  if (!progress.cancelled()) baseline.compare(json_report);
  baseline.put_report(console, flags.part.json, json_report, [&] {
    return to_text(report::sweep_report({model, progress}, study), {.wide = flags.wide});
  });
  if (!flags.image_folder.empty()) {
    console.progress("drawing pictures", 1.0);
    if (!write_sweep_pictures({*context, model, result}, flags.still, flags.image_folder, progress))
      console.warning(fmt::format("interrupted; {} was not drawn", k_contact_sheet));
  }
  if (flags.report.any() && !progress.cancelled()) {
    console.progress("writing the report", 1.0);
    const auto for_report = report_context(flags.report, *context, model, flags.still.look.palette, progress);
    write_reports(flags.report, report::sweep_report(for_report, study), console);
  }
  if (progress.cancelled()) return k_interrupted;
  if (flags.limit && !meets(*flags.limit, *model, result, console)) return k_criterion_failed;
  if (const int code = baseline.exit_code(console); code != 0) return code;
  if (flags.must_be_proved && !is_proved(result, console)) return k_not_proved;
  return 0;
}

Json settings(const SweepFlags& flags) {
  Json json = options_json(method_options(), flags.sweep.method);
  json.update(options_json(sweep_options(), flags.sweep));
  json.update(options_json(reading_options(), flags.part.reading));
  if (flags.limit) json["fail_if_undercut"] = {flags.limit->value, flags.limit->per_cent ? "%" : "area"};
  if (flags.must_be_proved) json["fail_unless_proved"] = true;
  return json;
}

void add_sweep_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand("sweep", "Find the best parting directions");
  const auto flags = std::make_shared<SweepFlags>();
  SweepSettings& sweep = flags->sweep;
  add_part_flags(*command, flags->part, request);
  add_option_flags(*command, sweep_options(), sweep);
  for (const Option<ActionSettings>& option : action_options())
    flags->of_actions.push_back(add_option_flag(*command, option, sweep.action_settings));
  add_file_flag(*command, flags->directions_file,
                {"--directions-file", "FILE.csv", "Extra directions from a file, one per line: x, y, z"});
  add_text_flag(
      *command,
      {"--fail-if-undercut", "AREA|PCT%",
       "Exit with 3 if the best direction's undercut exceeds this area, in the part's unit squared or per "
       "cent of its surface"},
      [flags = flags.get()](const std::string& text) { flags->limit = parse_undercut_limit(text); });
  command->add_flag(
      "--fail-unless-proved", flags->must_be_proved,
      "Exit with 4 unless the proof is complete, and all open directions lie within --apart of one listed");
  command->add_flag("--wide", flags->wide,
                    "Print all figures and the sources of each direction, in a wide table");
  add_file_flag(*command, flags->csv,
                {"--csv", "FILE.csv", "Write a table of all directions that were scored"});
  add_report_flags(*command, flags->report, request);
  add_live_flag(*command, flags->report);
  CLI::Option* pictures =
      add_file_flag(*command, flags->image_folder,
                    {"--image-dir", "DIR",
                     "Write direction_sphere.png, a map of the undercut over all directions, and "
                     "contact_sheet.png, the part with the best directions, to this folder"});
  add_size_flag(*command, flags->still.size,
                "Width and height of direction_sphere.png in pixels. contact_sheet.png has the same scale")
      ->needs(pictures);
  add_still_flags(*command, flags->still, pictures);
  add_baseline_flags(*command, flags->baseline, "sweep");
  add_option_flags(*command, method_options(), sweep.method);
  set_work(*command, request, flags, run, settings);
}

const RegisteredCommand k_sweep_command({50, "sweep", add_sweep_command, 2});

}  // namespace

}  // namespace moldlight::cli
