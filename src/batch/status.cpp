#include "batch/status.hpp"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/numbers.hpp"
#include "base/shown_text.hpp"
#include "batch/part_result.hpp"

namespace moldlight::batch {

namespace {

constexpr std::size_t k_reasons_in_text = 10;

}  // namespace

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
    fmt::format_to(out, "{} of them hold the same as another with the same settings, and share its result\n",
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
