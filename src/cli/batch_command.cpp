// moldlight batch: one subcommand for many parts, on one machine or on many.
#include <algorithm>
#include <filesystem>
#include <memory>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "base/stopwatch.hpp"
#include "batch/csv.hpp"
#include "batch/merge.hpp"
#include "batch/part_result.hpp"
#include "batch/runner.hpp"
#include "cli/batch_baseline.hpp"
#include "cli/batch_work.hpp"
#include "cli/console.hpp"
#include "cli/flags.hpp"

namespace moldlight::cli {

namespace fs = std::filesystem;
using namespace batch;

namespace {

/// More failures than these are listed by `status`.
constexpr std::size_t k_failures_listed = 20;
constexpr std::chrono::seconds k_plain_interval(30);

struct PlanFlags {
  std::string source, out, anew;
  std::vector<std::string> work;
};

struct RunFlags {
  std::string folder, parts;
  RunSettings settings;
  Shard shard;
  bool fail_on_error = false;
};

struct StatusFlags {
  std::string folder, json;
  Shard shard;
  bool missing = false;
};

struct MergeFlags {
  std::string folder, baseline;
  MergeFiles files;
  Gate gate;
};

Shard parse_shard(const std::string& text) {
  const std::size_t slash = text.find('/');
  const std::string_view whole(text);
  const auto index = number_from<std::size_t>(whole.substr(0, std::min(slash, text.size())));
  const auto count =
      slash == std::string::npos ? std::nullopt : number_from<std::size_t>(whole.substr(slash + 1));
  if (!index || !count || *count == 0 || *index >= *count) {
    throw UsageError(
        fmt::format("--shard: '{}' is not I/N with I from 0 to N - 1, such as 0/8", one_line(text)));
  }
  return {*index, *count};
}

void set_parts_progress(Console& console, const char* what) {
  console.set_progress_text(
      [what](std::string_view stage, double fraction, int columns) {
        const std::string begin = columns >= k_least_columns_for_bar ? bar(fraction) + " " : "";
        return fmt::format("{}{:3.0f} %  {}: {}", begin, 100.0 * fraction, what, stage);
      },
      k_plain_interval);
}

// --- plan

int write(Manifest& manifest, const BatchWork& work, Console& console, const Progress& progress) {
  set_parts_progress(console, "plan");
  const PlanSource source = read_plan_source(manifest.source, progress);
  manifest.version = MOLDLIGHT_VERSION;
  const std::vector<Row> rows = plan_rows(
      manifest, source, [&](const std::vector<NamedValue>& row) { return work.settings(row); }, progress);
  std::error_code error;
  fs::create_directories(manifest.folder, error);
  if (error) throw FileError(manifest.folder, "", "cannot be made: " + error.message());
  write_plan(manifest, rows);
  console.set_progress_text({});
  const auto faulty = static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const Row& row) { return !row.fault.empty(); }));
  const auto shared = static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const Row& row) { return row.same_as && row.fault.empty(); }));
  if (source.left_out > 0) {
    console.warning(
        fmt::format("{} out of the folder and {} not planned; a list of parts may name such parts",
                    source.left_out == 1 ? "1 link leads" : fmt::format("{} links lead", source.left_out),
                    source.left_out == 1 ? "was" : "were"));
  }
  if (faulty > 0) {
    const Row& first = *std::ranges::find_if(rows, [](const Row& row) { return !row.fault.empty(); });
    console.warning(fmt::format("{} cannot be read and will be recorded as failed; the first is {}: {}",
                                plural(faulty, "part"), first.path, first.fault));
  }
  if (shared > 0) {
    console.warning(fmt::format("{} the same content and settings as another, and share{} its result",
                                shared == 1 ? "1 part holds" : fmt::format("{} parts hold", shared),
                                shared == 1 ? "s" : ""));
  }
  console.result(fmt::format("{}: {} planned; start with moldlight batch run {}\n", manifest.folder,
                             plural(rows.size(), "part"), shell_text({&manifest.folder, 1})));
  return 0;
}

