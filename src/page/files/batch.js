// Shows, sorts and filters the rows, some hundred at a time. Fields of a row are those of HtmlSink::add.
const {about, results, rows} = pageData("batch");
// Heading, field, and of what kind it is.
const columns = [["#", 0], ["part", 1, "path"], ["state", 2, "word"], ["undercut", 7, "area"], ["share", 8, "share"],
  ["undercuts", 9], ["side actions", 10], ["not released", 11, "area"], ["pieces", 18],
  ["at least", 19], ["verdict", 16, "word"],
  ["that is", 17, "said"], ["area", 6, "area"], ["facets", 5], ["time s", 12, "time"], ["settings", 13, "said"],
  ["reason", 3, "said"]];
const isText = (kind) => ["path", "word", "said"].includes(kind);
const step = 200;
let shown = step, sorted = 8, down = true, list = [];
const isEmpty = (value) => value === null || value === "";
const drawn = rows.some((row) => row[14]);
const used = columns.filter(([, field]) => rows.some((row) => !isEmpty(row[field])));
// Areas are in each part's own unit: in the heading where all have one.
const units = [...new Set(rows.map((row) => row[4]).filter((unit) => unit))];
const squared = (unit) => unit ? " " + unit + "²" : "";
function text(value, kind, unit) {
  if (value === null) return "";
  if (kind === "share") return (100 * value).toFixed(2) + " %";
  if (kind === "area") return Number(value.toPrecision(6)) + (units.length > 1 ? squared(unit) : "");
  return kind === "time" ? value.toFixed(2) : String(value);
}
function compare(a, b) {
  const x = a[sorted], y = b[sorted];
  if (x === y) return a[0] - b[0];
  if (isEmpty(x) || isEmpty(y)) return isEmpty(x) ? 1 : -1;
  return (x < y) === down ? 1 : -1;
}
function choose() {
  const words = byId("filter").value.toLowerCase().split(/\s+/), state = byId("state").value;
  const said = (row) => [row[1], row[13], row[3], row[17]].join(" ").toLowerCase();
  list = rows.filter((row) => (!state || row[2] === state) && words.every((word) => said(row).includes(word)));
  list.sort(compare);
  shown = step;
  show();
}
function cell(row, [, field, kind]) {
  const said = text(row[field], kind, row[4]);
  return made("td", {className: isText(kind) ? "text " + kind : ""},
    kind === "path" && row[15] ? made("a", {href: results + row[15]}, said) : said);
}
function show() {
  byId("count").textContent = list.length + " of " + rows.length;
  byId("body").replaceChildren(...list.slice(0, shown).map((row) => {
    const picture = row[14] ? made("img", {loading: "lazy", alt: "", src: results + row[14]}) : "";
    return made("tr", {className: row[2]}, drawn ? made("td", {}, picture) : "", ...used.map((one) => cell(row, one)));
  }));
  byId("more").hidden = shown >= list.length;
  for (const th of document.querySelectorAll("th[data-field]")) {
    const is = Number(th.dataset.field) === sorted;
    th.setAttribute("aria-sort", is ? (down ? "descending" : "ascending") : "none");
  }
}
byId("about").textContent = about;
if (drawn) byId("head").append(made("th"));
for (const [name, field, kind] of used) {
  const unit = kind === "area" && units.length === 1 ? squared(units[0]) : "";
  const onclick = () => {
    down = sorted === field ? !down : !isText(kind);
    sorted = field;
    choose();
  };
  const th = made("th", {className: isText(kind) ? "text" : ""},
    made("button", {onclick}, name + unit));
  th.dataset.field = field;
  byId("head").append(th);
}
byId("filter").oninput = byId("state").onchange = choose;
byId("more").onclick = () => { shown += step; show(); };
choose();
