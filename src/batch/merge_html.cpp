// The results as a page for a browser, without a server: the rows are data in it, and a script of ours shows,
// sorts and filters them, some hundred at a time.
#include <filesystem>

#include <fmt/format.h>

#include "batch/merge.hpp"
#include "io/atomic_file.hpp"

namespace moldlight::batch {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view k_page_begin = R"(<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width">
<title>moldlight batch</title>
<style>
:root { color-scheme: light dark; --line: #8884; --faint: #888; --bad: #c33; }
body { font: 14px/1.4 Inter, "DejaVu Sans", sans-serif; margin: 1.5rem; }
h1 { font-size: 1.2rem; margin: 0; }
#about { color: var(--faint); margin: 0 0 1rem; }
input, select, button { font: inherit; padding: .25rem .5rem; }
table { border-collapse: collapse; margin-top: .75rem; }
th, td { padding: .25rem .6rem; border-bottom: 1px solid var(--line); text-align: right; vertical-align: middle; }
td { white-space: nowrap; }
th { position: sticky; top: 0; background: Canvas; padding: 0; }
th button { border: 0; background: none; font-weight: 600; cursor: pointer; color: inherit; white-space: nowrap; }
td.text, th.text { text-align: left; }
td.path { white-space: pre-wrap; overflow-wrap: anywhere; min-width: 12rem; max-width: 32rem; }
td.said { white-space: normal; min-width: 12rem; max-width: 32rem; }
tr.failed td { color: var(--bad); }
tr.missing td { color: var(--faint); }
img { width: 120px; height: 90px; object-fit: contain; display: block; }
</style></head><body>
<h1>moldlight batch</h1><p id="about"></p>
<input id="filter" type="search" placeholder="part, settings or reason" aria-label="Filter">
<select id="state" aria-label="State"><option value="">all</option><option>done</option><option>failed</option>
<option>missing</option></select> <span id="count"></span>
<table><thead><tr id="head"></tr></thead><tbody id="body"></tbody></table>
<p><button id="more">Show more</button></p>
<script>
)";

// Fields of a row are those of HtmlSink::add.
constexpr std::string_view k_page_end = R"(
"use strict";
const columns = [["#", 0, 0], ["part", 1, 1], ["state", 2, 1], ["undercut", 7, 0, "area"], ["share", 8, 0, "share"],
  ["undercuts", 9, 0], ["side actions", 10, 0], ["not released", 11, 0, "area"], ["area", 6, 0, "area"],
  ["facets", 5, 0], ["time s", 12, 0, "time"], ["settings", 13, 1, "said"], ["reason", 3, 1, "said"]];
const step = 200;
let shown = step, sorted = 8, down = true, list = [];
const byId = (id) => document.getElementById(id);
const drawn = rows.some((row) => row[14]);
const used = columns.filter((column) => rows.some((row) => row[column[1]] !== null && row[column[1]] !== ""));
const text = (value, kind) => value === null ? "" : kind === "share" ? (100 * value).toFixed(2) + " %"
  : kind === "area" ? Number(value.toPrecision(6)).toString() : kind === "time" ? value.toFixed(2) : String(value);
function compare(a, b) {
  const x = a[sorted], y = b[sorted];
  if (x === y) return a[0] - b[0];
  if (x === null || x === "") return 1;
  if (y === null || y === "") return -1;
  return (x < y ? -1 : 1) * (down ? -1 : 1);
}
function choose() {
  const words = byId("filter").value.toLowerCase().split(/\s+/).filter((word) => word);
  const state = byId("state").value;
  list = rows.filter((row) => (!state || row[2] === state) &&
    words.every((word) => (row[1] + " " + row[13] + " " + row[3]).toLowerCase().includes(word)));
  list.sort(compare);
  shown = step;
  show();
}
function cell(row, column) {
  const td = document.createElement("td");
  if (column[2]) td.className = column[1] === 1 ? "text path" : "text " + (column[3] || "");
  td.textContent = text(row[column[1]], column[3]);
  return td;
}
function show() {
  byId("count").textContent = list.length + " of " + rows.length;
  const lines = list.slice(0, shown).map((row) => {
    const tr = document.createElement("tr");
    tr.className = row[2];
    if (drawn) {
      const td = document.createElement("td");
      if (row[14]) {
        const image = document.createElement("img");
        image.loading = "lazy";
        image.alt = "";
        image.src = pictures + row[14];
        td.append(image);
      }
      tr.append(td);
    }
    tr.append(...used.map((column) => cell(row, column)));
    return tr;
  });
  byId("body").replaceChildren(...lines);
  byId("more").hidden = shown >= list.length;
  document.querySelectorAll("th[data-field]").forEach((th) => {
    const is = Number(th.dataset.field) === sorted;
    th.setAttribute("aria-sort", is ? (down ? "descending" : "ascending") : "none");
    th.querySelector("span").textContent = is ? (down ? " ▾" : " ▴") : "";
  });
}
byId("about").textContent = about;
if (drawn) byId("head").append(document.createElement("th"));
for (const column of used) {
  const th = document.createElement("th"), button = document.createElement("button");
  th.dataset.field = column[1];
  if (column[2]) th.className = "text";
  button.append(column[0], document.createElement("span"));
  button.onclick = () => {
    if (sorted === column[1]) down = !down; else { sorted = column[1]; down = !column[2]; }
    choose();
  };
  th.append(button);
  byId("head").append(th);
}
byId("filter").oninput = choose;
byId("state").onchange = choose;
byId("more").onclick = () => { shown += step; show(); };
choose();
</script></body></html>
)";

/// JSON that may stand in a script of a page: nothing in it ends the script.
std::string script_json(const Json& json) {
  std::string text = json.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t k = text.find('<'); k != std::string::npos; k = text.find('<', k))
    text.replace(k, 1, "\\u003c");
  return text;
}

/// A path as part of a URL.
std::string url_of(const std::string& path) {
  std::string url;
  for (const char c : path) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
                       std::string_view("/._-~").find(c) != std::string_view::npos;
    url += plain ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  }
  return url;
}

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
    file_.write(k_page_begin);
    file_.write(fmt::format(
        "const pictures = {};\nconst about = {};\nconst rows = [\n",
        script_json(url_of(relative.string()) + "/"),
        script_json(fmt::format("{} of {} parts of {}, planned {} by moldlight {}", manifest.command,
                                manifest.rows, manifest.source, manifest.planned_at, manifest.version))));
  }

  void add(const PartResult& result) override {
    const std::string name = hex_of(result.key);
    file_.write(
        script_json({result.row, result.path, state_name(result.state), result.reason, result.unit,
                     or_null(result.facets), or_null(result.figure(Figure::area)),
                     or_null(result.figure(Figure::undercut_area)), or_null(result.undercut_share()),
                     or_null(result.figure(Figure::undercuts)), or_null(result.figure(Figure::side_actions)),
                     or_null(result.figure(Figure::unreleased_area)), or_null(result.elapsed_s),
                     result.settings,
                     result.picture ? name.substr(0, 2) + "/" + name + ".png" : std::string()}) +
        ",\n");
  }

  void finish() override {
    file_.write("];");
    file_.write(k_page_end);
    file_.commit();
  }

 private:
  AtomicFile file_;
};

}  // namespace

std::unique_ptr<MergeSink> html_sink(const std::string& path, const Manifest& manifest) {
  return std::make_unique<HtmlSink>(path, manifest);
}

}  // namespace moldlight::batch
