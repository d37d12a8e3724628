// The results as a page for a browser, without a server: the rows are data in it, and its script shows, sorts
// and filters them.
#include <filesystem>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "base/shown_text.hpp"
#include "batch/merge.hpp"
#include "io/atomic_file.hpp"
#include "page/html.hpp"
#include "page/page.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

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

template <typename T>
Json or_null(const std::optional<T>& value) {
  return value ? Json(*value) : Json();
}

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
    file_.write(
        separator_ +
        page::script_json(
            {result.row, shown_text(result.path), state_name(result.state), shown_text(result.reason),
             shown_text(result.unit), or_null(result.facets), or_null(result.figure(Figure::area)),
             or_null(result.figure(Figure::undercut_area)), or_null(result.undercut_share()),
             or_null(result.figure(Figure::undercuts)), or_null(result.figure(Figure::side_actions)),
             or_null(result.figure(Figure::unreleased_area)), or_null(result.elapsed_s),
             shown_text(result.settings), result.picture ? beside + ".png" : std::string(),
             result.report ? beside + ".html" : std::string(), result.verdict, shown_text(result.sentence)}));
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

std::unique_ptr<MergeSink> html_sink(const std::string& path, const Manifest& manifest) {
  return std::make_unique<HtmlSink>(path, manifest);
}

}  // namespace moldlight::batch
