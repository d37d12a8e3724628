// A live page: the direction follows ball, arrow, buttons and keys, and regions and areas follow it.
const shortest = (value) => String(Number(value.toPrecision(4))).replace("-", "−");
// A place of the part in the unit frame, and back.
const inUnit = ({centre, diagonal}, place) => scaled(plus(place, scaled(centre, -1)), 1 / diagonal);
const inPart = ({centre, diagonal}, place) => plus(scaled(place, diagonal), centre);

class Live {
  constructor(view, live, mesh, sphere) {
    const {tools, figure} = view, find = (name) => figure.querySelector("#" + name), ball = find("ball");
    const goals = [...figure.querySelectorAll("[data-direction]")]
      .map((button) => ({button, direction: unit(button.dataset.direction.split(",").map(Number))}));
    // What is named on the ball: axes, and the first of the listed directions by their numbers.
    const listed = live.known.filter((known) => known.verdict).slice(0, 5).map((known, k) => [k + 1, known.direction]);
    const places = [["x", [1, 0, 0]], ["y", [0, 1, 0]], ["z", [0, 0, 1]], ...listed].map(([textContent, place], k) => {
      const label = Object.assign(document.createElement("span"), {textContent});
      ball.append(label);
      return {place, label, axis: k < 3};
    });
    const size = live.sphere?.size ?? 1;
    Object.assign(this, {view, live, find, ball, goals, places, rays: new Rays(mesh), moving: 512,
      maps: new LiveMaps(tools, live, mesh), ballProgram: tools.program("ball"),
      sphere: tools.texture("RGBA8", size, size, sphere)});
    Object.assign(view, {live: this.maps, before: () => this.redraw(), over: (...picture) => this.drawBall(...picture),
      pick: (x, y) => this.pick(x, y), grab: (x, y) => this.grab(x, y)});
    this.listen();
    ball.hidden = figure.querySelector(".direct").hidden = false;
    this.go(view.up, true);
  }
  // What the controls say; `moving` maps are smaller.
  settings(moving) {
    const {live, find} = this, [tau, kernel, wanted, thickness] = ["tau", "kernel", "resolution", "thickness"]
      .map((name) => Number(find(name).value)), reported = tau === live.tau && !kernel;
    return {tau, thickness, lateral: kernel ? 0.5 * (kernel - 1) / wanted : live.lateral,
      resolution: moving ? Math.min(wanted, this.moving) : wanted, reported,
      measured: reported && thickness === live.thickness};
  }
  go(direction, rest) {
    const field = this.find("direction");
    this.view.aim(direction);
    this.change(rest);
    if (document.activeElement !== field || rest)
      field.value = direction.map((value) => Number(value.toFixed(4)) || 0).join(", ");
    for (const goal of this.goals)
      goal.button.setAttribute("aria-pressed", dot(goal.direction, direction) > 1 - 1e-9);
  }
  // Something that the maps depend on has changed; while it goes on changing, they are drawn small.
  change(rest) {
    this.stale = rest ? "rest" : "move";
    this.mark("", []);
    clearTimeout(this.resting);
    if (!rest) this.resting = setTimeout(() => { this.stale = "rest"; this.view.ask(); }, 180);
  }
  // Before every picture: the maps, where they are not those of the direction.
  redraw() {
    if (!this.stale) return;
    const {view, live} = this, rest = this.stale === "rest", settings = this.settings(!rest), now = performance.now();
    // Exact areas are known of a direction, and then of its opposite, as they were asked for.
    const same = (known) => 1 - Math.abs(dot(known.direction, view.direction)) < 1e-12;
    const found = settings.reported && !this.find("bymaps").checked ? live.known.find(same) : null;
    view.byMaps = found !== live.known[0] || dot(found.direction, view.direction) < 0;
    if (view.byMaps) this.maps.draw(view.direction, settings);
    // While it moves, maps as fine as keep up.
    const took = now - this.last;
    if (!rest && took < 300) this.moving = between(this.moving * (took < 18 ? 2 : took > 75 ? 0.5 : 1), 512, 2048);
    if (rest || !(now - this.shownAt < 120)) this.showAreas(found, settings, rest);
    this.last = now;
    this.stale = "";
  }
  // What rays ask about a point of the part.
  query({tau, lateral}) { return {tau, lateral: lateral * this.live.diagonal, direction: this.view.direction}; }
  // Areas: the exact ones where the page has them, else those by maps with their error.
  showAreas(found, settings, rest) {
    const {live, view, rays} = this, query = this.query(settings);
    const settle = rest && ((facet, place) => rays.bits(rays.blockers(facet, inPart(live, place), query)));
    const areas = found ? [...found.areas] : this.maps.areas(settle);
    if (found && dot(found.direction, view.direction) < 0) [areas[0], areas[1]] = [areas[1], areas[0]];
    [...view.figure.querySelectorAll(".legend li i")].slice(0, 4).forEach((legend, k) => {
      legend.textContent = `${(100 * areas[k] / live.area).toFixed(2)} %  ·  ${shortest(areas[k])} ${live.area_unit}`;
    });
    const measured = live.errors.find(([size]) => settings.measured && size === settings.resolution);
    const error = measured && `± ${(100 * measured[rest ? 2 : 1]).toFixed(2)} % of the surface`;
    this.find("standing").textContent = found ? "Exact areas." + (view.byMaps ? " The picture is by shadow maps." : "")
      : `Areas by shadow maps, ${error ?? "± not measured for these settings"}.`;
    Object.assign(this, {areas, exact: Boolean(found), shownAt: performance.now()});
  }
  // Turns the direction by a way on the screen.
  turn(x, y, angle) {
    const {direction, seen: {right, above}} = this.view, axis = unit(plus(scaled(right, -y), scaled(above, x)));
    this.go(unit(moved(turning(axis, angle), direction)), false);
  }
  listen() {
    const {view, ball, find} = this, named = this.places.flatMap(({place}) => [place, scaled(place, -1)]);
    ball.onpointerdown = ball.onpointermove = (event) => {
      if (event.type === "pointerdown") ball.setPointerCapture(event.pointerId);
      else if (!ball.hasPointerCapture(event.pointerId)) return;
      const box = ball.getBoundingClientRect(), {right, above, toward} = view.seen;
      const x = 2 * (event.clientX - box.left) / box.width - 1, y = 1 - 2 * (event.clientY - box.top) / box.height;
      const high = scaled(toward, Math.sqrt(Math.max(0, 1 - x * x - y * y)));
      const pointed = unit(plus(scaled(right, x), scaled(above, y), high));
      // A named place nearby is met.
      this.go(named.find((place) => dot(place, pointed) > Math.cos(0.07)) ?? pointed, false);
    };
    ball.onkeydown = (event) => {
      const way = {ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
      if (!way) return;
      this.turn(...way, event.shiftKey ? 0.005 : 0.05);
      event.preventDefault();
    };
    addEventListener("beforeprint", () => { this.go(view.up, true); view.draw(); });
    for (const {button, direction} of this.goals) button.onclick = () => this.go(direction, true);
    find("direction").onchange = ({target}) => {
      const numbers = target.value.replaceAll("−", "-").split(/[\s,;]+/).filter((word) => word).map(Number);
      const good = numbers.length === 3 && numbers.every(Number.isFinite) && Math.hypot(...numbers) > 0;
      target.setAttribute("aria-invalid", !good);
      if (good) this.go(unit(numbers), true);
    };
    for (const name of ["tau", "kernel", "thickness", "resolution", "bymaps"]) find(name).oninput = ({target}) => {
      if (target.type === "range") find(name + "-is").textContent = target.value;
      this.change(target.type !== "range");
    };
  }
  // What follows a pointer that takes hold of an arrow there, by its ways in pixels.
  grab(x, y) {
    const {view, view: {seen: {box, toward}}} = this, reach = 0.4 * Math.min(box.width, box.height);
    const held = view.tips.find((tip) => {
      const [left, top] = view.onScreen(scaled(tip, 0.9));
      return Math.hypot(left - x, top - y) < 30;
    });
    const side = held && dot(held, toward) < 0 ? -1 : 1;
    return held && ((dx, dy) => { if (dx || dy) this.turn(side * dx, -side * dy, Math.hypot(dx, dy) / reach); });
  }
  // The ball in its corner of the picture, and the names on it.
  drawBall({right, above, toward}, {ratio, dark}) {
    const {tools, canvas, direction} = this.view, stage = canvas.getBoundingClientRect();
    const box = this.ball.getBoundingClientRect(), side = Math.round(box.width * ratio);
    const place = [box.left - stage.left, stage.bottom - box.bottom].map((way) => Math.round(way * ratio));
    tools.begin({place, size: [side, side], depth: "", blend: true});
    tools.draw(this.ballProgram, {u_right: right, u_above: above, u_toward: toward, u_direction: direction,
      u_plain: dark ? [0.42, 0.44, 0.48] : [0.86, 0.87, 0.89], u_ink: dark ? [0.9, 0.9, 0.92] : [0.1, 0.11, 0.13],
      u_pixel: 2 / side, t_sphere: this.sphere}, {vertices: null, count: 4}, "TRIANGLE_STRIP");
    for (const {place, axis, label} of this.places) {
      const near = axis || dot(place, toward) >= 0 ? place : scaled(place, -1), spread = axis ? 60 : 50;
      label.hidden = dot(near, toward) < -0.05;
      label.style.left = 50 + spread * dot(near, right) + "%";
      label.style.top = 50 - spread * dot(near, above) + "%";
    }
  }
  // Says what was clicked, and marks places of the part, corners of triangles or ends of lines: [places, kind, ink].
  mark(text, marks) {
    const {view, view: {tools}} = this, within = (place) => inUnit(this.live, place);
    for (const {buffer} of view.marks) tools.drop(buffer);
    view.marks = marks.map(([places, kind, ink]) => ({buffer: tools.buffer(places.flatMap(within), [3]), kind, ink}));
    this.find("picked").textContent = text;
    view.ask();
  }
  // The undercut at a place of the picture, and what blocks it there.
  pick(x, y) {
    const {view, rays, live, rays: {mesh}} = this, {eye, right, above, toward, aspect, f, box} = view.seen;
    this.mark("", []);
    if (view.opened > 0 || view.plane) return null;
    const across = scaled(right, (2 * x / box.width - 1) * aspect / f);
    const sight = unit(plus(across, scaled(above, (1 - 2 * y / box.height) / f), scaled(toward, -1)));
    const from = inPart(live, eye), seen = rays.hit(from, sight, true), query = this.query(this.settings(false));
    if (!seen) return null;
    const point = plus(from, scaled(sight, seen.way)), blockers = rays.blockers(seen.facet, point, query);
    const region = ["undercut", "core", "cavity", "both"][rays.bits(blockers)];
    if (region !== "undercut") {
      const draft = Math.asin(between(dot(at(mesh.normals, seen.facet), view.direction), -1, 1)) * 180 / Math.PI;
      this.mark(`${region[0].toUpperCase()}${region.slice(1)} here, draft ${shortest(draft)}°.`, []);
      return {region, blockers};
    }
    const {facets, area, depth, all} = rays.undercutAround(seen.facet, query), start = blockers.beside ?? point;
    const hits = [["+d", blockers.plus, 1], ["−d", blockers.minus, -1]].filter(([, hit]) => hit);
    const blocked = hits.map(([name, {way}]) =>
      ` Along ${name}, surface ${shortest(Math.max(0, way))} ${live.length_unit} away blocks it.`);
    const lines = hits.flatMap(([, {way}, side]) => [start, plus(start, scaled(view.direction, side * way))]);
    const count = `${all ? "" : "more than "}${facets.length} facet${facets.length > 1 ? "s" : ""}`;
    const deep = `${shortest(depth)} ${live.length_unit} deep along the direction.`;
    this.mark(`Undercut of ${count}, about ${shortest(area)} ${live.area_unit}, ${deep}${blocked.join("")}`,
      [[facets.flatMap(mesh.cornersOf), "TRIANGLES", [0.5, 0.42, 0, 0.5]], [lines, "LINES", [0, 0, 0, 1]],
       [hits.flatMap(([, hit]) => mesh.cornersOf(hit.facet)), "TRIANGLES", [0, 0, 0, 0.6]]]);
    return {region, blockers, facets, area, depth};
  }
}

async function beginLive(view, live) {
  const sphere = live.sphere ? await inflated(live.sphere.data) : new Uint8Array(4);
  return new Live(view, live, await unpackedPart(live), sphere);
}
