#include "batch/part_result.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <tbb/parallel_for.h>

#include "base/error.hpp"
#include "base/numbers.hpp"
#include "base/shown_text.hpp"

namespace moldlight::batch {

namespace {

/// Where reports have a figure: the first of these places that a report has; of an array its size counts.
struct FigurePlaces {
  std::string_view name;
  std::array<std::string_view, 3> places;
};
constexpr std::array<FigurePlaces, k_figure_count> k_figures = {
    {{"area", {"/part/area"}},
     {"undercut_area", {"/areas/undercut", "/candidates/0/areas/undercut", "/verdict/undercut_area"}},
     {"projected_area", {"/projected_area", "/candidates/0/projected_area"}},
     {"undercuts", {"/candidates/0/patches", "/verdict/undercuts"}},
     {"side_actions", {"/actions"}},
     {"unreleased_area", {"/unreleased/area", "/left/area"}},
     {"pieces", {"/count"}},
     {"piece_bound", {"/lower_bound"}}}};
/// And the direction that a picture is drawn along.
constexpr std::array<std::string_view, 3> k_directions = {"/direction", "/candidates/0/direction",
                                                          "/directions/0/direction"};

constexpr std::array<std::string_view, 2> k_without_effect = {"jobs", "time_limit_s"};

/// Null where the report has nothing there.
const Json* find(const Json& report, std::string_view pointer) {
  const Json::json_pointer place{std::string(pointer)};
  return report.contains(place) ? &report.at(place) : nullptr;
}

constexpr std::size_t k_rows_at_a_time = 512;

template <typename T>
std::optional<T> member(const Json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::nullopt;
  if constexpr (std::is_same_v<T, bool>) {
    if (!found->is_boolean()) return std::nullopt;
  } else if constexpr (std::is_same_v<T, std::string>) {
    if (!found->is_string()) return std::nullopt;
  } else if (!found->is_number()) {
    return std::nullopt;
  }
  return found->get<T>();
}

void take_report(const Json& report, PartResult& result) {
  for (std::size_t k = 0; k < k_figure_count; ++k)
    result.figures[k] = figure_in(report, static_cast<Figure>(k));
  result.direction = direction_in(report);
  if (const auto verdict = report.find("verdict"); verdict != report.end() && verdict->is_object()) {
    result.verdict = member<std::string>(*verdict, "state").value_or("");
    result.sentence = member<std::string>(*verdict, "sentence").value_or("");
    const auto reasons = verdict->find("reasons");
    for (const Json& reason : reasons != verdict->end() && reasons->is_array() ? *reasons : Json::array()) {
      if (!reason.is_string()) continue;
      result.reasons += result.reasons.empty() ? "" : " ";
      result.reasons += reason.get<std::string>();
    }
  }
  const auto part = report.find("part");
  if (part == report.end() || !part->is_object()) return;
  result.unit = member<std::string>(*part, "unit").value_or("");
  result.facets = member<double>(*part, "facets");
  result.closed = member<bool>(*part, "closed");
}

/// Sets everything but what the row itself says. Returns why its file is no result, and then sets it aside.
std::string read_result(const ResultStore& store, PartResult& result) {
  if (result.state == ResultState::missing) return "";
  std::optional<Json> stored;
  try {
    stored = store.read(result.key, result.state);
  } catch (const FileError& error) {
    store.set_aside(result.key, result.state);
    result.state = ResultState::missing;
    return error.what();
  }
  if (!stored) {  // it went since the folder was read
    result.state = ResultState::missing;
    return "";
  }
  result.reason = member<std::string>(*stored, "reason").value_or("");
  result.elapsed_s = member<double>(*stored, "elapsed_s");
  result.tries = member<int>(*stored, "tries");
  const auto report = stored->find("report");
  if (report != stored->end() && report->is_object()) take_report(*report, result);
  return "";
}

constexpr std::size_t k_reasons_in_text = 10;

}  // namespace

std::string_view figure_name(Figure figure) { return k_figures[static_cast<std::size_t>(figure)].name; }

std::span<const std::string_view> settings_without_effect() { return k_without_effect; }

std::optional<double> figure_in(const Json& report, Figure figure) {
  for (const std::string_view place : k_figures[static_cast<std::size_t>(figure)].places) {
    const Json* value = place.empty() ? nullptr : find(report, place);
    if (value == nullptr) continue;
    if (value->is_number()) return value->get<double>();
    return value->is_array() ? std::optional(static_cast<double>(value->size())) : std::nullopt;
  }
  return std::nullopt;
}

std::optional<std::array<double, 3>> direction_in(const Json& report) {
  for (const std::string_view place : k_directions) {
    const Json* value = find(report, place);
    if (value == nullptr || !value->is_array() || value->size() != 3) continue;
    if (!std::ranges::all_of(*value, [](const Json& one) { return one.is_number(); })) continue;
    return value->get<std::array<double, 3>>();
  }
  return std::nullopt;
}

std::optional<double> PartResult::undercut_share() const {
  const auto whole = figure(Figure::area), undercut = figure(Figure::undercut_area);
  if (!whole || !undercut || !(*whole > 0.0)) return std::nullopt;
  return *undercut / *whole;
}

std::string_view state_name(ResultState state) {
  return state == ResultState::done ? "done" : state == ResultState::failed ? "failed" : "missing";
}

ReadingCounts for_each_result(const Manifest& manifest, const Progress& progress,
                              const std::function<void(const PartResult&)>& visit, const Shard& shard) {
  const ResultStore store(manifest.folder);
  const ResultIndex there = store.index(progress), pictures = store.those_with(Beside::picture, progress),
                    reports = store.those_with(Beside::report, progress);
  const KeyMaker key_of(manifest);
  std::vector<std::string> settings;
  for (const RowSettings& one : manifest.settings) settings.push_back(shell_text(one.arguments));
  ReadingCounts counts;
  RowReader reader(manifest);
  std::vector<PartResult> results;
  for (bool more = true; more;) {
    results.clear();
    Row row;
    while (results.size() < k_rows_at_a_time && (more = reader.next(row))) {
      if (!shard.has(row.number)) continue;
      PartResult result;
      result.row = row.number;
      result.path = row.path;
      result.settings = settings[row.settings];
      result.settings_number = row.settings;
      result.key = key_of(row);
      if (row.fault.empty()) result.content = hex_of(row.content);
      const auto found = there.find(result.key);
      if (found != there.end()) result.state = found->second;
      result.picture = pictures.contains(result.key);
      result.report = reports.contains(result.key);
      result.shared = row.same_as.has_value();
      results.push_back(std::move(result));
    }
    std::vector<std::string> refused(results.size());
    tbb::parallel_for(std::size_t{0}, results.size(),
                      [&](std::size_t k) { refused[k] = read_result(store, results[k]); });
    std::erase(refused, "");
    counts.refused.insert(counts.refused.end(), refused.begin(), refused.end());
    for (const PartResult& result : results) {
      ++(result.state == ResultState::done     ? counts.done
         : result.state == ResultState::failed ? counts.failed
                                               : counts.missing);
      visit(result);
    }
    if (manifest.rows > 0 && !results.empty()) {
      const double read = static_cast<double>(results.back().row + 1);
      progress.report("reading results", read / static_cast<double>(manifest.rows));
    }
  }
  return counts;
}

BatchStatus batch_status(const Manifest& manifest, const StatusOptions& options, const Progress& progress) {
  BatchStatus status;
  std::map<std::string, std::size_t> reasons;
  ReadingCounts counts = for_each_result(
      manifest, progress,
      [&](const PartResult& part) {
        ++status.rows;
        if (part.shared) ++status.shared;
        if (part.state == ResultState::missing && options.missing_rows)
          status.missing_rows.emplace_back(part.row, part.path);
        if (part.state == ResultState::failed && options.reasons) ++reasons[part.reason];
      },
      options.shard);
  status.done = counts.done;
  status.failed = counts.failed;
  status.missing = counts.missing;
  status.refused = std::move(counts.refused);
  status.reasons.assign(reasons.begin(), reasons.end());
  std::ranges::stable_sort(status.reasons, std::ranges::greater(),
                           &std::pair<std::string, std::size_t>::second);
  return status;
}

std::string status_text(const Manifest& manifest, const BatchStatus& status) {
  std::string text =
      fmt::format("{}: {} of {}, planned {} by moldlight {}\n", shown_text(manifest.folder), manifest.command,
                  plural(status.rows, "part"), shown_text(manifest.planned_at), shown_text(manifest.version));
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "done     {:>9}\nfailed   {:>9}\nmissing  {:>9}\n", status.done, status.failed,
                 status.missing);
  if (status.shared > 0)
    fmt::format_to(out, "{} of them have the same content and settings as another, and share its result\n",
                   status.shared);
  if (!status.reasons.empty()) fmt::format_to(out, "\nfailed because\n");
  for (std::size_t k = 0; k < std::min(status.reasons.size(), k_reasons_in_text); ++k)
    fmt::format_to(out, "{:>9}  {}\n", status.reasons[k].second, shown_text(status.reasons[k].first));
  if (status.reasons.size() > k_reasons_in_text)
    fmt::format_to(out, "{:>9}  other reasons\n", status.reasons.size() - k_reasons_in_text);
  return text;
}

Json status_json(const Manifest& manifest, const BatchStatus& status) {
  Json reasons = Json::array();
  for (const auto& [reason, count] : status.reasons)
    reasons.push_back({{"reason", reason}, {"parts", count}});
  return {{"schema", "moldlight.batch.status/1"},
          {"version", manifest.version},
          {"planned_at", manifest.planned_at},
          {"command", manifest.command},
          {"parts", status.rows},
          {"done", status.done},
          {"failed", status.failed},
          {"missing", status.missing},
          {"shared", status.shared},
          {"reasons", reasons},
          {"refused", status.refused}};
}

}  // namespace moldlight::batch
