// Shows, sorts and filters the rows, some hundred at a time. Fields of a row are those of HtmlSink::add.
"use strict";
const {about, results, rows} = JSON.parse(document.getElementById("batch").textContent);
// Heading, field, whether it is text, kind.
const columns = [["#", 0, 0], ["part", 1, 1, "path"], ["state", 2, 1], ["undercut", 7, 0, "area"],
  ["share", 8, 0, "share"], ["undercuts", 9, 0], ["side actions", 10, 0], ["not released", 11, 0, "area"],
  ["verdict", 16, 1], ["that is", 17, 1, "said"], ["area", 6, 0, "area"], ["facets", 5, 0], ["time s", 12, 0, "time"],
  ["settings", 13, 1, "said"], ["reason", 3, 1, "said"]];
const step = 200;
let shown = step, sorted = 8, down = true, list = [];
const byId = (id) => document.getElementById(id);
const made = (tag, fields, ...children) => {
  const element = Object.assign(document.createElement(tag), fields);
  element.append(...children);
  return element;
};
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
function cell(row, [, field, isText, kind]) {
  const said = text(row[field], kind, row[4]);
  return made("td", {className: isText ? "text " + (kind ?? "") : ""},
    kind === "path" && row[15] ? made("a", {href: results + row[15]}, said) : said);
}
function show() {
  byId("count").textContent = list.length + " of " + rows.length;
  byId("body").replaceChildren(...list.slice(0, shown).map((row) => {
    const picture = row[14] ? [made("img", {loading: "lazy", alt: "", src: results + row[14]})] : [];
    const cells = used.map((column) => cell(row, column));
    return made("tr", {className: row[2]}, ...(drawn ? [made("td", {}, ...picture)] : []), ...cells);
  }));
  byId("more").hidden = shown >= list.length;
  for (const th of document.querySelectorAll("th[data-field]")) {
    const is = Number(th.dataset.field) === sorted;
    th.setAttribute("aria-sort", is ? (down ? "descending" : "ascending") : "none");
    th.querySelector("span").textContent = is ? (down ? " ▾" : " ▴") : "";
  }
}
byId("about").textContent = about;
if (drawn) byId("head").append(made("th"));
for (const [name, field, isText, kind] of used) {
  const unit = kind === "area" && units.length === 1 ? squared(units[0]) : "";
  const onclick = () => {
    down = sorted === field ? !down : !isText;
    sorted = field;
    choose();
  };
  const th = made("th", {className: isText ? "text" : ""}, made("button", {onclick}, name + unit, made("span")));
  th.dataset.field = field;
  byId("head").append(th);
}
byId("filter").oninput = byId("state").onchange = choose;
byId("more").onclick = () => { shown += step; show(); };
choose();