int run_plan(const PlanFlags& flags, Console& console, const Progress& progress) {
  if (!flags.anew.empty()) {
    if (!flags.source.empty()) throw UsageError("--anew takes the source of the batch; give no other source");
    Manifest manifest = read_manifest(flags.anew);
    return write(manifest, BatchWork(manifest.command, manifest.given), console, progress);
  }
  if (flags.source.empty() || flags.out.empty() || flags.work.empty()) {
    throw UsageError(
        "batch plan needs SOURCE --out DIR -- WORK, such as moldlight batch plan parts --out night -- "
        "classify --direction z");
  }
  if (is_batch(flags.out)) {
    throw UsageError(
        fmt::format("--out: {0} is a batch already; plan it again with moldlight batch plan --anew {1}, "
                    "which keeps its results, or name another folder",
                    flags.out, shell_text({&flags.out, 1})));
  }
  std::error_code error;
  if (fs::exists(flags.out, error) &&
      (!fs::is_directory(flags.out, error) || !fs::is_empty(flags.out, error)))
    throw UsageError(fmt::format("--out: {} exists and is not an empty folder; name a new one", flags.out));
  Manifest manifest;
  manifest.folder = flags.out;
  manifest.command = flags.work.front();
  manifest.given.assign(flags.work.begin() + 1, flags.work.end());
  const BatchWork work(manifest.command, manifest.given);
  // A pattern is kept as it is, but begins at the root.
  manifest.source = fs::absolute(flags.source).lexically_normal().string();
  return write(manifest, work, console, progress);
}

// --- run

/// What a run says of itself while it goes on.
std::string progress_text(const RunCounts& counts, const Stopwatch& watch, int columns) {
  const std::size_t mine = counts.done + counts.failed, settled = counts.before + counts.elsewhere + mine;
  const std::size_t rows = counts.rows;
  const double share = rows > 0 ? static_cast<double>(settled) / static_cast<double>(rows) : 1.0;
  std::string text = columns >= k_least_columns_for_bar ? bar(share) + " " : "";
  text += fmt::format("{:3.0f} %  {} of {}", 100.0 * share, settled, plural(rows, "part"));
  if (counts.failed > 0) text += fmt::format(", {} failed", counts.failed.load());
  const double elapsed_s = watch.elapsed_ms() / 1000.0;
  if (mine > 0 && elapsed_s > 1.0) {
    const double rate = static_cast<double>(mine) / elapsed_s;
    text +=
        fmt::format(", {:.3g}/s, about {} left", rate, time_text(static_cast<double>(rows - settled) / rate));
  }
  return text;
}

void check_version(const Manifest& manifest) {
  if (manifest.version == MOLDLIGHT_VERSION) return;
  throw Error(fmt::format(
      "{}: was planned by moldlight {}, and this is {}: plan it again with moldlight batch plan --anew {}, "
      "which keeps the results, or run that version",
      manifest.folder, one_line(manifest.version), MOLDLIGHT_VERSION, shell_text({&manifest.folder, 1})));
}

int run_run(const RunFlags& flags, Console& console, const Progress& progress) {
  const Manifest manifest = read_manifest(flags.folder);
  static_cast<void>(work_row(manifest.command));
  check_version(manifest);
  if (flags.settings.live && manifest.command != "classify" && manifest.command != "sweep")
    throw UsageError(
        fmt::format("--live: reports of {} are not live; those of classify and sweep are", manifest.command));
  Run run(manifest, flags.settings, flags.shard, flags.parts.empty() ? manifest.parts_folder() : flags.parts);
  const RunCounts& counts = run.counts();
  const Stopwatch watch;
  console.set_progress_text(
      [&](std::string_view stage, double, int columns) {
        return counts.rows == 0 ? std::string(stage) : progress_text(counts, watch, columns);
      },
      k_plain_interval);
  const auto noting = [&console](const char* what, const char* further) {
    return [&console, what, further, noted = std::size_t{0}](const std::string& path,
                                                             const std::string& sentence) mutable {
      if (++noted <= k_failures_listed) console.warning(fmt::format("{}: {}{}", path, what, sentence));
      if (noted == k_failures_listed + 1) console.warning(further);
    };
  };
  const RunEnd end = run.carry_out(
      {.failed = noting("failed: ",
                        "further failures are not listed here; moldlight batch status lists the reasons"),
       .off_axis = noting("", "further parts whose best direction is not an axis are not listed here"),
       .warning = [&](const std::string& sentence) { console.warning(sentence); }},
      progress);
  console.set_progress_text({});
  const BatchStatus status = batch_status(manifest, {.shard = flags.shard}, Progress());
  console.result(fmt::format("this run: {} done, {} failed, {} skipped, {:.1f} s\n", counts.done.load(),
                             counts.failed.load(), counts.before + counts.elsewhere,
                             watch.elapsed_ms() / 1000.0) +
                 status_text(manifest, status));
  if (end.interrupted) {
    console.failure("interrupted; the same command continues");
    return k_interrupted;
  }
  if (!end.try_again.empty()) {
    console.failure(fmt::format("{}; {} left, try again", end.try_again, plural(end.undone, "part")));
    return k_try_again;
  }
  return flags.fail_on_error && status.failed > 0 ? k_criterion_failed : 0;
}

