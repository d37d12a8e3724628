// The view that turns follows hand and controls. Where it cannot be drawn, the picture stays.
// Calls use(x, y, event) with the way on the screen for which an arrow key of the element stands.
function onArrowKeys(element, use) {
  element.addEventListener("keydown", (event) => {
    const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (way) { use(...way, event); event.preventDefault(); }
  });
}
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
  canvas.onkeydown = (event) => {
    const act = {"+": () => view.scale(1.15), "-": () => view.scale(1 / 1.15), Home: () => view.home()}[event.key];
    if (act) { act(); event.preventDefault(); }
  };
  onArrowKeys(canvas, (x, y) => view.turn(0.1 * x, -0.1 * y));
  canvas.ondblclick = byId("home").onclick = () => view.home();
  for (const [name, field] of [["open", "opened"], ["clear", "clear"], ["cut", "cut"]])
    byId(name).oninput = (event) => { view[field] = Number(event.target.value); view.ask(); };
  byId("plane").onchange = (event) => {
    view.plane = event.target.value;
    byId("cut").disabled = !view.plane;
    view.ask();
  };
  for (const box of figure.querySelectorAll("input[data-group]")) {
    const chosen = Number(box.dataset.group), owned = (group, k) => k === chosen || group.with === chosen;
    box.disabled = false;
    box.onchange = () => {
      view.shown = view.model.groups.map((group, k) => owned(group, k) ? box.checked : view.shown[k]);
      view.ask();
    };
  }
  new ResizeObserver(() => view.ask()).observe(canvas.parentElement);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => view.ask());
}

async function begin() {
  const figure = byId("view"), model = pageData("model"), live = pageData("live");
  if (!model) return null;
  const view = new View(figure, await unpacked(model), Boolean(live));
  for (const part of [view.canvas, view.tags, figure.querySelector(":scope > .controls")]) part.hidden = false;
  figure.classList.add("live");
  listen(view);
  view.draw();
  if (live)
    view.director = new Live(view, live, await unpackedPart(live), live.sphere && await inflated(live.sphere.data));
  return view;
}
const begun = begin().catch(String);  // the view, or why there is none
