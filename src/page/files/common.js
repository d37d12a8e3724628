// The beginning of the script of every page.
"use strict";
const byId = (id) => document.getElementById(id);
// The data that the page has under this name, or null.
const pageData = (id) => JSON.parse(byId(id)?.textContent ?? null);
function made(tag, fields, ...children) {
  const element = Object.assign(document.createElement(tag), fields);
  element.append(...children);
  return element;
}
