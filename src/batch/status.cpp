#include "batch/status.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/error.hpp"
#include "batch/store.hpp"

namespace moldlight::batch {

namespace {

constexpr std::size_t k_reasons_in_text = 10;

std::string reason_of(const ResultStore& store, const Digest& key) {
  constexpr std::string_view k_damaged = "the record of its failure is damaged";
  try {
    const auto result = store.read(key, ResultState::failed);
    if (!result) return std::string(k_damaged);
    const auto reason = result->find("reason");
    return reason != result->end() && reason->is_string() ? reason->get<std::string>()
                                                          : std::string(k_damaged);
  } catch (const FileError&) {
    return std::string(k_damaged);
  }
}

}  // namespace

BatchStatus batch_status(const Manifest& manifest, const StatusOptions& options, const Progress& progress) {
  const ResultStore store(manifest.folder);
  const ResultIndex there = store.index(progress);
  const KeyMaker key_of(manifest);
  BatchStatus status;
  std::map<std::string, std::size_t> reasons;
  RowReader reader(manifest);
  for (Row row; reader.next(row);) {
    if (row.number % 4096 == 0) progress.report("reading the plan", 0.0);
    if (!options.shard.has(row.number)) continue;
    ++status.rows;
    if (row.same_as) ++status.shared;
    const Digest key = key_of(row);
    const auto found = there.find(key);
    if (found == there.end()) {
      ++status.missing;
      if (options.missing_rows) status.missing_rows.emplace_back(row.number, row.path);
    } else if (found->second == ResultState::done) {
      ++status.done;
    } else {
      ++status.failed;
      if (options.reasons) ++reasons[reason_of(store, key)];
    }
  }
  status.reasons.assign(reasons.begin(), reasons.end());
  std::ranges::stable_sort(status.reasons, std::ranges::greater(),
                           &std::pair<std::string, std::size_t>::second);
  return status;
}

std::string status_text(const Manifest& manifest, const BatchStatus& status) {
  std::string text =
      fmt::format("{}: {} of {} part{}, planned {} by moldlight {}\n", manifest.folder, manifest.command,
                  status.rows, status.rows == 1 ? "" : "s", manifest.planned_at, manifest.version);
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "done     {:>9}\nfailed   {:>9}\nmissing  {:>9}\n", status.done, status.failed,
                 status.missing);
  if (status.shared > 0)
    fmt::format_to(out, "{} of them hold the same as another with the same settings, and share its result\n",
                   status.shared);
  if (!status.reasons.empty()) fmt::format_to(out, "\nfailed because\n");
  for (std::size_t k = 0; k < std::min(status.reasons.size(), k_reasons_in_text); ++k)
    fmt::format_to(out, "{:>9}  {}\n", status.reasons[k].second, status.reasons[k].first);
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
          {"reasons", reasons}};
}

}  // namespace moldlight::batch
