// Shows, sorts and filters the rows, some hundred at a time. Fields of a row are those of HtmlSink::add.
"use strict";
const {about, results, rows} = JSON.parse(document.getElementById("batch").textContent);
const columns = [["#", 0, 0], ["part", 1, 1], ["state", 2, 1], ["undercut", 7, 0, "area"], ["share", 8, 0, "share"],
  ["undercuts", 9, 0], ["side actions", 10, 0], ["not released", 11, 0, "area"],
  ["verdict", 16, 1], ["that is", 17, 1, "said"], ["area", 6, 0, "area"],
  ["facets", 5, 0], ["time s", 12, 0, "time"], ["settings", 13, 1, "said"], ["reason", 3, 1, "said"]];
const step = 200;
let shown = step, sorted = 8, down = true, list = [];
const byId = (id) => document.getElementById(id);
const drawn = rows.some((row) => row[14]);
const used = columns.filter((column) => rows.some((row) => row[column[1]] !== null && row[column[1]] !== ""));
// Areas are in each part's own unit: in the heading where all have one.
const units = [...new Set(rows.map((row) => row[4]).filter((unit) => unit))];
const squared = (unit) => unit ? " " + unit + "²" : "";
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
    words.every((word) => (row[1] + " " + row[13] + " " + row[3] + " " + row[17]).toLowerCase().includes(word)));
  list.sort(compare);
  shown = step;
  show();
}
function cell(row, column) {
  const td = document.createElement("td");
  if (column[2]) td.className = column[1] === 1 ? "text path" : "text " + (column[3] || "");
  let place = td;
  if (column[1] === 1 && row[15]) {
    place = document.createElement("a");
    place.href = results + row[15];
    td.append(place);
  }
  place.textContent = text(row[column[1]], column[3]) +
    (column[3] === "area" && units.length > 1 && row[column[1]] !== null ? squared(row[4]) : "");
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
        image.src = results + row[14];
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
  button.append(column[0] + (column[3] === "area" && units.length === 1 ? squared(units[0]) : ""),
    document.createElement("span"));
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