// --- status and merge

void print_refused(Console& console, const std::vector<std::string>& refused) {
  constexpr std::size_t k_most = 5;
  for (std::size_t k = 0; k < std::min(refused.size(), k_most); ++k)
    console.warning(refused[k] + "; it is set aside, and the next run makes a new result");
  if (refused.size() > k_most)
    console.warning(fmt::format("{} more files that are not results are set aside", refused.size() - k_most));
}

int run_status(const StatusFlags& flags, Console& console, const Progress& progress) {
  const Manifest manifest = read_manifest(flags.folder);
  const BatchStatus status = batch_status(
      manifest, {.shard = flags.shard, .reasons = !flags.missing, .missing_rows = flags.missing}, progress);
  if (flags.missing) {
    std::string text = csv_record({"row", "path"});
    for (const auto& [row, path] : status.missing_rows)
      text += csv_record({fmt::format("{}", row), spreadsheet_text(path)});
    console.result(text);
  } else {
    put_report(
        console, flags.json, [&] { return status_json(manifest, status); },
        [&] { return status_text(manifest, status); });
  }
  print_refused(console, status.refused);
  if (manifest.version != MOLDLIGHT_VERSION) {
    console.warning(fmt::format("it was planned by moldlight {}, and this is {}", one_line(manifest.version),
                                MOLDLIGHT_VERSION));
  }
  return status.missing > 0 ? k_try_again : 0;
}

int run_merge(const MergeFlags& flags, Console& console, const Progress& progress) {
  const MergeFiles& files = flags.files;
  if (files.csv.empty() && files.sqlite.empty() && files.html.empty() && flags.baseline.empty() &&
      flags.gate.criteria.empty())
    throw UsageError("batch merge needs an output: --csv, --sqlite, --html, --baseline or --fail-on");
  const Manifest manifest = read_manifest(flags.folder);
  const NamedPath manifest_file{"the batch's manifest",
                                (fs::path(manifest.folder) / k_manifest_name).string()};
  check_outputs({.inputs = {manifest_file, {"--baseline", flags.baseline}},
                 .files = {{"--csv", files.csv},
                           {"--sqlite", files.sqlite},
                           {"--html", files.html},
                           {"--junit", flags.gate.junit}}});
  set_parts_progress(console, "merge");
  std::optional<BatchBaseline> baseline;
  if (!flags.baseline.empty() || !flags.gate.criteria.empty()) baseline.emplace(flags.baseline, flags.gate);
  const ReadingCounts counts = merge(manifest, files, progress, baseline ? &*baseline : nullptr);
  console.set_progress_text({});
  console.result(fmt::format("{} merged: {} done, {} failed, {} missing\n", plural(manifest.rows, "part"),
                             counts.done, counts.failed, counts.missing) +
                 (baseline ? baseline->table() : ""));
  print_refused(console, counts.refused);
  if (counts.missing > 0)
    console.warning(fmt::format("{} no result yet", counts.missing == 1
                                                        ? "1 part has"
                                                        : fmt::format("{} parts have", counts.missing)));
  // What has failed stays so, whatever is still to come.
  if (baseline) write_junit(flags.gate, baseline->cases());
  if (baseline && baseline->failure_count() > 0) {
    for (const std::string& sentence : baseline->failures()) console.failure(sentence);
    if (baseline->failure_count() > baseline->failures().size())
      console.failure(fmt::format("criteria failed {} times in all", baseline->failure_count()));
    return k_criterion_failed;
  }
  return counts.missing > 0 ? k_try_again : 0;
}

// --- the command line

void add_folder(CLI::App& command, std::string& folder) {
  command.add_option("DIR", folder, "Folder of the batch")->required()->check(named());
}

void add_shard_flag(CLI::App& command, Shard& shard) {
  add_text_flag(
      command,
      {"--shard", "I/N", "One share of the parts: every N-th part from number I on, I from 0 to N - 1"},
      [&shard](const std::string& text) { shard = parse_shard(text); });
}

