#include "batch/merge.hpp"

#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.hpp"
#include "batch/csv.hpp"
#include "io/atomic_file.hpp"
#include "page/page.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

std::string csv_text(const Json& value) {
  if (value.is_string()) return spreadsheet_text(value.get<std::string>());
  if (value.is_boolean()) return value.get<bool>() ? "yes" : "no";
  if (value.is_number_float()) return fmt::format("{}", value.get<double>());
  return value.is_null() ? "" : value.dump();
}

/// A line a row.
class CsvSink : public MergeSink {
 public:
  explicit CsvSink(const std::string& path) : file_(path) {
    std::vector<std::string> names;
    for (const ResultColumn& column : result_columns()) names.push_back(column.name);
    file_.write(csv_record(names));
  }
  void add(const PartResult& result) override {
    std::vector<std::string> fields;
    for (const ResultColumn& column : result_columns()) fields.push_back(csv_text(column.of(result)));
    file_.write(csv_record(fields));
  }
  void finish() override { file_.commit(); }

 private:
  AtomicFile file_;
};

/// A page for a browser, without a server: the rows are data in it, and its script shows, sorts and filters
/// them.
const page::PageFrame& frame() {
  static const page::PageFrame k_frame = {"moldlight batch", "batch.css", {"batch.js"}, true};
  return k_frame;
}

constexpr std::string_view k_content = R"(<h1>moldlight batch</h1><p id="about"></p>
<input id="filter" type="search" placeholder="part, settings or reason" aria-label="Filter">
<select id="state" aria-label="State"><option value="">all</option><option>done</option><option>failed</option>
<option>missing</option></select> <span id="count"></span>
<table><thead><tr id="head"></tr></thead><tbody id="body"></tbody></table>
<p><button id="more">Show more</button></p>
<script type="application/json" id="batch">)";

/// A page that sorts and filters, with the pictures where they lie.
class HtmlSink : public MergeSink {
 public:
  HtmlSink(const std::string& path, const Manifest& manifest) : file_(path) {
    const fs::path page_folder = fs::absolute(path).lexically_normal().parent_path();
    const fs::path results = fs::absolute(fs::path(manifest.folder) / "results").lexically_normal();
    const fs::path relative = results.lexically_relative(page_folder);
    file_.write(page::page_begin(frame()));
    file_.write(k_content);
    file_.write(fmt::format(
        "{{\"results\": {},\n\"about\": {},\n\"rows\": [",
        page::script_json(page::url_of(relative.string()) + "/"),
        page::script_json(fmt::format("{} of {} parts of {}, planned {} by moldlight {}", manifest.command,
                                      manifest.rows, shown_text(manifest.source),
                                      shown_text(manifest.planned_at), shown_text(manifest.version)))));
  }

  void add(const PartResult& result) override {
    const std::string name = hex_of(result.key), beside = name.substr(0, 2) + "/" + name;
    file_.write(separator_ + page::script_json({result.row,
                                                shown_text(result.path),
                                                state_name(result.state),
                                                shown_text(result.reason),
                                                shown_text(result.unit),
                                                or_null(result.facets),
                                                or_null(result.figure(Figure::area)),
                                                or_null(result.figure(Figure::undercut_area)),
                                                or_null(result.undercut_share()),
                                                or_null(result.figure(Figure::undercuts)),
                                                or_null(result.figure(Figure::side_actions)),
                                                or_null(result.figure(Figure::unreleased_area)),
                                                or_null(result.elapsed_s),
                                                shown_text(result.settings),
                                                result.picture ? beside + ".png" : std::string(),
                                                result.report ? beside + ".html" : std::string(),
                                                result.verdict,
                                                shown_text(result.sentence),
                                                or_null(result.figure(Figure::pieces)),
                                                or_null(result.figure(Figure::piece_bound))}));
    separator_ = ",\n";
  }

  void finish() override {
    file_.write("]}</script>\n");
    file_.write(page::page_end(frame()));
    file_.commit();
  }

 private:
  AtomicFile file_;
  std::string separator_ = "\n";
};

}  // namespace

const std::vector<ResultColumn>& result_columns() {
  using R = PartResult;
  static const auto k_columns = [] {
    std::vector<ResultColumn> columns = {
        {"row", "INTEGER PRIMARY KEY", [](const R& r) { return Json(r.row); }},
        {"path", "TEXT NOT NULL", [](const R& r) { return Json(r.path); }},
        {"settings", "TEXT NOT NULL", [](const R& r) { return Json(r.settings); }},
        {"state", "TEXT NOT NULL", [](const R& r) { return Json(state_name(r.state)); }},
        {"reason", "TEXT", [](const R& r) { return Json(r.reason); }},
        {"unit", "TEXT", [](const R& r) { return Json(r.unit); }},
        {"facets", "INTEGER", [](const R& r) { return or_null(r.facets); }},
        {"closed", "INTEGER", [](const R& r) { return or_null(r.closed); }},
        {"verdict", "TEXT", [](const R& r) { return Json(r.verdict); }},
        {"sentence", "TEXT", [](const R& r) { return Json(r.sentence); }},
        {"reasons", "TEXT", [](const R& r) { return Json(r.reasons); }}};
    for (const std::size_t axis : {0U, 1U, 2U})
      columns.push_back({fmt::format("direction_{}", "xyz"[axis]), "REAL",
                         [axis](const R& r) { return r.direction ? Json((*r.direction)[axis]) : Json(); }});
    for (std::size_t k = 0; k < k_figure_count; ++k) {
      const auto figure = static_cast<Figure>(k);
      const bool whole = figure == Figure::undercuts || figure == Figure::side_actions ||
                         figure == Figure::pieces || figure == Figure::piece_bound;
      columns.push_back({std::string(figure_name(figure)), whole ? "INTEGER" : "REAL",
                         [figure](const R& r) { return or_null(r.figure(figure)); }});
    }
    columns.insert(columns.end(),
                   {{"undercut_share", "REAL", [](const R& r) { return or_null(r.undercut_share()); }},
                    {"elapsed_s", "REAL", [](const R& r) { return or_null(r.elapsed_s); }},
                    {"tries", "INTEGER", [](const R& r) { return or_null(r.tries); }},
                    {"content", "TEXT", [](const R& r) { return Json(r.content); }},
                    {"key", "TEXT", [](const R& r) { return Json(hex_of(r.key)); }}});
    return columns;
  }();
  return k_columns;
}

ReadingCounts merge(const Manifest& manifest, const MergeFiles& files, const Progress& progress,
                    MergeSink* first) {
  std::vector<std::unique_ptr<MergeSink>> sinks;
  if (!files.csv.empty()) sinks.push_back(std::make_unique<CsvSink>(files.csv));
  if (!files.sqlite.empty()) sinks.push_back(sqlite_sink(files.sqlite, manifest));
  if (!files.html.empty()) sinks.push_back(std::make_unique<HtmlSink>(files.html, manifest));
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
