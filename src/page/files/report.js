// The view that turns follows hand and controls (model.js and view.js come before). Where it cannot be drawn, the
// picture stays. With #selftest in the address it says in the page what it drew.
const notes = {errors: [], blocked: 0};
addEventListener("error", (event) => notes.errors.push(String(event.message)));
addEventListener("unhandledrejection", (event) => notes.errors.push(String(event.reason)));
document.addEventListener("securitypolicyviolation", () => ++notes.blocked);

function listen(view) {
  const {canvas, figure} = view, held = new Map();
  const gap = () => { const [a, b] = [...held.values()]; return Math.hypot(a[0] - b[0], a[1] - b[1]); };
  let grabbed = null, way = 0;  // an arrow; how far the pointer went
  canvas.onpointerdown = (event) => {
    canvas.setPointerCapture(event.pointerId);
    grabbed = held.size ? null : view.grab?.(event.offsetX, event.offsetY);
    way = held.size ? 99 : 0;
    held.set(event.pointerId, [event.clientX, event.clientY]);
    canvas.focus({preventScroll: true});
  };
  canvas.onpointermove = (event) => {
    const last = held.get(event.pointerId);
    if (!last) return;
    const before = held.size === 2 ? gap() : 0, x = event.clientX - last[0], y = event.clientY - last[1];
    held.set(event.pointerId, [event.clientX, event.clientY]);
    way += Math.abs(x) + Math.abs(y);
    if (grabbed) grabbed(x, y);
    else if (held.size === 2) view.scale(gap() / Math.max(1, before));
    else if (event.shiftKey || event.buttons & 6) {
      const pixel = view.pixel * canvas.width / canvas.clientWidth;
      view.pan = [view.pan[0] + x * pixel, view.pan[1] - y * pixel];
      view.ask();
    } else view.turn(0.008 * x, 0.008 * y);
  };
  canvas.onpointerup = canvas.onpointercancel = (event) => {
    held.delete(event.pointerId);
    if (way < 5 && event.type === "pointerup") view.pick?.(event.offsetX, event.offsetY);
    way = 99;
  };
  canvas.oncontextmenu = (event) => event.preventDefault();
  // The wheel scrolls the page until the view has been clicked.
  canvas.addEventListener("wheel", (event) => {
    if (document.activeElement !== canvas && !event.ctrlKey) return;
    event.preventDefault();
    view.scale(Math.exp(-0.0015 * event.deltaY));
  }, {passive: false});
  canvas.ondblclick = () => { view.home(); view.ask(); };
  canvas.onkeydown = (event) => {
    const turns = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, -0.1], ArrowDown: [0, 0.1]}[event.key];
    if (turns) view.turn(...turns);
    else if (event.key === "+" || event.key === "-") view.scale(event.key === "+" ? 1.15 : 1 / 1.15);
    else if (event.key === "Home") { view.home(); view.ask(); } else return;
    event.preventDefault();
  };
  const control = (name) => figure.querySelector("#" + name);
  for (const [name, field] of [["open", "opened"], ["clear", "clear"], ["cut", "cut"]])
    control(name).oninput = (event) => { view[field] = Number(event.target.value); view.ask(); };
  control("plane").onchange = (event) => { view.plane = event.target.value; control("cut").disabled = !view.plane; view.ask(); };
  control("home").onclick = () => { view.home(); view.ask(); };
  for (const box of figure.querySelectorAll("input[data-group]")) {
    box.disabled = false;
    const chosen = Number(box.dataset.group);
    box.onchange = () => {
      view.model.groups.forEach((group, k) => { if (k === chosen || group.with === chosen) view.shown[k] = box.checked; });
      view.ask();
    };
  }
  new ResizeObserver(() => view.ask()).observe(canvas.parentElement);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => view.ask());
}

// What the view does when it is used, as numbers in the page.
function selftest(view) {
  const pixels = () => {
    view.draw();
    const {gl, canvas} = view, bytes = new Uint8Array(4 * canvas.width * canvas.height);
    gl.readPixels(0, 0, canvas.width, canvas.height, gl.RGBA, gl.UNSIGNED_BYTE, bytes);
    return new Uint32Array(bytes.buffer);
  };
  const differing = (a, b) => a.reduce((sum, pixel, k) => sum + (pixel !== b[k] ? 1 : 0), 0);
  const use = (name, value) => {
    const input = view.figure.querySelector("#" + name);
    input.value = value;
    input.dispatchEvent(new Event(input.tagName === "SELECT" ? "change" : "input"));
  };
  const first = pixels(), found = {pixels: first.length, drawn: first.filter((pixel) => pixel).length, colours: new Set(first).size};
  const compare = (name, act, back) => { act(); found[name] = differing(first, pixels()); back(); };
  const key = (name) => view.canvas.dispatchEvent(new KeyboardEvent("keydown", {key: name}));
  compare("turned", () => key("ArrowLeft"), () => key("ArrowRight"));
  compare("opened", () => use("open", view.opened > 0.5 ? 0 : 1), () => use("open", view.model.opened));
  compare("cleared", () => use("clear", 0.7), () => use("clear", 0));
  compare("cut", () => use("plane", "d"), () => use("plane", ""));
  const boxes = [...view.figure.querySelectorAll("input[data-group]")].filter((box) => box.checked);
  compare("hidden", () => boxes.forEach((box) => box.click()), () => boxes.forEach((box) => box.click()));
  view.home();
  found.restored = differing(first, pixels());
  found.facets = view.model.surfaces.reduce((sum, surface) => sum + surface.facets, 0);
  found.glError = view.gl.getError();
  return found;
}

async function begin() {
  const figure = document.getElementById("view"), data = document.getElementById("model");
  if (!data) return null;
  const view = new View(figure, await unpacked(JSON.parse(data.textContent)));
  view.canvas.hidden = figure.querySelector(".controls").hidden = figure.querySelector(".tags").hidden = false;
  figure.classList.add("live");
  listen(view);
  view.draw();
  if (document.getElementById("live")) view.director = await beginLive(view);
  return view;
}
const begun = begin().catch((error) => { notes.errors.push(String(error)); return null; });
begun.then((view) => {
  if (location.hash !== "#selftest") return;
  const result = Object.assign(document.createElement("pre"), {id: "selftest"});
  const found = view ? selftest(view) : {};
  result.textContent = JSON.stringify({...found, ...notes, requests: performance.getEntriesByType("resource").length,
    width: document.documentElement.scrollWidth, room: document.documentElement.clientWidth});
  document.body.append(result);
});