void add_loudness_flags(CLI::App& command, Request& request) {
  command.add_flag("-q,--quiet", request.quiet, "Print no warnings and no progress on stderr");
}

void add_plan(CLI::App& batch, Request& request) {
  CLI::App* command = batch.add_subcommand(
      "plan", "Plan the work: moldlight batch plan SOURCE --out DIR -- classify --direction z");
  const auto flags = std::make_shared<PlanFlags>();
  command->add_option("SOURCE", flags->source,
                      "Folder of parts, pattern in quotes, or CSV list with a column path and optional "
                      "columns of settings (unit, direction, …)");
  add_file_flag(*command, flags->out, {"-o,--out", "DIR", "New folder for the batch"});
  add_file_flag(*command, flags->anew,
                {"--anew", "DIR",
                 "Plan a batch again from its source and settings. Results of unchanged parts stay valid"});
  command->add_option("WORK", flags->work,
                      fmt::format("After --: {}, with its flags but without part and files", work_names()));
  add_loudness_flags(*command, request);
  set_work(*command, request, flags, run_plan);
}

void add_run(CLI::App& batch, Request& request) {
  CLI::App* command = batch.add_subcommand(
      "run",
      "Work on the parts without a result, one process each. It may be stopped and continued at any time");
  const auto flags = std::make_shared<RunFlags>();
  add_folder(*command, flags->folder);
  add_shard_flag(*command, flags->shard);
  add_option_flags(*command, run_options(), flags->settings);
  add_text_flag(*command, {"--processes", "N", "The same as --jobs"}, [flags](const std::string& text) {
    set_option(option_named(run_options(), "processes"), flags->settings, text);
  });
  add_file_flag(*command, flags->parts,
                {"--parts", "DIR", "Folder of the parts on this machine, if it differs from the plan"});
  command->add_flag("--fail-on-error", flags->fail_on_error,
                    fmt::format("Exit with {} if a part failed", k_criterion_failed));
  add_loudness_flags(*command, request);
  set_work(*command, request, flags, run_run);
}

void add_status(CLI::App& batch, Request& request) {
  CLI::App* command = batch.add_subcommand(
      "status",
      fmt::format("Report how many parts are done or failed, and why. Exit code {} while some are missing",
                  k_try_again));
  const auto flags = std::make_shared<StatusFlags>();
  add_folder(*command, flags->folder);
  add_shard_flag(*command, flags->shard);
  CLI::Option* missing =
      command->add_flag("--missing", flags->missing, "List the parts without a result, as CSV");
  add_file_flag(*command, flags->json, {"--json", "FILE|-", "Write the counts as JSON. - writes to stdout"})
      ->excludes(missing);
  add_loudness_flags(*command, request);
  set_work(*command, request, flags, run_status);
}

void add_merge(CLI::App& batch, Request& request) {
  CLI::App* command = batch.add_subcommand(
      "merge",
      fmt::format("Put all results into one file. Exit code {} while some are missing", k_try_again));
  const auto flags = std::make_shared<MergeFlags>();
  add_folder(*command, flags->folder);
  add_file_flag(*command, flags->files.csv, {"--csv", "FILE.csv", "A table, a line a part"});
  add_file_flag(*command, flags->files.sqlite,
                {"--sqlite", "FILE.db",
                 "An SQLite database with the views worst, changed (since the last plan that was merged into "
                 "it), more_than_two_actions and failed"});
  add_file_flag(*command, flags->files.html,
                {"--html", "FILE.html", "A page to sort and filter, with pictures"});
  add_file_flag(*command, flags->baseline,
                {"--baseline", "FILE.csv",
                 "Compare with an earlier table of --csv: new parts, missing parts and changed figures"});
  add_gate_flags(*command, flags->gate, batch_figure_names());
  add_loudness_flags(*command, request);
  set_work(*command, request, flags, run_merge);
}

void add_batch_command(CLI::App& program, Request& request) {
  CLI::App* command = program.add_subcommand("batch", "Work on many parts, on one machine or on many");
  command->require_subcommand(1);
  add_plan(*command, request);
  add_run(*command, request);
  add_status(*command, request);
  add_merge(*command, request);
}

const RegisteredCommand k_batch_command({80, "batch", add_batch_command});

}  // namespace

}  // namespace moldlight::cli
