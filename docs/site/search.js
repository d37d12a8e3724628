// Search in the words of all pages: every word typed must occur in a section; headings count most. `?q=WORDS` in the
// address searches at once.
"use strict";

const field = document.getElementById("search");
const list = document.getElementById("found");
const mostShown = 12;

function score(section, words) {
  let sum = 0;
  const heading = section.heading.toLowerCase(), text = section.text.toLowerCase();
  for (const word of words) {
    if (!heading.includes(word) && !text.includes(word)) return 0;
    sum += (heading.includes(word) ? 10 : 0) + Math.min(text.split(word).length - 1, 5);
  }
  return sum;
}

function beginning(text, word) {
  const place = Math.max(text.toLowerCase().indexOf(word) - 30, 0);
  return (place > 0 ? "…" : "") + text.slice(place, place + 90) + "…";
}

function search() {
  const words = field.value.toLowerCase().split(/\s+/).filter(Boolean);
  const found = words.length === 0 ? [] : sections.map(section => ({section, points: score(section, words)}))
    .filter(each => each.points > 0).sort((a, b) => b.points - a.points).slice(0, mostShown);
  list.hidden = words.length === 0;
  list.replaceChildren(...found.map(({section}) => {
    const item = document.createElement("li"), link = document.createElement("a"), text = document.createElement("small");
    link.href = `${section.page}#${section.anchor}`;
    link.textContent = section.heading;
    text.textContent = beginning(section.text, words[0]);
    item.append(link, text);
    return item;
  }));
  if (words.length > 0 && found.length === 0) list.textContent = "Nothing found.";
}

field.value = new URLSearchParams(location.search).get("q") ?? "";
field.addEventListener("input", search);
search();
