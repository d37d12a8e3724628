#include "batch/merge.hpp"

#include <vector>

#include <fmt/format.h>

#include "batch/csv.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::batch {

namespace {

std::string text_of(const std::optional<double>& value) { return value ? fmt::format("{}", *value) : ""; }

class CsvSink : public MergeSink {
 public:
  explicit CsvSink(const std::string& path) : file_(path) {
    std::vector<std::string> names = {"row",         "path",        "settings",   "state",   "reason",
                                      "unit",        "facets",      "closed",     "verdict", "sentence",
                                      "direction_x", "direction_y", "direction_z"};
    for (std::size_t k = 0; k < k_figure_count; ++k) names.emplace_back(figure_name(static_cast<Figure>(k)));
    for (const char* name : {"undercut_share", "elapsed_s", "tries", "content", "key"})
      names.emplace_back(name);
    file_.write(csv_record(names));
  }

  void add(const PartResult& result) override {
    std::vector<std::string> fields = {fmt::format("{}", result.row),
                                       spreadsheet_text(result.path),
                                       spreadsheet_text(result.settings),
                                       std::string(state_name(result.state)),
                                       spreadsheet_text(result.reason),
                                       spreadsheet_text(result.unit),
                                       text_of(result.facets),
                                       !result.closed   ? ""
                                       : *result.closed ? "yes"
                                                        : "no",
                                       result.verdict,
                                       result.sentence};
    for (std::size_t k = 0; k < 3; ++k)
      fields.push_back(result.direction ? fmt::format("{}", (*result.direction)[k]) : "");
    for (const auto& figure : result.figures) fields.push_back(text_of(figure));
    fields.push_back(text_of(result.undercut_share()));
    fields.push_back(text_of(result.elapsed_s));
    fields.push_back(result.tries ? fmt::format("{}", *result.tries) : "");
    fields.push_back(result.content);
    fields.push_back(hex_of(result.key));
    file_.write(csv_record(fields));
  }

  void finish() override { file_.commit(); }

 private:
  AtomicFile file_;
};

}  // namespace

std::unique_ptr<MergeSink> csv_sink(const std::string& path) { return std::make_unique<CsvSink>(path); }

ReadingCounts merge(const Manifest& manifest, const MergeFiles& files, const Progress& progress,
                    MergeSink* first) {
  std::vector<std::unique_ptr<MergeSink>> sinks;
  if (!files.csv.empty()) sinks.push_back(csv_sink(files.csv));
  if (!files.sqlite.empty()) sinks.push_back(sqlite_sink(files.sqlite, manifest));
  if (!files.html.empty()) sinks.push_back(html_sink(files.html, manifest));
  const ReadingCounts counts = for_each_result(manifest, progress, [&](const PartResult& result) {
    if (first != nullptr) first->add(result);
    for (const auto& sink : sinks) sink->add(result);
  });
  if (first != nullptr) first->finish();
  for (const auto& sink : sinks) {
    progress.report("writing", 1.0);
    sink->finish();
  }
  return counts;
}

}  // namespace moldlight::batch
